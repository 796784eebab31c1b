// SPDX-License-Identifier: MIT
/** FTimespan: a length of time in ticks of 100 nanoseconds. */
#pragma once

#include "Containers/UnrealString.h"
#include "Math/UnrealMathUtility.h"

namespace ETimespan {
inline constexpr int64 TicksPerDay = 864000000000;
inline constexpr int64 TicksPerHour = 36000000000;
inline constexpr int64 TicksPerMicrosecond = 10;
inline constexpr int64 TicksPerMillisecond = 10000;
inline constexpr int64 TicksPerMinute = 600000000;
inline constexpr int64 TicksPerSecond = 10000000;
inline constexpr int64 NanosecondsPerTick = 100;
} // namespace ETimespan

struct FTimespan {
    constexpr FTimespan() : Ticks(0) {}
    explicit constexpr FTimespan(int64 InTicks) : Ticks(InTicks) {}
    constexpr FTimespan(int32 Hours, int32 Minutes, int32 Seconds) : FTimespan(0, Hours, Minutes, Seconds, 0) {}
    constexpr FTimespan(int32 Days, int32 Hours, int32 Minutes, int32 Seconds)
        : FTimespan(Days, Hours, Minutes, Seconds, 0) {}
    constexpr FTimespan(int32 Days, int32 Hours, int32 Minutes, int32 Seconds, int32 FractionNano)
        : Ticks(Days * ETimespan::TicksPerDay + Hours * ETimespan::TicksPerHour + Minutes * ETimespan::TicksPerMinute +
                Seconds * ETimespan::TicksPerSecond + FractionNano / ETimespan::NanosecondsPerTick) {}

    constexpr FTimespan operator+(const FTimespan& O) const { return FTimespan(Ticks + O.Ticks); }
    constexpr FTimespan operator-(const FTimespan& O) const { return FTimespan(Ticks - O.Ticks); }
    constexpr FTimespan operator-() const { return FTimespan(-Ticks); }
    FTimespan operator*(double Scalar) const {
        return FTimespan(static_cast<int64>(static_cast<double>(Ticks) * Scalar));
    }
    FTimespan operator/(double Scalar) const {
        return FTimespan(static_cast<int64>(static_cast<double>(Ticks) / Scalar));
    }
    FTimespan& operator+=(const FTimespan& O) {
        Ticks += O.Ticks;
        return *this;
    }
    FTimespan& operator-=(const FTimespan& O) {
        Ticks -= O.Ticks;
        return *this;
    }
    constexpr bool operator==(const FTimespan& O) const { return Ticks == O.Ticks; }
    constexpr auto operator<=>(const FTimespan& O) const { return Ticks <=> O.Ticks; }

    constexpr int64 GetTicks() const { return Ticks; }
    int32 GetDays() const { return static_cast<int32>(Ticks / ETimespan::TicksPerDay); }
    int32 GetHours() const { return static_cast<int32>(Ticks / ETimespan::TicksPerHour % 24); }
    int32 GetMinutes() const { return static_cast<int32>(Ticks / ETimespan::TicksPerMinute % 60); }
    int32 GetSeconds() const { return static_cast<int32>(Ticks / ETimespan::TicksPerSecond % 60); }
    int32 GetFractionMilli() const {
        return static_cast<int32>(Ticks % ETimespan::TicksPerSecond / ETimespan::TicksPerMillisecond);
    }
    int32 GetFractionMicro() const {
        return static_cast<int32>(Ticks % ETimespan::TicksPerSecond / ETimespan::TicksPerMicrosecond);
    }
    int32 GetFractionNano() const {
        return static_cast<int32>(Ticks % ETimespan::TicksPerSecond * ETimespan::NanosecondsPerTick);
    }
    int32 GetFractionTicks() const { return static_cast<int32>(Ticks % ETimespan::TicksPerSecond); }
    FTimespan GetDuration() const { return FTimespan(Ticks < 0 ? -Ticks : Ticks); }
    double GetTotalDays() const { return static_cast<double>(Ticks) / static_cast<double>(ETimespan::TicksPerDay); }
    double GetTotalHours() const { return static_cast<double>(Ticks) / static_cast<double>(ETimespan::TicksPerHour); }
    double GetTotalMinutes() const {
        return static_cast<double>(Ticks) / static_cast<double>(ETimespan::TicksPerMinute);
    }
    double GetTotalSeconds() const {
        return static_cast<double>(Ticks) / static_cast<double>(ETimespan::TicksPerSecond);
    }
    double GetTotalMilliseconds() const {
        return static_cast<double>(Ticks) / static_cast<double>(ETimespan::TicksPerMillisecond);
    }
    double GetTotalMicroseconds() const {
        return static_cast<double>(Ticks) / static_cast<double>(ETimespan::TicksPerMicrosecond);
    }
    bool IsZero() const { return Ticks == 0; }
    /** "[-][d.]hh:mm:ss.fff". */
    CORE_API FString ToString() const;
    /** %d %h %m %s %f (milliseconds) %u %t %n %D %H %M %S %F, as UE. */
    CORE_API FString ToString(const TCHAR* Format) const;
    static CORE_API bool Parse(const FString& TimespanString, FTimespan& OutTimespan);

    static FTimespan FromDays(double Days) { return FromSeconds(Days * 86400.0); }
    static FTimespan FromHours(double Hours) { return FromSeconds(Hours * 3600.0); }
    static FTimespan FromMinutes(double Minutes) { return FromSeconds(Minutes * 60.0); }
    static FTimespan FromSeconds(double Seconds) {
        return FTimespan(
            static_cast<int64>(std::floor(Seconds * static_cast<double>(ETimespan::TicksPerSecond) + 0.5)));
    }
    static FTimespan FromMilliseconds(double Milliseconds) { return FromSeconds(Milliseconds * 1e-3); }
    static FTimespan FromMicroseconds(double Microseconds) { return FromSeconds(Microseconds * 1e-6); }
    static constexpr FTimespan MaxValue() { return FTimespan(MAX_int64); }
    static constexpr FTimespan MinValue() { return FTimespan(MIN_int64); }
    static constexpr FTimespan Zero() { return FTimespan(0); }
    static double Ratio(FTimespan Dividend, FTimespan Divisor) {
        return static_cast<double>(Dividend.Ticks) / static_cast<double>(Divisor.Ticks);
    }
    friend uint32 GetTypeHash(const FTimespan& Timespan) { return GetTypeHash(Timespan.Ticks); }

private:
    int64 Ticks;
};
inline FTimespan operator*(double Scalar, const FTimespan& Timespan) { return Timespan * Scalar; }
