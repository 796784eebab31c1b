// SPDX-License-Identifier: MIT
#include "Components/StaticMeshComponent.h"

#include "Engine/StaticMesh.h"
#include "Engine/World.h"
#include "GameFramework/Actor.h"
#include "Materials/MaterialInterface.h"

DEFINE_LOG_CATEGORY_STATIC(LogStaticMeshComponent, Log, All);

UStaticMeshComponent::UStaticMeshComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    bReverseCulling = false;
}

bool UStaticMeshComponent::SetStaticMesh(UStaticMesh* NewMesh) {
    if (NewMesh == StaticMesh) {
        return false;
    }
    const UWorld* const World = GetWorld();
    const AActor* const Owner = GetOwner();
    if (Mobility == EComponentMobility::Static && IsRegistered() && World && World->IsGameWorld() && Owner &&
        Owner->IsActorInitialized()) {
        UE_LOG(LogStaticMeshComponent, Warning,
            TEXT("SetStaticMesh of '%s': the mobility is Static; call SetMobility first"), *GetPathName());
        return false;
    }
    StaticMesh = NewMesh;
    UpdateBounds();
    MarkRenderStateDirty();
    return true;
}

void UStaticMeshComponent::GetLocalBounds(FVector& Min, FVector& Max) const {
    Min = FVector(0.0, 0.0, 0.0);
    Max = FVector(0.0, 0.0, 0.0);
    if (StaticMesh) {
        const FBoxSphereBounds MeshBounds = StaticMesh->GetBounds();
        Min = MeshBounds.Origin - MeshBounds.BoxExtent;
        Max = MeshBounds.Origin + MeshBounds.BoxExtent;
    }
}

void UStaticMeshComponent::SetReverseCulling(bool ReverseCulling) {
    if (bReverseCulling != ReverseCulling) {
        bReverseCulling = ReverseCulling;
        MarkRenderStateDirty();
    }
}

FBoxSphereBounds UStaticMeshComponent::CalcBounds(const FTransform& LocalToWorld) const {
    return StaticMesh ? StaticMesh->GetBounds().TransformBy(LocalToWorld) : Super::CalcBounds(LocalToWorld);
}

int32 UStaticMeshComponent::GetNumMaterials() const { return StaticMesh ? StaticMesh->GetStaticMaterials().Num() : 0; }

UMaterialInterface* UStaticMeshComponent::GetMaterial(int32 MaterialIndex) const {
    if (UMaterialInterface* const Override = Super::GetMaterial(MaterialIndex)) {
        return Override;
    }
    return StaticMesh ? StaticMesh->GetMaterial(MaterialIndex) : nullptr;
}

int32 UStaticMeshComponent::GetMaterialIndex(FName MaterialSlotName) const {
    return StaticMesh ? StaticMesh->GetMaterialIndex(MaterialSlotName) : INDEX_NONE;
}

TArray<FName> UStaticMeshComponent::GetMaterialSlotNames() const {
    TArray<FName> Names;
    if (StaticMesh) {
        for (const FStaticMaterial& Slot : StaticMesh->GetStaticMaterials()) {
            Names.Add(Slot.MaterialSlotName);
        }
    }
    return Names;
}

bool UStaticMeshComponent::IsMaterialSlotNameValid(FName MaterialSlotName) const {
    return GetMaterialIndex(MaterialSlotName) != INDEX_NONE;
}
