// SPDX-License-Identifier: MIT
#pragma once

#include "Components/LightComponent.h"
#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

#include "DirectionalLightComponent.generated.h"

/** A light whose rays are parallel: the sun or the moon. Its intensity is in lux, its direction the local X axis. Epic
 * page: UDirectionalLightComponent. */
UCLASS(Blueprintable, ClassGroup = Lights, HideCategories = (Object, LightProfiles), EditInlineNew,
    meta = (BlueprintSpawnableComponent))
class ENGINE_API UDirectionalLightComponent : public ULightComponent {
    GENERATED_BODY()

public:
    /** Angle that the light source subtends, in degrees. The sun's is 0.5357. */
    UPROPERTY(BlueprintReadOnly, Interp, EditAnywhere, Category = Light,
        meta = (DisplayName = "Source Angle", UIMin = "0.0", UIMax = "5.0"))
    float LightSourceAngle;

    /** Angle that the soft light source subtends, in degrees. */
    UPROPERTY(BlueprintReadOnly, Interp, EditAnywhere, Category = Light,
        meta = (DisplayName = "Source Soft Angle", UIMin = "0.0", UIMax = "5.0"))
    float LightSourceSoftAngle;

    /** How far the dynamic shadows of a movable light reach, in centimetres. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = CascadedShadowMaps,
        meta = (UIMin = "0", UIMax = "20000", DisplayName = "Dynamic Shadow Distance MovableLight"))
    float DynamicShadowDistanceMovableLight;

    /** Whether the directional light can interact with the atmosphere: it draws the sun's disc and lights the sky. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = AtmosphereAndCloud,
        meta = (DisplayName = "Atmosphere Sun Light", ShouldShowInViewport = true))
    uint32 bAtmosphereSunLight : 1;

    /** Two atmosphere lights are supported: 0 is the sun, 1 for instance the moon. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = AtmosphereAndCloud, AdvancedDisplay,
        meta = (UIMin = "0", UIMax = "1", ClampMin = "0", ClampMax = "1"))
    int32 AtmosphereSunLightIndex;

    UDirectionalLightComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Sets the angle that the light source subtends, in degrees. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetLightSourceAngle(float NewValue);

    /** Sets the angle that the soft light source subtends, in degrees. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetLightSourceSoftAngle(float NewValue);

    /** Sets how far dynamic shadows reach, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetDynamicShadowDistanceMovableLight(float NewValue);

    /** Sets whether the light interacts with the atmosphere. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetAtmosphereSunLight(bool bNewValue);

    /** Sets which of the atmosphere's lights this is. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetAtmosphereSunLightIndex(int32 NewValue);
};
