// SPDX-License-Identifier: MIT
#include "Engine/GameInstance.h"

#include "Engine/Engine.h"
#include "Engine/GameViewportClient.h"
#include "Engine/LocalPlayer.h"
#include "Engine/World.h"
#include "GameFramework/GameModeBase.h"
#include "GameFramework/PlayerController.h"
#include "GameFramework/WorldSettings.h"
#include "TimerManager.h"
#include "UObject/Package.h"

DEFINE_LOG_CATEGORY_STATIC(LogGameInstance, Log, All);

UGameInstance::UGameInstance(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer), WorldContext(nullptr) {
    if (!HasAnyFlags(RF_ClassDefaultObject)) {
        TimerManager = MakeUnique<FTimerManager>(this);
        LatentActionManager = MakeUnique<FLatentActionManager>();
    }
}

UGameInstance::~UGameInstance() = default;

UEngine* UGameInstance::GetEngine() const { return CastChecked<UEngine>(GetOuter()); }

UWorld* UGameInstance::GetWorld() const { return WorldContext ? WorldContext->World() : nullptr; }

UGameViewportClient* UGameInstance::GetGameViewportClient() const {
    return WorldContext ? WorldContext->GameViewport.Get() : nullptr;
}

void UGameInstance::Init() {
    SubsystemCollection.Initialize(this);
    ReceiveInit();
}

void UGameInstance::InitializeStandalone(const FName InPackageName, UPackage* InWorldPackage) {
    WorldContext = &GetEngine()->CreateNewWorldContext(EWorldType::Game);
    WorldContext->OwningGameInstance = this;
    // A first world, so that the context always has one; LoadMap replaces it.
    UPackage* Package = InWorldPackage ? InWorldPackage
                                       : CreatePackage(InPackageName == NAME_None ? TEXT("/Temp/Untitled_0")
                                                                                  : *InPackageName.ToString());
    UWorld* DummyWorld = UWorld::CreateWorld(EWorldType::Game, false, NAME_None, Package, true, nullptr, true);
    DummyWorld->SetGameInstance(this);
    WorldContext->SetCurrentWorld(DummyWorld);
    DummyWorld->InitWorld();
    Init();
}

void UGameInstance::StartGameInstance() {
    FWorldDelegates::OnStartGameInstance.Broadcast(this);
    OnStart();
}

void UGameInstance::Shutdown() {
    ReceiveShutdown();
    const TArray<ULocalPlayer*> Players = GetLocalPlayers();
    for (int32 Index = Players.Num() - 1; Index >= 0; --Index) {
        RemoveLocalPlayer(Players[Index]);
    }
    SubsystemCollection.Deinitialize();
    WorldContext = nullptr;
}

// --------------------------------------------------------------------------------------------------------------- game
// mode

TSubclassOf<AGameModeBase> UGameInstance::OverrideGameModeClass(
    TSubclassOf<AGameModeBase> GameModeClass, const FString&, const FString&, const FString&) const {
    return GameModeClass;
}

AGameModeBase* UGameInstance::CreateGameModeForURL(FURL InURL, UWorld* InWorld) {
    TSubclassOf<AGameModeBase> GameModeClass;
    if (const TCHAR* GameClassName = InURL.GetOption(TEXT("game="), nullptr)) {
        GameModeClass = LoadClass<AGameModeBase>(nullptr, GameClassName);
        if (!GameModeClass) {
            UE_LOG(LogGameInstance, Error,
                TEXT("Game mode '%s' of URL '%s' was not found; write its path, e.g. game=/Script/Engine.GameModeBase"),
                GameClassName, *InURL.ToString());
        }
    }
    const AWorldSettings* Settings = InWorld->GetWorldSettings();
    if (!GameModeClass && Settings) {
        GameModeClass = Settings->DefaultGameMode;
    }
    if (!GameModeClass) {
        GameModeClass = GetEngine()->DefaultGameModeClass;
    }
    GameModeClass = OverrideGameModeClass(GameModeClass, InURL.Map, InURL.OptionsToString(), InURL.Portal);
    FActorSpawnParameters SpawnInfo;
    SpawnInfo.ObjectFlags |= RF_Transient;
    return InWorld->SpawnActor<AGameModeBase>(GameModeClass.Get(), SpawnInfo);
}

// -----------------------------------------------------------------------------------------------------------------
// players

const TArray<ULocalPlayer*> UGameInstance::GetLocalPlayers() const {
    TArray<ULocalPlayer*> Result;
    for (const TObjectPtr<ULocalPlayer>& Player : LocalPlayers) {
        Result.Add(Player);
    }
    return Result;
}

ULocalPlayer* UGameInstance::CreateInitialPlayer(FString& OutError) { return CreateLocalPlayer(0, OutError, false); }

ULocalPlayer* UGameInstance::CreateLocalPlayer(int32 ControllerId, FString& OutError, bool bSpawnPlayerController) {
    if (FindLocalPlayerFromControllerId(ControllerId)) {
        OutError = FString::Printf(TEXT("A local player already exists for controller ID %d"), ControllerId);
        return nullptr;
    }
    ULocalPlayer* Player = NewObject<ULocalPlayer>(GetEngine(), GetEngine()->LocalPlayerClass.Get());
    LocalPlayers.Add(Player);
    Player->PlayerAdded(GetGameViewportClient(), ControllerId);
    OnLocalPlayerAddedEvent.Broadcast(Player);
    if (bSpawnPlayerController && GetWorld() && !Player->SpawnPlayActor(FString(), OutError, GetWorld())) {
        RemoveLocalPlayer(Player);
        return nullptr;
    }
    return Player;
}

bool UGameInstance::RemoveLocalPlayer(ULocalPlayer* ExistingPlayer) {
    if (!ExistingPlayer || !LocalPlayers.Contains(ExistingPlayer)) {
        return false;
    }
    if (ExistingPlayer->PlayerController && IsValid(ExistingPlayer->PlayerController) &&
        ExistingPlayer->PlayerController->GetWorld()) {
        ExistingPlayer->PlayerController->Destroy();
    }
    ExistingPlayer->PlayerRemoved();
    LocalPlayers.Remove(ExistingPlayer);
    OnLocalPlayerRemovedEvent.Broadcast(ExistingPlayer);
    return true;
}

ULocalPlayer* UGameInstance::FindLocalPlayerFromControllerId(const int32 ControllerId) const {
    for (const TObjectPtr<ULocalPlayer>& Player : LocalPlayers) {
        if (Player->GetControllerId() == ControllerId) {
            return Player;
        }
    }
    return nullptr;
}

APlayerController* UGameInstance::GetFirstLocalPlayerController(const UWorld* World) const {
    for (const TObjectPtr<ULocalPlayer>& Player : LocalPlayers) {
        if (APlayerController* PlayerController = Player->GetPlayerController(World)) {
            return PlayerController;
        }
    }
    return nullptr;
}

UGameInstanceSubsystem* UGameInstance::GetSubsystemBase(TSubclassOf<UGameInstanceSubsystem> SubsystemClass) const {
    return SubsystemCollection.GetSubsystem<UGameInstanceSubsystem>(SubsystemClass);
}

bool UGameInstance::Exec(UWorld* InWorld, const TCHAR* Cmd, FOutputDevice& Ar) {
    return GetEngine()->Exec(InWorld, Cmd, Ar);
}
