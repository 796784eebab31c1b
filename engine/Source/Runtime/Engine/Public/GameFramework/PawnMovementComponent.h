// SPDX-License-Identifier: MIT
/** @file Movement of pawns by input. Mirrors UE's GameFramework/PawnMovementComponent.h. */
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/MovementComponent.h"
#include "UObject/ObjectMacros.h"

#include "PawnMovementComponent.generated.h"

class APawn;

/**
 * PawnMovementComponent can be used to update movement for an associated Pawn. It also provides ways to accumulate and
 * read directional input in a generic way.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/UPawnMovementComponent
 */
UCLASS(Abstract)
class ENGINE_API UPawnMovementComponent : public UMovementComponent {
    GENERATED_BODY()

public:
    UPawnMovementComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Adds the given vector to the accumulated input in world space. Input vectors are usually between 0 and 1 in
     * magnitude. */
    UFUNCTION(BlueprintCallable, Category = "Pawn|Components|PawnMovement")
    virtual void AddInputVector(FVector WorldVector, bool bForce = false);

    /** Return the pending input vector in world space. This is the most up-to-date value before it is consumed. */
    UFUNCTION(BlueprintCallable, Category = "Pawn|Components|PawnMovement")
    FVector GetPendingInputVector() const;

    /** Return the last input vector in world space that was processed by ConsumeInputVector(). */
    UFUNCTION(BlueprintCallable, Category = "Pawn|Components|PawnMovement")
    FVector GetLastInputVector() const;

    /** Returns the pending input vector and resets it to zero. */
    UFUNCTION(BlueprintCallable, Category = "Pawn|Components|PawnMovement")
    virtual FVector ConsumeInputVector();

    /** Helper to see if move input is ignored. If there is no Pawn or UpdatedComponent, returns true, otherwise defers
     * to the Pawn's implementation of IsMoveInputIgnored(). */
    UFUNCTION(BlueprintCallable, Category = "Pawn|Components|PawnMovement")
    virtual bool IsMoveInputIgnored() const;

    /** Return the Pawn that owns UpdatedComponent. */
    UFUNCTION(BlueprintCallable, Category = "Pawn|Components|PawnMovement")
    APawn* GetPawnOwner() const;

    // UMovementComponent
    virtual void SetUpdatedComponent(USceneComponent* NewUpdatedComponent) override;

protected:
    /** Pawn that owns this component. */
    UPROPERTY(Transient, DuplicateTransient)
    TObjectPtr<APawn> PawnOwner;
};
