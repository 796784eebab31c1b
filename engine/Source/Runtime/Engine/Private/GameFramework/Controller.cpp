// SPDX-License-Identifier: MIT
#include "GameFramework/Controller.h"

#include "Components/SceneComponent.h"
#include "Engine/World.h"
#include "GameFramework/GameModeBase.h"
#include "GameFramework/Pawn.h"
#include "GameFramework/PlayerController.h"
#include "GameFramework/PlayerState.h"

AController::AController(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    PrimaryActorTick.bCanEverTick = true;
    SetHidden(true);
    StateName = NAME_None;
    ControlRotation = FRotator::ZeroRotator;
    IgnoreMoveInput = 0;
    IgnoreLookInput = 0;
    // A place in the world, to look from without a pawn.
    USceneComponent* Transform = CreateDefaultSubobject<USceneComponent>(FName(TEXT("TransformComponent0")));
    RootComponent = Transform;
}

void AController::PostInitializeComponents() {
    Super::PostInitializeComponents();
    if (IsValid(this)) {
        GetWorld()->AddController(this);
    }
}

void AController::Destroyed() {
    if (Pawn) {
        UnPossess();
    }
    if (UWorld* World = GetWorld()) {
        if (AGameModeBase* GameMode = World->GetAuthGameMode()) {
            GameMode->Logout(this);
        }
        World->RemoveController(this);
    }
    CleanupPlayerState();
    Super::Destroyed();
}

void AController::Reset() {
    Super::Reset();
    StartSpot = nullptr;
}

void AController::GetActorEyesViewPoint(FVector& OutLocation, FRotator& OutRotation) const {
    if (Pawn) {
        Pawn->GetActorEyesViewPoint(OutLocation, OutRotation);
    } else {
        OutLocation = GetActorLocation();
        OutRotation = GetControlRotation();
    }
}

// -------------------------------------------------------------------------------------------------------------
// possession

void AController::Possess(APawn* InPawn) {
    APawn* OldPawn = Pawn;
    OnPossess(InPawn);
    if (OldPawn != Pawn) {
        NotifyPawnChanged(OldPawn);
    }
}

void AController::OnPossess(APawn* InPawn) {
    if (!InPawn || !IsValid(InPawn)) {
        return;
    }
    const bool bNewPawn = Pawn != InPawn;
    if (bNewPawn && Pawn) {
        UnPossess();
    }
    if (InPawn->Controller && InPawn->Controller != this) {
        InPawn->Controller->UnPossess();
    }
    InPawn->PossessedBy(this);
    SetPawn(InPawn);
    SetControlRotation(InPawn->GetActorRotation());
    if (bNewPawn) {
        ReceivePossess(InPawn);
    }
}

void AController::UnPossess() {
    APawn* OldPawn = Pawn;
    if (!OldPawn) {
        return;
    }
    OnUnPossess();
    ReceiveUnPossess(OldPawn);
    NotifyPawnChanged(OldPawn);
}

void AController::OnUnPossess() {
    if (Pawn) {
        Pawn->UnPossessed();
        SetPawn(nullptr);
    }
}

void AController::NotifyPawnChanged(APawn* OldPawn) { OnPossessedPawnChanged.Broadcast(OldPawn, Pawn); }

APawn* AController::K2_GetPawn() const { return Pawn; }

void AController::SetPawn(APawn* InPawn) {
    Pawn = InPawn;
    if (PlayerState) {
        PlayerState->SetPawnPrivate(InPawn);
    }
    if (RootComponent) {
        // The controller goes where its pawn goes.
        RootComponent->DetachFromComponent(FDetachmentTransformRules::KeepWorldTransform);
        if (InPawn && InPawn->GetRootComponent()) {
            RootComponent->SetRelativeLocationAndRotation(FVector::ZeroVector, FRotator::ZeroRotator);
            RootComponent->AttachToComponent(
                InPawn->GetRootComponent(), FAttachmentTransformRules::KeepRelativeTransform);
        }
    }
}

void AController::PawnPendingDestroy(APawn* InPawn) {
    if (InPawn && InPawn == Pawn) {
        UnPossess();
    }
}

// ----------------------------------------------------------------------------------------------------------- player
// state

void AController::InitPlayerState() {
    UWorld* World = GetWorld();
    const AGameModeBase* GameMode = World ? World->GetAuthGameMode() : nullptr;
    if (!GameMode) {
        return;
    }
    FActorSpawnParameters SpawnInfo;
    SpawnInfo.Owner = this;
    SpawnInfo.Instigator = Instigator;
    SpawnInfo.ObjectFlags |= RF_Transient;
    UClass* PlayerStateClass =
        GameMode->PlayerStateClass ? GameMode->PlayerStateClass.Get() : APlayerState::StaticClass();
    PlayerState = World->SpawnActor<APlayerState>(PlayerStateClass, SpawnInfo);
    if (PlayerState && PlayerState->GetPlayerName().IsEmpty()) {
        PlayerState->SetPlayerName(GameMode->DefaultPlayerNameText);
    }
}

void AController::CleanupPlayerState() {
    if (PlayerState) {
        PlayerState->Destroy();
        PlayerState = nullptr;
    }
}

// ---------------------------------------------------------------------------------------------------------------
// rotation

FRotator AController::GetControlRotation() const { return ControlRotation; }

void AController::SetControlRotation(const FRotator& NewRotation) {
    if (!NewRotation.ContainsNaN()) {
        ControlRotation = NewRotation;
    }
}

void AController::SetInitialLocationAndRotation(const FVector& NewLocation, const FRotator& NewRotation) {
    SetActorLocationAndRotation(NewLocation, NewRotation);
    SetControlRotation(NewRotation);
}

FRotator AController::GetDesiredRotation() const { return GetControlRotation(); }

AActor* AController::GetViewTarget() const {
    if (Pawn) {
        return Pawn;
    }
    return const_cast<AController*>(this);
}

void AController::GetPlayerViewPoint(FVector& Location, FRotator& Rotation) const {
    GetActorEyesViewPoint(Location, Rotation);
}

bool AController::IsPlayerController() const { return IsA(APlayerController::StaticClass()); }

bool AController::IsLocalPlayerController() const { return IsPlayerController(); }

// ------------------------------------------------------------------------------------------------------------------
// input

void AController::SetIgnoreMoveInput(bool bNewMoveInput) {
    IgnoreMoveInput = static_cast<uint8>(FMath::Clamp(IgnoreMoveInput + (bNewMoveInput ? 1 : -1), 0, 255));
}

void AController::ResetIgnoreMoveInput() { IgnoreMoveInput = 0; }

bool AController::IsMoveInputIgnored() const { return IgnoreMoveInput > 0; }

void AController::SetIgnoreLookInput(bool bNewLookInput) {
    IgnoreLookInput = static_cast<uint8>(FMath::Clamp(IgnoreLookInput + (bNewLookInput ? 1 : -1), 0, 255));
}

void AController::ResetIgnoreLookInput() { IgnoreLookInput = 0; }

bool AController::IsLookInputIgnored() const { return IgnoreLookInput > 0; }

void AController::ResetIgnoreInputFlags() {
    ResetIgnoreMoveInput();
    ResetIgnoreLookInput();
}

void AController::StopMovement() {
    if (Pawn && Pawn->GetRootComponent()) {
        Pawn->GetRootComponent()->ComponentVelocity = FVector::ZeroVector;
    }
}
