// SPDX-License-Identifier: MIT
#include "Engine/Player.h"

#include "Engine/Engine.h"
#include "GameFramework/PlayerController.h"
#include "Misc/StringOutputDevice.h"

APlayerController* UPlayer::GetPlayerController(const UWorld* const InWorld) const {
    return PlayerController && (!InWorld || PlayerController->GetWorld() == InWorld) ? PlayerController.Get() : nullptr;
}

void UPlayer::SwitchController(APlayerController* PC) {
    if (PlayerController && PlayerController != PC) {
        PlayerController->Player = nullptr;
    }
    PlayerController = PC;
    if (PC) {
        PC->Player = this;
    }
}

FString UPlayer::ConsoleCommand(const FString& Cmd, bool bWriteToLog) {
    FStringOutputDevice Output;
    UWorld* World = PlayerController ? PlayerController->GetWorld() : GetWorld();
    if (!Exec(World, *Cmd, Output)) {
        Output.Logf(TEXT("Command not recognized: %s"), *Cmd);
    }
    if (bWriteToLog && !Output.IsEmpty()) {
        UE_LOG(LogEngine, Log, TEXT("%s"), *static_cast<const FString&>(Output));
    }
    return FString(Output);
}

bool UPlayer::Exec(UWorld* InWorld, const TCHAR* Cmd, FOutputDevice& Ar) {
    return GEngine && GEngine->Exec(InWorld, Cmd, Ar);
}
