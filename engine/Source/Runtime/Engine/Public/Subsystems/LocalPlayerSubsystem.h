// SPDX-License-Identifier: MIT
/** @file Subsystems of local players. Mirrors UE's Subsystems/LocalPlayerSubsystem.h. */
#pragma once

#include "CoreMinimal.h"
#include "Subsystems/Subsystem.h"

#include "LocalPlayerSubsystem.generated.h"

class APlayerController;
class ULocalPlayer;

/** Base class for auto instanced and initialized subsystems that share the lifetime of local players. */
UCLASS(Abstract, Within = LocalPlayer)
class ENGINE_API ULocalPlayerSubsystem : public USubsystem {
    GENERATED_BODY()

public:
    ULocalPlayerSubsystem();

    /** The local player this belongs to; T is ULocalPlayer or derived. */
    template <typename LocalPlayerType = ULocalPlayer>
    LocalPlayerType* GetLocalPlayer() const {
        return Cast<LocalPlayerType>(GetOuter());
    }
    ULocalPlayer* GetLocalPlayerChecked() const;
    virtual UWorld* GetWorld() const override;

    /** Callback for when the player controller is changed on this subsystem's owning local player. */
    virtual void PlayerControllerChanged(APlayerController* NewPlayerController) {}
};
