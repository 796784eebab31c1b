// SPDX-License-Identifier: MIT
#include "Misc/AssertionMacros.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <execinfo.h>

#include "CoreGlobals.h"
#include "Misc/OutputDeviceRedirector.h"

namespace {
std::atomic<bool> GHasAsserted{false};
std::atomic<SIZE_T> GNumEnsureFailures{0};

FString Describe(const TCHAR* Format, va_list Args) {
    return Format && *Format ? FString::PrintfVa(Format, Args) : FString();
}

/** The last words: to stderr first, which always works, then to the other devices. */
[[noreturn]] void Die(const FString& Message) {
    // A failure while reporting a failure (or on a second thread meanwhile) must not report again.
    if (GHasAsserted.exchange(true)) {
        std::abort();
    }
    GIsCriticalError = true;
    FCString::Strncpy(GErrorHist, *Message, UE_ARRAY_COUNT(GErrorHist));
    std::fprintf(stderr, "%s\n", TCHAR_TO_UTF8(*Message));
    FDebug::DumpStackTraceToLog();
    FOutputDeviceRedirector* Log = FOutputDeviceRedirector::Get();
    Log->RemoveOutputDevice(&FOutputDeviceStdErr::Get());
    Log->Serialize(*Message, ELogVerbosity::Error, FName(TEXT("LogCore")));
    Log->Flush();
    std::fflush(nullptr);
    std::abort();
}
} // namespace

void FDebug::CheckVerifyFailed(const ANSICHAR* Expr, const ANSICHAR* File, int32 Line, const TCHAR* Format, ...) {
    va_list Args;
    va_start(Args, Format);
    const FString Message = Describe(Format, Args);
    va_end(Args);
    Die(FString::Printf(TEXT("Assertion failed: %hs [File:%hs] [Line: %d] %s"), Expr, File, Line, *Message));
}

bool FDebug::EnsureFailed(const ANSICHAR* Expr, const ANSICHAR* File, int32 Line, const TCHAR* Format, ...) {
    va_list Args;
    va_start(Args, Format);
    const FString Message = Describe(Format, Args);
    va_end(Args);
    GNumEnsureFailures.fetch_add(1);
    UE_LOG(LogCore, Error, TEXT("Ensure condition failed: %hs [File:%hs] [Line: %d] %s"), Expr, File, Line, *Message);
    DumpStackTraceToLog();
    return false;
}

void FDebug::DumpStackTraceToLog() {
    void* Frames[64];
    const int NumFrames = backtrace(Frames, 64);
    backtrace_symbols_fd(Frames, NumFrames, 2);
}

SIZE_T FDebug::GetNumEnsureFailures() { return GNumEnsureFailures.load(); }

bool FDebug::HasAsserted() { return GHasAsserted.load(); }

void LowLevelFatalErrorImpl(const ANSICHAR* File, int32 Line, const TCHAR* Format, ...) {
    va_list Args;
    va_start(Args, Format);
    const FString Message = Describe(Format, Args);
    va_end(Args);
    Die(FString::Printf(TEXT("Fatal error: [File:%hs] [Line: %d] %s"), File, Line, *Message));
}
