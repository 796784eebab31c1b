// SPDX-License-Identifier: MIT
#include "Kismet/GameplayStatics.h"
#include "Camera/PlayerCameraManager.h"
#include "Components/ActorComponent.h"
#include "Components/SceneComponent.h"
#include "Engine/Engine.h"
#include "Engine/GameInstance.h"
#include "Engine/World.h"
#include "EngineUtils.h"
#include "GameFramework/Actor.h"
#include "GameFramework/GameModeBase.h"
#include "GameFramework/GameStateBase.h"
#include "GameFramework/Pawn.h"
#include "GameFramework/PlayerController.h"
#include "GameFramework/WorldSettings.h"
#include "HAL/PlatformTime.h"
#include "KismetPrivate.h"
#include "Misc/App.h"
#include "Misc/CommandLine.h"
#include "Misc/Parse.h"

#include <cmath>

// Players and the game

UGameInstance* UGameplayStatics::GetGameInstance(const UObject* WorldContextObject) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World ? World->GetGameInstance() : nullptr;
}

int32 UGameplayStatics::GetNumPlayerControllers(const UObject* WorldContextObject) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World ? World->GetNumPlayerControllers() : 0;
}

APlayerController* UGameplayStatics::GetPlayerController(const UObject* WorldContextObject, int32 PlayerIndex) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    if (World && PlayerIndex >= 0) {
        int32 Index = 0;
        for (FConstPlayerControllerIterator Iterator = World->GetPlayerControllerIterator(); Iterator;
            ++Iterator, ++Index) {
            if (Index == PlayerIndex) {
                return Iterator->Get();
            }
        }
    }
    return nullptr;
}

APawn* UGameplayStatics::GetPlayerPawn(const UObject* WorldContextObject, int32 PlayerIndex) {
    APlayerController* Controller = GetPlayerController(WorldContextObject, PlayerIndex);
    return Controller ? Controller->GetPawn() : nullptr;
}

APlayerCameraManager* UGameplayStatics::GetPlayerCameraManager(const UObject* WorldContextObject, int32 PlayerIndex) {
    APlayerController* Controller = GetPlayerController(WorldContextObject, PlayerIndex);
    return Controller ? Controller->PlayerCameraManager : nullptr;
}

AGameModeBase* UGameplayStatics::GetGameMode(const UObject* WorldContextObject) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World ? World->GetAuthGameMode() : nullptr;
}

AGameStateBase* UGameplayStatics::GetGameState(const UObject* WorldContextObject) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World ? World->GetGameState() : nullptr;
}

UClass* UGameplayStatics::GetObjectClass(const UObject* Object) { return Object ? Object->GetClass() : nullptr; }

// Time

float UGameplayStatics::GetGlobalTimeDilation(const UObject* WorldContextObject) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World ? World->GetWorldSettings()->TimeDilation : 1.0f;
}

void UGameplayStatics::SetGlobalTimeDilation(const UObject* WorldContextObject, float TimeDilation) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    if (World) {
        World->GetWorldSettings()->SetTimeDilation(TimeDilation);
    }
}

bool UGameplayStatics::SetGamePaused(const UObject* WorldContextObject, bool bPaused) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    APlayerController* const Controller = World ? World->GetFirstPlayerController() : nullptr;
    return Controller && Controller->SetPause(bPaused);
}

bool UGameplayStatics::IsGamePaused(const UObject* WorldContextObject) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World && World->IsPaused();
}

double UGameplayStatics::GetWorldDeltaSeconds(const UObject* WorldContextObject) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World ? World->GetDeltaSeconds() : 0.0;
}

double UGameplayStatics::GetTimeSeconds(const UObject* WorldContextObject) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World ? World->GetTimeSeconds() : 0.0;
}

double UGameplayStatics::GetUnpausedTimeSeconds(const UObject* WorldContextObject) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World ? World->GetUnpausedTimeSeconds() : 0.0;
}

double UGameplayStatics::GetRealTimeSeconds(const UObject* WorldContextObject) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World ? World->GetRealTimeSeconds() : 0.0;
}

void UGameplayStatics::GetAccurateRealTime(int32& Seconds, double& PartialSeconds) {
    const double Now = FPlatformTime::Seconds() - GStartTime;
    Seconds = static_cast<int32>(std::floor(Now));
    PartialSeconds = Now - Seconds;
}

// Spawning

UObject* UGameplayStatics::SpawnObject(TSubclassOf<UObject> ObjectClass, UObject* Outer) {
    if (!ObjectClass || !Outer || ObjectClass->HasAnyClassFlags(CLASS_Abstract) ||
        ObjectClass->IsChildOf(AActor::StaticClass()) || ObjectClass->IsChildOf(UActorComponent::StaticClass())) {
        UE_LOG(LogKismet, Error,
            TEXT("SpawnObject: the class '%s' under the outer '%s' cannot be created: both must be given, and the "
                 "class neither abstract nor an actor or component"),
            *GetNameSafe(ObjectClass.Get()), *GetNameSafe(Outer));
        return nullptr;
    }
    return NewObject<UObject>(Outer, ObjectClass);
}

AActor* UGameplayStatics::BeginDeferredActorSpawnFromClass(const UObject* WorldContextObject,
    TSubclassOf<AActor> ActorClass, const FTransform& SpawnTransform,
    ESpawnActorCollisionHandlingMethod CollisionHandlingOverride, AActor* Owner,
    ESpawnActorScaleMethod TransformScaleMethod) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    if (!World || !ActorClass) {
        UE_LOG(LogKismet, Warning, TEXT("BeginDeferredActorSpawnFromClass: %s"),
            World ? TEXT("no actor class was given") : TEXT("the world context object has no world"));
        return nullptr;
    }
    APawn* const Instigator = KismetPrivate::FindInstigator(WorldContextObject);
    return World->SpawnActorDeferred<AActor>(
        ActorClass, SpawnTransform, Owner, Instigator, CollisionHandlingOverride, TransformScaleMethod);
}

AActor* UGameplayStatics::FinishSpawningActor(
    AActor* Actor, const FTransform& SpawnTransform, ESpawnActorScaleMethod TransformScaleMethod) {
    if (!Actor) {
        UE_LOG(LogKismet, Warning, TEXT("FinishSpawningActor: no actor was given"));
        return nullptr;
    }
    Actor->FinishSpawning(SpawnTransform, false, nullptr, TransformScaleMethod);
    return Actor;
}

// Finding actors

FVector UGameplayStatics::GetActorArrayAverageLocation(const TArray<AActor*>& Actors) {
    FVector Sum(0.0, 0.0, 0.0);
    int32 Count = 0;
    for (const AActor* Actor : Actors) {
        if (Actor && Actor->GetRootComponent()) {
            Sum = Sum + Actor->GetActorLocation();
            ++Count;
        }
    }
    return Count > 0 ? Sum / static_cast<double>(Count) : Sum;
}

void UGameplayStatics::GetActorArrayBounds(
    const TArray<AActor*>& Actors, bool bOnlyCollidingComponents, FVector& Center, FVector& BoxExtent) {
    FBox Bounds(ForceInit);
    for (const AActor* Actor : Actors) {
        if (Actor) {
            Bounds += Actor->GetComponentsBoundingBox(!bOnlyCollidingComponents);
        }
    }
    Center = Bounds.IsValid ? Bounds.GetCenter() : FVector(0.0, 0.0, 0.0);
    BoxExtent = Bounds.IsValid ? Bounds.GetExtent() : FVector(0.0, 0.0, 0.0);
}

AActor* UGameplayStatics::GetActorOfClass(const UObject* WorldContextObject, TSubclassOf<AActor> ActorClass) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    if (World && ActorClass) {
        for (TActorIterator<AActor> Iterator(World, ActorClass); Iterator; ++Iterator) {
            return *Iterator;
        }
    }
    return nullptr;
}

void UGameplayStatics::GetAllActorsOfClass(
    const UObject* WorldContextObject, TSubclassOf<AActor> ActorClass, TArray<AActor*>& OutActors) {
    KismetPrivate::CollectActors(WorldContextObject, ActorClass, OutActors, [](const AActor*) { return true; });
}

void UGameplayStatics::GetAllActorsWithInterface(
    const UObject* WorldContextObject, TSubclassOf<UInterface> Interface, TArray<AActor*>& OutActors) {
    OutActors.Reset();
    if (Interface) {
        KismetPrivate::CollectActors(WorldContextObject, AActor::StaticClass(), OutActors,
            [Interface](const AActor* Actor) { return Actor->GetClass()->ImplementsInterface(Interface); });
    }
}

void UGameplayStatics::GetAllActorsWithTag(const UObject* WorldContextObject, FName Tag, TArray<AActor*>& OutActors) {
    OutActors.Reset();
    if (!Tag.IsNone()) {
        KismetPrivate::CollectActors(WorldContextObject, AActor::StaticClass(), OutActors,
            [Tag](const AActor* Actor) { return Actor->ActorHasTag(Tag); });
    }
}

void UGameplayStatics::GetAllActorsOfClassWithTag(
    const UObject* WorldContextObject, TSubclassOf<AActor> ActorClass, FName Tag, TArray<AActor*>& OutActors) {
    OutActors.Reset();
    if (!Tag.IsNone()) {
        KismetPrivate::CollectActors(
            WorldContextObject, ActorClass, OutActors, [Tag](const AActor* Actor) { return Actor->ActorHasTag(Tag); });
    }
}

AActor* UGameplayStatics::FindNearestActor(FVector Origin, const TArray<AActor*>& ActorsToCheck, float& Distance) {
    AActor* Nearest = nullptr;
    double Least = 0.0;
    for (AActor* Actor : ActorsToCheck) {
        if (Actor) {
            const double DistanceSquared = (Actor->GetActorLocation() - Origin).SizeSquared();
            if (!Nearest || DistanceSquared < Least) {
                Nearest = Actor;
                Least = DistanceSquared;
            }
        }
    }
    Distance = static_cast<float>(std::sqrt(Least));
    return Nearest;
}

// Levels and options

void UGameplayStatics::OpenLevel(const UObject* WorldContextObject, FName LevelName, bool bAbsolute, FString Options) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    if (World) {
        FString Target = LevelName.ToString();
        if (!Options.IsEmpty()) {
            Target += FString(TEXT("?")) + Options;
        }
        GEngine->SetClientTravel(World, *Target, bAbsolute ? TRAVEL_Absolute : TRAVEL_Relative);
    }
}

FString UGameplayStatics::GetCurrentLevelName(const UObject* WorldContextObject, bool bRemovePrefixString) {
    UWorld* World = KismetPrivate::GetWorld(WorldContextObject);
    return World ? World->GetMapName() : FString();
}

FString UGameplayStatics::GetPlatformName() { return FString(TEXT("Linux")); }

bool UGameplayStatics::HasLaunchOption(const FString& OptionToCheck) {
    return FParse::Param(FCommandLine::Get(), *OptionToCheck);
}

FString UGameplayStatics::ParseOption(FString Options, const FString& Key) {
    FString Value;
    KismetPrivate::FindOption(Options, Key, Value);
    return Value;
}

bool UGameplayStatics::HasOption(FString Options, const FString& InKey) {
    FString Value;
    return KismetPrivate::FindOption(Options, InKey, Value);
}

int32 UGameplayStatics::GetIntOption(const FString& Options, const FString& Key, int32 DefaultValue) {
    FString Value;
    return KismetPrivate::FindOption(Options, Key, Value) ? FCString::Atoi(*Value) : DefaultValue;
}

void UGameplayStatics::GetKeyValue(const FString& Pair, FString& Key, FString& Value) {
    if (!Pair.Split(TEXT("="), &Key, &Value)) {
        Key = Pair;
        Value = FString();
    }
}
