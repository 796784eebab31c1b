// SPDX-License-Identifier: MIT
/** @file A simple flying pawn. Mirrors UE's GameFramework/DefaultPawn.h. */
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Pawn.h"
#include "UObject/ObjectMacros.h"

#include "DefaultPawn.generated.h"

class UPawnMovementComponent;
class USphereComponent;

/**
 * DefaultPawn implements a simple Pawn with spherical collision and built-in flying movement.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/ADefaultPawn
 */
UCLASS(config = Game, Blueprintable, BlueprintType)
class ENGINE_API ADefaultPawn : public APawn {
    GENERATED_BODY()

public:
    ADefaultPawn(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Name of the MovementComponent. Use this name if you want to use a different class (with
     * ObjectInitializer.SetDefaultSubobjectClass). */
    static FName MovementComponentName;
    /** Name of the CollisionComponent. */
    static FName CollisionComponentName;

    /** Base turn rate, in deg/sec. Other scaling may affect final turn rate. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Pawn)
    float BaseTurnRate;

    /** Base lookup rate, in deg/sec. Other scaling may affect final lookup rate. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Pawn)
    float BaseLookUpRate;

    /** Input callback to move forward in local space (or backward if Val is negative). @param Val amount of movement in
     * the forward direction (or backward if negative). */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    virtual void MoveForward(float Val);
    /** Input callback to strafe right in local space (or left if Val is negative). */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    virtual void MoveRight(float Val);
    /** Input callback to move up in world space (or down if Val is negative). */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    virtual void MoveUp_World(float Val);
    /** Called via input to turn at a given rate. @param Rate this is a normalized rate, i.e. 1.0 means 100% of desired
     * turn rate. */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    virtual void TurnAtRate(float Rate);
    /** Called via input to look up at a given rate (or down if Rate is negative). */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    virtual void LookUpAtRate(float Rate);

    /** Returns CollisionComponent subobject. */
    USphereComponent* GetCollisionComponent() const { return CollisionComponent; }
    virtual UPawnMovementComponent* GetMovementComponent() const override { return MovementComponent; }

protected:
    /** DefaultPawn movement component. */
    UPROPERTY(Category = Pawn, VisibleAnywhere, BlueprintReadOnly, meta = (AllowPrivateAccess = "true"))
    TObjectPtr<UPawnMovementComponent> MovementComponent;

private:
    /** DefaultPawn collision component. */
    UPROPERTY(Category = Pawn, VisibleAnywhere, BlueprintReadOnly, meta = (AllowPrivateAccess = "true"))
    TObjectPtr<USphereComponent> CollisionComponent;
};
