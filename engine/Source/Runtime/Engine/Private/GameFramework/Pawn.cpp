// SPDX-License-Identifier: MIT
#include "GameFramework/Pawn.h"

#include "Components/SceneComponent.h"
#include "Engine/GameInstance.h"
#include "Engine/LocalPlayer.h"
#include "Engine/World.h"
#include "GameFramework/Controller.h"
#include "GameFramework/PawnMovementComponent.h"
#include "GameFramework/PlayerController.h"
#include "GameFramework/PlayerState.h"

APawn::APawn(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    PrimaryActorTick.bCanEverTick = true;
    PrimaryActorTick.TickGroup = TG_PrePhysics;
    bUseControllerRotationPitch = false;
    bUseControllerRotationYaw = false;
    bUseControllerRotationRoll = false;
    BaseEyeHeight = 64.f;
    AutoPossessPlayer = EAutoReceiveInput::Disabled;
    ControlInputVector = FVector::ZeroVector;
    LastControlInputVector = FVector::ZeroVector;
}

void APawn::PostInitializeComponents() {
    Super::PostInitializeComponents();
    if (IsValid(this)) {
        SetInstigator(this);
    }
}

void APawn::BeginPlay() {
    Super::BeginPlay();
    if (AutoPossessPlayer != EAutoReceiveInput::Disabled && !Controller) {
        const int32 PlayerIndex = AutoPossessPlayer.GetIntValue() - EAutoReceiveInput::Player0;
        const UGameInstance* GameInstance = GetGameInstance();
        const ULocalPlayer* Player = GameInstance ? GameInstance->GetLocalPlayerByIndex(PlayerIndex) : nullptr;
        if (APlayerController* PlayerController = Player ? Player->GetPlayerController(GetWorld()) : nullptr) {
            PlayerController->Possess(this);
        }
    }
}

void APawn::EndPlay(const EEndPlayReason::Type EndPlayReason) {
    // Only for the end of this pawn alone: when the world ends, its controllers end too.
    if (EndPlayReason == EEndPlayReason::Destroyed) {
        DetachFromControllerPendingDestroy();
    }
    Super::EndPlay(EndPlayReason);
}

void APawn::Destroyed() {
    DetachFromControllerPendingDestroy();
    Super::Destroyed();
}

void APawn::Reset() {
    if (!Controller || !Controller->IsPlayerController()) {
        DetachFromControllerPendingDestroy();
        Destroy();
    } else {
        Super::Reset();
    }
}

FVector APawn::GetVelocity() const {
    if (const UPawnMovementComponent* Movement = GetMovementComponent()) {
        return Movement->Velocity;
    }
    return Super::GetVelocity();
}

// -------------------------------------------------------------------------------------------------------------
// controller

AController* APawn::GetController() const { return Controller; }

APlayerController* APawn::GetLocalViewingPlayerController() const {
    UWorld* World = GetWorld();
    if (!World) {
        return nullptr;
    }
    for (FConstPlayerControllerIterator It = World->GetPlayerControllerIterator(); It; ++It) {
        APlayerController* PlayerController = It->Get();
        if (PlayerController && PlayerController->GetViewTarget() == this) {
            return PlayerController;
        }
    }
    return nullptr;
}

bool APawn::IsLocallyControlled() const { return Controller != nullptr; }

bool APawn::IsPlayerControlled() const { return Controller && Controller->IsPlayerController(); }

bool APawn::IsPawnControlled() const { return Controller != nullptr; }

FRotator APawn::GetControlRotation() const {
    return Controller ? Controller->GetControlRotation() : FRotator::ZeroRotator;
}

void APawn::DetachFromControllerPendingDestroy() {
    if (Controller) {
        Controller->PawnPendingDestroy(this);
    }
}

void APawn::PossessedBy(AController* NewController) {
    AController* OldController = Controller;
    Controller = NewController;
    SetOwner(NewController);
    if (NewController->PlayerState) {
        SetPlayerState(NewController->PlayerState);
    }
    if (OldController != NewController) {
        ReceivePossessed(Controller);
        NotifyControllerChanged();
    }
}

void APawn::UnPossessed() {
    AController* OldController = Controller;
    SetPlayerState(nullptr);
    SetOwner(nullptr);
    Controller = nullptr;
    ConsumeMovementInputVector();
    ReceiveUnpossessed(OldController);
    NotifyControllerChanged();
}

void APawn::NotifyControllerChanged() {
    AController* OldController = PreviousController;
    PreviousController = Controller;
    ReceiveControllerChanged(OldController, Controller);
    ReceiveControllerChangedDelegate.Broadcast(this, OldController, Controller);
}

void APawn::SetPlayerState(APlayerState* NewPlayerState) {
    if (PlayerState && PlayerState->GetPawn() == this && PlayerState != NewPlayerState) {
        PlayerState->SetPawnPrivate(nullptr);
    }
    PlayerState = NewPlayerState;
    if (PlayerState) {
        PlayerState->SetPawnPrivate(this);
    }
}

// -------------------------------------------------------------------------------------------------------------------
// view

FVector APawn::GetPawnViewLocation() const { return GetActorLocation() + FVector(0.0, 0.0, BaseEyeHeight); }

FRotator APawn::GetViewRotation() const { return Controller ? Controller->GetControlRotation() : GetActorRotation(); }

FRotator APawn::GetBaseAimRotation() const { return GetViewRotation(); }

void APawn::GetActorEyesViewPoint(FVector& OutLocation, FRotator& OutRotation) const {
    OutLocation = GetPawnViewLocation();
    OutRotation = GetViewRotation();
}

void APawn::BecomeViewTarget(APlayerController* PC) {
    Super::BecomeViewTarget(PC);
    if (GetRootComponent()) {
        MarkComponentsRenderStateDirty();
    }
}

void APawn::FaceRotation(FRotator NewControlRotation, float) {
    if (!bUseControllerRotationPitch && !bUseControllerRotationYaw && !bUseControllerRotationRoll) {
        return;
    }
    const FRotator Current = GetActorRotation();
    if (!bUseControllerRotationPitch) {
        NewControlRotation.Pitch = Current.Pitch;
    }
    if (!bUseControllerRotationYaw) {
        NewControlRotation.Yaw = Current.Yaw;
    }
    if (!bUseControllerRotationRoll) {
        NewControlRotation.Roll = Current.Roll;
    }
    SetActorRotation(NewControlRotation);
}

void APawn::RecalculateBaseEyeHeight() { BaseEyeHeight = GetClass()->GetDefaultObject<APawn>()->BaseEyeHeight; }

// ------------------------------------------------------------------------------------------------------------------
// input

UPawnMovementComponent* APawn::GetMovementComponent() const { return FindComponentByClass<UPawnMovementComponent>(); }

void APawn::AddMovementInput(FVector WorldDirection, float ScaleValue, bool bForce) {
    if (UPawnMovementComponent* Movement = GetMovementComponent()) {
        Movement->AddInputVector(WorldDirection * ScaleValue, bForce);
    } else {
        Internal_AddMovementInput(WorldDirection * ScaleValue, bForce);
    }
}

FVector APawn::GetPendingMovementInputVector() const { return ControlInputVector; }

FVector APawn::GetLastMovementInputVector() const { return LastControlInputVector; }

FVector APawn::ConsumeMovementInputVector() {
    if (UPawnMovementComponent* Movement = GetMovementComponent()) {
        return Movement->ConsumeInputVector();
    }
    return Internal_ConsumeMovementInputVector();
}

void APawn::Internal_AddMovementInput(FVector WorldAccel, bool bForce) {
    if (bForce || !IsMoveInputIgnored()) {
        ControlInputVector += WorldAccel;
    }
}

FVector APawn::Internal_ConsumeMovementInputVector() {
    LastControlInputVector = ControlInputVector;
    ControlInputVector = FVector::ZeroVector;
    return LastControlInputVector;
}

bool APawn::IsMoveInputIgnored() const { return Controller && Controller->IsMoveInputIgnored(); }

void APawn::AddControllerPitchInput(float Val) {
    if (APlayerController* PlayerController = Cast<APlayerController>(Controller.Get())) {
        PlayerController->AddPitchInput(Val);
    }
}

void APawn::AddControllerYawInput(float Val) {
    if (APlayerController* PlayerController = Cast<APlayerController>(Controller.Get())) {
        PlayerController->AddYawInput(Val);
    }
}

void APawn::AddControllerRollInput(float Val) {
    if (APlayerController* PlayerController = Cast<APlayerController>(Controller.Get())) {
        PlayerController->AddRollInput(Val);
    }
}
