// SPDX-License-Identifier: MIT
#include "GameFramework/PlayerController.h"

#include "Camera/PlayerCameraManager.h"
#include "Engine/Engine.h"
#include "Engine/GameViewportClient.h"
#include "Engine/LocalPlayer.h"
#include "Engine/World.h"
#include "GameFramework/GameModeBase.h"
#include "GameFramework/GameStateBase.h"
#include "GameFramework/Pawn.h"
#include "GameFramework/PlayerState.h"

APlayerController::APlayerController(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    PrimaryActorTick.TickGroup = TG_PrePhysics;
    // Input and camera go on while the world is paused.
    PrimaryActorTick.bTickEvenWhenPaused = true;
    PlayerCameraManagerClass = APlayerCameraManager::StaticClass();
    bAutoManageActiveCameraTarget = true;
    RotationInput = FRotator::ZeroRotator;
}

void APlayerController::PostInitializeComponents() {
    Super::PostInitializeComponents();
    if (!IsValid(this)) {
        return;
    }
    InitPlayerState();
    SpawnPlayerCameraManager();
}

void APlayerController::InitPlayerState() {
    Super::InitPlayerState();
    AGameStateBase* GameState = GetWorld()->GetGameState();
    if (PlayerState && GameState) {
        GameState->AddPlayerState(PlayerState);
    }
}

void APlayerController::Destroyed() {
    if (PlayerCameraManager) {
        PlayerCameraManager->Destroy();
        PlayerCameraManager = nullptr;
    }
    if (Player && Player->PlayerController == this) {
        Player->PlayerController = nullptr;
    }
    Player = nullptr;
    Super::Destroyed();
}

void APlayerController::Reset() {
    if (GetPawn()) {
        UnPossess();
    }
    Super::Reset();
    SetViewTarget(this);
}

// --------------------------------------------------------------------------------------------------------------------
// tick

void APlayerController::TickActor(float DeltaTime, ELevelTick TickType, FActorTickFunction&) {
    if (IsActorBeingDestroyed() || !GetWorld()) {
        return;
    }
    PlayerTick(DeltaTime);
    if (TickType != LEVELTICK_PauseTick) {
        Tick(DeltaTime);
    }
}

void APlayerController::PlayerTick(float DeltaTime) { UpdateRotation(DeltaTime); }

void APlayerController::UpdateRotation(float DeltaTime) {
    FRotator DeltaRotation = RotationInput;
    RotationInput = FRotator::ZeroRotator;
    FRotator ViewRotation = GetControlRotation();
    if (PlayerCameraManager) {
        PlayerCameraManager->ProcessViewRotation(DeltaTime, ViewRotation, DeltaRotation);
    }
    SetControlRotation(ViewRotation);
    APawn* PawnOrSpectator = GetPawn();
    if (PawnOrSpectator && !IsPaused()) {
        PawnOrSpectator->FaceRotation(ViewRotation, DeltaTime);
    }
}

void APlayerController::AddPitchInput(float Val) { RotationInput.Pitch += IsLookInputIgnored() ? 0.f : Val; }

void APlayerController::AddYawInput(float Val) { RotationInput.Yaw += IsLookInputIgnored() ? 0.f : Val; }

void APlayerController::AddRollInput(float Val) { RotationInput.Roll += IsLookInputIgnored() ? 0.f : Val; }

// ------------------------------------------------------------------------------------------------------------------
// camera

void APlayerController::SpawnPlayerCameraManager() {
    FActorSpawnParameters SpawnInfo;
    SpawnInfo.Owner = this;
    SpawnInfo.Instigator = Instigator;
    SpawnInfo.ObjectFlags |= RF_Transient;
    UClass* ManagerClass =
        PlayerCameraManagerClass ? PlayerCameraManagerClass.Get() : APlayerCameraManager::StaticClass();
    PlayerCameraManager = GetWorld()->SpawnActor<APlayerCameraManager>(ManagerClass, SpawnInfo);
    if (PlayerCameraManager) {
        PlayerCameraManager->InitializeFor(this);
    }
}

void APlayerController::UpdateCameraManager(float DeltaSeconds) {
    if (PlayerCameraManager) {
        PlayerCameraManager->UpdateCamera(DeltaSeconds);
    }
}

void APlayerController::SetViewTarget(AActor* NewViewTarget, FViewTargetTransitionParams TransitionParams) {
    if (PlayerCameraManager) {
        PlayerCameraManager->SetViewTarget(NewViewTarget, TransitionParams);
    }
}

void APlayerController::SetViewTargetWithBlend(
    AActor* NewViewTarget, float BlendTime, EViewTargetBlendFunction BlendFunc, float BlendExp, bool bLockOutgoing) {
    FViewTargetTransitionParams TransitionParams;
    TransitionParams.BlendTime = BlendTime;
    TransitionParams.BlendFunction = BlendFunc;
    TransitionParams.BlendExp = BlendExp;
    TransitionParams.bLockOutgoing = bLockOutgoing;
    SetViewTarget(NewViewTarget, TransitionParams);
}

void APlayerController::AutoManageActiveCameraTarget(AActor* SuggestedTarget) {
    if (bAutoManageActiveCameraTarget) {
        SetViewTarget(SuggestedTarget);
    }
}

AActor* APlayerController::GetViewTarget() const {
    AActor* Target = PlayerCameraManager ? PlayerCameraManager->GetViewTarget() : nullptr;
    return Target ? Target : const_cast<APlayerController*>(this);
}

void APlayerController::GetPlayerViewPoint(FVector& Location, FRotator& Rotation) const {
    if (PlayerCameraManager && PlayerCameraManager->ViewTarget.Target) {
        PlayerCameraManager->GetCameraViewPoint(Location, Rotation);
    } else {
        Super::GetPlayerViewPoint(Location, Rotation);
    }
}

// --------------------------------------------------------------------------------------------------------------
// possession

void APlayerController::OnPossess(APawn* InPawn) {
    Super::OnPossess(InPawn);
    if (GetPawn()) {
        AutoManageActiveCameraTarget(GetPawn());
    }
}

void APlayerController::OnUnPossess() {
    APawn* OldPawn = GetPawn();
    Super::OnUnPossess();
    if (OldPawn && GetViewTarget() == OldPawn) {
        SetViewTarget(this);
    }
}

void APlayerController::SetPawn(APawn* InPawn) {
    Super::SetPawn(InPawn);
    AcknowledgedPawn = InPawn;
}

// -------------------------------------------------------------------------------------------------------------------
// pause

bool APlayerController::IsPaused() const {
    const UWorld* World = GetWorld();
    return World && World->IsPaused();
}

bool APlayerController::SetPause(bool bPause, FCanUnpause CanUnpauseDelegate) {
    UWorld* World = GetWorld();
    AGameModeBase* GameMode = World ? World->GetAuthGameMode() : nullptr;
    if (!GameMode) {
        return false;
    }
    const bool bPaused = IsPaused();
    if (bPause && !bPaused) {
        return GameMode->SetPause(this, CanUnpauseDelegate);
    }
    if (!bPause && bPaused) {
        return GameMode->ClearPause();
    }
    return false;
}

void APlayerController::Pause() { SetPause(!IsPaused()); }

void APlayerController::RestartLevel() { ConsoleCommand(TEXT("restartlevel")); }

// ------------------------------------------------------------------------------------------------------------------
// player

void APlayerController::SetPlayer(UPlayer* InPlayer) {
    Player = InPlayer;
    if (InPlayer) {
        InPlayer->SwitchController(this);
    }
}

ULocalPlayer* APlayerController::GetLocalPlayer() const { return Cast<ULocalPlayer>(Player.Get()); }

bool APlayerController::IsPrimaryPlayer() const {
    const ULocalPlayer* LocalPlayer = GetLocalPlayer();
    return LocalPlayer && LocalPlayer->IsPrimaryPlayer();
}

void APlayerController::SetName(const FString& S) {
    AGameModeBase* GameMode = GetWorld() ? GetWorld()->GetAuthGameMode() : nullptr;
    if (!S.IsEmpty() && GameMode) {
        GameMode->ChangeName(this, S, true);
    }
}

FString APlayerController::ConsoleCommand(const FString& Command, bool bWriteToLog) {
    return Player ? Player->ConsoleCommand(Command, bWriteToLog) : FString();
}

void APlayerController::GetViewportSize(int32& SizeX, int32& SizeY) const {
    const ULocalPlayer* LocalPlayer = GetLocalPlayer();
    FVector2D Size(0.0, 0.0);
    if (LocalPlayer && LocalPlayer->ViewportClient) {
        LocalPlayer->ViewportClient->GetViewportSize(Size);
    }
    SizeX = FMath::TruncToInt32(Size.X);
    SizeY = FMath::TruncToInt32(Size.Y);
}
