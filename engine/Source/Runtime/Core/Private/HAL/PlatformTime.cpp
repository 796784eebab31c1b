// SPDX-License-Identifier: MIT
#include "HAL/PlatformTime.h"

#include <ctime>

#include "CoreMinimal.h"
#include "Misc/DateTime.h"

namespace {
void Split(const FDateTime& Time, int32& Year, int32& Month, int32& DayOfWeek, int32& Day, int32& Hour, int32& Min,
    int32& Sec, int32& MSec) {
    Time.GetDate(Year, Month, Day);
    DayOfWeek = (static_cast<int32>(Time.GetDayOfWeek()) + 1) % 7; // Sunday is 0
    Hour = Time.GetHour();
    Min = Time.GetMinute();
    Sec = Time.GetSecond();
    MSec = Time.GetMillisecond();
}
} // namespace

uint64 FGenericPlatformTime::Cycles64() {
    timespec Time{};
    ::clock_gettime(CLOCK_MONOTONIC, &Time);
    return static_cast<uint64>(Time.tv_sec) * 1000000000ull + static_cast<uint64>(Time.tv_nsec);
}
uint32 FGenericPlatformTime::Cycles() { return static_cast<uint32>(Cycles64()); }
double FGenericPlatformTime::Seconds() { return static_cast<double>(Cycles64()) * 1e-9; }
void FGenericPlatformTime::SystemTime(
    int32& Year, int32& Month, int32& DayOfWeek, int32& Day, int32& Hour, int32& Min, int32& Sec, int32& MSec) {
    Split(FDateTime::Now(), Year, Month, DayOfWeek, Day, Hour, Min, Sec, MSec);
}
void FGenericPlatformTime::UtcTime(
    int32& Year, int32& Month, int32& DayOfWeek, int32& Day, int32& Hour, int32& Min, int32& Sec, int32& MSec) {
    Split(FDateTime::UtcNow(), Year, Month, DayOfWeek, Day, Hour, Min, Sec, MSec);
}
