// SPDX-License-Identifier: MIT
// FPlatformProcess.
#include "HAL/PlatformProcess.h"

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include <dlfcn.h>
#include <pthread.h>
#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "CoreMinimal.h"
#include "HAL/PlatformTLS.h"
#include "Misc/Paths.h"

uint32 FGenericPlatformTLS::GetCurrentThreadId() {
    static thread_local const uint32 Id = static_cast<uint32>(::syscall(SYS_gettid));
    return Id;
}

uint32 FGenericPlatformProcess::GetCurrentProcessId() { return static_cast<uint32>(::getpid()); }
void FGenericPlatformProcess::Sleep(float Seconds) {
    if (Seconds > 0.0f) {
        std::this_thread::sleep_for(std::chrono::duration<double>(static_cast<double>(Seconds)));
    } else {
        ::sched_yield();
    }
}
void FGenericPlatformProcess::SleepNoStats(float Seconds) { Sleep(Seconds); }
void FGenericPlatformProcess::YieldThread() { ::sched_yield(); }
void FGenericPlatformProcess::SetThreadName(const TCHAR* ThreadName) {
    ::pthread_setname_np(::pthread_self(), std::string(TCHAR_TO_UTF8(ThreadName)).substr(0, 15).c_str());
}

const TCHAR* FGenericPlatformProcess::ExecutablePath() {
    static const FString Path = [] {
        std::error_code Error;
        return FString(UTF8_TO_TCHAR(std::filesystem::read_symlink("/proc/self/exe", Error).c_str()));
    }();
    return *Path;
}
const TCHAR* FGenericPlatformProcess::ExecutableName(bool bRemoveExtension) {
    static const FString Name = FPaths::GetCleanFilename(ExecutablePath());
    return *Name;
}
const TCHAR* FGenericPlatformProcess::BaseDir() {
    static const FString Dir = FPaths::GetPath(ExecutablePath()) + TEXT("/");
    return *Dir;
}
const TCHAR* FGenericPlatformProcess::ComputerName() {
    static const FString Name = [] {
        char Buffer[256] = {};
        ::gethostname(Buffer, sizeof(Buffer) - 1);
        return FString(UTF8_TO_TCHAR(Buffer));
    }();
    return *Name;
}
const TCHAR* FGenericPlatformProcess::UserName(bool bOnlyAlphaNumeric) {
    static const FString Name = [] {
        const char* User = std::getenv("USER");
        return User ? FString(UTF8_TO_TCHAR(User)) : FString::FromInt(static_cast<int32>(::getuid()));
    }();
    return *Name;
}
const TCHAR* FGenericPlatformProcess::UserTempDir() {
    static const FString Dir = [] {
        std::error_code Error;
        return FString(UTF8_TO_TCHAR(std::filesystem::temp_directory_path(Error).c_str())) + TEXT("/");
    }();
    return *Dir;
}
FString FGenericPlatformProcess::GetCurrentWorkingDirectory() {
    std::error_code Error;
    return FString(UTF8_TO_TCHAR(std::filesystem::current_path(Error).c_str()));
}

void* FGenericPlatformProcess::GetDllHandle(const TCHAR* Filename) {
    return ::dlopen(TCHAR_TO_UTF8(Filename), RTLD_NOW | RTLD_GLOBAL);
}
void FGenericPlatformProcess::FreeDllHandle(void* DllHandle) { ::dlclose(DllHandle); }
void* FGenericPlatformProcess::GetDllExport(void* DllHandle, const TCHAR* ProcName) {
    return ::dlsym(DllHandle, TCHAR_TO_UTF8(ProcName));
}
FString FGenericPlatformProcess::GetDllError() {
    const char* Error = ::dlerror();
    return Error ? FString(UTF8_TO_TCHAR(Error)) : FString();
}
