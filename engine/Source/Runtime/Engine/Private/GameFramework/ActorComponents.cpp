// SPDX-License-Identifier: MIT
/** @file The components of actors. */
#include "Components/PrimitiveComponent.h"
#include "Components/SceneComponent.h"
#include "Engine/World.h"
#include "GameFramework/Actor.h"

DEFINE_LOG_CATEGORY_STATIC(LogActorComponents, Log, All);

void AActor::AddOwnedComponent(UActorComponent* Component) {
    check(Component->GetOwner() == this);
    OwnedComponents.AddUnique(Component);
}

void AActor::RemoveOwnedComponent(UActorComponent* Component) {
    OwnedComponents.Remove(Component);
    BlueprintCreatedComponents.Remove(Component);
    InstanceComponents.Remove(Component);
}

void AActor::AddInstanceComponent(UActorComponent* Component) {
    Component->CreationMethod = EComponentCreationMethod::Instance;
    InstanceComponents.AddUnique(Component);
}

void AActor::RemoveInstanceComponent(UActorComponent* Component) { InstanceComponents.Remove(Component); }

const TArray<UActorComponent*>& AActor::GetInstanceComponents() const { return ObjectPtrDecay(InstanceComponents); }

UActorComponent* AActor::AddComponentByClass(TSubclassOf<UActorComponent> Class, bool bManualAttachment,
    const FTransform& RelativeTransform, bool bDeferredFinish) {
    if (!Class || Class->HasAnyClassFlags(CLASS_Abstract | CLASS_Deprecated)) {
        UE_LOG(LogActorComponents, Warning,
            TEXT("AddComponentByClass on %s: %s cannot be created; pass a component class that is not abstract"),
            *GetName(), *GetNameSafe(Class.Get()));
        return nullptr;
    }
    UActorComponent* Component = NewObject<UActorComponent>(this, Class.Get());
    if (!bDeferredFinish) {
        FinishAddComponent(Component, bManualAttachment, RelativeTransform);
    }
    return Component;
}

void AActor::FinishAddComponent(
    UActorComponent* Component, bool bManualAttachment, const FTransform& RelativeTransform) {
    if (!Component || Component->GetOwner() != this || Component->IsRegistered()) {
        return;
    }
    Component->CreationMethod = EComponentCreationMethod::UserConstructionScript;
    BlueprintCreatedComponents.AddUnique(Component);
    if (!Component->HasBeenCreated()) {
        Component->OnComponentCreated();
    }
    USceneComponent* SceneComponent = Cast<USceneComponent>(Component);
    if (SceneComponent && !bManualAttachment) {
        if (RootComponent) {
            SceneComponent->SetupAttachment(RootComponent);
        } else {
            RootComponent = SceneComponent;
        }
        SceneComponent->SetRelativeTransform(RelativeTransform);
    }
    if (GetWorld()) {
        Component->RegisterComponent();
    }
}

// ---------------------------------------------------------------------------------------------------------------
// finding

UActorComponent* AActor::FindComponentByClass(const TSubclassOf<UActorComponent> ComponentClass) const {
    if (ComponentClass) {
        for (const TObjectPtr<UActorComponent>& Component : OwnedComponents) {
            if (Component->IsA(ComponentClass.Get())) {
                return Component;
            }
        }
    }
    return nullptr;
}

UActorComponent* AActor::GetComponentByClass(TSubclassOf<UActorComponent> ComponentClass) const {
    return FindComponentByClass(ComponentClass);
}

TArray<UActorComponent*> AActor::K2_GetComponentsByClass(TSubclassOf<UActorComponent> ComponentClass) const {
    TArray<UActorComponent*> Result;
    GetComponents(ComponentClass, Result);
    return Result;
}

void AActor::GetComponents(
    TSubclassOf<UActorComponent> ComponentClass, TArray<UActorComponent*>& OutComponents, bool) const {
    OutComponents.Reset();
    for (const TObjectPtr<UActorComponent>& Component : OwnedComponents) {
        if (ComponentClass && Component->IsA(ComponentClass.Get())) {
            OutComponents.Add(Component);
        }
    }
}

TArray<UActorComponent*> AActor::GetComponentsByTag(TSubclassOf<UActorComponent> ComponentClass, FName Tag) const {
    TArray<UActorComponent*> Result;
    GetComponents(ComponentClass, Result);
    Result.RemoveAll([Tag](const UActorComponent* Component) { return !Component->ComponentHasTag(Tag); });
    return Result;
}

UActorComponent* AActor::FindComponentByTag(TSubclassOf<UActorComponent> ComponentClass, FName Tag) const {
    for (const TObjectPtr<UActorComponent>& Component : OwnedComponents) {
        if (ComponentClass && Component->IsA(ComponentClass.Get()) && Component->ComponentHasTag(Tag)) {
            return Component;
        }
    }
    return nullptr;
}

TArray<UActorComponent*> AActor::GetComponentsByInterface(TSubclassOf<UInterface> Interface) const {
    TArray<UActorComponent*> Result;
    for (const TObjectPtr<UActorComponent>& Component : OwnedComponents) {
        if (Interface && Component->GetClass()->ImplementsInterface(Interface.Get())) {
            Result.Add(Component);
        }
    }
    return Result;
}

// ----------------------------------------------------------------------------------------------------------
// registration

void AActor::RegisterAllComponents() {
    UWorld* World = GetWorld();
    if (!World) {
        return;
    }
    PreRegisterAllComponents();
    // By index: registering may create components. Parents first, so that a child finds its parent's transform.
    for (int32 Index = 0; Index < OwnedComponents.Num(); ++Index) {
        UActorComponent* Component = OwnedComponents[Index];
        while (!Component->IsRegistered() && Component->bAutoRegister && IsValid(Component)) {
            UActorComponent* Next = Component;
            for (;;) {
                const USceneComponent* Scene = Cast<USceneComponent>(Next);
                USceneComponent* Parent = Scene ? Scene->GetAttachParent() : nullptr;
                if (!Parent || Parent->GetOwner() != this || Parent->IsRegistered() || !Parent->bAutoRegister ||
                    !IsValid(Parent)) {
                    break;
                }
                Next = Parent;
            }
            Next->RegisterComponentWithWorld(World);
            if (!Next->IsRegistered()) {
                // Refused (for instance the actor is being destroyed): going on would not end.
                break;
            }
        }
    }
    bHasRegisteredAllComponents = true;
    PostRegisterAllComponents();
}

void AActor::UnregisterAllComponents(bool) {
    const TArray<TObjectPtr<UActorComponent>> Components = OwnedComponents;
    for (UActorComponent* Component : Components) {
        if (Component->IsRegistered()) {
            Component->UnregisterComponent();
        }
    }
    bHasRegisteredAllComponents = false;
}

void AActor::MarkComponentsAsGarbage(bool) {
    const TArray<TObjectPtr<UActorComponent>> Components = OwnedComponents;
    for (UActorComponent* Component : Components) {
        if (IsValid(Component)) {
            Component->bIsBeingDestroyed = true;
            Component->OnComponentDestroyed(true);
            Component->MarkAsGarbage();
        }
    }
}

void AActor::MarkComponentsRenderStateDirty() {
    for (const TObjectPtr<UActorComponent>& Component : OwnedComponents) {
        if (Component->IsRegistered()) {
            Component->MarkRenderStateDirty();
        }
    }
}

void AActor::UpdateComponentTransforms() {
    for (const TObjectPtr<UActorComponent>& Component : OwnedComponents) {
        USceneComponent* Scene = Cast<USceneComponent>(Component.Get());
        if (Scene && Scene->IsRegistered()) {
            Scene->UpdateComponentToWorld();
        }
    }
}

USceneComponent* AActor::K2_GetRootComponent() const { return RootComponent; }

bool AActor::SetRootComponent(USceneComponent* NewRootComponent) {
    if (NewRootComponent && NewRootComponent->GetOwner() != this) {
        UE_LOG(LogActorComponents, Warning,
            TEXT("SetRootComponent on %s: %s belongs to %s; create it with this actor as outer"), *GetName(),
            *NewRootComponent->GetName(), *GetNameSafe(NewRootComponent->GetOwner()));
        return false;
    }
    RootComponent = NewRootComponent;
    return true;
}

FBox AActor::GetComponentsBoundingBox(bool bNonColliding, bool) const {
    FBox Box(ForceInit);
    ForEachComponent<UPrimitiveComponent>(false, [&Box, bNonColliding](const UPrimitiveComponent* Primitive) {
        if (Primitive->IsRegistered() &&
            (bNonColliding || Primitive->GetCollisionEnabled() != ECollisionEnabled::NoCollision)) {
            Box += Primitive->Bounds.GetBox();
        }
    });
    return Box;
}

void AActor::GetActorBounds(
    bool bOnlyCollidingComponents, FVector& Origin, FVector& BoxExtent, bool bIncludeFromChildActors) const {
    GetComponentsBoundingBox(!bOnlyCollidingComponents, bIncludeFromChildActors).GetCenterAndExtents(Origin, BoxExtent);
}
