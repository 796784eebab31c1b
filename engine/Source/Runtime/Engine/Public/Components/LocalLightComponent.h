// SPDX-License-Identifier: MIT
#pragma once

#include "Components/LightComponent.h"
#include "CoreMinimal.h"
#include "Engine/Scene.h"
#include "UObject/ObjectMacros.h"

#include "LocalLightComponent.generated.h"

/** A light with a place and a reach: point, spot and rectangular lights. Epic page: ULocalLightComponent. */
UCLASS(Abstract, ClassGroup = (Lights), HideCategories = (Object, LightShafts), EditInlineNew)
class ENGINE_API ULocalLightComponent : public ULightComponent {
    GENERATED_BODY()

public:
    /** Units used for the intensity. The peak luminous intensity is measured in candelas, the luminous power in lumens.
     */
    UPROPERTY(
        EditAnywhere, BlueprintReadOnly, AdvancedDisplay, Category = Light, meta = (DisplayName = "Intensity Units"))
    ELightUnits IntensityUnits;

    /** Blend factor for the inverse exposure, for lights that ignore exposure. 0 is physical. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, AdvancedDisplay, Category = Light,
        meta = (ClampMin = "0.0", ClampMax = "1.0", UIMin = "0.0", UIMax = "1.0"))
    float InverseExposureBlend;

    /** Bounds the light's visible influence, in centimetres. This clamping of the influence is not physically correct.
     */
    UPROPERTY(Interp, BlueprintReadOnly, EditAnywhere, Category = Light,
        meta = (SliderExponent = 5.0, ClampMin = "0.0", UIMin = "8.0", UIMax = "16384.0", ShouldShowInViewport = true))
    float AttenuationRadius;

    ULocalLightComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Sets the attenuation radius, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetAttenuationRadius(float NewRadius);

    /** Sets the units used for the intensity; the number itself stays. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetIntensityUnits(ELightUnits NewIntensityUnits);

    /** Sets the blend factor for the inverse exposure. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetInverseExposureBlend(float NewInverseExposureBlend);

    /**
     * Factor between two units of intensity. EV is logarithmic, no factor leads there or from there: the result is 1.
     * @param CosHalfConeAngle cosine of half the cone the light fills: -1 for all directions; lumens depend on it
     */
    UFUNCTION(BlueprintPure, Category = "Rendering|Lighting")
    static float GetUnitsConversionFactor(ELightUnits SrcUnits, ELightUnits TargetUnits, float CosHalfConeAngle = -1);

    /** Cosine of half the angle that the light fills, by which lumens and candelas convert. */
    virtual float GetCosHalfConeAngleForUnits() const;

    // ULightComponent, USceneComponent
    virtual float ComputeLightBrightness() const override;
    virtual FBoxSphereBounds CalcBounds(const FTransform& LocalToWorld) const override;
};
