// SPDX-License-Identifier: MIT
#pragma once

#include "Components/ShapeComponent.h"
#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

#include "CapsuleComponent.generated.h"

/** A capsule along the local Z axis for simple collision. Epic page: UCapsuleComponent. */
UCLASS(ClassGroup = "Collision", EditInlineNew, HideCategories = (Object, LOD, Lighting, TextureStreaming),
    meta = (DisplayName = "Capsule Collision", BlueprintSpawnableComponent))
class ENGINE_API UCapsuleComponent : public UShapeComponent {
    GENERATED_BODY()

protected:
    /** Half-height, from the centre of the capsule to the end of its top or bottom hemisphere, in centimetres. Never
     * less than the radius. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Shape, meta = (ClampMin = "0", UIMin = "0"))
    float CapsuleHalfHeight;

    /** Radius of the cap hemispheres and of the centre cylinder, in centimetres. Never more than the half-height. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Shape, meta = (ClampMin = "0", UIMin = "0"))
    float CapsuleRadius;

public:
    UCapsuleComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Changes the capsule size. This is the unscaled size, before the component scale is applied. */
    UFUNCTION(BlueprintCallable, Category = "Components|Capsule")
    void SetCapsuleSize(float InRadius, float InHalfHeight, bool bUpdateOverlaps = true);

    /** Sets the capsule radius. This is the unscaled radius, before the component scale is applied. */
    UFUNCTION(BlueprintCallable, Category = "Components|Capsule")
    void SetCapsuleRadius(float Radius, bool bUpdateOverlaps = true);

    /** Sets the capsule half-height. This is the unscaled half-height, before the component scale is applied. */
    UFUNCTION(BlueprintCallable, Category = "Components|Capsule")
    void SetCapsuleHalfHeight(float HalfHeight, bool bUpdateOverlaps = true);

    /** Returns the capsule radius scaled by the component scale, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Components|Capsule")
    float GetScaledCapsuleRadius() const;

    /** Returns the capsule half-height scaled by the component scale, in centimetres, the hemispheres included. */
    UFUNCTION(BlueprintCallable, Category = "Components|Capsule")
    float GetScaledCapsuleHalfHeight() const;

    /** Returns the scaled half-height without the hemispheres. */
    UFUNCTION(BlueprintCallable, Category = "Components|Capsule")
    float GetScaledCapsuleHalfHeight_WithoutHemisphere() const;

    /** Returns the capsule radius and half-height scaled by the component scale. */
    UFUNCTION(BlueprintCallable, Category = "Components|Capsule")
    void GetScaledCapsuleSize(float& OutRadius, float& OutHalfHeight) const;

    /** Returns the capsule radius, ignoring the component scale, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Components|Capsule")
    float GetUnscaledCapsuleRadius() const;

    /** Returns the capsule half-height, ignoring the component scale, in centimetres, the hemispheres included. */
    UFUNCTION(BlueprintCallable, Category = "Components|Capsule")
    float GetUnscaledCapsuleHalfHeight() const;

    /** Returns the unscaled half-height without the hemispheres. */
    UFUNCTION(BlueprintCallable, Category = "Components|Capsule")
    float GetUnscaledCapsuleHalfHeight_WithoutHemisphere() const;

    /** Returns the capsule radius and half-height, ignoring the component scale. */
    UFUNCTION(BlueprintCallable, Category = "Components|Capsule")
    void GetUnscaledCapsuleSize(float& OutRadius, float& OutHalfHeight) const;

    /** Gets the scale used by this shape: the smallest absolute component of the world scale. */
    UFUNCTION(BlueprintCallable, Category = "Components|Capsule")
    float GetShapeScale() const;

    /** Sets the properties without the side effects. */
    void InitCapsuleSize(float InRadius, float InHalfHeight);

    virtual FBoxSphereBounds CalcBounds(const FTransform& LocalToWorld) const override;
};
