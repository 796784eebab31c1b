// SPDX-License-Identifier: MIT
#include "Engine/DirectionalLight.h"
#include "Engine/Light.h"
#include "Engine/PointLight.h"
#include "Engine/RectLight.h"
#include "Engine/SkyLight.h"
#include "Engine/SpotLight.h"
#include "Engine/StaticMeshActor.h"
#include "Engine/TargetPoint.h"

#include "Components/DirectionalLightComponent.h"
#include "Components/PointLightComponent.h"
#include "Components/RectLightComponent.h"
#include "Components/SkyLightComponent.h"
#include "Components/SpotLightComponent.h"
#include "Components/StaticMeshComponent.h"

namespace {

// The subobject of ALight, whose class each kind of light chooses.
const TCHAR* const LightSubobjectName = TEXT("LightComponent0");

} // namespace

// ----------------------------------------------------------------------------------------------------------------------
// light

ALight::ALight(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    // The class itself is abstract, and so is the component it would have: only its class default object has none.
    LightComponent = ObjectInitializer.CreateOptionalDefaultSubobject<ULightComponent>(this, LightSubobjectName);
    RootComponent = LightComponent;
    if (LightComponent) {
        LightComponent->Mobility = EComponentMobility::Stationary;
    }
}

void ALight::SetBrightness(float NewBrightness) { LightComponent->SetIntensity(NewBrightness); }

float ALight::GetBrightness() const { return LightComponent->Intensity; }

void ALight::SetLightColor(FLinearColor NewLightColor) { LightComponent->SetLightColor(NewLightColor); }

FLinearColor ALight::GetLightColor() const { return FLinearColor(LightComponent->LightColor); }

void ALight::SetCastShadows(bool bNewValue) { LightComponent->SetCastShadows(bNewValue); }

void ALight::SetAffectTranslucentLighting(bool bNewValue) { LightComponent->SetAffectTranslucentLighting(bNewValue); }

void ALight::SetEnabled(bool bSetEnabled) { LightComponent->SetVisibility(bSetEnabled); }

bool ALight::IsEnabled() const { return LightComponent->IsVisible(); }

void ALight::ToggleEnabled() { LightComponent->ToggleVisibility(); }

void ALight::SetMobility(EComponentMobility::Type InMobility) { LightComponent->SetMobility(InMobility); }

EComponentMobility::Type ALight::GetMobility() const { return LightComponent->Mobility; }

// ---------------------------------------------------------------------------------------------------------- kinds of
// lights

APointLight::APointLight(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer.SetDefaultSubobjectClass<UPointLightComponent>(LightSubobjectName)) {
    PointLightComponent = CastChecked<UPointLightComponent>(GetLightComponent());
}

void APointLight::SetRadius(float NewRadius) { PointLightComponent->SetAttenuationRadius(NewRadius); }

void APointLight::SetLightFalloffExponent(float NewLightFalloffExponent) {
    PointLightComponent->SetLightFalloffExponent(NewLightFalloffExponent);
}

ASpotLight::ASpotLight(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer.SetDefaultSubobjectClass<USpotLightComponent>(LightSubobjectName)) {
    SpotLightComponent = CastChecked<USpotLightComponent>(GetLightComponent());
}

void ASpotLight::SetInnerConeAngle(float NewInnerConeAngle) {
    SpotLightComponent->SetInnerConeAngle(NewInnerConeAngle);
}

void ASpotLight::SetOuterConeAngle(float NewOuterConeAngle) {
    SpotLightComponent->SetOuterConeAngle(NewOuterConeAngle);
}

ARectLight::ARectLight(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer.SetDefaultSubobjectClass<URectLightComponent>(LightSubobjectName)) {
    RectLightComponent = CastChecked<URectLightComponent>(GetLightComponent());
}

ADirectionalLight::ADirectionalLight(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer.SetDefaultSubobjectClass<UDirectionalLightComponent>(LightSubobjectName)) {}

UDirectionalLightComponent* ADirectionalLight::GetComponent() const {
    return CastChecked<UDirectionalLightComponent>(GetLightComponent());
}

ASkyLight::ASkyLight(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    LightComponent = CreateDefaultSubobject<USkyLightComponent>(TEXT("SkyLightComponent0"));
    RootComponent = LightComponent;
}

// ------------------------------------------------------------------------------------------------------------- other
// actors

AStaticMeshActor::AStaticMeshActor(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    StaticMeshComponent = CreateDefaultSubobject<UStaticMeshComponent>(TEXT("StaticMeshComponent0"));
    StaticMeshComponent->SetCollisionProfileName(FName(TEXT("BlockAll")));
    StaticMeshComponent->Mobility = EComponentMobility::Static;
    StaticMeshComponent->SetGenerateOverlapEvents(false);
    RootComponent = StaticMeshComponent;
}

void AStaticMeshActor::SetMobility(EComponentMobility::Type InMobility) {
    StaticMeshComponent->SetMobility(InMobility);
}

ATargetPoint::ATargetPoint(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    RootComponent = CreateDefaultSubobject<USceneComponent>(TEXT("SceneComp"));
    RootComponent->Mobility = EComponentMobility::Static;
    SetHidden(true);
}
