// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Info.h"
#include "UObject/ObjectMacros.h"

#include "SkyLight.generated.h"

class USkyLightComponent;

/** An actor with a sky light. Epic page: ASkyLight. */
UCLASS(ClassGroup = Lights, HideCategories = (Input, Collision, Replication, Info),
    ShowCategories = ("Input|MouseInput", "Input|TouchInput"), ComponentWrapperClass, Blueprintable)
class ENGINE_API ASkyLight : public AInfo {
    GENERATED_BODY()

private:
    /** The light. */
    UPROPERTY(Category = Light, VisibleAnywhere, BlueprintReadOnly,
        meta = (ExposeFunctionCategories = "Light,Rendering|Lighting", AllowPrivateAccess = "true"))
    TObjectPtr<USkyLightComponent> LightComponent;

public:
    ASkyLight(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** The light. */
    USkyLightComponent* GetLightComponent() const { return LightComponent; }
};
