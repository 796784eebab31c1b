// SPDX-License-Identifier: MIT
// Reflected types that the tests of worlds, actors and subsystems need: they write down what is called on them.
#pragma once

#include "Components/ActorComponent.h"
#include "CoreMinimal.h"
#include "GameFramework/Actor.h"
#include "GameFramework/GameModeBase.h"
#include "Subsystems/EngineSubsystem.h"
#include "Subsystems/GameInstanceSubsystem.h"
#include "Subsystems/LocalPlayerSubsystem.h"
#include "Subsystems/WorldSubsystem.h"
#include "UObject/Object.h"

#include "WorldTestTypes.generated.h"

/** What was called, in order. Tests empty it first. */
struct ENGINETESTTYPES_API FTestJournal {
    static TArray<FString>& Get();
    static void Add(const FString& Entry);
    /** The entries, separated by spaces; empties the journal. */
    static FString Take();
};

/** Writes down its life. */
UCLASS()
class ENGINETESTTYPES_API UJournalComponent : public UActorComponent {
    GENERATED_BODY()

public:
    UJournalComponent();
    virtual void InitializeComponent() override;
    virtual void UninitializeComponent() override;
    virtual void BeginPlay() override;
    virtual void EndPlay(const EEndPlayReason::Type EndPlayReason) override;
    virtual void TickComponent(
        float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction) override;

protected:
    virtual void OnRegister() override;
    virtual void OnUnregister() override;
};

/** Writes down its life, and that of its component. */
UCLASS()
class ENGINETESTTYPES_API AJournalActor : public AActor {
    GENERATED_BODY()

public:
    AJournalActor();

    UPROPERTY()
    TObjectPtr<UJournalComponent> Journal;

    /** Seconds that Tick has been called with, summed up. */
    double TickedSeconds = 0.0;
    int32 TickCount = 0;
    /** Destroys itself in its first tick. */
    bool bDestroyInTick = false;

    virtual void PreInitializeComponents() override;
    virtual void PostInitializeComponents() override;
    virtual void EndPlay(const EEndPlayReason::Type EndPlayReason) override;
    virtual void Destroyed() override;
    virtual void Tick(float DeltaSeconds) override;

    UFUNCTION()
    void HandleDestroyed(AActor* DestroyedActor);
    UFUNCTION()
    void HandleTimer();

protected:
    virtual void BeginPlay() override;
};

/** Target of latent actions. */
UCLASS()
class ENGINETESTTYPES_API ULatentTarget : public UObject {
    GENERATED_BODY()

public:
    UPROPERTY()
    int32 LastLinkage = 0;
    UPROPERTY()
    int32 CallCount = 0;

    UFUNCTION()
    void Resume(int32 Linkage);
};

/** A game mode that cannot be paused. */
UCLASS()
class ENGINETESTTYPES_API AUnpauseableGameMode : public AGameModeBase {
    GENERATED_BODY()

public:
    AUnpauseableGameMode(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());
};

UCLASS()
class ENGINETESTTYPES_API UJournalEngineSubsystem : public UEngineSubsystem {
    GENERATED_BODY()

public:
    virtual void Initialize(FSubsystemCollectionBase& Collection) override;
    virtual void Deinitialize() override;
};

UCLASS()
class ENGINETESTTYPES_API UJournalGameInstanceSubsystem : public UGameInstanceSubsystem {
    GENERATED_BODY()

public:
    virtual void Initialize(FSubsystemCollectionBase& Collection) override;
    virtual void Deinitialize() override;
};

UCLASS()
class ENGINETESTTYPES_API UJournalLocalPlayerSubsystem : public ULocalPlayerSubsystem {
    GENERATED_BODY()

public:
    virtual void Initialize(FSubsystemCollectionBase& Collection) override;
    virtual void Deinitialize() override;
};

/** Comes first by name, but initialises the other one first. */
UCLASS()
class ENGINETESTTYPES_API UADependentWorldSubsystem : public UWorldSubsystem {
    GENERATED_BODY()

public:
    virtual void Initialize(FSubsystemCollectionBase& Collection) override;
    virtual void Deinitialize() override;
    virtual void OnWorldBeginPlay(UWorld& InWorld) override;
};

/** Ticks with its world. */
UCLASS()
class ENGINETESTTYPES_API UJournalTickingSubsystem : public UTickableWorldSubsystem {
    GENERATED_BODY()

public:
    double TickedSeconds = 0.0;

    virtual void Initialize(FSubsystemCollectionBase& Collection) override;
    virtual void Deinitialize() override;
    virtual void Tick(float DeltaTime) override;
};

/** Declines to be created. */
UCLASS()
class ENGINETESTTYPES_API UUnwantedWorldSubsystem : public UWorldSubsystem {
    GENERATED_BODY()

public:
    virtual bool ShouldCreateSubsystem(UObject* Outer) const override { return false; }
};
