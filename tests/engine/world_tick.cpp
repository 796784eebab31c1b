// SPDX-License-Identifier: MIT
// The order of ticks, pause, time.
#include "engine_fixture.h"

#include "GameFramework/GameModeBase.h"
#include "WorldTestTypes.h"

namespace {

// A tick function that writes its name down.
struct NamedTick : FTickFunction {
    FString name;
    TArray<FString>* order = nullptr;
    float last_delta = 0.0f;
    TFunction<void()> action;

    NamedTick(const TCHAR* in_name, TArray<FString>& in_order, ETickingGroup group) : name(in_name), order(&in_order) {
        bCanEverTick = true;
        TickGroup = group;
    }
    void ExecuteTick(float delta, ELevelTick, ENamedThreads::Type, const FGraphEventRef&) override {
        order->Add(name);
        last_delta = delta;
        if (action) {
            action();
        }
    }
};

struct Ticks : EngineFixture {
    TArray<FString> order;

    Ticks() { BeginPlay(); }
    void add(NamedTick& function) { function.RegisterTickFunction(World->PersistentLevel); }
    FString frame(float seconds = 0.0625f) {
        order.Reset();
        Tick(seconds);
        return FString::Join(order, TEXT(" "));
    }
};

} // namespace

TEST_CASE_FIXTURE(Ticks, "tick: groups run in order, inside a group in the order of registration") {
    NamedTick last(TEXT("last"), order, TG_LastDemotable), post(TEXT("post"), order, TG_PostPhysics),
        pre_b(TEXT("pre_b"), order, TG_PrePhysics);
    NamedTick during(TEXT("during"), order, TG_DuringPhysics), update(TEXT("update"), order, TG_PostUpdateWork),
        pre_a(TEXT("pre_a"), order, TG_PrePhysics);
    for (NamedTick* function : {&last, &post, &pre_b, &during, &update, &pre_a}) {
        add(*function);
    }
    CHECK(frame() == TEXT("pre_b pre_a during post update last"));
    CHECK(frame() == TEXT("pre_b pre_a during post update last"));
    pre_b.UnRegisterTickFunction();
    during.SetTickFunctionEnable(false);
    CHECK(frame() == TEXT("pre_a post update last"));
    during.SetTickFunctionEnable(true);
    during.TickGroup = TG_PrePhysics;
    CHECK(frame() == TEXT("during pre_a post update last"));
}

TEST_CASE_FIXTURE(Ticks, "tick: prerequisites run first, and drag into later groups") {
    NamedTick a(TEXT("a"), order, TG_PrePhysics), b(TEXT("b"), order, TG_PrePhysics),
        c(TEXT("c"), order, TG_PostPhysics);
    for (NamedTick* function : {&a, &b, &c}) {
        add(*function);
    }
    a.AddPrerequisite(World, b);
    CHECK(frame() == TEXT("b a c"));
    b.AddPrerequisite(World, c); // b cannot start before c, so a cannot either
    CHECK(frame() == TEXT("c b a"));
    CHECK(a.GetActualTickGroup() == TG_PostPhysics);
    c.AddPrerequisite(World, a); // a cycle: broken somewhere, but everything still runs once
    frame();
    CHECK(order.Num() == 3);
    c.RemovePrerequisite(World, a);
    b.RemovePrerequisite(World, c);
    a.RemovePrerequisite(World, b);
    CHECK(frame() == TEXT("a b c"));
}

TEST_CASE_FIXTURE(Ticks, "tick: high priority first; interval ticks keep their pace") {
    NamedTick normal(TEXT("n"), order, TG_PrePhysics), high(TEXT("h"), order, TG_PrePhysics),
        slow(TEXT("s"), order, TG_PrePhysics);
    slow.TickInterval = 0.25f;
    for (NamedTick* function : {&normal, &high, &slow}) {
        add(*function);
    }
    high.SetPriorityIncludingPrerequisites(true);
    CHECK(frame() == TEXT("h n s"));
    for (int repeat = 0; repeat < 3; ++repeat) {
        CHECK(frame() == TEXT("h n"));
        CHECK(frame() == TEXT("h n"));
        CHECK(frame() == TEXT("h n"));
        CHECK(frame() == TEXT("h n s"));
        CHECK(slow.last_delta == doctest::Approx(0.25f));
    }
}

TEST_CASE_FIXTURE(Ticks, "tick: what is registered during a frame still runs in it") {
    NamedTick later(TEXT("later"), order, TG_PostPhysics), passed(TEXT("passed"), order, TG_PrePhysics),
        first(TEXT("first"), order, TG_DuringPhysics);
    first.action = [&] {
        if (!later.IsTickFunctionRegistered()) {
            add(passed); // its group is over: runs at the end of this one
            add(later);
        }
    };
    add(first);
    CHECK(frame() == TEXT("first passed later"));
    CHECK(frame() == TEXT("passed first later"));
    first.action = [&] { later.UnRegisterTickFunction(); };
    CHECK(frame() == TEXT("passed first"));
}

TEST_CASE_FIXTURE(Ticks, "tick: a destroyed object's tick function is gone") {
    {
        NamedTick temporary(TEXT("x"), order, TG_PrePhysics);
        add(temporary);
        CHECK(frame() == TEXT("x"));
    }
    CHECK(frame() == TEXT(""));
}

TEST_CASE_FIXTURE(Ticks, "time: world time is the sum of the steps, exactly; limits and dilation") {
    AJournalActor* actor = World->SpawnActor<AJournalActor>();
    for (int step = 0; step < 100; ++step) {
        Tick(1.0f / 64.0f);
    }
    CHECK(World->GetTimeSeconds() == 100.0 / 64.0);
    CHECK(World->GetRealTimeSeconds() == 100.0 / 64.0);
    CHECK(actor->TickCount == 100);
    CHECK(actor->TickedSeconds == 100.0 / 64.0);

    Tick(3.0f); // a long frame counts 0.4 s of game time
    CHECK(World->GetDeltaSeconds() == doctest::Approx(0.4f));
    CHECK(World->GetRealTimeSeconds() == 100.0 / 64.0 + 3.0);

    World->GetWorldSettings()->SetTimeDilation(0.5f);
    actor->CustomTimeDilation = 0.5f;
    actor->TickedSeconds = 0.0;
    const double before = World->GetTimeSeconds();
    Tick(0.25f);
    CHECK(World->GetTimeSeconds() - before == doctest::Approx(0.125));
    CHECK(World->GetDeltaRealTimeSeconds() == 0.25f);
    CHECK(actor->TickedSeconds == doctest::Approx(0.0625));
    CHECK(World->GetWorldSettings()->SetTimeDilation(1000.0f) == 20.0f); // clamped
}

TEST_CASE_FIXTURE(Ticks, "pause: world time and actors stop, bTickEvenWhenPaused goes on, real time too") {
    AJournalActor* actor = World->SpawnActor<AJournalActor>();
    AJournalActor* paused_too = World->SpawnActor<AJournalActor>();
    paused_too->SetTickableWhenPaused(true);
    Tick(0.25f);
    CHECK_FALSE(World->IsPaused());
    REQUIRE(Player());
    CHECK(Player()->SetPause(true));
    CHECK(World->IsPaused());
    const double time = World->GetTimeSeconds();
    const double unpaused_time = World->GetUnpausedTimeSeconds();
    Tick(0.25f);
    Tick(0.25f);
    CHECK(World->GetTimeSeconds() == time);
    CHECK(World->GetUnpausedTimeSeconds() == unpaused_time + 0.5);
    CHECK(World->GetRealTimeSeconds() == time + 0.5);
    CHECK(actor->TickCount == 1);
    CHECK(paused_too->TickCount == 3);
    CHECK(Player()->SetPause(false));
    CHECK_FALSE(World->IsPaused());
    Tick(0.25f);
    CHECK(actor->TickCount == 2);
    CHECK(World->GetTimeSeconds() == time + 0.25);
}

TEST_CASE_FIXTURE(EngineFixture, "pause: a game mode may forbid it, and a delegate may keep it") {
    SUBCASE("forbidden") {
        World->GetWorldSettings()->DefaultGameMode = AUnpauseableGameMode::StaticClass();
        BeginPlay();
        CHECK(World->GetAuthGameMode()->IsA<AUnpauseableGameMode>());
        CHECK_FALSE(Player()->SetPause(true));
        CHECK_FALSE(World->IsPaused());
    }
    SUBCASE("kept") {
        BeginPlay();
        bool may_unpause = false;
        CHECK(Player()->SetPause(true, FCanUnpause::CreateLambda([&] { return may_unpause; })));
        CHECK_FALSE(Player()->SetPause(false));
        CHECK(World->IsPaused());
        may_unpause = true;
        CHECK(Player()->SetPause(false));
        CHECK_FALSE(World->IsPaused());
    }
}

TEST_CASE_FIXTURE(EngineFixture, "time: fixed step and frame rate limit") {
    BeginPlay();
    Engine->SetMaxFPS(0.0f);
    FApp::SetUseFixedTimeStep(true);
    FApp::SetFixedDeltaTime(0.125);
    Engine->UpdateTimeAndHandleMaxTickRate();
    const double start = FApp::GetCurrentTime();
    for (int frame = 0; frame < 8; ++frame) {
        Engine->UpdateTimeAndHandleMaxTickRate();
        CHECK(FApp::GetDeltaTime() == 0.125);
    }
    CHECK(FApp::GetCurrentTime() - start == doctest::Approx(1.0));
    FApp::SetUseFixedTimeStep(false);

    Engine->SetMaxFPS(100.0f);
    Engine->UpdateTimeAndHandleMaxTickRate();
    const double real_start = FPlatformTime::Seconds();
    for (int frame = 0; frame < 10; ++frame) {
        Engine->UpdateTimeAndHandleMaxTickRate();
        CHECK(FApp::GetDeltaTime() >= 0.0099);
    }
    CHECK(FPlatformTime::Seconds() - real_start >= 0.099);
    Engine->SetMaxFPS(0.0f);
}
