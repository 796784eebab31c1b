// SPDX-License-Identifier: MIT
#include "Components/SceneComponent.h"

#include "Engine/World.h"
#include "GameFramework/Actor.h"

DEFINE_LOG_CATEGORY_STATIC(LogAttachment, Log, All);

void USceneComponent::SetupAttachment(USceneComponent* InParent, FName InSocketName) {
    if (InParent == AttachParent && InSocketName == AttachSocketName) {
        return;
    }
    if (IsRegistered()) {
        UE_LOG(LogAttachment, Warning,
            TEXT("SetupAttachment of '%s' is for components that are not registered yet: call AttachToComponent"),
            *GetPathName());
        return;
    }
    if (InParent == this || (InParent && InParent->IsAttachedTo(this))) {
        UE_LOG(LogAttachment, Warning, TEXT("SetupAttachment of '%s' to '%s' would make a loop"), *GetPathName(),
            *GetNameSafe(InParent));
        return;
    }
    if (AttachParent) {
        AttachParent->AttachChildren.Remove(this);
    }
    AttachParent = InParent;
    AttachSocketName = InSocketName;
}

bool USceneComponent::K2_AttachToComponent(USceneComponent* Parent, FName SocketName, EAttachmentRule LocationRule,
    EAttachmentRule RotationRule, EAttachmentRule ScaleRule, bool bWeldSimulatedBodies) {
    return AttachToComponent(
        Parent, FAttachmentTransformRules(LocationRule, RotationRule, ScaleRule, bWeldSimulatedBodies), SocketName);
}

bool USceneComponent::AttachToComponent(
    USceneComponent* InParent, const FAttachmentTransformRules& AttachmentRules, FName InSocketName) {
    if (!InParent) {
        UE_LOG(LogAttachment, Warning, TEXT("'%s' cannot be attached: no parent was given"), *GetPathName());
        return false;
    }
    const bool bListed = InParent->AttachChildren.Contains(this);
    if (bListed && AttachParent == InParent && AttachSocketName == InSocketName) {
        return true;
    }
    if (InParent == this || InParent->IsAttachedTo(this)) {
        UE_LOG(LogAttachment, Warning, TEXT("'%s' cannot be attached to '%s': that would make a loop"), *GetPathName(),
            *InParent->GetPathName());
        return false;
    }
    if (!::IsValid(InParent)) {
        UE_LOG(LogAttachment, Warning, TEXT("'%s' cannot be attached to '%s': the parent is being destroyed"),
            *GetPathName(), *InParent->GetPathName());
        return false;
    }
    const AActor* const Owner = GetOwner();
    if (Mobility == EComponentMobility::Static && InParent->Mobility != EComponentMobility::Static && Owner &&
        Owner->IsActorInitialized()) {
        UE_LOG(LogAttachment, Warning,
            TEXT("'%s' is static and cannot be attached to '%s', which is not: call SetMobility first"), *GetPathName(),
            *InParent->GetPathName());
        return false;
    }

    // A parent that was only set up has no world transform of ours to keep.
    const bool bWasOnlySetUp = AttachParent == InParent && !bListed;
    if (!bWasOnlySetUp) {
        ConditionalUpdateComponentToWorld();
        DetachFromComponent(FDetachmentTransformRules(AttachmentRules, true));
    }
    InParent->ConditionalUpdateComponentToWorld();

    AttachParent = InParent;
    AttachSocketName = InSocketName;
    InParent->AttachChildren.Add(this);

    const FTransform Relative = ComponentToWorld.GetRelativeTransform(InParent->GetSocketTransform(InSocketName));
    switch (AttachmentRules.LocationRule) {
    case EAttachmentRule::KeepRelative:
        break;
    case EAttachmentRule::KeepWorld:
        RelativeLocation = bAbsoluteLocation ? ComponentToWorld.GetLocation() : Relative.GetLocation();
        break;
    case EAttachmentRule::SnapToTarget:
        RelativeLocation = FVector(0.0, 0.0, 0.0);
        break;
    }
    switch (AttachmentRules.RotationRule) {
    case EAttachmentRule::KeepRelative:
        break;
    case EAttachmentRule::KeepWorld:
        SetRelativeRotationExactly(bAbsoluteRotation ? ComponentToWorld.GetRotation() : Relative.GetRotation());
        break;
    case EAttachmentRule::SnapToTarget:
        SetRelativeRotationExactly(FQuat(0.0, 0.0, 0.0, 1.0));
        break;
    }
    switch (AttachmentRules.ScaleRule) {
    case EAttachmentRule::KeepRelative:
        break;
    case EAttachmentRule::KeepWorld:
        RelativeScale3D = bAbsoluteScale ? ComponentToWorld.GetScale3D() : Relative.GetScale3D();
        break;
    case EAttachmentRule::SnapToTarget:
        RelativeScale3D = FVector(1.0, 1.0, 1.0);
        break;
    }

    OnAttachmentChanged();
    InParent->OnChildAttached(this);
    UpdateComponentToWorld(EUpdateTransformFlags::None, ETeleportType::TeleportPhysics);
    return true;
}

void USceneComponent::K2_DetachFromComponent(
    EDetachmentRule LocationRule, EDetachmentRule RotationRule, EDetachmentRule ScaleRule, bool bCallModify) {
    DetachFromComponent(FDetachmentTransformRules(LocationRule, RotationRule, ScaleRule, bCallModify));
}

void USceneComponent::DetachFromComponent(const FDetachmentTransformRules& DetachmentRules) {
    USceneComponent* const Parent = AttachParent;
    if (!Parent) {
        return;
    }
    ConditionalUpdateComponentToWorld();
    Parent->AttachChildren.Remove(this);
    AttachParent = nullptr;
    AttachSocketName = NAME_None;
    if (DetachmentRules.LocationRule == EDetachmentRule::KeepWorld) {
        RelativeLocation = ComponentToWorld.GetLocation();
    }
    if (DetachmentRules.RotationRule == EDetachmentRule::KeepWorld) {
        SetRelativeRotationExactly(ComponentToWorld.GetRotation());
    }
    if (DetachmentRules.ScaleRule == EDetachmentRule::KeepWorld) {
        RelativeScale3D = ComponentToWorld.GetScale3D();
    }
    OnAttachmentChanged();
    Parent->OnChildDetached(this);
    UpdateComponentToWorld();
}

void USceneComponent::OnChildAttached(USceneComponent*) {}

void USceneComponent::OnChildDetached(USceneComponent*) {}

// ------------------------------------------------------------------------------------------------------------- queries

USceneComponent* USceneComponent::GetAttachParent() const { return AttachParent; }

FName USceneComponent::GetAttachSocketName() const { return AttachSocketName; }

USceneComponent* USceneComponent::GetAttachmentRoot() const {
    const USceneComponent* Top = this;
    while (Top->AttachParent) {
        Top = Top->AttachParent;
    }
    return const_cast<USceneComponent*>(Top);
}

AActor* USceneComponent::GetAttachmentRootActor() const { return GetAttachmentRoot()->GetOwner(); }

AActor* USceneComponent::GetAttachParentActor() const { return AttachParent ? AttachParent->GetOwner() : nullptr; }

bool USceneComponent::IsAttachedTo(const USceneComponent* TestComp) const {
    if (TestComp) {
        for (const USceneComponent* Component = AttachParent; Component; Component = Component->AttachParent) {
            if (Component == TestComp) {
                return true;
            }
        }
    }
    return false;
}

void USceneComponent::GetParentComponents(TArray<USceneComponent*>& Parents) const {
    Parents.Reset();
    for (USceneComponent* Component = AttachParent; Component; Component = Component->AttachParent) {
        Parents.Add(Component);
    }
}

int32 USceneComponent::GetNumChildrenComponents() const { return AttachChildren.Num(); }

USceneComponent* USceneComponent::GetChildComponent(int32 ChildIndex) const {
    return AttachChildren.IsValidIndex(ChildIndex) ? AttachChildren[ChildIndex].Get() : nullptr;
}

void USceneComponent::GetChildrenComponents(bool bIncludeAllDescendants, TArray<USceneComponent*>& Children) const {
    Children.Reset();
    for (const TObjectPtr<USceneComponent>& Child : AttachChildren) {
        if (Child) {
            Children.Add(Child);
        }
    }
    if (bIncludeAllDescendants) {
        // Breadth first: the list grows while we walk it.
        for (int32 Index = 0; Index < Children.Num(); ++Index) {
            const USceneComponent* const Component = Children[Index];
            for (const TObjectPtr<USceneComponent>& Child : Component->AttachChildren) {
                if (Child) {
                    Children.Add(Child);
                }
            }
        }
    }
}

// ------------------------------------------------------------------------------------------------------------- sockets

TArray<FName> USceneComponent::GetAllSocketNames() const {
    TArray<FComponentSocketDescription> Sockets;
    QuerySupportedSockets(Sockets);
    TArray<FName> Names;
    for (const FComponentSocketDescription& Socket : Sockets) {
        Names.Add(Socket.Name);
    }
    return Names;
}

FTransform USceneComponent::GetSocketTransform(FName, ERelativeTransformSpace TransformSpace) const {
    switch (TransformSpace) {
    case RTS_Actor: {
        const AActor* const Owner = GetOwner();
        return Owner ? ComponentToWorld.GetRelativeTransform(Owner->GetTransform()) : ComponentToWorld;
    }
    case RTS_Component:
    case RTS_ParentBoneSpace:
        return FTransform(FQuat(0.0, 0.0, 0.0, 1.0), FVector(0.0, 0.0, 0.0), FVector(1.0, 1.0, 1.0));
    default:
        return ComponentToWorld;
    }
}

FVector USceneComponent::GetSocketLocation(FName InSocketName) const {
    return GetSocketTransform(InSocketName, RTS_World).GetLocation();
}

FRotator USceneComponent::GetSocketRotation(FName InSocketName) const {
    return GetSocketTransform(InSocketName, RTS_World).Rotator();
}

FQuat USceneComponent::GetSocketQuaternion(FName InSocketName) const {
    return GetSocketTransform(InSocketName, RTS_World).GetRotation();
}

bool USceneComponent::DoesSocketExist(FName) const { return false; }

bool USceneComponent::HasAnySockets() const { return false; }

void USceneComponent::QuerySupportedSockets(TArray<FComponentSocketDescription>& OutSockets) const {
    OutSockets.Reset();
}
