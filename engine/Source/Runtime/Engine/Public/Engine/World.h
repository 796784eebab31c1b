// SPDX-License-Identifier: MIT
/** @file The world. Mirrors UE's Engine/World.h. */
#pragma once

#include "Containers/Map.h"
#include "CoreMinimal.h"
#include "Engine/EngineBaseTypes.h"
#include "Engine/EngineTypes.h"
#include "Engine/LatentActionManager.h"
#include "GameFramework/Actor.h"
#include "Subsystems/SubsystemCollection.h"
#include "Subsystems/WorldSubsystem.h"
#include "Templates/SubclassOf.h"
#include "Templates/UniquePtr.h"
#include "UObject/Object.h"
#include "UObject/ObjectMacros.h"
#include "UObject/WeakObjectPtrTemplates.h"

#include "World.generated.h"

class AController;
class AGameModeBase;
class AGameStateBase;
class APawn;
class APlayerController;
class AWorldSettings;
class FTickTaskManager;
class FTimerManager;
class UGameInstance;
class ULevel;
class ULocalPlayer;
class UWorld;
struct FActorsInitializedParams;
struct FWorldContext;

DECLARE_LOG_CATEGORY_EXTERN(LogWorld, Log, All);
DECLARE_LOG_CATEGORY_EXTERN(LogSpawn, Log, All);

/** Proxy class that allows verification on GWorld accesses. */
class UWorldProxy {
public:
    UWorldProxy() : World(nullptr) {}

    UWorld* operator->() const { return World; }
    const UWorld& operator*() const { return *World; }
    UWorldProxy& operator=(UWorld* InWorld) {
        World = InWorld;
        return *this;
    }
    operator UWorld*() const { return World; }
    UWorld* GetReference() const { return World; }

private:
    UWorld* World;
};

/** Global pointer to the world that is current. Prefer an object's own GetWorld(). */
extern ENGINE_API UWorldProxy GWorld;

/** Determines how the name of FActorSpawnParameters is used if it is taken. */
enum class ESpawnActorNameMode : uint8 {
    /** Fatal if unavailable, application will assert. */
    Required_Fatal,
    /** Report an error return null if unavailable. */
    Required_ErrorAndReturnNull,
    /** Return null if unavailable. */
    Required_ReturnNull,
    /** If the supplied Name is already in use the generate an unused one using the supplied version as a base. */
    Requested,
};

/**
 * Struct of optional parameters passed to SpawnActor function(s).
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/FActorSpawnParameters
 */
struct ENGINE_API FActorSpawnParameters {
    FActorSpawnParameters();

    /** A name to assign as the Name of the Actor being spawned. If no value is specified, the name of the spawned Actor
     * will be automatically generated using the form [Class]_[Number]. */
    FName Name;
    /** An Actor to use as a template when spawning the new Actor. The spawned Actor will be initialized using the
     * property values of the template Actor. If left NULL the class default object (CDO) will be used to initialize the
     * spawned Actor. */
    AActor* Template;
    /** The Actor that spawned this Actor. (Can be left as NULL). */
    AActor* Owner;
    /** The APawn that is responsible for damage done by the spawned Actor. (Can be left as NULL). */
    APawn* Instigator;
    /** The ULevel to spawn the Actor in, i.e. the Outer of the Actor. If left as NULL the Outer of the Owner is used.
     * If the Owner is NULL the persistent level is used. */
    ULevel* OverrideLevel;
    /** Method for resolving collisions at the spawn point. Undefined means no override, use the actor's setting.
     * Nothing collides in a world without physics, so that the actor is always spawned. */
    ESpawnActorCollisionHandlingMethod SpawnCollisionHandlingOverride;
    /** Determines whether to multiply or override root component with provided spawn transform. */
    ESpawnActorScaleMethod TransformScaleMethod = ESpawnActorScaleMethod::MultiplyWithRoot;
    /** If true, an actor that destroys itself while it is spawned is returned nevertheless. */
    uint8 bNoFail : 1;
    /** Determines whether the construction script will be run. If true, the construction script will not be run on the
     * spawned Actor: call FinishSpawning. */
    uint8 bDeferConstruction : 1;
    /** Whether the actor may be spawned while a construction script is running; else that fails. */
    uint8 bAllowDuringConstructionScript : 1;
    /** In which way should SpawnActor should treat the supplied Name if not none. */
    ESpawnActorNameMode NameMode;
    /** Flags used to describe the spawned actor/object instance. */
    EObjectFlags ObjectFlags;
    /** Custom function allowing the caller to specify a function to execute post actor construction but before other
     * systems see this actor spawn. */
    TFunction<void(AActor*)> CustomPreSpawnInitalization;
};

/** Type of the delegate of UWorld::AddOnActorSpawnedHandler. */
DECLARE_MULTICAST_DELEGATE_OneParam(FOnActorSpawned, AActor*);
/** Type of the delegate of UWorld::AddOnActorDestroyedHandler. */
DECLARE_MULTICAST_DELEGATE_OneParam(FOnActorDestroyed, AActor*);

using FConstControllerIterator = TArray<TWeakObjectPtr<AController>>::TConstIterator;
using FConstPlayerControllerIterator = TArray<TWeakObjectPtr<APlayerController>>::TConstIterator;

/**
 * The World is the top level object representing a map or a sandbox in which Actors and Components will exist and be
 * rendered.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/UWorld
 */
UCLASS(config = Engine)
class ENGINE_API UWorld final : public UObject {
    GENERATED_BODY()

public:
    UWorld(const FObjectInitializer& ObjectInitializer);
    virtual ~UWorld();

    /** Struct containing a collection of optional parameters for initialization of a World. */
    struct InitializationValues {
        InitializationValues() = default;

        /** The default game mode for this world (if any). */
        TSubclassOf<AGameModeBase> DefaultGameMode;

        InitializationValues& SetDefaultGameMode(TSubclassOf<AGameModeBase> GameMode) {
            DefaultGameMode = GameMode;
            return *this;
        }
    };

    // -------------------------------------------------------------------------------------------------------
    // properties

    /** Persistent level containing the world info, default brush and actors spawned during gameplay among other things.
     */
    UPROPERTY(Transient)
    TObjectPtr<ULevel> PersistentLevel;

    /** The URL that was used when loading this World. */
    FURL URL;

    /** The type of world this is. Describes the context in which it is being used (Editor, Game, Preview etc.). */
    TEnumAsByte<EWorldType::Type> WorldType;

    /** Time in seconds since level began play, but IS paused when the game is paused, and IS dilated/clamped. */
    double TimeSeconds;
    /** Time in seconds since level began play, but IS NOT paused when the game is paused, and IS dilated/clamped. */
    double UnpausedTimeSeconds;
    /** Time in seconds since level began play, but IS NOT paused when the game is paused, and IS NOT dilated/clamped.
     */
    double RealTimeSeconds;
    /** Frame delta time in seconds adjusted by e.g. time dilation. */
    float DeltaTimeSeconds;
    /** Frame delta time in seconds NOT adjusted by time dilation or clamps. */
    float DeltaRealTimeSeconds;
    /** Time at which to start pausing. */
    double PauseDelay;

    /** Whether the world object has been initialized via Init(). */
    uint8 bIsWorldInitialized : 1;
    /** Is the world in the middle of a tick. */
    uint8 bInTick : 1;
    /** Whether actors have been initialized for play. */
    uint8 bActorsInitialized : 1;
    /** Indicates this world is being torn down. */
    uint8 bIsTearingDown : 1;
    /** Whether the match has been started. */
    uint8 bMatchStarted : 1;
    /** Whether we are in the middle of running a construction script. */
    uint8 bIsRunningConstructionScript : 1;
    /** The group in which the world ticks now; TG_NewlySpawned outside of ticks. */
    TEnumAsByte<ETickingGroup> TickGroup;

    /** Called at the beginning of play, after all actors began to play. */
    DECLARE_EVENT(UWorld, FOnWorldBeginPlay);
    FOnWorldBeginPlay OnWorldBeginPlay;

    /** Called each time the world begins to tear down. */
    DECLARE_EVENT_OneParam(UWorld, FOnBeginTearingDownEvent, UWorld*);
    FOnBeginTearingDownEvent& OnBeginTearingDown() { return BeginTearingDownEvent; }

    // -----------------------------------------------------------------------------------------------------------
    // making

    /**
     * Static function that creates a new UWorld and returns a pointer to it.
     * @param InWorldType what it is for.
     * @param bInformEngineOfWorld whether to tell GEngine about it.
     * @param WorldName its name; NAME_None: "Untitled".
     * @param InWorldPackage its package; null: a new one.
     * @param bAddToRoot whether to keep it alive until DestroyWorld.
     * @param InIVS how to initialise it.
     * @param bInSkipInitWorld leaves InitWorld to the caller.
     */
    static UWorld* CreateWorld(const EWorldType::Type InWorldType, bool bInformEngineOfWorld,
        FName WorldName = NAME_None, UPackage* InWorldPackage = nullptr, bool bAddToRoot = true,
        const InitializationValues* InIVS = nullptr, bool bInSkipInitWorld = false);
    /** Makes the persistent level and its settings, subsystems, and broadcasts OnPreWorldInitialization and
     * OnPostWorldInitialization. */
    void InitWorld(const InitializationValues IVS = InitializationValues());
    /** Destroys this world: ends play, cleans up, and removes it from the root. @param bInformEngineOfWorld whether to
     * tell GEngine. */
    void DestroyWorld(bool bInformEngineOfWorld, UWorld* NewWorld = nullptr);
    /** Ends play of all actors with the given reason and deinitialises the subsystems. Broadcasts OnWorldCleanup.
     * @param bSessionEnded whether to notify the viewport that the game session has ended. */
    void CleanupWorld(bool bSessionEnded = true, bool bCleanupResources = true, UWorld* NewWorld = nullptr);
    /** Marks the world as being torn down and broadcasts OnWorldBeginTearDown. */
    void BeginTearingDown();
    /** Ends play of all actors. */
    void EndPlay(const EEndPlayReason::Type EndPlayReason);

    /** Sets the game mode from the URL, the world settings or the default. @return whether there is one. */
    bool SetGameMode(const FURL& InURL);
    /** Initializes all actors and prepares them to start gameplay. @param InURL commandline URL. @param bResetTime
     * whether the WorldSettings' TimeSeconds should be reset to zero. */
    void InitializeActorsForPlay(const FURL& InURL, bool bResetTime = true);
    /** Starts gameplay. This will cause the game mode to transition to the correct state and call BeginPlay on all
     * actors. */
    void BeginPlay();
    /** Returns true if gameplay has already started, false otherwise. */
    bool HasBegunPlay() const;
    /** Called by the game mode: play has begun, or not. */
    void SetBegunPlay(bool bHasBegunPlay);
    /** Returns true if actors have been initialized for gameplay. */
    bool AreActorsInitialized() const { return bActorsInitialized && PersistentLevel; }
    /** Returns true if the world is in the middle of being torn down. */
    bool IsBeingCleanedUp() const { return bIsTearingDown; }
    /** Returns whether this world is initialised. */
    bool IsInitialized() const { return bIsWorldInitialized; }

    // -------------------------------------------------------------------------------------------------------------
    // kind

    /** Returns true if this world is any kind of game world (including PIE worlds). */
    bool IsGameWorld() const;
    /** Returns true if this world is any kind of editor world (including editor preview worlds). */
    bool IsEditorWorld() const;
    /** Returns true if this world is a preview game world (editor or game). */
    bool IsPreviewWorld() const;
    /** Returns true if this world is a Play In Editor world. */
    bool IsPlayInEditor() const { return WorldType == EWorldType::PIE; }
    /** Returns the net mode this world is running under: NM_Standalone. */
    ENetMode GetNetMode() const { return NM_Standalone; }
    /** Whether the network mode is that one. */
    bool IsNetMode(ENetMode Mode) const { return GetNetMode() == Mode; }
    /** The name of the map: that of this world's package. */
    const FString GetMapName() const;

    // -------------------------------------------------------------------------------------------------------------
    // spawn

    /**
     * Spawn Actors with given transform and SpawnParameters.
     * @param InClass class to spawn; must derive from AActor and not be abstract.
     * @param Location location to spawn at, null: the origin.
     * @param Rotation rotation to spawn with, null: none.
     * @param SpawnParameters spawn parameters.
     * @return actor that just spawned, or null, with the reason in the log (category LogSpawn).
     */
    AActor* SpawnActor(UClass* InClass, FVector const* Location = nullptr, FRotator const* Rotation = nullptr,
        const FActorSpawnParameters& SpawnParameters = FActorSpawnParameters());
    AActor* SpawnActor(UClass* Class, FTransform const* Transform,
        const FActorSpawnParameters& SpawnParameters = FActorSpawnParameters());
    /** Spawn Actors with given absolute transform (override root component transform) and SpawnParameters. */
    AActor* SpawnActorAbsolute(UClass* Class, FTransform const& AbsoluteTransform,
        const FActorSpawnParameters& SpawnParameters = FActorSpawnParameters());

    /** Templated version of SpawnActor that allows you to specify a class type via the template type. */
    template <class T>
    T* SpawnActor(const FActorSpawnParameters& SpawnParameters = FActorSpawnParameters()) {
        return Cast<T>(SpawnActor(T::StaticClass(), nullptr, nullptr, SpawnParameters));
    }
    template <class T>
    T* SpawnActor(FVector const& Location, FRotator const& Rotation,
        const FActorSpawnParameters& SpawnParameters = FActorSpawnParameters()) {
        return Cast<T>(SpawnActor(T::StaticClass(), &Location, &Rotation, SpawnParameters));
    }
    /** Class may be derived from T. */
    template <class T>
    T* SpawnActor(UClass* Class, const FActorSpawnParameters& SpawnParameters = FActorSpawnParameters()) {
        return Cast<T>(SpawnActor(Class, nullptr, nullptr, SpawnParameters));
    }
    template <class T>
    T* SpawnActor(UClass* Class, FVector const& Location, FRotator const& Rotation,
        const FActorSpawnParameters& SpawnParameters = FActorSpawnParameters()) {
        return Cast<T>(SpawnActor(Class, &Location, &Rotation, SpawnParameters));
    }
    template <class T>
    T* SpawnActor(UClass* Class, FTransform const& Transform,
        const FActorSpawnParameters& SpawnParameters = FActorSpawnParameters()) {
        return Cast<T>(SpawnActor(Class, &Transform, SpawnParameters));
    }
    template <class T>
    T* SpawnActorAbsolute(UClass* Class, FTransform const& AbsoluteTransform,
        const FActorSpawnParameters& SpawnParameters = FActorSpawnParameters()) {
        return Cast<T>(SpawnActorAbsolute(Class, AbsoluteTransform, SpawnParameters));
    }
    /** Spawns an actor whose construction the caller completes by FinishSpawning. */
    template <class T>
    T* SpawnActorDeferred(UClass* Class, FTransform const& Transform, AActor* Owner = nullptr,
        APawn* Instigator = nullptr,
        ESpawnActorCollisionHandlingMethod CollisionHandlingOverride = ESpawnActorCollisionHandlingMethod::Undefined,
        ESpawnActorScaleMethod TransformScaleMethod = ESpawnActorScaleMethod::MultiplyWithRoot) {
        if (Owner) {
            check(this == Owner->GetWorld());
        }
        FActorSpawnParameters SpawnInfo;
        SpawnInfo.SpawnCollisionHandlingOverride = CollisionHandlingOverride;
        SpawnInfo.TransformScaleMethod = TransformScaleMethod;
        SpawnInfo.Owner = Owner;
        SpawnInfo.Instigator = Instigator;
        SpawnInfo.bDeferConstruction = true;
        return Cast<T>(SpawnActor(Class, &Transform, SpawnInfo));
    }

    /**
     * Removes the actor from its level's actor list and generally cleans up the engine's internal state. The object
     * lingers until the garbage is collected.
     * @param Actor actor to remove.
     * @param bNetForce not used without network.
     * @param bShouldModifyLevel not used outside of an editor.
     * @return true if destroyed or already marked for destruction, false if actor can't be destroyed.
     */
    bool DestroyActor(AActor* Actor, bool bNetForce = false, bool bShouldModifyLevel = true);
    /** Removes the actor from its level's list without any notification. */
    void RemoveActor(AActor* Actor, bool bShouldModifyLevel) const;

    /** Adds a listener to spawned actors: called when the spawn is complete. */
    FDelegateHandle AddOnActorSpawnedHandler(const FOnActorSpawned::FDelegate& InHandler) const;
    void RemoveOnActorSpawnedHandler(FDelegateHandle InHandle) const;
    /** Adds a listener to actors as they are about to be initialised after their construction. */
    FDelegateHandle AddOnActorPreSpawnInitialization(const FOnActorSpawned::FDelegate& InHandler) const;
    void RemoveOnActorPreSpawnInitialization(FDelegateHandle InHandle) const;
    /** Adds a listener to destroyed actors. */
    FDelegateHandle AddOnActorDestroyedHandler(const FOnActorDestroyed::FDelegate& InHandler) const;
    void RemoveOnActorDestroyedHandler(FDelegateHandle InHandle) const;

    // --------------------------------------------------------------------------------------------------------------
    // tick

    /**
     * Update the level after a variable amount of time, DeltaSeconds, has passed. All child actors are ticked after
     * their owners have been ticked.
     * @param TickType what to tick.
     * @param DeltaSeconds real time in seconds since the last tick.
     */
    void Tick(ELevelTick TickType, float DeltaSeconds);
    /** Returns true if the world is paused: its settings have a pauser. */
    bool IsPaused() const;
    /** Sends what components marked dirty to the renderer. Called at the end of each tick. */
    void SendAllEndOfFrameUpdates();
    /** Marks a component for SendAllEndOfFrameUpdates. */
    void MarkActorComponentForNeededEndOfFrameUpdate(UActorComponent* Component);
    /** Forgets a component, which unregisters. */
    void ClearActorComponentEndOfFrameUpdate(UActorComponent* Component);

    /** Returns time in seconds since world was brought up for play, IS stopped when game pauses, IS dilated/clamped. */
    double GetTimeSeconds() const { return TimeSeconds; }
    /** Returns time in seconds since world was brought up for play, IS NOT stopped when game pauses, IS
     * dilated/clamped. */
    double GetUnpausedTimeSeconds() const { return UnpausedTimeSeconds; }
    /** Returns time in seconds since world was brought up for play, does NOT stop when game pauses, NOT
     * dilated/clamped. */
    double GetRealTimeSeconds() const { return RealTimeSeconds; }
    /** Returns the frame delta time in seconds adjusted by e.g. time dilation. */
    float GetDeltaSeconds() const { return DeltaTimeSeconds; }
    /** Returns the dilation-free delta time of the frame in seconds. */
    float GetDeltaRealTimeSeconds() const { return DeltaRealTimeSeconds; }
    /** Helper for getting the time since a certain time. */
    double TimeSince(double Time) const { return GetTimeSeconds() - Time; }

    // ------------------------------------------------------------------------------------------------- levels,
    // collections

    /** Returns the current level, which new actors are put into. */
    ULevel* GetCurrentLevel() const;
    /** Sets the current level. @return whether it changed. */
    bool SetCurrentLevel(ULevel* InLevel);
    /** Return an array of all the levels in this world. */
    const TArray<TObjectPtr<ULevel>>& GetLevels() const { return Levels; }
    ULevel* GetLevel(int32 InLevelIndex) const { return Levels[InLevelIndex]; }
    int32 GetNumLevels() const { return Levels.Num(); }
    /** Returns the number of actors currently in this world, destroyed ones excluded. */
    int32 GetActorCount() const;

    /** Returns the AWorldSettings actor associated with this world. */
    UFUNCTION(BlueprintCallable, Category = "World",
        meta = (DisplayName = "Get World Settings", ScriptName = "GetWorldSettings"))
    AWorldSettings* K2_GetWorldSettings();
    /** Returns the AWorldSettings actor associated with this world. */
    AWorldSettings* GetWorldSettings(bool bCheckStreamingPersistent = false, bool bChecked = true) const;
    /** Gravity on the Z axis, in centimetres per second squared. */
    float GetGravityZ() const;
    /** Gravity of worlds that do not set their own, in centimetres per second squared. */
    float GetDefaultGravityZ() const;

    // ------------------------------------------------------------------------------------------------ game mode,
    // players

    /** Returns the current Game Mode instance, which is always valid during gameplay on the server. */
    AGameModeBase* GetAuthGameMode() const { return AuthorityGameMode; }
    template <class T>
    T* GetAuthGameMode() const {
        return Cast<T>(AuthorityGameMode);
    }
    /** Returns the current GameState instance. */
    AGameStateBase* GetGameState() const { return GameState; }
    template <class T>
    T* GetGameState() const {
        return Cast<T>(GameState);
    }
    /** Sets the current GameState instance on this world and the game state's world. */
    void SetGameState(AGameStateBase* NewGameState);

    /** Returns the owning game instance, or null. */
    UGameInstance* GetGameInstance() const { return OwningGameInstance; }
    template <class T>
    T* GetGameInstance() const {
        return Cast<T>(OwningGameInstance);
    }
    /** Sets the owning game instance for this world. */
    void SetGameInstance(UGameInstance* NewGI);

    /** Returns an iterator for the controller list. */
    FConstControllerIterator GetControllerIterator() const;
    /** Returns an iterator for the player controller list. */
    FConstPlayerControllerIterator GetPlayerControllerIterator() const;
    /** Returns the first player controller, or null if there is not one. */
    APlayerController* GetFirstPlayerController() const;
    template <class T>
    T* GetFirstPlayerController() const {
        return Cast<T>(GetFirstPlayerController());
    }
    /** Returns the first valid local player of the game instance, or null. */
    ULocalPlayer* GetFirstLocalPlayerFromController() const;
    int32 GetNumControllers() const;
    int32 GetNumPlayerControllers() const;
    /** Inserts/removes the given controller into/from the appropriate list. */
    void AddController(AController* Controller);
    void RemoveController(AController* Controller);

    /**
     * Spawns the play actor (player controller) of a player through the game mode's Login and PostLogin.
     * @param Player the player. @param InURL URL of the login. @param Error why it was refused.
     * @return the new player controller, or null.
     */
    APlayerController* SpawnPlayActor(ULocalPlayer* Player, const FURL& InURL, FString& Error);

    /** Jumps the server to a new level: at the end of this frame. */
    bool ServerTravel(const FString& InURL, bool bAbsolute = false, bool bShouldSkipGameNotify = false);

    // ---------------------------------------------------------------------------------------------- managers,
    // subsystems

    /** Returns TimerManager instance for this world: that of the game instance, if there is one. */
    FTimerManager& GetTimerManager() const;
    /** Returns LatentActionManager instance for this world: that of the game instance, if there is one. */
    FLatentActionManager& GetLatentActionManager();
    /** Runs the tick functions. Engine code only. */
    FTickTaskManager& GetTickTaskManager() const { return *TickTaskManager; }

    /** Get a Subsystem of specified type. */
    UWorldSubsystem* GetSubsystemBase(TSubclassOf<UWorldSubsystem> SubsystemClass) const;
    template <typename TSubsystemClass>
    TSubsystemClass* GetSubsystem() const {
        return SubsystemCollection.GetSubsystem<TSubsystemClass>(TSubsystemClass::StaticClass());
    }
    /** Get a Subsystem of specified type from the provided World, returns nullptr if there is no World. */
    template <typename TSubsystemClass>
    static TSubsystemClass* GetSubsystem(const UWorld* World) {
        return World ? World->GetSubsystem<TSubsystemClass>() : nullptr;
    }
    /** Check if world has a subsystem of the specified type. */
    template <typename TSubsystemClass>
    bool HasSubsystem() const {
        return GetSubsystem<TSubsystemClass>() != nullptr;
    }
    /** Get all Subsystem of specified type. */
    template <typename TSubsystemClass>
    TArray<TSubsystemClass*> GetSubsystemArrayCopy() const {
        return SubsystemCollection.GetSubsystemArrayCopy<TSubsystemClass>(TSubsystemClass::StaticClass());
    }

    /** Executes a console command of the world: see UEngine::Exec for the list. */
    bool Exec(UWorld* InWorld, const TCHAR* Cmd, FOutputDevice& Ar);

    // UObject
    virtual UWorld* GetWorld() const override final;
    virtual void FinishDestroy() override;

private:
    friend class AActor;
    friend class UEngine;

    /** Array of levels currently in this world. Not serialized to disk to avoid hard references. */
    UPROPERTY(Transient)
    TArray<TObjectPtr<ULevel>> Levels;

    /** Pointer to the current level being edited. Level has to be in the Levels array and == PersistentLevel in the
     * game. */
    UPROPERTY(Transient)
    TObjectPtr<ULevel> CurrentLevel;

    /** The world's game instance. */
    UPROPERTY(Transient)
    TObjectPtr<UGameInstance> OwningGameInstance;

    /** The current GameMode, valid only on the server. */
    UPROPERTY(Transient)
    TObjectPtr<AGameModeBase> AuthorityGameMode;

    /** The replicated actor which contains game state information that can be accessible to clients. */
    UPROPERTY(Transient)
    TObjectPtr<AGameStateBase> GameState;

    bool bBegunPlay;
    FObjectSubsystemCollection<UWorldSubsystem> SubsystemCollection;
    TUniquePtr<FTickTaskManager> TickTaskManager;
    TUniquePtr<FTimerManager> TimerManager;
    FLatentActionManager LatentActionManager;
    TArray<TWeakObjectPtr<AController>> ControllerList;
    TArray<TWeakObjectPtr<APlayerController>> PlayerControllerList;
    TArray<TWeakObjectPtr<UActorComponent>> ComponentsThatNeedEndOfFrameUpdate;
    TSubclassOf<AGameModeBase> InitialGameModeClass;
    FOnBeginTearingDownEvent BeginTearingDownEvent;
    mutable FOnActorSpawned OnActorSpawned;
    mutable FOnActorSpawned OnActorPreSpawnInitialization;
    mutable FOnActorDestroyed OnActorDestroyed;

    AActor* SpawnActorInternal(
        UClass* Class, const FTransform& Transform, const FActorSpawnParameters& SpawnParameters);
    void RunTickGroup(ETickingGroup Group, ELevelTick TickType, float DeltaSeconds);
    void InitializeSubsystems();
};

/** Parameters of FWorldDelegates::OnWorldInitializedActors. */
struct FActorsInitializedParams {
    FActorsInitializedParams(UWorld* InWorld, bool InResetTime) : World(InWorld), ResetTime(InResetTime) {}
    UWorld* World;
    bool ResetTime;
};

/**
 * World delegates.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/FWorldDelegates
 */
class ENGINE_API FWorldDelegates {
public:
    DECLARE_MULTICAST_DELEGATE_ThreeParams(FWorldTickStart, UWorld*, ELevelTick, float);
    /** Called at the start of a world's tick. */
    static FWorldTickStart OnWorldTickStart;

    DECLARE_MULTICAST_DELEGATE_ThreeParams(FWorldTickEnd, UWorld*, ELevelTick, float);
    /** Called at the end of a world's tick. */
    static FWorldTickEnd OnWorldTickEnd;

    DECLARE_MULTICAST_DELEGATE_ThreeParams(FOnWorldPreActorTick, UWorld*, ELevelTick, float);
    /** Called before actors are ticked for each world. */
    static FOnWorldPreActorTick OnWorldPreActorTick;

    DECLARE_MULTICAST_DELEGATE_ThreeParams(FOnWorldPostActorTick, UWorld*, ELevelTick, float);
    /** Called after actors have been ticked for each world. */
    static FOnWorldPostActorTick OnWorldPostActorTick;

    DECLARE_MULTICAST_DELEGATE_OneParam(FWorldEvent, UWorld*);
    /** Called when a world is created, before it is initialised. */
    static FWorldEvent OnPostWorldCreation;

    DECLARE_MULTICAST_DELEGATE_TwoParams(FWorldInitializationEvent, UWorld*, const UWorld::InitializationValues);
    /** Callback for world initialization (pre). */
    static FWorldInitializationEvent OnPreWorldInitialization;
    /** Callback for world initialization (post). */
    static FWorldInitializationEvent OnPostWorldInitialization;

    DECLARE_MULTICAST_DELEGATE_OneParam(FOnWorldInitializedActors, const FActorsInitializedParams&);
    /** Called after all actors of a world have been initialised for play. */
    static FOnWorldInitializedActors OnWorldInitializedActors;

    DECLARE_MULTICAST_DELEGATE_ThreeParams(FWorldCleanupEvent, UWorld*, bool, bool);
    /** Callback for world cleanup start: (World, bSessionEnded, bCleanupResources). */
    static FWorldCleanupEvent OnWorldCleanup;
    /** Callback for world cleanup end. */
    static FWorldCleanupEvent OnPostWorldCleanup;

    /** Callback for world destruction (only called for initialized worlds). */
    static FWorldEvent OnPreWorldFinishDestroy;
    /** Sent when a world begins to be torn down. */
    static FWorldEvent OnWorldBeginTearDown;

    DECLARE_MULTICAST_DELEGATE_TwoParams(FOnLevelChanged, ULevel*, UWorld*);
    /** Sent when a level is added to the world (for the persistent level: LevelAddedToWorld(null, World)). */
    static FOnLevelChanged LevelAddedToWorld;
    /** Sent when a level is removed from the world. */
    static FOnLevelChanged LevelRemovedFromWorld;

    DECLARE_MULTICAST_DELEGATE_OneParam(FGameInstanceEvent, UGameInstance*);
    /** Called when a game instance starts. */
    static FGameInstanceEvent OnStartGameInstance;

    FWorldDelegates() = delete;
};
