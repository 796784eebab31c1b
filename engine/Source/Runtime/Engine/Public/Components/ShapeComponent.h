// SPDX-License-Identifier: MIT
#pragma once

#include "Components/PrimitiveComponent.h"
#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

#include "ShapeComponent.generated.h"

/** Base of the simple shapes: box, sphere and capsule. Hidden in game by default. Epic page: UShapeComponent. */
UCLASS(Abstract, HideCategories = (Object, LOD, Lighting, TextureStreaming, Activation, "Components|Activation"),
    EditInlineNew, ShowCategories = (Mobility))
class ENGINE_API UShapeComponent : public UPrimitiveComponent {
    GENERATED_BODY()

public:
    /** Colour used to draw the shape. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Shape)
    FColor ShapeColor;

    UShapeComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

protected:
    /** To be called when the dimensions changed: refreshes the bounds. */
    void OnShapeChanged();
};
