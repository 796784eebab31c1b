// SPDX-License-Identifier: MIT
#include "GameFramework/WorldSettings.h"

#include "Engine/Level.h"
#include "Engine/World.h"
#include "GameFramework/GameModeBase.h"
#include "GameFramework/PlayerState.h"

namespace {
/** UE's default gravity, in centimetres per second squared. */
constexpr float DefaultGravityZ = -980.f;
} // namespace

AWorldSettings::AWorldSettings(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    bGlobalGravitySet = false;
    bWorldGravitySet = false;
    bEnableWorldBoundsChecks = true;
    KillZ = -1048575.f;
    WorldGravityZ = 0.f;
    GlobalGravityZ = 0.f;
    TimeDilation = 1.f;
    CinematicTimeDilation = 1.f;
    MinGlobalTimeDilation = 0.0001f;
    MaxGlobalTimeDilation = 20.f;
    MinUndilatedFrameTime = 0.0005f;
    MaxUndilatedFrameTime = 0.4f;
}

void AWorldSettings::PreInitializeComponents() {
    Super::PreInitializeComponents();
    if (!bWorldGravitySet) {
        WorldGravityZ = GetGravityZ();
    }
}

float AWorldSettings::GetGravityZ() const {
    if (bWorldGravitySet) {
        return WorldGravityZ;
    }
    return bGlobalGravitySet ? GlobalGravityZ : DefaultGravityZ;
}

float AWorldSettings::SetTimeDilation(float NewTimeDilation) {
    TimeDilation = FMath::Clamp(NewTimeDilation, MinGlobalTimeDilation, MaxGlobalTimeDilation);
    return TimeDilation;
}

float AWorldSettings::FixupDeltaSeconds(float DeltaSeconds, float) {
    // The limits are for undilated time.
    const float Dilation = GetEffectiveTimeDilation();
    return FMath::Clamp(DeltaSeconds, MinUndilatedFrameTime * Dilation, MaxUndilatedFrameTime * Dilation);
}

void AWorldSettings::SetPauserPlayerState(APlayerState* PlayerState) { PauserPlayerState = PlayerState; }

void AWorldSettings::NotifyBeginPlay() {
    UWorld* World = GetWorld();
    if (World->HasBegunPlay()) {
        return;
    }
    // Set first: what is spawned from here on begins to play by itself.
    World->SetBegunPlay(true);
    for (int32 LevelIndex = 0; LevelIndex < World->GetNumLevels(); ++LevelIndex) {
        ULevel* Level = World->GetLevel(LevelIndex);
        for (int32 Index = 0; Index < Level->Actors.Num(); ++Index) {
            AActor* Actor = Level->Actors[Index];
            if (Actor && !Actor->IsActorBeingDestroyed() && Actor->IsActorInitialized()) {
                Actor->DispatchBeginPlay();
            }
        }
    }
}
