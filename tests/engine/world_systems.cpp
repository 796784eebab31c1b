// SPDX-License-Identifier: MIT
// Subsystems, timers, latent actions, delegates of worlds, maps, console commands.
#include "engine_fixture.h"

#include "HAL/IConsoleManager.h"
#include "LatentActions.h"
#include "Misc/StringOutputDevice.h"
#include "TimerManager.h"
#include "UObject/StrongObjectPtr.h"
#include "WorldTestTypes.h"

TEST_CASE("subsystems: made with their owner, dependencies first, unmade in reverse") {
    FTestJournal::Take();
    {
        EngineFixture engine;
        CHECK(FTestJournal::Take() == TEXT("Engine+ Ticking+ Dependent+ GameInstance+ LocalPlayer+"));
        CHECK(engine.Engine->GetEngineSubsystem<UJournalEngineSubsystem>());
        CHECK(engine.Engine->GetEngineSubsystemBase(UEngineSubsystem::StaticClass()));
        CHECK(engine.World->GetSubsystem<UADependentWorldSubsystem>()->GetWorld() == engine.World);
        CHECK(engine.World->GetSubsystem<UUnwantedWorldSubsystem>() == nullptr);
        CHECK(engine.Engine->GameInstance->GetSubsystem<UJournalGameInstanceSubsystem>()->GetGameInstance() ==
              engine.Engine->GameInstance);
        CHECK(engine.Engine->GameInstance->GetFirstGamePlayer()->GetSubsystem<UJournalLocalPlayerSubsystem>());

        UWorld* preview = UWorld::CreateWorld(EWorldType::GamePreview, false);
        CHECK(preview->GetSubsystem<UADependentWorldSubsystem>() == nullptr); // not for this type of world
        preview->DestroyWorld(false);
        CHECK(FTestJournal::Take() == TEXT(""));

        engine.BeginPlay();
        CHECK(FTestJournal::Take() == TEXT("WorldBeginPlay"));
        UJournalTickingSubsystem* ticking = engine.World->GetSubsystem<UJournalTickingSubsystem>();
        engine.Tick(0.25f);
        CHECK(ticking->TickedSeconds == 0.25);
        engine.Player()->SetPause(true);
        engine.Tick(0.25f);
        CHECK(ticking->TickedSeconds == 0.25);
        CollectGarbage(GARBAGE_COLLECTION_KEEPFLAGS, true);
        CHECK(engine.World->GetSubsystem<UJournalTickingSubsystem>() == ticking);
        FTestJournal::Take();
    }
    CHECK(FTestJournal::Take() == TEXT("Dependent- Ticking- LocalPlayer- GameInstance- Engine-"));
}

TEST_CASE_FIXTURE(EngineFixture, "timers: once, looping, paused, cleared, next tick") {
    BeginPlay();
    FTimerManager& timers = World->GetTimerManager();
    int once = 0, loop = 0, next = 0;
    FTimerHandle once_handle, loop_handle;
    timers.SetTimer(once_handle, [&] { ++once; }, 0.5f, false);
    timers.SetTimer(loop_handle, FTimerDelegate::CreateLambda([&] { ++loop; }), 0.25f, true, 0.0625f);
    timers.SetTimerForNextTick([&] { ++next; });
    CHECK(timers.TimerExists(once_handle));
    CHECK(timers.GetTimerRate(loop_handle) == 0.25f);
    Tick(0.125f); // set before this frame's tick: its time does not count
    CHECK(next == 1);
    CHECK(loop == 0);
    Tick(0.125f);
    CHECK(loop == 1);
    CHECK(timers.GetTimerRemaining(once_handle) == doctest::Approx(0.375f));
    CHECK(timers.GetTimerElapsed(once_handle) == doctest::Approx(0.125f));
    Tick(0.375f);
    CHECK(once == 0); // strictly past its time
    Tick(0.125f);
    CHECK(once == 1);
    CHECK_FALSE(timers.TimerExists(once_handle));
    CHECK(loop == 3); // 0.0625, 0.3125, 0.5625
    timers.PauseTimer(loop_handle);
    CHECK(timers.IsTimerPaused(loop_handle));
    Tick(0.4f);
    CHECK(loop == 3);
    timers.UnPauseTimer(loop_handle);
    Tick(0.4f);
    Tick(0.4f);
    CHECK(loop >= 4);
    timers.ClearTimer(loop_handle);
    CHECK_FALSE(loop_handle.IsValid());
    const int loops = loop;
    Tick(0.4f);
    CHECK(loop == loops);
    CHECK(next == 1);
}

TEST_CASE_FIXTURE(EngineFixture, "timers: bound to objects, cleared from inside, world paused") {
    BeginPlay();
    FTimerManager& timers = World->GetTimerManager();
    AJournalActor* actor = World->SpawnActor<AJournalActor>();
    actor->SetActorTickEnabled(false);
    actor->Journal->SetComponentTickEnabled(false);
    FTimerHandle native, dynamic, self_clearing;
    timers.SetTimer(native, actor, &AJournalActor::HandleTimer, 0.1f, true);
    FTimerDynamicDelegate delegate;
    delegate.BindUFunction(actor, FName(TEXT("HandleTimer")));
    timers.SetTimer(dynamic, delegate, 0.1f, false);
    CHECK(timers.K2_FindDynamicTimerHandle(delegate) == dynamic);
    int cleared = 0;
    timers.SetTimer(
        self_clearing,
        [&] {
            ++cleared;
            timers.ClearTimer(self_clearing);
        },
        0.05f, true);
    FTestJournal::Take();
    Tick(0.1f);
    Tick(0.15f);
    CHECK(FTestJournal::Take() == TEXT("Timer Timer"));
    CHECK(cleared == 1);
    Player()->SetPause(true);
    Tick(0.3f);
    CHECK(FTestJournal::Take() == TEXT(""));
    Player()->SetPause(false);
    actor->Destroy();
    FTestJournal::Take();
    Tick(0.3f);
    CHECK(FTestJournal::Take() == TEXT(""));
    CHECK_FALSE(timers.TimerExists(native));
}

namespace {

struct CountdownAction : FPendingLatentAction {
    float remaining;
    FLatentActionInfo info;
    int* aborted;
    CountdownAction(float seconds, const FLatentActionInfo& in_info, int* in_aborted)
        : remaining(seconds), info(in_info), aborted(in_aborted) {}
    void UpdateOperation(FLatentResponse& response) override {
        remaining -= response.ElapsedTime();
        response.FinishAndTriggerIf(remaining <= 0.0f, info.ExecutionFunction, info.Linkage, info.CallbackTarget.Get());
    }
    void NotifyActionAborted() override { ++*aborted; }
};

} // namespace

TEST_CASE_FIXTURE(
    EngineFixture, "latent actions: complete frames later through the function named, once per UUID, abortable") {
    BeginPlay();
    FLatentActionManager& manager = World->GetLatentActionManager();
    TStrongObjectPtr<ULatentTarget> target(NewObject<ULatentTarget>());
    int aborted = 0;
    const FLatentActionInfo info(7, 1, TEXT("Resume"), target.Get());
    CHECK(manager.FindExistingAction<CountdownAction>(target.Get(), 1) == nullptr);
    manager.AddNewAction(target.Get(), 1, new CountdownAction(0.5f, info, &aborted));
    CHECK(manager.FindExistingAction<CountdownAction>(target.Get(), 1) != nullptr);
    CHECK(manager.GetNumActionsForObject(target.Get()) == 1);
    Tick(0.25f);
    CHECK(target->CallCount == 0);
    Tick(0.3f);
    CHECK(target->CallCount == 1);
    CHECK(target->LastLinkage == 7);
    CHECK(manager.GetNumActionsForObject(target.Get()) == 0);
    Tick(0.3f);
    CHECK(target->CallCount == 1);

    manager.AddNewAction(target.Get(), 2, new CountdownAction(0.1f, info, &aborted));
    Player()->SetPause(true);
    Tick(0.3f);
    CHECK(target->CallCount == 1); // paused
    Player()->SetPause(false);
    manager.RemoveActionsForObject(target.Get());
    CHECK(aborted == 1);
    Tick(0.3f);
    CHECK(target->CallCount == 1);
}

TEST_CASE("world delegates: in order, with their world") {
    TArray<FString> events;
    UWorld* seen = nullptr;
    const auto add = [&](const TCHAR* name) {
        return [&events, &seen, name](UWorld* world) {
            events.Add(name);
            seen = world;
        };
    };
    const FDelegateHandle post_initialization = FWorldDelegates::OnPostWorldInitialization.AddLambda(
        [on_event = add(TEXT("PostInitialization"))](
            UWorld* world, const UWorld::InitializationValues) { on_event(world); });
    const FDelegateHandle initialized = FWorldDelegates::OnWorldInitializedActors.AddLambda(
        [on_event = add(TEXT("InitializedActors"))](
            const FActorsInitializedParams& parameters) { on_event(parameters.World); });
    const FDelegateHandle tear_down = FWorldDelegates::OnWorldBeginTearDown.AddLambda(add(TEXT("BeginTearDown")));
    const FDelegateHandle cleanup = FWorldDelegates::OnWorldCleanup.AddLambda(
        [on_event = add(TEXT("Cleanup"))](UWorld* world, bool, bool) { on_event(world); });
    UWorld* world = nullptr;
    {
        EngineFixture engine;
        world = engine.World;
        CHECK(seen == world);
        engine.World->OnWorldBeginPlay.AddLambda([&] { events.Add(TEXT("BeginPlay")); });
        engine.BeginPlay();
    }
    CHECK(seen == world);
    CHECK(FString::Join(events, TEXT(" ")) ==
          TEXT("PostInitialization InitializedActors BeginPlay BeginTearDown Cleanup"));
    FWorldDelegates::OnPostWorldInitialization.Remove(post_initialization);
    FWorldDelegates::OnWorldInitializedActors.Remove(initialized);
    FWorldDelegates::OnWorldBeginTearDown.Remove(tear_down);
    FWorldDelegates::OnWorldCleanup.Remove(cleanup);
}

TEST_CASE_FIXTURE(EngineFixture, "world: what it is") {
    CHECK(World->IsGameWorld());
    CHECK_FALSE(World->IsEditorWorld());
    CHECK_FALSE(World->IsPreviewWorld());
    CHECK(World->GetNetMode() == NM_Standalone);
    CHECK(World->GetWorld() == World);
    CHECK(Engine->GetWorldContextFromWorld(World) != nullptr);
    CHECK(Engine->GetWorldContexts().Num() == 1);
    CHECK(World->GetGravityZ() == -980.0f);
    CHECK_FALSE(World->HasBegunPlay());
    BeginPlay();
    CHECK(World->HasBegunPlay());
    AActor* actor = World->SpawnActor<AJournalActor>();
    CHECK(Engine->GetWorldFromContextObject(actor, EGetWorldErrorMode::ReturnNull) == World);
    CHECK(Engine->GetWorldFromContextObject(GetTransientPackage(), EGetWorldErrorMode::LogAndReturnNull) == nullptr);
    CHECK(AJournalActor::StaticClass()->GetDefaultObject()->GetWorld() == nullptr);
    CHECK(Engine->GetFirstGamePlayer(World) == Engine->GameInstance->GetFirstGamePlayer());
}

TEST_CASE_FIXTURE(EngineFixture, "maps: a new world replaces the old one; an unknown map leaves it") {
    BeginPlay();
    FWorldContext& context = *Engine->GameInstance->GetWorldContext();
    TWeakObjectPtr<UWorld> old_world = World;
    FString error;
    CHECK_FALSE(
        Engine->LoadMap(context, FURL(nullptr, TEXT("no_such_scene_anywhere"), TRAVEL_Absolute), nullptr, error));
    CHECK(error.Contains(TEXT("no_such_scene_anywhere")));
    CHECK(context.World() == World);

    CHECK(Engine->LoadMap(
        context, FURL(nullptr, TEXT("/Engine/Maps/Entry?Colour=Red"), TRAVEL_Absolute), nullptr, error));
    CHECK(error.IsEmpty());
    UWorld* entry = context.World();
    CHECK_FALSE(old_world.IsValid());
    CHECK(entry->GetPathName() == TEXT("/Engine/Maps/Entry.Entry"));
    CHECK(entry->GetMapName() == TEXT("Entry"));
    CHECK(entry->HasBegunPlay());
    CHECK(FString(entry->URL.GetOption(TEXT("colour="), TEXT(""))) == TEXT("Red"));
    CHECK(entry->GetFirstPlayerController() == Engine->GetFirstLocalPlayerController(entry));

    TWeakObjectPtr<UWorld> weak_entry = entry;
    Engine->SetClientTravel(entry, TEXT("/Engine/Maps/Entry"), TRAVEL_Absolute);
    Tick(0.1f);
    CHECK_FALSE(weak_entry.IsValid());
    CHECK(context.World()->GetPathName() == TEXT("/Engine/Maps/Entry.Entry")); // same path, new world
    World = context.World();
}

TEST_CASE("url: parsed, options without case") {
    FURL url(nullptr, TEXT("/Game/Scenes/apartment?game=/Script/Engine.GameModeBase?listen#Door"), TRAVEL_Absolute);
    CHECK(url.Map == TEXT("/Game/Scenes/apartment"));
    CHECK(url.Portal == TEXT("Door"));
    CHECK(url.HasOption(TEXT("LISTEN")));
    CHECK(FString(url.GetOption(TEXT("Game="), TEXT(""))) == TEXT("/Script/Engine.GameModeBase"));
    CHECK(FString(url.GetOption(TEXT("none="), TEXT("default"))) == TEXT("default"));
    CHECK(url.ToString() == TEXT("/Game/Scenes/apartment?game=/Script/Engine.GameModeBase?listen#Door"));
    FURL next(&url, TEXT("?listen=2"), TRAVEL_Relative);
    CHECK(next.Map == url.Map);
    CHECK(FString(next.GetOption(TEXT("listen="), TEXT(""))) == TEXT("2"));
    CHECK_FALSE(static_cast<bool>(FURL(nullptr, TEXT(""), TRAVEL_Absolute).Valid));
}

TEST_CASE_FIXTURE(EngineFixture, "console commands") {
    BeginPlay();
    FStringOutputDevice output;
    CHECK(Engine->Exec(World, TEXT("slomo 0.5"), output));
    CHECK(World->GetWorldSettings()->TimeDilation == 0.5f);
    CHECK(Engine->Exec(World, TEXT("pause"), output));
    CHECK(World->IsPaused());
    CHECK(Engine->Exec(World, TEXT("PAUSE"), output));
    CHECK_FALSE(World->IsPaused());
    CHECK(Engine->Exec(World, TEXT("t.MaxFPS 75"), output));
    CHECK(Engine->GetMaxFPS() == 75.0f);
    CHECK(Engine->Exec(World, TEXT("t.MaxFPS 0"), output));
    output.Empty();
    CHECK(Engine->Exec(World, TEXT("obj list class=PlayerController"), output));
    CHECK(output.Contains(TEXT("PlayerController")));
    output.Empty();
    CHECK(Engine->Exec(World, TEXT("stat actors"), output));
    CHECK(output.Contains(TEXT("WorldSettings")));
    CHECK_FALSE(Engine->Exec(World, TEXT("no.such.command"), output));
    CHECK(Player()->ConsoleCommand(TEXT("slomo"), false).Contains(TEXT("0.5")));
    Engine->DeferCommand(TEXT("slomo 2"));
    Tick(0.1f);
    CHECK(World->GetWorldSettings()->TimeDilation == 2.0f);
}

TEST_CASE_FIXTURE(EngineFixture, "frame delegates: begin before the world's tick, end after it") {
    BeginPlay();
    TArray<FString> events;
    const FDelegateHandle begin = FCoreDelegates::OnBeginFrame.AddLambda([&] { events.Add(TEXT("begin")); });
    const FDelegateHandle end = FCoreDelegates::OnEndFrame.AddLambda([&] { events.Add(TEXT("end")); });
    const FDelegateHandle tick =
        FWorldDelegates::OnWorldPreActorTick.AddLambda([&](UWorld*, ELevelTick, float) { events.Add(TEXT("tick")); });
    Tick(0.1f);
    CHECK(FString::Join(events, TEXT(" ")) == TEXT("begin tick end"));
    FCoreDelegates::OnBeginFrame.Remove(begin);
    FCoreDelegates::OnEndFrame.Remove(end);
    FWorldDelegates::OnWorldPreActorTick.Remove(tick);
}
