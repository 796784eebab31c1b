// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/MovementComponent.h"
#include "UObject/ObjectMacros.h"

#include "ProjectileMovementComponent.generated.h"

/**
 * Flies the updated component under gravity, with an optional homing target. The position over one step is exact for a
 * constant acceleration, so a thrown object follows its parabola at any frame rate. Bouncing and stopping need
 * collision and are absent. Epic page: UProjectileMovementComponent.
 */
UCLASS(ClassGroup = Movement, meta = (BlueprintSpawnableComponent), ShowCategories = (Velocity))
class ENGINE_API UProjectileMovementComponent : public UMovementComponent {
    GENERATED_BODY()

public:
    /** Initial speed of the projectile, in centimetres per second. If greater than zero, this will override the initial
     * Velocity value and instead treat Velocity as a direction. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Projectile)
    float InitialSpeed;

    /** Limit on the speed of the projectile, in centimetres per second (0 means no limit). */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Projectile)
    float MaxSpeed;

    /** If true, this projectile will have its rotation updated each frame to match the direction of its velocity. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Projectile)
    uint8 bRotationFollowsVelocity : 1;

    /** If true, this projectile will have its rotation updated each frame to maintain the rotation's pitch at zero. */
    UPROPERTY(
        EditAnywhere, BlueprintReadWrite, Category = Projectile, meta = (EditCondition = "bRotationFollowsVelocity"))
    uint8 bRotationRemainsVertical : 1;

    /** If true, the initial Velocity is interpreted as being in local space upon startup. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Projectile)
    uint8 bInitialVelocityInLocalSpace : 1;

    /** If true, does normal simulation ticking and update. If false, simulation is halted, but component will still
     * tick. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = ProjectileSimulation)
    uint8 bSimulationEnabled : 1;

    /** If true, forces sub-stepping to break up movement into discrete smaller steps to improve accuracy of the
     * trajectory. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = ProjectileSimulation)
    uint8 bForceSubStepping : 1;

    /** If true, we will accelerate toward our homing target. HomingTargetComponent must be set after the projectile is
     * spawned. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Homing)
    uint8 bIsHomingProjectile : 1;

    /** Custom gravity scale for this projectile. Set to 0 for no gravity. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Projectile)
    float ProjectileGravityScale;

    /** The magnitude of our acceleration towards the homing target, in centimetres per second squared. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Homing)
    float HomingAccelerationMagnitude;

    /** The current target we are homing towards. */
    UPROPERTY(VisibleInstanceOnly, BlueprintReadWrite, Category = Homing)
    TWeakObjectPtr<USceneComponent> HomingTargetComponent;

    /** Max time delta for each discrete simulation step, in seconds. Used only when sub-stepping. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = ProjectileSimulation,
        meta = (ClampMin = "0.0166", ClampMax = "0.50", UIMin = "0.0166", UIMax = "0.50"))
    float MaxSimulationTimeStep;

    /** Max number of iterations used for each discrete simulation step. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = ProjectileSimulation,
        meta = (ClampMin = "1", ClampMax = "25", UIMin = "1", UIMax = "25"))
    int32 MaxSimulationIterations;

    UProjectileMovementComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Sets the velocity to a vector in the updated component's local space. */
    UFUNCTION(BlueprintCallable, Category = "Game|Components|ProjectileMovement")
    virtual void SetVelocityInLocalSpace(FVector NewVelocity);

    /** The acceleration that a velocity suffers: gravity and homing, in centimetres per second squared. */
    virtual FVector ComputeAcceleration(const FVector& InVelocity, float DeltaTime) const;
    /** The velocity after a time step. */
    FVector ComputeVelocity(FVector InitialVelocity, float DeltaTime) const;
    /** The way made in a time step. */
    virtual FVector ComputeMoveDelta(const FVector& InVelocity, float DeltaTime) const;
    /** Whether there is gravity for this projectile. */
    bool ShouldApplyGravity() const { return ProjectileGravityScale != 0.0f; }
    /** A velocity cut to the maximum speed. */
    FVector LimitVelocity(FVector NewVelocity) const;
    /** Whether ticks are broken into smaller steps. */
    virtual bool ShouldUseSubStepping() const;
    /** The length of the next step, in seconds. */
    float GetSimulationTimeStep(float RemainingTime, int32 Iterations) const;

    // UMovementComponent
    virtual float GetMaxSpeed() const override { return MaxSpeed; }
    virtual float GetGravityZ() const override;
    virtual void InitializeComponent() override;
    virtual void TickComponent(
        float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction) override;

protected:
    /** The acceleration towards the homing target. */
    virtual FVector ComputeHomingAcceleration(const FVector& InVelocity, float DeltaTime) const;
};
