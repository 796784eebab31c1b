// SPDX-License-Identifier: MIT
/** @file The engine of games. Mirrors UE's Engine/GameEngine.h. */
#pragma once

#include "CoreMinimal.h"
#include "Engine/Engine.h"

#include "GameEngine.generated.h"

class UGameInstance;

/**
 * Engine that manages core systems that enable a game: one game instance, its viewport, its world.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/UGameEngine
 */
UCLASS(config = Engine, Transient)
class ENGINE_API UGameEngine : public UEngine {
    GENERATED_BODY()

public:
    UGameEngine(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** The game instance. */
    UPROPERTY()
    TObjectPtr<UGameInstance> GameInstance;

    /** The map that Start loads: -Map=..., or an empty world. */
    FString StartMap;

    /** Why the start map could not be loaded; empty when it was. */
    FString StartError;

    /** Returns the current world of the game. */
    UWorld* GetGameWorld();

    // UEngine
    virtual void Init(IEngineLoop* InEngineLoop) override;
    virtual void Start() override;
    virtual void PreExit() override;
    virtual void Tick(float DeltaSeconds, bool bIdleMode) override;
    virtual UGameInstance* GetGameInstance() const override { return GameInstance; }
};
