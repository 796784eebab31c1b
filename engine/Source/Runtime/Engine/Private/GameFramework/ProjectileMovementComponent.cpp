// SPDX-License-Identifier: MIT
#include "GameFramework/ProjectileMovementComponent.h"

#include "GameFramework/Actor.h"

namespace {

// Steps shorter than this, in seconds, are not simulated.
constexpr float ShortestStep = 1.e-6f;

} // namespace

UProjectileMovementComponent::UProjectileMovementComponent(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer) {
    InitialSpeed = 0.0f;
    MaxSpeed = 0.0f;
    bRotationFollowsVelocity = false;
    bRotationRemainsVertical = false;
    bInitialVelocityInLocalSpace = true;
    bSimulationEnabled = true;
    bForceSubStepping = false;
    bIsHomingProjectile = false;
    ProjectileGravityScale = 1.0f;
    HomingAccelerationMagnitude = 0.0f;
    MaxSimulationTimeStep = 0.05f;
    MaxSimulationIterations = 4;
    Velocity = FVector(1.0, 0.0, 0.0);
}

void UProjectileMovementComponent::InitializeComponent() {
    Super::InitializeComponent();
    if (Velocity.SizeSquared() > 0.0) {
        if (InitialSpeed > 0.0f) {
            Velocity = Velocity.GetSafeNormal() * static_cast<double>(InitialSpeed);
        }
        if (bInitialVelocityInLocalSpace) {
            SetVelocityInLocalSpace(Velocity);
        }
        if (bRotationFollowsVelocity && UpdatedComponent) {
            FRotator Facing = Velocity.Rotation();
            if (bRotationRemainsVertical) {
                Facing = FRotator(0.0, Facing.Yaw, 0.0);
            }
            UpdatedComponent->SetWorldRotation(Facing);
        }
        UpdateComponentVelocity();
    }
}

void UProjectileMovementComponent::SetVelocityInLocalSpace(FVector NewVelocity) {
    if (UpdatedComponent) {
        Velocity = UpdatedComponent->GetComponentTransform().TransformVectorNoScale(NewVelocity);
    }
}

float UProjectileMovementComponent::GetGravityZ() const {
    return ShouldApplyGravity() ? Super::GetGravityZ() * ProjectileGravityScale : 0.0f;
}

bool UProjectileMovementComponent::ShouldUseSubStepping() const {
    return bForceSubStepping || GetGravityZ() != 0.0f || (bIsHomingProjectile && HomingTargetComponent.IsValid());
}

float UProjectileMovementComponent::GetSimulationTimeStep(float RemainingTime, int32 Iterations) const {
    if (RemainingTime > MaxSimulationTimeStep && Iterations < MaxSimulationIterations) {
        RemainingTime = FMath::Min(MaxSimulationTimeStep, RemainingTime * 0.5f);
    }
    return FMath::Max(ShortestStep, RemainingTime);
}

FVector UProjectileMovementComponent::LimitVelocity(FVector NewVelocity) const {
    const float Limit = GetMaxSpeed();
    return ConstrainDirectionToPlane(Limit > 0.0f ? NewVelocity.GetClampedToMaxSize(Limit) : NewVelocity);
}

FVector UProjectileMovementComponent::ComputeHomingAcceleration(const FVector&, float) const {
    const USceneComponent* const Target = HomingTargetComponent.Get();
    return (Target->GetComponentLocation() - UpdatedComponent->GetComponentLocation()).GetSafeNormal() *
           static_cast<double>(HomingAccelerationMagnitude);
}

FVector UProjectileMovementComponent::ComputeAcceleration(const FVector& InVelocity, float DeltaTime) const {
    FVector Acceleration(0.0, 0.0, GetGravityZ());
    if (bIsHomingProjectile && HomingTargetComponent.IsValid() && UpdatedComponent) {
        Acceleration = Acceleration + ComputeHomingAcceleration(InVelocity, DeltaTime);
    }
    return Acceleration;
}

FVector UProjectileMovementComponent::ComputeVelocity(FVector InitialVelocity, float DeltaTime) const {
    return LimitVelocity(
        InitialVelocity + ComputeAcceleration(InitialVelocity, DeltaTime) * static_cast<double>(DeltaTime));
}

FVector UProjectileMovementComponent::ComputeMoveDelta(const FVector& InVelocity, float DeltaTime) const {
    // The mean of the velocities at both ends: exact while the acceleration is constant.
    const FVector NewVelocity = ComputeVelocity(InVelocity, DeltaTime);
    return (InVelocity + NewVelocity) * (0.5 * static_cast<double>(DeltaTime));
}

void UProjectileMovementComponent::TickComponent(
    float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction) {
    Super::TickComponent(DeltaTime, TickType, ThisTickFunction);
    if (ShouldSkipUpdate(DeltaTime)) {
        return;
    }
    AActor* const Owner = UpdatedComponent->GetOwner();
    if (!Owner || !Owner->CheckStillInWorld()) {
        return;
    }
    float RemainingTime = DeltaTime;
    int32 Iterations = 0;
    while (bSimulationEnabled && RemainingTime >= ShortestStep && Iterations < FMath::Max(MaxSimulationIterations, 1) &&
           UpdatedComponent && ::IsValid(Owner)) {
        ++Iterations;
        const float Step = ShouldUseSubStepping() ? GetSimulationTimeStep(RemainingTime, Iterations) : RemainingTime;
        RemainingTime -= Step;
        const FVector OldVelocity = Velocity;
        FQuat Rotation = UpdatedComponent->GetComponentQuat();
        if (bRotationFollowsVelocity && !OldVelocity.IsNearlyZero(0.01)) {
            FRotator Facing = OldVelocity.Rotation();
            if (bRotationRemainsVertical) {
                Facing = FRotator(0.0, Facing.Yaw, 0.0);
            }
            Rotation = Facing.Quaternion();
        }
        MoveUpdatedComponent(ComputeMoveDelta(OldVelocity, Step), Rotation, false);
        // A listener of the move may have changed the velocity: then that one counts.
        if (Velocity == OldVelocity) {
            Velocity = ComputeVelocity(OldVelocity, Step);
        }
    }
    UpdateComponentVelocity();
}
