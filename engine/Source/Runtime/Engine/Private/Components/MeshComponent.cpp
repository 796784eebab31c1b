// SPDX-License-Identifier: MIT
#include "Components/MeshComponent.h"

#include "Materials/MaterialInstanceDynamic.h"
#include "Materials/MaterialInterface.h"

DEFINE_LOG_CATEGORY_STATIC(LogMeshComponent, Log, All);

UMeshComponent::UMeshComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    CastShadow = true;
}

TArray<UMaterialInterface*> UMeshComponent::GetMaterials() const {
    TArray<UMaterialInterface*> Materials;
    for (int32 Index = 0; Index < GetNumMaterials(); ++Index) {
        Materials.Add(GetMaterial(Index));
    }
    return Materials;
}

int32 UMeshComponent::GetMaterialIndex(FName) const { return INDEX_NONE; }

TArray<FName> UMeshComponent::GetMaterialSlotNames() const { return TArray<FName>(); }

bool UMeshComponent::IsMaterialSlotNameValid(FName) const { return false; }

int32 UMeshComponent::GetNumMaterials() const { return OverrideMaterials.Num(); }

UMaterialInterface* UMeshComponent::GetMaterial(int32 ElementIndex) const {
    return OverrideMaterials.IsValidIndex(ElementIndex) ? OverrideMaterials[ElementIndex].Get() : nullptr;
}

UMaterialInterface* UMeshComponent::GetMaterialByName(FName MaterialSlotName) const {
    const int32 Index = GetMaterialIndex(MaterialSlotName);
    return Index != INDEX_NONE ? GetMaterial(Index) : nullptr;
}

void UMeshComponent::SetMaterial(int32 ElementIndex, UMaterialInterface* Material) {
    if (ElementIndex < 0) {
        UE_LOG(LogMeshComponent, Warning, TEXT("SetMaterial of '%s': there is no element %d"), *GetPathName(),
            ElementIndex);
        return;
    }
    if (OverrideMaterials.IsValidIndex(ElementIndex) && OverrideMaterials[ElementIndex] == Material) {
        return;
    }
    if (OverrideMaterials.Num() <= ElementIndex) {
        // As in UE the list may be longer than the mesh has slots: the mesh may be set later. A limit keeps a wild
        // index harmless.
        constexpr int32 MaxElements = 1024;
        if (ElementIndex >= FMath::Max(MaxElements, GetNumMaterials())) {
            UE_LOG(LogMeshComponent, Warning, TEXT("SetMaterial of '%s': element %d is out of range, the mesh has %d"),
                *GetPathName(), ElementIndex, GetNumMaterials());
            return;
        }
        OverrideMaterials.SetNum(ElementIndex + 1);
    }
    OverrideMaterials[ElementIndex] = Material;
    MarkRenderStateDirty();
}

void UMeshComponent::SetMaterialByName(FName MaterialSlotName, UMaterialInterface* Material) {
    const int32 Index = GetMaterialIndex(MaterialSlotName);
    if (Index == INDEX_NONE) {
        UE_LOG(LogMeshComponent, Warning, TEXT("SetMaterialByName of '%s': there is no material slot '%s'"),
            *GetPathName(), *MaterialSlotName.ToString());
        return;
    }
    SetMaterial(Index, Material);
}

void UMeshComponent::EmptyOverrideMaterials() {
    OverrideMaterials.Reset();
    MarkRenderStateDirty();
}

void UMeshComponent::SetOverlayMaterial(UMaterialInterface* NewOverlayMaterial) {
    if (OverlayMaterial != NewOverlayMaterial) {
        OverlayMaterial = NewOverlayMaterial;
        MarkRenderStateDirty();
    }
}

UMaterialInstanceDynamic* UMeshComponent::GetOrMakeDynamicMaterial(int32 ElementIndex) {
    UMaterialInterface* const Material = GetMaterial(ElementIndex);
    return Material ? CreateDynamicMaterialInstance(ElementIndex) : nullptr;
}

void UMeshComponent::SetScalarParameterValueOnMaterials(const FName ParameterName, const float ParameterValue) {
    for (int32 Index = 0; Index < GetNumMaterials(); ++Index) {
        if (UMaterialInstanceDynamic* const Instance = GetOrMakeDynamicMaterial(Index)) {
            Instance->SetScalarParameterValue(ParameterName, ParameterValue);
        }
    }
}

void UMeshComponent::SetVectorParameterValueOnMaterials(const FName ParameterName, const FVector ParameterValue) {
    const FLinearColor Value(static_cast<float>(ParameterValue.X), static_cast<float>(ParameterValue.Y),
        static_cast<float>(ParameterValue.Z), 1.0f);
    for (int32 Index = 0; Index < GetNumMaterials(); ++Index) {
        if (UMaterialInstanceDynamic* const Instance = GetOrMakeDynamicMaterial(Index)) {
            Instance->SetVectorParameterValue(ParameterName, Value);
        }
    }
}
