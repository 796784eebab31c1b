// SPDX-License-Identifier: MIT
/** Log categories. Each registers itself, so that `Log LogFoo Verbose` on the console and -LogCmds find it. */
#pragma once

#include <atomic>

#include "Logging/LogVerbosity.h"
#include "UObject/NameTypes.h"

using FLogCategoryName = FName;

struct FLogCategoryBase {
    CORE_API FLogCategoryBase(const FLogCategoryName& InCategoryName, ELogVerbosity::Type InDefaultVerbosity,
        ELogVerbosity::Type InCompileTimeVerbosity);
    CORE_API ~FLogCategoryBase();
    UE_NONCOPYABLE(FLogCategoryBase)

    bool IsSuppressed(ELogVerbosity::Type VerbosityLevel) const {
        return (VerbosityLevel & ELogVerbosity::VerbosityMask) > GetVerbosity();
    }
    const FLogCategoryName& GetCategoryName() const { return CategoryName; }
    ELogVerbosity::Type GetVerbosity() const { return Verbosity.load(std::memory_order_relaxed); }
    void SetVerbosity(ELogVerbosity::Type NewVerbosity) {
        const int32 Wanted = NewVerbosity & ELogVerbosity::VerbosityMask;
        Verbosity.store(
            static_cast<ELogVerbosity::Type>(Wanted < CompileTimeVerbosity ? Wanted : CompileTimeVerbosity),
            std::memory_order_relaxed);
    }
    ELogVerbosity::Type GetCompileTimeVerbosity() const { return CompileTimeVerbosity; }

private:
    std::atomic<ELogVerbosity::Type> Verbosity; // the console changes it while other threads log
    const ELogVerbosity::Type CompileTimeVerbosity;
    const FLogCategoryName CategoryName;
};

template <ELogVerbosity::Type InDefaultVerbosity, ELogVerbosity::Type InCompileTimeVerbosity>
struct FLogCategory : public FLogCategoryBase {
    static constexpr ELogVerbosity::Type CompileTimeVerbosity = InCompileTimeVerbosity;
    explicit FLogCategory(const FLogCategoryName& InCategoryName)
        : FLogCategoryBase(InCategoryName, InDefaultVerbosity, InCompileTimeVerbosity) {}
};

/** Registered log categories by name; null if there is none of that name. */
CORE_API FLogCategoryBase* FindLogCategory(const FName& Name);
/** Applies "LogFoo Verbose, LogBar Error" (or "global Warning"); false if a word is not understood. */
CORE_API bool ApplyLogCommands(const FString& Commands);
