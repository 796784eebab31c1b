// SPDX-License-Identifier: MIT
/** @file Levels. Mirrors UE's Engine/Level.h. */
#pragma once

#include "CoreMinimal.h"
#include "Engine/EngineBaseTypes.h"
#include "UObject/Object.h"
#include "UObject/ObjectMacros.h"

#include "Level.generated.h"

class AActor;
class AWorldSettings;
class ULevel;
class UWorld;

/**
 * A Level is a collection of Actors. The actors of a world live in its persistent level: that is their outer, so that
 * their path reads
 * "/Game/Scenes/apartment.apartment:PersistentLevel.Chair_1".
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/ULevel
 */
UCLASS()
class ENGINE_API ULevel : public UObject {
    GENERATED_BODY()

public:
    ULevel(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Array of all actors in this level, in the order of spawning. Entries are null where an actor was destroyed in
     * this frame. */
    TArray<TObjectPtr<AActor>> Actors;

    /** The World that has this level in its Levels array. */
    UPROPERTY(Transient)
    TObjectPtr<UWorld> OwningWorld;

    /** Whether the level is currently visible/ associated with the world. */
    UPROPERTY()
    uint8 bIsVisible : 1;

    /** The world settings of this level. @param bChecked true asserts that there are any. */
    AWorldSettings* GetWorldSettings(bool bChecked = true) const;
    /** Sets the world settings. */
    void SetWorldSettings(AWorldSettings* NewWorldSettings);

    /** Whether this is the persistent level of its world. */
    bool IsPersistentLevel() const;
    /** Whether this is the level that new actors are put into. */
    bool IsCurrentLevel() const;

    /** Called to remove null entries of destroyed actors, keeping the order. */
    void CompactActors();

    // UObject
    virtual UWorld* GetWorld() const override final;
    static void AddReferencedObjects(UObject* InThis, FReferenceCollector& Collector);

private:
    /** Actor that holds the settings of the level. */
    UPROPERTY()
    TObjectPtr<AWorldSettings> WorldSettings;
};
