// SPDX-License-Identifier: MIT
#include "Tickable.h"

#include "Engine/World.h"

namespace {
struct FTickables {
    /** In the order of construction; null where one was destroyed during a tick. */
    TArray<FTickableGameObject*> Objects;
    int32 IteratingDepth = 0;
};

FTickables& GetTickables() {
    // Never destroyed: tickables with static life unregister after this module's statics are gone.
    static FTickables* Tickables = new FTickables;
    return *Tickables;
}
} // namespace

FTickableGameObject::FTickableGameObject(ETickableTickType StartingTickType) : TickType(StartingTickType) {
    GetTickables().Objects.Add(this);
}

FTickableGameObject::~FTickableGameObject() {
    FTickables& Tickables = GetTickables();
    const int32 Index = Tickables.Objects.Find(this);
    if (Tickables.IteratingDepth > 0) {
        Tickables.Objects[Index] = nullptr;
    } else {
        Tickables.Objects.RemoveAt(Index);
    }
}

void FTickableGameObject::SetTickableTickType(ETickableTickType NewTickType) { TickType = NewTickType; }

void FTickableGameObject::TickObjects(UWorld* World, int32 LevelTickType, bool bIsGamePaused, float DeltaSeconds) {
    FTickables& Tickables = GetTickables();
    ++Tickables.IteratingDepth;
    for (int32 Index = 0; Index < Tickables.Objects.Num(); ++Index) {
        FTickableGameObject* Object = Tickables.Objects[Index];
        if (!Object || Object->TickType == ETickableTickType::Never || !Object->IsAllowedToTick()) {
            continue;
        }
        if (Object->TickType == ETickableTickType::NewObject) {
            Object->TickType = Object->GetTickableTickType();
        }
        const bool bWantsTick = Object->TickType == ETickableTickType::Always ||
                                (Object->TickType == ETickableTickType::Conditional && Object->IsTickable());
        if (bWantsTick && Object->GetTickableGameObjectWorld() == World &&
            (!bIsGamePaused || Object->IsTickableWhenPaused()) && LevelTickType != LEVELTICK_TimeOnly) {
            Object->Tick(DeltaSeconds);
        }
    }
    if (--Tickables.IteratingDepth == 0) {
        Tickables.Objects.Remove(nullptr);
    }
}
