// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Engine/EngineTypes.h"
#include "GameFramework/Actor.h"
#include "UObject/ObjectMacros.h"

#include "Light.generated.h"

class ULightComponent;

/** Base of the actors with a light; its functions pass to the component. Epic page: ALight. */
UCLASS(Abstract, ClassGroup = Lights, HideCategories = (Input, Collision, Replication),
    ShowCategories = ("Input|MouseInput", "Input|TouchInput"), ComponentWrapperClass)
class ENGINE_API ALight : public AActor {
    GENERATED_BODY()

private:
    /** The light. */
    UPROPERTY(BlueprintReadOnly, Category = Light, VisibleAnywhere,
        meta = (ExposeFunctionCategories = "Light,Rendering,Rendering|Components|Light", AllowPrivateAccess = "true"))
    TObjectPtr<ULightComponent> LightComponent;

public:
    ALight(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Sets the intensity of the light. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetBrightness(float NewBrightness);

    /** Gets the intensity of the light. */
    UFUNCTION(BlueprintPure, Category = "Rendering|Lighting")
    float GetBrightness() const;

    /** Sets the colour of the light, linear. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetLightColor(FLinearColor NewLightColor);

    /** Gets the colour of the light, linear. */
    UFUNCTION(BlueprintPure, Category = "Rendering|Lighting")
    FLinearColor GetLightColor() const;

    /** Sets whether the light casts shadows. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetCastShadows(bool bNewValue);

    /** Sets whether the light affects translucency. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetAffectTranslucentLighting(bool bNewValue);

    /** Turns the light on or off. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void SetEnabled(bool bSetEnabled);

    /** Whether the light is on. */
    UFUNCTION(BlueprintPure, Category = "Rendering|Lighting")
    bool IsEnabled() const;

    /** Toggles the light. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Lighting")
    void ToggleEnabled();

    /** Sets the mobility of the light. */
    void SetMobility(EComponentMobility::Type InMobility);
    /** The mobility of the light. */
    EComponentMobility::Type GetMobility() const;

    /** The light. */
    ULightComponent* GetLightComponent() const { return LightComponent; }
};
