// SPDX-License-Identifier: MIT
#include "Components/ArrowComponent.h"
#include "Components/BoxComponent.h"
#include "Components/CapsuleComponent.h"
#include "Components/ShapeComponent.h"
#include "Components/SphereComponent.h"

#include "Engine/CollisionProfile.h"

#include <cmath>

namespace {

// The scale that keeps a sphere round: the least of the three, sizes only.
float LeastScale(const FTransform& Transform) {
    const FVector Scale = Transform.GetScale3D();
    return static_cast<float>(std::fmin(std::fabs(Scale.X), std::fmin(std::fabs(Scale.Y), std::fabs(Scale.Z))));
}

} // namespace

// --------------------------------------------------------------------------------------------------------------- shape

UShapeComponent::UShapeComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    ShapeColor = FColor(223, 149, 157, 255);
    bHiddenInGame = true;
    bCastDynamicShadow = false;
    BodyInstance.SetCollisionProfileName(FName(TEXT("OverlapAllDynamic")));
}

void UShapeComponent::OnShapeChanged() {
    UpdateBounds();
    MarkRenderStateDirty();
}

// ----------------------------------------------------------------------------------------------------------------- box

UBoxComponent::UBoxComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    BoxExtent = FVector(32.0, 32.0, 32.0);
}

void UBoxComponent::SetBoxExtent(FVector InBoxExtent, bool) {
    BoxExtent = InBoxExtent;
    OnShapeChanged();
}

FVector UBoxComponent::GetScaledBoxExtent() const {
    const FVector Scale = GetComponentTransform().GetScale3D();
    return FVector(BoxExtent.X * Scale.X, BoxExtent.Y * Scale.Y, BoxExtent.Z * Scale.Z);
}

FVector UBoxComponent::GetUnscaledBoxExtent() const { return BoxExtent; }

FBoxSphereBounds UBoxComponent::CalcBounds(const FTransform& LocalToWorld) const {
    return FBoxSphereBounds(FVector(0.0, 0.0, 0.0), BoxExtent, BoxExtent.Size()).TransformBy(LocalToWorld);
}

// -------------------------------------------------------------------------------------------------------------- sphere

USphereComponent::USphereComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    SphereRadius = 32.0f;
    ShapeColor = FColor(255, 0, 0, 255);
}

void USphereComponent::SetSphereRadius(float InSphereRadius, bool) {
    SphereRadius = InSphereRadius;
    OnShapeChanged();
}

float USphereComponent::GetScaledSphereRadius() const { return SphereRadius * GetShapeScale(); }

float USphereComponent::GetUnscaledSphereRadius() const { return SphereRadius; }

float USphereComponent::GetShapeScale() const { return LeastScale(GetComponentTransform()); }

FBoxSphereBounds USphereComponent::CalcBounds(const FTransform& LocalToWorld) const {
    const double Radius = SphereRadius * LeastScale(LocalToWorld);
    return FBoxSphereBounds(LocalToWorld.GetLocation(), FVector(Radius, Radius, Radius), Radius);
}

// ------------------------------------------------------------------------------------------------------------- capsule

UCapsuleComponent::UCapsuleComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    CapsuleRadius = 22.0f;
    CapsuleHalfHeight = 44.0f;
}

void UCapsuleComponent::InitCapsuleSize(float InRadius, float InHalfHeight) {
    CapsuleRadius = FMath::Max(0.0f, InRadius);
    CapsuleHalfHeight = FMath::Max(CapsuleRadius, InHalfHeight);
}

void UCapsuleComponent::SetCapsuleSize(float InRadius, float InHalfHeight, bool) {
    InitCapsuleSize(InRadius, InHalfHeight);
    OnShapeChanged();
}

void UCapsuleComponent::SetCapsuleRadius(float Radius, bool bUpdateOverlaps) {
    SetCapsuleSize(Radius, CapsuleHalfHeight, bUpdateOverlaps);
}

void UCapsuleComponent::SetCapsuleHalfHeight(float HalfHeight, bool bUpdateOverlaps) {
    SetCapsuleSize(CapsuleRadius, HalfHeight, bUpdateOverlaps);
}

float UCapsuleComponent::GetScaledCapsuleRadius() const { return CapsuleRadius * GetShapeScale(); }

float UCapsuleComponent::GetScaledCapsuleHalfHeight() const { return CapsuleHalfHeight * GetShapeScale(); }

float UCapsuleComponent::GetScaledCapsuleHalfHeight_WithoutHemisphere() const {
    return (CapsuleHalfHeight - CapsuleRadius) * GetShapeScale();
}

void UCapsuleComponent::GetScaledCapsuleSize(float& OutRadius, float& OutHalfHeight) const {
    OutRadius = GetScaledCapsuleRadius();
    OutHalfHeight = GetScaledCapsuleHalfHeight();
}

float UCapsuleComponent::GetUnscaledCapsuleRadius() const { return CapsuleRadius; }

float UCapsuleComponent::GetUnscaledCapsuleHalfHeight() const { return CapsuleHalfHeight; }

float UCapsuleComponent::GetUnscaledCapsuleHalfHeight_WithoutHemisphere() const {
    return CapsuleHalfHeight - CapsuleRadius;
}

void UCapsuleComponent::GetUnscaledCapsuleSize(float& OutRadius, float& OutHalfHeight) const {
    OutRadius = CapsuleRadius;
    OutHalfHeight = CapsuleHalfHeight;
}

float UCapsuleComponent::GetShapeScale() const { return LeastScale(GetComponentTransform()); }

FBoxSphereBounds UCapsuleComponent::CalcBounds(const FTransform& LocalToWorld) const {
    const double Scale = LeastScale(LocalToWorld);
    const double Radius = CapsuleRadius * Scale;
    const double HalfHeight = CapsuleHalfHeight * Scale;
    // The axis of the capsule may point anywhere: the box holds both caps.
    const FVector Axis = LocalToWorld.GetRotation().RotateVector(FVector(0.0, 0.0, HalfHeight - Radius));
    const FVector Extent(std::fabs(Axis.X) + Radius, std::fabs(Axis.Y) + Radius, std::fabs(Axis.Z) + Radius);
    return FBoxSphereBounds(LocalToWorld.GetLocation(), Extent, HalfHeight);
}

// --------------------------------------------------------------------------------------------------------------- arrow

UArrowComponent::UArrowComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    ArrowColor = FColor(255, 0, 0, 255);
    ArrowSize = 1.0f;
    ArrowLength = 80.0f;
    bHiddenInGame = true;
    BodyInstance.SetCollisionProfileName(UCollisionProfile::NoCollision_ProfileName);
    SetGenerateOverlapEvents(false);
}

void UArrowComponent::SetArrowColor(FLinearColor NewColor) {
    ArrowColor = NewColor.ToFColor(true);
    MarkRenderStateDirty();
}

void UArrowComponent::SetArrowSize(float NewSize) {
    ArrowSize = NewSize;
    UpdateBounds();
    MarkRenderStateDirty();
}

void UArrowComponent::SetArrowLength(float NewLength) {
    ArrowLength = NewLength;
    UpdateBounds();
    MarkRenderStateDirty();
}

FBoxSphereBounds UArrowComponent::CalcBounds(const FTransform& LocalToWorld) const {
    // The head is an eighth of the length wide.
    const double Length = static_cast<double>(ArrowSize) * ArrowLength;
    return FBoxSphereBounds(
        FBox(FVector(0.0, -Length / 8.0, -Length / 8.0), FVector(Length, Length / 8.0, Length / 8.0)))
        .TransformBy(LocalToWorld);
}
