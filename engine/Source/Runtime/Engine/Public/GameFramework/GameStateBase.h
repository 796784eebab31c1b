// SPDX-License-Identifier: MIT
/** @file State of the game. Mirrors UE's GameFramework/GameStateBase.h. */
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Info.h"
#include "Templates/SubclassOf.h"

#include "GameStateBase.generated.h"

class AController;
class AGameModeBase;
class APlayerState;

/**
 * GameStateBase is a class that manages the game's global state, and is spawned by GameModeBase.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/AGameStateBase
 */
UCLASS(config = Game, NotPlaceable, BlueprintType, Blueprintable)
class ENGINE_API AGameStateBase : public AInfo {
    GENERATED_BODY()

public:
    AGameStateBase(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Class of the server's game mode, assigned by GameModeBase. */
    UPROPERTY(Transient, BlueprintReadOnly, Category = GameState)
    TSubclassOf<AGameModeBase> GameModeClass;

    /** Instance of the current game mode, exists only on the server. For non-authority clients, this will be NULL. */
    UPROPERTY(Transient, BlueprintReadOnly, Category = GameState)
    TObjectPtr<AGameModeBase> AuthorityGameMode;

    /** Array of all PlayerStates, maintained on both server and clients (PlayerStates are always relevant). */
    UPROPERTY(Transient, BlueprintReadOnly, Category = GameState)
    TArray<TObjectPtr<APlayerState>> PlayerArray;

    /** Helper template to returns the GameModeBase default object. */
    const AGameModeBase* GetDefaultGameMode() const;

    /** Returns the simulated TimeSeconds on the server, will be synchronized on client and server. */
    UFUNCTION(BlueprintCallable, Category = GameState)
    virtual double GetServerWorldTimeSeconds() const;

    /** Returns true if the world has started play (called BeginPlay on actors). */
    UFUNCTION(BlueprintCallable, Category = GameState)
    virtual bool HasBegunPlay() const;

    /** Returns true if the world has started match (called MatchStarted callbacks). */
    UFUNCTION(BlueprintCallable, Category = GameState)
    virtual bool HasMatchStarted() const;

    /** Returns the time that should be used as when a player started. */
    UFUNCTION(BlueprintCallable, Category = GameState)
    virtual float GetPlayerStartTime(AController* Controller) const;

    /** Add PlayerState to the PlayerArray. */
    virtual void AddPlayerState(APlayerState* PlayerState);
    /** Remove PlayerState from the PlayerArray. */
    virtual void RemovePlayerState(APlayerState* PlayerState);
    /** Called by game mode to set the started play bool: starts play of the world. */
    virtual void HandleBeginPlay();

    // AActor
    virtual void PreInitializeComponents() override;
    virtual void PostInitializeComponents() override;

private:
    /** True if BeginPlay has been called. */
    UPROPERTY(Transient)
    bool bReplicatedHasBegunPlay;
};
