// SPDX-License-Identifier: MIT
/** @file Subsystems of the game instance. Mirrors UE's Subsystems/GameInstanceSubsystem.h. */
#pragma once

#include "CoreMinimal.h"
#include "Subsystems/Subsystem.h"

#include "GameInstanceSubsystem.generated.h"

class UGameInstance;

/** Base class for auto instanced and initialized systems that share the lifetime of the game instance. */
UCLASS(Abstract, Within = GameInstance)
class ENGINE_API UGameInstanceSubsystem : public USubsystem {
    GENERATED_BODY()

public:
    UGameInstanceSubsystem();

    /** The game instance this belongs to. */
    UGameInstance* GetGameInstance() const;
    virtual UWorld* GetWorld() const override;
};
