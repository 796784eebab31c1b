// SPDX-License-Identifier: MIT
/** @file Base of all subsystems. Mirrors UE's Subsystems/Subsystem.h. */
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"
#include "UObject/ObjectMacros.h"

#include "Subsystem.generated.h"

class FSubsystemCollectionBase;

/**
 * Subsystems are auto instanced classes that share the lifetime of certain engine constructs: the engine, the game
 * instance, a world, a local player. One instance is made of every class that is not abstract and whose
 * ShouldCreateSubsystem returns true.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Subsystems/USubsystem
 */
UCLASS(Abstract)
class ENGINE_API USubsystem : public UObject {
    GENERATED_BODY()

public:
    USubsystem();

    /** Override to control if the Subsystem should be created at all. Called on the class default object. @param Outer
     * what the subsystem would belong to. */
    virtual bool ShouldCreateSubsystem(UObject* Outer) const { return true; }
    /** Implement this for initialization of instances of the system. @param Collection allows to initialize
     * dependencies first. */
    virtual void Initialize(FSubsystemCollectionBase& Collection) {}
    /** Implement this for deinitialization of instances of the system. */
    virtual void Deinitialize() {}

private:
    friend class FSubsystemCollectionBase;
    FSubsystemCollectionBase* InternalOwningSubsystem;
};

/**
 * Dynamic subsystems auto populate/depopulate existing collections when modules are loaded (and only the engine's
 * collection is dynamic here).
 */
UCLASS(Abstract)
class ENGINE_API UDynamicSubsystem : public USubsystem {
    GENERATED_BODY()

public:
    UDynamicSubsystem();
};
