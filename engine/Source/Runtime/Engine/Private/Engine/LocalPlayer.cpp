// SPDX-License-Identifier: MIT
#include "Engine/LocalPlayer.h"

#include "Camera/CameraTypes.h"
#include "Camera/PlayerCameraManager.h"
#include "Engine/Engine.h"
#include "Engine/GameInstance.h"
#include "Engine/GameViewportClient.h"
#include "Engine/World.h"
#include "GameFramework/PlayerController.h"
#include "GameFramework/PlayerState.h"

ULocalPlayer::ULocalPlayer(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer), ControllerId(INDEX_NONE) {}

void ULocalPlayer::PlayerAdded(UGameViewportClient* InViewportClient, int32 InControllerID) {
    ViewportClient = InViewportClient;
    ControllerId = InControllerID;
    SubsystemCollection.Initialize(this);
}

void ULocalPlayer::PlayerRemoved() {
    SubsystemCollection.Deinitialize();
    ViewportClient = nullptr;
}

UGameInstance* ULocalPlayer::GetGameInstance() const {
    return ViewportClient ? ViewportClient->GetGameInstance() : GEngine ? GEngine->GetGameInstance() : nullptr;
}

UWorld* ULocalPlayer::GetWorld() const {
    const UGameInstance* GameInstance = GetGameInstance();
    return GameInstance ? GameInstance->GetWorld() : nullptr;
}

int32 ULocalPlayer::GetLocalPlayerIndex() const {
    const UGameInstance* GameInstance = GetGameInstance();
    return GameInstance ? GameInstance->GetLocalPlayers().Find(const_cast<ULocalPlayer*>(this)) : INDEX_NONE;
}

FString ULocalPlayer::GetNickname() const {
    return PlayerController && PlayerController->PlayerState ? PlayerController->PlayerState->GetPlayerName()
                                                             : FString();
}

bool ULocalPlayer::SpawnPlayActor(const FString& URL, FString& OutError, UWorld* InWorld) {
    check(InWorld);
    const FURL PlayerURL(&InWorld->URL, *URL, TRAVEL_Absolute);
    return InWorld->SpawnPlayActor(this, PlayerURL, OutError) != nullptr;
}

void ULocalPlayer::SwitchController(APlayerController* PC) {
    Super::SwitchController(PC);
    for (ULocalPlayerSubsystem* Subsystem : GetSubsystemArrayCopy<ULocalPlayerSubsystem>()) {
        Subsystem->PlayerControllerChanged(PC);
    }
}

bool ULocalPlayer::GetViewPoint(FMinimalViewInfo& OutViewInfo) const {
    if (!PlayerController || !PlayerController->PlayerCameraManager) {
        return false;
    }
    OutViewInfo = PlayerController->PlayerCameraManager->GetCameraCacheView();
    return true;
}

ULocalPlayerSubsystem* ULocalPlayer::GetSubsystemBase(TSubclassOf<ULocalPlayerSubsystem> SubsystemClass) const {
    return SubsystemCollection.GetSubsystem<ULocalPlayerSubsystem>(SubsystemClass);
}

bool ULocalPlayer::Exec(UWorld* InWorld, const TCHAR* Cmd, FOutputDevice& Ar) {
    return Super::Exec(InWorld ? InWorld : GetWorld(), Cmd, Ar);
}
