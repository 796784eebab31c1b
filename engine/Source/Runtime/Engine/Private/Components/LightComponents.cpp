// SPDX-License-Identifier: MIT
#include "Components/LightComponent.h"
#include "Components/LightComponentBase.h"
#include "Components/DirectionalLightComponent.h"
#include "Components/SkyLightComponent.h"

#include "Engine/World.h"
#include "GameFramework/Actor.h"

// ----------------------------------------------------------------------------------------------------- light component
// base

ULightComponentBase::ULightComponentBase(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    Intensity = UE_PI;
    LightColor = FColor(255, 255, 255, 255);
    bAffectsWorld = true;
    CastShadows = true;
    CastStaticShadows = true;
    CastDynamicShadows = true;
    bAffectTranslucentLighting = true;
    bAffectReflection = true;
    bAffectGlobalIllumination = true;
    IndirectLightingIntensity = 1.0f;
    VolumetricScatteringIntensity = 1.0f;
}

bool ULightComponentBase::AreDynamicDataChangesAllowed(bool bIgnoreStationary) const {
    const bool bFixed =
        Mobility == EComponentMobility::Static || (!bIgnoreStationary && Mobility == EComponentMobility::Stationary);
    const UWorld* const World = GetWorld();
    const AActor* const Owner = GetOwner();
    return !(bFixed && IsRegistered() && World && World->IsGameWorld() && Owner && Owner->IsActorInitialized());
}

FLinearColor ULightComponentBase::GetLightColor() const { return FLinearColor(LightColor); }

void ULightComponentBase::SetCastShadows(bool bNewValue) {
    if (AreDynamicDataChangesAllowed() && CastShadows != bNewValue) {
        CastShadows = bNewValue;
        MarkRenderStateDirty();
    }
}

void ULightComponentBase::SetAffectReflection(bool bNewValue) {
    if (AreDynamicDataChangesAllowed() && bAffectReflection != bNewValue) {
        bAffectReflection = bNewValue;
        MarkRenderStateDirty();
    }
}

void ULightComponentBase::SetAffectGlobalIllumination(bool bNewValue) {
    if (AreDynamicDataChangesAllowed() && bAffectGlobalIllumination != bNewValue) {
        bAffectGlobalIllumination = bNewValue;
        MarkRenderStateDirty();
    }
}

// ---------------------------------------------------------------------------------------------------------- light
// component

ULightComponent::ULightComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    Temperature = 6500.0f;
    MaxDrawDistance = 0.0f;
    MaxDistanceFadeRange = 0.0f;
    bUseTemperature = false;
    ShadowBias = 0.5f;
    ShadowSlopeBias = 0.5f;
    SpecularScale = 1.0f;
    DiffuseScale = 1.0f;
}

void ULightComponent::SetIntensity(float NewIntensity) {
    if (AreDynamicDataChangesAllowed() && Intensity != NewIntensity) {
        Intensity = NewIntensity;
        MarkRenderStateDirty();
    }
}

void ULightComponent::SetIndirectLightingIntensity(float NewIntensity) {
    if (AreDynamicDataChangesAllowed() && IndirectLightingIntensity != NewIntensity) {
        IndirectLightingIntensity = NewIntensity;
        MarkRenderStateDirty();
    }
}

void ULightComponent::SetVolumetricScatteringIntensity(float NewIntensity) {
    if (AreDynamicDataChangesAllowed() && VolumetricScatteringIntensity != NewIntensity) {
        VolumetricScatteringIntensity = NewIntensity;
        MarkRenderStateDirty();
    }
}

void ULightComponent::SetLightColor(FLinearColor NewLightColor, bool bSRGB) {
    SetLightFColor(NewLightColor.ToFColor(bSRGB));
}

void ULightComponent::SetLightFColor(FColor NewLightColor) {
    if (AreDynamicDataChangesAllowed() && LightColor != NewLightColor) {
        LightColor = NewLightColor;
        MarkRenderStateDirty();
    }
}

void ULightComponent::SetTemperature(float NewTemperature) {
    if (AreDynamicDataChangesAllowed() && Temperature != NewTemperature) {
        Temperature = NewTemperature;
        MarkRenderStateDirty();
    }
}

void ULightComponent::SetUseTemperature(bool bNewValue) {
    if (AreDynamicDataChangesAllowed() && bUseTemperature != bNewValue) {
        bUseTemperature = bNewValue;
        MarkRenderStateDirty();
    }
}

void ULightComponent::SetAffectTranslucentLighting(bool bNewValue) {
    if (AreDynamicDataChangesAllowed() && bAffectTranslucentLighting != bNewValue) {
        bAffectTranslucentLighting = bNewValue;
        MarkRenderStateDirty();
    }
}

void ULightComponent::SetShadowBias(float NewValue) {
    if (AreDynamicDataChangesAllowed() && ShadowBias != NewValue) {
        ShadowBias = NewValue;
        MarkRenderStateDirty();
    }
}

void ULightComponent::SetShadowSlopeBias(float NewValue) {
    if (AreDynamicDataChangesAllowed() && ShadowSlopeBias != NewValue) {
        ShadowSlopeBias = NewValue;
        MarkRenderStateDirty();
    }
}

void ULightComponent::SetSpecularScale(float NewValue) {
    if (AreDynamicDataChangesAllowed() && SpecularScale != NewValue) {
        SpecularScale = NewValue;
        MarkRenderStateDirty();
    }
}

void ULightComponent::SetDiffuseScale(float NewValue) {
    if (AreDynamicDataChangesAllowed() && DiffuseScale != NewValue) {
        DiffuseScale = NewValue;
        MarkRenderStateDirty();
    }
}

void ULightComponent::SetLightingChannels(bool bChannel0, bool bChannel1, bool bChannel2) {
    LightingChannels.bChannel0 = bChannel0;
    LightingChannels.bChannel1 = bChannel1;
    LightingChannels.bChannel2 = bChannel2;
    MarkRenderStateDirty();
}

FVector ULightComponent::GetDirection() const { return GetForwardVector(); }

float ULightComponent::ComputeLightBrightness() const { return bAffectsWorld ? Intensity : 0.0f; }

FLinearColor ULightComponent::GetColorTemperature() const {
    return FLinearColor::MakeFromColorTemperature(Temperature);
}

FLinearColor ULightComponent::GetColoredLightBrightness() const {
    FLinearColor Color(LightColor);
    if (bUseTemperature) {
        const FLinearColor OfTemperature = GetColorTemperature();
        Color = FLinearColor(Color.R * OfTemperature.R, Color.G * OfTemperature.G, Color.B * OfTemperature.B, Color.A);
    }
    const float Brightness = ComputeLightBrightness();
    return FLinearColor(Color.R * Brightness, Color.G * Brightness, Color.B * Brightness, Color.A);
}

// ----------------------------------------------------------------------------------------------------------------
// directional

UDirectionalLightComponent::UDirectionalLightComponent(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer) {
    Intensity = 10.0f;
    LightSourceAngle = 0.5357f;
    LightSourceSoftAngle = 0.0f;
    DynamicShadowDistanceMovableLight = 20000.0f;
    bAtmosphereSunLight = true;
    AtmosphereSunLightIndex = 0;
}

void UDirectionalLightComponent::SetLightSourceAngle(float NewValue) {
    if (AreDynamicDataChangesAllowed() && LightSourceAngle != NewValue) {
        LightSourceAngle = NewValue;
        MarkRenderStateDirty();
    }
}

void UDirectionalLightComponent::SetLightSourceSoftAngle(float NewValue) {
    if (AreDynamicDataChangesAllowed() && LightSourceSoftAngle != NewValue) {
        LightSourceSoftAngle = NewValue;
        MarkRenderStateDirty();
    }
}

void UDirectionalLightComponent::SetDynamicShadowDistanceMovableLight(float NewValue) {
    if (AreDynamicDataChangesAllowed() && DynamicShadowDistanceMovableLight != NewValue) {
        DynamicShadowDistanceMovableLight = NewValue;
        MarkRenderStateDirty();
    }
}

void UDirectionalLightComponent::SetAtmosphereSunLight(bool bNewValue) {
    if (AreDynamicDataChangesAllowed() && bAtmosphereSunLight != bNewValue) {
        bAtmosphereSunLight = bNewValue;
        MarkRenderStateDirty();
    }
}

void UDirectionalLightComponent::SetAtmosphereSunLightIndex(int32 NewValue) {
    if (AreDynamicDataChangesAllowed()) {
        AtmosphereSunLightIndex = FMath::Clamp(NewValue, 0, 1);
        MarkRenderStateDirty();
    }
}

// ------------------------------------------------------------------------------------------------------------------------
// sky

USkyLightComponent::USkyLightComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    Intensity = 1.0f;
    SkyDistanceThreshold = 150000.0f;
    bLowerHemisphereIsBlack = true;
    LowerHemisphereColor = FLinearColor(0.0f, 0.0f, 0.0f, 1.0f);
    Mobility = EComponentMobility::Stationary;
}

void USkyLightComponent::SetIntensity(float NewIntensity) {
    if (AreDynamicDataChangesAllowed() && Intensity != NewIntensity) {
        Intensity = NewIntensity;
        MarkRenderStateDirty();
    }
}

void USkyLightComponent::SetIndirectLightingIntensity(float NewIntensity) {
    if (AreDynamicDataChangesAllowed() && IndirectLightingIntensity != NewIntensity) {
        IndirectLightingIntensity = NewIntensity;
        MarkRenderStateDirty();
    }
}

void USkyLightComponent::SetVolumetricScatteringIntensity(float NewIntensity) {
    if (AreDynamicDataChangesAllowed() && VolumetricScatteringIntensity != NewIntensity) {
        VolumetricScatteringIntensity = NewIntensity;
        MarkRenderStateDirty();
    }
}

void USkyLightComponent::SetLightColor(FLinearColor NewLightColor) {
    if (AreDynamicDataChangesAllowed()) {
        LightColor = NewLightColor.ToFColor(true);
        MarkRenderStateDirty();
    }
}

void USkyLightComponent::SetLowerHemisphereColor(const FLinearColor& InLowerHemisphereColor) {
    if (AreDynamicDataChangesAllowed(false)) {
        LowerHemisphereColor = InLowerHemisphereColor;
        MarkRenderStateDirty();
    }
}
