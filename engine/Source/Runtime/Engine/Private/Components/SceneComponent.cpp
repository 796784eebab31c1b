// SPDX-License-Identifier: MIT
#include "Components/SceneComponent.h"

#include "Engine/World.h"
#include "GameFramework/Actor.h"

DEFINE_LOG_CATEGORY_STATIC(LogSceneComponent, Log, All);

namespace {

// Rotations that differ by less are the same rotation: what a conversion to another space and back loses.
constexpr double QuatTolerance = 1.e-8;

} // namespace

USceneComponent::USceneComponent(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    AttachParent = nullptr;
    AttachSocketName = NAME_None;
    RelativeLocation = FVector(0.0, 0.0, 0.0);
    RelativeRotation = FRotator(0.0, 0.0, 0.0);
    RelativeScale3D = FVector(1.0, 1.0, 1.0);
    ComponentVelocity = FVector(0.0, 0.0, 0.0);
    bAbsoluteLocation = false;
    bAbsoluteRotation = false;
    bAbsoluteScale = false;
    bVisible = true;
    bHiddenInGame = false;
    bUseAttachParentBound = false;
    Mobility = EComponentMobility::Movable;
    Bounds = FBoxSphereBounds(FVector(0.0, 0.0, 0.0), FVector(0.0, 0.0, 0.0), 0.0);
    ComponentToWorld = FTransform(FQuat(0.0, 0.0, 0.0, 1.0), FVector(0.0, 0.0, 0.0), FVector(1.0, 1.0, 1.0));
    bComponentToWorldUpdated = false;
    CachedRelativeQuat = FQuat(0.0, 0.0, 0.0, 1.0);
    CachedRelativeRotator = FRotator(0.0, 0.0, 0.0);
}

void USceneComponent::PostInitProperties() {
    Super::PostInitProperties();
    // Properties copied from another instance bring its list of children along; they are attached to that one, not to
    // this.
    AttachChildren.RemoveAll(
        [this](const TObjectPtr<USceneComponent>& Child) { return !Child || Child->AttachParent != this; });
}

// ------------------------------------------------------------------------------------------------------ register,
// destroy

void USceneComponent::OnRegister() {
    if (AttachParent) {
        if (AttachParent == this ||
            !AttachToComponent(AttachParent, FAttachmentTransformRules::KeepRelativeTransform, AttachSocketName)) {
            AttachParent = nullptr;
            AttachSocketName = NAME_None;
        }
    }
    Super::OnRegister();
    UpdateComponentToWorld();
}

void USceneComponent::OnUnregister() { Super::OnUnregister(); }

void USceneComponent::DestroyComponent(bool bPromoteChildren) {
    if (bPromoteChildren) {
        AActor* const Owner = GetOwner();
        USceneComponent* NewParent = AttachParent;
        TArray<USceneComponent*> Children;
        GetChildrenComponents(false, Children);
        for (USceneComponent* Child : Children) {
            if (Owner && Owner->GetRootComponent() == this && Child->GetOwner() == Owner) {
                // The first child takes our place, under our parent.
                Owner->SetRootComponent(Child);
                if (NewParent) {
                    Child->AttachToComponent(
                        NewParent, FAttachmentTransformRules::KeepWorldTransform, AttachSocketName);
                } else {
                    Child->DetachFromComponent(FDetachmentTransformRules::KeepWorldTransform);
                }
                NewParent = Child;
            } else if (NewParent) {
                Child->AttachToComponent(NewParent, FAttachmentTransformRules::KeepWorldTransform);
            }
        }
    }
    Super::DestroyComponent(bPromoteChildren);
}

void USceneComponent::OnComponentDestroyed(bool bDestroyingHierarchy) {
    Super::OnComponentDestroyed(bDestroyingHierarchy);
    TArray<USceneComponent*> Children;
    GetChildrenComponents(false, Children);
    for (USceneComponent* Child : Children) {
        // Children that go down with us keep their parent; the others stay where they are in the world.
        if (!bDestroyingHierarchy || Child->GetOwner() != GetOwner()) {
            Child->DetachFromComponent(FDetachmentTransformRules::KeepWorldTransform);
        }
    }
    if (AttachParent && (!bDestroyingHierarchy || AttachParent->GetOwner() != GetOwner())) {
        DetachFromComponent(FDetachmentTransformRules::KeepWorldTransform);
    }
}

// ------------------------------------------------------------------------------------------------------------ relative

FQuat USceneComponent::GetRelativeQuat() const {
    return RelativeRotation == CachedRelativeRotator ? CachedRelativeQuat : RelativeRotation.Quaternion();
}

void USceneComponent::SetRelativeRotationExactly(const FQuat& NewRotation) {
    if (NewRotation.Equals(CachedRelativeQuat, QuatTolerance)) {
        // The angles that were asked for last are kept: many triples of angles are one rotation.
        RelativeRotation = CachedRelativeRotator;
        return;
    }
    CachedRelativeQuat = NewRotation;
    CachedRelativeRotator = NewRotation.Rotator();
    RelativeRotation = CachedRelativeRotator;
}

FQuat USceneComponent::RememberedQuat(const FRotator& Rotation) {
    CachedRelativeRotator = Rotation.GetNormalized();
    CachedRelativeQuat = CachedRelativeRotator.Quaternion();
    return CachedRelativeQuat;
}

FTransform USceneComponent::GetRelativeTransform() const {
    return FTransform(GetRelativeQuat(), RelativeLocation, RelativeScale3D);
}

FTransform USceneComponent::CalcNewComponentToWorld(
    const FTransform& NewRelativeTransform, const USceneComponent* Parent, FName SocketName) const {
    if (!Parent) {
        Parent = AttachParent;
        SocketName = AttachSocketName;
    }
    if (!Parent) {
        return NewRelativeTransform;
    }
    FTransform Result = NewRelativeTransform * Parent->GetSocketTransform(SocketName);
    if (bAbsoluteLocation) {
        Result.SetLocation(NewRelativeTransform.GetLocation());
    }
    if (bAbsoluteRotation) {
        Result.SetRotation(NewRelativeTransform.GetRotation());
    }
    if (bAbsoluteScale) {
        Result.SetScale3D(NewRelativeTransform.GetScale3D());
    }
    return Result;
}

// -------------------------------------------------------------------------------------------------------------- update

void USceneComponent::SetComponentToWorld(const FTransform& NewComponentToWorld) {
    bComponentToWorldUpdated = true;
    ComponentToWorld = NewComponentToWorld;
}

void USceneComponent::UpdateComponentToWorld(EUpdateTransformFlags UpdateTransformFlags, ETeleportType Teleport) {
    UpdateComponentToWorldWithParent(AttachParent, AttachSocketName, UpdateTransformFlags, GetRelativeQuat(), Teleport);
}

void USceneComponent::ConditionalUpdateComponentToWorld() {
    if (!bComponentToWorldUpdated) {
        UpdateComponentToWorld();
    }
}

void USceneComponent::UpdateComponentToWorldWithParent(USceneComponent* Parent, FName SocketName,
    EUpdateTransformFlags UpdateTransformFlags, const FQuat& RelativeRotationQuat, ETeleportType Teleport) {
    if (Parent && !Parent->bComponentToWorldUpdated) {
        Parent->UpdateComponentToWorld();
        if (bComponentToWorldUpdated) {
            return; // the parent's update has reached us
        }
    }
    bComponentToWorldUpdated = true;
    const FTransform RelativeTransform(RelativeRotationQuat, RelativeLocation, RelativeScale3D);
    const FTransform NewTransform = CalcNewComponentToWorld(RelativeTransform, Parent, SocketName);
    if (ComponentToWorld.Equals(NewTransform, QuatTolerance)) {
        PropagateTransformUpdate(false);
        return;
    }
    ComponentToWorld = NewTransform;
    PropagateTransformUpdate(true, UpdateTransformFlags, Teleport);
}

void USceneComponent::PropagateTransformUpdate(
    bool bTransformChanged, EUpdateTransformFlags UpdateTransformFlags, ETeleportType Teleport) {
    UpdateBounds();
    if (!bTransformChanged) {
        for (const TObjectPtr<USceneComponent>& Child : AttachChildren) {
            if (Child && Child->bUseAttachParentBound) {
                Child->UpdateBounds();
            }
        }
        return;
    }
    if (IsRegistered()) {
        OnUpdateTransform(UpdateTransformFlags, Teleport);
        MarkRenderTransformDirty();
    }
    TransformUpdated.Broadcast(this, UpdateTransformFlags, Teleport);
    UpdateChildTransforms(UpdateTransformFlags, Teleport);
}

void USceneComponent::UpdateChildTransforms(EUpdateTransformFlags UpdateTransformFlags, ETeleportType Teleport) {
    if (AttachChildren.Num() == 0) {
        return;
    }
    const bool bOnlySockets = EnumHasAnyFlags(UpdateTransformFlags, EUpdateTransformFlags::OnlyUpdateIfUsingSocket);
    const EUpdateTransformFlags ChildFlags = (UpdateTransformFlags & ~EUpdateTransformFlags::OnlyUpdateIfUsingSocket) |
                                             EUpdateTransformFlags::PropagateFromParent;
    // A listener may attach or detach while we update.
    const TArray<TObjectPtr<USceneComponent>> Children = AttachChildren;
    for (const TObjectPtr<USceneComponent>& Child : Children) {
        if (Child && Child->AttachParent == this && (!bOnlySockets || !Child->AttachSocketName.IsNone())) {
            Child->UpdateComponentToWorld(ChildFlags, Teleport);
        }
    }
}

void USceneComponent::OnUpdateTransform(EUpdateTransformFlags, ETeleportType) {}

// ---------------------------------------------------------------------------------------------------------------- move

bool USceneComponent::CheckStaticMobilityAndWarn(const TCHAR* ActionText) const {
    if (Mobility == EComponentMobility::Movable || !IsRegistered()) {
        return false;
    }
    const UWorld* const World = GetWorld();
    const AActor* const Owner = GetOwner();
    if (!World || !World->IsGameWorld() || !World->bIsWorldInitialized || !Owner || !Owner->IsActorInitialized()) {
        return false;
    }
    UE_LOG(LogSceneComponent, Warning,
        TEXT("The mobility of '%s' has to be 'Movable' if you would like to %s: call SetMobility first"),
        *GetPathName(), ActionText);
    return true;
}

bool USceneComponent::MoveComponent(const FVector& Delta, const FQuat& NewRotation, bool bSweep, FHitResult* Hit,
    EMoveComponentFlags MoveFlags, ETeleportType Teleport) {
    return MoveComponentImpl(Delta, NewRotation, bSweep, Hit, MoveFlags, Teleport);
}

bool USceneComponent::MoveComponent(const FVector& Delta, const FRotator& NewRotation, bool bSweep, FHitResult* Hit,
    EMoveComponentFlags MoveFlags, ETeleportType Teleport) {
    return MoveComponentImpl(Delta, NewRotation.Quaternion(), bSweep, Hit, MoveFlags, Teleport);
}

bool USceneComponent::MoveComponentImpl(const FVector& Delta, const FQuat& NewRotation, bool, FHitResult* OutHit,
    EMoveComponentFlags, ETeleportType Teleport) {
    ConditionalUpdateComponentToWorld();
    const FVector Start = ComponentToWorld.GetLocation();
    if (!::IsValid(this) || CheckStaticMobilityAndWarn(TEXT("move it"))) {
        if (OutHit) {
            *OutHit = FHitResult(Start, Start);
        }
        return false;
    }
    if (OutHit) {
        *OutHit = FHitResult(Start, Start + Delta);
    }
    if (Delta.IsZero() && NewRotation.Equals(ComponentToWorld.GetRotation(), QuatTolerance)) {
        return true;
    }
    return InternalSetWorldLocationAndRotation(Start + Delta, NewRotation, Teleport);
}

bool USceneComponent::InternalSetWorldLocationAndRotation(
    const FVector& NewLocation, const FQuat& NewRotation, ETeleportType Teleport) {
    FVector Location = NewLocation;
    FQuat Rotation = NewRotation;
    if (AttachParent) {
        const FTransform ParentToWorld = AttachParent->GetSocketTransform(AttachSocketName);
        const FTransform Relative =
            FTransform(NewRotation, NewLocation, ComponentToWorld.GetScale3D()).GetRelativeTransform(ParentToWorld);
        if (!bAbsoluteLocation) {
            Location = Relative.GetLocation();
        }
        if (!bAbsoluteRotation) {
            Rotation = Relative.GetRotation();
        }
    }
    RelativeLocation = Location;
    SetRelativeRotationExactly(Rotation);
    UpdateComponentToWorldWithParent(
        AttachParent, AttachSocketName, EUpdateTransformFlags::None, GetRelativeQuat(), Teleport);
    return true;
}

// -------------------------------------------------------------------------------------------------------------- bounds

FBoxSphereBounds USceneComponent::CalcBounds(const FTransform& LocalToWorld) const {
    return FBoxSphereBounds(LocalToWorld.GetLocation(), FVector(0.0, 0.0, 0.0), 0.0);
}

FBoxSphereBounds USceneComponent::CalcLocalBounds() const {
    return CalcBounds(FTransform(FQuat(0.0, 0.0, 0.0, 1.0), FVector(0.0, 0.0, 0.0), FVector(1.0, 1.0, 1.0)));
}

void USceneComponent::UpdateBounds() {
    Bounds = bUseAttachParentBound && AttachParent ? AttachParent->Bounds : CalcBounds(ComponentToWorld);
}

// ------------------------------------------------------------------------------------------------- visibility,
// mobility

bool USceneComponent::IsVisible() const { return bVisible; }

bool USceneComponent::ShouldRender() const {
    const AActor* const Owner = GetOwner();
    return bVisible && !bHiddenInGame && !(Owner && Owner->IsHidden());
}

void USceneComponent::SetVisibility(bool bNewVisibility, bool bPropagateToChildren) {
    if (bVisible != bNewVisibility) {
        bVisible = bNewVisibility;
        OnVisibilityChanged();
    }
    if (bPropagateToChildren) {
        const TArray<TObjectPtr<USceneComponent>> Children = AttachChildren;
        for (const TObjectPtr<USceneComponent>& Child : Children) {
            if (Child) {
                Child->SetVisibility(bNewVisibility, true);
            }
        }
    }
}

void USceneComponent::ToggleVisibility(bool bPropagateToChildren) { SetVisibility(!bVisible, bPropagateToChildren); }

void USceneComponent::SetHiddenInGame(bool NewHidden, bool bPropagateToChildren) {
    if (bHiddenInGame != NewHidden) {
        bHiddenInGame = NewHidden;
        OnHiddenInGameChanged();
    }
    if (bPropagateToChildren) {
        const TArray<TObjectPtr<USceneComponent>> Children = AttachChildren;
        for (const TObjectPtr<USceneComponent>& Child : Children) {
            if (Child) {
                Child->SetHiddenInGame(NewHidden, true);
            }
        }
    }
}

void USceneComponent::OnVisibilityChanged() { MarkRenderStateDirty(); }

void USceneComponent::OnHiddenInGameChanged() { MarkRenderStateDirty(); }

void USceneComponent::SetMobility(EComponentMobility::Type NewMobility) {
    if (Mobility != NewMobility) {
        Mobility = NewMobility;
        MarkRenderStateDirty();
    }
}

FVector USceneComponent::GetComponentVelocity() const { return ComponentVelocity; }
