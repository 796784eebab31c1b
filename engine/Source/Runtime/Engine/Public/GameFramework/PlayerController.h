// SPDX-License-Identifier: MIT
/** @file Controllers of human players. Mirrors UE's GameFramework/PlayerController.h. */
#pragma once

#include "Camera/PlayerCameraManager.h"
#include "CoreMinimal.h"
#include "GameFramework/Controller.h"
#include "Templates/SubclassOf.h"
#include "UObject/ObjectMacros.h"

#include "PlayerController.generated.h"

class APawn;
class ASpectatorPawn;
class ULocalPlayer;
class UPlayer;

/** Delegate used to override default viewport behaviour: asked whether this player may unpause. */
DECLARE_DELEGATE_RetVal(bool, FCanUnpause);

/**
 * PlayerControllers are used by human players to control Pawns. ControlRotation (accessed via GetControlRotation()),
 * determines the aiming orientation of the controlled Pawn.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/APlayerController
 */
UCLASS(config = Game, BlueprintType, Blueprintable,
    meta = (ShortTooltip = "A Player Controller is an actor responsible for controlling a Pawn used by the player."))
class ENGINE_API APlayerController : public AController {
    GENERATED_BODY()

public:
    APlayerController(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** UPlayer associated with this PlayerController. Could be a local player or a net connection. */
    UPROPERTY()
    TObjectPtr<UPlayer> Player;

    /** Used in net games so client can acknowledge it possessed a specific pawn: always the pawn here. */
    UPROPERTY()
    TObjectPtr<APawn> AcknowledgedPawn;

    /** Camera manager associated with this Player Controller. */
    UPROPERTY(BlueprintReadOnly, Category = PlayerController)
    TObjectPtr<APlayerCameraManager> PlayerCameraManager;

    /** PlayerCamera class should be set for each game, otherwise Engine.PlayerCameraManager is used. */
    UPROPERTY(EditDefaultsOnly, BlueprintReadOnly, Category = PlayerController)
    TSubclassOf<APlayerCameraManager> PlayerCameraManagerClass;

    /** True to allow this player controller to manage the camera target for you, typically by using the possessed pawn
     * as the camera target. Set to false if you want to manually control the camera target. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = PlayerController)
    bool bAutoManageActiveCameraTarget;

    /** Rotation input collected in this frame, in degrees; applied by UpdateRotation. */
    UPROPERTY(Transient)
    FRotator RotationInput;

    // --------------------------------------------------------------------------------------------------------- view
    // target

    /**
     * Set the view target.
     * @param NewViewTarget new view target; null: this controller.
     * @param TransitionParams how to move there.
     */
    virtual void SetViewTarget(
        AActor* NewViewTarget, FViewTargetTransitionParams TransitionParams = FViewTargetTransitionParams());

    /**
     * Set the view target blending with variable control.
     * @param NewViewTarget new actor to set as view target.
     * @param BlendTime time taken to blend, in seconds.
     * @param BlendFunc cubic, Linear etc functions for blending.
     * @param BlendExp exponent, used by certain blend functions to control the shape of the curve.
     * @param bLockOutgoing if true, lock outgoing viewtarget to last frame's camera position for the remainder of the
     * blend.
     */
    UFUNCTION(BlueprintCallable, Category = "Game|Player", meta = (Keywords = "Camera"))
    virtual void SetViewTargetWithBlend(AActor* NewViewTarget, float BlendTime = 0,
        EViewTargetBlendFunction BlendFunc = VTBlend_Linear, float BlendExp = 0, bool bLockOutgoing = false);

    /** Spawn the camera manager. */
    virtual void SpawnPlayerCameraManager();
    /** Updates the camera: called each frame after all actors of earlier groups ticked. */
    virtual void UpdateCameraManager(float DeltaSeconds);
    /** If bAutoManageActiveCameraTarget is true, then automatically manage the active camera target. */
    virtual void AutoManageActiveCameraTarget(AActor* SuggestedTarget);

    // --------------------------------------------------------------------------------------------------------------
    // pause

    /**
     * Try to pause game; default implementation allows if the game mode does.
     * @param bPause whether to pause or to unpause.
     * @param CanUnpauseDelegate asked later whether it may be unpaused.
     * @return true if the game is now paused, or unpaused, as asked.
     */
    virtual bool SetPause(bool bPause, FCanUnpause CanUnpauseDelegate = FCanUnpause());
    /** Returns true if the game is paused. */
    bool IsPaused() const;
    /** Command to try to pause the game: toggles. */
    UFUNCTION(exec)
    virtual void Pause();
    /** Restarts the current level. */
    UFUNCTION(exec)
    virtual void RestartLevel();

    // -------------------------------------------------------------------------------------------------------------
    // player

    /** Associate a new UPlayer with this PlayerController. */
    virtual void SetPlayer(UPlayer* InPlayer);
    /** Returns the ULocalPlayer for this controller if it exists, or null otherwise. */
    ULocalPlayer* GetLocalPlayer() const;
    /** Returns whether this is the first local player. */
    bool IsPrimaryPlayer() const;
    /** Change name of local player. */
    UFUNCTION(exec)
    virtual void SetName(const FString& S);
    /** Executes a console command: of the player, the engine, or the variable of that name. @return its output. */
    UFUNCTION(BlueprintCallable, Category = "Development")
    virtual FString ConsoleCommand(const FString& Command, bool bWriteToLog = true);

    // --------------------------------------------------------------------------------------------------------------
    // input

    /** Add Pitch (look up) input. This value is multiplied by InputPitchScale. Degrees. */
    UFUNCTION(BlueprintCallable, Category = "Game|Player", meta = (Keywords = "up down"))
    virtual void AddPitchInput(float Val);
    /** Add Yaw (turn) input. Degrees. */
    UFUNCTION(BlueprintCallable, Category = "Game|Player", meta = (Keywords = "left right turn"))
    virtual void AddYawInput(float Val);
    /** Add Roll input. Degrees. */
    UFUNCTION(BlueprintCallable, Category = "Game|Player")
    virtual void AddRollInput(float Val);
    /** Updates the rotation of player, based on ControlRotation after RotationInput has been applied. */
    virtual void UpdateRotation(float DeltaTime);
    /** Called each frame to process input, also while the game is paused. */
    virtual void PlayerTick(float DeltaTime);
    /** Helper to get the size of the viewport, in pixels. Returns 0, 0 if there is no viewport. */
    UFUNCTION(BlueprintCallable, Category = "Game|Player")
    void GetViewportSize(int32& SizeX, int32& SizeY) const;

    /** The pawn; there are no spectator pawns beside it here. */
    APawn* GetPawnOrSpectator() const { return GetPawn(); }

    // AController
    virtual void SetPawn(APawn* InPawn) override;
    virtual AActor* GetViewTarget() const override;
    virtual void GetPlayerViewPoint(FVector& Location, FRotator& Rotation) const override;
    virtual void InitPlayerState() override;

    // AActor
    virtual void PostInitializeComponents() override;
    virtual void TickActor(float DeltaTime, ELevelTick TickType, FActorTickFunction& ThisTickFunction) override;
    virtual void Destroyed() override;
    virtual void Reset() override;

protected:
    virtual void OnPossess(APawn* InPawn) override;
    virtual void OnUnPossess() override;
};
