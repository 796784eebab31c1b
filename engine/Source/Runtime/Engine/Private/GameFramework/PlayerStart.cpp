// SPDX-License-Identifier: MIT
#include "GameFramework/PlayerStart.h"

#include "Components/CapsuleComponent.h"

APlayerStart::APlayerStart(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    SetHidden(true);
    PlayerStartTag = NAME_None;
    CapsuleComponent = CreateDefaultSubobject<UCapsuleComponent>(FName(TEXT("CollisionCapsule")));
    CapsuleComponent->InitCapsuleSize(40.f, 92.f);
    RootComponent = CapsuleComponent;
}
