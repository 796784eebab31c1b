// SPDX-License-Identifier: MIT
/** @file The engine. Mirrors UE's Engine/Engine.h. */
#pragma once

#include "Containers/IndirectArray.h"
#include "CoreMinimal.h"
#include "Engine/EngineBaseTypes.h"
#include "Engine/EngineTypes.h"
#include "Engine/World.h"
#include "Subsystems/EngineSubsystem.h"
#include "Subsystems/SubsystemCollection.h"
#include "Templates/SubclassOf.h"
#include "UObject/Object.h"
#include "UObject/ObjectMacros.h"

#include "Engine.generated.h"

class AGameModeBase;
class APlayerController;
class AWorldSettings;
class UEngine;
class UGameInstance;
class UGameViewportClient;
class ULocalPlayer;
class UPendingNetGame;

ENGINE_API DECLARE_LOG_CATEGORY_EXTERN(LogEngine, Log, All);
DECLARE_LOG_CATEGORY_EXTERN(LogLoad, Log, All);

/** Global engine pointer. Can be null in the very early stages of start-up. */
extern ENGINE_API UEngine* GEngine;

/** What to do when a world cannot be found from an object. */
enum class EGetWorldErrorMode {
    /** Silently returns null, the calling code is expected to handle this gracefully. */
    ReturnNull,
    /** Raises a runtime error but still returns null, the calling code is expected to handle this gracefully. */
    LogAndReturnNull,
    /** Asserts, the calling code is not expecting to handle a failure gracefully. */
    Assert,
};

/** What the engine loop offers to the engine. */
class IEngineLoop {
public:
    virtual ~IEngineLoop() = default;
    /** Initialises what comes after the modules. @return 0, or an exit code. */
    virtual int32 Init() = 0;
    /** Runs one frame. */
    virtual void Tick() = 0;
    /** Removes all references to objects that are being deferred. */
    virtual void ClearPendingCleanupObjects() = 0;
};

/**
 * A context for dealing with UWorlds at the engine level. As the engine brings up and destroys world, we need a way to
 * keep straight what world belongs to what.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/FWorldContext
 */
USTRUCT()
struct FWorldContext {
    GENERATED_BODY()

    /** What the world is used for. */
    TEnumAsByte<EWorldType::Type> WorldType = EWorldType::None;

    /** Name of this context: unique. */
    FName ContextHandle;

    /** URL to travel to for pending client connect: the next map, or empty. */
    FString TravelURL;

    /** TravelType for pending client connects. */
    uint8 TravelType = 0;

    /** URL the last time we traveled. */
    UPROPERTY()
    FURL LastURL;

    /** The viewport of the game. */
    UPROPERTY()
    TObjectPtr<UGameViewportClient> GameViewport;

    /** The game instance that owns this context. */
    UPROPERTY()
    TObjectPtr<UGameInstance> OwningGameInstance;

    /** Set CurrentWorld and update external reference pointers to reflect this. */
    ENGINE_API void SetCurrentWorld(UWorld* World);
    /** The world, or null. */
    UWorld* World() const { return ThisCurrentWorld; }

private:
    friend class UEngine;

    UPROPERTY()
    TObjectPtr<UWorld> ThisCurrentWorld;
};

/** Event type for when a world is added or destroyed. */
DECLARE_EVENT_OneParam(UEngine, FWorldAddedEvent, UWorld*);
DECLARE_EVENT_OneParam(UEngine, FWorldDestroyedEvent, UWorld*);
/** Delegate of actors added to or deleted from levels. */
DECLARE_EVENT_OneParam(UEngine, FLevelActorEvent, AActor*);

/** A message on the screen, or where the screen would be. Epic page: FScreenMessageString. */
struct FScreenMessageString {
    /** A message with the key of another replaces it. */
    uint64 Key = 0;
    /** The text. */
    FString ScreenMessage;
    /** Its colour. */
    FColor DisplayColor;
    /** Seconds of FApp's clock at which it goes. */
    double ExpireTime = 0.0;
};

/**
 * Abstract base class of all Engine classes, responsible for management of systems critical to editor or game systems.
 * Also defines default classes for certain engine systems.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/UEngine
 */
UCLASS(Abstract, config = Engine, Transient)
class ENGINE_API UEngine : public UObject {
    GENERATED_BODY()

public:
    UEngine(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());
    virtual ~UEngine();

    /** Class used for the local player. */
    UPROPERTY()
    TSubclassOf<ULocalPlayer> LocalPlayerClass;

    /** Class of the world settings. */
    UPROPERTY()
    TSubclassOf<AWorldSettings> WorldSettingsClass;

    /** Class of the game's viewport. */
    UPROPERTY()
    TSubclassOf<UGameViewportClient> GameViewportClientClass;

    /** Class of the game instance. */
    UPROPERTY()
    TSubclassOf<UGameInstance> GameInstanceClass;

    /** The game mode of maps that name none. */
    UPROPERTY()
    TSubclassOf<AGameModeBase> DefaultGameModeClass;

    /** The viewport of the game; there may be none. */
    UPROPERTY()
    TObjectPtr<UGameViewportClient> GameViewport;

    /** Colour of "lighting only" views. */
    UPROPERTY()
    FLinearColor LightingOnlyBrightness;

    /** When we last did a full garbage collection, in seconds of the engine's clock. */
    UPROPERTY(Transient)
    float TimeSinceLastPendingKillPurge;

    /** Initialize the game engine. @param InEngineLoop loop that drives this; may be null in tests. */
    virtual void Init(IEngineLoop* InEngineLoop);
    /** Start the game, separate from the initialize call to allow for post initialize configuration before the game
     * starts. */
    virtual void Start() {}
    /** Called at shutdown, just before the exit purge. */
    virtual void PreExit();
    /** Update everything: worlds, travel, garbage. @param DeltaSeconds real seconds since the last frame. @param
     * bIdleMode whether to do as little as possible. */
    virtual void Tick(float DeltaSeconds, bool bIdleMode) {}
    /** Whether the engine is initialised. */
    bool IsInitialized() const { return bIsInitialized; }

    // ---------------------------------------------------------------------------------------------------------------
    // time

    /** Updates the current time and delta time of FApp, sleeping as the maximum tick rate or the fixed step asks for.
     */
    virtual void UpdateTimeAndHandleMaxTickRate();
    /** Get tick rate limiter: of the console variable t.MaxFPS; 0 is no limit. */
    virtual float GetMaxTickRate(float DeltaTime, bool bAllowFrameRateSmoothing = true) const;
    /** Sets t.MaxFPS. */
    virtual void SetMaxFPS(const float MaxFPS);
    virtual float GetMaxFPS() const;

    // ------------------------------------------------------------------------------------------------------------
    // garbage

    /** Requests a one frame delay of garbage collection. */
    void DelayGarbageCollection();
    /** Updates the timer between garbage collection such that at the next opportunity garbage collection will be run.
     * @param bFullPurge whether to purge everything at once. */
    void ForceGarbageCollection(bool bFullPurge = false);
    /** Updates the timer (as a one-off) that is used to trigger garbage collection. */
    void SetTimeUntilNextGarbageCollection(float MinTimeUntilNextPass);
    /** Collect garbage once per frame driven by gc.TimeBetweenPurgingPendingKillObjects. */
    void ConditionalCollectGarbage();

    // -------------------------------------------------------------------------------------------------------------
    // worlds

    /** Creates a world context. */
    FWorldContext& CreateNewWorldContext(EWorldType::Type WorldType);
    /** Finds the world context of a world, or null. */
    FWorldContext* GetWorldContextFromWorld(const UWorld* InWorld);
    const FWorldContext* GetWorldContextFromWorld(const UWorld* InWorld) const;
    FWorldContext& GetWorldContextFromWorldChecked(const UWorld* InWorld);
    FWorldContext* GetWorldContextFromHandle(const FName WorldContextHandle);
    FWorldContext* GetWorldContextFromGameViewport(const UGameViewportClient* InViewport);
    /** All world contexts. */
    const TIndirectArray<FWorldContext>& GetWorldContexts() const { return WorldList; }
    /** Removes the world from its context; destroys the context if no game needs it. */
    void DestroyWorldContext(UWorld* InWorld);
    /** The world of an object, e.g. of the WorldContextObject parameter of a reflected function. */
    UWorld* GetWorldFromContextObject(const UObject* Object, EGetWorldErrorMode ErrorMode) const;
    UWorld* GetWorldFromContextObjectChecked(const UObject* Object) const {
        return GetWorldFromContextObject(Object, EGetWorldErrorMode::Assert);
    }
    /** The world that is current in the game, or null. */
    UWorld* GetCurrentPlayWorld(UWorld* PossiblePlayWorld = nullptr) const;

    /** Needs to be called when a world is added to broadcast messages. */
    virtual void WorldAdded(UWorld* World);
    /** Needs to be called when a world is destroyed to broadcast messages. */
    virtual void WorldDestroyed(UWorld* InWorld);
    FWorldAddedEvent& OnWorldAdded() { return WorldAddedEvent; }
    FWorldDestroyedEvent& OnWorldDestroyed() { return WorldDestroyedEvent; }
    /** Broadcast for each actor added to a level, and deleted from it. */
    FLevelActorEvent& OnLevelActorAdded() { return LevelActorAddedEvent; }
    FLevelActorEvent& OnLevelActorDeleted() { return LevelActorDeletedEvent; }
    void BroadcastLevelActorAdded(AActor* InActor) { LevelActorAddedEvent.Broadcast(InActor); }
    void BroadcastLevelActorDeleted(AActor* InActor) { LevelActorDeletedEvent.Broadcast(InActor); }

    // -------------------------------------------------------------------------------------------------------------
    // travel

    /**
     * Loads a map: tears down the old world of the context, makes a new one, loads the scene, starts play.
     *
     * Map names: a scene name ("apartment"), the path of its world ("/Game/Scenes/apartment" or
     * "/Game/Scenes/apartment.apartment"), a glTF file, or "/Engine/Maps/Entry" (an empty world). A map that cannot be
     * found leaves the old world running; a scene that cannot be read leaves an empty world.
     *
     * @param Pending must be null: there is no network.
     * @param Error why not.
     */
    virtual bool LoadMap(FWorldContext& WorldContext, FURL URL, UPendingNetGame* Pending, FString& Error);
    /** Loads the map of a URL. @return whether it worked. */
    virtual bool Browse(FWorldContext& WorldContext, FURL URL, FString& Error);
    /** Travels at the end of the frame. @param NextURL as in LoadMap, with options. */
    void SetClientTravel(UWorld* InWorld, const TCHAR* NextURL, ETravelType InTravelType);
    /** Does the travel that is pending. */
    virtual void TickWorldTravel(FWorldContext& WorldContext, float DeltaSeconds);

    // ------------------------------------------------------------------------------------------------------------
    // players

    /** Returns the first local player of the game of the world, or null. */
    ULocalPlayer* GetFirstGamePlayer(UWorld* InWorld);
    ULocalPlayer* GetFirstGamePlayer(const UGameViewportClient* InViewport);
    ULocalPlayer* GetLocalPlayerFromControllerId(const UWorld* InWorld, const int32 ControllerId) const;
    TArray<ULocalPlayer*> GetGamePlayers(const UWorld* World) const;
    ULocalPlayer* GetGamePlayer(const UWorld* InWorld, int32 InPlayer);
    int32 GetNumGamePlayers(UWorld* InWorld);
    APlayerController* GetFirstLocalPlayerController(const UWorld* InWorld);
    /** The game instance of the engine, or null. */
    virtual UGameInstance* GetGameInstance() const { return nullptr; }

    // -----------------------------------------------------------------------------------------------------------
    // commands

    /**
     * Executes a console command: `slomo RATE`, `pause`, `open MAP`, `restartlevel`, `exit`/`quit`, `obj list
     * [class=CLASS]`, `obj gc`, `stat actors`, the name of a console variable (alone: shows it; with a value: sets it),
     * or a registered console command.
     * @return whether it was known.
     */
    virtual bool Exec(UWorld* InWorld, const TCHAR* Cmd, FOutputDevice& Ar = *GLog);
    /** Executes a command at the end of this frame. */
    void DeferCommand(const FString& Cmd) { DeferredCommands.Add(Cmd); }
    /** Executes the deferred commands. */
    void TickDeferredCommands();

    // ---------------------------------------------------------------------------------------------------------
    // subsystems

    /** Get an Engine Subsystem of specified type. */
    UEngineSubsystem* GetEngineSubsystemBase(TSubclassOf<UEngineSubsystem> SubsystemClass) const;
    template <typename TSubsystemClass>
    TSubsystemClass* GetEngineSubsystem() const {
        return EngineSubsystemCollection.GetSubsystem<TSubsystemClass>(TSubsystemClass::StaticClass());
    }
    /** Get all Engine Subsystems of specified type. */
    template <typename TSubsystemClass>
    TArray<TSubsystemClass*> GetEngineSubsystemArrayCopy() const {
        return EngineSubsystemCollection.GetSubsystemArrayCopy<TSubsystemClass>(TSubsystemClass::StaticClass());
    }

    static void AddReferencedObjects(UObject* InThis, FReferenceCollector& Collector);

    // ------------------------------------------------------------------------------------------------------ messages

    /**
     * Adds a message to the list of those on the screen.
     * @param Key messages with the same key replace each other; uint64(-1) is a message of its own.
     * @param TimeToDisplay how long to show it, in seconds.
     */
    void AddOnScreenDebugMessage(uint64 Key, float TimeToDisplay, FColor DisplayColor, const FString& DebugMessage);
    /** Whether a message with that key is on the screen. */
    bool OnScreenDebugMessageExists(uint64 Key);
    /** Removes all messages. */
    void ClearOnScreenDebugMessages();
    /** The messages that have not expired, in the order they were added. */
    const TArray<FScreenMessageString>& GetOnScreenDebugMessages();

protected:
    /** Ticks a world of the given context and what belongs to it. */
    void TickWorldContext(FWorldContext& Context, float DeltaSeconds);
    bool HandleObjCommand(const TCHAR* Cmd, FOutputDevice& Ar);

    TIndirectArray<FWorldContext> WorldList;
    int32 NextWorldContextHandle;
    bool bIsInitialized;

private:
    FObjectSubsystemCollection<UEngineSubsystem> EngineSubsystemCollection;
    FWorldAddedEvent WorldAddedEvent;
    FWorldDestroyedEvent WorldDestroyedEvent;
    FLevelActorEvent LevelActorAddedEvent;
    FLevelActorEvent LevelActorDeletedEvent;
    TArray<FString> DeferredCommands;
    TArray<FScreenMessageString> ScreenMessages;
    FDelegateHandle ModulesChangedHandle;
    bool bFullPurgeTriggered;
    bool bShouldDelayGarbageCollect;
    double LastTickTime;
};
