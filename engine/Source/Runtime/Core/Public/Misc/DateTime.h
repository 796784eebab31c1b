// SPDX-License-Identifier: MIT
/** FDateTime: a date and time in ticks of 100 nanoseconds since 1 January 0001, Gregorian calendar, no time zone. */
#pragma once

#include "Misc/Timespan.h"

enum class EDayOfWeek { Monday = 0, Tuesday, Wednesday, Thursday, Friday, Saturday, Sunday };
enum class EMonthOfYear {
    January = 1,
    February,
    March,
    April,
    May,
    June,
    July,
    August,
    September,
    October,
    November,
    December
};

struct FDateTime {
    constexpr FDateTime() : Ticks(0) {}
    explicit constexpr FDateTime(int64 InTicks) : Ticks(InTicks) {}
    CORE_API FDateTime(
        int32 Year, int32 Month, int32 Day, int32 Hour = 0, int32 Minute = 0, int32 Second = 0, int32 Millisecond = 0);

    FDateTime operator+(const FTimespan& O) const { return FDateTime(Ticks + O.GetTicks()); }
    FDateTime operator-(const FTimespan& O) const { return FDateTime(Ticks - O.GetTicks()); }
    FTimespan operator-(const FDateTime& O) const { return FTimespan(Ticks - O.Ticks); }
    FDateTime& operator+=(const FTimespan& O) { return *this = *this + O; }
    FDateTime& operator-=(const FTimespan& O) { return *this = *this - O; }
    constexpr bool operator==(const FDateTime& O) const { return Ticks == O.Ticks; }
    constexpr auto operator<=>(const FDateTime& O) const { return Ticks <=> O.Ticks; }

    constexpr int64 GetTicks() const { return Ticks; }
    CORE_API void GetDate(int32& OutYear, int32& OutMonth, int32& OutDay) const;
    FDateTime GetDate() const { return FDateTime(Ticks - Ticks % ETimespan::TicksPerDay); }
    FTimespan GetTimeOfDay() const { return FTimespan(Ticks % ETimespan::TicksPerDay); }
    int32 GetYear() const { return Part(0); }
    int32 GetMonth() const { return Part(1); }
    int32 GetDay() const { return Part(2); }
    EMonthOfYear GetMonthOfYear() const { return static_cast<EMonthOfYear>(GetMonth()); }
    EDayOfWeek GetDayOfWeek() const { return static_cast<EDayOfWeek>(Ticks / ETimespan::TicksPerDay % 7); }
    CORE_API int32 GetDayOfYear() const;
    int32 GetHour() const { return static_cast<int32>(Ticks / ETimespan::TicksPerHour % 24); }
    int32 GetHour12() const {
        const int32 Hour = GetHour();
        return Hour < 1 ? 12 : (Hour > 12 ? Hour - 12 : Hour);
    }
    bool IsAfternoon() const { return GetHour() >= 12; }
    bool IsMorning() const { return GetHour() < 12; }
    int32 GetMinute() const { return static_cast<int32>(Ticks / ETimespan::TicksPerMinute % 60); }
    int32 GetSecond() const { return static_cast<int32>(Ticks / ETimespan::TicksPerSecond % 60); }
    int32 GetMillisecond() const { return static_cast<int32>(Ticks / ETimespan::TicksPerMillisecond % 1000); }
    double GetJulianDay() const {
        return 1721425.5 + static_cast<double>(Ticks) / static_cast<double>(ETimespan::TicksPerDay);
    }
    int64 ToUnixTimestamp() const { return (Ticks - FDateTime(1970, 1, 1).Ticks) / ETimespan::TicksPerSecond; }

    /** "yyyy.mm.dd-hh.mm.ss". */
    FString ToString() const { return ToString(TEXT("%Y.%m.%d-%H.%M.%S")); }
    /** %a %A %w %y %Y %b %B %m %d %e %j %l %h %H %I %M %S %s (milliseconds) %T %n. */
    CORE_API FString ToString(const TCHAR* Format) const;
    /** "yyyy-mm-ddThh:mm:ss.mmmZ". */
    FString ToIso8601() const { return ToString(TEXT("%Y-%m-%dT%H:%M:%S.%sZ")); }
    FString ToHttpDate() const { return ToString(TEXT("%a, %d %b %Y %H:%M:%S GMT")); }
    /** Reads what ToString() writes. */
    static CORE_API bool Parse(const FString& DateTimeString, FDateTime& OutDateTime);
    static CORE_API bool ParseIso8601(const TCHAR* DateTimeString, FDateTime& OutDateTime);

    static CORE_API int32 DaysInMonth(int32 Year, int32 Month);
    static int32 DaysInYear(int32 Year) { return IsLeapYear(Year) ? 366 : 365; }
    static bool IsLeapYear(int32 Year) { return Year % 4 == 0 && (Year % 100 != 0 || Year % 400 == 0); }
    static CORE_API bool Validate(
        int32 Year, int32 Month, int32 Day, int32 Hour, int32 Minute, int32 Second, int32 Millisecond);
    static FDateTime FromUnixTimestamp(int64 UnixTime) {
        return FDateTime(1970, 1, 1) + FTimespan(UnixTime * ETimespan::TicksPerSecond);
    }
    static FDateTime FromJulianDay(double JulianDay) {
        return FDateTime(static_cast<int64>((JulianDay - 1721425.5) * static_cast<double>(ETimespan::TicksPerDay)));
    }
    static constexpr FDateTime MinValue() { return FDateTime(0); }
    static constexpr FDateTime MaxValue() { return FDateTime(3652059 * ETimespan::TicksPerDay - 1); }
    static CORE_API FDateTime Now();
    static FDateTime Today() { return Now().GetDate(); }
    static CORE_API FDateTime UtcNow();
    friend uint32 GetTypeHash(const FDateTime& DateTime) { return GetTypeHash(DateTime.Ticks); }

private:
    int32 Part(int32 Index) const {
        int32 Parts[3];
        GetDate(Parts[0], Parts[1], Parts[2]);
        return Parts[Index];
    }
    int64 Ticks;
};
