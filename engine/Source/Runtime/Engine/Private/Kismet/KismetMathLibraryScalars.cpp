// SPDX-License-Identifier: MIT
#include "Kismet/KismetMathLibrary.h"
#include "KismetMathLibraryPrivate.h"

#include <cmath>

using namespace KismetMathPrivate;

// Float (double-precision) functions

double UKismetMathLibrary::MultiplyMultiply_FloatFloat(double Base, double Exp) { return std::pow(Base, Exp); }

double UKismetMathLibrary::Multiply_DoubleDouble(double A, double B) { return A * B; }

double UKismetMathLibrary::Multiply_IntFloat(int32 A, double B) { return A * B; }

double UKismetMathLibrary::Divide_DoubleDouble(double A, double B) {
    if (B == 0.0) {
        WarnDivideByZero(TEXT("Divide_DoubleDouble"));
        return 0.0;
    }
    return A / B;
}

double UKismetMathLibrary::Percent_FloatFloat(double A, double B) {
    if (B == 0.0) {
        WarnDivideByZero(TEXT("Percent_FloatFloat"));
        return 0.0;
    }
    return std::fmod(A, B);
}

double UKismetMathLibrary::Fraction(double A) { return A - std::floor(A); }

double UKismetMathLibrary::Add_DoubleDouble(double A, double B) { return A + B; }

double UKismetMathLibrary::Subtract_DoubleDouble(double A, double B) { return A - B; }

bool UKismetMathLibrary::Less_DoubleDouble(double A, double B) { return A < B; }

bool UKismetMathLibrary::Greater_DoubleDouble(double A, double B) { return A > B; }

bool UKismetMathLibrary::LessEqual_DoubleDouble(double A, double B) { return A <= B; }

bool UKismetMathLibrary::GreaterEqual_DoubleDouble(double A, double B) { return A >= B; }

bool UKismetMathLibrary::EqualEqual_DoubleDouble(double A, double B) { return A == B; }

bool UKismetMathLibrary::NotEqual_DoubleDouble(double A, double B) { return A != B; }

bool UKismetMathLibrary::NearlyEqual_FloatFloat(double A, double B, double ErrorTolerance) {
    return std::fabs(A - B) <= ErrorTolerance;
}

bool UKismetMathLibrary::InRange_FloatFloat(
    double Value, double Min, double Max, bool InclusiveMin, bool InclusiveMax) {
    return (InclusiveMin ? Value >= Min : Value > Min) && (InclusiveMax ? Value <= Max : Value < Max);
}

double UKismetMathLibrary::Hypotenuse(double Width, double Height) {
    return std::sqrt(Width * Width + Height * Height);
}

double UKismetMathLibrary::Log(double A, double Base) {
    return Base <= 0.0 || Base == 1.0 ? 0.0 : std::log(A) / std::log(Base);
}

double UKismetMathLibrary::Loge(double A) { return std::log(A); }

double UKismetMathLibrary::Exp(double A) { return std::exp(A); }

double UKismetMathLibrary::Sqrt(double A) {
    if (A < 0.0) {
        UE_LOG(LogBlueprintMath, Warning, TEXT("Sqrt of the negative number %f: the result is 0"), A);
        return 0.0;
    }
    return std::sqrt(A);
}

double UKismetMathLibrary::Square(double A) { return A * A; }

double UKismetMathLibrary::Abs(double A) { return std::fabs(A); }

double UKismetMathLibrary::SignOfFloat(double A) { return A > 0.0 ? 1.0 : (A < 0.0 ? -1.0 : 0.0); }

double UKismetMathLibrary::NormalizeToRange(double Value, double RangeMin, double RangeMax) {
    if (RangeMin == RangeMax) {
        return Value < RangeMin ? 0.0 : 1.0;
    }
    return (Value - RangeMin) / (RangeMax - RangeMin);
}

double UKismetMathLibrary::MapRangeUnclamped(
    double Value, double InRangeA, double InRangeB, double OutRangeA, double OutRangeB) {
    return Lerp(OutRangeA, OutRangeB,
        InRangeA == InRangeB ? (Value < InRangeB ? 0.0 : 1.0) : (Value - InRangeA) / (InRangeB - InRangeA));
}

double UKismetMathLibrary::MapRangeClamped(
    double Value, double InRangeA, double InRangeB, double OutRangeA, double OutRangeB) {
    return Lerp(OutRangeA, OutRangeB,
        FClamp(InRangeA == InRangeB ? (Value < InRangeB ? 0.0 : 1.0) : (Value - InRangeA) / (InRangeB - InRangeA), 0.0,
            1.0));
}

double UKismetMathLibrary::MultiplyByPi(double Value) { return Value * UE_DOUBLE_PI; }

double UKismetMathLibrary::FInterpEaseInOut(double A, double B, double Alpha, double Exponent) {
    return Lerp(A, B, EaseInOutAlpha(Alpha, Exponent));
}

double UKismetMathLibrary::MakePulsatingValue(double InCurrentTime, float InPulsesPerSecond, float InPhase) {
    return 0.5 + 0.5 * std::sin(((0.25 + InPhase) * 2.0 + InCurrentTime * InPulsesPerSecond * 2.0) * UE_DOUBLE_PI);
}

double UKismetMathLibrary::FWrap(double Value, double Min, double Max) {
    const double Size = Max - Min;
    if (Size <= 0.0) {
        return Min;
    }
    double Result = Value;
    if (Result < Min || Result > Max) {
        Result = std::fmod(Result - Min, Size);
        Result = Min + (Result < 0.0 ? Result + Size : Result);
    }
    return Result;
}

double UKismetMathLibrary::FMin(double A, double B) { return A < B ? A : B; }

double UKismetMathLibrary::FMax(double A, double B) { return A > B ? A : B; }

double UKismetMathLibrary::FClamp(double Value, double Min, double Max) {
    return Value < Min ? Min : (Value < Max ? Value : Max);
}

void UKismetMathLibrary::MaxOfIntArray(const TArray<int32>& IntArray, int32& IndexOfMaxValue, int32& MaxValue) {
    IndexOfMaxValue = INDEX_NONE;
    MaxValue = 0;
    for (int32 Index = 0; Index < IntArray.Num(); ++Index) {
        if (IndexOfMaxValue == INDEX_NONE || IntArray[Index] > MaxValue) {
            IndexOfMaxValue = Index;
            MaxValue = IntArray[Index];
        }
    }
}

void UKismetMathLibrary::MinOfIntArray(const TArray<int32>& IntArray, int32& IndexOfMinValue, int32& MinValue) {
    IndexOfMinValue = INDEX_NONE;
    MinValue = 0;
    for (int32 Index = 0; Index < IntArray.Num(); ++Index) {
        if (IndexOfMinValue == INDEX_NONE || IntArray[Index] < MinValue) {
            IndexOfMinValue = Index;
            MinValue = IntArray[Index];
        }
    }
}

void UKismetMathLibrary::MaxOfFloatArray(const TArray<float>& FloatArray, int32& IndexOfMaxValue, float& MaxValue) {
    IndexOfMaxValue = INDEX_NONE;
    MaxValue = 0.0f;
    for (int32 Index = 0; Index < FloatArray.Num(); ++Index) {
        if (IndexOfMaxValue == INDEX_NONE || FloatArray[Index] > MaxValue) {
            IndexOfMaxValue = Index;
            MaxValue = FloatArray[Index];
        }
    }
}

void UKismetMathLibrary::MinOfFloatArray(const TArray<float>& FloatArray, int32& IndexOfMinValue, float& MinValue) {
    IndexOfMinValue = INDEX_NONE;
    MinValue = 0.0f;
    for (int32 Index = 0; Index < FloatArray.Num(); ++Index) {
        if (IndexOfMinValue == INDEX_NONE || FloatArray[Index] < MinValue) {
            IndexOfMinValue = Index;
            MinValue = FloatArray[Index];
        }
    }
}

double UKismetMathLibrary::Lerp(double A, double B, double Alpha) { return A + Alpha * (B - A); }

double UKismetMathLibrary::Ease(
    double A, double B, double Alpha, TEnumAsByte<EEasingFunc::Type> EasingFunc, double BlendExp, int32 Steps) {
    return Lerp(A, B, EaseAlpha(Alpha, EasingFunc, BlendExp, Steps));
}

int32 UKismetMathLibrary::Round(double A) { return ToInt32(std::floor(A + 0.5)); }

int32 UKismetMathLibrary::FFloor(double A) { return ToInt32(std::floor(A)); }

int32 UKismetMathLibrary::FTrunc(double A) { return ToInt32(std::trunc(A)); }

int32 UKismetMathLibrary::FCeil(double A) { return ToInt32(std::ceil(A)); }

int64 UKismetMathLibrary::Round64(double A) { return ToInt64(std::floor(A + 0.5)); }

int64 UKismetMathLibrary::FFloor64(double A) { return ToInt64(std::floor(A)); }

int64 UKismetMathLibrary::FTrunc64(double A) { return ToInt64(std::trunc(A)); }

int64 UKismetMathLibrary::FCeil64(double A) { return ToInt64(std::ceil(A)); }

int32 UKismetMathLibrary::FMod(double Dividend, double Divisor, double& Remainder) {
    if (Divisor == 0.0) {
        WarnDivideByZero(TEXT("FMod"));
        Remainder = 0.0;
        return 0;
    }
    const double Quotient = Dividend / Divisor;
    Remainder = std::fmod(Dividend, Divisor);
    return ToInt32(Quotient < 0.0 ? std::ceil(Quotient) : std::floor(Quotient));
}

double UKismetMathLibrary::SafeDivide(double A, double B) { return B == 0.0 ? 0.0 : A / B; }

double UKismetMathLibrary::FixedTurn(double InCurrent, double InDesired, double InDeltaRate) {
    if (InDeltaRate == 0.0) {
        return ClampAxis(InCurrent);
    }
    const double Difference = NormalizeAxis(InDesired - InCurrent);
    return ClampAxis(InCurrent + FClamp(Difference, -std::fabs(InDeltaRate), std::fabs(InDeltaRate)));
}

double UKismetMathLibrary::GetPI() { return UE_DOUBLE_PI; }

double UKismetMathLibrary::GetTAU() { return 2.0 * UE_DOUBLE_PI; }

// Trigonometry

double UKismetMathLibrary::Sin(double A) { return std::sin(A); }

double UKismetMathLibrary::Cos(double A) { return std::cos(A); }

double UKismetMathLibrary::Tan(double A) { return std::tan(A); }

double UKismetMathLibrary::Asin(double A) { return std::asin(FClamp(A, -1.0, 1.0)); }

double UKismetMathLibrary::Acos(double A) { return std::acos(FClamp(A, -1.0, 1.0)); }

double UKismetMathLibrary::Atan(double A) { return std::atan(A); }

double UKismetMathLibrary::Atan2(double Y, double X) { return std::atan2(Y, X); }

double UKismetMathLibrary::RadiansToDegrees(double A) { return A * (180.0 / UE_DOUBLE_PI); }

double UKismetMathLibrary::DegreesToRadians(double A) { return A * (UE_DOUBLE_PI / 180.0); }

double UKismetMathLibrary::DegSin(double A) { return std::sin(DegreesToRadians(A)); }

double UKismetMathLibrary::DegCos(double A) { return std::cos(DegreesToRadians(A)); }

double UKismetMathLibrary::DegTan(double A) { return std::tan(DegreesToRadians(A)); }

double UKismetMathLibrary::DegAsin(double A) { return RadiansToDegrees(Asin(A)); }

double UKismetMathLibrary::DegAcos(double A) { return RadiansToDegrees(Acos(A)); }

double UKismetMathLibrary::DegAtan(double A) { return RadiansToDegrees(Atan(A)); }

double UKismetMathLibrary::DegAtan2(double Y, double X) { return RadiansToDegrees(std::atan2(Y, X)); }

double UKismetMathLibrary::ClampAngle(double AngleDegrees, double MinAngleDegrees, double MaxAngleDegrees) {
    const double MaxDelta = ClampAxis(MaxAngleDegrees - MinAngleDegrees) * 0.5;
    const double RangeCentre = ClampAxis(MinAngleDegrees + MaxDelta);
    const double DeltaFromCentre = NormalizeAxis(AngleDegrees - RangeCentre);
    if (DeltaFromCentre > MaxDelta) {
        return NormalizeAxis(RangeCentre + MaxDelta);
    }
    if (DeltaFromCentre < -MaxDelta) {
        return NormalizeAxis(RangeCentre - MaxDelta);
    }
    return NormalizeAxis(AngleDegrees);
}

double UKismetMathLibrary::NormalizeAxis(double Angle) {
    double Result = ClampAxis(Angle);
    if (Result > 180.0) {
        Result -= 360.0;
    }
    return Result;
}

double UKismetMathLibrary::ClampAxis(double Angle) {
    double Result = std::fmod(Angle, 360.0);
    if (Result < 0.0) {
        Result += 360.0;
    }
    return Result;
}

// Interpolation of numbers

double UKismetMathLibrary::FInterpTo(double Current, double Target, double DeltaTime, double InterpSpeed) {
    if (InterpSpeed <= 0.0) {
        return Target;
    }
    const double Distance = Target - Current;
    if (Distance * Distance < 1.e-8) {
        return Target;
    }
    return Current + Distance * FClamp(DeltaTime * InterpSpeed, 0.0, 1.0);
}

double UKismetMathLibrary::FInterpTo_Constant(double Current, double Target, double DeltaTime, double InterpSpeed) {
    const double Distance = Target - Current;
    if (Distance * Distance < 1.e-8) {
        return Target;
    }
    const double Step = InterpSpeed * DeltaTime;
    return Current + FClamp(Distance, -Step, Step);
}
