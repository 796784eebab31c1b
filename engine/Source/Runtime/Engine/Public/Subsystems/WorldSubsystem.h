// SPDX-License-Identifier: MIT
/** @file Subsystems of worlds. Mirrors UE's Subsystems/WorldSubsystem.h. */
#pragma once

#include "CoreMinimal.h"
#include "Engine/EngineTypes.h"
#include "Subsystems/Subsystem.h"
#include "Tickable.h"

#include "WorldSubsystem.generated.h"

class UWorld;

/** Base class for auto instanced and initialized systems that share the lifetime of a UWorld. */
UCLASS(Abstract)
class ENGINE_API UWorldSubsystem : public USubsystem {
    GENERATED_BODY()

public:
    UWorldSubsystem();

    /** Returns a pointer to the UWorld that owns this, or null for the class default object. */
    virtual UWorld* GetWorld() const override final;
    /** Returns a reference to the UWorld that owns this; there must be one. */
    UWorld& GetWorldRef() const;

    /** Called once all UWorldSubsystems have been initialized. */
    virtual void PostInitialize() {}
    /** Called when world is ready to start gameplay before the game mode transitions to the correct state and call
     * BeginPlay on all actors. */
    virtual void OnWorldBeginPlay(UWorld& InWorld) {}
    /** Called after world components (e.g. line batcher and all level components) have been updated. */
    virtual void OnWorldComponentsUpdated(UWorld& World) {}
    /** Called when the world is about to be torn down, before Deinitialize. */
    virtual void PreDeinitialize() {}

    // USubsystem
    virtual bool ShouldCreateSubsystem(UObject* Outer) const override;

protected:
    /** Called when determining whether to create this Subsystem: game worlds by default. */
    virtual bool DoesSupportWorldType(const EWorldType::Type WorldType) const;
};

/** Base class for auto instanced and initialized systems that share the lifetime of a UWorld and are ticking along with
 * it. */
UCLASS(Abstract)
class ENGINE_API UTickableWorldSubsystem : public UWorldSubsystem, public FTickableGameObject {
    GENERATED_BODY()

public:
    UTickableWorldSubsystem();
    virtual ~UTickableWorldSubsystem();

    // FTickableGameObject
    virtual UWorld* GetTickableGameObjectWorld() const override;
    virtual ETickableTickType GetTickableTickType() const override;
    virtual bool IsAllowedToTick() const override final;
    virtual void Tick(float DeltaTime) override;
    virtual TStatId GetStatId() const override;

    // USubsystem; overrides must call these.
    virtual void Initialize(FSubsystemCollectionBase& Collection) override;
    virtual void Deinitialize() override;

    /** Returns true between Initialize and Deinitialize. */
    bool IsInitialized() const { return bInitialized; }

private:
    bool bInitialized;
};
