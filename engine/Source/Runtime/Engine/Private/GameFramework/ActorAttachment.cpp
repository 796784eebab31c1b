// SPDX-License-Identifier: MIT
/** @file Attachment of actors: that of their root component. */
#include "Components/SceneComponent.h"
#include "GameFramework/Actor.h"

DEFINE_LOG_CATEGORY_STATIC(LogActorAttachment, Log, All);

bool AActor::AttachToComponent(
    USceneComponent* Parent, const FAttachmentTransformRules& AttachmentRules, FName SocketName) {
    if (!Parent) {
        UE_LOG(LogActorAttachment, Warning, TEXT("AttachToComponent of %s: there is no parent component"), *GetName());
        return false;
    }
    return RootComponent && RootComponent->AttachToComponent(Parent, AttachmentRules, SocketName);
}

bool AActor::K2_AttachToComponent(USceneComponent* Parent, FName SocketName, EAttachmentRule LocationRule,
    EAttachmentRule RotationRule, EAttachmentRule ScaleRule, bool bWeldSimulatedBodies) {
    return AttachToComponent(
        Parent, FAttachmentTransformRules(LocationRule, RotationRule, ScaleRule, bWeldSimulatedBodies), SocketName);
}

bool AActor::AttachToActor(AActor* ParentActor, const FAttachmentTransformRules& AttachmentRules, FName SocketName) {
    if (!ParentActor || ParentActor == this) {
        UE_LOG(LogActorAttachment, Warning, TEXT("AttachToActor of %s: the parent is %s"), *GetName(),
            ParentActor ? TEXT("the actor itself") : TEXT("null"));
        return false;
    }
    USceneComponent* Parent = ParentActor->GetDefaultAttachComponent();
    return RootComponent && Parent && RootComponent->AttachToComponent(Parent, AttachmentRules, SocketName);
}

bool AActor::K2_AttachToActor(AActor* ParentActor, FName SocketName, EAttachmentRule LocationRule,
    EAttachmentRule RotationRule, EAttachmentRule ScaleRule, bool bWeldSimulatedBodies) {
    return AttachToActor(ParentActor,
        FAttachmentTransformRules(LocationRule, RotationRule, ScaleRule, bWeldSimulatedBodies), SocketName);
}

void AActor::DetachFromActor(const FDetachmentTransformRules& DetachmentRules) {
    if (RootComponent) {
        RootComponent->DetachFromComponent(DetachmentRules);
    }
}

void AActor::K2_DetachFromActor(EDetachmentRule LocationRule, EDetachmentRule RotationRule, EDetachmentRule ScaleRule) {
    DetachFromActor(FDetachmentTransformRules(LocationRule, RotationRule, ScaleRule, true));
}

void AActor::DetachAllSceneComponents(
    USceneComponent* InParentComponent, const FDetachmentTransformRules& DetachmentRules) {
    ForEachComponent<USceneComponent>(false, [InParentComponent, &DetachmentRules](USceneComponent* Component) {
        if (InParentComponent && Component->GetAttachParent() == InParentComponent) {
            Component->DetachFromComponent(DetachmentRules);
        }
    });
}

AActor* AActor::GetAttachParentActor() const {
    const USceneComponent* Parent = RootComponent ? RootComponent->GetAttachParent() : nullptr;
    return Parent ? Parent->GetOwner() : nullptr;
}

FName AActor::GetAttachParentSocketName() const {
    return GetAttachParentActor() ? RootComponent->GetAttachSocketName() : NAME_None;
}

void AActor::ForEachAttachedActors(TFunctionRef<bool(AActor*)> Functor) const {
    TArray<AActor*> Attached;
    for (const TObjectPtr<UActorComponent>& Component : OwnedComponents) {
        if (const USceneComponent* SceneComponent = Cast<USceneComponent>(Component.Get())) {
            for (const USceneComponent* Child : SceneComponent->GetAttachChildren()) {
                AActor* ChildOwner = Child ? Child->GetOwner() : nullptr;
                if (ChildOwner && ChildOwner != this) {
                    Attached.AddUnique(ChildOwner);
                }
            }
        }
    }
    for (AActor* Actor : Attached) {
        if (!Functor(Actor)) {
            return;
        }
    }
}

void AActor::GetAttachedActors(
    TArray<AActor*>& OutActors, bool bResetArray, bool bRecursivelyIncludeAttachedActors) const {
    if (bResetArray) {
        OutActors.Reset();
    }
    ForEachAttachedActors([&OutActors, bRecursivelyIncludeAttachedActors](AActor* Actor) {
        if (!OutActors.Contains(Actor)) {
            OutActors.Add(Actor);
            if (bRecursivelyIncludeAttachedActors) {
                Actor->GetAttachedActors(OutActors, false, true);
            }
        }
        return true;
    });
}

bool AActor::IsAttachedTo(const AActor* Other) const {
    for (const AActor* Actor = GetAttachParentActor(); Actor; Actor = Actor->GetAttachParentActor()) {
        if (Actor == Other) {
            return true;
        }
    }
    return false;
}
