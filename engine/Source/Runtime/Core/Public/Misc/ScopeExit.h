// SPDX-License-Identifier: MIT
/** ON_SCOPE_EXIT { ... }; runs its block when the scope is left. */
#pragma once

#include "Templates/UnrealTemplate.h"

namespace ScopeExitSupport {
template <typename FuncType>
class TScopeGuard : private FNoncopyable {
public:
    explicit TScopeGuard(FuncType&& InFunc) : Func(static_cast<FuncType&&>(InFunc)) {}
    ~TScopeGuard() { Func(); }

private:
    FuncType Func;
};
struct FScopeGuardSyntaxSupport {
    template <typename FuncType>
    TScopeGuard<FuncType> operator+(FuncType&& InFunc) {
        return TScopeGuard<FuncType>(static_cast<FuncType&&>(InFunc));
    }
};
} // namespace ScopeExitSupport

#define ON_SCOPE_EXIT                                                                                                  \
    [[maybe_unused]] const auto PREPROCESSOR_JOIN(ScopeGuard_, __LINE__) =                                             \
        ::ScopeExitSupport::FScopeGuardSyntaxSupport() + [&]()
