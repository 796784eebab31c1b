// SPDX-License-Identifier: MIT
#include "GameFramework/GameModeBase.h"

#include "Engine/LocalPlayer.h"
#include "Engine/World.h"
#include "EngineUtils.h"
#include "GameFramework/DefaultPawn.h"
#include "GameFramework/GameStateBase.h"
#include "GameFramework/Pawn.h"
#include "GameFramework/PlayerStart.h"
#include "GameFramework/PlayerState.h"
#include "GameFramework/WorldSettings.h"

DEFINE_LOG_CATEGORY_STATIC(LogGameMode, Log, All);

AGameModeBase::AGameModeBase(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    GameStateClass = AGameStateBase::StaticClass();
    PlayerControllerClass = APlayerController::StaticClass();
    PlayerStateClass = APlayerState::StaticClass();
    DefaultPawnClass = ADefaultPawn::StaticClass();
    DefaultPlayerNameText = TEXT("Player");
    bStartPlayersAsSpectators = false;
    bPauseable = true;
    NextPlayerId = 256;
}

void AGameModeBase::InitGame(const FString&, const FString& Options, FString&) { OptionsString = Options; }

void AGameModeBase::InitGameState() { GameState->GameModeClass = GetClass(); }

void AGameModeBase::PreInitializeComponents() {
    Super::PreInitializeComponents();
    FActorSpawnParameters SpawnInfo;
    SpawnInfo.Instigator = Instigator;
    SpawnInfo.ObjectFlags |= RF_Transient;
    UWorld* World = GetWorld();
    UClass* StateClass = GameStateClass ? GameStateClass.Get() : AGameStateBase::StaticClass();
    GameState = World->SpawnActor<AGameStateBase>(StateClass, SpawnInfo);
    World->SetGameState(GameState);
    if (GameState) {
        GameState->AuthorityGameMode = this;
        InitGameState();
    }
}

int32 AGameModeBase::GetNumPlayers() {
    int32 Count = 0;
    for (FConstPlayerControllerIterator It = GetWorld()->GetPlayerControllerIterator(); It; ++It) {
        Count += It->IsValid() ? 1 : 0;
    }
    return Count;
}

void AGameModeBase::StartPlay() { GameState->HandleBeginPlay(); }

bool AGameModeBase::HasMatchStarted() const { return GameState && GameState->HasMatchStarted(); }

bool AGameModeBase::ShouldReset_Implementation(AActor*) { return true; }

void AGameModeBase::ResetLevel() {
    // Controllers first, as they may refer to other actors.
    for (FConstControllerIterator It = GetWorld()->GetControllerIterator(); It; ++It) {
        if (AController* Controller = It->Get()) {
            Controller->Reset();
        }
    }
    for (FActorIterator It(GetWorld()); It; ++It) {
        AActor* Actor = *It;
        if (Actor != this && !Actor->IsA<AController>() && ShouldReset(Actor)) {
            Actor->Reset();
        }
    }
    Reset();
}

// -------------------------------------------------------------------------------------------------------------------
// pause

bool AGameModeBase::AllowPausing(APlayerController*) { return bPauseable; }

bool AGameModeBase::IsPaused() const { return Pausers.Num() > 0; }

bool AGameModeBase::SetPause(APlayerController* PC, FCanUnpause CanUnpauseDelegate) {
    if (!AllowPausing(PC)) {
        return false;
    }
    Pausers.Add(FPauser{PC, CanUnpauseDelegate});
    AWorldSettings* Settings = GetWorldSettings();
    if (!Settings->GetPauserPlayerState()) {
        Settings->SetPauserPlayerState(PC->PlayerState);
    }
    return true;
}

bool AGameModeBase::ClearPause() {
    Pausers.RemoveAll(
        [](const FPauser& Pauser) { return !Pauser.CanUnpause.IsBound() || Pauser.CanUnpause.Execute(); });
    if (Pausers.Num() > 0) {
        return false;
    }
    GetWorldSettings()->SetPauserPlayerState(nullptr);
    return true;
}

void AGameModeBase::ForceClearUnpauseDelegates(AActor* PauseActor) {
    Pausers.RemoveAll([PauseActor](const FPauser& Pauser) {
        return !PauseActor || Pauser.Controller == PauseActor ||
               (Pauser.CanUnpause.IsBound() && Pauser.CanUnpause.IsBoundToObject(PauseActor));
    });
    if (Pausers.Num() == 0) {
        GetWorldSettings()->SetPauserPlayerState(nullptr);
    }
}

AWorldSettings* AGameModeBase::GetWorldSettings() const { return GetWorld()->GetWorldSettings(); }

// -------------------------------------------------------------------------------------------------------------------
// login

APlayerController* AGameModeBase::Login(
    UPlayer*, const FString& Portal, const FString& Options, FString& ErrorMessage) {
    PreLogin(Options, FString(), ErrorMessage);
    if (!ErrorMessage.IsEmpty()) {
        return nullptr;
    }
    APlayerController* PlayerController = SpawnPlayerController(ROLE_None, FVector::ZeroVector, FRotator::ZeroRotator);
    if (!PlayerController) {
        ErrorMessage = FString::Printf(
            TEXT("Login: could not spawn a player controller of class %s"), *GetNameSafe(PlayerControllerClass.Get()));
        return nullptr;
    }
    ErrorMessage = InitNewPlayer(PlayerController, Options, Portal);
    if (!ErrorMessage.IsEmpty()) {
        PlayerController->Destroy();
        return nullptr;
    }
    return PlayerController;
}

APlayerController* AGameModeBase::SpawnPlayerController(
    ENetRole, FVector const& SpawnLocation, FRotator const& SpawnRotation) {
    FActorSpawnParameters SpawnInfo;
    SpawnInfo.Instigator = Instigator;
    SpawnInfo.ObjectFlags |= RF_Transient;
    UClass* ControllerClass = PlayerControllerClass ? PlayerControllerClass.Get() : APlayerController::StaticClass();
    return GetWorld()->SpawnActor<APlayerController>(ControllerClass, SpawnLocation, SpawnRotation, SpawnInfo);
}

FString AGameModeBase::InitNewPlayer(APlayerController* NewPlayerController, const FString&, const FString& Portal) {
    if (NewPlayerController->PlayerState) {
        NewPlayerController->PlayerState->SetPlayerId(NextPlayerId++);
        ChangeName(NewPlayerController, DefaultPlayerNameText, false);
    }
    FString ErrorMessage;
    if (!UpdatePlayerStartSpot(NewPlayerController, Portal, ErrorMessage)) {
        UE_LOG(LogGameMode, Warning, TEXT("InitNewPlayer: %s"), *ErrorMessage);
    }
    return FString();
}

void AGameModeBase::ChangeName(AController* Controller, const FString& NewName, bool) {
    if (Controller && Controller->PlayerState && !NewName.IsEmpty()) {
        Controller->PlayerState->SetPlayerName(NewName);
    }
}

void AGameModeBase::PostLogin(APlayerController* NewPlayer) {
    K2_PostLogin(NewPlayer);
    HandleStartingNewPlayer(NewPlayer);
}

void AGameModeBase::Logout(AController* Exiting) {
    if (APlayerController* PlayerController = Cast<APlayerController>(Exiting)) {
        K2_OnLogout(PlayerController);
        ForceClearUnpauseDelegates(PlayerController);
    }
    if (GameState && Exiting->PlayerState) {
        GameState->RemovePlayerState(Exiting->PlayerState);
    }
}

// -----------------------------------------------------------------------------------------------------------------
// restart

void AGameModeBase::HandleStartingNewPlayer(APlayerController* NewPlayer) {
    if (!bStartPlayersAsSpectators && PlayerCanRestart(NewPlayer)) {
        RestartPlayer(NewPlayer);
    }
}

bool AGameModeBase::PlayerCanRestart_Implementation(APlayerController* Player) {
    return IsValid(Player) && Player->PlayerState;
}

bool AGameModeBase::ShouldSpawnAtStartSpot(AController* Player) { return Player && Player->StartSpot.IsValid(); }

bool AGameModeBase::UpdatePlayerStartSpot(AController* Player, const FString& Portal, FString& OutErrorMessage) {
    AActor* StartSpot = FindPlayerStart(Player, Portal);
    if (!StartSpot) {
        OutErrorMessage = TEXT("Could not find a starting spot");
        return false;
    }
    Player->SetInitialLocationAndRotation(
        StartSpot->GetActorLocation(), FRotator(0.0, StartSpot->GetActorRotation().Yaw, 0.0));
    Player->StartSpot = StartSpot;
    return true;
}

AActor* AGameModeBase::FindPlayerStart_Implementation(AController* Player, const FString& IncomingName) {
    if (!IncomingName.IsEmpty()) {
        const FName Tag(*IncomingName);
        for (TActorIterator<APlayerStart> It(GetWorld()); It; ++It) {
            if (It->PlayerStartTag == Tag) {
                return *It;
            }
        }
    }
    if (ShouldSpawnAtStartSpot(Player)) {
        return Player->StartSpot.Get();
    }
    if (AActor* BestStart = ChoosePlayerStart(Player)) {
        return BestStart;
    }
    // A map without player starts: the origin, where the world settings are.
    return GetWorldSettings();
}

AActor* AGameModeBase::ChoosePlayerStart_Implementation(AController*) {
    for (TActorIterator<APlayerStart> It(GetWorld()); It; ++It) {
        return *It;
    }
    return nullptr;
}

UClass* AGameModeBase::GetDefaultPawnClassForController_Implementation(AController*) { return DefaultPawnClass; }

void AGameModeBase::RestartPlayer(AController* NewPlayer) {
    if (!IsValid(NewPlayer)) {
        return;
    }
    AActor* StartSpot = FindPlayerStart(NewPlayer);
    if (!StartSpot && NewPlayer->StartSpot.IsValid()) {
        StartSpot = NewPlayer->StartSpot.Get();
    }
    RestartPlayerAtPlayerStart(NewPlayer, StartSpot);
}

void AGameModeBase::RestartPlayerAtPlayerStart(AController* NewPlayer, AActor* StartSpot) {
    if (!IsValid(NewPlayer)) {
        return;
    }
    if (!StartSpot) {
        UE_LOG(LogGameMode, Warning, TEXT("RestartPlayerAtPlayerStart: there is no player start"));
        return;
    }
    InitStartSpot(StartSpot, NewPlayer);
    FRotator SpawnRotation = StartSpot->GetActorRotation();
    if (NewPlayer->GetPawn()) {
        SpawnRotation = NewPlayer->GetPawn()->GetActorRotation();
    } else if (GetDefaultPawnClassForController(NewPlayer)) {
        if (APawn* NewPawn = SpawnDefaultPawnFor(NewPlayer, StartSpot)) {
            NewPlayer->SetPawn(NewPawn);
        }
    }
    if (NewPlayer->GetPawn()) {
        NewPlayer->StartSpot = StartSpot;
        FinishRestartPlayer(NewPlayer, SpawnRotation);
    }
}

void AGameModeBase::RestartPlayerAtTransform(AController* NewPlayer, const FTransform& SpawnTransform) {
    if (!IsValid(NewPlayer)) {
        return;
    }
    FRotator SpawnRotation = SpawnTransform.Rotator();
    if (NewPlayer->GetPawn()) {
        SpawnRotation = NewPlayer->GetPawn()->GetActorRotation();
    } else if (GetDefaultPawnClassForController(NewPlayer)) {
        if (APawn* NewPawn = SpawnDefaultPawnAtTransform(NewPlayer, SpawnTransform)) {
            NewPlayer->SetPawn(NewPawn);
        }
    }
    if (NewPlayer->GetPawn()) {
        FinishRestartPlayer(NewPlayer, SpawnRotation);
    }
}

APawn* AGameModeBase::SpawnDefaultPawnFor_Implementation(AController* NewPlayer, AActor* StartSpot) {
    // No pitch or roll: pawns stand upright.
    const FTransform Transform(FRotator(0.0, StartSpot->GetActorRotation().Yaw, 0.0), StartSpot->GetActorLocation());
    return SpawnDefaultPawnAtTransform(NewPlayer, Transform);
}

APawn* AGameModeBase::SpawnDefaultPawnAtTransform_Implementation(
    AController* NewPlayer, const FTransform& SpawnTransform) {
    FActorSpawnParameters SpawnInfo;
    SpawnInfo.Instigator = Instigator;
    SpawnInfo.ObjectFlags |= RF_Transient;
    UClass* PawnClass = GetDefaultPawnClassForController(NewPlayer);
    APawn* Pawn = GetWorld()->SpawnActor<APawn>(PawnClass, SpawnTransform, SpawnInfo);
    if (!Pawn) {
        UE_LOG(LogGameMode, Warning, TEXT("SpawnDefaultPawnAtTransform: could not spawn a pawn of class %s at %s"),
            *GetNameSafe(PawnClass), *SpawnTransform.ToString());
    }
    return Pawn;
}

void AGameModeBase::FinishRestartPlayer(AController* NewPlayer, const FRotator& StartRotation) {
    NewPlayer->Possess(NewPlayer->GetPawn());
    if (IsValid(NewPlayer->GetPawn())) {
        FRotator Rotation = StartRotation;
        Rotation.Roll = 0.0;
        NewPlayer->SetControlRotation(Rotation);
    }
}

void AGameModeBase::InitStartSpot_Implementation(AActor*, AController*) {}
