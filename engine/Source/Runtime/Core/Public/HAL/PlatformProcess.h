// SPDX-License-Identifier: MIT
/** FPlatformProcess: this process, sleeping, shared libraries. */
#pragma once

#include "Containers/UnrealString.h"

class FEvent;
enum class EEventMode { AutoReset, ManualReset };

struct FGenericPlatformProcess {
    static CORE_API uint32 GetCurrentProcessId();
    /** Suspends the calling thread. */
    static CORE_API void Sleep(float Seconds);
    static CORE_API void SleepNoStats(float Seconds);
    static CORE_API void YieldThread();
    static CORE_API void SetThreadName(const TCHAR* ThreadName);
    static CORE_API const TCHAR* ExecutablePath();
    static CORE_API const TCHAR* ExecutableName(bool bRemoveExtension = true);
    static CORE_API const TCHAR* BaseDir();
    static CORE_API const TCHAR* ComputerName();
    static CORE_API const TCHAR* UserName(bool bOnlyAlphaNumeric = true);
    static CORE_API const TCHAR* UserTempDir();
    static CORE_API FString GetCurrentWorkingDirectory();
    /** dlopen. Null on failure, and then GetDllError tells why. */
    static CORE_API void* GetDllHandle(const TCHAR* Filename);
    static CORE_API void FreeDllHandle(void* DllHandle);
    static CORE_API void* GetDllExport(void* DllHandle, const TCHAR* ProcName);
    static CORE_API FString GetDllError();
    /** An event of a pool; give it back with ReturnSynchEventToPool. */
    static CORE_API FEvent* GetSynchEventFromPool(bool bIsManualReset = false);
    static CORE_API void ReturnSynchEventToPool(FEvent* Event);
};
typedef FGenericPlatformProcess FPlatformProcess;
