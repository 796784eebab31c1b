// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

#include "CameraTypes.generated.h"

/** How a camera projects. Epic page: ECameraProjectionMode::Type. */
UENUM()
namespace ECameraProjectionMode {
enum Type : int {
    /** Things get smaller with distance. */
    Perspective,
    /** Things keep their size. */
    Orthographic
};
}

/** Where a view is taken from and with which lens. Epic page: FMinimalViewInfo. */
USTRUCT(BlueprintType)
struct FMinimalViewInfo {
    GENERATED_BODY()

    /** Location of the view, in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Camera")
    FVector Location;

    /** Rotation of the view, in degrees. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Camera")
    FRotator Rotation;

    /** The horizontal field of view, in degrees, in perspective mode (ignored in orthographic mode). */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Camera")
    float FOV;

    /** The originally desired horizontal field of view before any adjustments for a different aspect ratio. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Camera")
    float DesiredFOV;

    /** The desired width of the orthographic view, in centimetres (ignored in perspective mode). */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Camera")
    float OrthoWidth;

    /** The near plane distance of the orthographic view, in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Camera")
    float OrthoNearClipPlane;

    /** The far plane distance of the orthographic view, in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Camera")
    float OrthoFarClipPlane;

    /** The near plane distance of the perspective view, in centimetres. Not positive: the engine's default. */
    UPROPERTY()
    float PerspectiveNearClipPlane;

    /** Aspect ratio (width over height). */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Camera")
    float AspectRatio;

    /** If true, black bars will be added if the destination view has a different aspect ratio than this camera
     * requested. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Camera")
    uint32 bConstrainAspectRatio : 1;

    /** The type of camera. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Camera")
    TEnumAsByte<ECameraProjectionMode::Type> ProjectionMode;

    FMinimalViewInfo()
        : Location(0.0, 0.0, 0.0), Rotation(0.0, 0.0, 0.0), FOV(90.0f), DesiredFOV(90.0f), OrthoWidth(512.0f),
          OrthoNearClipPlane(0.0f), OrthoFarClipPlane(2097152.0f), PerspectiveNearClipPlane(-1.0f),
          AspectRatio(1.33333333f), bConstrainAspectRatio(false), ProjectionMode(ECameraProjectionMode::Perspective) {}

    /** Whether two views are the same, within a small tolerance. */
    ENGINE_API bool Equals(const FMinimalViewInfo& OtherInfo) const;
    /** Blends towards another view by a weight from 0 (this) to 1 (the other). Rotations take the short way. */
    ENGINE_API void BlendViewInfo(FMinimalViewInfo& OtherInfo, float OtherWeight);
    /** Multiplies location, rotation and the lens's numbers by a weight. */
    ENGINE_API void ApplyBlendWeight(const float& Weight);
    /** Adds another view, already multiplied by its weight. */
    ENGINE_API void AddWeightedViewInfo(const FMinimalViewInfo& OtherView, const float& Weight);
};
