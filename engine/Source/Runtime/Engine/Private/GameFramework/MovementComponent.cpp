// SPDX-License-Identifier: MIT
#include "GameFramework/MovementComponent.h"

#include "Components/PrimitiveComponent.h"
#include "Engine/World.h"
#include "GameFramework/Actor.h"

UMovementComponent::UMovementComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    PrimaryComponentTick.TickGroup = TG_PrePhysics;
    PrimaryComponentTick.bCanEverTick = true;
    bWantsInitializeComponent = true;
    bAutoActivate = true;
    Velocity = FVector(0.0, 0.0, 0.0);
    bConstrainToPlane = false;
    bSnapToPlaneAtStart = false;
    bAutoRegisterUpdatedComponent = true;
    bTickBeforeOwner = true;
    PlaneConstraintNormal = FVector(0.0, 0.0, 1.0);
    PlaneConstraintOrigin = FVector(0.0, 0.0, 0.0);
    PlaneConstraintAxisSetting = EPlaneConstraintAxisSetting::UseGlobalPhysicsSetting;
}

void UMovementComponent::SetUpdatedComponent(USceneComponent* NewUpdatedComponent) {
    // What we move ticks after us, so that it sees this frame's location.
    if (UpdatedComponent && UpdatedComponent != NewUpdatedComponent) {
        UpdatedComponent->PrimaryComponentTick.RemovePrerequisite(this, PrimaryComponentTick);
    }
    UpdatedComponent = ::IsValid(NewUpdatedComponent) ? NewUpdatedComponent : nullptr;
    UpdatedPrimitive = Cast<UPrimitiveComponent>(UpdatedComponent.Get());
    if (UpdatedComponent) {
        UpdatedComponent->PrimaryComponentTick.AddPrerequisite(this, PrimaryComponentTick);
    }
    if (bSnapToPlaneAtStart) {
        SnapUpdatedComponentToPlane();
    }
}

void UMovementComponent::OnRegister() {
    Super::OnRegister();
    PlaneConstraintNormal = GetPlaneConstraintNormalFromAxisSetting(PlaneConstraintAxisSetting);
    AActor* const Owner = GetOwner();
    if (!UpdatedComponent && bAutoRegisterUpdatedComponent && Owner) {
        SetUpdatedComponent(Owner->GetRootComponent());
    }
    if (bTickBeforeOwner && Owner && PrimaryComponentTick.bCanEverTick && Owner->PrimaryActorTick.bCanEverTick) {
        Owner->PrimaryActorTick.AddPrerequisite(this, PrimaryComponentTick);
    }
}

void UMovementComponent::InitializeComponent() {
    Super::InitializeComponent();
    if (!UpdatedComponent && bAutoRegisterUpdatedComponent && GetOwner()) {
        SetUpdatedComponent(GetOwner()->GetRootComponent());
    }
    if (bSnapToPlaneAtStart) {
        SnapUpdatedComponentToPlane();
    }
}

void UMovementComponent::TickComponent(
    float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction) {
    Super::TickComponent(DeltaTime, TickType, ThisTickFunction);
    if (UpdatedComponent && !::IsValid(UpdatedComponent.Get())) {
        SetUpdatedComponent(nullptr);
    }
}

float UMovementComponent::GetGravityZ() const {
    const UWorld* const World = GetWorld();
    return World ? World->GetGravityZ() : 0.0f;
}

float UMovementComponent::GetMaxSpeed() const { return 0.0f; }

bool UMovementComponent::IsExceedingSpeed(float Speed) const {
    // A little more is allowed: the speed that a clamp leaves may be off in the last digits.
    const double Limit = static_cast<double>(FMath::Max(0.0f, Speed)) * 1.01;
    return Velocity.SizeSquared() > Limit * Limit;
}

bool UMovementComponent::IsExceedingMaxSpeed(float MaxSpeed) const { return IsExceedingSpeed(MaxSpeed); }

void UMovementComponent::StopMovementImmediately() {
    Velocity = FVector(0.0, 0.0, 0.0);
    UpdateComponentVelocity();
}

void UMovementComponent::UpdateComponentVelocity() {
    if (UpdatedComponent) {
        UpdatedComponent->ComponentVelocity = Velocity;
    }
}

bool UMovementComponent::ShouldSkipUpdate(float) const {
    return !UpdatedComponent || UpdatedComponent->Mobility != EComponentMobility::Movable;
}

// -----------------------------------------------------------------------------------------------------------------------
// move

bool UMovementComponent::MoveUpdatedComponent(
    const FVector& Delta, const FQuat& NewRotation, bool bSweep, FHitResult* OutHit, ETeleportType Teleport) {
    return UpdatedComponent && UpdatedComponent->MoveComponent(ConstrainDirectionToPlane(Delta), NewRotation, bSweep,
                                   OutHit, MOVECOMP_NoFlags, Teleport);
}

bool UMovementComponent::MoveUpdatedComponent(
    const FVector& Delta, const FRotator& NewRotation, bool bSweep, FHitResult* OutHit, ETeleportType Teleport) {
    return MoveUpdatedComponent(Delta, NewRotation.Quaternion(), bSweep, OutHit, Teleport);
}

bool UMovementComponent::K2_MoveUpdatedComponent(
    FVector Delta, FRotator NewRotation, FHitResult& OutHit, bool bSweep, bool bTeleport) {
    return MoveUpdatedComponent(Delta, NewRotation.Quaternion(), bSweep, &OutHit, TeleportFlagToEnum(bTeleport));
}

// ----------------------------------------------------------------------------------------------------------------------
// plane

FVector UMovementComponent::GetPlaneConstraintNormalFromAxisSetting(EPlaneConstraintAxisSetting AxisSetting) const {
    switch (AxisSetting) {
    case EPlaneConstraintAxisSetting::X:
        return FVector(1.0, 0.0, 0.0);
    case EPlaneConstraintAxisSetting::Y:
        return FVector(0.0, 1.0, 0.0);
    case EPlaneConstraintAxisSetting::Z:
        return FVector(0.0, 0.0, 1.0);
    default:
        return PlaneConstraintNormal;
    }
}

void UMovementComponent::SetPlaneConstraintEnabled(bool bEnabled) { bConstrainToPlane = bEnabled; }

void UMovementComponent::SetPlaneConstraintNormal(FVector PlaneNormal) {
    const FVector Normal = PlaneNormal.GetSafeNormal();
    if (!Normal.IsZero()) {
        PlaneConstraintNormal = Normal;
        PlaneConstraintAxisSetting = EPlaneConstraintAxisSetting::Custom;
    }
}

void UMovementComponent::SetPlaneConstraintOrigin(FVector PlaneOrigin) { PlaneConstraintOrigin = PlaneOrigin; }

void UMovementComponent::SetPlaneConstraintAxisSetting(EPlaneConstraintAxisSetting NewAxisSetting) {
    PlaneConstraintAxisSetting = NewAxisSetting;
    PlaneConstraintNormal = GetPlaneConstraintNormalFromAxisSetting(NewAxisSetting);
}

const FVector& UMovementComponent::GetPlaneConstraintNormal() const { return PlaneConstraintNormal; }

const FVector& UMovementComponent::GetPlaneConstraintOrigin() const { return PlaneConstraintOrigin; }

FVector UMovementComponent::ConstrainDirectionToPlane(FVector Direction) const {
    return bConstrainToPlane ? Direction - PlaneConstraintNormal * FVector::DotProduct(Direction, PlaneConstraintNormal)
                             : Direction;
}

FVector UMovementComponent::ConstrainLocationToPlane(FVector Location) const {
    return bConstrainToPlane ? Location - PlaneConstraintNormal * FVector::DotProduct(Location - PlaneConstraintOrigin,
                                                                      PlaneConstraintNormal)
                             : Location;
}

FVector UMovementComponent::ConstrainNormalToPlane(FVector Normal) const {
    return bConstrainToPlane ? ConstrainDirectionToPlane(Normal).GetSafeNormal() : Normal;
}

void UMovementComponent::SnapUpdatedComponentToPlane() {
    if (UpdatedComponent && bConstrainToPlane) {
        UpdatedComponent->SetWorldLocation(ConstrainLocationToPlane(UpdatedComponent->GetComponentLocation()));
    }
}
