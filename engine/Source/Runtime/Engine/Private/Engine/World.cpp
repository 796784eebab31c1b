// SPDX-License-Identifier: MIT
/** @file Life of worlds. Spawning is in WorldSpawn.cpp, ticking in WorldTick.cpp. */
#include "Engine/World.h"

#include "Engine/Engine.h"
#include "Engine/GameInstance.h"
#include "Engine/Level.h"
#include "Engine/LocalPlayer.h"
#include "EngineUtils.h"
#include "GameFramework/Controller.h"
#include "GameFramework/GameModeBase.h"
#include "GameFramework/GameStateBase.h"
#include "GameFramework/PlayerController.h"
#include "GameFramework/WorldSettings.h"
#include "Misc/Paths.h"
#include "TickTaskManager.h"
#include "TimerManager.h"
#include "UObject/Package.h"

DEFINE_LOG_CATEGORY(LogWorld);
DEFINE_LOG_CATEGORY(LogSpawn);

UWorldProxy GWorld;

FWorldDelegates::FWorldTickStart FWorldDelegates::OnWorldTickStart;
FWorldDelegates::FWorldTickEnd FWorldDelegates::OnWorldTickEnd;
FWorldDelegates::FOnWorldPreActorTick FWorldDelegates::OnWorldPreActorTick;
FWorldDelegates::FOnWorldPostActorTick FWorldDelegates::OnWorldPostActorTick;
FWorldDelegates::FWorldEvent FWorldDelegates::OnPostWorldCreation;
FWorldDelegates::FWorldInitializationEvent FWorldDelegates::OnPreWorldInitialization;
FWorldDelegates::FWorldInitializationEvent FWorldDelegates::OnPostWorldInitialization;
FWorldDelegates::FOnWorldInitializedActors FWorldDelegates::OnWorldInitializedActors;
FWorldDelegates::FWorldCleanupEvent FWorldDelegates::OnWorldCleanup;
FWorldDelegates::FWorldCleanupEvent FWorldDelegates::OnPostWorldCleanup;
FWorldDelegates::FWorldEvent FWorldDelegates::OnPreWorldFinishDestroy;
FWorldDelegates::FWorldEvent FWorldDelegates::OnWorldBeginTearDown;
FWorldDelegates::FOnLevelChanged FWorldDelegates::LevelAddedToWorld;
FWorldDelegates::FOnLevelChanged FWorldDelegates::LevelRemovedFromWorld;
FWorldDelegates::FGameInstanceEvent FWorldDelegates::OnStartGameInstance;

UWorld::UWorld(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    WorldType = EWorldType::None;
    TimeSeconds = 0.0;
    UnpausedTimeSeconds = 0.0;
    RealTimeSeconds = 0.0;
    DeltaTimeSeconds = 0.f;
    DeltaRealTimeSeconds = 0.f;
    PauseDelay = 0.0;
    bIsWorldInitialized = false;
    bInTick = false;
    bActorsInitialized = false;
    bIsTearingDown = false;
    bMatchStarted = false;
    bIsRunningConstructionScript = false;
    bBegunPlay = false;
    TickGroup = TG_NewlySpawned;
    if (!HasAnyFlags(RF_ClassDefaultObject)) {
        TickTaskManager = MakeUnique<FTickTaskManager>(this);
        TimerManager = MakeUnique<FTimerManager>();
    }
}

UWorld::~UWorld() = default;

UWorld* UWorld::CreateWorld(const EWorldType::Type InWorldType, bool bInformEngineOfWorld, FName WorldName,
    UPackage* InWorldPackage, bool bAddToRoot, const InitializationValues* InIVS, bool bInSkipInitWorld) {
    UPackage* Package = InWorldPackage;
    if (!Package) {
        static int32 UntitledCount = 0;
        Package = CreatePackage(*FString::Printf(TEXT("/Temp/Untitled_%d"), ++UntitledCount));
    }
    UWorld* World = NewObject<UWorld>(
        Package, WorldName == NAME_None ? FName(TEXT("Untitled")) : WorldName, RF_Public | RF_Transactional);
    World->WorldType = InWorldType;
    FWorldDelegates::OnPostWorldCreation.Broadcast(World);
    if (!bInSkipInitWorld) {
        World->InitWorld(InIVS ? *InIVS : InitializationValues());
    }
    if (bAddToRoot) {
        World->AddToRoot();
    }
    if (bInformEngineOfWorld && GEngine) {
        GEngine->WorldAdded(World);
    }
    return World;
}

void UWorld::InitWorld(const InitializationValues IVS) {
    if (bIsWorldInitialized) {
        return;
    }
    FWorldDelegates::OnPreWorldInitialization.Broadcast(this, IVS);

    InitialGameModeClass = IVS.DefaultGameMode;
    if (!PersistentLevel) {
        PersistentLevel = NewObject<ULevel>(this, FName(TEXT("PersistentLevel")));
        PersistentLevel->OwningWorld = this;
        Levels.Add(PersistentLevel);
        CurrentLevel = PersistentLevel;
    }
    if (!PersistentLevel->GetWorldSettings(false)) {
        FActorSpawnParameters SpawnInfo;
        SpawnInfo.Name = FName(TEXT("WorldSettings"));
        UClass* SettingsClass =
            GEngine && GEngine->WorldSettingsClass ? GEngine->WorldSettingsClass.Get() : AWorldSettings::StaticClass();
        PersistentLevel->SetWorldSettings(SpawnActor<AWorldSettings>(SettingsClass, SpawnInfo));
    }
    bIsWorldInitialized = true;
    InitializeSubsystems();
    FWorldDelegates::OnPostWorldInitialization.Broadcast(this, IVS);
    FWorldDelegates::LevelAddedToWorld.Broadcast(nullptr, this);
}

void UWorld::InitializeSubsystems() {
    SubsystemCollection.Initialize(this);
    for (UWorldSubsystem* Subsystem : GetSubsystemArrayCopy<UWorldSubsystem>()) {
        Subsystem->PostInitialize();
    }
}

bool UWorld::SetGameMode(const FURL& InURL) {
    if (!AuthorityGameMode && OwningGameInstance) {
        AuthorityGameMode = OwningGameInstance->CreateGameModeForURL(InURL, this);
    }
    return AuthorityGameMode != nullptr;
}

void UWorld::InitializeActorsForPlay(const FURL& InURL, bool bResetTime) {
    check(bIsWorldInitialized);
    URL = InURL;
    if (bResetTime) {
        TimeSeconds = 0.0;
        UnpausedTimeSeconds = 0.0;
        RealTimeSeconds = 0.0;
    }
    if (!bActorsInitialized) {
        // From here on, what is spawned initialises itself.
        bActorsInitialized = true;
        if (AuthorityGameMode && !AuthorityGameMode->IsActorInitialized()) {
            FString Error;
            AuthorityGameMode->InitGame(FPaths::GetBaseFilename(InURL.Map), InURL.OptionsToString(), Error);
            if (!Error.IsEmpty()) {
                UE_LOG(LogWorld, Error, TEXT("InitGame of %s: %s"), *AuthorityGameMode->GetName(), *Error);
            }
        }
        // First all are told that initialisation comes, then each is initialised with its components.
        const auto ForEachUninitialized = [this](TFunctionRef<void(AActor*)> Function) {
            for (FActorIterator It(this); It; ++It) {
                if (!It->IsActorInitialized()) {
                    Function(*It);
                }
            }
        };
        ForEachUninitialized([](AActor* Actor) { Actor->PreInitializeComponents(); });
        ForEachUninitialized([](AActor* Actor) {
            Actor->InitializeComponents();
            Actor->PostInitializeComponents();
        });
    }
    FWorldDelegates::OnWorldInitializedActors.Broadcast(FActorsInitializedParams(this, bResetTime));
}

void UWorld::BeginPlay() {
    for (UWorldSubsystem* Subsystem : GetSubsystemArrayCopy<UWorldSubsystem>()) {
        Subsystem->OnWorldBeginPlay(*this);
    }
    if (AuthorityGameMode) {
        AuthorityGameMode->StartPlay();
    } else if (AWorldSettings* Settings = GetWorldSettings()) {
        Settings->NotifyBeginPlay();
    }
    OnWorldBeginPlay.Broadcast();
}

bool UWorld::HasBegunPlay() const { return bBegunPlay && PersistentLevel && !bIsTearingDown; }

void UWorld::SetBegunPlay(bool bHasBegunPlay) { bBegunPlay = bHasBegunPlay; }

// -----------------------------------------------------------------------------------------------------------------
// ending

void UWorld::BeginTearingDown() {
    if (bIsTearingDown) {
        return;
    }
    bIsTearingDown = true;
    UE_LOG(LogWorld, Log, TEXT("BeginTearingDown for %s"), *GetOutermost()->GetName());
    FWorldDelegates::OnWorldBeginTearDown.Broadcast(this);
    BeginTearingDownEvent.Broadcast(this);
}

void UWorld::EndPlay(const EEndPlayReason::Type EndPlayReason) {
    for (FActorIterator It(this); It; ++It) {
        It->RouteEndPlay(EndPlayReason);
    }
    bBegunPlay = false;
}

void UWorld::CleanupWorld(bool bSessionEnded, bool bCleanupResources, UWorld*) {
    if (!bIsWorldInitialized) {
        return;
    }
    FWorldDelegates::OnWorldCleanup.Broadcast(this, bSessionEnded, bCleanupResources);
    EndPlay(EEndPlayReason::LevelTransition);
    for (FActorIterator It(this); It; ++It) {
        It->UnregisterAllComponents();
    }
    for (UWorldSubsystem* Subsystem : GetSubsystemArrayCopy<UWorldSubsystem>()) {
        Subsystem->PreDeinitialize();
    }
    SubsystemCollection.Deinitialize();
    FWorldDelegates::LevelRemovedFromWorld.Broadcast(nullptr, this);
    ComponentsThatNeedEndOfFrameUpdate.Empty();
    ControllerList.Empty();
    PlayerControllerList.Empty();
    bActorsInitialized = false;
    bIsWorldInitialized = false;
    FWorldDelegates::OnPostWorldCleanup.Broadcast(this, bSessionEnded, bCleanupResources);
}

void UWorld::DestroyWorld(bool bInformEngineOfWorld, UWorld* NewWorld) {
    BeginTearingDown();
    CleanupWorld(true, true, NewWorld);
    if (bInformEngineOfWorld && GEngine) {
        GEngine->WorldDestroyed(this);
    }
    RemoveFromRoot();
    ClearFlags(RF_Standalone);
    // What is left of the world must not be found any more, though it lingers until the garbage is collected.
    for (const TObjectPtr<ULevel>& Level : Levels) {
        for (AActor* Actor : Level->Actors) {
            if (Actor) {
                Actor->bActorIsBeingDestroyed = true;
                Actor->MarkComponentsAsGarbage();
                Actor->MarkAsGarbage();
            }
        }
        Level->MarkAsGarbage();
    }
    MarkAsGarbage();
    if (GWorld == this) {
        GWorld = NewWorld;
    }
}

void UWorld::FinishDestroy() {
    if (!HasAnyFlags(RF_ClassDefaultObject)) {
        FWorldDelegates::OnPreWorldFinishDestroy.Broadcast(this);
    }
    Super::FinishDestroy();
}

UWorld* UWorld::GetWorld() const { return const_cast<UWorld*>(this); }

// -------------------------------------------------------------------------------------------------------------------
// kind

bool UWorld::IsGameWorld() const {
    return WorldType == EWorldType::Game || WorldType == EWorldType::PIE || WorldType == EWorldType::GamePreview ||
           WorldType == EWorldType::GameRPC;
}

bool UWorld::IsEditorWorld() const {
    return WorldType == EWorldType::Editor || WorldType == EWorldType::EditorPreview || WorldType == EWorldType::PIE;
}

bool UWorld::IsPreviewWorld() const {
    return WorldType == EWorldType::EditorPreview || WorldType == EWorldType::GamePreview;
}

const FString UWorld::GetMapName() const { return FPaths::GetBaseFilename(GetOutermost()->GetName()); }

// ------------------------------------------------------------------------------------------------------ levels and
// actors

ULevel* UWorld::GetCurrentLevel() const { return CurrentLevel; }

bool UWorld::SetCurrentLevel(ULevel* InLevel) {
    if (CurrentLevel == InLevel || !Levels.Contains(InLevel)) {
        return false;
    }
    CurrentLevel = InLevel;
    return true;
}

int32 UWorld::GetActorCount() const {
    int32 Count = 0;
    for (FActorIterator It(this); It; ++It) {
        ++Count;
    }
    return Count;
}

AWorldSettings* UWorld::GetWorldSettings(bool, bool bChecked) const {
    return PersistentLevel ? PersistentLevel->GetWorldSettings(bChecked) : nullptr;
}

AWorldSettings* UWorld::K2_GetWorldSettings() { return GetWorldSettings(false, false); }

float UWorld::GetGravityZ() const {
    const AWorldSettings* Settings = GetWorldSettings(false, false);
    return Settings ? Settings->GetGravityZ() : GetDefaultGravityZ();
}

float UWorld::GetDefaultGravityZ() const { return GetDefault<AWorldSettings>()->GetGravityZ(); }

// --------------------------------------------------------------------------------------------------- players,
// controllers

void UWorld::SetGameState(AGameStateBase* NewGameState) { GameState = NewGameState; }

void UWorld::SetGameInstance(UGameInstance* NewGI) { OwningGameInstance = NewGI; }

void UWorld::AddController(AController* Controller) {
    check(Controller);
    ControllerList.AddUnique(Controller);
    if (APlayerController* PlayerController = Cast<APlayerController>(Controller)) {
        PlayerControllerList.AddUnique(PlayerController);
    }
}

void UWorld::RemoveController(AController* Controller) {
    check(Controller);
    ControllerList.Remove(Controller);
    if (APlayerController* PlayerController = Cast<APlayerController>(Controller)) {
        PlayerControllerList.Remove(PlayerController);
    }
}

FConstControllerIterator UWorld::GetControllerIterator() const { return ControllerList.CreateConstIterator(); }

FConstPlayerControllerIterator UWorld::GetPlayerControllerIterator() const {
    return PlayerControllerList.CreateConstIterator();
}

int32 UWorld::GetNumControllers() const { return ControllerList.Num(); }

int32 UWorld::GetNumPlayerControllers() const { return PlayerControllerList.Num(); }

APlayerController* UWorld::GetFirstPlayerController() const {
    for (FConstPlayerControllerIterator It = GetPlayerControllerIterator(); It; ++It) {
        if (APlayerController* PlayerController = It->Get()) {
            return PlayerController;
        }
    }
    return nullptr;
}

ULocalPlayer* UWorld::GetFirstLocalPlayerFromController() const {
    const APlayerController* PlayerController = GetFirstPlayerController();
    return PlayerController ? PlayerController->GetLocalPlayer() : nullptr;
}

APlayerController* UWorld::SpawnPlayActor(ULocalPlayer* Player, const FURL& InURL, FString& Error) {
    Error.Empty();
    if (!AuthorityGameMode) {
        Error = TEXT("SpawnPlayActor: the world has no game mode");
        return nullptr;
    }
    APlayerController* PlayerController =
        AuthorityGameMode->Login(Player, InURL.Portal, InURL.OptionsToString(), Error);
    if (!PlayerController) {
        UE_LOG(LogSpawn, Warning, TEXT("Login failed: %s"), *Error);
        return nullptr;
    }
    PlayerController->SetPlayer(Player);
    AuthorityGameMode->PostLogin(PlayerController);
    return PlayerController;
}

bool UWorld::ServerTravel(const FString& InURL, bool bAbsolute, bool) {
    if (!GEngine || !GEngine->GetWorldContextFromWorld(this)) {
        return false;
    }
    GEngine->SetClientTravel(this, *InURL, bAbsolute ? TRAVEL_Absolute : TRAVEL_Relative);
    return true;
}

// --------------------------------------------------------------------------------------------------- managers,
// subsystems

FTimerManager& UWorld::GetTimerManager() const {
    return OwningGameInstance ? OwningGameInstance->GetTimerManager() : *TimerManager;
}

FLatentActionManager& UWorld::GetLatentActionManager() {
    return OwningGameInstance ? OwningGameInstance->GetLatentActionManager() : LatentActionManager;
}

UWorldSubsystem* UWorld::GetSubsystemBase(TSubclassOf<UWorldSubsystem> SubsystemClass) const {
    return SubsystemCollection.GetSubsystem<UWorldSubsystem>(SubsystemClass);
}
