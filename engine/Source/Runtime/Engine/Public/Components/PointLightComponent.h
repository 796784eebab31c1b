// SPDX-License-Identifier: MIT
#pragma once

#include "Components/LocalLightComponent.h"
#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

#include "PointLightComponent.generated.h"

/** A light that shines in all directions from a small sphere or tube. Epic page: UPointLightComponent. */
UCLASS(Blueprintable, ClassGroup = (Lights), HideCategories = (Object, LightShafts), EditInlineNew,
    meta = (BlueprintSpawnableComponent))
class ENGINE_API UPointLightComponent : public ULocalLightComponent {
    GENERATED_BODY()

public:
    /** Whether to use physically based inverse squared distance falloff. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Light, AdvancedDisplay)
    uint32 bUseInverseSquaredFalloff : 1;

    /** Controls the radial falloff of the light when bUseInverseSquaredFalloff is false. */
    UPROPERTY(Interp, BlueprintReadOnly, EditAnywhere, Category = Light, AdvancedDisplay,
        meta = (UIMin = "2.0", UIMax = "16.0"))
    float LightFalloffExponent;

    /** Radius of the light source shape, in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Light)
    float SourceRadius;

    /** Soft radius of the light source shape, in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Light)
    float SoftSourceRadius;

    /** Length of the light source shape along the local Z axis, in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Light)
    float SourceLength;

    UPointLightComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Sets whether to use inverse squared distance falloff. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetUseInverseSquaredFalloff(bool bNewValue);

    /** Sets the radial falloff exponent. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetLightFalloffExponent(float NewLightFalloffExponent);

    /** Sets the radius of the light source shape, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetSourceRadius(float bNewValue);

    /** Sets the soft radius of the light source shape, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetSoftSourceRadius(float bNewValue);

    /** Sets the length of the light source shape, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetSourceLength(float NewValue);

    virtual float ComputeLightBrightness() const override;
};
