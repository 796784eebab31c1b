// SPDX-License-Identifier: MIT
/** UE_LOG and the category declarations. See Epic's "Logging". */
#pragma once

#include "Logging/LogCategory.h"

struct FMsg {
    template <typename FmtType, typename... Types>
    static void Logf(const ANSICHAR* File, int32 Line, const FName& Category, ELogVerbosity::Type Verbosity,
        const FmtType& Fmt, Types... Args) {
        static_assert(std::is_convertible_v<const FmtType&, const TCHAR*>, "Formatting string must be a TCHAR array.");
        static_assert((UE::Core::Private::TIsPrintfArgument<Types> && ...),
            "Invalid argument(s) passed to UE_LOG; pass strings as *Str");
        LogfImpl(File, Line, Category, Verbosity, Fmt, Args...);
    }

private:
    static CORE_API void LogfImpl(
        const ANSICHAR* File, int32 Line, const FName& Category, ELogVerbosity::Type Verbosity, const TCHAR* Fmt, ...);
};

#define DECLARE_LOG_CATEGORY_EXTERN(CategoryName, DefaultVerbosity, CompileTimeVerbosity)                              \
    extern struct FLogCategory##CategoryName                                                                           \
        : public FLogCategory<ELogVerbosity::DefaultVerbosity, ELogVerbosity::CompileTimeVerbosity> {                  \
        FLogCategory##CategoryName() : FLogCategory(TEXT(#CategoryName)) {}                                            \
    } CategoryName;
#define DEFINE_LOG_CATEGORY(CategoryName) FLogCategory##CategoryName CategoryName;
#define DEFINE_LOG_CATEGORY_STATIC(CategoryName, DefaultVerbosity, CompileTimeVerbosity)                               \
    static struct FLogCategory##CategoryName                                                                           \
        : public FLogCategory<ELogVerbosity::DefaultVerbosity, ELogVerbosity::CompileTimeVerbosity> {                  \
        FLogCategory##CategoryName() : FLogCategory(TEXT(#CategoryName)) {}                                            \
    } CategoryName;
#define DECLARE_LOG_CATEGORY_CLASS(CategoryName, DefaultVerbosity, CompileTimeVerbosity)                               \
    DEFINE_LOG_CATEGORY_STATIC(CategoryName, DefaultVerbosity, CompileTimeVerbosity)

#if NO_LOGGING
#define UE_LOG(CategoryName, Verbosity, Format, ...) ((void)0)
#define UE_CLOG(Condition, CategoryName, Verbosity, Format, ...) ((void)0)
#define UE_LOG_ACTIVE(CategoryName, Verbosity) (false)
#else
/** Logs printf-like: `UE_LOG(LogTemp, Warning, TEXT("%s is %d"), *Name, Value);` Fatal does not return. */
#define UE_LOG(CategoryName, Verbosity, Format, ...)                                                                   \
    do {                                                                                                               \
        if constexpr ((ELogVerbosity::Verbosity & ELogVerbosity::VerbosityMask) <=                                     \
                      std::remove_cvref_t<decltype(CategoryName)>::CompileTimeVerbosity) {                             \
            if (!(CategoryName).IsSuppressed(ELogVerbosity::Verbosity)) {                                              \
                FMsg::Logf(__FILE__, __LINE__, (CategoryName).GetCategoryName(), ELogVerbosity::Verbosity, Format,     \
                    ##__VA_ARGS__);                                                                                    \
            }                                                                                                          \
            if constexpr (ELogVerbosity::Verbosity == ELogVerbosity::Fatal) {                                          \
                __builtin_unreachable();                                                                               \
            }                                                                                                          \
        }                                                                                                              \
    } while (0)
#define UE_CLOG(Condition, CategoryName, Verbosity, Format, ...)                                                       \
    do {                                                                                                               \
        if (Condition) {                                                                                               \
            UE_LOG(CategoryName, Verbosity, Format, ##__VA_ARGS__);                                                    \
        }                                                                                                              \
    } while (0)
#define UE_LOG_ACTIVE(CategoryName, Verbosity) (!(CategoryName).IsSuppressed(ELogVerbosity::Verbosity))
#endif
#define UE_SUPPRESS(CategoryName, Verbosity, Statement)                                                                \
    do {                                                                                                               \
        if (UE_LOG_ACTIVE(CategoryName, Verbosity)) {                                                                  \
            Statement;                                                                                                 \
        }                                                                                                              \
    } while (0)
