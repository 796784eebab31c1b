// SPDX-License-Identifier: MIT
/** @file Players. Mirrors UE's Engine/Player.h. */
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"
#include "UObject/ObjectMacros.h"

#include "Player.generated.h"

class APlayerController;
class UWorld;

/** Object that represents a player, whose player controller is replaced with each world. */
UCLASS(Transient, config = Engine)
class ENGINE_API UPlayer : public UObject {
    GENERATED_BODY()

public:
    /** The actor this player controls. */
    UPROPERTY(Transient)
    TObjectPtr<APlayerController> PlayerController;

    /** Gets the player controller in the given world for this player; null: in any world. */
    APlayerController* GetPlayerController(const UWorld* const InWorld) const;
    /** Dynamically assign Controller to Player and set viewport. */
    virtual void SwitchController(APlayerController* PC);
    /** Dispatches a console command: of the player controller's world, the engine, or a console variable. @return its
     * output. */
    FString ConsoleCommand(const FString& Cmd, bool bWriteToLog = true);
    /** Executes a console command. @return whether any object knew it. */
    virtual bool Exec(UWorld* InWorld, const TCHAR* Cmd, FOutputDevice& Ar);
};
