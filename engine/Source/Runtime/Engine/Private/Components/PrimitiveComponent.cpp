// SPDX-License-Identifier: MIT
#include "Components/PrimitiveComponent.h"

#include "Engine/CollisionProfile.h"
#include "GameFramework/Actor.h"
#include "Materials/MaterialInstanceDynamic.h"
#include "Materials/MaterialInterface.h"

DEFINE_LOG_CATEGORY_STATIC(LogPrimitiveComponent, Log, All);

UPrimitiveComponent::UPrimitiveComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    MinDrawDistance = 0.0f;
    LDMaxDrawDistance = 0.0f;
    CachedMaxDrawDistance = 0.0f;
    BoundsScale = 1.0f;
    bRenderInMainPass = true;
    bRenderInDepthPass = true;
    bReceivesDecals = true;
    bOwnerNoSee = false;
    bOnlyOwnerSee = false;
    bVisibleInReflectionCaptures = true;
    bVisibleInRayTracing = true;
    bVisibleInSceneCaptureOnly = false;
    bHiddenInSceneCapture = false;
    CastShadow = false;
    bAffectDynamicIndirectLighting = true;
    bAffectDistanceFieldLighting = true;
    bCastDynamicShadow = true;
    bCastStaticShadow = true;
    bCastHiddenShadow = false;
    bCastShadowAsTwoSided = false;
    bRenderCustomDepth = false;
    CustomDepthStencilValue = 0;
    TranslucencySortPriority = 0;
    bGenerateOverlapEvents = true;
    BodyInstance.SetCollisionProfileName(UCollisionProfile::BlockAllDynamic_ProfileName);
}

// ----------------------------------------------------------------------------------------------------------- collision

void UPrimitiveComponent::SetGenerateOverlapEvents(bool bInGenerateOverlapEvents) {
    bGenerateOverlapEvents = bInGenerateOverlapEvents;
}

bool UPrimitiveComponent::GetGenerateOverlapEvents() const { return bGenerateOverlapEvents; }

void UPrimitiveComponent::SetCollisionEnabled(ECollisionEnabled::Type NewType) {
    BodyInstance.SetCollisionEnabled(NewType);
}

ECollisionEnabled::Type UPrimitiveComponent::GetCollisionEnabled() const {
    const AActor* const Owner = GetOwner();
    if (Owner && !Owner->GetActorEnableCollision()) {
        return ECollisionEnabled::NoCollision;
    }
    return BodyInstance.GetCollisionEnabled();
}

bool UPrimitiveComponent::K2_IsCollisionEnabled() const {
    return GetCollisionEnabled() != ECollisionEnabled::NoCollision;
}

bool UPrimitiveComponent::K2_IsQueryCollisionEnabled() const { return CollisionEnabledHasQuery(GetCollisionEnabled()); }

bool UPrimitiveComponent::K2_IsPhysicsCollisionEnabled() const {
    return CollisionEnabledHasPhysics(GetCollisionEnabled());
}

void UPrimitiveComponent::SetCollisionProfileName(FName InCollisionProfileName, bool) {
    FCollisionResponseTemplate Profile;
    if (InCollisionProfileName != UCollisionProfile::CustomCollisionProfileName &&
        !UCollisionProfile::Get()->GetProfileTemplate(InCollisionProfileName, Profile)) {
        UE_LOG(LogPrimitiveComponent, Warning,
            TEXT("SetCollisionProfileName of '%s': there is no collision profile '%s'"), *GetPathName(),
            *InCollisionProfileName.ToString());
    }
    BodyInstance.SetCollisionProfileName(InCollisionProfileName);
}

FName UPrimitiveComponent::GetCollisionProfileName() const { return BodyInstance.GetCollisionProfileName(); }

void UPrimitiveComponent::SetCollisionObjectType(ECollisionChannel Channel) { BodyInstance.SetObjectType(Channel); }

ECollisionChannel UPrimitiveComponent::GetCollisionObjectType() const { return BodyInstance.GetObjectType(); }

void UPrimitiveComponent::SetCollisionResponseToChannel(ECollisionChannel Channel, ECollisionResponse NewResponse) {
    BodyInstance.SetResponseToChannel(Channel, NewResponse);
}

void UPrimitiveComponent::SetCollisionResponseToAllChannels(ECollisionResponse NewResponse) {
    BodyInstance.SetResponseToAllChannels(NewResponse);
}

void UPrimitiveComponent::SetCollisionResponseToChannels(const FCollisionResponseContainer& NewReponses) {
    BodyInstance.SetResponseToChannels(NewReponses);
}

ECollisionResponse UPrimitiveComponent::GetCollisionResponseToChannel(ECollisionChannel Channel) const {
    return BodyInstance.GetResponseToChannel(Channel);
}

const FCollisionResponseContainer& UPrimitiveComponent::GetCollisionResponseToChannels() const {
    return BodyInstance.GetResponseToChannels();
}

// ----------------------------------------------------------------------------------------------------------- materials

UMaterialInterface* UPrimitiveComponent::GetMaterial(int32) const { return nullptr; }

UMaterialInterface* UPrimitiveComponent::GetMaterialByName(FName) const { return nullptr; }

void UPrimitiveComponent::SetMaterial(int32, UMaterialInterface*) {
    UE_LOG(LogPrimitiveComponent, Warning, TEXT("SetMaterial of '%s': a '%s' has no materials"), *GetPathName(),
        *GetClass()->GetName());
}

void UPrimitiveComponent::SetMaterialByName(FName, UMaterialInterface*) {
    UE_LOG(LogPrimitiveComponent, Warning, TEXT("SetMaterialByName of '%s': a '%s' has no materials"), *GetPathName(),
        *GetClass()->GetName());
}

int32 UPrimitiveComponent::GetNumMaterials() const { return 0; }

UMaterialInstanceDynamic* UPrimitiveComponent::CreateAndSetMaterialInstanceDynamic(int32 ElementIndex) {
    return CreateDynamicMaterialInstance(ElementIndex);
}

UMaterialInstanceDynamic* UPrimitiveComponent::CreateAndSetMaterialInstanceDynamicFromMaterial(
    int32 ElementIndex, UMaterialInterface* Parent) {
    return CreateDynamicMaterialInstance(ElementIndex, Parent);
}

UMaterialInstanceDynamic* UPrimitiveComponent::CreateDynamicMaterialInstance(
    int32 ElementIndex, UMaterialInterface* SourceMaterial, FName OptionalName) {
    if (ElementIndex < 0 || ElementIndex >= GetNumMaterials()) {
        UE_LOG(LogPrimitiveComponent, Warning,
            TEXT("CreateDynamicMaterialInstance of '%s': element %d does not exist, there are %d"), *GetPathName(),
            ElementIndex, GetNumMaterials());
        return nullptr;
    }
    UMaterialInterface* const Source = SourceMaterial ? SourceMaterial : GetMaterial(ElementIndex);
    if (!Source) {
        UE_LOG(LogPrimitiveComponent, Warning,
            TEXT("CreateDynamicMaterialInstance of '%s': element %d has no material and none was given"),
            *GetPathName(), ElementIndex);
        return nullptr;
    }
    // An element that has a dynamic instance already keeps it, unless another source is wanted.
    UMaterialInstanceDynamic* Instance = SourceMaterial ? nullptr : Cast<UMaterialInstanceDynamic>(Source);
    if (!Instance) {
        Instance = UMaterialInstanceDynamic::Create(Source, this, OptionalName);
        SetMaterial(ElementIndex, Instance);
    }
    return Instance;
}

void UPrimitiveComponent::GetUsedMaterials(TArray<UMaterialInterface*>& OutMaterials, bool) const {
    for (int32 Index = 0; Index < GetNumMaterials(); ++Index) {
        if (UMaterialInterface* const Material = GetMaterial(Index)) {
            OutMaterials.Add(Material);
        }
    }
}

// ------------------------------------------------------------------------------------------------------------- setters

void UPrimitiveComponent::SetRenderInMainPass(bool bValue) {
    bRenderInMainPass = bValue;
    MarkRenderStateDirty();
}

void UPrimitiveComponent::SetRenderInDepthPass(bool bValue) {
    bRenderInDepthPass = bValue;
    MarkRenderStateDirty();
}

void UPrimitiveComponent::SetVisibleInSceneCaptureOnly(bool bValue) {
    bVisibleInSceneCaptureOnly = bValue;
    MarkRenderStateDirty();
}

void UPrimitiveComponent::SetHiddenInSceneCapture(bool bValue) {
    bHiddenInSceneCapture = bValue;
    MarkRenderStateDirty();
}

void UPrimitiveComponent::SetCastShadow(bool NewCastShadow) {
    CastShadow = NewCastShadow;
    MarkRenderStateDirty();
}

void UPrimitiveComponent::SetCastHiddenShadow(bool NewCastHiddenShadow) {
    bCastHiddenShadow = NewCastHiddenShadow;
    MarkRenderStateDirty();
}

void UPrimitiveComponent::SetAffectDistanceFieldLighting(bool NewAffectDistanceFieldLighting) {
    bAffectDistanceFieldLighting = NewAffectDistanceFieldLighting;
    MarkRenderStateDirty();
}

void UPrimitiveComponent::SetAffectDynamicIndirectLighting(bool bNewAffectDynamicIndirectLighting) {
    bAffectDynamicIndirectLighting = bNewAffectDynamicIndirectLighting;
    MarkRenderStateDirty();
}

void UPrimitiveComponent::SetVisibleInRayTracing(bool bNewVisibleInRayTracing) {
    bVisibleInRayTracing = bNewVisibleInRayTracing;
    MarkRenderStateDirty();
}

void UPrimitiveComponent::SetOwnerNoSee(bool bNewOwnerNoSee) {
    bOwnerNoSee = bNewOwnerNoSee;
    MarkRenderStateDirty();
}

void UPrimitiveComponent::SetOnlyOwnerSee(bool bNewOnlyOwnerSee) {
    bOnlyOwnerSee = bNewOnlyOwnerSee;
    MarkRenderStateDirty();
}

void UPrimitiveComponent::SetRenderCustomDepth(bool bValue) {
    bRenderCustomDepth = bValue;
    MarkRenderStateDirty();
}

void UPrimitiveComponent::SetCustomDepthStencilValue(int32 Value) {
    CustomDepthStencilValue = FMath::Clamp(Value, 0, 255);
    MarkRenderStateDirty();
}

void UPrimitiveComponent::SetReceivesDecals(bool bNewReceivesDecals) {
    bReceivesDecals = bNewReceivesDecals;
    MarkRenderStateDirty();
}

void UPrimitiveComponent::SetTranslucentSortPriority(int32 NewTranslucentSortPriority) {
    TranslucencySortPriority = NewTranslucentSortPriority;
    MarkRenderStateDirty();
}

void UPrimitiveComponent::SetCullDistance(float NewCullDistance) {
    LDMaxDrawDistance = NewCullDistance;
    CachedMaxDrawDistance = NewCullDistance;
    MarkRenderStateDirty();
}

void UPrimitiveComponent::SetBoundsScale(float NewBoundsScale) {
    BoundsScale = NewBoundsScale;
    UpdateBounds();
    MarkRenderTransformDirty();
}

void UPrimitiveComponent::SetLightingChannels(bool bChannel0, bool bChannel1, bool bChannel2) {
    LightingChannels.bChannel0 = bChannel0;
    LightingChannels.bChannel1 = bChannel1;
    LightingChannels.bChannel2 = bChannel2;
    MarkRenderStateDirty();
}

void UPrimitiveComponent::UpdateBounds() {
    Super::UpdateBounds();
    if (!(bUseAttachParentBound && GetAttachParent())) {
        Bounds.BoxExtent = Bounds.BoxExtent * static_cast<double>(BoundsScale);
        Bounds.SphereRadius = Bounds.SphereRadius * BoundsScale;
    }
}
