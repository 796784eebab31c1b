// SPDX-License-Identifier: MIT
/** @file The camera of a player. Mirrors UE's Camera/PlayerCameraManager.h. */
#pragma once

#include "Camera/CameraTypes.h"
#include "CoreMinimal.h"
#include "GameFramework/Actor.h"
#include "UObject/ObjectMacros.h"

#include "PlayerCameraManager.generated.h"

class APawn;
class APlayerController;
class APlayerState;
class USceneComponent;

/** Options that define how to blend when changing view targets. */
UENUM()
enum EViewTargetBlendFunction : int {
    /** Camera does a simple linear interpolation. */
    VTBlend_Linear,
    /** Camera has a slight ease in and ease out, but amount of ease cannot be tweaked. */
    VTBlend_Cubic,
    /** Camera immediately accelerates, but smoothly decelerates into the target. Ease amount controlled by BlendExp. */
    VTBlend_EaseIn,
    /** Camera smoothly accelerates, but does not decelerate into the target. Ease amount controlled by BlendExp. */
    VTBlend_EaseOut,
    /** Camera smoothly accelerates and decelerates. Ease amount controlled by BlendExp. */
    VTBlend_EaseInOut,
    /** The game's camera system has already performed the blending. Engine should not blend at all. */
    VTBlend_PreBlended,
    VTBlend_MAX,
};

/** Cached camera POV info, stored as optimization so we only need to do a full camera update once per tick. */
USTRUCT()
struct FCameraCacheEntry {
    GENERATED_BODY()

    /** World time this entry was created. */
    UPROPERTY()
    float TimeStamp;

    /** Camera POV to cache. */
    UPROPERTY()
    FMinimalViewInfo POV;

    FCameraCacheEntry() : TimeStamp(0.f) {}
};

/** A ViewTarget is the primary actor the camera is associated with. */
USTRUCT(BlueprintType)
struct FTViewTarget {
    GENERATED_BODY()

    /** Target Actor used to compute POV. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = TViewTarget)
    TObjectPtr<AActor> Target;

    /** Computed point of view. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = TViewTarget)
    FMinimalViewInfo POV;

    /** PlayerState (used to follow same player through pawn transitions, etc., when spectating). */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = TViewTarget)
    TObjectPtr<APlayerState> PlayerState;

    FTViewTarget() : Target(nullptr), PlayerState(nullptr) {}

    /** Changes the target, telling both. */
    ENGINE_API void SetNewTarget(AActor* NewTarget);
    /** Make sure ViewTarget is valid: falls back to the owning player controller. */
    ENGINE_API void CheckViewTarget(APlayerController* OwningController);
    /** The pawn that is the target, or that of the target controller. */
    ENGINE_API APawn* GetTargetPawn() const;
};

/** A set of parameters to describe how to transition between view targets. */
USTRUCT()
struct FViewTargetTransitionParams {
    GENERATED_BODY()

    /** Total duration of blend to pending view target, in seconds. 0 means no blending. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = ViewTargetTransitionParams)
    float BlendTime;

    /** Function to apply to the blend parameter. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = ViewTargetTransitionParams)
    TEnumAsByte<EViewTargetBlendFunction> BlendFunction;

    /** Exponent, used by certain blend functions to control the shape of the curve. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = ViewTargetTransitionParams)
    float BlendExp;

    /** If true, lock outgoing viewtarget to last frame's camera POV for the remainder of the blend. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = ViewTargetTransitionParams)
    uint32 bLockOutgoing : 1;

    FViewTargetTransitionParams() : BlendTime(0.f), BlendFunction(VTBlend_Cubic), BlendExp(2.f), bLockOutgoing(false) {}

    /** For a given linear blend value (blend percentage), return the final blend alpha with the requested function
     * applied. */
    ENGINE_API float GetBlendAlpha(const float& TimePct) const;
};

/**
 * A PlayerCameraManager is responsible for managing the camera for a particular player. It defines the final view
 * properties used by other systems (e.g. the renderer), meaning you can think of it as your virtual eyeball in the
 * world. It can compute the final camera properties directly, or it can arbitrate/blend between other objects or actors
 * that influence the camera.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Camera/APlayerCameraManager
 */
UCLASS(NotPlaceable, Transient, BlueprintType, Blueprintable, config = Engine)
class ENGINE_API APlayerCameraManager : public AActor {
    GENERATED_BODY()

public:
    APlayerCameraManager(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** PlayerController that owns this Camera actor. */
    UPROPERTY()
    TObjectPtr<APlayerController> PCOwner;

    /** FOV to use by default, in degrees. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = PlayerCameraManager)
    float DefaultFOV;

    /** Value to lock FOV to, in degrees. 0: not locked. */
    UPROPERTY()
    float LockedFOV;

    /** Current ViewTarget. */
    UPROPERTY(Transient)
    FTViewTarget ViewTarget;

    /** Pending view target for blending. */
    UPROPERTY(Transient)
    FTViewTarget PendingViewTarget;

    /** Time remaining in viewtarget blend, in seconds. */
    float BlendTimeToGo;

    /** Current view target transition blend parameters. */
    FViewTargetTransitionParams BlendParams;

    /** Minimum view pitch, in degrees. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = PlayerCameraManager)
    float ViewPitchMin;
    /** Maximum view pitch, in degrees. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = PlayerCameraManager)
    float ViewPitchMax;
    /** Minimum view yaw, in degrees. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = PlayerCameraManager)
    float ViewYawMin;
    /** Maximum view yaw, in degrees. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = PlayerCameraManager)
    float ViewYawMax;
    /** Minimum view roll, in degrees. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = PlayerCameraManager)
    float ViewRollMin;
    /** Maximum view roll, in degrees. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = PlayerCameraManager)
    float ViewRollMax;

    /** Initialize this PlayerCameraManager for the given associated PlayerController. */
    virtual void InitializeFor(APlayerController* PC);
    /** Sets a new ViewTarget. */
    virtual void SetViewTarget(
        AActor* NewViewTarget, FViewTargetTransitionParams TransitionParams = FViewTargetTransitionParams());
    /** Returns the current ViewTarget. */
    virtual AActor* GetViewTarget() const;
    /** Returns the PlayerController that owns this camera. */
    UFUNCTION(BlueprintCallable, Category = "Game|Player")
    virtual APlayerController* GetOwningPlayerController() const;

    /** Performs per-tick camera update. Called once per tick after all other actors have been ticked. */
    virtual void UpdateCamera(float DeltaTime);
    /** Primary function to retrieve Camera's actual view point. */
    void GetCameraViewPoint(FVector& OutCamLoc, FRotator& OutCamRot) const;
    /** Returns camera's current rotation, in degrees. */
    UFUNCTION(BlueprintCallable, Category = "Camera", meta = (Keywords = "View Direction"))
    FRotator GetCameraRotation() const;
    /** Returns camera's current location, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Camera", meta = (Keywords = "View Position"))
    FVector GetCameraLocation() const;
    /** Returns the camera's current full FOV angle, in degrees. */
    UFUNCTION(BlueprintCallable, Category = "Camera")
    virtual float GetFOVAngle() const;
    /** Locks FOV to the given value, in degrees. 0 unlocks. */
    virtual void SetFOV(float NewFOV);
    /** Unlocks the FOV. */
    virtual void UnlockFOV();
    /** Returns the cached POV of this frame. */
    virtual const FMinimalViewInfo& GetCameraCacheView() const { return CameraCachePrivate.POV; }
    /** The POV of the previous frame. */
    virtual const FMinimalViewInfo& GetLastFrameCameraCacheView() const { return LastFrameCameraCachePrivate.POV; }
    /** Limits the view pitch, yaw and roll of the view rotation, which DeltaRot is added to first. */
    virtual void ProcessViewRotation(float DeltaTime, FRotator& OutViewRotation, FRotator& OutDeltaRot);

    // AActor
    virtual void PostInitializeComponents() override;
    virtual void Destroyed() override;

protected:
    /** Calculates an updated POV for the given viewtarget. */
    virtual void UpdateViewTarget(FTViewTarget& OutVT, float DeltaTime);
    /** Internal. Creates and initializes a new camera POV cache. */
    virtual void FillCameraCache(const FMinimalViewInfo& NewInfo);

private:
    /** Cached camera properties. */
    UPROPERTY(Transient)
    FCameraCacheEntry CameraCachePrivate;

    /** Cached camera properties, one frame old. */
    UPROPERTY(Transient)
    FCameraCacheEntry LastFrameCameraCachePrivate;
};
