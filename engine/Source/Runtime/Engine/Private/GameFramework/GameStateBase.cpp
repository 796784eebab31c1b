// SPDX-License-Identifier: MIT
#include "GameFramework/GameStateBase.h"

#include "Engine/World.h"
#include "GameFramework/Controller.h"
#include "GameFramework/GameModeBase.h"
#include "GameFramework/PlayerState.h"
#include "GameFramework/WorldSettings.h"

AGameStateBase::AGameStateBase(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer), bReplicatedHasBegunPlay(false) {}

const AGameModeBase* AGameStateBase::GetDefaultGameMode() const {
    return GameModeClass ? GameModeClass->GetDefaultObject<AGameModeBase>() : nullptr;
}

double AGameStateBase::GetServerWorldTimeSeconds() const {
    const UWorld* World = GetWorld();
    return World ? World->GetTimeSeconds() : 0.0;
}

bool AGameStateBase::HasBegunPlay() const {
    const UWorld* World = GetWorld();
    return World && World->HasBegunPlay();
}

bool AGameStateBase::HasMatchStarted() const { return bReplicatedHasBegunPlay; }

float AGameStateBase::GetPlayerStartTime(AController*) const { return static_cast<float>(GetServerWorldTimeSeconds()); }

void AGameStateBase::AddPlayerState(APlayerState* PlayerState) { PlayerArray.AddUnique(PlayerState); }

void AGameStateBase::RemovePlayerState(APlayerState* PlayerState) { PlayerArray.Remove(PlayerState); }

void AGameStateBase::HandleBeginPlay() {
    bReplicatedHasBegunPlay = true;
    UWorld* World = GetWorld();
    World->GetWorldSettings()->NotifyBeginPlay();
    World->GetWorldSettings()->NotifyMatchStarted();
    World->bMatchStarted = true;
}

void AGameStateBase::PreInitializeComponents() {
    Super::PreInitializeComponents();
    GetWorld()->SetGameState(this);
}

void AGameStateBase::PostInitializeComponents() { Super::PostInitializeComponents(); }
