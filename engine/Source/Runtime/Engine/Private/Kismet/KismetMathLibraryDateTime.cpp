// SPDX-License-Identifier: MIT
#include "Kismet/KismetMathLibrary.h"
#include "KismetMathLibraryPrivate.h"

#include <cmath>

using namespace KismetMathPrivate;

// Date and time functions

FDateTime UKismetMathLibrary::MakeDateTime(
    int32 Year, int32 Month, int32 Day, int32 Hour, int32 Minute, int32 Second, int32 Millisecond) {
    if (!FDateTime::Validate(Year, Month, Day, Hour, Minute, Second, Millisecond)) {
        UE_LOG(LogBlueprintMath, Warning, TEXT("MakeDateTime: %d-%d-%d %d:%d:%d.%d is no date and time"), Year, Month,
            Day, Hour, Minute, Second, Millisecond);
        return FDateTime(0);
    }
    return FDateTime(Year, Month, Day, Hour, Minute, Second, Millisecond);
}

void UKismetMathLibrary::BreakDateTime(FDateTime InDateTime, int32& Year, int32& Month, int32& Day, int32& Hour,
    int32& Minute, int32& Second, int32& Millisecond) {
    InDateTime.GetDate(Year, Month, Day);
    Hour = InDateTime.GetHour();
    Minute = InDateTime.GetMinute();
    Second = InDateTime.GetSecond();
    Millisecond = InDateTime.GetMillisecond();
}

FDateTime UKismetMathLibrary::Add_DateTimeTimespan(FDateTime A, FTimespan B) { return A + B; }

FDateTime UKismetMathLibrary::Subtract_DateTimeTimespan(FDateTime A, FTimespan B) { return A - B; }

FTimespan UKismetMathLibrary::Subtract_DateTimeDateTime(FDateTime A, FDateTime B) { return A - B; }

bool UKismetMathLibrary::EqualEqual_DateTimeDateTime(FDateTime A, FDateTime B) { return A == B; }

bool UKismetMathLibrary::NotEqual_DateTimeDateTime(FDateTime A, FDateTime B) { return A != B; }

bool UKismetMathLibrary::Greater_DateTimeDateTime(FDateTime A, FDateTime B) { return A > B; }

bool UKismetMathLibrary::GreaterEqual_DateTimeDateTime(FDateTime A, FDateTime B) { return A >= B; }

bool UKismetMathLibrary::Less_DateTimeDateTime(FDateTime A, FDateTime B) { return A < B; }

bool UKismetMathLibrary::LessEqual_DateTimeDateTime(FDateTime A, FDateTime B) { return A <= B; }

int32 UKismetMathLibrary::GetDay(FDateTime A) { return A.GetDay(); }

int32 UKismetMathLibrary::GetDayOfYear(FDateTime A) { return A.GetDayOfYear(); }

int32 UKismetMathLibrary::GetHour(FDateTime A) { return A.GetHour(); }

int32 UKismetMathLibrary::GetHour12(FDateTime A) { return A.GetHour12(); }

int32 UKismetMathLibrary::GetMillisecond(FDateTime A) { return A.GetMillisecond(); }

int32 UKismetMathLibrary::GetMinute(FDateTime A) { return A.GetMinute(); }

int32 UKismetMathLibrary::GetMonth(FDateTime A) { return A.GetMonth(); }

int32 UKismetMathLibrary::GetSecond(FDateTime A) { return A.GetSecond(); }

int32 UKismetMathLibrary::GetYear(FDateTime A) { return A.GetYear(); }

FDateTime UKismetMathLibrary::GetDate(FDateTime A) { return A.GetDate(); }

FTimespan UKismetMathLibrary::GetTimeOfDay(FDateTime A) { return A.GetTimeOfDay(); }

bool UKismetMathLibrary::IsLeapYear(int32 Year) { return FDateTime::IsLeapYear(Year); }

int32 UKismetMathLibrary::DaysInMonth(int32 Year, int32 Month) {
    if (Month < 1 || Month > 12) {
        UE_LOG(LogBlueprintMath, Warning, TEXT("DaysInMonth: %d is no month (1 to 12)"), Month);
        return 0;
    }
    return FDateTime::DaysInMonth(Year, Month);
}

int32 UKismetMathLibrary::DaysInYear(int32 Year) { return FDateTime::DaysInYear(Year); }

FDateTime UKismetMathLibrary::Now() { return FDateTime::Now(); }

FDateTime UKismetMathLibrary::Today() { return FDateTime::Today(); }

FDateTime UKismetMathLibrary::UtcNow() { return FDateTime::UtcNow(); }

FDateTime UKismetMathLibrary::FromUnixTimestamp(const int64 UnixTime) { return FDateTime::FromUnixTimestamp(UnixTime); }

int64 UKismetMathLibrary::ToUnixTimestamp(const FDateTime& Time) { return Time.ToUnixTimestamp(); }

// Timespan functions

FTimespan UKismetMathLibrary::MakeTimespan(int32 Days, int32 Hours, int32 Minutes, int32 Seconds, int32 Milliseconds) {
    return FTimespan(Days, Hours, Minutes, Seconds, Milliseconds * 1000000);
}

void UKismetMathLibrary::BreakTimespan(
    FTimespan InTimespan, int32& Days, int32& Hours, int32& Minutes, int32& Seconds, int32& Milliseconds) {
    Days = InTimespan.GetDays();
    Hours = InTimespan.GetHours();
    Minutes = InTimespan.GetMinutes();
    Seconds = InTimespan.GetSeconds();
    Milliseconds = InTimespan.GetFractionMilli();
}

FTimespan UKismetMathLibrary::Add_TimespanTimespan(FTimespan A, FTimespan B) { return A + B; }

FTimespan UKismetMathLibrary::Subtract_TimespanTimespan(FTimespan A, FTimespan B) { return A - B; }

FTimespan UKismetMathLibrary::Multiply_TimespanFloat(FTimespan A, float Scalar) { return A * Scalar; }

bool UKismetMathLibrary::EqualEqual_TimespanTimespan(FTimespan A, FTimespan B) { return A == B; }

bool UKismetMathLibrary::NotEqual_TimespanTimespan(FTimespan A, FTimespan B) { return A != B; }

bool UKismetMathLibrary::Greater_TimespanTimespan(FTimespan A, FTimespan B) { return A > B; }

bool UKismetMathLibrary::GreaterEqual_TimespanTimespan(FTimespan A, FTimespan B) { return A >= B; }

bool UKismetMathLibrary::Less_TimespanTimespan(FTimespan A, FTimespan B) { return A < B; }

bool UKismetMathLibrary::LessEqual_TimespanTimespan(FTimespan A, FTimespan B) { return A <= B; }

double UKismetMathLibrary::GetTotalDays(FTimespan A) { return A.GetTotalDays(); }

double UKismetMathLibrary::GetTotalHours(FTimespan A) { return A.GetTotalHours(); }

double UKismetMathLibrary::GetTotalMilliseconds(FTimespan A) { return A.GetTotalMilliseconds(); }

double UKismetMathLibrary::GetTotalMinutes(FTimespan A) { return A.GetTotalMinutes(); }

double UKismetMathLibrary::GetTotalSeconds(FTimespan A) { return A.GetTotalSeconds(); }

int32 UKismetMathLibrary::GetDays(FTimespan A) { return A.GetDays(); }

int32 UKismetMathLibrary::GetHours(FTimespan A) { return A.GetHours(); }

int32 UKismetMathLibrary::GetMinutes(FTimespan A) { return A.GetMinutes(); }

int32 UKismetMathLibrary::GetSeconds(FTimespan A) { return A.GetSeconds(); }

int32 UKismetMathLibrary::GetMilliseconds(FTimespan A) { return A.GetFractionMilli(); }

FTimespan UKismetMathLibrary::GetDuration(FTimespan A) { return A.GetDuration(); }

FTimespan UKismetMathLibrary::FromDays(double Days) { return FTimespan::FromDays(Days); }

FTimespan UKismetMathLibrary::FromHours(double Hours) { return FTimespan::FromHours(Hours); }

FTimespan UKismetMathLibrary::FromMinutes(double Minutes) { return FTimespan::FromMinutes(Minutes); }

FTimespan UKismetMathLibrary::FromSeconds(double Seconds) { return FTimespan::FromSeconds(Seconds); }

FTimespan UKismetMathLibrary::FromMilliseconds(double Milliseconds) {
    return FTimespan::FromMilliseconds(Milliseconds);
}

FTimespan UKismetMathLibrary::TimespanZeroValue() { return FTimespan::Zero(); }

float UKismetMathLibrary::TimespanRatio(FTimespan A, FTimespan B) {
    return B.GetTicks() == 0
               ? 0.0f
               : static_cast<float>(static_cast<double>(A.GetTicks()) / static_cast<double>(B.GetTicks()));
}
