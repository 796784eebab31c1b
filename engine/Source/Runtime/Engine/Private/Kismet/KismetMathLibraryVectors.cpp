// SPDX-License-Identifier: MIT
#include "Kismet/KismetMathLibrary.h"
#include "KismetMathLibraryPrivate.h"

#include <cmath>

using namespace KismetMathPrivate;

// Vector functions

FVector UKismetMathLibrary::Vector_Zero() { return FVector(0.0, 0.0, 0.0); }

FVector UKismetMathLibrary::Vector_One() { return FVector(1.0, 1.0, 1.0); }

FVector UKismetMathLibrary::Vector_Forward() { return FVector(1.0, 0.0, 0.0); }

FVector UKismetMathLibrary::Vector_Backward() { return FVector(-1.0, 0.0, 0.0); }

FVector UKismetMathLibrary::Vector_Up() { return FVector(0.0, 0.0, 1.0); }

FVector UKismetMathLibrary::Vector_Down() { return FVector(0.0, 0.0, -1.0); }

FVector UKismetMathLibrary::Vector_Right() { return FVector(0.0, 1.0, 0.0); }

FVector UKismetMathLibrary::Vector_Left() { return FVector(0.0, -1.0, 0.0); }

FVector UKismetMathLibrary::MakeVector(double X, double Y, double Z) { return FVector(X, Y, Z); }

FVector UKismetMathLibrary::CreateVectorFromYawPitch(float Yaw, float Pitch, float Length) {
    return FRotator(Pitch, Yaw, 0.0).Vector() * Length;
}

void UKismetMathLibrary::BreakVector(FVector InVec, double& X, double& Y, double& Z) {
    X = InVec.X;
    Y = InVec.Y;
    Z = InVec.Z;
}

bool UKismetMathLibrary::EqualExactly_VectorVector(FVector A, FVector B) { return A == B; }

bool UKismetMathLibrary::EqualEqual_VectorVector(FVector A, FVector B, float ErrorTolerance) {
    return A.Equals(B, ErrorTolerance);
}

bool UKismetMathLibrary::NotEqualExactly_VectorVector(FVector A, FVector B) { return !(A == B); }

bool UKismetMathLibrary::NotEqual_VectorVector(FVector A, FVector B, float ErrorTolerance) {
    return !A.Equals(B, ErrorTolerance);
}

FVector UKismetMathLibrary::Add_VectorVector(FVector A, FVector B) { return A + B; }

FVector UKismetMathLibrary::Add_VectorFloat(FVector A, double B) { return A + FVector(B, B, B); }

FVector UKismetMathLibrary::Add_VectorInt(FVector A, int32 B) { return A + FVector(B, B, B); }

FVector UKismetMathLibrary::Subtract_VectorVector(FVector A, FVector B) { return A - B; }

FVector UKismetMathLibrary::Subtract_VectorFloat(FVector A, double B) { return A - FVector(B, B, B); }

FVector UKismetMathLibrary::Subtract_VectorInt(FVector A, int32 B) { return A - FVector(B, B, B); }

FVector UKismetMathLibrary::Multiply_VectorVector(FVector A, FVector B) {
    return FVector(A.X * B.X, A.Y * B.Y, A.Z * B.Z);
}

FVector UKismetMathLibrary::Multiply_VectorFloat(FVector A, double B) { return A * B; }

FVector UKismetMathLibrary::Multiply_VectorInt(FVector A, int32 B) { return A * static_cast<double>(B); }

FVector UKismetMathLibrary::Divide_VectorVector(FVector A, FVector B) {
    if (B.X == 0.0 || B.Y == 0.0 || B.Z == 0.0) {
        WarnDivideByZero(TEXT("Divide_VectorVector"));
        return FVector(0.0, 0.0, 0.0);
    }
    return FVector(A.X / B.X, A.Y / B.Y, A.Z / B.Z);
}

FVector UKismetMathLibrary::Divide_VectorFloat(FVector A, double B) {
    if (B == 0.0) {
        WarnDivideByZero(TEXT("Divide_VectorFloat"));
        return FVector(0.0, 0.0, 0.0);
    }
    return FVector(A.X / B, A.Y / B, A.Z / B);
}

FVector UKismetMathLibrary::Divide_VectorInt(FVector A, int32 B) {
    if (B == 0) {
        WarnDivideByZero(TEXT("Divide_VectorInt"));
        return FVector(0.0, 0.0, 0.0);
    }
    return FVector(A.X / B, A.Y / B, A.Z / B);
}

FVector UKismetMathLibrary::NegateVector(FVector A) { return FVector(-A.X, -A.Y, -A.Z); }

double UKismetMathLibrary::Dot_VectorVector(FVector A, FVector B) { return A.X * B.X + A.Y * B.Y + A.Z * B.Z; }

FVector UKismetMathLibrary::Cross_VectorVector(FVector A, FVector B) { return FVector::CrossProduct(A, B); }

FVector UKismetMathLibrary::GreaterGreater_VectorRotator(FVector A, FRotator B) { return B.RotateVector(A); }

FVector UKismetMathLibrary::LessLess_VectorRotator(FVector A, FRotator B) { return B.UnrotateVector(A); }

FVector UKismetMathLibrary::RotateAngleAxis(FVector InVect, float AngleDeg, FVector Axis) {
    return FQuat(Axis.GetSafeNormal(), DegreesToRadians(AngleDeg)).RotateVector(InVect);
}

void UKismetMathLibrary::Vector_Set(FVector& A, double X, double Y, double Z) { A = FVector(X, Y, Z); }

void UKismetMathLibrary::Vector_Assign(FVector& A, const FVector& InVector) { A = InVector; }

double UKismetMathLibrary::VSize(FVector A) { return A.Size(); }

double UKismetMathLibrary::VSizeSquared(FVector A) { return A.SizeSquared(); }

double UKismetMathLibrary::VSizeXY(FVector A) { return std::sqrt(A.X * A.X + A.Y * A.Y); }

double UKismetMathLibrary::VSizeXYSquared(FVector A) { return A.X * A.X + A.Y * A.Y; }

double UKismetMathLibrary::Vector_Distance(FVector V1, FVector V2) { return (V2 - V1).Size(); }

double UKismetMathLibrary::Vector_DistanceSquared(FVector V1, FVector V2) { return (V2 - V1).SizeSquared(); }

double UKismetMathLibrary::Vector_Distance2D(FVector V1, FVector V2) { return VSizeXY(V2 - V1); }

double UKismetMathLibrary::Vector_Distance2DSquared(FVector V1, FVector V2) { return VSizeXYSquared(V2 - V1); }

FVector UKismetMathLibrary::Normal(FVector A, float Tolerance) { return A.GetSafeNormal(Tolerance); }

FVector UKismetMathLibrary::Vector_Normal2D(FVector A, float Tolerance) {
    return FVector(A.X, A.Y, 0.0).GetSafeNormal(Tolerance);
}

bool UKismetMathLibrary::Vector_IsZero(const FVector& A) { return A.X == 0.0 && A.Y == 0.0 && A.Z == 0.0; }

bool UKismetMathLibrary::Vector_IsNearlyZero(const FVector& A, float Tolerance) { return A.IsNearlyZero(Tolerance); }

bool UKismetMathLibrary::Vector_IsNAN(const FVector& A) {
    return std::isnan(A.X) || std::isnan(A.Y) || std::isnan(A.Z);
}

bool UKismetMathLibrary::Vector_IsUniform(const FVector& A, float Tolerance) {
    return std::fabs(A.X - A.Y) <= Tolerance && std::fabs(A.X - A.Z) <= Tolerance && std::fabs(A.Y - A.Z) <= Tolerance;
}

bool UKismetMathLibrary::Vector_IsUnit(const FVector& A, float SquaredLenthTolerance) {
    return std::fabs(1.0 - A.SizeSquared()) < SquaredLenthTolerance;
}

bool UKismetMathLibrary::Vector_IsNormal(const FVector& A) { return std::fabs(1.0 - A.SizeSquared()) < 0.01; }

FVector UKismetMathLibrary::VLerp(FVector A, FVector B, float Alpha) {
    return A + (B - A) * static_cast<double>(Alpha);
}

FVector UKismetMathLibrary::VEase(
    FVector A, FVector B, float Alpha, TEnumAsByte<EEasingFunc::Type> EasingFunc, float BlendExp, int32 Steps) {
    return A + (B - A) * EaseAlpha(Alpha, EasingFunc, BlendExp, Steps);
}

FVector UKismetMathLibrary::VInterpTo(FVector Current, FVector Target, float DeltaTime, float InterpSpeed) {
    if (InterpSpeed <= 0.0f) {
        return Target;
    }
    const FVector Distance = Target - Current;
    if (Distance.SizeSquared() < 1.e-4) {
        return Target;
    }
    return Current + Distance * FClamp(static_cast<double>(DeltaTime) * InterpSpeed, 0.0, 1.0);
}

FVector UKismetMathLibrary::VInterpTo_Constant(FVector Current, FVector Target, float DeltaTime, float InterpSpeed) {
    const FVector Delta = Target - Current;
    const double Distance = Delta.Size();
    const double Step = static_cast<double>(InterpSpeed) * DeltaTime;
    if (Distance > Step) {
        return Step > 0.0 ? Current + Delta / Distance * Step : Current;
    }
    return Target;
}

FVector UKismetMathLibrary::Vector_Reciprocal(const FVector& A) {
    constexpr double Big = 3.4e38;
    return FVector(A.X != 0.0 ? 1.0 / A.X : Big, A.Y != 0.0 ? 1.0 / A.Y : Big, A.Z != 0.0 ? 1.0 / A.Z : Big);
}

FVector UKismetMathLibrary::GetReflectionVector(FVector Direction, FVector SurfaceNormal) {
    const FVector Normal = SurfaceNormal.GetSafeNormal();
    return Direction - Normal * (2.0 * Dot_VectorVector(Direction, Normal));
}

FVector UKismetMathLibrary::MirrorVectorByNormal(FVector InVect, FVector InNormal) {
    return InVect - InNormal * (2.0 * Dot_VectorVector(InVect, InNormal));
}

FVector UKismetMathLibrary::ProjectVectorOnToVector(FVector V, FVector Target) {
    const double LengthSquared = Target.SizeSquared();
    if (LengthSquared <= 1.e-8) {
        return FVector(0.0, 0.0, 0.0);
    }
    return Target * (Dot_VectorVector(V, Target) / LengthSquared);
}

FVector UKismetMathLibrary::ProjectPointOnToPlane(FVector Point, FVector PlaneBase, FVector PlaneNormal) {
    const FVector Normal = PlaneNormal.GetSafeNormal();
    return Point - Normal * Dot_VectorVector(Point - PlaneBase, Normal);
}

FVector UKismetMathLibrary::ProjectVectorOnToPlane(FVector V, FVector PlaneNormal) {
    return V - ProjectVectorOnToVector(V, PlaneNormal);
}

FVector UKismetMathLibrary::ClampVectorSize(FVector A, double Min, double Max) {
    const double Size = A.Size();
    if (Size < 1.e-8) {
        return FVector(0.0, 0.0, 0.0);
    }
    return A * (FClamp(Size, Min, Max) / Size);
}

FVector UKismetMathLibrary::Vector_ClampSizeMax(FVector A, double Max) { return A.GetClampedToMaxSize(Max); }

double UKismetMathLibrary::GetMinElement(FVector A) { return FMin(A.X, FMin(A.Y, A.Z)); }

double UKismetMathLibrary::GetMaxElement(FVector A) { return FMax(A.X, FMax(A.Y, A.Z)); }

FVector UKismetMathLibrary::Vector_GetAbs(FVector A) { return FVector(std::fabs(A.X), std::fabs(A.Y), std::fabs(A.Z)); }

FVector UKismetMathLibrary::GetDirectionUnitVector(FVector From, FVector To) { return (To - From).GetSafeNormal(); }

void UKismetMathLibrary::GetYawPitchFromVector(FVector InVec, float& Yaw, float& Pitch) {
    const FVector Direction = InVec.GetSafeNormal();
    Yaw = static_cast<float>(RadiansToDegrees(std::atan2(Direction.Y, Direction.X)));
    Pitch = static_cast<float>(RadiansToDegrees(std::asin(FClamp(Direction.Z, -1.0, 1.0))));
}

void UKismetMathLibrary::GetAzimuthAndElevation(
    FVector InDirection, const FTransform& ReferenceFrame, float& Azimuth, float& Elevation) {
    const FVector Local = ReferenceFrame.InverseTransformVectorNoScale(InDirection).GetSafeNormal();
    Azimuth = static_cast<float>(RadiansToDegrees(std::atan2(Local.Y, Local.X)));
    Elevation = static_cast<float>(RadiansToDegrees(std::asin(FClamp(Local.Z, -1.0, 1.0))));
}

FVector UKismetMathLibrary::GetVectorArrayAverage(const TArray<FVector>& Vectors) {
    FVector Sum(0.0, 0.0, 0.0);
    for (const FVector& Vector : Vectors) {
        Sum = Sum + Vector;
    }
    return Vectors.Num() > 0 ? Sum / static_cast<double>(Vectors.Num()) : Sum;
}

double UKismetMathLibrary::GetPointDistanceToSegment(FVector Point, FVector SegmentStart, FVector SegmentEnd) {
    return (Point - FindClosestPointOnSegment(Point, SegmentStart, SegmentEnd)).Size();
}

double UKismetMathLibrary::GetPointDistanceToLine(FVector Point, FVector LineOrigin, FVector LineDirection) {
    return (Point - FindClosestPointOnLine(Point, LineOrigin, LineDirection)).Size();
}

FVector UKismetMathLibrary::FindClosestPointOnSegment(FVector Point, FVector SegmentStart, FVector SegmentEnd) {
    const FVector Segment = SegmentEnd - SegmentStart;
    const double LengthSquared = Segment.SizeSquared();
    if (LengthSquared <= 0.0) {
        return SegmentStart;
    }
    return SegmentStart + Segment * FClamp(Dot_VectorVector(Point - SegmentStart, Segment) / LengthSquared, 0.0, 1.0);
}

FVector UKismetMathLibrary::FindClosestPointOnLine(FVector Point, FVector LineOrigin, FVector LineDirection) {
    const FVector Direction = LineDirection.GetSafeNormal();
    return LineOrigin + Direction * Dot_VectorVector(Point - LineOrigin, Direction);
}

bool UKismetMathLibrary::IsPointInBox(FVector Point, FVector BoxOrigin, FVector BoxExtent) {
    return std::fabs(Point.X - BoxOrigin.X) <= BoxExtent.X && std::fabs(Point.Y - BoxOrigin.Y) <= BoxExtent.Y &&
           std::fabs(Point.Z - BoxOrigin.Z) <= BoxExtent.Z;
}

FRotator UKismetMathLibrary::FindLookAtRotation(const FVector& Start, const FVector& Target) {
    return (Target - Start).ToOrientationRotator();
}

// Vector2D functions

FVector2D UKismetMathLibrary::MakeVector2D(double X, double Y) { return FVector2D(X, Y); }

void UKismetMathLibrary::BreakVector2D(FVector2D InVec, double& X, double& Y) {
    X = InVec.X;
    Y = InVec.Y;
}

FVector2D UKismetMathLibrary::Add_Vector2DVector2D(FVector2D A, FVector2D B) { return A + B; }

FVector2D UKismetMathLibrary::Subtract_Vector2DVector2D(FVector2D A, FVector2D B) { return A - B; }

FVector2D UKismetMathLibrary::Multiply_Vector2DFloat(FVector2D A, double B) { return A * B; }

FVector2D UKismetMathLibrary::Multiply_Vector2DVector2D(FVector2D A, FVector2D B) {
    return FVector2D(A.X * B.X, A.Y * B.Y);
}

FVector2D UKismetMathLibrary::Divide_Vector2DFloat(FVector2D A, double B) {
    if (B == 0.0) {
        WarnDivideByZero(TEXT("Divide_Vector2DFloat"));
        return FVector2D(0.0, 0.0);
    }
    return FVector2D(A.X / B, A.Y / B);
}

double UKismetMathLibrary::DotProduct2D(FVector2D A, FVector2D B) { return A.X * B.X + A.Y * B.Y; }

double UKismetMathLibrary::CrossProduct2D(FVector2D A, FVector2D B) { return A.X * B.Y - A.Y * B.X; }

double UKismetMathLibrary::VSize2D(FVector2D A) { return std::sqrt(A.X * A.X + A.Y * A.Y); }

double UKismetMathLibrary::VSize2DSquared(FVector2D A) { return A.X * A.X + A.Y * A.Y; }

double UKismetMathLibrary::Distance2D(FVector2D V1, FVector2D V2) { return VSize2D(V2 - V1); }

FVector2D UKismetMathLibrary::Normal2D(FVector2D A, float Tolerance) {
    const double Size = VSize2D(A);
    return Size * Size > Tolerance ? FVector2D(A.X / Size, A.Y / Size) : FVector2D(0.0, 0.0);
}

bool UKismetMathLibrary::EqualEqual_Vector2DVector2D(FVector2D A, FVector2D B, float ErrorTolerance) {
    return std::fabs(A.X - B.X) <= ErrorTolerance && std::fabs(A.Y - B.Y) <= ErrorTolerance;
}

FVector2D UKismetMathLibrary::Vector2DInterpTo(
    FVector2D Current, FVector2D Target, float DeltaTime, float InterpSpeed) {
    if (InterpSpeed <= 0.0f) {
        return Target;
    }
    const FVector2D Distance = Target - Current;
    if (VSize2DSquared(Distance) < 1.e-4) {
        return Target;
    }
    return Current + Distance * FClamp(static_cast<double>(DeltaTime) * InterpSpeed, 0.0, 1.0);
}
