// SPDX-License-Identifier: MIT
#include "Components/SkyAtmosphereComponent.h"

USkyAtmosphereComponent::USkyAtmosphereComponent(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer) {
    // The Earth's atmosphere, as in UE.
    TransformMode = ESkyAtmosphereTransformMode::PlanetTopAtAbsoluteWorldOrigin;
    BottomRadius = 6360.0f;
    GroundAlbedo = FColor(170, 170, 170, 255);
    AtmosphereHeight = 100.0f;
    MultiScatteringFactor = 1.0f;
    RayleighScatteringScale = 0.0331f;
    RayleighScattering = FLinearColor(0.175287f, 0.409607f, 1.0f, 1.0f);
    RayleighExponentialDistribution = 8.0f;
    MieScatteringScale = 0.003996f;
    MieAnisotropy = 0.8f;
    MieExponentialDistribution = 1.2f;
}

void USkyAtmosphereComponent::SetBottomRadius(float NewValue) {
    if (BottomRadius != NewValue) {
        BottomRadius = NewValue;
        MarkRenderStateDirty();
    }
}

void USkyAtmosphereComponent::SetGroundAlbedo(const FColor& NewValue) {
    if (GroundAlbedo != NewValue) {
        GroundAlbedo = NewValue;
        MarkRenderStateDirty();
    }
}

void USkyAtmosphereComponent::SetAtmosphereHeight(float NewValue) {
    if (AtmosphereHeight != NewValue) {
        AtmosphereHeight = NewValue;
        MarkRenderStateDirty();
    }
}

void USkyAtmosphereComponent::SetMultiScatteringFactor(float NewValue) {
    if (MultiScatteringFactor != NewValue) {
        MultiScatteringFactor = NewValue;
        MarkRenderStateDirty();
    }
}

void USkyAtmosphereComponent::SetRayleighScatteringScale(float NewValue) {
    if (RayleighScatteringScale != NewValue) {
        RayleighScatteringScale = NewValue;
        MarkRenderStateDirty();
    }
}

void USkyAtmosphereComponent::SetRayleighScattering(FLinearColor NewValue) {
    if (RayleighScattering != NewValue) {
        RayleighScattering = NewValue;
        MarkRenderStateDirty();
    }
}

void USkyAtmosphereComponent::SetRayleighExponentialDistribution(float NewValue) {
    if (RayleighExponentialDistribution != NewValue) {
        RayleighExponentialDistribution = NewValue;
        MarkRenderStateDirty();
    }
}

void USkyAtmosphereComponent::SetMieScatteringScale(float NewValue) {
    if (MieScatteringScale != NewValue) {
        MieScatteringScale = NewValue;
        MarkRenderStateDirty();
    }
}

void USkyAtmosphereComponent::SetMieAnisotropy(float NewValue) {
    if (MieAnisotropy != NewValue) {
        MieAnisotropy = NewValue;
        MarkRenderStateDirty();
    }
}

void USkyAtmosphereComponent::SetMieExponentialDistribution(float NewValue) {
    if (MieExponentialDistribution != NewValue) {
        MieExponentialDistribution = NewValue;
        MarkRenderStateDirty();
    }
}

ASkyAtmosphere::ASkyAtmosphere(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    SkyAtmosphereComponent = CreateDefaultSubobject<USkyAtmosphereComponent>(TEXT("SkyAtmosphereComponent"));
    RootComponent = SkyAtmosphereComponent;
}
