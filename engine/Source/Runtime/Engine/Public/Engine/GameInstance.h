// SPDX-License-Identifier: MIT
/** @file The running game. Mirrors UE's Engine/GameInstance.h. */
#pragma once

#include "CoreMinimal.h"
#include "Engine/Engine.h"
#include "Engine/EngineBaseTypes.h"
#include "Engine/LatentActionManager.h"
#include "Subsystems/GameInstanceSubsystem.h"
#include "Subsystems/SubsystemCollection.h"
#include "Templates/SubclassOf.h"
#include "UObject/Object.h"
#include "UObject/ObjectMacros.h"

#include "GameInstance.generated.h"

class AGameModeBase;
class APlayerController;
class FTimerManager;
class UEngine;
class ULocalPlayer;
class UWorld;
struct FWorldContext;

/** Delegate for when the local players change. */
DECLARE_EVENT_OneParam(UGameInstance, FOnLocalPlayerEvent, ULocalPlayer*);

/**
 * GameInstance: high-level manager object for an instance of the running game. Spawned at game creation and not
 * destroyed until game instance is shut down.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/UGameInstance
 */
UCLASS(config = Game, Transient, BlueprintType, Blueprintable, Within = Engine)
class ENGINE_API UGameInstance : public UObject {
    GENERATED_BODY()

public:
    UGameInstance(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());
    virtual ~UGameInstance();

    /** Called when a local player was added to, or removed from, the game. */
    FOnLocalPlayerEvent OnLocalPlayerAddedEvent;
    FOnLocalPlayerEvent OnLocalPlayerRemovedEvent;

    /** Virtual function to allow custom GameInstances an opportunity to set up what it needs. */
    virtual void Init();
    /** Virtual function to allow custom GameInstances an opportunity to do cleanup when shutting down. */
    virtual void Shutdown();
    /** Called to initialize the game instance for standalone instances of the game: makes the world context and a
     * first, empty world. */
    void InitializeStandalone(const FName InPackageName = NAME_None, UPackage* InWorldPackage = nullptr);
    /** Starts the game: broadcasts OnStartGameInstance and calls OnStart. The engine loads the map. */
    virtual void StartGameInstance();

    /** Opportunity for blueprints to handle the game instance being initialised. */
    UFUNCTION(BlueprintImplementableEvent, meta = (DisplayName = "Init"))
    void ReceiveInit();
    /** Opportunity for blueprints to handle the game instance being shutdown. */
    UFUNCTION(BlueprintImplementableEvent, meta = (DisplayName = "Shutdown"))
    void ReceiveShutdown();

    /** Creates the game mode of a URL (?game=ClassPath), of the world settings, or the default one. */
    virtual AGameModeBase* CreateGameModeForURL(FURL InURL, UWorld* InWorld);
    /** Return the game mode subclass to use for a given map, options, and portal. Return the passed in class by
     * default. */
    virtual TSubclassOf<AGameModeBase> OverrideGameModeClass(TSubclassOf<AGameModeBase> GameModeClass,
        const FString& MapName, const FString& Options, const FString& Portal) const;

    // ------------------------------------------------------------------------------------------------------------
    // players

    /** Adds a new player. @param ControllerId the ID of the controller it accepts input from. @param OutError why not.
     * @param bSpawnPlayerController whether to spawn its controller in the current world. */
    ULocalPlayer* CreateLocalPlayer(int32 ControllerId, FString& OutError, bool bSpawnPlayerController);
    /** Creates the player that exists from the start. */
    virtual ULocalPlayer* CreateInitialPlayer(FString& OutError);
    /** Removes a player. @return whether it was there. */
    virtual bool RemoveLocalPlayer(ULocalPlayer* ExistingPlayer);
    int32 GetNumLocalPlayers() const { return LocalPlayers.Num(); }
    ULocalPlayer* GetLocalPlayerByIndex(const int32 Index) const {
        return LocalPlayers.IsValidIndex(Index) ? LocalPlayers[Index].Get() : nullptr;
    }
    ULocalPlayer* GetFirstGamePlayer() const { return GetLocalPlayerByIndex(0); }
    ULocalPlayer* FindLocalPlayerFromControllerId(const int32 ControllerId) const;
    APlayerController* GetFirstLocalPlayerController(const UWorld* World = nullptr) const;
    const TArray<ULocalPlayer*> GetLocalPlayers() const;

    // -----------------------------------------------------------------------------------------------------------
    // managers

    /** The timer manager, which worlds of this game share. */
    FTimerManager& GetTimerManager() const { return *TimerManager; }
    /** The latent action manager, which worlds of this game share. */
    FLatentActionManager& GetLatentActionManager() const { return *LatentActionManager; }
    UEngine* GetEngine() const;
    FWorldContext* GetWorldContext() const { return WorldContext; }
    class UGameViewportClient* GetGameViewportClient() const;

    /** Get a Subsystem of specified type. */
    UGameInstanceSubsystem* GetSubsystemBase(TSubclassOf<UGameInstanceSubsystem> SubsystemClass) const;
    template <typename TSubsystemClass>
    TSubsystemClass* GetSubsystem() const {
        return SubsystemCollection.GetSubsystem<TSubsystemClass>(TSubsystemClass::StaticClass());
    }
    template <typename TSubsystemClass>
    static TSubsystemClass* GetSubsystem(const UGameInstance* GameInstance) {
        return GameInstance ? GameInstance->GetSubsystem<TSubsystemClass>() : nullptr;
    }
    template <typename TSubsystemClass>
    TArray<TSubsystemClass*> GetSubsystemArrayCopy() const {
        return SubsystemCollection.GetSubsystemArrayCopy<TSubsystemClass>(TSubsystemClass::StaticClass());
    }

    /** Executes a console command of the game. @return whether it was known. */
    virtual bool Exec(UWorld* InWorld, const TCHAR* Cmd, FOutputDevice& Ar);

    // UObject
    virtual UWorld* GetWorld() const override final;

protected:
    /** Called when the game instance is started either normally or through PIE. */
    virtual void OnStart() {}

    /** List of locally participating players in this game instance. */
    UPROPERTY()
    TArray<TObjectPtr<ULocalPlayer>> LocalPlayers;

    FWorldContext* WorldContext;

private:
    friend class UEngine;
    TUniquePtr<FTimerManager> TimerManager;
    TUniquePtr<FLatentActionManager> LatentActionManager;
    FObjectSubsystemCollection<UGameInstanceSubsystem> SubsystemCollection;
};
