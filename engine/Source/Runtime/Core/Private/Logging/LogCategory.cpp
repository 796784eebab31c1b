// SPDX-License-Identifier: MIT
#include "Logging/LogCategory.h"

#include "CoreGlobals.h"
#include "Logging/LogMacros.h"
#include "Misc/OutputDeviceRedirector.h"
#include "Misc/ScopeLock.h"

namespace {
struct FLogCategories {
    FCriticalSection Lock;
    TMultiMap<FName, FLogCategoryBase*> ByName;
    /** Verbosities asked for before their category existed. */
    TMap<FName, ELogVerbosity::Type> Wanted;
    static FLogCategories& Get() {
        static FLogCategories& Instance = *new FLogCategories();
        return Instance;
    }
};

const TCHAR* const VerbosityNames[] = {TEXT("NoLogging"), TEXT("Fatal"), TEXT("Error"), TEXT("Warning"),
    TEXT("Display"), TEXT("Log"), TEXT("Verbose"), TEXT("VeryVerbose")};

bool FindVerbosity(FStringView Word, ELogVerbosity::Type& Out) {
    for (uint8 Index = 0; Index < ELogVerbosity::NumVerbosity; ++Index) {
        if (Word == FStringView(VerbosityNames[Index])) {
            Out = static_cast<ELogVerbosity::Type>(Index);
            return true;
        }
    }
    if (Word == TEXTVIEW("All")) {
        Out = ELogVerbosity::All;
        return true;
    }
    if (Word == TEXTVIEW("off") || Word == TEXTVIEW("none")) {
        Out = ELogVerbosity::NoLogging;
        return true;
    }
    return false;
}
} // namespace

const TCHAR* ToString(ELogVerbosity::Type Verbosity) {
    const int32 Index = Verbosity & ELogVerbosity::VerbosityMask;
    return Index < ELogVerbosity::NumVerbosity ? VerbosityNames[Index] : TEXT("Unknown");
}

ELogVerbosity::Type ParseLogVerbosityFromString(const FString& VerbosityString) {
    ELogVerbosity::Type Result = ELogVerbosity::Log;
    FindVerbosity(VerbosityString, Result);
    return Result;
}

FLogCategoryBase::FLogCategoryBase(const FLogCategoryName& InCategoryName, ELogVerbosity::Type InDefaultVerbosity,
    ELogVerbosity::Type InCompileTimeVerbosity)
    : Verbosity(InDefaultVerbosity), CompileTimeVerbosity(InCompileTimeVerbosity), CategoryName(InCategoryName) {
    FLogCategories& Categories = FLogCategories::Get();
    FScopeLock Lock(&Categories.Lock);
    Categories.ByName.Add(CategoryName, this);
    const ELogVerbosity::Type* Wanted = Categories.Wanted.Find(CategoryName);
    SetVerbosity(Wanted ? *Wanted : InDefaultVerbosity);
}

FLogCategoryBase::~FLogCategoryBase() {
    FLogCategories& Categories = FLogCategories::Get();
    FScopeLock Lock(&Categories.Lock);
    Categories.ByName.Remove(CategoryName, this);
}

FLogCategoryBase* FindLogCategory(const FName& Name) {
    FLogCategories& Categories = FLogCategories::Get();
    FScopeLock Lock(&Categories.Lock);
    FLogCategoryBase** Found = Categories.ByName.Find(Name);
    return Found ? *Found : nullptr;
}

bool ApplyLogCommands(const FString& Commands) {
    FLogCategories& Categories = FLogCategories::Get();
    FScopeLock Lock(&Categories.Lock);
    bool bUnderstood = true;
    TArray<FString> Parts;
    Commands.ParseIntoArray(Parts, TEXT(","));
    for (const FString& Part : Parts) {
        TArray<FString> Words;
        Part.ParseIntoArrayWS(Words);
        ELogVerbosity::Type Verbosity = ELogVerbosity::Log;
        if (Words.Num() != 2 || !FindVerbosity(Words[1], Verbosity)) {
            bUnderstood = false;
            continue;
        }
        const bool bGlobal = Words[0] == TEXT("global");
        const FName Name(Words[0]);
        if (!bGlobal) {
            Categories.Wanted.Add(Name, Verbosity);
        }
        for (auto& Pair : Categories.ByName) {
            if (bGlobal || Pair.Key == Name) {
                Pair.Value->SetVerbosity(Verbosity);
            }
        }
    }
    return bUnderstood;
}

void FMsg::LogfImpl(
    const ANSICHAR* File, int32 Line, const FName& Category, ELogVerbosity::Type Verbosity, const TCHAR* Fmt, ...) {
    va_list Args;
    va_start(Args, Fmt);
    const FString Message = FString::PrintfVa(Fmt, Args);
    va_end(Args);
    if ((Verbosity & ELogVerbosity::VerbosityMask) == ELogVerbosity::Fatal) {
        LowLevelFatalErrorImpl(File, Line, TEXT("%s: %s"), *Category.ToString(), *Message);
    }
    FOutputDeviceRedirector::Get()->Serialize(*Message, Verbosity, Category);
}
