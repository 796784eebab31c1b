// SPDX-License-Identifier: MIT
/** @file The game's viewport. Mirrors UE's Engine/GameViewportClient.h. */
#pragma once

#include "CoreMinimal.h"
#include "Engine/Engine.h"
#include "UObject/Object.h"
#include "UObject/ObjectMacros.h"

#include "GameViewportClient.generated.h"

class UGameInstance;
class ULocalPlayer;
class UWorld;
struct FWorldContext;

/**
 * A game viewport is a high-level abstract interface for the platform specific rendering, audio, and input subsystems.
 * This one is headless: it has a size, which sensors and projections use, but no window.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/UGameViewportClient
 */
UCLASS(Within = Engine, Transient, config = Engine)
class ENGINE_API UGameViewportClient : public UObject {
    GENERATED_BODY()

public:
    UGameViewportClient(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** The relative world context for this viewport. */
    UPROPERTY()
    TObjectPtr<UWorld> World;

    /** The game instance of this viewport. */
    UPROPERTY()
    TObjectPtr<UGameInstance> GameInstance;

    /** Sets up the viewport with the size from the command line: -ResX=1280 -ResY=720. */
    virtual void Init(
        FWorldContext& WorldContext, UGameInstance* OwningGameInstance, bool bCreateNewAudioDevice = true);
    /** Creates the first local player, if there is none. */
    virtual ULocalPlayer* SetupInitialLocalPlayer(FString& OutError);
    /** Retrieve the size of the main viewport, in pixels. */
    void GetViewportSize(FVector2D& ViewportSize) const;
    /** Changes the size of the viewport. @param X, Y in pixels, at least 1. */
    void SetViewportSize(int32 X, int32 Y);
    /** The game instance of this viewport. */
    UGameInstance* GetGameInstance() const { return GameInstance; }

    // UObject
    virtual UWorld* GetWorld() const override { return World; }

private:
    FIntPoint Size;
};
