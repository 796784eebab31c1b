// SPDX-License-Identifier: MIT
// FDateTime and FTimespan: calendar, text. Mirrors Epic's API pages of these names.
#include "Misc/DateTime.h"

#include <ctime>
#include <sys/time.h>

#include "CoreMinimal.h"

namespace {

constexpr int32 DaysBefore[] = {0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334, 365};
const TCHAR* const DayNames[] = {TEXT("Monday"), TEXT("Tuesday"), TEXT("Wednesday"), TEXT("Thursday"), TEXT("Friday"),
    TEXT("Saturday"), TEXT("Sunday")};
const TCHAR* const MonthNames[] = {TEXT("January"), TEXT("February"), TEXT("March"), TEXT("April"), TEXT("May"),
    TEXT("June"), TEXT("July"), TEXT("August"), TEXT("September"), TEXT("October"), TEXT("November"), TEXT("December")};

/** Days from 1 January 0001 to 1 January of a year. */
int64 DaysBeforeYear(int64 Year) {
    const int64 Past = Year - 1;
    return Past * 365 + Past / 4 - Past / 100 + Past / 400;
}

/** Reads the digits at Cursor; false if there are none. */
bool ReadNumber(const TCHAR*& Cursor, int32& Value) {
    if (!FChar::IsDigit(*Cursor)) {
        return false;
    }
    int64 Number = 0;
    for (; FChar::IsDigit(*Cursor) && Number < 1000000000; ++Cursor) {
        Number = Number * 10 + (*Cursor - TEXT('0'));
    }
    Value = static_cast<int32>(Number);
    return true;
}

bool SkipChar(const TCHAR*& Cursor, TCHAR Char) {
    if (*Cursor != Char) {
        return false;
    }
    ++Cursor;
    return true;
}

FDateTime FromParts(const tm& Parts, int32 Millisecond) {
    return FDateTime(Parts.tm_year + 1900, Parts.tm_mon + 1, Parts.tm_mday, Parts.tm_hour, Parts.tm_min,
        FMath::Min(Parts.tm_sec, 59), Millisecond);
}

} // namespace

FDateTime::FDateTime(int32 Year, int32 Month, int32 Day, int32 Hour, int32 Minute, int32 Second, int32 Millisecond) {
    checkf(Validate(Year, Month, Day, Hour, Minute, Second, Millisecond),
        TEXT("%d-%d-%d %d:%d:%d.%d is no date and time"), Year, Month, Day, Hour, Minute, Second, Millisecond);
    const int64 Days = DaysBeforeYear(Year) + DaysBefore[Month - 1] + (Month > 2 && IsLeapYear(Year) ? 1 : 0) + Day - 1;
    Ticks = Days * ETimespan::TicksPerDay + Hour * ETimespan::TicksPerHour + Minute * ETimespan::TicksPerMinute +
            Second * ETimespan::TicksPerSecond + Millisecond * ETimespan::TicksPerMillisecond;
}

void FDateTime::GetDate(int32& OutYear, int32& OutMonth, int32& OutDay) const {
    const int64 Days = Ticks / ETimespan::TicksPerDay;
    int64 Year = Days / 366 + 1; // never too late
    while (DaysBeforeYear(Year + 1) <= Days) {
        ++Year;
    }
    int32 DayOfYear = static_cast<int32>(Days - DaysBeforeYear(Year));
    OutYear = static_cast<int32>(Year);
    for (OutMonth = 1; DayOfYear >= DaysInMonth(OutYear, OutMonth); ++OutMonth) {
        DayOfYear -= DaysInMonth(OutYear, OutMonth);
    }
    OutDay = DayOfYear + 1;
}

int32 FDateTime::GetDayOfYear() const {
    return static_cast<int32>(Ticks / ETimespan::TicksPerDay - DaysBeforeYear(GetYear())) + 1;
}

int32 FDateTime::DaysInMonth(int32 Year, int32 Month) {
    check(Month >= 1 && Month <= 12);
    return DaysBefore[Month] - DaysBefore[Month - 1] + (Month == 2 && IsLeapYear(Year) ? 1 : 0);
}

bool FDateTime::Validate(
    int32 Year, int32 Month, int32 Day, int32 Hour, int32 Minute, int32 Second, int32 Millisecond) {
    return Year >= 1 && Year <= 9999 && Month >= 1 && Month <= 12 && Day >= 1 && Day <= DaysInMonth(Year, Month) &&
           Hour >= 0 && Hour <= 23 && Minute >= 0 && Minute <= 59 && Second >= 0 && Second <= 59 && Millisecond >= 0 &&
           Millisecond <= 999;
}

FString FDateTime::ToString(const TCHAR* Format) const {
    FString Result;
    int32 Year, Month, Day;
    GetDate(Year, Month, Day);
    const int32 WeekDay = static_cast<int32>(GetDayOfWeek());
    for (; *Format; ++Format) {
        if (*Format != TEXT('%') || !Format[1]) {
            Result.AppendChar(*Format);
            continue;
        }
        switch (*++Format) {
        case TEXT('a'):
            Result += FString(DayNames[WeekDay]).Left(3);
            break;
        case TEXT('A'):
            Result += DayNames[WeekDay];
            break;
        case TEXT('w'):
            Result += FString::FromInt((WeekDay + 1) % 7);
            break;
        case TEXT('y'):
            Result += FString::Printf(TEXT("%02d"), Year % 100);
            break;
        case TEXT('Y'):
            Result += FString::Printf(TEXT("%04d"), Year);
            break;
        case TEXT('b'):
            Result += FString(MonthNames[Month - 1]).Left(3);
            break;
        case TEXT('B'):
            Result += MonthNames[Month - 1];
            break;
        case TEXT('m'):
            Result += FString::Printf(TEXT("%02d"), Month);
            break;
        case TEXT('d'):
            Result += FString::Printf(TEXT("%02d"), Day);
            break;
        case TEXT('e'):
            Result += FString::FromInt(Day);
            break;
        case TEXT('j'):
            Result += FString::Printf(TEXT("%03d"), GetDayOfYear());
            break;
        case TEXT('l'):
            Result += FString::FromInt(GetHour12());
            break;
        case TEXT('h'):
            Result += FString::Printf(TEXT("%02d"), GetHour12());
            break;
        case TEXT('H'):
            Result += FString::Printf(TEXT("%02d"), GetHour());
            break;
        case TEXT('I'):
            Result += FString::Printf(TEXT("%02d"), GetHour12());
            break;
        case TEXT('M'):
            Result += FString::Printf(TEXT("%02d"), GetMinute());
            break;
        case TEXT('S'):
            Result += FString::Printf(TEXT("%02d"), GetSecond());
            break;
        case TEXT('s'):
            Result += FString::Printf(TEXT("%03d"), GetMillisecond());
            break;
        case TEXT('T'):
            Result += FString::Printf(TEXT("%02d:%02d:%02d"), GetHour(), GetMinute(), GetSecond());
            break;
        case TEXT('n'):
            Result += TEXT("\n");
            break;
        default:
            Result.AppendChar(*Format);
            break;
        }
    }
    return Result;
}

bool FDateTime::Parse(const FString& DateTimeString, FDateTime& OutDateTime) {
    const TCHAR* Cursor = *DateTimeString;
    int32 Parts[6] = {};
    for (int32 Index = 0; Index < 6; ++Index) {
        if (!ReadNumber(Cursor, Parts[Index])) {
            return false;
        }
        if (Index < 5 && *Cursor) {
            ++Cursor; // '.', '-' and ':' all separate
        }
    }
    if (!Validate(Parts[0], Parts[1], Parts[2], Parts[3], Parts[4], Parts[5], 0)) {
        return false;
    }
    OutDateTime = FDateTime(Parts[0], Parts[1], Parts[2], Parts[3], Parts[4], Parts[5]);
    return true;
}

bool FDateTime::ParseIso8601(const TCHAR* DateTimeString, FDateTime& OutDateTime) {
    const TCHAR* Cursor = DateTimeString;
    int32 Year = 0, Month = 1, Day = 1, Hour = 0, Minute = 0, Second = 0, Millisecond = 0, OffsetMinutes = 0;
    if (!ReadNumber(Cursor, Year) || !SkipChar(Cursor, TEXT('-')) || !ReadNumber(Cursor, Month) ||
        !SkipChar(Cursor, TEXT('-')) || !ReadNumber(Cursor, Day)) {
        return false;
    }
    if (*Cursor == TEXT('T') || *Cursor == TEXT(' ')) {
        ++Cursor;
        if (!ReadNumber(Cursor, Hour) || !SkipChar(Cursor, TEXT(':')) || !ReadNumber(Cursor, Minute)) {
            return false;
        }
        if (SkipChar(Cursor, TEXT(':')) && !ReadNumber(Cursor, Second)) {
            return false;
        }
        if (SkipChar(Cursor, TEXT('.'))) {
            for (int32 Scale = 100; FChar::IsDigit(*Cursor); ++Cursor, Scale /= 10) {
                Millisecond += (*Cursor - TEXT('0')) * Scale;
            }
        }
        if (*Cursor == TEXT('+') || *Cursor == TEXT('-')) {
            const int32 Sign = *Cursor++ == TEXT('+') ? 1 : -1;
            int32 OffsetHours = 0, OffsetRest = 0;
            if (!ReadNumber(Cursor, OffsetHours) || (SkipChar(Cursor, TEXT(':')) && !ReadNumber(Cursor, OffsetRest))) {
                return false;
            }
            OffsetMinutes = Sign * (OffsetHours * 60 + OffsetRest);
        } else {
            SkipChar(Cursor, TEXT('Z'));
        }
    }
    if (*Cursor || !Validate(Year, Month, Day, Hour, Minute, Second, Millisecond)) {
        return false;
    }
    OutDateTime = FDateTime(Year, Month, Day, Hour, Minute, Second, Millisecond) - FTimespan(0, OffsetMinutes, 0);
    return true;
}

FDateTime FDateTime::Now() {
    timeval Time{};
    gettimeofday(&Time, nullptr);
    tm Parts{};
    localtime_r(&Time.tv_sec, &Parts);
    return FromParts(Parts, static_cast<int32>(Time.tv_usec / 1000));
}

FDateTime FDateTime::UtcNow() {
    timeval Time{};
    gettimeofday(&Time, nullptr);
    tm Parts{};
    gmtime_r(&Time.tv_sec, &Parts);
    return FromParts(Parts, static_cast<int32>(Time.tv_usec / 1000));
}

FString FTimespan::ToString() const { return ToString(GetDays() == 0 ? TEXT("%h:%m:%s.%f") : TEXT("%d.%h:%m:%s.%f")); }

FString FTimespan::ToString(const TCHAR* Format) const {
    FString Result(Ticks < 0 ? TEXT("-") : TEXT("+"));
    const FTimespan Size = GetDuration();
    for (; *Format; ++Format) {
        if (*Format != TEXT('%') || !Format[1]) {
            Result.AppendChar(*Format);
            continue;
        }
        switch (*++Format) {
        case TEXT('n'):
            Result += Ticks < 0 ? TEXT("-") : TEXT("");
            break;
        case TEXT('N'):
            Result += Ticks < 0 ? TEXT("-") : TEXT("+");
            break;
        case TEXT('d'):
            Result += FString::FromInt(Size.GetDays());
            break;
        case TEXT('h'):
            Result += FString::Printf(TEXT("%02d"), Size.GetHours());
            break;
        case TEXT('m'):
            Result += FString::Printf(TEXT("%02d"), Size.GetMinutes());
            break;
        case TEXT('s'):
            Result += FString::Printf(TEXT("%02d"), Size.GetSeconds());
            break;
        case TEXT('f'):
            Result += FString::Printf(TEXT("%03d"), Size.GetFractionMilli());
            break;
        case TEXT('u'):
            Result += FString::Printf(TEXT("%06d"), Size.GetFractionMicro());
            break;
        case TEXT('t'):
            Result += FString::Printf(TEXT("%07d"), Size.GetFractionTicks());
            break;
        case TEXT('D'):
            Result += FString::Printf(TEXT("%f"), Size.GetTotalDays());
            break;
        case TEXT('H'):
            Result += FString::Printf(TEXT("%f"), Size.GetTotalHours());
            break;
        case TEXT('M'):
            Result += FString::Printf(TEXT("%f"), Size.GetTotalMinutes());
            break;
        case TEXT('S'):
            Result += FString::Printf(TEXT("%f"), Size.GetTotalSeconds());
            break;
        case TEXT('F'):
            Result += FString::Printf(TEXT("%f"), Size.GetTotalMilliseconds());
            break;
        default:
            Result.AppendChar(*Format);
            break;
        }
    }
    return Result;
}

bool FTimespan::Parse(const FString& TimespanString, FTimespan& OutTimespan) {
    const TCHAR* Cursor = *TimespanString;
    const bool bNegative = *Cursor == TEXT('-');
    if (bNegative || *Cursor == TEXT('+')) {
        ++Cursor;
    }
    int32 Days = 0, Hours = 0, Minutes = 0, Seconds = 0;
    int64 FractionTicks = 0;
    if (!ReadNumber(Cursor, Hours)) {
        return false;
    }
    if (SkipChar(Cursor, TEXT('.'))) {
        Days = Hours;
        if (!ReadNumber(Cursor, Hours)) {
            return false;
        }
    }
    if (!SkipChar(Cursor, TEXT(':')) || !ReadNumber(Cursor, Minutes)) {
        return false;
    }
    if (SkipChar(Cursor, TEXT(':')) && !ReadNumber(Cursor, Seconds)) {
        return false;
    }
    if (SkipChar(Cursor, TEXT('.'))) {
        for (int64 Scale = ETimespan::TicksPerSecond / 10; FChar::IsDigit(*Cursor); ++Cursor, Scale /= 10) {
            FractionTicks += (*Cursor - TEXT('0')) * Scale;
        }
    }
    if (*Cursor || Hours > 23 || Minutes > 59 || Seconds > 59) {
        return false;
    }
    OutTimespan = FTimespan(Days, Hours, Minutes, Seconds) + FTimespan(FractionTicks);
    if (bNegative) {
        OutTimespan = -OutTimespan;
    }
    return true;
}
