// SPDX-License-Identifier: MIT
/** Small macros and tag types of the Core module. */
#pragma once

#include "HAL/Platform.h"

/** "No index" in every UE container call. */
inline constexpr int32 INDEX_NONE = -1;

enum EForceInit { ForceInit, ForceInitToZero };
enum ENoInit { NoInit };
enum EInPlace { InPlace };
enum EConstEval { ConstEval };

#define UE_DEPRECATED(Version, Message) [[deprecated(Message " Please update your code to the new API.")]]
#define UE_NONCOPYABLE(TypeName)                                                                                       \
    TypeName(TypeName&&) = delete;                                                                                     \
    TypeName(const TypeName&) = delete;                                                                                \
    TypeName& operator=(const TypeName&) = delete;                                                                     \
    TypeName& operator=(TypeName&&) = delete;

/** Body of a virtual function that has no meaning in a base class that must stay instantiable (UObject bases). */
#define PURE_VIRTUAL(Func, ...)                                                                                        \
    {                                                                                                                  \
        LowLevelFatalError(TEXT("Pure virtual function called: %s"), TEXT(#Func));                                     \
        __VA_ARGS__                                                                                                    \
    }

#define UE_ARRAY_COUNT(Array) (sizeof(UE::Core::Private::ArrayCountHelper(Array)))
#define ARRAY_COUNT_DEPRECATED UE_ARRAY_COUNT
#define STRUCT_OFFSET(Struct, Member) offsetof(Struct, Member)
#define UE_GREATER_SORT(ValueA, ValueB, SortComparisonFunction)                                                        \
    (((ValueA) == (ValueB)) ? (SortComparisonFunction) : ((ValueA) > (ValueB)))
#define UE_LESS_SORT(ValueA, ValueB, SortComparisonFunction)                                                           \
    (((ValueA) == (ValueB)) ? (SortComparisonFunction) : ((ValueA) < (ValueB)))
#define EXPAND_WITH_EDITORONLY(...)

namespace UE::Core::Private {
template <typename T, SIZE_T N>
char (&ArrayCountHelper(const T (&)[N]))[N];
} // namespace UE::Core::Private

/** Reports a fatal error from places where the log may not exist yet, then aborts. */
[[noreturn]] CORE_API void LowLevelFatalErrorImpl(const ANSICHAR* File, int32 Line, const TCHAR* Format, ...);
#define LowLevelFatalError(Format, ...) LowLevelFatalErrorImpl(__FILE__, __LINE__, Format, ##__VA_ARGS__)
