// SPDX-License-Identifier: MIT
/** @file Iterators over actors. Mirrors UE's EngineUtils.h. */
#pragma once

#include "CoreMinimal.h"
#include "Engine/Level.h"
#include "Engine/World.h"
#include "GameFramework/Actor.h"

/** Specifies flags used for actor iterators. */
enum class EActorIteratorFlags {
    /** No flags: iterate on all actors, including those being destroyed. */
    AllActors = 0x00000000,
    /** Skip pending kill actors. */
    SkipPendingKill = 0x00000001,
    /** Only iterate actors in active levels: there are no others here. */
    OnlyActiveLevels = 0x00000004,
};
ENUM_CLASS_FLAGS(EActorIteratorFlags);

/**
 * Iterates over the actors of a world that are of a class, level by level, in the order of spawning. Actors that are
 * spawned during the iteration are visited too; actors may be destroyed.
 */
class FActorIteratorBase {
public:
    FActorIteratorBase(const UWorld* InWorld, UClass* InClass, EActorIteratorFlags InFlags)
        : World(InWorld), Class(InClass), Flags(InFlags), LevelIndex(0), ActorIndex(INDEX_NONE), CurrentActor(nullptr) {
        Advance();
    }

    /** Advances to the next actor. */
    void operator++() { Advance(); }
    /** Whether there is a current actor. */
    explicit operator bool() const { return CurrentActor != nullptr; }
    bool operator!() const { return CurrentActor == nullptr; }
    /** Clears the current Actor in the array: destroys nothing. */
    UWorld* GetWorld() const { return const_cast<UWorld*>(World); }

protected:
    AActor* GetCurrent() const { return CurrentActor; }

private:
    void Advance() {
        CurrentActor = nullptr;
        if (!World) {
            return;
        }
        const TArray<TObjectPtr<ULevel>>& Levels = World->GetLevels();
        while (LevelIndex < Levels.Num()) {
            const ULevel* Level = Levels[LevelIndex];
            while (Level && ++ActorIndex < Level->Actors.Num()) {
                AActor* Actor = Level->Actors[ActorIndex];
                const bool bSkip = EnumHasAnyFlags(Flags, EActorIteratorFlags::SkipPendingKill) && Actor &&
                                   Actor->IsActorBeingDestroyed();
                if (Actor && !bSkip && Actor->IsA(Class)) {
                    CurrentActor = Actor;
                    return;
                }
            }
            ++LevelIndex;
            ActorIndex = INDEX_NONE;
        }
    }

    const UWorld* World;
    UClass* Class;
    EActorIteratorFlags Flags;
    int32 LevelIndex;
    int32 ActorIndex;
    AActor* CurrentActor;
};

/**
 * Template actor iterator: `for (TActorIterator<APawn> It(World); It; ++It) { It->...; }`. It can be given a derived
 * class.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/TActorIterator
 */
template <typename ActorType>
class TActorIterator : public FActorIteratorBase {
public:
    explicit TActorIterator(const UWorld* InWorld, TSubclassOf<ActorType> InClass = ActorType::StaticClass(),
        EActorIteratorFlags InFlags = EActorIteratorFlags::OnlyActiveLevels | EActorIteratorFlags::SkipPendingKill)
        : FActorIteratorBase(InWorld, InClass, InFlags) {}

    ActorType* operator*() const { return static_cast<ActorType*>(GetCurrent()); }
    ActorType* operator->() const { return static_cast<ActorType*>(GetCurrent()); }
};

/** Iterates over all actors of a world. */
class FActorIterator : public FActorIteratorBase {
public:
    explicit FActorIterator(const UWorld* InWorld,
        EActorIteratorFlags InFlags = EActorIteratorFlags::OnlyActiveLevels | EActorIteratorFlags::SkipPendingKill)
        : FActorIteratorBase(InWorld, AActor::StaticClass(), InFlags) {}

    AActor* operator*() const { return GetCurrent(); }
    AActor* operator->() const { return GetCurrent(); }
};

/** Template class used to filter actors by class, for ranged for: `for (APawn* Pawn : TActorRange<APawn>(World))`. */
template <typename ActorType>
class TActorRange {
    struct FEnd {};
    struct FIterator {
        TActorIterator<ActorType> It;
        ActorType* operator*() const { return *It; }
        FIterator& operator++() {
            ++It;
            return *this;
        }
        bool operator!=(const FEnd&) const { return static_cast<bool>(It); }
    };

public:
    explicit TActorRange(const UWorld* InWorld, TSubclassOf<ActorType> InClass = ActorType::StaticClass(),
        EActorIteratorFlags InFlags = EActorIteratorFlags::OnlyActiveLevels | EActorIteratorFlags::SkipPendingKill)
        : World(InWorld), Class(InClass), Flags(InFlags) {}

    FIterator begin() const { return FIterator{TActorIterator<ActorType>(World, Class, Flags)}; }
    FEnd end() const { return FEnd{}; }

private:
    const UWorld* World;
    TSubclassOf<ActorType> Class;
    EActorIteratorFlags Flags;
};

/** Range over all actors of a world. */
using FActorRange = TActorRange<AActor>;
