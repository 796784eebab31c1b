// SPDX-License-Identifier: MIT
#pragma once

#include "Components/ShapeComponent.h"
#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

#include "BoxComponent.generated.h"

/** A box for simple collision. Epic page: UBoxComponent. */
UCLASS(ClassGroup = "Collision", HideCategories = (Object, LOD, Lighting, TextureStreaming),
    meta = (DisplayName = "Box Collision", BlueprintSpawnableComponent))
class ENGINE_API UBoxComponent : public UShapeComponent {
    GENERATED_BODY()

protected:
    /** The extents (radii dimensions) of the box, in centimetres, before the component's scale. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Shape)
    FVector BoxExtent;

public:
    UBoxComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Changes the box extent. This is the unscaled size, before the component scale is applied. */
    UFUNCTION(BlueprintCallable, Category = "Components|Box")
    void SetBoxExtent(FVector InBoxExtent, bool bUpdateOverlaps = true);

    /** Returns the box extents scaled by the component scale, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Components|Box")
    FVector GetScaledBoxExtent() const;

    /** Returns the box extent, ignoring the component scale, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Components|Box")
    FVector GetUnscaledBoxExtent() const;

    /** Sets the property without the side effects. */
    void InitBoxExtent(const FVector& InBoxExtent) { BoxExtent = InBoxExtent; }

    virtual FBoxSphereBounds CalcBounds(const FTransform& LocalToWorld) const override;
};
