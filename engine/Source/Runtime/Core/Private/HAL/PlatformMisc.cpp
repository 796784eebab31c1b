// SPDX-License-Identifier: MIT
#include "HAL/PlatformMisc.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include <unistd.h>

#include "CoreMinimal.h"

namespace {
std::atomic<uint8> RequestedExitStatus{0};
}

void FGenericPlatformMisc::RequestExit(bool bForce, const TCHAR* CallSite) {
    RequestExitWithStatus(bForce, 0, CallSite);
}
void FGenericPlatformMisc::RequestExitWithStatus(bool bForce, uint8 ReturnCode, const TCHAR* CallSite) {
    RequestedExitStatus = ReturnCode;
    if (bForce) {
        std::fflush(nullptr);
        ::_exit(ReturnCode);
    }
    RequestEngineExit(CallSite ? CallSite : TEXT("RequestExit"));
}
uint8 FGenericPlatformMisc::GetRequestedExitStatus() { return RequestedExitStatus; }

FString FGenericPlatformMisc::GetEnvironmentVariable(const TCHAR* VariableName) {
    const char* Value = std::getenv(TCHAR_TO_UTF8(VariableName));
    return Value ? FString(UTF8_TO_TCHAR(Value)) : FString();
}
void FGenericPlatformMisc::SetEnvironmentVar(const TCHAR* VariableName, const TCHAR* Value) {
    if (Value && *Value) {
        ::setenv(TCHAR_TO_UTF8(VariableName), TCHAR_TO_UTF8(Value), 1);
    } else {
        ::unsetenv(TCHAR_TO_UTF8(VariableName));
    }
}
int32 FGenericPlatformMisc::NumberOfCoresIncludingHyperthreads() {
    return FMath::Max(1, static_cast<int32>(std::thread::hardware_concurrency()));
}
int32 FGenericPlatformMisc::NumberOfCores() { return NumberOfCoresIncludingHyperthreads(); }
void FGenericPlatformMisc::CreateGuid(FGuid& Result) { Result = FGuid::NewGuid(); }
void FGenericPlatformMisc::LowLevelOutputDebugString(const TCHAR* Message) { LocalPrint(Message); }
void FGenericPlatformMisc::LocalPrint(const TCHAR* Message) { std::fputs(TCHAR_TO_UTF8(Message), stderr); }

bool FGenericPlatformMisc::IsDebuggerPresent() {
    std::FILE* Status = std::fopen("/proc/self/status", "r");
    if (!Status) {
        return false;
    }
    char Line[256];
    int Tracer = 0;
    while (std::fgets(Line, sizeof(Line), Status) && std::sscanf(Line, "TracerPid: %d", &Tracer) != 1) {}
    std::fclose(Status);
    return Tracer != 0;
}

FString FGenericPlatformMisc::GetDefaultLanguage() {
    const FString Language = GetEnvironmentVariable(TEXT("LANG"));
    return Language.IsEmpty() ? FString(TEXT("en")) : Language.Left(2);
}
