// SPDX-License-Identifier: MIT
#include "Kismet/KismetMathLibrary.h"
#include "KismetMathLibraryPrivate.h"

#include <cmath>

using namespace KismetMathPrivate;

// Rotator functions

FRotator UKismetMathLibrary::MakeRotator(float Roll, float Pitch, float Yaw) { return FRotator(Pitch, Yaw, Roll); }

void UKismetMathLibrary::BreakRotator(FRotator InRot, float& Roll, float& Pitch, float& Yaw) {
    Roll = static_cast<float>(InRot.Roll);
    Pitch = static_cast<float>(InRot.Pitch);
    Yaw = static_cast<float>(InRot.Yaw);
}

void UKismetMathLibrary::BreakRotIntoAxes(const FRotator& InRot, FVector& X, FVector& Y, FVector& Z) {
    const FQuat Rotation = InRot.Quaternion();
    X = Rotation.RotateVector(FVector(1.0, 0.0, 0.0));
    Y = Rotation.RotateVector(FVector(0.0, 1.0, 0.0));
    Z = Rotation.RotateVector(FVector(0.0, 0.0, 1.0));
}

FRotator UKismetMathLibrary::MakeRotFromX(const FVector& X) { return FRotationMatrix::MakeFromX(X).Rotator(); }

FRotator UKismetMathLibrary::MakeRotFromY(const FVector& Y) { return FRotationMatrix::MakeFromY(Y).Rotator(); }

FRotator UKismetMathLibrary::MakeRotFromZ(const FVector& Z) { return FRotationMatrix::MakeFromZ(Z).Rotator(); }

FRotator UKismetMathLibrary::MakeRotFromXY(const FVector& X, const FVector& Y) {
    return FRotationMatrix::MakeFromXY(X, Y).Rotator();
}

FRotator UKismetMathLibrary::MakeRotFromXZ(const FVector& X, const FVector& Z) {
    return FRotationMatrix::MakeFromXZ(X, Z).Rotator();
}

FRotator UKismetMathLibrary::MakeRotationFromAxes(FVector Forward, FVector Right, FVector Up) {
    Forward.Normalize();
    Right.Normalize();
    Up.Normalize();
    return FMatrix(Forward, Right, Up, FVector(0.0, 0.0, 0.0)).Rotator();
}

bool UKismetMathLibrary::EqualEqual_RotatorRotator(FRotator A, FRotator B, float ErrorTolerance) {
    return A.Equals(B, ErrorTolerance);
}

bool UKismetMathLibrary::NotEqual_RotatorRotator(FRotator A, FRotator B, float ErrorTolerance) {
    return !A.Equals(B, ErrorTolerance);
}

FRotator UKismetMathLibrary::Multiply_RotatorFloat(FRotator A, float B) {
    return FRotator(A.Pitch * B, A.Yaw * B, A.Roll * B);
}

FRotator UKismetMathLibrary::Multiply_RotatorInt(FRotator A, int32 B) {
    return FRotator(A.Pitch * B, A.Yaw * B, A.Roll * B);
}

FRotator UKismetMathLibrary::ComposeRotators(FRotator A, FRotator B) {
    return (B.Quaternion() * A.Quaternion()).Rotator();
}

FRotator UKismetMathLibrary::NegateRotator(FRotator A) { return A.Quaternion().Inverse().Rotator(); }

FVector UKismetMathLibrary::GetForwardVector(FRotator InRot) {
    return InRot.Quaternion().RotateVector(FVector(1.0, 0.0, 0.0));
}

FVector UKismetMathLibrary::GetRightVector(FRotator InRot) {
    return InRot.Quaternion().RotateVector(FVector(0.0, 1.0, 0.0));
}

FVector UKismetMathLibrary::GetUpVector(FRotator InRot) {
    return InRot.Quaternion().RotateVector(FVector(0.0, 0.0, 1.0));
}

FRotator UKismetMathLibrary::RLerp(FRotator A, FRotator B, float Alpha, bool bShortestPath) {
    if (bShortestPath) {
        return FQuat::Slerp(A.Quaternion(), B.Quaternion(), Alpha).Rotator();
    }
    return FRotator(
        A.Pitch + Alpha * (B.Pitch - A.Pitch), A.Yaw + Alpha * (B.Yaw - A.Yaw), A.Roll + Alpha * (B.Roll - A.Roll));
}

FRotator UKismetMathLibrary::REase(FRotator A, FRotator B, float Alpha, bool bShortestPath,
    TEnumAsByte<EEasingFunc::Type> EasingFunc, float BlendExp, int32 Steps) {
    return RLerp(A, B, static_cast<float>(EaseAlpha(Alpha, EasingFunc, BlendExp, Steps)), bShortestPath);
}

FRotator UKismetMathLibrary::NormalizedDeltaRotator(FRotator A, FRotator B) {
    return FRotator(NormalizeAxis(A.Pitch - B.Pitch), NormalizeAxis(A.Yaw - B.Yaw), NormalizeAxis(A.Roll - B.Roll));
}

FRotator UKismetMathLibrary::RotatorFromAxisAndAngle(FVector Axis, float Angle) {
    return FQuat(Axis.GetSafeNormal(), DegreesToRadians(Angle)).Rotator();
}

FRotator UKismetMathLibrary::RInterpTo(FRotator Current, FRotator Target, float DeltaTime, float InterpSpeed) {
    if (DeltaTime == 0.0f || Current == Target) {
        return Current;
    }
    if (InterpSpeed <= 0.0f) {
        return Target;
    }
    const FRotator Delta = NormalizedDeltaRotator(Target, Current);
    if (std::fabs(Delta.Pitch) < 1.e-4 && std::fabs(Delta.Yaw) < 1.e-4 && std::fabs(Delta.Roll) < 1.e-4) {
        return Target;
    }
    const double Alpha = FClamp(static_cast<double>(DeltaTime) * InterpSpeed, 0.0, 1.0);
    return FRotator(NormalizeAxis(Current.Pitch + Delta.Pitch * Alpha), NormalizeAxis(Current.Yaw + Delta.Yaw * Alpha),
        NormalizeAxis(Current.Roll + Delta.Roll * Alpha));
}

FRotator UKismetMathLibrary::RInterpTo_Constant(FRotator Current, FRotator Target, float DeltaTime, float InterpSpeed) {
    if (DeltaTime == 0.0f || Current == Target) {
        return Current;
    }
    if (InterpSpeed <= 0.0f) {
        return Target;
    }
    const double Step = static_cast<double>(InterpSpeed) * DeltaTime;
    const FRotator Delta = NormalizedDeltaRotator(Target, Current);
    return FRotator(NormalizeAxis(Current.Pitch + FClamp(Delta.Pitch, -Step, Step)),
        NormalizeAxis(Current.Yaw + FClamp(Delta.Yaw, -Step, Step)),
        NormalizeAxis(Current.Roll + FClamp(Delta.Roll, -Step, Step)));
}

FRotator UKismetMathLibrary::RandomRotator(bool bRoll) {
    return FRotator(FMath::FRand() * 360.0, FMath::FRand() * 360.0, bRoll ? FMath::FRand() * 360.0 : 0.0);
}

// Quaternion functions

FQuat UKismetMathLibrary::Quat_Identity() { return FQuat(0.0, 0.0, 0.0, 1.0); }

bool UKismetMathLibrary::EqualEqual_QuatQuat(const FQuat& A, const FQuat& B, float Tolerance) {
    return A.Equals(B, Tolerance);
}

bool UKismetMathLibrary::NotEqual_QuatQuat(const FQuat& A, const FQuat& B, float ErrorTolerance) {
    return !A.Equals(B, ErrorTolerance);
}

FQuat UKismetMathLibrary::Add_QuatQuat(const FQuat& A, const FQuat& B) {
    return FQuat(A.X + B.X, A.Y + B.Y, A.Z + B.Z, A.W + B.W);
}

FQuat UKismetMathLibrary::Subtract_QuatQuat(const FQuat& A, const FQuat& B) {
    return FQuat(A.X - B.X, A.Y - B.Y, A.Z - B.Z, A.W - B.W);
}

FQuat UKismetMathLibrary::Multiply_QuatQuat(const FQuat& A, const FQuat& B) { return A * B; }

bool UKismetMathLibrary::Quat_IsIdentity(const FQuat& Q, float Tolerance) {
    return Q.Equals(FQuat(0.0, 0.0, 0.0, 1.0), Tolerance);
}

bool UKismetMathLibrary::Quat_IsNormalized(const FQuat& Q) { return std::fabs(1.0 - Quat_SizeSquared(Q)) < 0.01; }

bool UKismetMathLibrary::Quat_IsFinite(const FQuat& Q) {
    return std::isfinite(Q.X) && std::isfinite(Q.Y) && std::isfinite(Q.Z) && std::isfinite(Q.W);
}

double UKismetMathLibrary::Quat_AngularDistance(const FQuat& A, const FQuat& B) {
    const double Inner = A.X * B.X + A.Y * B.Y + A.Z * B.Z + A.W * B.W;
    return std::acos(FClamp(2.0 * Inner * Inner - 1.0, -1.0, 1.0));
}

double UKismetMathLibrary::Quat_SizeSquared(const FQuat& Q) { return Q.X * Q.X + Q.Y * Q.Y + Q.Z * Q.Z + Q.W * Q.W; }

double UKismetMathLibrary::Quat_Size(const FQuat& Q) { return std::sqrt(Quat_SizeSquared(Q)); }

double UKismetMathLibrary::Quat_GetAngle(const FQuat& Q) { return 2.0 * std::acos(FClamp(Q.W, -1.0, 1.0)); }

FVector UKismetMathLibrary::Quat_GetRotationAxis(const FQuat& Q) {
    return FVector(Q.X, Q.Y, Q.Z).SizeSquared() > 1.e-16 ? FVector(Q.X, Q.Y, Q.Z).GetSafeNormal(1.e-16)
                                                         : FVector(1.0, 0.0, 0.0);
}

FVector UKismetMathLibrary::Quat_GetAxisX(const FQuat& Q) { return Q.RotateVector(FVector(1.0, 0.0, 0.0)); }

FVector UKismetMathLibrary::Quat_GetAxisY(const FQuat& Q) { return Q.RotateVector(FVector(0.0, 1.0, 0.0)); }

FVector UKismetMathLibrary::Quat_GetAxisZ(const FQuat& Q) { return Q.RotateVector(FVector(0.0, 0.0, 1.0)); }

FVector UKismetMathLibrary::Quat_VectorForward(const FQuat& Q) { return Q.RotateVector(FVector(1.0, 0.0, 0.0)); }

FVector UKismetMathLibrary::Quat_VectorRight(const FQuat& Q) { return Q.RotateVector(FVector(0.0, 1.0, 0.0)); }

FVector UKismetMathLibrary::Quat_VectorUp(const FQuat& Q) { return Q.RotateVector(FVector(0.0, 0.0, 1.0)); }

FQuat UKismetMathLibrary::Quat_Inversed(const FQuat& Q) { return Q.Inverse(); }

FQuat UKismetMathLibrary::Quat_Normalized(const FQuat& Q, float Tolerance) {
    FQuat Result = Q;
    Result.Normalize(Tolerance);
    return Result;
}

FVector UKismetMathLibrary::Quat_RotateVector(const FQuat& Q, const FVector& V) { return Q.RotateVector(V); }

FVector UKismetMathLibrary::Quat_UnrotateVector(const FQuat& Q, const FVector& V) { return Q.UnrotateVector(V); }

FRotator UKismetMathLibrary::Quat_Rotator(const FQuat& Q) { return Q.Rotator(); }

FQuat UKismetMathLibrary::Quat_MakeFromEuler(const FVector& Euler) {
    return FRotator(Euler.Y, Euler.Z, Euler.X).Quaternion();
}

FVector UKismetMathLibrary::Quat_Euler(const FQuat& Q) {
    const FRotator Rotator = Q.Rotator();
    return FVector(Rotator.Roll, Rotator.Pitch, Rotator.Yaw);
}

FQuat UKismetMathLibrary::Quat_Slerp(const FQuat& A, const FQuat& B, double Alpha) { return FQuat::Slerp(A, B, Alpha); }
