// SPDX-License-Identifier: MIT
/** @file Simple floating movement. Mirrors UE's GameFramework/FloatingPawnMovement.h. */
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/PawnMovementComponent.h"
#include "UObject/ObjectMacros.h"

#include "FloatingPawnMovement.generated.h"

/**
 * FloatingPawnMovement is a movement component that provides simple movement for any Pawn class. Limits on speed and
 * acceleration are provided, while gravity is not implemented.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/UFloatingPawnMovement
 */
UCLASS(ClassGroup = Movement, meta = (BlueprintSpawnableComponent))
class ENGINE_API UFloatingPawnMovement : public UPawnMovementComponent {
    GENERATED_BODY()

public:
    UFloatingPawnMovement(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Maximum velocity magnitude allowed for the controlled Pawn, in centimetres per second. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = FloatingPawnMovement)
    float MaxSpeed;

    /** Acceleration applied by input (rate of change of velocity), in centimetres per second squared. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = FloatingPawnMovement)
    float Acceleration;

    /** Deceleration applied when there is no input (rate of change of velocity), in centimetres per second squared. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = FloatingPawnMovement)
    float Deceleration;

    /** Setting affecting extra force applied when changing direction, making turns have less drift and become more
     * responsive. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = FloatingPawnMovement, meta = (ClampMin = "0", UIMin = "0"))
    float TurningBoost;

    // UActorComponent
    virtual void TickComponent(
        float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction) override;
    // UMovementComponent
    virtual float GetMaxSpeed() const override { return MaxSpeed; }

protected:
    /** Update Velocity based on input. Also applies gravity: none here. */
    virtual void ApplyControlInputToVelocity(float DeltaTime);
};
