// SPDX-License-Identifier: MIT
#pragma once

#include "Components/LightComponentBase.h"
#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

#include "SkyLightComponent.generated.h"

/** Light from everything far away: the sky. Epic page: USkyLightComponent. */
UCLASS(Blueprintable, ClassGroup = Lights, HideCategories = (Trigger, Activation, "Components|Activation", Physics),
    meta = (BlueprintSpawnableComponent))
class ENGINE_API USkyLightComponent : public ULightComponentBase {
    GENERATED_BODY()

public:
    /** Distance from the sky light at which any geometry should be treated as part of the sky, in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Light)
    float SkyDistanceThreshold;

    /** Whether all distant lighting from the lower hemisphere should be set to LowerHemisphereColor. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Light, AdvancedDisplay,
        meta = (DisplayName = "Lower Hemisphere Is Solid Color"))
    uint8 bLowerHemisphereIsBlack : 1;

    /** The colour of the lower hemisphere, linear. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Light, AdvancedDisplay)
    FLinearColor LowerHemisphereColor;

    USkyLightComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Sets the brightness of the light. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|SkyLight")
    void SetIntensity(float NewIntensity);

    /** Sets the scale of the indirect lighting. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|SkyLight")
    void SetIndirectLightingIntensity(float NewIntensity);

    /** Sets the scale of the volumetric scattering. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|SkyLight")
    void SetVolumetricScatteringIntensity(float NewIntensity);

    /** Sets the colour of the light, linear. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|SkyLight")
    void SetLightColor(FLinearColor NewLightColor);

    /** Sets the colour of the lower hemisphere, linear. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Components|SkyLight")
    void SetLowerHemisphereColor(const FLinearColor& InLowerHemisphereColor);
};
