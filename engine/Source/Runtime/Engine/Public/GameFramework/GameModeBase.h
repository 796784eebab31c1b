// SPDX-License-Identifier: MIT
/** @file Rules of the game. Mirrors UE's GameFramework/GameModeBase.h. */
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Info.h"
#include "GameFramework/PlayerController.h"
#include "Templates/SubclassOf.h"

#include "GameModeBase.generated.h"

class AController;
class AGameStateBase;
class APawn;
class APlayerState;
class AWorldSettings;
class ULocalPlayer;
class UPlayer;

/**
 * The GameModeBase defines the game being played. It governs the game rules, scoring, what actors are allowed to exist
 * in this game type, and who may enter the game. It is only instanced on the server and will never exist on the client.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/AGameModeBase
 */
UCLASS(config = Game, NotPlaceable, BlueprintType, Blueprintable, Transient,
    HideCategories = (Info, Rendering, MovementReplication, Replication, Actor),
    meta = (ShortTooltip =
                "Game Mode Base defines the game being played, its rules, scoring, and other facets of the game type."))
class ENGINE_API AGameModeBase : public AInfo {
    GENERATED_BODY()

public:
    AGameModeBase(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Save options string and parse it when needed. */
    UPROPERTY(BlueprintReadOnly, Category = GameMode)
    FString OptionsString;

    /** Class of GameState associated with this GameMode. */
    UPROPERTY(EditAnywhere, NoClear, BlueprintReadOnly, Category = Classes)
    TSubclassOf<AGameStateBase> GameStateClass;

    /** The class of PlayerController to spawn for players logging in. */
    UPROPERTY(EditAnywhere, NoClear, BlueprintReadOnly, Category = Classes)
    TSubclassOf<APlayerController> PlayerControllerClass;

    /** A PlayerState of this class will be associated with every player to replicate relevant player information to all
     * clients. */
    UPROPERTY(EditAnywhere, NoClear, BlueprintReadOnly, Category = Classes)
    TSubclassOf<APlayerState> PlayerStateClass;

    /** The default pawn class used by players. */
    UPROPERTY(EditAnywhere, NoClear, BlueprintReadOnly, Category = Classes, meta = (DisplayName = "Default Pawn Class"))
    TSubclassOf<APawn> DefaultPawnClass;

    /** GameState is used to replicate game state relevant properties to all clients. */
    UPROPERTY(Transient)
    TObjectPtr<AGameStateBase> GameState;

    /** The default player name assigned to players that join with no name specified. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = Game)
    FString DefaultPlayerNameText;

    /** Whether players should immediately spawn when logging in, or stay as spectators until they manually spawn. */
    UPROPERTY(EditDefaultsOnly, BlueprintReadOnly, Category = "Game")
    uint8 bStartPlayersAsSpectators : 1;

    /** Whether the game is pauseable. */
    UPROPERTY(EditDefaultsOnly, BlueprintReadOnly, Category = "Game")
    uint8 bPauseable : 1;

    /** Initialize the game. The GameMode's InitGame() event is called before any other functions (including
     * PreInitializeComponents()) and is used by the GameMode to initialize parameters and spawn its helper classes. */
    virtual void InitGame(const FString& MapName, const FString& Options, FString& ErrorMessage);
    /** Initialize the GameState actor with default settings; called during PreInitializeComponents() of the GameMode
     * after a GameState has been spawned. */
    virtual void InitGameState();

    /** Helper template to returns the current GameState casted to the desired type. */
    template <class T>
    T* GetGameState() const {
        return Cast<T>(GameState);
    }

    /** Returns number of active human players, excluding spectators. */
    UFUNCTION(BlueprintCallable, Category = Game)
    virtual int32 GetNumPlayers();

    /** Transitions to calls BeginPlay on actors. */
    UFUNCTION(BlueprintCallable, Category = Game)
    virtual void StartPlay();
    /** Returns true if the match start callbacks have been called. */
    UFUNCTION(BlueprintCallable, Category = Game)
    virtual bool HasMatchStarted() const;
    /** Overridable function to determine whether an Actor should have Reset called when the game has Reset called on
     * it. */
    UFUNCTION(BlueprintNativeEvent, Category = Game)
    bool ShouldReset(AActor* ActorToReset);
    /** Overridable function called when resetting level. This is used to reset the game state while staying in the same
     * map. */
    UFUNCTION(BlueprintCallable, Category = Game)
    virtual void ResetLevel();

    /** Adds the delegate to the list if the player Controller has the right to pause the game. */
    virtual bool SetPause(APlayerController* PC, FCanUnpause CanUnpauseDelegate = FCanUnpause());
    /** Check the list of delegates and clear the pause if all of them say that it may end. @return whether the game is
     * unpaused. */
    virtual bool ClearPause();
    /** Forcibly removes an object's CanUnpause delegates from the list of pausers; with null, all of them. */
    void ForceClearUnpauseDelegates(AActor* PauseActor);
    /** Return whether a player may pause the game. */
    virtual bool AllowPausing(APlayerController* PC = nullptr);
    /** Returns true if the game is currently paused by a player that this mode knows. */
    virtual bool IsPaused() const;

    /** Accept or reject a player attempting to join the server. Fails login if you set the ErrorMessage to a non-empty
     * string. */
    virtual void PreLogin(const FString& Options, const FString& Address, FString& ErrorMessage) {}
    /** Called to login new players by creating a player controller, overridable by the game. @return the new
     * controller, or null with the ErrorMessage. */
    virtual APlayerController* Login(
        UPlayer* NewPlayer, const FString& Portal, const FString& Options, FString& ErrorMessage);
    /** Called after a successful login. This is the first place it is safe to call replicated functions on the
     * PlayerController. */
    virtual void PostLogin(APlayerController* NewPlayer);
    /** Called when a Controller with a PlayerState leaves the game or is destroyed. */
    virtual void Logout(AController* Exiting);

    /** Notification that a player has successfully logged in, and has been given a player controller. */
    UFUNCTION(
        BlueprintImplementableEvent, Category = Game, meta = (DisplayName = "OnPostLogin", ScriptName = "OnPostLogin"))
    void K2_PostLogin(APlayerController* NewPlayer);
    /** Implementable event when a Controller with a PlayerState leaves the game. */
    UFUNCTION(BlueprintImplementableEvent, Category = Game, meta = (DisplayName = "OnLogout", ScriptName = "OnLogout"))
    void K2_OnLogout(AController* ExitingController);

    /** Spawns a PlayerController at the specified location; split out from Login() for easier overriding. */
    virtual APlayerController* SpawnPlayerController(
        ENetRole InRemoteRole, FVector const& SpawnLocation, FRotator const& SpawnRotation);
    /** Customize incoming player based on URL options. @return an error message, or nothing. */
    virtual FString InitNewPlayer(
        APlayerController* NewPlayerController, const FString& Options, const FString& Portal = TEXT(""));
    /** Sets the name for a controller. @param NewName; @param bNameChange true if this is a change of an older name. */
    UFUNCTION(BlueprintCallable, Category = Game)
    virtual void ChangeName(AController* Controller, const FString& NewName, bool bNameChange);

    /** Signals that a player is ready to enter the game, which may start it up: restarts the player when it can. */
    virtual void HandleStartingNewPlayer(APlayerController* NewPlayer);
    /** Returns true if it's valid to call RestartPlayer. By default will call Player->CanRestartPlayer. */
    UFUNCTION(BlueprintNativeEvent, Category = Game)
    bool PlayerCanRestart(APlayerController* Player);
    /** Return true if FindPlayerStart should use the StartSpot stored on Player instead of calling ChoosePlayerStart.
     */
    virtual bool ShouldSpawnAtStartSpot(AController* Player);
    /** Return the specific player start actor that should be used for the next spawn. @param IncomingName tag of a
     * player start to use. */
    UFUNCTION(BlueprintNativeEvent, Category = Game)
    AActor* FindPlayerStart(AController* Player, const FString& IncomingName = TEXT(""));
    /** Return the 'best' player start for this player to spawn from: the first one. */
    UFUNCTION(BlueprintNativeEvent, Category = Game)
    AActor* ChoosePlayerStart(AController* Player);
    /** Returns default pawn class for given controller. */
    UFUNCTION(BlueprintNativeEvent, Category = Game)
    UClass* GetDefaultPawnClassForController(AController* InController);
    /** Tries to spawn the player's pawn, at the location returned by FindPlayerStart. */
    UFUNCTION(BlueprintCallable, Category = Game)
    virtual void RestartPlayer(AController* NewPlayer);
    /** Tries to spawn the player's pawn at the specified actor's location. */
    UFUNCTION(BlueprintCallable, Category = Game)
    virtual void RestartPlayerAtPlayerStart(AController* NewPlayer, AActor* StartSpot);
    /** Tries to spawn the player's pawn at a specific location. */
    UFUNCTION(BlueprintCallable, Category = Game)
    virtual void RestartPlayerAtTransform(AController* NewPlayer, const FTransform& SpawnTransform);
    /** Called during RestartPlayer to actually spawn the player's pawn, when using a start spot. */
    UFUNCTION(BlueprintNativeEvent, Category = Game)
    APawn* SpawnDefaultPawnFor(AController* NewPlayer, AActor* StartSpot);
    /** Called during RestartPlayer to actually spawn the player's pawn, when using a transform. */
    UFUNCTION(BlueprintNativeEvent, Category = Game)
    APawn* SpawnDefaultPawnAtTransform(AController* NewPlayer, const FTransform& SpawnTransform);

    // AActor
    virtual void PreInitializeComponents() override;

protected:
    /** Handles second half of RestartPlayer. */
    virtual void FinishRestartPlayer(AController* NewPlayer, const FRotator& StartRotation);
    /** Initializes the player's start spot. @return whether there is one. */
    virtual bool UpdatePlayerStartSpot(AController* Player, const FString& Portal, FString& OutErrorMessage);
    /** Called from RestartPlayerAtPlayerStart, can be used to initialize the start spawn actor. */
    UFUNCTION(BlueprintNativeEvent, Category = Game)
    void InitStartSpot(AActor* StartSpot, AController* NewPlayer);

private:
    struct FPauser {
        TWeakObjectPtr<APlayerController> Controller;
        FCanUnpause CanUnpause;
    };
    /** Who paused the game, with the delegates that tell whether it may go on. */
    TArray<FPauser> Pausers;
    int32 NextPlayerId;

    AWorldSettings* GetWorldSettings() const;
};
