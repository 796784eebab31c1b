// SPDX-License-Identifier: MIT
/** @file Spawning and destroying actors. */
#include "Components/SceneComponent.h"
#include "Engine/Engine.h"
#include "Engine/Level.h"
#include "Engine/World.h"
#include "GameFramework/Actor.h"
#include "GameFramework/WorldSettings.h"
#include "TimerManager.h"

FActorSpawnParameters::FActorSpawnParameters()
    : Name(NAME_None), Template(nullptr), Owner(nullptr), Instigator(nullptr), OverrideLevel(nullptr),
      SpawnCollisionHandlingOverride(ESpawnActorCollisionHandlingMethod::Undefined), bNoFail(false),
      bDeferConstruction(false), bAllowDuringConstructionScript(false), NameMode(ESpawnActorNameMode::Required_Fatal),
      ObjectFlags(RF_Transactional) {}

AActor* UWorld::SpawnActor(
    UClass* InClass, FVector const* Location, FRotator const* Rotation, const FActorSpawnParameters& SpawnParameters) {
    FTransform Transform;
    if (Location) {
        Transform.SetLocation(*Location);
    }
    if (Rotation) {
        Transform.SetRotation(FQuat(*Rotation));
    }
    return SpawnActorInternal(InClass, Transform, SpawnParameters);
}

AActor* UWorld::SpawnActor(UClass* Class, FTransform const* Transform, const FActorSpawnParameters& SpawnParameters) {
    return SpawnActorInternal(Class, Transform ? *Transform : FTransform::Identity, SpawnParameters);
}

AActor* UWorld::SpawnActorAbsolute(
    UClass* Class, FTransform const& AbsoluteTransform, const FActorSpawnParameters& SpawnParameters) {
    AActor* Template = SpawnParameters.Template ? SpawnParameters.Template
                       : Class                  ? Class->GetDefaultObject<AActor>()
                                                : nullptr;
    FTransform Transform = AbsoluteTransform;
    // SpawnActor multiplies with the root component's own transform: taken out beforehand, so that the result is
    // absolute.
    if (const USceneComponent* Root = Template ? Template->GetRootComponent() : nullptr) {
        const FTransform RootTransform(
            Root->GetRelativeRotation(), Root->GetRelativeLocation(), Root->GetRelativeScale3D());
        Transform = RootTransform.Inverse() * AbsoluteTransform;
    }
    return SpawnActorInternal(Class, Transform, SpawnParameters);
}

AActor* UWorld::SpawnActorInternal(
    UClass* Class, const FTransform& Transform, const FActorSpawnParameters& SpawnParameters) {
    AActor* Template = SpawnParameters.Template;
    if (!Class && Template) {
        Class = Template->GetClass();
    }
    if (!Class) {
        UE_LOG(LogSpawn, Warning, TEXT("SpawnActor failed because no class was specified"));
        return nullptr;
    }
    if (!Class->IsChildOf(AActor::StaticClass())) {
        UE_LOG(LogSpawn, Warning, TEXT("SpawnActor failed because %s is not an actor class"), *Class->GetName());
        return nullptr;
    }
    if (Class->HasAnyClassFlags(CLASS_Deprecated | CLASS_Abstract)) {
        UE_LOG(LogSpawn, Warning, TEXT("SpawnActor failed because class %s is %s: spawn a class derived from it"),
            *Class->GetName(), Class->HasAnyClassFlags(CLASS_Abstract) ? TEXT("abstract") : TEXT("deprecated"));
        return nullptr;
    }
    if (Template && Template->GetClass() != Class) {
        UE_LOG(LogSpawn, Warning, TEXT("SpawnActor failed because the template %s is not of class %s"),
            *Template->GetName(), *Class->GetName());
        return nullptr;
    }
    if (bIsRunningConstructionScript && !SpawnParameters.bAllowDuringConstructionScript) {
        UE_LOG(LogSpawn, Warning,
            TEXT("SpawnActor of %s failed because a construction script is running (bAllowDuringConstructionScript is "
                 "false)"),
            *Class->GetName());
        return nullptr;
    }
    if (bIsTearingDown) {
        UE_LOG(LogSpawn, Warning, TEXT("SpawnActor of %s failed because the world %s is being torn down"),
            *Class->GetName(), *GetName());
        return nullptr;
    }
    if (Transform.ContainsNaN()) {
        UE_LOG(LogSpawn, Warning, TEXT("SpawnActor of %s failed because the given transform (%s) is invalid"),
            *Class->GetName(), *Transform.ToString());
        return nullptr;
    }

    ULevel* Level = SpawnParameters.OverrideLevel;
    if (!Level) {
        Level = SpawnParameters.Owner ? SpawnParameters.Owner->GetLevel() : CurrentLevel.Get();
    }
    if (!Level || Level->OwningWorld != this) {
        UE_LOG(LogSpawn, Warning, TEXT("SpawnActor of %s failed because the level %s is not in world %s"),
            *Class->GetName(), *GetNameSafe(Level), *GetName());
        return nullptr;
    }

    FName ActorName = SpawnParameters.Name;
    if (ActorName == NAME_None) {
        ActorName = MakeUniqueObjectName(Level, Class);
    } else if (StaticFindObjectFast(nullptr, Level, ActorName)) {
        switch (SpawnParameters.NameMode) {
        case ESpawnActorNameMode::Requested:
            ActorName = MakeUniqueObjectName(Level, Class, SpawnParameters.Name);
            break;
        case ESpawnActorNameMode::Required_Fatal:
            UE_LOG(LogSpawn, Fatal,
                TEXT("Cannot generate unique name for '%s' in level '%s': it is taken. Use another "
                     "SpawnParameters.NameMode"),
                *ActorName.ToString(), *Level->GetPathName());
            return nullptr;
        case ESpawnActorNameMode::Required_ErrorAndReturnNull:
            UE_LOG(LogSpawn, Error, TEXT("SpawnActor of %s failed because the name '%s' is taken in level '%s'"),
                *Class->GetName(), *ActorName.ToString(), *Level->GetPathName());
            return nullptr;
        case ESpawnActorNameMode::Required_ReturnNull:
            return nullptr;
        }
    }

    AActor* Actor = NewObject<AActor>(Level, Class, ActorName, SpawnParameters.ObjectFlags, Template);
    check(Actor);
    Level->Actors.Add(Actor);
    if (SpawnParameters.SpawnCollisionHandlingOverride != ESpawnActorCollisionHandlingMethod::Undefined) {
        Actor->SpawnCollisionHandlingMethod = SpawnParameters.SpawnCollisionHandlingOverride;
    }
    if (SpawnParameters.CustomPreSpawnInitalization) {
        SpawnParameters.CustomPreSpawnInitalization(Actor);
    }
    OnActorPreSpawnInitialization.Broadcast(Actor);
    Actor->PostSpawnInitialize(Transform, SpawnParameters.Owner, SpawnParameters.Instigator,
        SpawnParameters.bDeferConstruction, SpawnParameters.TransformScaleMethod);
    if (!IsValid(Actor) && !SpawnParameters.bNoFail) {
        UE_LOG(LogSpawn, Log, TEXT("SpawnActor: %s destroyed itself while it was spawned"), *Actor->GetPathName());
        return nullptr;
    }
    OnActorSpawned.Broadcast(Actor);
    if (GEngine) {
        GEngine->BroadcastLevelActorAdded(Actor);
    }
    return Actor;
}

bool UWorld::DestroyActor(AActor* Actor, bool, bool bShouldModifyLevel) {
    check(Actor);
    if (Actor->GetWorld() != this) {
        UE_LOG(LogSpawn, Warning, TEXT("DestroyActor: %s is not in world %s"), *Actor->GetPathName(), *GetName());
        return false;
    }
    if (Actor->bActorIsBeingDestroyed) {
        return true;
    }
    if (PersistentLevel && Actor == PersistentLevel->GetWorldSettings(false)) {
        UE_LOG(LogSpawn, Warning, TEXT("DestroyActor: the world settings cannot be destroyed"));
        return false;
    }

    Actor->bActorIsBeingDestroyed = true;
    Actor->Destroyed();
    OnActorDestroyed.Broadcast(Actor);
    if (GEngine) {
        GEngine->BroadcastLevelActorDeleted(Actor);
    }
    Actor->OnLeaveWorld();
    GetTimerManager().ClearAllTimersForObject(Actor);
    GetLatentActionManager().RemoveActionsForObject(Actor);
    Actor->RegisterAllActorTickFunctions(false, true);
    RemoveActor(Actor, bShouldModifyLevel);
    Actor->UnregisterAllComponents();
    Actor->MarkComponentsAsGarbage(bShouldModifyLevel);
    Actor->MarkAsGarbage();
    return true;
}

void UWorld::RemoveActor(AActor* Actor, bool) const {
    if (ULevel* Level = Actor->GetLevel()) {
        const int32 Index = Level->Actors.Find(Actor);
        if (Index != INDEX_NONE) {
            // Null instead of removed: iterators in progress keep their place. The world compacts the list after its
            // tick.
            Level->Actors[Index] = nullptr;
        }
    }
}

FDelegateHandle UWorld::AddOnActorSpawnedHandler(const FOnActorSpawned::FDelegate& InHandler) const {
    return OnActorSpawned.Add(InHandler);
}

void UWorld::RemoveOnActorSpawnedHandler(FDelegateHandle InHandle) const { OnActorSpawned.Remove(InHandle); }

FDelegateHandle UWorld::AddOnActorPreSpawnInitialization(const FOnActorSpawned::FDelegate& InHandler) const {
    return OnActorPreSpawnInitialization.Add(InHandler);
}

void UWorld::RemoveOnActorPreSpawnInitialization(FDelegateHandle InHandle) const {
    OnActorPreSpawnInitialization.Remove(InHandle);
}

FDelegateHandle UWorld::AddOnActorDestroyedHandler(const FOnActorDestroyed::FDelegate& InHandler) const {
    return OnActorDestroyed.Add(InHandler);
}

void UWorld::RemoveOnActorDestroyedHandler(FDelegateHandle InHandle) const { OnActorDestroyed.Remove(InHandle); }
