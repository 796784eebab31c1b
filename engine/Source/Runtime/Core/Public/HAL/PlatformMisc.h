// SPDX-License-Identifier: MIT
/** FPlatformMisc: what belongs nowhere else. */
#pragma once

#include "Containers/UnrealString.h"
#include "Misc/Guid.h"

struct FGenericPlatformMisc {
    /** Ends the process: at once if forced, else by asking the engine loop. Callable from any thread. */
    static CORE_API void RequestExit(bool bForce, const TCHAR* CallSite = nullptr);
    static CORE_API void RequestExitWithStatus(bool bForce, uint8 ReturnCode, const TCHAR* CallSite = nullptr);
    /** Exit status asked for by RequestExitWithStatus; 0 otherwise. */
    static CORE_API uint8 GetRequestedExitStatus();
    static CORE_API FString GetEnvironmentVariable(const TCHAR* VariableName);
    static CORE_API void SetEnvironmentVar(const TCHAR* VariableName, const TCHAR* Value);
    static CORE_API int32 NumberOfCores();
    static CORE_API int32 NumberOfCoresIncludingHyperthreads();
    static CORE_API void CreateGuid(FGuid& Result);
    static CORE_API void LowLevelOutputDebugString(const TCHAR* Message);
    static CORE_API void LocalPrint(const TCHAR* Message);
    static CORE_API bool IsDebuggerPresent();
    static CORE_API FString GetDefaultLanguage();
    static const TCHAR* GetPathVarDelimiter() { return TEXT(":"); }
    static void MemoryBarrier() { __sync_synchronize(); }
};
typedef FGenericPlatformMisc FPlatformMisc;
