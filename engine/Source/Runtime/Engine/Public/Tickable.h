// SPDX-License-Identifier: MIT
/** @file Objects that tick without being actors or components. Mirrors UE's Tickable.h. */
#pragma once

#include "CoreMinimal.h"
#include "Engine/EngineBaseTypes.h"
#include "Stats/Stats.h"

class UWorld;

/** Enum to determine how a tickable object should be registered. */
enum class ETickableTickType : uint8 {
    /** Tick is never registered. */
    Never,
    /** Ticked while IsTickable returns true. */
    Conditional,
    /** Ticked always. */
    Always,
    /** A new tickable, to be resolved into one of the others. */
    NewObject,
};

/**
 * Base class for objects that the world (or the engine) ticks after all actors have ticked their normal groups.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/FTickableGameObject
 */
class ENGINE_API FTickableGameObject {
public:
    /** Registers. @param StartingTickType NewObject asks GetTickableTickType at the first tick. */
    explicit FTickableGameObject(ETickableTickType StartingTickType = ETickableTickType::NewObject);
    /** Unregisters. */
    virtual ~FTickableGameObject();

    /** Called each tick. @param DeltaTime seconds. */
    virtual void Tick(float DeltaTime) = 0;
    /** How this registers. */
    virtual ETickableTickType GetTickableTickType() const { return ETickableTickType::Conditional; }
    /** Whether this wants to tick now. */
    virtual bool IsTickable() const { return true; }
    /** Used to determine if an object is allowed to tick: false until it is initialised. */
    virtual bool IsAllowedToTick() const { return true; }
    /** Whether this ticks while the game is paused. */
    virtual bool IsTickableWhenPaused() const { return false; }
    /** The world that ticks this; null: ticked by the engine, outside of worlds. */
    virtual UWorld* GetTickableGameObjectWorld() const { return nullptr; }
    /** Return the stat id to use for this tickable. */
    virtual TStatId GetStatId() const = 0;

    /** Changes how this registers. */
    void SetTickableTickType(ETickableTickType NewTickType);

    /** Ticks all objects of a world. @param World null: those without a world. */
    static void TickObjects(UWorld* World, int32 LevelTickType, bool bIsGamePaused, float DeltaSeconds);

private:
    ETickableTickType TickType;
};
