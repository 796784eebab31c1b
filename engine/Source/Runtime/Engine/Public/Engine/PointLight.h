// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Engine/Light.h"
#include "UObject/ObjectMacros.h"

#include "PointLight.generated.h"

class UPointLightComponent;

/** An actor with a point light. Epic page: APointLight. */
UCLASS(ClassGroup = Lights, ComponentWrapperClass, meta = (ChildCanTick))
class ENGINE_API APointLight : public ALight {
    GENERATED_BODY()

private:
    /** The light. */
    UPROPERTY(Category = Light, VisibleAnywhere, BlueprintReadOnly,
        meta = (ExposeFunctionCategories = "Light,Rendering|Lighting", AllowPrivateAccess = "true"))
    TObjectPtr<UPointLightComponent> PointLightComponent;

public:
    APointLight(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** The light. */
    UPointLightComponent* GetPointLightComponent() const { return PointLightComponent; }

    /** Sets the radius of the light, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetRadius(float NewRadius);

    /** Sets the falloff exponent of the light. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetLightFalloffExponent(float NewLightFalloffExponent);
};
