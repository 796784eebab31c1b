// SPDX-License-Identifier: MIT
#pragma once

#include "Components/SceneComponent.h"
#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

#include "LightComponentBase.generated.h"

/** What all lights, sky lights included, have in common. Epic page: ULightComponentBase. */
UCLASS(Abstract, HideCategories = (Trigger, Activation, "Components|Activation", Physics), ShowCategories = (Mobility))
class ENGINE_API ULightComponentBase : public USceneComponent {
    GENERATED_BODY()

public:
    /** Total energy that the light emits: lux for a directional light, else in the light's IntensityUnits. */
    UPROPERTY(BlueprintReadOnly, Interp, EditAnywhere, Category = Light,
        meta = (DisplayName = "Intensity", UIMin = "0.0", UIMax = "20.0"))
    float Intensity;

    /** Filter colour of the light (sRGB). Note that this can change the light's effective intensity. */
    UPROPERTY(BlueprintReadOnly, Interp, EditAnywhere, Category = Light, meta = (HideAlphaChannel))
    FColor LightColor;

    /** Whether the light can affect the world, or whether it is disabled. */
    UPROPERTY(BlueprintReadOnly, EditAnywhere, Category = Light, meta = (ShouldShowInViewport = true))
    uint8 bAffectsWorld : 1;

    /** Whether the light should cast any shadows. */
    UPROPERTY(BlueprintReadOnly, EditAnywhere, Category = Light, meta = (ShouldShowInViewport = true))
    uint8 CastShadows : 1;

    /** Whether the light should cast shadows from static objects. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Light, AdvancedDisplay)
    uint8 CastStaticShadows : 1;

    /** Whether the light should cast shadows from dynamic objects. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Light, AdvancedDisplay)
    uint8 CastDynamicShadows : 1;

    /** Whether the light affects translucency or not. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Light, AdvancedDisplay)
    uint8 bAffectTranslucentLighting : 1;

    /** Whether the light shows up in reflections. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = RayTracing)
    uint8 bAffectReflection : 1;

    /** Whether the light affects global illumination. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = RayTracing)
    uint8 bAffectGlobalIllumination : 1;

    /** Scales the indirect lighting contribution from this light. A value of 0 disables it. */
    UPROPERTY(BlueprintReadOnly, Interp, EditAnywhere, Category = Light, meta = (UIMin = "0.0", UIMax = "6.0"))
    float IndirectLightingIntensity;

    /** Intensity of the volumetric scattering from this light. This scales Intensity and LightColor. */
    UPROPERTY(BlueprintReadOnly, Interp, EditAnywhere, Category = Light, meta = (UIMin = "0.25", UIMax = "4.0"))
    float VolumetricScatteringIntensity;

    ULightComponentBase(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Sets whether this light casts shadows. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|Light")
    void SetCastShadows(bool bNewValue);

    /** Gets the light colour as a linear colour. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|Light")
    FLinearColor GetLightColor() const;

    /** Sets whether the light shows up in reflections. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|Light")
    void SetAffectReflection(bool bNewValue);

    /** Sets whether the light affects global illumination. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|Light")
    void SetAffectGlobalIllumination(bool bNewValue);

protected:
    /** Whether a setting that is baked for static lights may change now: not for a registered static light in a game.
     */
    bool AreDynamicDataChangesAllowed(bool bIgnoreStationary = true) const;
};
