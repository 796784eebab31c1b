// SPDX-License-Identifier: MIT
#pragma once

#include "Components/PrimitiveComponent.h"
#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

#include "ArrowComponent.generated.h"

/** An arrow along the local X axis, to mark a direction. Hidden in game by default. Epic page: UArrowComponent. */
UCLASS(ClassGroup = Utility,
    HideCategories = (Object, LOD, Physics, Lighting, TextureStreaming, Activation, "Components|Activation", Collision),
    EditInlineNew, meta = (BlueprintSpawnableComponent))
class ENGINE_API UArrowComponent : public UPrimitiveComponent {
    GENERATED_BODY()

public:
    /** Colour to draw the arrow. */
    UPROPERTY(BlueprintReadOnly, EditAnywhere, Category = ArrowComponent)
    FColor ArrowColor;

    /** Relative size to scale the drawn arrow by. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = ArrowComponent)
    float ArrowSize;

    /** Total length of the drawn arrow including the head, in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = ArrowComponent)
    float ArrowLength;

    UArrowComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Updates the arrow's colour, linear. */
    UFUNCTION(BlueprintCallable, DisplayName = "SetArrowColor", Category = "Components|Arrow")
    virtual void SetArrowColor(FLinearColor NewColor);

    /** Updates the arrow's size. */
    UFUNCTION(BlueprintCallable, Category = "Components|Arrow")
    virtual void SetArrowSize(float NewSize);

    /** Updates the arrow's length, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Components|Arrow")
    virtual void SetArrowLength(float NewLength);

    virtual FBoxSphereBounds CalcBounds(const FTransform& LocalToWorld) const override;
};
