// SPDX-License-Identifier: MIT
// A running engine for a test case, without the Launch module: one game engine, one game instance, one local player,
// one empty world.
#pragma once

#include <doctest/doctest.h>

#include "CoreMinimal.h"
#include "Engine/GameEngine.h"
#include "Engine/GameInstance.h"
#include "Engine/Level.h"
#include "Engine/LocalPlayer.h"
#include "Engine/World.h"
#include "EngineUtils.h"
#include "GameFramework/Actor.h"
#include "GameFramework/PlayerController.h"
#include "GameFramework/WorldSettings.h"
#include "Misc/App.h"
#include "Misc/CoreDelegates.h"
#include "UObject/GarbageCollection.h"
#include "UObject/Package.h"

inline doctest::String toString(const FString& text) { return TCHAR_TO_UTF8(*text); }

struct EngineFixture {
    UGameEngine* Engine = nullptr;
    // The world of the game: initialised and empty. Its play begins by BeginPlay().
    UWorld* World = nullptr;

    EngineFixture() {
        Engine = NewObject<UGameEngine>(GetTransientPackage());
        GEngine = Engine;
        Engine->AddToRoot();
        Engine->Init(nullptr);
        World = Engine->GetGameWorld();
        REQUIRE(World);
        GWorld = World;
    }

    ~EngineFixture() {
        Engine->PreExit();
        Engine->RemoveFromRoot();
        GEngine = nullptr;
        GWorld = nullptr;
        CollectGarbage(GARBAGE_COLLECTION_KEEPFLAGS, true);
    }

    EngineFixture(const EngineFixture&) = delete;
    EngineFixture& operator=(const EngineFixture&) = delete;

    // Starts the game as LoadMap does: game mode, actors initialised, a player with its pawn, play.
    void BeginPlay() {
        const FURL url(nullptr, TEXT("/Engine/Maps/Entry"), TRAVEL_Absolute);
        World->SetGameMode(url);
        World->InitializeActorsForPlay(url);
        FString error;
        for (ULocalPlayer* player : Engine->GameInstance->GetLocalPlayers()) {
            CHECK(player->SpawnPlayActor(url.ToString(), error, World));
        }
        CHECK_MESSAGE(error.IsEmpty(), toString(error));
        World->BeginPlay();
    }

    // One frame, as the engine loop runs it. Seconds of real time; the world clamps them to [0.0005, 0.4].
    void Tick(float seconds) {
        FCoreDelegates::OnBeginFrame.Broadcast();
        FApp::SetDeltaTime(seconds);
        FApp::UpdateLastTime();
        FApp::SetCurrentTime(FApp::GetLastTime() + seconds);
        Engine->Tick(seconds, false);
        FCoreDelegates::OnEndFrame.Broadcast();
        ++GFrameCounter;
    }

    APlayerController* Player() const { return World->GetFirstPlayerController(); }
};
