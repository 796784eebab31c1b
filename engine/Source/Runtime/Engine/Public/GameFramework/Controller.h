// SPDX-License-Identifier: MIT
/** @file Controllers of pawns. Mirrors UE's GameFramework/Controller.h. */
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Actor.h"
#include "UObject/ObjectMacros.h"
#include "UObject/ScriptDelegates.h"

#include "Controller.generated.h"

class APawn;
class APlayerController;
class APlayerState;

DECLARE_DYNAMIC_MULTICAST_DELEGATE_TwoParams(FOnPossessedPawnChanged, APawn*, OldPawn, APawn*, NewPawn);

/**
 * Controllers are non-physical actors that can possess a Pawn to control its actions. PlayerControllers are used by
 * human players to control pawns.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/AController
 */
UCLASS(Abstract, NotPlaceable, NotBlueprintable, HideCategories = (Collision, Rendering, Transformation))
class ENGINE_API AController : public AActor {
    GENERATED_BODY()

public:
    AController(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** PlayerState containing replicated information about the player using this controller (only exists for players,
     * not NPCs). */
    UPROPERTY(BlueprintReadOnly, Category = Controller)
    TObjectPtr<APlayerState> PlayerState;

    /** Called on both authority and clients when the possessed pawn changes (either OldPawn or NewPawn might be
     * nullptr). */
    UPROPERTY(BlueprintAssignable, Category = Pawn)
    FOnPossessedPawnChanged OnPossessedPawnChanged;

    /** Current gameplay state this controller is in. */
    UPROPERTY()
    FName StateName;

    /** Actor marking where this controller spawned in. */
    TWeakObjectPtr<AActor> StartSpot;

    /**
     * Handles attaching this controller to the specified pawn. Only runs on the network authority (where HasAuthority()
     * returns true). Derived native classes can override OnPossess.
     * @param InPawn the Pawn to be possessed.
     */
    UFUNCTION(BlueprintCallable, Category = Pawn, meta = (Keywords = "set controller"))
    virtual void Possess(APawn* InPawn) final;

    /** Called to unpossess our pawn for any reason that is not the pawn being destroyed (destruction handled by
     * PawnDestroyed()). */
    UFUNCTION(BlueprintCallable, Category = Pawn, meta = (Keywords = "set controller"))
    virtual void UnPossess() final;

    /** Return the Pawn that is currently 'controlled' by this PlayerController. */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    APawn* K2_GetPawn() const;
    /** Getter for Pawn. */
    APawn* GetPawn() const { return Pawn; }
    template <class T>
    T* GetPawn() const {
        return Cast<T>(Pawn);
    }
    /** Setter for Pawn. Normally should only be used internally when possessing/unpossessing a Pawn. */
    virtual void SetPawn(APawn* InPawn);
    /** Called when the controlled pawn was destroyed. */
    virtual void PawnPendingDestroy(APawn* InPawn);

    /** The player state cast to T. */
    template <class T>
    T* GetPlayerState() const {
        return Cast<T>(PlayerState);
    }
    /** Spawns and initializes the PlayerState for this Controller. */
    virtual void InitPlayerState();
    /** Called from Destroyed(). Cleans up PlayerState. */
    virtual void CleanupPlayerState();

    /** Returns the current control rotation, in degrees. */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    virtual FRotator GetControlRotation() const;
    /** Set the control rotation. */
    UFUNCTION(BlueprintCallable, Category = Pawn, meta = (Tooltip = "Set the control rotation."))
    virtual void SetControlRotation(const FRotator& NewRotation);
    /** Set the initial location and rotation of the controller, as well as the control rotation. Typically used when
     * the controller is first created. */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    virtual void SetInitialLocationAndRotation(const FVector& NewLocation, const FRotator& NewRotation);
    /** Returns the rotation that the pawn should aim at: the control rotation. */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    virtual FRotator GetDesiredRotation() const;
    /** Get the actor the controller is looking at: the pawn. */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    virtual AActor* GetViewTarget() const;
    /** Returns Player's Point of View. For the AI this means the Pawn's 'Eyes' ViewPoint, for a Human player, this
     * means the Camera's ViewPoint. */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    virtual void GetPlayerViewPoint(FVector& Location, FRotator& Rotation) const;

    /** Returns whether this Controller is a locally controlled controller. */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    bool IsLocalPlayerController() const;
    /** Returns whether this Controller is a PlayerController. */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    bool IsPlayerController() const;
    /** Returns whether this Controller is a local controller. */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    bool IsLocalController() const { return true; }

    /** Locks or unlocks movement input, consecutive calls stack up and require the same amount of calls to undo, or can
     * all be undone using ResetIgnoreMoveInput. */
    UFUNCTION(BlueprintCallable, Category = Input)
    virtual void SetIgnoreMoveInput(bool bNewMoveInput);
    /** Stops ignoring move input by resetting the ignore move input state. */
    UFUNCTION(BlueprintCallable, Category = Input, meta = (Keywords = "ClearIgnoreMoveInput"))
    virtual void ResetIgnoreMoveInput();
    /** Returns true if movement input is ignored. */
    UFUNCTION(BlueprintCallable, Category = Input)
    virtual bool IsMoveInputIgnored() const;
    /** Locks or unlocks look input, consecutive calls stack up and require the same amount of calls to undo, or can all
     * be undone using ResetIgnoreLookInput. */
    UFUNCTION(BlueprintCallable, Category = Input)
    virtual void SetIgnoreLookInput(bool bNewLookInput);
    /** Stops ignoring look input by resetting the ignore look input state. */
    UFUNCTION(BlueprintCallable, Category = Input, meta = (Keywords = "ClearIgnoreLookInput"))
    virtual void ResetIgnoreLookInput();
    /** Returns true if look input is ignored. */
    UFUNCTION(BlueprintCallable, Category = Input)
    virtual bool IsLookInputIgnored() const;
    /** Stop ignoring both. */
    UFUNCTION(BlueprintCallable, Category = Input)
    virtual void ResetIgnoreInputFlags();

    /** Aborts the move the controller is currently performing: zeroes the velocity of the pawn's root. */
    UFUNCTION(BlueprintCallable, Category = "Navigation")
    virtual void StopMovement();

    /** Blueprint implementable event to react to the controller possessing a pawn. */
    UFUNCTION(BlueprintImplementableEvent, Category = "Controller", meta = (DisplayName = "On Possess"))
    void ReceivePossess(APawn* PossessedPawn);
    /** Blueprint implementable event to react to the controller unpossessing a pawn. */
    UFUNCTION(BlueprintImplementableEvent, Category = "Controller", meta = (DisplayName = "On UnPossess"))
    void ReceiveUnPossess(APawn* UnpossessedPawn);

    // AActor
    virtual void PostInitializeComponents() override;
    virtual void Destroyed() override;
    virtual void Reset() override;
    virtual void GetActorEyesViewPoint(FVector& OutLocation, FRotator& OutRotation) const override;

protected:
    /** Overridable native function for when this controller is asked to possess a pawn. */
    virtual void OnPossess(APawn* InPawn);
    /** Overridable native function for when this controller unpossesses its pawn. */
    virtual void OnUnPossess();
    /** Tells the listeners about a change of the pawn. */
    void NotifyPawnChanged(APawn* OldPawn);

    /** The control rotation of the Controller. See GetControlRotation. */
    UPROPERTY()
    FRotator ControlRotation;

    uint8 IgnoreMoveInput;
    uint8 IgnoreLookInput;

private:
    /** Pawn currently being controlled by this controller. Use Pawn.Possess() to take control of a pawn. */
    UPROPERTY()
    TObjectPtr<APawn> Pawn;
};
