// SPDX-License-Identifier: MIT
/** @file Settings of a world. Mirrors UE's GameFramework/WorldSettings.h. */
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Info.h"
#include "Templates/SubclassOf.h"
#include "UObject/ObjectMacros.h"

#include "WorldSettings.generated.h"

class AGameModeBase;
class APlayerState;

/**
 * Actor containing all script accessible world properties.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/AWorldSettings
 */
UCLASS(config = game,
    HideCategories = (Actor, Advanced, Display, Events, Object, Attachment, Info, Input, Blueprint, Layers, Tags,
        Replication),
    NotPlaceable)
class ENGINE_API AWorldSettings : public AInfo {
    GENERATED_BODY()

public:
    AWorldSettings(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** If true, GlobalGravityZ is used; otherwise the default gravity, -980 cm/s^2. */
    UPROPERTY(EditAnywhere, Category = Physics, meta = (DisplayName = "Override World Gravity"))
    uint8 bGlobalGravitySet : 1;

    /** If true, enables KillZ checks: actors that fall below it are destroyed. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = World, meta = (DisplayName = "Enable World Bounds Checks"))
    uint8 bEnableWorldBoundsChecks : 1;

    /** If true, WorldGravityZ has been set and is used as it is. */
    UPROPERTY(Transient)
    uint8 bWorldGravitySet : 1;

    /** Any actor falling below this level gets destroyed, in centimetres. Checked for actors that move by a movement
     * component. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = World, meta = (EditCondition = "bEnableWorldBoundsChecks"))
    float KillZ;

    /** Current gravity actually being used, in centimetres per second squared, see GetGravityZ. */
    UPROPERTY(Transient)
    float WorldGravityZ;

    /** Level specific gravity value used if bGlobalGravitySet, in centimetres per second squared. */
    UPROPERTY(EditAnywhere, Category = Physics,
        meta = (EditCondition = "bGlobalGravitySet", DisplayName = "Global Gravity Z"))
    float GlobalGravityZ;

    /** The default GameMode to use when starting this map in the game. If this value is NULL, the INI setting for
     * default game type is used. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = GameMode, meta = (DisplayName = "GameMode Override"))
    TSubclassOf<AGameModeBase> DefaultGameMode;

    /** Normally 1 - scales real time passage. Warning - most use cases should use GetEffectiveTimeDilation() instead of
     * reading from this directly. */
    UPROPERTY(Transient)
    float TimeDilation;

    /** Additional TimeDilation used to control demo playback speed. */
    UPROPERTY(Transient)
    float CinematicTimeDilation;

    /** Lowest acceptable global time dilation. */
    UPROPERTY(config, EditAnywhere, Category = Tick, AdvancedDisplay, meta = (UIMin = "0", ClampMin = "0"))
    float MinGlobalTimeDilation;

    /** Highest acceptable global time dilation. */
    UPROPERTY(config, EditAnywhere, Category = Tick, AdvancedDisplay, meta = (UIMin = "0", ClampMin = "0"))
    float MaxGlobalTimeDilation;

    /** Smallest possible frametime, not considering dilation. Equiv to 1/FastestFPS. Seconds. */
    UPROPERTY(config, EditAnywhere, Category = Tick, AdvancedDisplay, meta = (UIMin = "0", ClampMin = "0"))
    float MinUndilatedFrameTime;

    /** Largest possible frametime, not considering dilation. Equiv to 1/SlowestFPS. Seconds. */
    UPROPERTY(config, EditAnywhere, Category = Tick, AdvancedDisplay, meta = (UIMin = "0", ClampMin = "0"))
    float MaxUndilatedFrameTime;

    /** The gravity of this world on the Z axis, in centimetres per second squared. */
    virtual float GetGravityZ() const;

    /** Real seconds to game seconds: TimeDilation * CinematicTimeDilation. */
    float GetEffectiveTimeDilation() const { return TimeDilation * CinematicTimeDilation; }

    /** Sets the global time dilation, clamped to [MinGlobalTimeDilation, MaxGlobalTimeDilation]. @return the value that
     * was set. */
    virtual float SetTimeDilation(float NewTimeDilation);

    /** Returns the delta time to be used by the tick. Can be overridden if game specific logic is needed. */
    virtual float FixupDeltaSeconds(float DeltaSeconds, float RealDeltaSeconds);

    /** Returns the player that pauses the world, or null if it is not paused. */
    virtual APlayerState* GetPauserPlayerState() const { return PauserPlayerState; }
    /** Pauses the world (non-null) or unpauses it (null). */
    virtual void SetPauserPlayerState(APlayerState* PlayerState);

    /** Called from GameStateBase: starts play of all actors of the level. */
    virtual void NotifyBeginPlay();
    /** Called from GameStateBase, used to notify native classes of match startup (such as level scripting). */
    virtual void NotifyMatchStarted() {}

    // AActor
    virtual void PreInitializeComponents() override;

private:
    /** If paused, PlayerState of person pausing the game. */
    UPROPERTY(Transient)
    TObjectPtr<APlayerState> PauserPlayerState;
};
