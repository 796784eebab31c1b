// SPDX-License-Identifier: MIT
#include "GameFramework/PlayerState.h"

#include "Engine/World.h"
#include "GameFramework/GameStateBase.h"
#include "GameFramework/Pawn.h"
#include "GameFramework/PlayerController.h"

APlayerState::APlayerState(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer), Score(0.f), PlayerId(0) {}

void APlayerState::PostInitializeComponents() {
    Super::PostInitializeComponents();
    if (AGameStateBase* GameState = GetWorld()->GetGameState()) {
        GameState->AddPlayerState(this);
    }
}

void APlayerState::Destroyed() {
    if (AGameStateBase* GameState = GetWorld()->GetGameState()) {
        GameState->RemovePlayerState(this);
    }
    Super::Destroyed();
}

void APlayerState::Reset() {
    Super::Reset();
    SetScore(0.f);
}

void APlayerState::SetPlayerName(const FString& S) { PlayerNamePrivate = S; }

void APlayerState::SetPawnPrivate(APawn* InPawn) {
    if (PawnPrivate != InPawn) {
        APawn* OldPawn = PawnPrivate;
        PawnPrivate = InPawn;
        OnPawnSet.Broadcast(this, InPawn, OldPawn);
    }
}

AController* APlayerState::GetOwningController() const { return Cast<AController>(GetOwner()); }

APlayerController* APlayerState::GetPlayerController() const { return Cast<APlayerController>(GetOwner()); }
