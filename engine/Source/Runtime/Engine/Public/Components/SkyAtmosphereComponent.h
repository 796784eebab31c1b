// SPDX-License-Identifier: MIT
#pragma once

#include "Components/SceneComponent.h"
#include "CoreMinimal.h"
#include "GameFramework/Info.h"
#include "UObject/ObjectMacros.h"

#include "SkyAtmosphereComponent.generated.h"

/** Where the planet of a sky atmosphere is. Epic page: ESkyAtmosphereTransformMode. */
UENUM()
enum class ESkyAtmosphereTransformMode : uint8 {
    /** The top of the planet is at the world's origin. */
    PlanetTopAtAbsoluteWorldOrigin,
    /** The top of the planet is at the component. */
    PlanetTopAtComponentTransform,
    /** The centre of the planet is at the component. */
    PlanetCenterAtComponentTransform
};

/** The air that makes the sky blue, lit by directional lights with bAtmosphereSunLight. Epic page:
 * USkyAtmosphereComponent. */
UCLASS(ClassGroup = Rendering, HideCategories = (Object, Mobility, Activation, "Components|Activation"), EditInlineNew,
    meta = (BlueprintSpawnableComponent))
class ENGINE_API USkyAtmosphereComponent : public USceneComponent {
    GENERATED_BODY()

public:
    /** Where the planet is. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = "Planet")
    ESkyAtmosphereTransformMode TransformMode;

    /** The radius of the planet from its centre to the ground, in kilometres. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = "Planet",
        meta = (DisplayName = "Ground Radius", UIMin = 1.0, UIMax = 7000.0, ClampMin = 0.1, ClampMax = 10000.0,
            SliderExponent = 5.0))
    float BottomRadius;

    /** The ground albedo that tints the light bouncing off the ground. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = "Planet", meta = (HideAlphaChannel))
    FColor GroundAlbedo;

    /** The height of the atmosphere layer above the ground, in kilometres. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Interp, Category = "Atmosphere",
        meta = (UIMin = 1.0, UIMax = 200.0, ClampMin = 0.1, SliderExponent = 2.0))
    float AtmosphereHeight;

    /** Factor on the multiple scattering: 1 is physical. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Interp, Category = "Atmosphere",
        meta = (DisplayName = "MultiScattering", UIMin = 0.0, UIMax = 2.0, ClampMin = 0.0, ClampMax = 100.0))
    float MultiScatteringFactor;

    /** Rayleigh scattering coefficient scale, per kilometre. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Interp, Category = "Atmosphere - Rayleigh",
        meta = (DisplayName = "Rayleigh Scattering Scale", UIMin = 0.0, UIMax = 2.0, ClampMin = 0.0,
            SliderExponent = 4.0))
    float RayleighScatteringScale;

    /** The Rayleigh scattering coefficients resulting from molecules in the air, relative to each other. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Interp, Category = "Atmosphere - Rayleigh", meta = (HideAlphaChannel))
    FLinearColor RayleighScattering;

    /** The altitude at which the Rayleigh scattering effect is reduced to 40 %, in kilometres. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Interp, Category = "Atmosphere - Rayleigh",
        meta = (UIMin = 0.01, UIMax = 20.0, ClampMin = 0.001, SliderExponent = 5.0))
    float RayleighExponentialDistribution;

    /** Mie scattering coefficient scale, per kilometre. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Interp, Category = "Atmosphere - Mie",
        meta = (DisplayName = "Mie Scattering Scale", UIMin = 0.0, UIMax = 5.0, ClampMin = 0.0, SliderExponent = 10.0))
    float MieScatteringScale;

    /** The phase function's eccentricity: 0 scatters all round, 1 only forward. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Interp, Category = "Atmosphere - Mie",
        meta = (UIMin = 0.0, UIMax = 0.999, ClampMin = 0.0, ClampMax = 0.999))
    float MieAnisotropy;

    /** The altitude at which the Mie effects are reduced to 40 %, in kilometres. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Interp, Category = "Atmosphere - Mie",
        meta = (UIMin = 0.01, UIMax = 10.0, ClampMin = 0.001, SliderExponent = 5.0))
    float MieExponentialDistribution;

    USkyAtmosphereComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Sets the planet's radius, in kilometres. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetBottomRadius(float NewValue);

    /** Sets the ground albedo. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetGroundAlbedo(const FColor& NewValue);

    /** Sets the height of the atmosphere, in kilometres. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetAtmosphereHeight(float NewValue);

    /** Sets the factor on the multiple scattering. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetMultiScatteringFactor(float NewValue);

    /** Sets the Rayleigh scattering scale. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetRayleighScatteringScale(float NewValue);

    /** Sets the Rayleigh scattering coefficients. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetRayleighScattering(FLinearColor NewValue);

    /** Sets the altitude of the Rayleigh distribution, in kilometres. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetRayleighExponentialDistribution(float NewValue);

    /** Sets the Mie scattering scale. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetMieScatteringScale(float NewValue);

    /** Sets the eccentricity of the Mie phase function. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetMieAnisotropy(float NewValue);

    /** Sets the altitude of the Mie distribution, in kilometres. */
    UFUNCTION(BlueprintCallable, Category = "Rendering")
    void SetMieExponentialDistribution(float NewValue);
};

/** An actor with a sky atmosphere. Epic page: ASkyAtmosphere. */
UCLASS(ShowCategories = (Movement, Rendering, Transformation), ClassGroup = Fog, HideCategories = (Info, Object, Input))
class ENGINE_API ASkyAtmosphere : public AInfo {
    GENERATED_BODY()

private:
    /** The atmosphere. */
    UPROPERTY(Category = Atmosphere, VisibleAnywhere, BlueprintReadOnly,
        meta = (ExposeFunctionCategories = "Rendering", AllowPrivateAccess = "true"))
    TObjectPtr<USkyAtmosphereComponent> SkyAtmosphereComponent;

public:
    ASkyAtmosphere(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** The atmosphere. */
    USkyAtmosphereComponent* GetComponent() const { return SkyAtmosphereComponent; }
};
