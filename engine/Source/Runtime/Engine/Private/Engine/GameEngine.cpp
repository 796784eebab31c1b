// SPDX-License-Identifier: MIT
#include "Engine/GameEngine.h"

#include "Engine/GameInstance.h"
#include "Engine/GameViewportClient.h"
#include "Engine/LocalPlayer.h"
#include "Misc/CommandLine.h"
#include "Misc/Parse.h"
#include "Tickable.h"

UGameEngine::UGameEngine(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {}

void UGameEngine::Init(IEngineLoop* InEngineLoop) {
    Super::Init(InEngineLoop);
    FParse::Value(FCommandLine::Get(), TEXT("-Map="), StartMap);

    GameInstance = NewObject<UGameInstance>(this, GameInstanceClass.Get());
    GameInstance->InitializeStandalone();

    GameViewport = NewObject<UGameViewportClient>(this, GameViewportClientClass.Get());
    FWorldContext& WorldContext = *GameInstance->GetWorldContext();
    WorldContext.GameViewport = GameViewport;
    GameViewport->Init(WorldContext, GameInstance);

    FString Error;
    if (!GameViewport->SetupInitialLocalPlayer(Error)) {
        UE_LOG(LogEngine, Warning, TEXT("There is no local player: %s"), *Error);
    }
}

void UGameEngine::Start() {
    GameInstance->StartGameInstance();
    StartError.Empty();
    const FString Map = StartMap.IsEmpty() ? FString(TEXT("/Engine/Maps/Entry")) : StartMap;
    Browse(*GameInstance->GetWorldContext(), FURL(nullptr, *Map, TRAVEL_Absolute), StartError);
}

void UGameEngine::PreExit() {
    // Worlds first: what they hold may still use the game instance and the subsystems of the engine.
    TArray<UWorld*> Worlds;
    for (FWorldContext& Context : WorldList) {
        if (Context.World()) {
            Worlds.Add(Context.World());
        }
    }
    for (UWorld* World : Worlds) {
        World->BeginTearingDown();
        World->EndPlay(EEndPlayReason::Quit);
        World->DestroyWorld(true);
    }
    if (GameInstance) {
        GameInstance->Shutdown();
    }
    for (FWorldContext& Context : WorldList) {
        Context.SetCurrentWorld(nullptr);
        Context.GameViewport = nullptr;
        Context.OwningGameInstance = nullptr;
    }
    WorldList.Empty();
    GameViewport = nullptr;
    GameInstance = nullptr;
    Super::PreExit();
}

UWorld* UGameEngine::GetGameWorld() { return GetCurrentPlayWorld(); }

void UGameEngine::Tick(float DeltaSeconds, bool bIdleMode) {
    TickDeferredCommands();
    for (int32 Index = 0; Index < WorldList.Num(); ++Index) {
        if (!bIdleMode) {
            TickWorldContext(WorldList[Index], DeltaSeconds);
        }
    }
    FTickableGameObject::TickObjects(nullptr, LEVELTICK_All, false, DeltaSeconds);
    ConditionalCollectGarbage();
}
