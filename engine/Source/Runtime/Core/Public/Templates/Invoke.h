// SPDX-License-Identifier: MIT
/** Invoke and projections. */
#pragma once

#include <functional>

#include "Templates/UnrealTemplate.h"

/** Calls functions, functors, member functions and data members alike. */
template <typename FuncType, typename... ArgTypes>
constexpr decltype(auto) Invoke(FuncType&& Func, ArgTypes&&... Args) {
    return std::invoke(static_cast<FuncType&&>(Func), static_cast<ArgTypes&&>(Args)...);
}
template <typename FuncType, typename... ArgTypes>
using TInvokeResult_T = std::invoke_result_t<FuncType, ArgTypes...>;

struct FIdentityFunctor {
    template <typename T>
    constexpr T&& operator()(T&& Val) const {
        return static_cast<T&&>(Val);
    }
};

/** Turns the name of an overloaded function into something that can be passed on. */
#define UE_PROJECTION(FuncName)                                                                                        \
    [](auto&&... Args) -> decltype(auto) { return FuncName(static_cast<decltype(Args)&&>(Args)...); }
#define UE_PROJECTION_MEMBER(Type, FuncName)                                                                           \
    [](auto&& Obj, auto&&... Args) -> decltype(auto) {                                                                 \
        return static_cast<decltype(Obj)&&>(Obj).FuncName(static_cast<decltype(Args)&&>(Args)...);                     \
    }
