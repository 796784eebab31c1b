// SPDX-License-Identifier: MIT
/** @file The local player. Mirrors UE's Engine/LocalPlayer.h. */
#pragma once

#include "CoreMinimal.h"
#include "Engine/Engine.h"
#include "Engine/Player.h"
#include "Subsystems/LocalPlayerSubsystem.h"
#include "Subsystems/SubsystemCollection.h"

#include "LocalPlayer.generated.h"

class APlayerController;
class UGameInstance;
class UGameViewportClient;

/**
 * Each player that is active on the current client has a LocalPlayer. It stays active across maps. There may be none
 * spawned in the case of a dedicated server.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/ULocalPlayer
 */
UCLASS(Within = Engine, config = Engine, Transient)
class ENGINE_API ULocalPlayer : public UPlayer {
    GENERATED_BODY()

public:
    ULocalPlayer(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** The primary viewport containing this player's view. */
    UPROPERTY()
    TObjectPtr<UGameViewportClient> ViewportClient;

    /** Called at creation time for internal setup. */
    virtual void PlayerAdded(UGameViewportClient* InViewportClient, int32 InControllerID);
    /** Called when the player is removed from the game: ends its subsystems. */
    virtual void PlayerRemoved();
    /** Spawns an actor to represent this player in the world: its controller. @param URL the URL the player joined
     * with. @param OutError why not. */
    virtual bool SpawnPlayActor(const FString& URL, FString& OutError, UWorld* InWorld);

    /** The controller ID which this player accepts input from. */
    UFUNCTION(BlueprintPure, Category = "Player")
    int32 GetControllerId() const { return ControllerId; }
    /** Index of this player among the local players of the game instance. */
    int32 GetLocalPlayerIndex() const;
    /** Whether this is the first local player. */
    bool IsPrimaryPlayer() const { return GetLocalPlayerIndex() == 0; }
    /** The game instance of this player. */
    UGameInstance* GetGameInstance() const;
    /** Returns this player's nickname. */
    virtual FString GetNickname() const;
    /** The player controller's view: location, rotation and field of view. @return false when there is no player
     * controller. */
    bool GetViewPoint(struct FMinimalViewInfo& OutViewInfo) const;

    /** Get a Subsystem of specified type. */
    ULocalPlayerSubsystem* GetSubsystemBase(TSubclassOf<ULocalPlayerSubsystem> SubsystemClass) const;
    template <typename TSubsystemClass>
    TSubsystemClass* GetSubsystem() const {
        return SubsystemCollection.GetSubsystem<TSubsystemClass>(TSubsystemClass::StaticClass());
    }
    template <typename TSubsystemClass>
    static TSubsystemClass* GetSubsystem(const ULocalPlayer* LocalPlayer) {
        return LocalPlayer ? LocalPlayer->GetSubsystem<TSubsystemClass>() : nullptr;
    }
    template <typename TSubsystemClass>
    TArray<TSubsystemClass*> GetSubsystemArrayCopy() const {
        return SubsystemCollection.GetSubsystemArrayCopy<TSubsystemClass>(TSubsystemClass::StaticClass());
    }

    // UPlayer
    virtual bool Exec(UWorld* InWorld, const TCHAR* Cmd, FOutputDevice& Ar) override;
    virtual void SwitchController(APlayerController* PC) override;
    // UObject
    virtual UWorld* GetWorld() const override;

private:
    int32 ControllerId;
    FObjectSubsystemCollection<ULocalPlayerSubsystem> SubsystemCollection;
};
