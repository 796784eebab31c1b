// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Engine/EngineTypes.h"
#include "Kismet/BlueprintFunctionLibrary.h"
#include "Templates/SubclassOf.h"
#include "UObject/Interface.h"
#include "UObject/ObjectMacros.h"

#include "GameplayStatics.generated.h"

class AActor;
class AGameModeBase;
class AGameStateBase;
class APawn;
class APlayerCameraManager;
class APlayerController;
class UGameInstance;

/**
 * What scripts and remote programs ask a running game: players, time, levels, and actors by class or tag. Epic page:
 * UGameplayStatics.
 */
UCLASS()
class ENGINE_API UGameplayStatics : public UBlueprintFunctionLibrary {
    GENERATED_BODY()

public:
    // -------------------------------------------------------------------------------------------- Players and the game

    /** Returns the game instance, or null when there is none. */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject"), Category = "Game")
    static UGameInstance* GetGameInstance(const UObject* WorldContextObject);

    /** Returns the total number of available players. */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject"), Category = "Game")
    static int32 GetNumPlayerControllers(const UObject* WorldContextObject);

    /** Returns the player controller found while iterating through the local and available player controllers; null
     * when there is none at that index. */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject"), Category = "Game")
    static APlayerController* GetPlayerController(const UObject* WorldContextObject, int32 PlayerIndex);

    /** Returns the pawn for the player controller at the specified player index; null if there is none. */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject"), Category = "Game")
    static APawn* GetPlayerPawn(const UObject* WorldContextObject, int32 PlayerIndex);

    /** Returns the camera manager for the player controller at the specified player index; null if there is none. */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject"), Category = "Game")
    static APlayerCameraManager* GetPlayerCameraManager(const UObject* WorldContextObject, int32 PlayerIndex);

    /** Returns the current game mode, or null if it cannot be retrieved. */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject"), Category = "Game")
    static AGameModeBase* GetGameMode(const UObject* WorldContextObject);

    /** Returns the current game state, or null if it cannot be retrieved. */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject"), Category = "Game")
    static AGameStateBase* GetGameState(const UObject* WorldContextObject);

    /** Returns the class of a passed object, null for null. */
    UFUNCTION(BlueprintPure, meta = (DisplayName = "Get Class"), Category = "Game")
    static UClass* GetObjectClass(const UObject* Object);

    // ------------------------------------------------------------------------------------------------------------ Time

    /** Gets the current global time dilation: 1 is normal. */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject"), Category = "Utilities|Time")
    static float GetGlobalTimeDilation(const UObject* WorldContextObject);

    /** Sets the global time dilation: 1 is normal. Clamped to the limits in the world settings. */
    UFUNCTION(BlueprintCallable, meta = (WorldContext = "WorldContextObject"), Category = "Utilities|Time")
    static void SetGlobalTimeDilation(const UObject* WorldContextObject, float TimeDilation);

    /** Sets the game's paused state. Returns whether it could be set: that takes a player controller. */
    UFUNCTION(BlueprintCallable, meta = (WorldContext = "WorldContextObject"), Category = "Utilities|Time")
    static bool SetGamePaused(const UObject* WorldContextObject, bool bPaused);

    /** Returns the game's paused state. */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject"), Category = "Utilities|Time")
    static bool IsGamePaused(const UObject* WorldContextObject);

    /** Returns the frame delta time in seconds, adjusted by time dilation. */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject"), Category = "Utilities|Time")
    static double GetWorldDeltaSeconds(const UObject* WorldContextObject);

    /** Returns time in seconds since the world was brought up for play: stops while the game is paused, is dilated. */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject"), Category = "Utilities|Time")
    static double GetTimeSeconds(const UObject* WorldContextObject);

    /** Returns time in seconds since the world was brought up for play: does not stop while the game is paused, is
     * dilated. */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject"), Category = "Utilities|Time")
    static double GetUnpausedTimeSeconds(const UObject* WorldContextObject);

    /** Returns time in seconds since the world was brought up for play: neither stopped nor dilated. */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject"), Category = "Utilities|Time")
    static double GetRealTimeSeconds(const UObject* WorldContextObject);

    /** Returns the time in seconds since the application was started: the whole seconds and the rest. It is read at the
     * call, not once for each frame. */
    UFUNCTION(BlueprintPure, Category = "Utilities|Time")
    static void GetAccurateRealTime(int32& Seconds, double& PartialSeconds);

    // -------------------------------------------------------------------------------------------------------- Spawning

    /** Creates an object of a class that is no actor, component or widget, with an outer that must not be null. Null
     * with the reason in the log if that is not possible. */
    UFUNCTION(
        BlueprintCallable, meta = (BlueprintInternalUseOnly = "true", DefaultToSelf = "Outer"), Category = "Spawning")
    static UObject* SpawnObject(TSubclassOf<UObject> ObjectClass, UObject* Outer);

    /** Spawns an instance of an actor class, but does not run its construction. FinishSpawningActor completes it. */
    UFUNCTION(BlueprintCallable,
        meta = (WorldContext = "WorldContextObject", UnsafeDuringActorConstruction = "true",
            BlueprintInternalUseOnly = "true"),
        Category = "Spawning")
    static AActor* BeginDeferredActorSpawnFromClass(const UObject* WorldContextObject, TSubclassOf<AActor> ActorClass,
        const FTransform& SpawnTransform,
        ESpawnActorCollisionHandlingMethod CollisionHandlingOverride = ESpawnActorCollisionHandlingMethod::Undefined,
        AActor* Owner = nullptr,
        ESpawnActorScaleMethod TransformScaleMethod = ESpawnActorScaleMethod::MultiplyWithRoot);

    /** Finishes the spawning of an actor: runs its construction, initialises it and begins its play. Returns the actor,
     * null for null. */
    UFUNCTION(BlueprintCallable, meta = (UnsafeDuringActorConstruction = "true", BlueprintInternalUseOnly = "true"),
        Category = "Spawning")
    static AActor* FinishSpawningActor(AActor* Actor, const FTransform& SpawnTransform,
        ESpawnActorScaleMethod TransformScaleMethod = ESpawnActorScaleMethod::MultiplyWithRoot);

    // -------------------------------------------------------------------------------------------------- Finding actors

    /** Finds the average location (centroid) of an array of actors; null ones do not count. Zero for none. */
    UFUNCTION(BlueprintPure, Category = "Actor")
    static FVector GetActorArrayAverageLocation(const TArray<AActor*>& Actors);

    /** Finds the bounds of a set of actors, in centimetres. */
    UFUNCTION(BlueprintPure, Category = "Actor")
    static void GetActorArrayBounds(
        const TArray<AActor*>& Actors, bool bOnlyCollidingComponents, FVector& Center, FVector& BoxExtent);

    /** Finds the first actor in the world of the specified class; null when there is none. */
    UFUNCTION(BlueprintCallable, meta = (WorldContext = "WorldContextObject", DeterminesOutputType = "ActorClass"),
        Category = "Actor")
    static AActor* GetActorOfClass(const UObject* WorldContextObject, TSubclassOf<AActor> ActorClass);

    /** Finds all actors in the world of the specified class, in the order of their spawning. This is a slow operation.
     */
    UFUNCTION(BlueprintCallable,
        meta = (WorldContext = "WorldContextObject", DeterminesOutputType = "ActorClass",
            DynamicOutputParam = "OutActors"),
        Category = "Actor")
    static void GetAllActorsOfClass(
        const UObject* WorldContextObject, TSubclassOf<AActor> ActorClass, TArray<AActor*>& OutActors);

    /** Finds all actors in the world with the specified interface. This is a slow operation. */
    UFUNCTION(BlueprintCallable,
        meta = (WorldContext = "WorldContextObject", DeterminesOutputType = "Interface",
            DynamicOutputParam = "OutActors"),
        Category = "Actor")
    static void GetAllActorsWithInterface(
        const UObject* WorldContextObject, TSubclassOf<UInterface> Interface, TArray<AActor*>& OutActors);

    /** Finds all actors in the world with the supplied tag. This is a slow operation. */
    UFUNCTION(BlueprintCallable, meta = (WorldContext = "WorldContextObject"), Category = "Actor")
    static void GetAllActorsWithTag(const UObject* WorldContextObject, FName Tag, TArray<AActor*>& OutActors);

    /** Finds all actors in the world of the specified class with the specified tag. This is a slow operation. */
    UFUNCTION(BlueprintCallable,
        meta = (WorldContext = "WorldContextObject", DeterminesOutputType = "ActorClass",
            DynamicOutputParam = "OutActors"),
        Category = "Actor")
    static void GetAllActorsOfClassWithTag(
        const UObject* WorldContextObject, TSubclassOf<AActor> ActorClass, FName Tag, TArray<AActor*>& OutActors);

    /** Returns the actor nearest to Origin from ActorsToCheck, and how far it is (centimetres). Null for none. */
    UFUNCTION(BlueprintPure, Category = "Actor")
    static AActor* FindNearestActor(FVector Origin, const TArray<AActor*>& ActorsToCheck, float& Distance);

    // ---------------------------------------------------------------------------------------------- Levels and options

    /** Travels to another level at the end of the frame. Options are like URL options, joined by question marks. */
    UFUNCTION(BlueprintCallable,
        meta = (WorldContext = "WorldContextObject", AdvancedDisplay = "2", DisplayName = "Open Level (by Name)"),
        Category = "Game")
    static void OpenLevel(
        const UObject* WorldContextObject, FName LevelName, bool bAbsolute = true, FString Options = FString(TEXT("")));

    /** Gets the name of the currently open level, by default without the prefix of play-in-editor worlds (there is none
     * here). */
    UFUNCTION(BlueprintPure, meta = (WorldContext = "WorldContextObject", AdvancedDisplay = "1"), Category = "Game")
    static FString GetCurrentLevelName(const UObject* WorldContextObject, bool bRemovePrefixString = true);

    /** Returns the name of the current platform: "Linux". */
    UFUNCTION(BlueprintPure, Category = "Game")
    static FString GetPlatformName();

    /** Returns whether a command line option was given: a parameter such as -name. */
    UFUNCTION(BlueprintPure, Category = "Game")
    static bool HasLaunchOption(const FString& OptionToCheck);

    /** Finds an option in an options string and returns its value: "?Key=Value"; an empty string if it is not there. */
    UFUNCTION(BlueprintPure, meta = (BlueprintThreadSafe), Category = "Game")
    static FString ParseOption(FString Options, const FString& Key);

    /** Returns whether a key exists in an options string. */
    UFUNCTION(BlueprintPure, meta = (BlueprintThreadSafe), Category = "Game")
    static bool HasOption(FString Options, const FString& InKey);

    /** Finds an option in an options string and returns it as an integer, or a default value. */
    UFUNCTION(BlueprintPure, meta = (BlueprintThreadSafe), Category = "Game")
    static int32 GetIntOption(const FString& Options, const FString& Key, int32 DefaultValue);

    /** Breaks up a key=value pair into its key and value. */
    UFUNCTION(BlueprintPure, meta = (BlueprintThreadSafe), Category = "Game")
    static void GetKeyValue(const FString& Pair, FString& Key, FString& Value);
};
