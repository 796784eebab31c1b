// SPDX-License-Identifier: MIT
/** @file The engine: start, time, garbage, worlds, players. Travel is in EngineTravel.cpp, console commands in
 * EngineExec.cpp. */
#include "Engine/Engine.h"

#include "Engine/GameInstance.h"
#include "Engine/GameViewportClient.h"
#include "Engine/LocalPlayer.h"
#include "GameFramework/GameModeBase.h"
#include "GameFramework/PlayerController.h"
#include "GameFramework/WorldSettings.h"
#include "HAL/IConsoleManager.h"
#include "HAL/PlatformProcess.h"
#include "HAL/PlatformTime.h"
#include "Misc/App.h"
#include "Misc/CoreDelegates.h"
#include "Modules/ModuleManager.h"
#include "UObject/GarbageCollection.h"

DEFINE_LOG_CATEGORY(LogEngine);
DEFINE_LOG_CATEGORY(LogLoad);

UEngine* GEngine = nullptr;

namespace {
TAutoConsoleVariable<float> CVarMaxFPS(
    TEXT("t.MaxFPS"), 0.f, TEXT("Caps FPS to the given value. Set to <= 0 to be uncapped."));
TAutoConsoleVariable<float> CVarTimeBetweenPurges(TEXT("gc.TimeBetweenPurgingPendingKillObjects"), 61.1f,
    TEXT("Time in seconds (game time) we should wait between purging object references to objects that are pending "
         "kill."));
} // namespace

void FWorldContext::SetCurrentWorld(UWorld* World) { ThisCurrentWorld = World; }

UEngine::UEngine(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    LocalPlayerClass = ULocalPlayer::StaticClass();
    WorldSettingsClass = AWorldSettings::StaticClass();
    GameViewportClientClass = UGameViewportClient::StaticClass();
    GameInstanceClass = UGameInstance::StaticClass();
    DefaultGameModeClass = AGameModeBase::StaticClass();
    LightingOnlyBrightness = FLinearColor(0.3f, 0.3f, 0.3f, 1.f);
    TimeSinceLastPendingKillPurge = 0.f;
    NextWorldContextHandle = 0;
    bIsInitialized = false;
    bFullPurgeTriggered = false;
    bShouldDelayGarbageCollect = false;
    LastTickTime = 0.0;
}

UEngine::~UEngine() = default;

void UEngine::AddReferencedObjects(UObject* InThis, FReferenceCollector& Collector) {
    UEngine* This = CastChecked<UEngine>(InThis);
    for (FWorldContext& Context : This->WorldList) {
        Collector.AddReferencedObject(Context.ThisCurrentWorld, This);
        Collector.AddReferencedObject(Context.GameViewport, This);
        Collector.AddReferencedObject(Context.OwningGameInstance, This);
    }
    Super::AddReferencedObjects(InThis, Collector);
}

void UEngine::Init(IEngineLoop*) {
    EngineSubsystemCollection.Initialize(this);
    // Modules that come later may bring subsystems of the engine.
    ModulesChangedHandle =
        FModuleManager::Get().OnModulesChanged().AddLambda([this](FName, EModuleChangeReason Reason) {
            if (Reason == EModuleChangeReason::ModuleLoaded) {
                EngineSubsystemCollection.AddNewlyLoadedClasses();
            }
        });
    bIsInitialized = true;
}

void UEngine::PreExit() {
    FModuleManager::Get().OnModulesChanged().Remove(ModulesChangedHandle);
    EngineSubsystemCollection.Deinitialize();
    bIsInitialized = false;
}

// --------------------------------------------------------------------------------------------------------------------
// time

float UEngine::GetMaxFPS() const { return CVarMaxFPS.GetValueOnGameThread(); }

void UEngine::SetMaxFPS(const float MaxFPS) { CVarMaxFPS->Set(MaxFPS, ECVF_SetByConsole); }

float UEngine::GetMaxTickRate(float, bool) const { return FMath::Max(0.f, GetMaxFPS()); }

void UEngine::UpdateTimeAndHandleMaxTickRate() {
    const double Now = FPlatformTime::Seconds();
    if (LastTickTime == 0.0) {
        LastTickTime = Now;
        FApp::SetCurrentTime(Now);
    }
    FApp::UpdateLastTime();

    // The pace of frames in real time, also with a fixed step: t.MaxFPS 0 runs as fast as it can.
    double IdleSeconds = 0.0;
    const float MaxTickRate = GetMaxTickRate(static_cast<float>(Now - LastTickTime));
    if (MaxTickRate > 0.f) {
        const double NextTickTime = LastTickTime + 1.0 / static_cast<double>(MaxTickRate);
        const double WaitBegan = FPlatformTime::Seconds();
        const double WaitSeconds = NextTickTime - WaitBegan;
        if (WaitSeconds > 0.0) {
            FPlatformProcess::SleepNoStats(static_cast<float>(WaitSeconds));
            IdleSeconds = FPlatformTime::Seconds() - WaitBegan;
            FApp::SetIdleTimeOvershoot(IdleSeconds - WaitSeconds);
        }
    }
    FApp::SetIdleTime(IdleSeconds);

    const double TickTime = FPlatformTime::Seconds();
    const double RealDelta = TickTime - LastTickTime;
    LastTickTime = TickTime;
    if (FApp::IsBenchmarking() || FApp::UseFixedTimeStep()) {
        FApp::SetDeltaTime(FApp::GetFixedDeltaTime());
        FApp::SetCurrentTime(FApp::GetLastTime() + FApp::GetFixedDeltaTime());
    } else {
        FApp::SetDeltaTime(RealDelta);
        FApp::SetCurrentTime(FApp::GetLastTime() + RealDelta);
    }
}

// -----------------------------------------------------------------------------------------------------------------
// garbage

void UEngine::DelayGarbageCollection() { bShouldDelayGarbageCollect = true; }

void UEngine::ForceGarbageCollection(bool bFullPurge) {
    TimeSinceLastPendingKillPurge = 1.0f + CVarTimeBetweenPurges.GetValueOnGameThread();
    bFullPurgeTriggered = bFullPurgeTriggered || bFullPurge;
}

void UEngine::SetTimeUntilNextGarbageCollection(float MinTimeUntilNextPass) {
    TimeSinceLastPendingKillPurge = CVarTimeBetweenPurges.GetValueOnGameThread() - MinTimeUntilNextPass;
}

void UEngine::ConditionalCollectGarbage() {
    if (bShouldDelayGarbageCollect) {
        bShouldDelayGarbageCollect = false;
        return;
    }
    TimeSinceLastPendingKillPurge += static_cast<float>(FApp::GetDeltaTime());
    if (bFullPurgeTriggered || TimeSinceLastPendingKillPurge > CVarTimeBetweenPurges.GetValueOnGameThread()) {
        CollectGarbage(GARBAGE_COLLECTION_KEEPFLAGS, true);
        TimeSinceLastPendingKillPurge = 0.f;
        bFullPurgeTriggered = false;
    }
}

// ------------------------------------------------------------------------------------------------------------------
// worlds

FWorldContext& UEngine::CreateNewWorldContext(EWorldType::Type WorldType) {
    FWorldContext* Context = new FWorldContext;
    WorldList.Add(Context);
    Context->WorldType = WorldType;
    Context->ContextHandle = FName(*FString::Printf(TEXT("Context_%d"), NextWorldContextHandle++));
    return *Context;
}

FWorldContext* UEngine::GetWorldContextFromWorld(const UWorld* InWorld) {
    for (FWorldContext& Context : WorldList) {
        if (InWorld && Context.World() == InWorld) {
            return &Context;
        }
    }
    return nullptr;
}

const FWorldContext* UEngine::GetWorldContextFromWorld(const UWorld* InWorld) const {
    return const_cast<UEngine*>(this)->GetWorldContextFromWorld(InWorld);
}

FWorldContext& UEngine::GetWorldContextFromWorldChecked(const UWorld* InWorld) {
    FWorldContext* Context = GetWorldContextFromWorld(InWorld);
    checkf(Context, TEXT("%s has no world context"), *GetNameSafe(InWorld));
    return *Context;
}

FWorldContext* UEngine::GetWorldContextFromHandle(const FName WorldContextHandle) {
    for (FWorldContext& Context : WorldList) {
        if (Context.ContextHandle == WorldContextHandle) {
            return &Context;
        }
    }
    return nullptr;
}

FWorldContext* UEngine::GetWorldContextFromGameViewport(const UGameViewportClient* InViewport) {
    for (FWorldContext& Context : WorldList) {
        if (InViewport && Context.GameViewport == InViewport) {
            return &Context;
        }
    }
    return nullptr;
}

void UEngine::DestroyWorldContext(UWorld* InWorld) {
    for (int32 Index = 0; Index < WorldList.Num(); ++Index) {
        if (WorldList[Index].World() == InWorld) {
            WorldList[Index].SetCurrentWorld(nullptr);
            WorldList.RemoveAt(Index);
            return;
        }
    }
}

UWorld* UEngine::GetWorldFromContextObject(const UObject* Object, EGetWorldErrorMode ErrorMode) const {
    UWorld* World = Object ? Object->GetWorld() : nullptr;
    if (!World && ErrorMode != EGetWorldErrorMode::ReturnNull) {
        const FString Message = Object ? FString::Printf(TEXT("No world was found for object (%s): pass an actor, a "
                                                              "component or a world as the world context"),
                                             *Object->GetPathName())
                                       : FString(TEXT("A null object was passed as a world context object"));
        checkf(ErrorMode != EGetWorldErrorMode::Assert, TEXT("%s"), *Message);
        UE_LOG(LogEngine, Warning, TEXT("%s"), *Message);
    }
    return World;
}

UWorld* UEngine::GetCurrentPlayWorld(UWorld* PossiblePlayWorld) const {
    UWorld* Found = nullptr;
    for (const FWorldContext& Context : WorldList) {
        if (Context.World() && Context.World()->IsGameWorld()) {
            if (Context.World() == PossiblePlayWorld) {
                return PossiblePlayWorld;
            }
            Found = Found ? Found : Context.World();
        }
    }
    return Found;
}

void UEngine::WorldAdded(UWorld* World) { WorldAddedEvent.Broadcast(World); }

void UEngine::WorldDestroyed(UWorld* InWorld) { WorldDestroyedEvent.Broadcast(InWorld); }

void UEngine::TickWorldContext(FWorldContext& Context, float DeltaSeconds) {
    TickWorldTravel(Context, DeltaSeconds);
    if (UWorld* World = Context.World()) {
        GWorld = World;
        World->Tick(LEVELTICK_All, DeltaSeconds);
    }
}

// -----------------------------------------------------------------------------------------------------------------
// players

TArray<ULocalPlayer*> UEngine::GetGamePlayers(const UWorld* World) const {
    const UGameInstance* GameInstance = World ? World->GetGameInstance() : nullptr;
    return GameInstance ? TArray<ULocalPlayer*>(GameInstance->GetLocalPlayers()) : TArray<ULocalPlayer*>();
}

ULocalPlayer* UEngine::GetGamePlayer(const UWorld* InWorld, int32 InPlayer) {
    const UGameInstance* GameInstance = InWorld ? InWorld->GetGameInstance() : nullptr;
    return GameInstance ? GameInstance->GetLocalPlayerByIndex(InPlayer) : nullptr;
}

ULocalPlayer* UEngine::GetFirstGamePlayer(UWorld* InWorld) { return GetGamePlayer(InWorld, 0); }

ULocalPlayer* UEngine::GetFirstGamePlayer(const UGameViewportClient* InViewport) {
    const UGameInstance* GameInstance = InViewport ? InViewport->GetGameInstance() : nullptr;
    return GameInstance ? GameInstance->GetFirstGamePlayer() : nullptr;
}

ULocalPlayer* UEngine::GetLocalPlayerFromControllerId(const UWorld* InWorld, const int32 ControllerId) const {
    const UGameInstance* GameInstance = InWorld ? InWorld->GetGameInstance() : nullptr;
    return GameInstance ? GameInstance->FindLocalPlayerFromControllerId(ControllerId) : nullptr;
}

int32 UEngine::GetNumGamePlayers(UWorld* InWorld) { return GetGamePlayers(InWorld).Num(); }

APlayerController* UEngine::GetFirstLocalPlayerController(const UWorld* InWorld) {
    const UGameInstance* GameInstance = InWorld ? InWorld->GetGameInstance() : nullptr;
    return GameInstance ? GameInstance->GetFirstLocalPlayerController(InWorld) : nullptr;
}

UEngineSubsystem* UEngine::GetEngineSubsystemBase(TSubclassOf<UEngineSubsystem> SubsystemClass) const {
    return EngineSubsystemCollection.GetSubsystem<UEngineSubsystem>(SubsystemClass);
}
