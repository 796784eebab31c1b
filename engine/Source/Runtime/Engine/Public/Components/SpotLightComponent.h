// SPDX-License-Identifier: MIT
#pragma once

#include "Components/PointLightComponent.h"
#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

#include "SpotLightComponent.generated.h"

/** A point light that shines in a cone along the local X axis. Epic page: USpotLightComponent. */
UCLASS(Blueprintable, ClassGroup = Lights, HideCategories = Object, EditInlineNew, meta = (BlueprintSpawnableComponent))
class ENGINE_API USpotLightComponent : public UPointLightComponent {
    GENERATED_BODY()

public:
    /** Half the angle of the cone of full intensity, in degrees. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Interp, Category = Light,
        meta = (UIMin = "1.0", UIMax = "80.0", ShouldShowInViewport = true))
    float InnerConeAngle;

    /** Half the angle of the cone outside which there is no light, in degrees. */
    UPROPERTY(Interp, EditAnywhere, BlueprintReadOnly, Category = Light,
        meta = (UIMin = "1.0", UIMax = "80.0", ShouldShowInViewport = true))
    float OuterConeAngle;

    USpotLightComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Sets the inner cone angle, in degrees. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetInnerConeAngle(float NewInnerConeAngle);

    /** Sets the outer cone angle, in degrees. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetOuterConeAngle(float NewOuterConeAngle);

    /** Half the angle of the cone in radians: the outer angle, at least the inner one and at most 89 degrees. */
    float GetHalfConeAngle() const;
    /** Cosine of GetHalfConeAngle. */
    float GetCosHalfConeAngle() const;

    virtual float GetCosHalfConeAngleForUnits() const override;
    virtual FBoxSphereBounds CalcBounds(const FTransform& LocalToWorld) const override;
};
