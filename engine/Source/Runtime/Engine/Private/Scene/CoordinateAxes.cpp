// SPDX-License-Identifier: MIT
#include "Engine/CoordinateAxes.h"

#include "Components/SceneComponent.h"
#include "Components/StaticMeshComponent.h"
#include "Engine/StaticMesh.h"
#include "Materials/MaterialInterface.h"

ACoordinateAxes::ACoordinateAxes(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    AxesRoot = CreateDefaultSubobject<USceneComponent>(TEXT("AxesRoot"));
    AxesRoot->SetMobility(EComponentMobility::Movable);
    RootComponent = AxesRoot;
    UStaticMesh* Arrow = LoadObject<UStaticMesh>(nullptr, TEXT("/Engine/BasicShapes/Arrow.Arrow"));
    const auto MakeAxis = [this, Arrow](const TCHAR* Name, const TCHAR* Material, const FRotator& Rotation) {
        UStaticMeshComponent* Axis = CreateDefaultSubobject<UStaticMeshComponent>(Name);
        Axis->SetupAttachment(AxesRoot);
        Axis->SetMobility(EComponentMobility::Movable);
        Axis->SetRelativeRotation(Rotation);
        Axis->SetStaticMesh(Arrow);
        Axis->SetMaterial(0, LoadObject<UMaterialInterface>(nullptr, Material));
        return Axis;
    };
    XAxis = MakeAxis(TEXT("XAxis"), TEXT("/Engine/EngineMaterials/AxisX.AxisX"), FRotator(0.0, 0.0, 0.0));
    YAxis = MakeAxis(TEXT("YAxis"), TEXT("/Engine/EngineMaterials/AxisY.AxisY"), FRotator(0.0, 90.0, 0.0));
    ZAxis = MakeAxis(TEXT("ZAxis"), TEXT("/Engine/EngineMaterials/AxisZ.AxisZ"), FRotator(90.0, 0.0, 0.0));
}
