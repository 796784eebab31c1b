// SPDX-License-Identifier: MIT
#pragma once

#include "Components/SceneComponent.h"
#include "CoreMinimal.h"
#include "Engine/HitResult.h"
#include "UObject/ObjectMacros.h"

#include "MovementComponent.generated.h"

class UPrimitiveComponent;

/** Which plane movement is constrained to. Epic page: EPlaneConstraintAxisSetting. */
UENUM(BlueprintType)
enum class EPlaneConstraintAxisSetting : uint8 {
    /** Lock movement to a user-defined axis. */
    Custom,
    /** Lock movement in the X axis. */
    X,
    /** Lock movement in the Y axis. */
    Y,
    /** Lock movement in the Z axis. */
    Z,
    /** Use the physics project setting; here that is the axis set by hand. */
    UseGlobalPhysicsSetting
};

/**
 * Base of the components that move a scene component (by default the owner's root).
 *
 * The embedded engine has no collision queries yet: moves never hit anything. Epic page: UMovementComponent.
 */
UCLASS(ClassGroup = Movement, Abstract, BlueprintType)
class ENGINE_API UMovementComponent : public UActorComponent {
    GENERATED_BODY()

public:
    /** The component we move and update. If this is null at startup, the owner's root component will automatically be
     * set. */
    UPROPERTY(BlueprintReadOnly, Transient, DuplicateTransient, Category = MovementComponent)
    TObjectPtr<USceneComponent> UpdatedComponent;

    /** UpdatedComponent, cast as a UPrimitiveComponent. May be null. */
    UPROPERTY(BlueprintReadOnly, Transient, DuplicateTransient, Category = MovementComponent)
    TObjectPtr<UPrimitiveComponent> UpdatedPrimitive;

    /** Current velocity of the moved component, in centimetres per second. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Velocity)
    FVector Velocity;

    /** Whether movement is constrained to a plane. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = PlanarMovement)
    uint8 bConstrainToPlane : 1;

    /** If true and plane constraints are enabled, then the updated component will be snapped to the plane when first
     * attached. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = PlanarMovement, meta = (EditCondition = "bConstrainToPlane"))
    uint8 bSnapToPlaneAtStart : 1;

    /** If true, after registration we will set the updated component to the owner's root where none is set. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, AdvancedDisplay, Category = MovementComponent)
    uint8 bAutoRegisterUpdatedComponent : 1;

    /** If true, the movement component ticks before its owner does. */
    UPROPERTY(EditAnywhere, AdvancedDisplay, BlueprintReadWrite, Category = MovementComponent)
    uint8 bTickBeforeOwner : 1;

    UMovementComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Assigns the component we move and update. */
    UFUNCTION(BlueprintCallable, Category = "Components|Movement")
    virtual void SetUpdatedComponent(USceneComponent* NewUpdatedComponent);

    /** Returns gravity that affects this component, in centimetres per second squared. */
    UFUNCTION(BlueprintCallable, Category = "Components|Movement")
    virtual float GetGravityZ() const;

    /** Returns maximum speed, in centimetres per second. */
    UFUNCTION(BlueprintCallable, Category = "Components|Movement")
    virtual float GetMaxSpeed() const;

    /** Returns true if the current velocity is exceeding the given max speed (usually the result of GetMaxSpeed()),
     * within a small error tolerance. */
    UFUNCTION(BlueprintCallable, Category = "Components|Movement")
    virtual bool IsExceedingMaxSpeed(float MaxSpeed) const;

    /** Stops movement immediately (zeroes velocity, usually zeros acceleration for components with acceleration). */
    UFUNCTION(BlueprintCallable, Category = "Components|Movement")
    virtual void StopMovementImmediately();

    /**
     * Moves the updated component by a delta, constrained to the plane.
     * @return whether it moved
     */
    UFUNCTION(BlueprintCallable, Category = "Components|Movement",
        meta = (DisplayName = "Move Updated Component", ScriptName = "MoveUpdatedComponent",
            AdvancedDisplay = "bTeleport"))
    bool K2_MoveUpdatedComponent(
        FVector Delta, FRotator NewRotation, FHitResult& OutHit, bool bSweep = true, bool bTeleport = false);

    /** Changes whether movement is constrained to a plane. */
    UFUNCTION(BlueprintCallable, Category = "Components|Movement|Planar")
    virtual void SetPlaneConstraintEnabled(bool bEnabled);

    /** Sets the normal of the plane that constrains movement. */
    UFUNCTION(BlueprintCallable, Category = "Components|Movement|Planar")
    virtual void SetPlaneConstraintNormal(FVector PlaneNormal);

    /** Sets the origin of the plane that constrains movement. */
    UFUNCTION(BlueprintCallable, Category = "Components|Movement|Planar")
    virtual void SetPlaneConstraintOrigin(FVector PlaneOrigin);

    /** Sets the axis setting of the plane that constrains movement. */
    UFUNCTION(BlueprintCallable, Category = "Components|Movement|Planar")
    virtual void SetPlaneConstraintAxisSetting(EPlaneConstraintAxisSetting NewAxisSetting);

    /** Gets the normal of the plane. */
    UFUNCTION(BlueprintCallable, Category = "Components|Movement|Planar")
    const FVector& GetPlaneConstraintNormal() const;

    /** Gets the origin of the plane. */
    UFUNCTION(BlueprintCallable, Category = "Components|Movement|Planar")
    const FVector& GetPlaneConstraintOrigin() const;

    /** Constrains a direction vector to the plane, if enabled. */
    UFUNCTION(BlueprintCallable, Category = "Components|Movement|Planar")
    virtual FVector ConstrainDirectionToPlane(FVector Direction) const;

    /** Constrains a position vector to the plane, if enabled. */
    UFUNCTION(BlueprintCallable, Category = "Components|Movement|Planar")
    virtual FVector ConstrainLocationToPlane(FVector Location) const;

    /** Constrains a normal vector (of unit length) to the plane, if enabled. */
    UFUNCTION(BlueprintCallable, Category = "Components|Movement|Planar")
    virtual FVector ConstrainNormalToPlane(FVector Normal) const;

    /** Snaps the updated component to the plane, if enabled. */
    UFUNCTION(BlueprintCallable, Category = "Components|Movement|Planar")
    virtual void SnapUpdatedComponentToPlane();

    /** Moves the updated component by a delta, constrained to the plane; returns whether it moved. */
    bool MoveUpdatedComponent(const FVector& Delta, const FQuat& NewRotation, bool bSweep, FHitResult* OutHit = nullptr,
        ETeleportType Teleport = ETeleportType::None);
    /** Moves the updated component by a delta, constrained to the plane; returns whether it moved. */
    bool MoveUpdatedComponent(const FVector& Delta, const FRotator& NewRotation, bool bSweep,
        FHitResult* OutHit = nullptr, ETeleportType Teleport = ETeleportType::None);
    /** Copies Velocity to the updated component's ComponentVelocity. */
    virtual void UpdateComponentVelocity();
    /** Whether this tick should do nothing: nothing to move, or the updated component must not move. */
    virtual bool ShouldSkipUpdate(float DeltaTime) const;
    /** Whether Velocity is above that speed by more than 1 %. */
    bool IsExceedingSpeed(float Speed) const;

    // UActorComponent
    virtual void OnRegister() override;
    virtual void InitializeComponent() override;
    virtual void TickComponent(
        float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction) override;

protected:
    /** The normal of the plane that movement is constrained to. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = PlanarMovement, meta = (EditCondition = "bConstrainToPlane"))
    FVector PlaneConstraintNormal;

    /** The origin of the plane that movement is constrained to. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = PlanarMovement, meta = (EditCondition = "bConstrainToPlane"))
    FVector PlaneConstraintOrigin;

private:
    /** Which axis the plane's normal is. */
    UPROPERTY(EditAnywhere, Category = PlanarMovement, meta = (EditCondition = "bConstrainToPlane"))
    EPlaneConstraintAxisSetting PlaneConstraintAxisSetting;

    FVector GetPlaneConstraintNormalFromAxisSetting(EPlaneConstraintAxisSetting AxisSetting) const;
};
