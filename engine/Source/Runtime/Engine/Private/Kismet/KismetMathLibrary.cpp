// SPDX-License-Identifier: MIT
#include "Kismet/KismetMathLibrary.h"
#include "KismetMathLibraryPrivate.h"

#include <cmath>

DEFINE_LOG_CATEGORY(LogBlueprintMath);

namespace KismetMathPrivate {

void WarnDivideByZero(const TCHAR* Function) {
    UE_LOG(LogBlueprintMath, Warning, TEXT("Divide by zero in %s: the result is 0"), Function);
}

int32 ToInt32(double Value) {
    if (std::isnan(Value)) {
        return 0;
    }
    return Value >= 2147483647.0 ? 2147483647 : (Value <= -2147483648.0 ? INT32_MIN : static_cast<int32>(Value));
}

int64 ToInt64(double Value) {
    if (std::isnan(Value)) {
        return 0;
    }
    // The largest double below 2^63 is representable as int64, 2^63 itself is not.
    return Value >= 9223372036854775808.0 ? INT64_MAX
                                          : (Value <= -9223372036854775808.0 ? INT64_MIN : static_cast<int64>(Value));
}

namespace {

double EaseIn(double Alpha, double Exponent) { return std::pow(Alpha, Exponent); }

double EaseOut(double Alpha, double Exponent) { return 1.0 - std::pow(1.0 - Alpha, Exponent); }

double SinusoidalIn(double Alpha) { return 1.0 - std::cos(Alpha * UE_DOUBLE_PI * 0.5); }

double SinusoidalOut(double Alpha) { return std::sin(Alpha * UE_DOUBLE_PI * 0.5); }

double ExpoIn(double Alpha) { return Alpha == 0.0 ? 0.0 : std::pow(2.0, 10.0 * (Alpha - 1.0)); }

double ExpoOut(double Alpha) { return Alpha == 1.0 ? 1.0 : 1.0 - std::pow(2.0, -10.0 * Alpha); }

double CircularIn(double Alpha) { return 1.0 - std::sqrt(std::fmax(0.0, 1.0 - Alpha * Alpha)); }

double CircularOut(double Alpha) { return std::sqrt(std::fmax(0.0, 1.0 - (Alpha - 1.0) * (Alpha - 1.0))); }

double Step(double Alpha, int32 Steps) {
    if (Steps <= 1 || Alpha <= 0.0) {
        return 0.0;
    }
    if (Alpha >= 1.0) {
        return 1.0;
    }
    return std::floor(Alpha * Steps) / (Steps - 1);
}

// One function up to the middle, its counterpart from there.
template <typename FirstType, typename SecondType>
double Halves(double Alpha, FirstType First, SecondType Second) {
    return Alpha < 0.5 ? First(Alpha * 2.0) * 0.5 : Second(Alpha * 2.0 - 1.0) * 0.5 + 0.5;
}

FQuat Scaled(const FQuat& Q, double Factor) { return FQuat(Q.X * Factor, Q.Y * Factor, Q.Z * Factor, Q.W * Factor); }

FQuat Sum(const FQuat& A, const FQuat& B) { return FQuat(A.X + B.X, A.Y + B.Y, A.Z + B.Z, A.W + B.W); }

// A rigid transform as a dual quaternion: the dual part is half the translation times the rotation.
FQuat DualPart(const FQuat& Rotation, const FVector& Translation) {
    return Scaled(FQuat(Translation.X, Translation.Y, Translation.Z, 0.0) * Rotation, 0.5);
}

FTransform BlendDualQuaternions(const FTransform& A, const FTransform& B, double Alpha, const FVector& Scale) {
    const FQuat RotationA = A.GetRotation();
    const FQuat RotationB = B.GetRotation();
    const double Dot =
        RotationA.X * RotationB.X + RotationA.Y * RotationB.Y + RotationA.Z * RotationB.Z + RotationA.W * RotationB.W;
    const double WeightB = Dot < 0.0 ? -Alpha : Alpha;
    FQuat Real = Sum(Scaled(RotationA, 1.0 - Alpha), Scaled(RotationB, WeightB));
    FQuat Dual = Sum(Scaled(DualPart(RotationA, A.GetLocation()), 1.0 - Alpha),
        Scaled(DualPart(RotationB, B.GetLocation()), WeightB));
    const double Length = std::sqrt(Real.X * Real.X + Real.Y * Real.Y + Real.Z * Real.Z + Real.W * Real.W);
    Real = Scaled(Real, 1.0 / Length);
    Dual = Scaled(Dual, 1.0 / Length);
    const FQuat Translation = Scaled(Dual * FQuat(-Real.X, -Real.Y, -Real.Z, Real.W), 2.0);
    return FTransform(Real, FVector(Translation.X, Translation.Y, Translation.Z), Scale);
}

} // namespace

double EaseInOutAlpha(double Alpha, double Exponent) {
    return Halves(
        Alpha, [Exponent](double Part) { return EaseIn(Part, Exponent); },
        [Exponent](double Part) { return EaseOut(Part, Exponent); });
}

double EaseAlpha(double Alpha, EEasingFunc::Type Function, double Exponent, int32 Steps) {
    switch (Function) {
    case EEasingFunc::Linear:
        return Alpha;
    case EEasingFunc::Step:
        return Step(Alpha, Steps);
    case EEasingFunc::SinusoidalIn:
        return SinusoidalIn(Alpha);
    case EEasingFunc::SinusoidalOut:
        return SinusoidalOut(Alpha);
    case EEasingFunc::SinusoidalInOut:
        return Halves(Alpha, SinusoidalIn, SinusoidalOut);
    case EEasingFunc::EaseIn:
        return EaseIn(Alpha, Exponent);
    case EEasingFunc::EaseOut:
        return EaseOut(Alpha, Exponent);
    case EEasingFunc::EaseInOut:
        return EaseInOutAlpha(Alpha, Exponent);
    case EEasingFunc::ExpoIn:
        return ExpoIn(Alpha);
    case EEasingFunc::ExpoOut:
        return ExpoOut(Alpha);
    case EEasingFunc::ExpoInOut:
        return Halves(Alpha, ExpoIn, ExpoOut);
    case EEasingFunc::CircularIn:
        return CircularIn(Alpha);
    case EEasingFunc::CircularOut:
        return CircularOut(Alpha);
    case EEasingFunc::CircularInOut:
        return Halves(Alpha, CircularIn, CircularOut);
    default:
        return Alpha;
    }
}

FTransform InterpolateTransforms(
    const FTransform& A, const FTransform& B, double Alpha, ELerpInterpolationMode::Type Mode) {
    const FVector Location = A.GetLocation() + (B.GetLocation() - A.GetLocation()) * Alpha;
    const FVector Scale = A.GetScale3D() + (B.GetScale3D() - A.GetScale3D()) * Alpha;
    switch (Mode) {
    case ELerpInterpolationMode::EulerInterp: {
        const FRotator From = A.Rotator();
        const FRotator To = B.Rotator();
        const FRotator Delta = UKismetMathLibrary::NormalizedDeltaRotator(To, From);
        return FTransform(
            FRotator(From.Pitch + Delta.Pitch * Alpha, From.Yaw + Delta.Yaw * Alpha, From.Roll + Delta.Roll * Alpha),
            Location, Scale);
    }
    case ELerpInterpolationMode::DualQuatInterp:
        return BlendDualQuaternions(A, B, Alpha, Scale);
    default:
        return FTransform(FQuat::Slerp(A.GetRotation(), B.GetRotation(), Alpha), Location, Scale);
    }
}

} // namespace KismetMathPrivate
