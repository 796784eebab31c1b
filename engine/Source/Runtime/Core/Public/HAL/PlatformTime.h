// SPDX-License-Identifier: MIT
/** FPlatformTime: the monotonic clock. */
#pragma once

#include "CoreTypes.h"

struct FGenericPlatformTime {
    /** Seconds of a monotonic clock; its zero means nothing. */
    static CORE_API double Seconds();
    /** Nanoseconds. */
    static CORE_API uint32 Cycles();
    static CORE_API uint64 Cycles64();
    static double GetSecondsPerCycle() { return 1e-9; }
    static double GetSecondsPerCycle64() { return 1e-9; }
    static double ToMilliseconds(uint32 InCycles) { return static_cast<double>(InCycles) * 1e-6; }
    static double ToMilliseconds64(uint64 InCycles) { return static_cast<double>(InCycles) * 1e-6; }
    static double ToSeconds(uint32 InCycles) { return static_cast<double>(InCycles) * 1e-9; }
    static double ToSeconds64(uint64 InCycles) { return static_cast<double>(InCycles) * 1e-9; }
    static uint64 SecondsToCycles64(double Seconds) { return static_cast<uint64>(Seconds * 1e9); }
    static CORE_API void SystemTime(
        int32& Year, int32& Month, int32& DayOfWeek, int32& Day, int32& Hour, int32& Min, int32& Sec, int32& MSec);
    static CORE_API void UtcTime(
        int32& Year, int32& Month, int32& DayOfWeek, int32& Day, int32& Hour, int32& Min, int32& Sec, int32& MSec);
};
typedef FGenericPlatformTime FPlatformTime;
