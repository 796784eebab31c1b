// SPDX-License-Identifier: MIT
#include "TickTaskManager.h"

#include "Engine/World.h"

FTickTaskManager::FTickTaskManager(UWorld* InWorld)
    : World(InWorld), Frame(0), CurrentGroup(INDEX_NONE), NumExecuted(0), FrameDeltaSeconds(0.f),
      FrameTickType(LEVELTICK_All), bInFrame(false), bNeedsCompact(false) {}

FTickTaskManager::~FTickTaskManager() {
    for (FTickFunction* Function : Functions) {
        if (Function) {
            Function->Manager = nullptr;
            Function->bRegistered = false;
        }
    }
}

void FTickTaskManager::Add(FTickFunction& Function) {
    Function.ManagerIndex = Functions.Add(&Function);
    Function.Manager = this;
    Function.bRegistered = true;
    Function.QueuedFrame = 0;
    Function.ExecutedFrame = 0;
    Function.CooldownSeconds = 0.0;
    Function.TimeSinceLastTick = -1.f;
    Function.LastTickGameTimeSeconds = -1.0;
    NotifyEnabled(Function);
}

void FTickTaskManager::Remove(FTickFunction& Function) {
    Functions[Function.ManagerIndex] = nullptr;
    bNeedsCompact = true;
    Function.Manager = nullptr;
    Function.bRegistered = false;
    if (bInFrame) {
        const auto Forget = [&Function](TArray<FTickFunction*>& List) {
            for (FTickFunction*& Entry : List) {
                if (Entry == &Function) {
                    Entry = nullptr;
                }
            }
        };
        for (TArray<FTickFunction*>& List : Queues) {
            Forget(List);
        }
        Forget(NewlySpawned);
    }
}

void FTickTaskManager::NotifyEnabled(FTickFunction& Function) {
    if (bInFrame && Function.QueuedFrame != Frame) {
        NewlySpawned.Add(&Function);
    }
}

int32 FTickTaskManager::Num() const {
    int32 Count = 0;
    for (const FTickFunction* Function : Functions) {
        Count += Function ? 1 : 0;
    }
    return Count;
}

void FTickTaskManager::Compact() {
    int32 Kept = 0;
    for (FTickFunction* Function : Functions) {
        if (Function) {
            Function->ManagerIndex = Kept;
            Functions[Kept++] = Function;
        }
    }
    Functions.SetNum(Kept);
    bNeedsCompact = false;
}

bool FTickTaskManager::IsDue(const FTickFunction& Function) const {
    if (!Function.bTickEnabled || (FrameTickType == LEVELTICK_PauseTick && !Function.bTickEvenWhenPaused)) {
        return false;
    }
    // A tolerance far below any interval keeps "every 0.1 s at 60 Hz" from slipping a frame by rounding.
    return Function.TickInterval <= 0.f || Function.CooldownSeconds <= 1.0e-5;
}

void FTickTaskManager::StartFrame(float DeltaSeconds, ELevelTick TickType) {
    check(!bInFrame);
    if (bNeedsCompact) {
        Compact();
    }
    ++Frame;
    bInFrame = true;
    CurrentGroup = INDEX_NONE;
    NumExecuted = 0;
    FrameDeltaSeconds = DeltaSeconds;
    FrameTickType = TickType;

    for (FTickFunction* Function : Functions) {
        const bool bClockRuns = TickType != LEVELTICK_PauseTick || Function->bTickEvenWhenPaused;
        if (Function->bTickEnabled && Function->TickInterval > 0.f && Function->TimeSinceLastTick >= 0.f &&
            bClockRuns) {
            Function->CooldownSeconds -= DeltaSeconds;
            Function->TimeSinceLastTick += DeltaSeconds;
        }
    }
    for (const bool bHighPriority : {true, false}) {
        for (FTickFunction* Function : Functions) {
            if (static_cast<bool>(Function->bHighPriority) == bHighPriority && IsDue(*Function)) {
                Queue(*Function);
            }
        }
    }
}

void FTickTaskManager::Queue(FTickFunction& Function) {
    if (Function.QueuedFrame == Frame) {
        return;
    }
    // Marked before the prerequisites are visited: a cycle of prerequisites ends here instead of recursing for ever.
    Function.QueuedFrame = Frame;
    int32 StartGroup = FMath::Clamp<int32>(Function.TickGroup, TG_PrePhysics, TG_LastDemotable);
    for (int32 Index = 0; Index < Function.Prerequisites.Num(); ++Index) {
        FTickFunction* Prerequisite = Function.Prerequisites[Index].Get();
        if (!Prerequisite) {
            Function.Prerequisites.RemoveAt(Index--);
        } else if (Prerequisite->Manager == this && IsDue(*Prerequisite)) {
            Queue(*Prerequisite);
            StartGroup = FMath::Max<int32>(StartGroup, Prerequisite->ActualStartTickGroup);
        }
    }
    // What is queued late (spawned meanwhile) cannot run in a group that is over.
    StartGroup = FMath::Max(StartGroup, CurrentGroup);
    Function.ActualStartTickGroup = static_cast<ETickingGroup>(StartGroup);
    Queues[StartGroup].Add(&Function);
}

void FTickTaskManager::RunTickGroup(ETickingGroup Group) {
    check(bInFrame);
    CurrentGroup = Group;
    RunQueue(Queues[Group]);
    while (NewlySpawned.Num() > 0) {
        const TArray<FTickFunction*> Spawned = MoveTemp(NewlySpawned);
        NewlySpawned.Reset();
        for (FTickFunction* Function : Spawned) {
            if (Function && IsDue(*Function)) {
                Queue(*Function);
            }
        }
        RunQueue(Queues[Group]);
    }
}

void FTickTaskManager::RunQueue(TArray<FTickFunction*>& List) {
    // By index: what runs may spawn, which appends to the lists, or destroy, which nulls entries.
    for (int32 Index = 0; Index < List.Num(); ++Index) {
        if (FTickFunction* Function = List[Index]) {
            List[Index] = nullptr;
            Execute(*Function);
        }
    }
    List.Reset();
}

void FTickTaskManager::Execute(FTickFunction& Function) {
    if (!Function.bTickEnabled || Function.ExecutedFrame == Frame) {
        return;
    }
    Function.ExecutedFrame = Frame;
    float DeltaSeconds = FrameDeltaSeconds;
    if (Function.TickInterval > 0.f) {
        // The first tick is due at once and starts the count; later ones carry over what they were late by.
        const bool bFirst = Function.TimeSinceLastTick < 0.f;
        DeltaSeconds = bFirst ? FrameDeltaSeconds : Function.TimeSinceLastTick;
        Function.CooldownSeconds =
            FMath::Max(0.0, (bFirst ? 0.0 : Function.CooldownSeconds) + static_cast<double>(Function.TickInterval));
        Function.TimeSinceLastTick = 0.f;
    }
    Function.LastTickGameTimeSeconds = World->GetTimeSeconds();
    ++NumExecuted;
    Function.ExecuteTick(DeltaSeconds, FrameTickType, ENamedThreads::GameThread, FGraphEventRef());
}

void FTickTaskManager::EndFrame() {
    check(bInFrame);
    for (TArray<FTickFunction*>& List : Queues) {
        List.Reset();
    }
    NewlySpawned.Reset();
    bInFrame = false;
    CurrentGroup = INDEX_NONE;
}
