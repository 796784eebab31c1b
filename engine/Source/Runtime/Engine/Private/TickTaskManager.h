// SPDX-License-Identifier: MIT
/** @file Runs the tick functions of one world. */
#pragma once

#include "CoreMinimal.h"
#include "Engine/EngineBaseTypes.h"

class UWorld;

/**
 * Holds the tick functions of a world and runs them, group by group, in a deterministic order: see FTickFunction.
 */
class FTickTaskManager {
public:
    explicit FTickTaskManager(UWorld* InWorld);
    ~FTickTaskManager();

    void Add(FTickFunction& Function);
    void Remove(FTickFunction& Function);
    /** Called when a registered function was enabled during a frame: it may still run in it. */
    void NotifyEnabled(FTickFunction& Function);

    /** Decides what runs in this frame, in which group and order. */
    void StartFrame(float DeltaSeconds, ELevelTick TickType);
    /** Runs one group, and everything spawned meanwhile whose group has come or gone. */
    void RunTickGroup(ETickingGroup Group);
    void EndFrame();

    /** Number of registered functions. */
    int32 Num() const;
    /** Number of functions executed in the last frame. */
    int32 NumExecutedInLastFrame() const { return NumExecuted; }

private:
    bool IsDue(const FTickFunction& Function) const;
    /** Puts a function, after its prerequisites, into the queue of the group it can start in. */
    void Queue(FTickFunction& Function);
    void RunQueue(TArray<FTickFunction*>& Functions);
    void Execute(FTickFunction& Function);
    void Compact();

    UWorld* World;
    /** In the order of registration; null where a function was removed. */
    TArray<FTickFunction*> Functions;
    TArray<FTickFunction*> Queues[TG_MAX];
    /** Functions that were registered or enabled during the frame. */
    TArray<FTickFunction*> NewlySpawned;
    uint64 Frame;
    int32 CurrentGroup;
    int32 NumExecuted;
    float FrameDeltaSeconds;
    ELevelTick FrameTickType;
    bool bInFrame;
    bool bNeedsCompact;
};
