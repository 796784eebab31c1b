// SPDX-License-Identifier: MIT
#include "Components/LocalLightComponent.h"
#include "Components/PointLightComponent.h"
#include "Components/RectLightComponent.h"
#include "Components/SpotLightComponent.h"

#include "Engine/Texture.h"

#include <cmath>

namespace {

// Distances are in centimetres, photometric units in metres.
constexpr float SquareCentimetresPerSquareMetre = 100.0f * 100.0f;
// What one of the old intensities without a unit is to the renderer.
constexpr float UnitlessScale = 16.0f;

// An exposure value at ISO 100 as a luminance: the middle of the scale that a camera exposes for, K = 12.5 (as in
// UE, 1.2 * 2^EV).
float Ev100ToLuminance(float Ev100) { return 1.2f * std::exp2(Ev100); }

// The solid angle, in steradians, of a cone.
float SolidAngle(float CosHalfConeAngle) { return 2.0f * UE_PI * (1.0f - CosHalfConeAngle); }

// The renderer's number for an intensity, given the solid angle that lumens spread over.
float Brightness(float Intensity, ELightUnits Units, float Steradians) {
    switch (Units) {
    case ELightUnits::Candelas:
        return Intensity * SquareCentimetresPerSquareMetre;
    case ELightUnits::Lumens:
        return Intensity * SquareCentimetresPerSquareMetre / Steradians;
    case ELightUnits::EV:
        return Ev100ToLuminance(Intensity) * SquareCentimetresPerSquareMetre;
    default:
        return Intensity * UnitlessScale;
    }
}

} // namespace

// ----------------------------------------------------------------------------------------------------------------
// local light

ULocalLightComponent::ULocalLightComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    Intensity = 5000.0f;
    IntensityUnits = ELightUnits::Unitless;
    InverseExposureBlend = 0.0f;
    AttenuationRadius = 1000.0f;
}

void ULocalLightComponent::SetAttenuationRadius(float NewRadius) {
    if (AreDynamicDataChangesAllowed(false) && NewRadius != AttenuationRadius) {
        AttenuationRadius = NewRadius;
        UpdateBounds();
        MarkRenderStateDirty();
    }
}

void ULocalLightComponent::SetIntensityUnits(ELightUnits NewIntensityUnits) {
    if (AreDynamicDataChangesAllowed() && IntensityUnits != NewIntensityUnits) {
        IntensityUnits = NewIntensityUnits;
        MarkRenderStateDirty();
    }
}

void ULocalLightComponent::SetInverseExposureBlend(float NewInverseExposureBlend) {
    if (AreDynamicDataChangesAllowed() && InverseExposureBlend != NewInverseExposureBlend) {
        InverseExposureBlend = NewInverseExposureBlend;
        MarkRenderStateDirty();
    }
}

float ULocalLightComponent::GetUnitsConversionFactor(
    ELightUnits SrcUnits, ELightUnits TargetUnits, float CosHalfConeAngle) {
    if (SrcUnits == TargetUnits || SrcUnits == ELightUnits::EV || TargetUnits == ELightUnits::EV) {
        return 1.0f;
    }
    const float Steradians = SolidAngle(FMath::Clamp(CosHalfConeAngle, -1.0f, 0.99999f));
    return Brightness(1.0f, SrcUnits, Steradians) / Brightness(1.0f, TargetUnits, Steradians);
}

float ULocalLightComponent::GetCosHalfConeAngleForUnits() const { return -1.0f; }

float ULocalLightComponent::ComputeLightBrightness() const {
    return bAffectsWorld ? Brightness(Intensity, IntensityUnits, SolidAngle(GetCosHalfConeAngleForUnits())) : 0.0f;
}

FBoxSphereBounds ULocalLightComponent::CalcBounds(const FTransform& LocalToWorld) const {
    const double Radius = AttenuationRadius;
    return FBoxSphereBounds(LocalToWorld.GetLocation(), FVector(Radius, Radius, Radius), Radius);
}

// ----------------------------------------------------------------------------------------------------------------
// point light

UPointLightComponent::UPointLightComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    bUseInverseSquaredFalloff = true;
    LightFalloffExponent = 8.0f;
    SourceRadius = 0.0f;
    SoftSourceRadius = 0.0f;
    SourceLength = 0.0f;
}

float UPointLightComponent::ComputeLightBrightness() const {
    if (!bUseInverseSquaredFalloff) {
        return bAffectsWorld ? Intensity : 0.0f; // such lights have no unit
    }
    return Super::ComputeLightBrightness();
}

void UPointLightComponent::SetUseInverseSquaredFalloff(bool bNewValue) {
    if (AreDynamicDataChangesAllowed() && bUseInverseSquaredFalloff != bNewValue) {
        bUseInverseSquaredFalloff = bNewValue;
        MarkRenderStateDirty();
    }
}

void UPointLightComponent::SetLightFalloffExponent(float NewLightFalloffExponent) {
    if (AreDynamicDataChangesAllowed() && LightFalloffExponent != NewLightFalloffExponent) {
        LightFalloffExponent = NewLightFalloffExponent;
        MarkRenderStateDirty();
    }
}

void UPointLightComponent::SetSourceRadius(float bNewValue) {
    if (AreDynamicDataChangesAllowed() && SourceRadius != bNewValue) {
        SourceRadius = bNewValue;
        MarkRenderStateDirty();
    }
}

void UPointLightComponent::SetSoftSourceRadius(float bNewValue) {
    if (AreDynamicDataChangesAllowed() && SoftSourceRadius != bNewValue) {
        SoftSourceRadius = bNewValue;
        MarkRenderStateDirty();
    }
}

void UPointLightComponent::SetSourceLength(float NewValue) {
    if (AreDynamicDataChangesAllowed() && SourceLength != NewValue) {
        SourceLength = NewValue;
        MarkRenderStateDirty();
    }
}

// -----------------------------------------------------------------------------------------------------------------
// spot light

USpotLightComponent::USpotLightComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    InnerConeAngle = 0.0f;
    OuterConeAngle = 44.0f;
}

void USpotLightComponent::SetInnerConeAngle(float NewInnerConeAngle) {
    if (AreDynamicDataChangesAllowed() && InnerConeAngle != NewInnerConeAngle) {
        InnerConeAngle = NewInnerConeAngle;
        MarkRenderStateDirty();
    }
}

void USpotLightComponent::SetOuterConeAngle(float NewOuterConeAngle) {
    if (AreDynamicDataChangesAllowed() && OuterConeAngle != NewOuterConeAngle) {
        OuterConeAngle = NewOuterConeAngle;
        UpdateBounds();
        MarkRenderStateDirty();
    }
}

float USpotLightComponent::GetHalfConeAngle() const {
    const float Inner = FMath::Clamp(InnerConeAngle, 0.0f, 89.0f);
    return FMath::Clamp(OuterConeAngle, Inner + 0.001f, 89.001f) * (UE_PI / 180.0f);
}

float USpotLightComponent::GetCosHalfConeAngle() const { return std::cos(GetHalfConeAngle()); }

float USpotLightComponent::GetCosHalfConeAngleForUnits() const { return GetCosHalfConeAngle(); }

FBoxSphereBounds USpotLightComponent::CalcBounds(const FTransform& LocalToWorld) const {
    // The cone from its tip to the cap of the sphere of influence.
    const double Side = static_cast<double>(AttenuationRadius) * std::sin(GetHalfConeAngle());
    const FBox Cone(FVector(0.0, -Side, -Side), FVector(AttenuationRadius, Side, Side));
    return FBoxSphereBounds(Cone).TransformBy(
        FTransform(LocalToWorld.GetRotation(), LocalToWorld.GetLocation(), FVector(1.0, 1.0, 1.0)));
}

// ------------------------------------------------------------------------------------------------------------
// rectangle light

URectLightComponent::URectLightComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    SourceWidth = 64.0f;
    SourceHeight = 64.0f;
    BarnDoorAngle = 88.0f;
    BarnDoorLength = 20.0f;
}

float URectLightComponent::ComputeLightBrightness() const {
    // A surface that shines as a cosine: its lumens are pi times the candelas straight ahead.
    return bAffectsWorld ? Brightness(Intensity, IntensityUnits, UE_PI) : 0.0f;
}

void URectLightComponent::SetSourceTexture(UTexture* bNewValue) {
    if (AreDynamicDataChangesAllowed() && SourceTexture != bNewValue) {
        SourceTexture = bNewValue;
        MarkRenderStateDirty();
    }
}

void URectLightComponent::SetSourceWidth(float bNewValue) {
    if (AreDynamicDataChangesAllowed() && SourceWidth != bNewValue) {
        SourceWidth = bNewValue;
        MarkRenderStateDirty();
    }
}

void URectLightComponent::SetSourceHeight(float NewValue) {
    if (AreDynamicDataChangesAllowed() && SourceHeight != NewValue) {
        SourceHeight = NewValue;
        MarkRenderStateDirty();
    }
}

void URectLightComponent::SetBarnDoorAngle(float NewValue) {
    if (AreDynamicDataChangesAllowed() && BarnDoorAngle != NewValue) {
        BarnDoorAngle = NewValue;
        MarkRenderStateDirty();
    }
}

void URectLightComponent::SetBarnDoorLength(float NewValue) {
    if (AreDynamicDataChangesAllowed() && BarnDoorLength != NewValue) {
        BarnDoorLength = NewValue;
        MarkRenderStateDirty();
    }
}
