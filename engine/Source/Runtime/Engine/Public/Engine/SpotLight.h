// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Engine/Light.h"
#include "UObject/ObjectMacros.h"

#include "SpotLight.generated.h"

class USpotLightComponent;

/** An actor with a spot light. Epic page: ASpotLight. */
UCLASS(ClassGroup = Lights, ComponentWrapperClass, meta = (ChildCanTick))
class ENGINE_API ASpotLight : public ALight {
    GENERATED_BODY()

private:
    /** The light. */
    UPROPERTY(Category = Light, VisibleAnywhere, BlueprintReadOnly,
        meta = (ExposeFunctionCategories = "Light,Rendering|Lighting", AllowPrivateAccess = "true"))
    TObjectPtr<USpotLightComponent> SpotLightComponent;

public:
    ASpotLight(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** The light. */
    USpotLightComponent* GetSpotLightComponent() const { return SpotLightComponent; }

    /** Sets the inner cone angle of the light, in degrees. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetInnerConeAngle(float NewInnerConeAngle);

    /** Sets the outer cone angle of the light, in degrees. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetOuterConeAngle(float NewOuterConeAngle);
};
