// SPDX-License-Identifier: MIT
/** @file The tick of worlds. */
#include "Engine/Level.h"
#include "Engine/World.h"
#include "GameFramework/PlayerController.h"
#include "GameFramework/WorldSettings.h"
#include "TickTaskManager.h"
#include "Tickable.h"
#include "TimerManager.h"

bool UWorld::IsPaused() const {
    const AWorldSettings* Settings = GetWorldSettings(false, false);
    return Settings && Settings->GetPauserPlayerState() != nullptr && TimeSeconds >= PauseDelay;
}

void UWorld::Tick(ELevelTick TickType, float DeltaSeconds) {
    check(!bInTick);
    if (!bIsWorldInitialized) {
        return;
    }
    FWorldDelegates::OnWorldTickStart.Broadcast(this, TickType, DeltaSeconds);
    bInTick = true;

    const bool bIsPaused = IsPaused();
    AWorldSettings* Settings = GetWorldSettings();
    const float RealDeltaSeconds = DeltaSeconds;
    RealTimeSeconds += RealDeltaSeconds;
    DeltaRealTimeSeconds = RealDeltaSeconds;
    DeltaSeconds =
        Settings->FixupDeltaSeconds(RealDeltaSeconds * Settings->GetEffectiveTimeDilation(), RealDeltaSeconds);
    DeltaTimeSeconds = DeltaSeconds;
    UnpausedTimeSeconds += DeltaSeconds;
    if (!bIsPaused) {
        TimeSeconds += DeltaSeconds;
    } else if (TickType == LEVELTICK_All) {
        TickType = LEVELTICK_PauseTick;
    }

    FLatentActionManager& LatentActions = GetLatentActionManager();
    LatentActions.BeginFrame();
    FWorldDelegates::OnWorldPreActorTick.Broadcast(this, TickType, DeltaSeconds);

    if (TickType != LEVELTICK_TimeOnly) {
        TickTaskManager->StartFrame(DeltaSeconds, TickType);
        for (const ETickingGroup Group :
            {TG_PrePhysics, TG_StartPhysics, TG_DuringPhysics, TG_EndPhysics, TG_PostPhysics}) {
            RunTickGroup(Group, TickType, DeltaSeconds);
        }
        if (!bIsPaused) {
            LatentActions.ProcessLatentActions(nullptr, DeltaSeconds);
            GetTimerManager().Tick(DeltaSeconds);
        }
        FTickableGameObject::TickObjects(this, TickType, bIsPaused, DeltaSeconds);
        // Before TG_PostUpdateWork, whose functions may use the camera of this frame.
        for (int32 Index = 0; Index < PlayerControllerList.Num(); ++Index) {
            if (APlayerController* PlayerController = PlayerControllerList[Index].Get()) {
                PlayerController->UpdateCameraManager(DeltaSeconds);
            }
        }
        RunTickGroup(TG_PostUpdateWork, TickType, DeltaSeconds);
        RunTickGroup(TG_LastDemotable, TickType, DeltaSeconds);
        TickTaskManager->EndFrame();
    }
    FWorldDelegates::OnWorldPostActorTick.Broadcast(this, TickType, DeltaSeconds);

    SendAllEndOfFrameUpdates();
    for (const TObjectPtr<ULevel>& Level : Levels) {
        Level->CompactActors();
    }
    TickGroup = TG_NewlySpawned;
    bInTick = false;
    FWorldDelegates::OnWorldTickEnd.Broadcast(this, TickType, DeltaSeconds);
}

void UWorld::RunTickGroup(ETickingGroup Group, ELevelTick, float) {
    TickGroup = Group;
    TickTaskManager->RunTickGroup(Group);
}

void UWorld::MarkActorComponentForNeededEndOfFrameUpdate(UActorComponent* Component) {
    ComponentsThatNeedEndOfFrameUpdate.Add(Component);
}

void UWorld::ClearActorComponentEndOfFrameUpdate(UActorComponent* Component) {
    if (Component->bMarkedForEndOfFrameUpdate) {
        ComponentsThatNeedEndOfFrameUpdate.RemoveSwap(Component);
    }
}

void UWorld::SendAllEndOfFrameUpdates() {
    const TArray<TWeakObjectPtr<UActorComponent>> Components = MoveTemp(ComponentsThatNeedEndOfFrameUpdate);
    ComponentsThatNeedEndOfFrameUpdate.Reset();
    for (const TWeakObjectPtr<UActorComponent>& Component : Components) {
        if (UActorComponent* Live = Component.Get()) {
            Live->DoDeferredRenderUpdates_Concurrent();
        }
    }
}
