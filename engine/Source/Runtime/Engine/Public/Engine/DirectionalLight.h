// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Engine/Light.h"
#include "UObject/ObjectMacros.h"

#include "DirectionalLight.generated.h"

class UDirectionalLightComponent;

/** An actor with a directional light: the sun or the moon. Epic page: ADirectionalLight. */
UCLASS(ClassGroup = Lights, ComponentWrapperClass, meta = (ChildCanTick))
class ENGINE_API ADirectionalLight : public ALight {
    GENERATED_BODY()

public:
    ADirectionalLight(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** The light. */
    UDirectionalLightComponent* GetComponent() const;
};
