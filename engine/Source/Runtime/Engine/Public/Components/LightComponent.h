// SPDX-License-Identifier: MIT
#pragma once

#include "Components/LightComponentBase.h"
#include "CoreMinimal.h"
#include "Engine/EngineTypes.h"
#include "UObject/ObjectMacros.h"

#include "LightComponent.generated.h"

/** A light that comes from a direction or a place (every light but the sky light). Epic page: ULightComponent. */
UCLASS(Abstract, HideCategories = (Trigger, Activation, "Components|Activation", Physics), ShowCategories = (Mobility))
class ENGINE_API ULightComponent : public ULightComponentBase {
    GENERATED_BODY()

public:
    /** Colour temperature in kelvin of the blackbody illuminant. White (D65) is 6500 K. */
    UPROPERTY(BlueprintReadOnly, Interp, EditAnywhere, Category = Light,
        meta = (UIMin = "1700.0", UIMax = "12000.0", ShouldShowInViewport = true, DisplayAfter = "bUseTemperature"))
    float Temperature;

    /** Distance at which the light is culled, in centimetres. 0 disables it. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Performance)
    float MaxDrawDistance;

    /** Distance over which the light fades before MaxDrawDistance, in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Performance)
    float MaxDistanceFadeRange;

    /** Whether the temperature, as a blackbody colour, multiplies the light colour. */
    UPROPERTY(BlueprintReadOnly, EditAnywhere, Category = Light,
        meta = (DisplayName = "Use Temperature", ShouldShowInViewport = true))
    uint32 bUseTemperature : 1;

    /** Controls how accurate self shadowing of the whole scene's shadows from this light is. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Light, AdvancedDisplay, meta = (UIMin = "0", UIMax = "1"))
    float ShadowBias;

    /** Controls how accurate self shadowing is on slopes. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Light, AdvancedDisplay, meta = (UIMin = "0", UIMax = "1"))
    float ShadowSlopeBias;

    /** Multiplier on specular highlights. Use only with great care: any value besides 1 is not physical. */
    UPROPERTY(
        BlueprintReadOnly, Interp, EditAnywhere, Category = Light, AdvancedDisplay, meta = (UIMin = "0", UIMax = "1"))
    float SpecularScale;

    /** Multiplier on diffuse lighting. Use only with great care: any value besides 1 is not physical. */
    UPROPERTY(
        BlueprintReadOnly, Interp, EditAnywhere, Category = Light, AdvancedDisplay, meta = (UIMin = "0", UIMax = "1"))
    float DiffuseScale;

    /** Channels that this light should affect. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, AdvancedDisplay, Category = Light)
    FLightingChannels LightingChannels;

    ULightComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Sets the intensity of the light, in the light's units. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|Light")
    void SetIntensity(float NewIntensity);

    /** Sets the scale of the indirect lighting. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|Light")
    void SetIndirectLightingIntensity(float NewIntensity);

    /** Sets the scale of the volumetric scattering. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|Light")
    void SetVolumetricScatteringIntensity(float NewIntensity);

    /**
     * Sets the colour of the light.
     * @param NewLightColor the colour, linear
     * @param bSRGB         whether to store it gamma-encoded (the usual; the component reads it that way)
     */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|Light")
    void SetLightColor(FLinearColor NewLightColor, bool bSRGB = true);

    /** Sets the colour of the light from an encoded (sRGB) colour. */
    void SetLightFColor(FColor NewLightColor);

    /** Sets the colour temperature of the light, in kelvin. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|Light")
    void SetTemperature(float NewTemperature);

    /** Sets whether the colour temperature counts. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|Light")
    void SetUseTemperature(bool bNewValue);

    /** Sets whether the light affects translucency. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|Light")
    void SetAffectTranslucentLighting(bool bNewValue);

    /** Sets the shadow bias. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|Light")
    void SetShadowBias(float NewValue);

    /** Sets the shadow slope bias. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|Light")
    void SetShadowSlopeBias(float NewValue);

    /** Sets the multiplier on specular highlights. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|Light")
    void SetSpecularScale(float NewValue);

    /** Sets the multiplier on diffuse lighting. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|Light")
    void SetDiffuseScale(float NewValue);

    /** Sets the lighting channels. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|Light")
    void SetLightingChannels(bool bChannel0, bool bChannel1, bool bChannel2);

    /** The direction the light points: its forward vector. */
    FVector GetDirection() const;
    /** The number that multiplies the colour: lux for a directional light, candelas times 100 squared (distances are in
     * centimetres) for the others. */
    virtual float ComputeLightBrightness() const;
    /** Colour with temperature and brightness counted, linear. */
    FLinearColor GetColoredLightBrightness() const;
    /** The colour of the temperature, linear. */
    FLinearColor GetColorTemperature() const;
};
