// SPDX-License-Identifier: MIT
#pragma once

#include "Camera/CameraTypes.h"
#include "Components/SceneComponent.h"
#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

#include "CameraComponent.generated.h"

/** A point of view and a lens; actors that have an active one are seen through it. It looks along the local X axis.
 * Epic page: UCameraComponent. */
UCLASS(HideCategories = (Mobility, Rendering, LOD), Blueprintable, ClassGroup = Camera,
    meta = (BlueprintSpawnableComponent))
class ENGINE_API UCameraComponent : public USceneComponent {
    GENERATED_BODY()

public:
    /** The horizontal field of view, in degrees, in perspective mode (ignored in orthographic mode). */
    UPROPERTY(Interp, EditAnywhere, BlueprintReadWrite, Category = CameraSettings,
        meta = (UIMin = "5.0", UIMax = "170", ClampMin = "0.001", ClampMax = "360.0", Units = deg))
    float FieldOfView;

    /** The desired width of the orthographic view, in centimetres (ignored in perspective mode). */
    UPROPERTY(Interp, EditAnywhere, BlueprintReadWrite, Category = CameraSettings)
    float OrthoWidth;

    /** The near plane distance of the orthographic view, in centimetres. */
    UPROPERTY(Interp, EditAnywhere, BlueprintReadWrite, Category = CameraSettings)
    float OrthoNearClipPlane;

    /** The far plane distance of the orthographic view, in centimetres. */
    UPROPERTY(Interp, EditAnywhere, BlueprintReadWrite, Category = CameraSettings)
    float OrthoFarClipPlane;

    /** Aspect ratio (width over height). */
    UPROPERTY(Interp, EditAnywhere, BlueprintReadWrite, Category = CameraSettings,
        meta = (ClampMin = "0.1", ClampMax = "100.0", EditCondition = "bConstrainAspectRatio"))
    float AspectRatio;

    /** If true, black bars will be added if the destination view has a different aspect ratio than this camera
     * requested. */
    UPROPERTY(Interp, EditAnywhere, BlueprintReadWrite, Category = CameraOptions)
    uint8 bConstrainAspectRatio : 1;

    /** If true, account for the field of view angle when computing which level of detail to use for meshes. */
    UPROPERTY(Interp, EditAnywhere, BlueprintReadWrite, AdvancedDisplay, Category = CameraOptions)
    uint8 bUseFieldOfViewForLOD : 1;

    /** If this camera component is placed on a pawn, should it use the view/control rotation of the pawn where
     * possible? */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = CameraOptions)
    uint8 bUsePawnControlRotation : 1;

    /** The type of camera. */
    UPROPERTY(Interp, EditAnywhere, BlueprintReadWrite, Category = CameraSettings)
    TEnumAsByte<ECameraProjectionMode::Type> ProjectionMode;

    UCameraComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Sets the horizontal field of view, in degrees. */
    UFUNCTION(BlueprintCallable, Category = Camera)
    virtual void SetFieldOfView(float InFieldOfView);

    /** Sets the width of the orthographic view, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = Camera)
    void SetOrthoWidth(float InOrthoWidth);

    /** Sets the near plane distance of the orthographic view, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = Camera)
    void SetOrthoNearClipPlane(float InOrthoNearClipPlane);

    /** Sets the far plane distance of the orthographic view, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = Camera)
    void SetOrthoFarClipPlane(float InOrthoFarClipPlane);

    /** Sets the aspect ratio. */
    UFUNCTION(BlueprintCallable, Category = Camera)
    void SetAspectRatio(float InAspectRatio);

    /** Sets whether the aspect ratio is constrained. */
    UFUNCTION(BlueprintCallable, Category = Camera)
    void SetConstraintAspectRatio(bool bInConstrainAspectRatio);

    /** Sets whether the field of view counts for the level of detail. */
    UFUNCTION(BlueprintCallable, Category = Camera)
    void SetUseFieldOfViewForLOD(bool bInUseFieldOfViewForLOD);

    /** Sets the type of camera. */
    UFUNCTION(BlueprintCallable, Category = Camera)
    void SetProjectionMode(ECameraProjectionMode::Type InProjectionMode);

    /**
     * Returns the camera's point of view.
     * @param DeltaTime   time since the last frame, in seconds
     * @param DesiredView receives the view
     */
    UFUNCTION(BlueprintCallable, Category = Camera)
    virtual void GetCameraView(float DeltaTime, FMinimalViewInfo& DesiredView);
};
