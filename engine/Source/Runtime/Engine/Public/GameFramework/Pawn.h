// SPDX-License-Identifier: MIT
/** @file Actors that controllers possess. Mirrors UE's GameFramework/Pawn.h. */
#pragma once

#include "CoreMinimal.h"
#include "Engine/EngineTypes.h"
#include "GameFramework/Actor.h"
#include "UObject/ObjectMacros.h"
#include "UObject/SparseDelegate.h"

#include "Pawn.generated.h"

class AController;
class APlayerState;
class UPawnMovementComponent;

DECLARE_DYNAMIC_MULTICAST_SPARSE_DELEGATE_ThreeParams(FPawnControllerChangedSignature, APawn,
    ReceiveControllerChangedDelegate, APawn*, Pawn, AController*, OldController, AController*, NewController);

/**
 * Pawn is the base class of all actors that can be possessed by players or AI. They are the physical representations of
 * players and creatures in a level.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/APawn
 */
UCLASS(config = Game, BlueprintType, Blueprintable, HideCategories = (Navigation),
    meta = (ShortTooltip = "A Pawn is an actor that can be 'possessed' and receive input from a controller."))
class ENGINE_API APawn : public AActor {
    GENERATED_BODY()

public:
    APawn(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** If true, this Pawn's pitch will be updated to match the Controller's ControlRotation pitch, if controlled by a
     * PlayerController. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Pawn)
    uint8 bUseControllerRotationPitch : 1;

    /** If true, this Pawn's yaw will be updated to match the Controller's ControlRotation yaw, if controlled by a
     * PlayerController. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Pawn)
    uint8 bUseControllerRotationYaw : 1;

    /** If true, this Pawn's roll will be updated to match the Controller's ControlRotation roll, if controlled by a
     * PlayerController. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Pawn)
    uint8 bUseControllerRotationRoll : 1;

    /** Base eye height above collision center, in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = Camera)
    float BaseEyeHeight;

    /** Determines which PlayerController, if any, should automatically possess the pawn when the level starts or when
     * the pawn is spawned. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Pawn)
    TEnumAsByte<EAutoReceiveInput::Type> AutoPossessPlayer;

    /** If Pawn is possessed by a player, points to its PlayerState. */
    UPROPERTY(BlueprintReadOnly, Category = Pawn, meta = (AllowPrivateAccess = "true"))
    TObjectPtr<APlayerState> PlayerState;

    /** Controller currently possessing this Actor. */
    UPROPERTY()
    TObjectPtr<AController> Controller;

    /** Previous controller that was controlling this pawn since the last controller change notification. */
    UPROPERTY(Transient)
    TObjectPtr<AController> PreviousController;

    /** Event called after a pawn's controller has changed, on the server and owning client. This will happen at the
     * same time as the delegate on GameInstance. */
    UPROPERTY(BlueprintAssignable, Category = Pawn)
    FPawnControllerChangedSignature ReceiveControllerChangedDelegate;

    // --------------------------------------------------------------------------------------------------------
    // controller

    /** Returns controller for this actor. */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    AController* GetController() const;
    /** Returns controller for this actor cast to the template type. May return NULL is the cast fails. */
    template <class T>
    T* GetController() const {
        return Cast<T>(Controller);
    }
    /** Returns local Player Controller viewing this pawn, whether it is possessing or spectating the pawn. */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    virtual APlayerController* GetLocalViewingPlayerController() const;
    /** Returns true if controlled by a local (not network) Controller. */
    UFUNCTION(BlueprintPure, Category = Pawn)
    virtual bool IsLocallyControlled() const;
    /** Returns true if controlled by a human player (possessed by a PlayerController). */
    UFUNCTION(BlueprintPure, Category = Pawn)
    virtual bool IsPlayerControlled() const;
    /** Check if this actor is currently being controlled at all (the actor has a valid Controller). */
    UFUNCTION(BlueprintPure, Category = Pawn)
    virtual bool IsPawnControlled() const;
    /** Get the rotation of the Controller, often the 'view' rotation of this Pawn. */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    FRotator GetControlRotation() const;
    /** Call this function to detach safely pawn from its controller, knowing that we will be destroyed soon. */
    UFUNCTION(BlueprintCallable, Category = Pawn, meta = (Keywords = "Delete"))
    virtual void DetachFromControllerPendingDestroy();
    /** Called when this Pawn is possessed. Only called on the server (or in standalone). */
    virtual void PossessedBy(AController* NewController);
    /** Called when our Controller no longer possesses us. Only called on the server (or in standalone). */
    virtual void UnPossessed();
    /** Call to notify about a change in controller, on both the server and owning client. */
    virtual void NotifyControllerChanged();
    /** Event called when the Pawn is possessed by a Controller. Only called on the server (or in standalone). */
    UFUNCTION(BlueprintImplementableEvent, BlueprintAuthorityOnly, meta = (DisplayName = "Possessed"))
    void ReceivePossessed(AController* NewController);
    /** Event called when the Pawn is no longer possessed by a Controller. Only called on the server (or in standalone).
     */
    UFUNCTION(BlueprintImplementableEvent, BlueprintAuthorityOnly, meta = (DisplayName = "Unpossessed"))
    void ReceiveUnpossessed(AController* OldController);
    /** Event called after a pawn's controller has changed, on the server and owning client. */
    UFUNCTION(BlueprintImplementableEvent, meta = (DisplayName = "Controller Changed"))
    void ReceiveControllerChanged(AController* OldController, AController* NewController);

    /** If Pawn is possessed by a player, returns its Player State. */
    APlayerState* GetPlayerState() const { return PlayerState; }
    template <class T>
    T* GetPlayerState() const {
        return Cast<T>(PlayerState);
    }
    /** Set the player state of this pawn. */
    void SetPlayerState(APlayerState* NewPlayerState);

    // --------------------------------------------------------------------------------------------------------------
    // view

    /** Returns the Pawn's eye location: that of the actor plus BaseEyeHeight. */
    virtual FVector GetPawnViewLocation() const;
    /** Get the view rotation of the Pawn (direction they are looking, normally Controller->ControlRotation). */
    virtual FRotator GetViewRotation() const;
    /** Return our base aim rotation: that of the view. */
    UFUNCTION(BlueprintCallable, Category = Pawn)
    virtual FRotator GetBaseAimRotation() const;
    /** Updates Pawn's rotation to the given rotation, assumed to be the Controller's ControlRotation. Respects the
     * bUseControllerRotation* settings. */
    virtual void FaceRotation(FRotator NewControlRotation, float DeltaTime = 0.f);
    /** Set BaseEyeHeight back to the default of the class. */
    virtual void RecalculateBaseEyeHeight();

    // -------------------------------------------------------------------------------------------------------------
    // input

    /** Return our PawnMovementComponent, if we have one. */
    UFUNCTION(
        BlueprintCallable, meta = (Tooltip = "Return our PawnMovementComponent, if we have one."), Category = Pawn)
    virtual UPawnMovementComponent* GetMovementComponent() const;
    /**
     * Add movement input along the given world direction vector (usually normalized) scaled by 'ScaleValue'. If
     * ScaleValue < 0, movement will be in the opposite direction. Base Pawn classes won't automatically apply movement,
     * it's up to the user to do so in a Tick event (or a movement component consumes it).
     * @param WorldDirection direction in world space to apply input.
     * @param ScaleValue scale to apply to input. This can be used for analog input, ie a value of 0.5 applies half the
     * normal value, while -1.0 would reverse the direction.
     * @param bForce if true always add the input, ignoring the result of IsMoveInputIgnored().
     */
    UFUNCTION(BlueprintCallable, Category = "Pawn|Input", meta = (Keywords = "AddInput"))
    virtual void AddMovementInput(FVector WorldDirection, float ScaleValue = 1.0f, bool bForce = false);
    /** Return the pending input vector in world space. This is the most up-to-date value before it is consumed by a
     * movement component. */
    UFUNCTION(BlueprintCallable, Category = "Pawn|Input", meta = (Keywords = "GetMovementInput GetInput"))
    FVector GetPendingMovementInputVector() const;
    /** Return the last input vector in world space that was processed by ConsumeMovementInputVector(). */
    UFUNCTION(BlueprintCallable, Category = "Pawn|Input", meta = (Keywords = "GetMovementInput GetInput"))
    FVector GetLastMovementInputVector() const;
    /** Returns the pending input vector and resets it to zero. */
    UFUNCTION(BlueprintCallable, Category = "Pawn|Input", meta = (Keywords = "ConsumeInput"))
    virtual FVector ConsumeMovementInputVector();
    /** Helper to see if move input is ignored. If our controller is a PlayerController, checks
     * Controller->IsMoveInputIgnored(). */
    UFUNCTION(BlueprintCallable, Category = "Pawn|Input")
    virtual bool IsMoveInputIgnored() const;
    /** Add input (affecting Pitch) to the Controller's ControlRotation, if it is a local PlayerController. Degrees. */
    UFUNCTION(BlueprintCallable, Category = "Pawn|Input", meta = (Keywords = "up down addpitch"))
    virtual void AddControllerPitchInput(float Val);
    /** Add input (affecting Yaw) to the Controller's ControlRotation, if it is a local PlayerController. Degrees. */
    UFUNCTION(BlueprintCallable, Category = "Pawn|Input", meta = (Keywords = "left right turn addyaw"))
    virtual void AddControllerYawInput(float Val);
    /** Add input (affecting Roll) to the Controller's ControlRotation, if it is a local PlayerController. Degrees. */
    UFUNCTION(BlueprintCallable, Category = "Pawn|Input", meta = (Keywords = "addroll"))
    virtual void AddControllerRollInput(float Val);
    /** Internal function meant for use only within Pawn or by a PawnMovementComponent. */
    void Internal_AddMovementInput(FVector WorldAccel, bool bForce = false);
    FVector Internal_ConsumeMovementInputVector();
    FVector Internal_GetPendingMovementInputVector() const { return ControlInputVector; }
    FVector Internal_GetLastMovementInputVector() const { return LastControlInputVector; }

    // AActor
    virtual void PostInitializeComponents() override;
    virtual void EndPlay(const EEndPlayReason::Type EndPlayReason) override;
    virtual void Destroyed() override;
    virtual void Reset() override;
    virtual FVector GetVelocity() const override;
    virtual void GetActorEyesViewPoint(FVector& OutLocation, FRotator& OutRotation) const override;
    virtual void BecomeViewTarget(APlayerController* PC) override;

protected:
    virtual void BeginPlay() override;

    /** Accumulated control input vector, stored in world space. This is the pending input, which is cleared (zeroed)
     * once consumed. */
    UPROPERTY(Transient)
    FVector ControlInputVector;

    /** The last control input vector that was processed by ConsumeMovementInputVector(). */
    UPROPERTY(Transient)
    FVector LastControlInputVector;
};
