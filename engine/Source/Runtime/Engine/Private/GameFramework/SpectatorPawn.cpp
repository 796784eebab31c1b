// SPDX-License-Identifier: MIT
#include "GameFramework/SpectatorPawn.h"

ASpectatorPawn::ASpectatorPawn(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    SetActorEnableCollision(false);
}
