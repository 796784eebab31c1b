// SPDX-License-Identifier: MIT
#include "Kismet/KismetMathLibrary.h"
#include "KismetMathLibraryPrivate.h"

#include <cmath>

using namespace KismetMathPrivate;

// Transform functions

FTransform UKismetMathLibrary::MakeTransform(FVector Location, FRotator Rotation, FVector Scale) {
    return FTransform(Rotation, Location, Scale);
}

void UKismetMathLibrary::BreakTransform(
    const FTransform& InTransform, FVector& Location, FRotator& Rotation, FVector& Scale) {
    Location = InTransform.GetLocation();
    Rotation = InTransform.Rotator();
    Scale = InTransform.GetScale3D();
}

FTransform UKismetMathLibrary::ComposeTransforms(const FTransform& A, const FTransform& B) { return A * B; }

FVector UKismetMathLibrary::TransformLocation(const FTransform& T, FVector Location) {
    return T.TransformPosition(Location);
}

FVector UKismetMathLibrary::TransformDirection(const FTransform& T, FVector Direction) {
    return T.TransformVectorNoScale(Direction);
}

FRotator UKismetMathLibrary::TransformRotation(const FTransform& T, FRotator Rotation) {
    return T.TransformRotation(Rotation.Quaternion()).Rotator();
}

FVector UKismetMathLibrary::InverseTransformLocation(const FTransform& T, FVector Location) {
    return T.InverseTransformPosition(Location);
}

FVector UKismetMathLibrary::InverseTransformDirection(const FTransform& T, FVector Direction) {
    return T.InverseTransformVectorNoScale(Direction);
}

FRotator UKismetMathLibrary::InverseTransformRotation(const FTransform& T, FRotator Rotation) {
    return T.InverseTransformRotation(Rotation.Quaternion()).Rotator();
}

FTransform UKismetMathLibrary::MakeRelativeTransform(const FTransform& A, const FTransform& RelativeTo) {
    return A.GetRelativeTransform(RelativeTo);
}

FTransform UKismetMathLibrary::InvertTransform(const FTransform& T) { return T.Inverse(); }

FTransform UKismetMathLibrary::TLerp(
    const FTransform& A, const FTransform& B, float Alpha, TEnumAsByte<ELerpInterpolationMode::Type> InterpMode) {
    return InterpolateTransforms(A, B, Alpha, InterpMode);
}

FTransform UKismetMathLibrary::TEase(const FTransform& A, const FTransform& B, float Alpha,
    TEnumAsByte<EEasingFunc::Type> EasingFunc, float BlendExp, int32 Steps) {
    return InterpolateTransforms(
        A, B, EaseAlpha(Alpha, EasingFunc, BlendExp, Steps), ELerpInterpolationMode::QuatInterp);
}

FTransform UKismetMathLibrary::TInterpTo(
    const FTransform& Current, const FTransform& Target, float DeltaTime, float InterpSpeed) {
    if (InterpSpeed <= 0.0f) {
        return Target;
    }
    const double Alpha = FClamp(static_cast<double>(DeltaTime) * InterpSpeed, 0.0, 1.0);
    return InterpolateTransforms(Current, Target, Alpha, ELerpInterpolationMode::QuatInterp);
}

bool UKismetMathLibrary::NearlyEqual_TransformTransform(const FTransform& A, const FTransform& B,
    float LocationTolerance, float RotationTolerance, float Scale3DTolerance) {
    return A.GetLocation().Equals(B.GetLocation(), LocationTolerance) &&
           A.GetRotation().Equals(B.GetRotation(), RotationTolerance) &&
           A.GetScale3D().Equals(B.GetScale3D(), Scale3DTolerance);
}

bool UKismetMathLibrary::EqualEqual_TransformTransform(const FTransform& A, const FTransform& B) {
    return NearlyEqual_TransformTransform(A, B);
}

double UKismetMathLibrary::Transform_Determinant(const FTransform& Transform) {
    const FVector Scale = Transform.GetScale3D();
    return Scale.X * Scale.Y * Scale.Z;
}

// Box functions

FBox UKismetMathLibrary::MakeBox(FVector Min, FVector Max) { return FBox(Min, Max); }

FBox UKismetMathLibrary::MakeBoxWithOrigin(const FVector& Origin, const FVector& Extent) {
    return FBox(Origin - Extent, Origin + Extent);
}

bool UKismetMathLibrary::Box_IsPointInside(const FBox& Box, const FVector& Point) { return Box.IsInside(Point); }

bool UKismetMathLibrary::IsPointInBox_Box(FVector Point, FBox Box) { return Box.IsInsideOrOn(Point); }

bool UKismetMathLibrary::Box_Intersects(const FBox& A, const FBox& B) { return A.Intersect(B); }
