// SPDX-License-Identifier: MIT
#pragma once

#include "Components/ShapeComponent.h"
#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

#include "SphereComponent.generated.h"

/** A sphere for simple collision. Under non-uniform scale its radius follows the smallest axis. Epic page:
 * USphereComponent. */
UCLASS(ClassGroup = "Collision", EditInlineNew, HideCategories = (Object, LOD, Lighting, TextureStreaming),
    meta = (DisplayName = "Sphere Collision", BlueprintSpawnableComponent))
class ENGINE_API USphereComponent : public UShapeComponent {
    GENERATED_BODY()

protected:
    /** The radius of the sphere, in centimetres, before the component's scale. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Shape, meta = (ClampMin = "0", UIMin = "0"))
    float SphereRadius;

public:
    USphereComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Changes the sphere radius. This is the unscaled radius, before the component scale is applied. */
    UFUNCTION(BlueprintCallable, Category = "Components|Sphere")
    void SetSphereRadius(float InSphereRadius, bool bUpdateOverlaps = true);

    /** Returns the radius of the sphere with the component scale applied, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Components|Sphere")
    float GetScaledSphereRadius() const;

    /** Returns the radius of the sphere, ignoring the component scale, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Components|Sphere")
    float GetUnscaledSphereRadius() const;

    /** Gets the scale used by this shape: the smallest absolute component of the world scale. */
    UFUNCTION(BlueprintCallable, Category = "Components|Sphere")
    float GetShapeScale() const;

    /** Sets the property without the side effects. */
    void InitSphereRadius(float InSphereRadius) { SphereRadius = InSphereRadius; }

    virtual FBoxSphereBounds CalcBounds(const FTransform& LocalToWorld) const override;
};
