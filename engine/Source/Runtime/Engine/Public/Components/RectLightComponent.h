// SPDX-License-Identifier: MIT
#pragma once

#include "Components/LocalLightComponent.h"
#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

#include "RectLightComponent.generated.h"

class UTexture;

/** A light from a rectangle in the local YZ plane that shines along the local X axis. Epic page: URectLightComponent.
 */
UCLASS(Blueprintable, ClassGroup = (Lights), HideCategories = (Object, LightShafts), EditInlineNew,
    meta = (BlueprintSpawnableComponent))
class ENGINE_API URectLightComponent : public ULocalLightComponent {
    GENERATED_BODY()

public:
    /** Width of the light source rectangle (local Y), in centimetres. */
    UPROPERTY(Interp, EditAnywhere, BlueprintReadOnly, Category = Light, meta = (UIMin = "0.0", UIMax = "1000.0"))
    float SourceWidth;

    /** Height of the light source rectangle (local Z), in centimetres. */
    UPROPERTY(Interp, EditAnywhere, BlueprintReadOnly, Category = Light, meta = (UIMin = "0.0", UIMax = "1000.0"))
    float SourceHeight;

    /** Angle of the barn doors attached to the rectangle, in degrees. */
    UPROPERTY(
        EditAnywhere, BlueprintReadOnly, AdvancedDisplay, Category = Light, meta = (UIMin = "0.0", UIMax = "90.0"))
    float BarnDoorAngle;

    /** Length of the barn doors attached to the rectangle, in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, AdvancedDisplay, Category = Light, meta = (UIMin = "0.0"))
    float BarnDoorLength;

    /** Texture mapped to the light source rectangle. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Light)
    TObjectPtr<UTexture> SourceTexture;

    URectLightComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Sets the texture mapped to the rectangle. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetSourceTexture(UTexture* bNewValue);

    /** Sets the width of the rectangle, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetSourceWidth(float bNewValue);

    /** Sets the height of the rectangle, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetSourceHeight(float NewValue);

    /** Sets the angle of the barn doors, in degrees. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetBarnDoorAngle(float NewValue);

    /** Sets the length of the barn doors, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetBarnDoorLength(float NewValue);

    virtual float ComputeLightBrightness() const override;
};
