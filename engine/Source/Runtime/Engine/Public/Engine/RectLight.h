// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Engine/Light.h"
#include "UObject/ObjectMacros.h"

#include "RectLight.generated.h"

class URectLightComponent;

/** An actor with a rectangular light. Epic page: ARectLight. */
UCLASS(ClassGroup = Lights, ComponentWrapperClass, meta = (ChildCanTick))
class ENGINE_API ARectLight : public ALight {
    GENERATED_BODY()

private:
    /** The light. */
    UPROPERTY(Category = Light, VisibleAnywhere, BlueprintReadOnly,
        meta = (ExposeFunctionCategories = "Light,Rendering|Lighting", AllowPrivateAccess = "true"))
    TObjectPtr<URectLightComponent> RectLightComponent;

public:
    ARectLight(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** The light. */
    URectLightComponent* GetRectLightComponent() const { return RectLightComponent; }
};
