// SPDX-License-Identifier: MIT
#include "Door.h"

#include "Components/SceneComponent.h"
#include "Components/StaticMeshComponent.h"
#include "Engine/StaticMesh.h"

namespace {
constexpr double Thickness = 4.0, Width = 90.0, Height = 200.0; // centimetres
constexpr double CubeEdge = 100.0;                              // of /Engine/BasicShapes/Cube
} // namespace

ADoor::ADoor() {
    RootComponent = CreateDefaultSubobject<USceneComponent>(TEXT("Frame"));
    Hinge = CreateDefaultSubobject<USceneComponent>(TEXT("Hinge"));
    Hinge->SetupAttachment(RootComponent);
    Hinge->SetMobility(EComponentMobility::Movable);
    Leaf = CreateDefaultSubobject<UStaticMeshComponent>(TEXT("Leaf"));
    Leaf->SetupAttachment(Hinge);
    Leaf->SetMobility(EComponentMobility::Movable);
    Leaf->SetStaticMesh(LoadObject<UStaticMesh>(nullptr, TEXT("/Engine/BasicShapes/Cube.Cube")));
    Leaf->SetRelativeLocation(FVector(0.0, Width / 2.0, Height / 2.0));
    Leaf->SetRelativeScale3D(FVector(Thickness, Width, Height) / CubeEdge);
}

void ADoor::Open(float Angle) {
    const float Limit = FMath::Max(MaxAngle, 0.0f);
    Hinge->SetRelativeRotation(FRotator(0.0, FMath::Clamp(Angle, -Limit, Limit), 0.0));
}

float ADoor::GetAngle() const { return static_cast<float>(Hinge->GetRelativeRotation().Yaw); }
