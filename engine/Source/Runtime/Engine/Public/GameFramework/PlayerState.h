// SPDX-License-Identifier: MIT
/** @file State of a player. Mirrors UE's GameFramework/PlayerState.h. */
#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Info.h"
#include "UObject/ScriptDelegates.h"

#include "PlayerState.generated.h"

class AController;
class APawn;
class APlayerController;
class APlayerState;

DECLARE_DYNAMIC_MULTICAST_DELEGATE_ThreeParams(
    FOnPlayerStatePawnSet, APlayerState*, Player, APawn*, NewPawn, APawn*, OldPawn);

/**
 * A PlayerState is created for every player. It contains information about the player, such as name and score.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/APlayerState
 */
UCLASS(BlueprintType, Blueprintable, NotPlaceable)
class ENGINE_API APlayerState : public AInfo {
    GENERATED_BODY()

public:
    APlayerState(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Broadcast whenever this player's possessed pawn is set. */
    UPROPERTY(BlueprintAssignable, Category = PlayerState)
    FOnPlayerStatePawnSet OnPawnSet;

    /** Player name, or blank if none. */
    UFUNCTION(BlueprintPure, Category = PlayerState)
    FString GetPlayerName() const { return PlayerNamePrivate; }
    /** Set the player name to S. */
    virtual void SetPlayerName(const FString& S);

    /** Player's current score. */
    float GetScore() const { return Score; }
    void SetScore(const float NewScore) { Score = NewScore; }
    /** Unique net id number: sequential. */
    UFUNCTION(BlueprintPure, Category = PlayerState)
    int32 GetPlayerId() const { return PlayerId; }
    void SetPlayerId(const int32 NewId) { PlayerId = NewId; }

    /** Return the pawn controlled by this Player State. */
    UFUNCTION(BlueprintCallable, Category = "PlayerState")
    APawn* GetPawn() const { return PawnPrivate; }
    template <class T>
    T* GetPawn() const {
        return Cast<T>(PawnPrivate);
    }
    /** Called by the controller: sets the pawn. */
    void SetPawnPrivate(APawn* InPawn);
    /** Gets the owning controller of this player state. */
    AController* GetOwningController() const;
    /** Return the player controller that created this player state, or null for remote clients. */
    UFUNCTION(BlueprintCallable, Category = "PlayerState")
    APlayerController* GetPlayerController() const;

    // AActor
    virtual void PostInitializeComponents() override;
    virtual void Destroyed() override;
    virtual void Reset() override;

private:
    /** Player's current score. */
    UPROPERTY(BlueprintReadOnly, Category = PlayerState, meta = (AllowPrivateAccess = "true"))
    float Score;

    /** Unique net id number. */
    UPROPERTY(BlueprintReadOnly, Category = PlayerState, meta = (AllowPrivateAccess = "true"))
    int32 PlayerId;

    /** Player name, or blank if none. */
    UPROPERTY()
    FString PlayerNamePrivate;

    /** The pawn that is controlled by this player. */
    UPROPERTY(BlueprintReadOnly, Category = PlayerState, meta = (AllowPrivateAccess = "true"))
    TObjectPtr<APawn> PawnPrivate;
};
