// SPDX-License-Identifier: MIT
/**
 * check, verify and ensure.
 * A failed check prints the expression, the message and a stack trace and aborts. A failed ensure reports once per
 * place and goes on. `*Slow` variants are compiled only where DO_GUARD_SLOW is 1.
 */
#pragma once

#include "HAL/Platform.h"
#include "Misc/Build.h"
#include "Misc/CoreMiscDefines.h"

struct FDebug {
    /** Reports a failed check and aborts the process. */
    [[noreturn]] static CORE_API void CheckVerifyFailed(
        const ANSICHAR* Expr, const ANSICHAR* File, int32 Line, const TCHAR* Format, ...);
    /** Reports a failed ensure; returns false, the value of the ensure expression. */
    static CORE_API bool EnsureFailed(const ANSICHAR* Expr, const ANSICHAR* File, int32 Line, const TCHAR* Format, ...);
    /** Writes the calling thread's stack to stderr. */
    static CORE_API void DumpStackTraceToLog();
    /** Number of ensures that have fired in this process. */
    static CORE_API SIZE_T GetNumEnsureFailures();
    static CORE_API bool HasAsserted();
};

#if DO_CHECK
#define checkf(expr, format, ...)                                                                                      \
    do {                                                                                                               \
        if (UNLIKELY(!(expr))) {                                                                                       \
            FDebug::CheckVerifyFailed(#expr, __FILE__, __LINE__, format, ##__VA_ARGS__);                               \
        }                                                                                                              \
    } while (0)
#define check(expr) checkf(expr, TEXT(""))
#define verify(expr) check(expr)
#define verifyf(expr, format, ...) checkf(expr, format, ##__VA_ARGS__)
#define checkCode(...)                                                                                                 \
    do {                                                                                                               \
        __VA_ARGS__;                                                                                                   \
    } while (false)
#define checkNoEntry() FDebug::CheckVerifyFailed("Enclosing block should never be called", __FILE__, __LINE__, TEXT(""))
#define checkNoReentry()                                                                                               \
    do {                                                                                                               \
        static bool bBeenHere = false;                                                                                 \
        checkf(!bBeenHere, TEXT("Enclosing block was called more than once"));                                         \
        bBeenHere = true;                                                                                              \
    } while (0)
#define unimplemented() FDebug::CheckVerifyFailed("Unimplemented function called", __FILE__, __LINE__, TEXT(""))
#else
#define checkf(expr, format, ...) UE_ASSUME(expr)
#define check(expr) UE_ASSUME(expr)
#define verify(expr)                                                                                                   \
    do {                                                                                                               \
        (void)!!(expr);                                                                                                \
    } while (0)
#define verifyf(expr, format, ...) verify(expr)
#define checkCode(...) ((void)0)
#define checkNoEntry() ((void)0)
#define checkNoReentry() ((void)0)
#define unimplemented() ((void)0)
#endif

#if DO_GUARD_SLOW
#define checkSlow(expr) check(expr)
#define checkfSlow(expr, format, ...) checkf(expr, format, ##__VA_ARGS__)
#define verifySlow(expr) check(expr)
#else
#define checkSlow(expr) ((void)0)
#define checkfSlow(expr, format, ...) ((void)0)
#define verifySlow(expr) ((void)!!(expr))
#endif

#if DO_ENSURE
#define UE_ENSURE_IMPL(Always, expr, format, ...)                                                                      \
    (LIKELY(!!(expr)) || ([&]() -> bool {                                                                              \
        static bool bExecuted = false;                                                                                 \
        if (Always || !bExecuted) {                                                                                    \
            bExecuted = true;                                                                                          \
            FDebug::EnsureFailed(#expr, __FILE__, __LINE__, format, ##__VA_ARGS__);                                    \
        }                                                                                                              \
        return false;                                                                                                  \
    }()))
#define ensure(expr) UE_ENSURE_IMPL(false, expr, TEXT(""))
#define ensureMsgf(expr, format, ...) UE_ENSURE_IMPL(false, expr, format, ##__VA_ARGS__)
#define ensureAlways(expr) UE_ENSURE_IMPL(true, expr, TEXT(""))
#define ensureAlwaysMsgf(expr, format, ...) UE_ENSURE_IMPL(true, expr, format, ##__VA_ARGS__)
#else
#define ensure(expr) (LIKELY(!!(expr)))
#define ensureMsgf(expr, format, ...) (LIKELY(!!(expr)))
#define ensureAlways(expr) (LIKELY(!!(expr)))
#define ensureAlwaysMsgf(expr, format, ...) (LIKELY(!!(expr)))
#endif
