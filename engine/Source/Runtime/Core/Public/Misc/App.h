// SPDX-License-Identifier: MIT
/** FApp: the application's name, clock and time step. Times in seconds. */
#pragma once

#include "Misc/Guid.h"

class FApp {
public:
    static CORE_API FGuid GetInstanceId();
    static CORE_API FGuid GetSessionId();
    static CORE_API FString GetInstanceName();
    static CORE_API const TCHAR* GetProjectName();
    static CORE_API bool HasProjectName();
    static CORE_API void SetProjectName(const TCHAR* InProjectName);
    static CORE_API FString GetName();
    static CORE_API const TCHAR* GetBuildVersion();
    static CORE_API bool CanEverRender();
    static CORE_API bool IsUnattended();
    static bool IsGame() { return true; }
    static bool IsInstalled() { return false; }

    static CORE_API double GetCurrentTime();
    static CORE_API void SetCurrentTime(double Seconds);
    static CORE_API double GetLastTime();
    static CORE_API void UpdateLastTime();
    static CORE_API double GetGameTime();
    static CORE_API void SetGameTime(double Seconds);
    /** Length of this frame. */
    static CORE_API double GetDeltaTime();
    static CORE_API void SetDeltaTime(double Seconds);
    static CORE_API double GetIdleTime();
    static CORE_API void SetIdleTime(double Seconds);
    static CORE_API double GetIdleTimeOvershoot();
    static CORE_API void SetIdleTimeOvershoot(double Seconds);
    static CORE_API double GetFixedDeltaTime();
    static CORE_API void SetFixedDeltaTime(double Seconds);
    /** Frames of fixed length without waiting. */
    static CORE_API bool UseFixedTimeStep();
    static CORE_API void SetUseFixedTimeStep(bool bVal);
    static CORE_API bool IsBenchmarking();
    static CORE_API void SetBenchmarking(bool bVal);
    static CORE_API bool UseFixedSeed();
    static CORE_API void SetUseFixedSeed(bool bVal);
};
