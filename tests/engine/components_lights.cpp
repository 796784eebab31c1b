// SPDX-License-Identifier: MIT
// Lights, cameras and mesh components.
#include "engine_fixture.h"

#include "Camera/CameraActor.h"
#include "Camera/CameraComponent.h"
#include "Components/DirectionalLightComponent.h"
#include "Components/PointLightComponent.h"
#include "Components/RectLightComponent.h"
#include "Components/SkyLightComponent.h"
#include "Components/SpotLightComponent.h"
#include "Components/StaticMeshComponent.h"
#include "Engine/DirectionalLight.h"
#include "Engine/PointLight.h"
#include "Engine/RectLight.h"
#include "Engine/SkyLight.h"
#include "Engine/SpotLight.h"
#include "Engine/StaticMesh.h"
#include "Engine/StaticMeshActor.h"
#include "Materials/Material.h"
#include "Materials/MaterialInstanceDynamic.h"

TEST_CASE_FIXTURE(EngineFixture, "light actors: each has the component of its kind as root") {
    APointLight* point = World->SpawnActor<APointLight>();
    ASpotLight* spot = World->SpawnActor<ASpotLight>();
    ARectLight* rect = World->SpawnActor<ARectLight>();
    ADirectionalLight* sun = World->SpawnActor<ADirectionalLight>();
    ASkyLight* sky = World->SpawnActor<ASkyLight>();
    REQUIRE(point);
    CHECK(Cast<UPointLightComponent>(point->GetRootComponent()));
    CHECK(point->GetLightComponent() == point->GetRootComponent());
    CHECK(Cast<USpotLightComponent>(spot->GetRootComponent()));
    CHECK(Cast<URectLightComponent>(rect->GetRootComponent()));
    CHECK(Cast<UDirectionalLightComponent>(sun->GetRootComponent()));
    CHECK(Cast<USkyLightComponent>(sky->GetRootComponent()));
    CHECK(point->GetMobility() == EComponentMobility::Stationary);
    CHECK(sun->GetBrightness() == 10.0f);
    point->SetBrightness(7.0f);
    CHECK(point->GetLightComponent()->Intensity == 7.0f);
    point->SetEnabled(false);
    CHECK_FALSE(point->IsEnabled());
    point->SetRadius(123.0f);
    CHECK(point->GetPointLightComponent()->Bounds.SphereRadius == doctest::Approx(123.0));
}

TEST_CASE_FIXTURE(EngineFixture, "lights: units, colours and brightness") {
    // 4 pi lumens in all directions are one candela; 625 of the unit without a name are, too.
    CHECK(ULocalLightComponent::GetUnitsConversionFactor(ELightUnits::Candelas, ELightUnits::Lumens) ==
          doctest::Approx(4.0 * UE_DOUBLE_PI));
    CHECK(ULocalLightComponent::GetUnitsConversionFactor(ELightUnits::Candelas, ELightUnits::Unitless) ==
          doctest::Approx(625.0));
    // Half of all directions: half the lumens.
    CHECK(ULocalLightComponent::GetUnitsConversionFactor(ELightUnits::Candelas, ELightUnits::Lumens, 0.0f) ==
          doctest::Approx(2.0 * UE_DOUBLE_PI));

    UPointLightComponent* light = Cast<UPointLightComponent>(World->SpawnActor<APointLight>()->GetRootComponent());
    light->SetIntensityUnits(ELightUnits::Candelas);
    light->SetIntensity(2.0f);
    CHECK(light->ComputeLightBrightness() == doctest::Approx(20000.0f));
    light->SetLightColor(FLinearColor(1.0f, 0.5f, 0.0f));
    CHECK(light->LightColor == FColor(255, 188, 0, 255));
    CHECK(light->GetLightColor().G == doctest::Approx(0.5f).epsilon(0.01));
    light->SetUseTemperature(true);
    light->SetTemperature(2700.0f); // warm
    const FLinearColor warm = light->GetColorTemperature();
    CHECK(warm.R > warm.G);
    CHECK(warm.G > warm.B);

    USpotLightComponent* spot = Cast<USpotLightComponent>(World->SpawnActor<ASpotLight>()->GetRootComponent());
    spot->SetOuterConeAngle(60.0f);
    CHECK(spot->GetCosHalfConeAngle() == doctest::Approx(0.5f));
    spot->SetInnerConeAngle(70.0f); // the outer one is never less
    CHECK(spot->GetHalfConeAngle() > 70.0f * UE_PI / 180.0f - 0.001f);
}

TEST_CASE_FIXTURE(EngineFixture, "camera: its view is where it is") {
    BeginPlay(); // components activate then
    ACameraActor* camera = World->SpawnActor<ACameraActor>(FVector(1, 2, 3), FRotator(10, 20, 0));
    REQUIRE(camera->GetCameraComponent());
    camera->GetCameraComponent()->SetFieldOfView(60.0f);
    FMinimalViewInfo view;
    camera->GetCameraComponent()->GetCameraView(0.0f, view);
    CHECK(view.Location.Equals(FVector(1, 2, 3)));
    CHECK(view.Rotation.Equals(FRotator(10, 20, 0), 1e-3));
    CHECK(view.FOV == 60.0f);
    CHECK(bool(view.bConstrainAspectRatio));
    CHECK(camera->GetCameraComponent()->IsActive());

    FMinimalViewInfo other = view;
    other.Location = FVector(3, 2, 3);
    other.Rotation = FRotator(10, -20, 0);
    other.FOV = 80.0f;
    view.BlendViewInfo(other, 0.5f);
    CHECK(view.Location.Equals(FVector(2, 2, 3)));
    CHECK(view.Rotation.Equals(FRotator(10, 0, 0), 1e-3));
    CHECK(view.FOV == doctest::Approx(70.0f));
}

TEST_CASE_FIXTURE(EngineFixture, "static mesh component: materials for each slot") {
    UStaticMesh* mesh = NewObject<UStaticMesh>();
    UMaterial* wood = NewObject<UMaterial>();
    UMaterial* metal = NewObject<UMaterial>();
    mesh->SetStaticMaterials(TArray<FStaticMaterial>{
        FStaticMaterial(wood, FName(TEXT("Seat"))), FStaticMaterial(metal, FName(TEXT("Legs")))});

    AStaticMeshActor* chair = World->SpawnActor<AStaticMeshActor>();
    UStaticMeshComponent* component = chair->GetStaticMeshComponent();
    component->SetMobility(EComponentMobility::Movable);
    CHECK(component->SetStaticMesh(mesh));
    CHECK_FALSE(component->SetStaticMesh(mesh));
    CHECK(component->GetStaticMesh() == mesh);
    CHECK(component->GetNumMaterials() == 2);
    CHECK(component->GetMaterial(0) == wood);
    CHECK(component->GetMaterialByName(FName(TEXT("legs"))) == metal);
    CHECK(component->GetMaterial(5) == nullptr);
    component->SetMaterial(0, metal);
    CHECK(component->GetMaterial(0) == metal);
    CHECK(mesh->GetMaterial(0) == wood);
    component->SetMaterial(-1, metal); // refused, with a warning
    component->SetMaterialByName(FName(TEXT("Back")), metal);
    CHECK(component->GetNumOverrideMaterials() == 1);
    component->EmptyOverrideMaterials();
    CHECK(component->GetMaterial(0) == wood);

    UMaterialInstanceDynamic* instance = component->CreateDynamicMaterialInstance(1);
    REQUIRE(instance);
    CHECK(component->GetMaterial(1) == instance);
    CHECK(component->CreateDynamicMaterialInstance(1) == instance); // the one that is there
    CHECK(component->CreateDynamicMaterialInstance(2) == nullptr);
    CHECK(component->GetMaterialSlotNames().Num() == 2);
    CHECK(component->IsMaterialSlotNameValid(FName(TEXT("Seat"))));
}
