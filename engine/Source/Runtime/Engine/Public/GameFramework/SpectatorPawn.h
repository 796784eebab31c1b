// SPDX-License-Identifier: MIT
/** @file Pawn of spectators. Mirrors UE's GameFramework/SpectatorPawn.h. */
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/DefaultPawn.h"

#include "SpectatorPawn.generated.h"

/**
 * SpectatorPawns are simple pawns that can fly around the world, used by PlayerControllers when in the spectator state.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/ASpectatorPawn
 */
UCLASS(config = Game, Blueprintable, BlueprintType, HideDropdown, notplaceable)
class ENGINE_API ASpectatorPawn : public ADefaultPawn {
    GENERATED_BODY()

public:
    ASpectatorPawn(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());
};
