// SPDX-License-Identifier: MIT
#include "GameFramework/Info.h"

AInfo::AInfo(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    PrimaryActorTick.bCanEverTick = false;
    SetHidden(true);
}
