// SPDX-License-Identifier: MIT
// The guarantees G1 to G10 of the programming model, as a client sees them.
#include <atomic>
#include <csignal>
#include <thread>
#include <vector>

#include "engine_fixture.hpp"

using namespace end_to_end;

TEST_CASE("G1: begin work and end work of a transaction run in the same frame, with the world's tick in between") {
    Client client;
    const spear::Class statics = client.game.get_class("UGameplayStatics");
    for (int i = 0; i < 5; ++i) {
        spear::Future<double> time_at_begin, time_at_end;
        client.transact([&] { time_at_begin = statics.async<double>("GetTimeSeconds"); },
            [&] { time_at_end = statics.async<double>("GetTimeSeconds"); });
        CHECK(time_at_end.get() - time_at_begin.get() == doctest::Approx(fixed_dt).epsilon(1e-3));
        CHECK(frame_of(time_at_begin) == frame_of(time_at_end));
    }
}

TEST_CASE("G1: work runs in program order, synchronous and asynchronous operations alike") {
    Client client;
    spear::Object actor;
    std::vector<spear::Future<FVector>> reads;
    client.transact([&] {
        actor = client.spawn();
        for (int i = 0; i < 10; ++i) {
            actor.send("K2_SetActorLocation", arg("NewLocation", FVector{double(i), 0, 0}), arg("bSweep", false),
                arg("bTeleport", true));
            reads.push_back(actor.async<FVector>("K2_GetActorLocation"));
            if (i == 5)
                CHECK(actor.call<FVector>("K2_GetActorLocation").X == 5);
        }
        client.game.send().destroy_actor(actor);
    });
    for (int i = 0; i < 10; ++i)
        CHECK(reads[static_cast<std::size_t>(i)].get().X == i);
}

TEST_CASE("G2: single_step holds the engine at the beginning of the next frame; without it frames go on") {
    Client client;
    std::uint64_t last = 0;
    for (int i = 0; i < 5; ++i) {
        spear::Future<spear::Class> any;
        client.transact([&] { any = client.game.async().get_class("AActor"); }, nullptr, {.single_step = true});
        const std::uint64_t now = frame_of(any);
        if (i != 0)
            CHECK(now == last + 1);
        last = now;
    }
    client.instance.flush();
    std::this_thread::sleep_for(50ms);
    const std::uint64_t held = client.frame_number();
    CHECK(held == last + 1);
    CHECK_FALSE(client.frames_go_on());
    client.transact(nullptr);
    CHECK(client.frames_go_on());
}

TEST_CASE("G2 G9: step(n) advances exactly n frames of exactly the fixed time") {
    Client client;
    const spear::Class statics = client.game.get_class("UGameplayStatics");
    const spear::Class system = client.game.get_class("UKismetSystemLibrary");
    struct Moment {
        double time = 0;
        std::int64_t frame = 0;
    };
    // Asked on the game thread, in a frame that this client holds: the server thread's counter may be a frame behind.
    const auto now = [&] {
        Moment moment;
        client.transact(
            [&] {
                moment.time = statics.call<double>("GetTimeSeconds");
                moment.frame = system.call<std::int64_t>("GetFrameCount");
            },
            nullptr, {.single_step = true});
        return moment;
    };
    const Moment start = now();
    client.instance.step(7);
    const Moment end = now();
    CHECK(end.frame - start.frame == 8); // seven steps, and the frame of the first transaction
    CHECK(end.time - start.time == doctest::Approx(8 * fixed_dt).epsilon(1e-3));
    client.transact(nullptr);
}

TEST_CASE("G3: a synchronous operation has run when it returns") {
    Client client;
    client.transact([&] {
        const spear::Object actor = client.spawn({1, 2, 3});
        CHECK(actor.call<FVector>("K2_GetActorLocation") == FVector{1, 2, 3});
        CHECK(actor.call<bool>("K2_SetActorLocation", FVector{4, 5, 6}, false, arg("bTeleport", true)) == true);
        CHECK(actor.call<FVector>("K2_GetActorLocation") == FVector{4, 5, 6});
        CHECK(client.game.destroy_actor(actor));
    });
}

TEST_CASE("G4: opening a block holds nothing; its first synchronous operation does, until the block closes") {
    Client client;
    {
        auto frame = client.instance.begin_frame();
        CHECK(client.frames_go_on());
        const auto recorded = client.game.async().get_class("AActor");
        CHECK(client.frames_go_on());
        CHECK_FALSE(recorded.is_ready());
        client.game.get_class("APawn");
        CHECK(recorded.is_ready()); // sent with it, and run before it
        CHECK_FALSE(client.frames_go_on());
        frame.execute();
    }
    CHECK_FALSE(client.frames_go_on()); // the game thread waits at the end of that frame for the end block
    {
        auto frame = client.instance.end_frame();
        const auto future = client.game.async().get_class("AActor");
        CHECK(future.get().class_name() == "UClass"); // get() of a future of this block holds as well
        CHECK_FALSE(client.frames_go_on());
        frame.execute();
    }
    CHECK(client.frames_go_on());
}

TEST_CASE("G5: transactions of asynchronous operations do not stop the engine") {
    Client client;
    spear::Object actor;
    client.transact([&] { actor = client.spawn(); });
    std::vector<spear::Future<FVector>> reads;
    for (int i = 0; i < 50; ++i) {
        client.transact([&] { reads.push_back(actor.async<FVector>("K2_GetActorLocation")); },
            [&] { actor.send("K2_AddActorWorldOffset", FVector{1, 0, 0}, false, arg("bTeleport", true)); });
    }
    client.instance.flush();
    for (int i = 0; i < 50; ++i)
        CHECK(reads[static_cast<std::size_t>(i)].get().X == i);
    for (std::size_t i = 1; i < 50; ++i)
        CHECK(frame_of(reads[i]) > frame_of(reads[i - 1]));
    CHECK(client.frames_go_on());
}

TEST_CASE("G6: a failing operation raises, the frame closes, later operations run, the engine goes on") {
    Client client;
    spear::Future<FVector> bad, good;
    spear::Object actor;
    client.transact([&] {
        actor = client.spawn({1, 0, 0});
        CHECK_THROWS_AS(actor.call("NoSuchFunction"), spear::UnknownFunction);
        bad = actor.async<FVector>("NoSuchFunctionEither");
        good = actor.async<FVector>("K2_GetActorLocation");
    });
    CHECK_THROWS_AS(bad.get(), spear::UnknownFunction);
    CHECK(good.get().X == 1);
    CHECK(client.frames_go_on());
}

TEST_CASE("G6: fire-and-forget failures are reported at the latest by flush, with type and names") {
    Client client;
    const auto run = [&] {
        client.transact([&] {
            client.game.get_class("AActor"); // holds: execute() then waits for the failure
            client.game.send().find_actor_by_name("NoSuchActor_1");
            client.game.send().find_actor_by_name("NoSuchActor_2");
        });
        client.instance.flush();
    };
    const std::string text = error_text<spear::UnknownObject>(run);
    CHECK(contains(text, "NoSuchActor_1"));
    CHECK(contains(text, "1 more"));
    CHECK_NOTHROW(client.transact(nullptr));
    CHECK(client.frames_go_on());
}

TEST_CASE(
    "a block left by an exception runs what was recorded, closes the transaction, and lets the exception through") {
    Client client;
    spear::Object actor;
    client.transact([&] { actor = client.spawn(); });
    SUBCASE("in a block that holds the game thread") {
        CHECK_THROWS_WITH(client.transact([&] {
            actor.call<FVector>("K2_GetActorLocation");
            actor.send("K2_SetActorLocation", FVector{9, 0, 0}, false, arg("bTeleport", true));
            throw std::runtime_error("the user's");
        }),
            "the user's");
    }
    SUBCASE("in an asynchronous block") {
        CHECK_THROWS_WITH(client.transact([&] {
            actor.send("K2_SetActorLocation", FVector{9, 0, 0}, false, arg("bTeleport", true));
            throw std::runtime_error("the user's");
        }),
            "the user's");
    }
    SUBCASE("in the end block") {
        CHECK_THROWS_WITH(client.transact(nullptr,
                              [&] {
                                  actor.send("K2_SetActorLocation", FVector{9, 0, 0}, false, arg("bTeleport", true));
                                  throw std::runtime_error("the user's");
                              }),
            "the user's");
    }
    CHECK(client.frames_go_on());
    client.transact([&] { CHECK(actor.call<FVector>("K2_GetActorLocation").X == 9); });
}

TEST_CASE("G7: a client that dies, hangs or closes in the middle of a block does not freeze the engine") {
    Client client;
    int child = 0;
    SUBCASE("dies within a begin block") { child = start_child("die"); }
    SUBCASE("dies between its blocks") { child = start_child("between"); }
    SUBCASE("hangs past its lease") { child = start_child("hang"); }
    SUBCASE("closes") {
        Client other;
        auto frame = other.instance.begin_frame();
        other.game.get_class("AActor");
        other.instance.close();
        CHECK_THROWS_AS(frame.execute(), spear::Disconnected);
    }
    const auto start = std::chrono::steady_clock::now();
    client.transact([&] { client.game.get_class("AActor"); });
    CHECK(std::chrono::steady_clock::now() - start < 3s);
    CHECK(client.frames_go_on());
    if (child != 0) {
        ::kill(child, SIGKILL);
        wait_for_child(child);
    }
}

TEST_CASE("G8: futures are arguments of later operations, in any position, without a round trip") {
    Client client;
    spear::Future<FVector> location, through_property;
    spear::Future<spear::Object> spawned;
    client.transact(
        [&] {
            const auto game = client.game.async();
            spawned = game.spawn_actor(
                spear::ClassReference(game.get_class("ACameraActor")), {.location = {1, 2, 3}}); // class
            location = spawned.async<FVector>("K2_GetActorLocation");                            // self
            const auto second = game.spawn_actor("ACameraActor");
            second.send("K2_SetActorLocation", arg("NewLocation", location), arg("bSweep", false),
                arg("bTeleport", true)); // argument
            const auto root = second["RootComponent"].async_get<spear::Object>();
            root["RelativeScale3D"].send_set(location);                      // value
            through_property = root["RelativeScale3D"].async_get<FVector>(); // owner
            game.destroy_actor(second);
        },
        [&] { client.game.send().destroy_actor(spawned); });
    CHECK(location.get() == FVector{1, 2, 3});
    CHECK(through_property.get() == FVector{1, 2, 3});
}

TEST_CASE("G8: an operation whose argument failed raises DependencyFailed with the original error") {
    Client client;
    spear::Future<FVector> location;
    client.transact([&] {
        location = client.game.async().find_actor_by_name("NoSuchActor").async<FVector>("K2_GetActorLocation");
    });
    try {
        location.get();
        FAIL_CHECK("no error");
    } catch (const spear::DependencyFailed& error) {
        REQUIRE(error.original());
        CHECK(error.original()->code == spear::ErrorCode::UnknownObject);
    }
}

TEST_CASE("G9: a paused world stepped with a fixed step gives the same bits in every engine") {
    const auto fly = [] {
        spear::Instance instance = spear::launch(launch_options());
        const spear::Game game = instance.game();
        std::vector<FVector> path;
        spear::Object ball;
        instance.step(1);
        {
            auto frame = instance.begin_frame();
            ball = game.spawn_actor("ACameraActor", {.location = {0, 0, 200}});
            const auto motion = ball.call<spear::Object>("AddComponentByClass",
                arg("Class", game.get_class("UProjectileMovementComponent")), arg("bManualAttachment", false),
                arg("RelativeTransform", unreal::FTransform{}), arg("bDeferredFinish", false));
            motion["Velocity"].set(FVector{300, 10, 400});
            frame.execute();
        }
        instance.end_frame({.single_step = true}).execute();
        for (int i = 0; i < 30; ++i) {
            auto begin = instance.begin_frame();
            path.push_back(ball.call<FVector>("K2_GetActorLocation"));
            begin.execute();
            instance.end_frame({.single_step = true}).execute();
        }
        return path;
    };
    const std::vector<FVector> first = fly();
    CHECK(first.front().X > 0);
    CHECK(first.back().X > first.front().X);
    CHECK(first == fly());
}

TEST_CASE("G10: between transactions the engine ticks, also while the world is paused") {
    Client client;
    const spear::Class statics = client.game.get_class("UGameplayStatics");
    client.transact([&] { statics.call("SetGamePaused", true); });
    CHECK(client.frames_go_on());
    client.transact([&] { CHECK(statics.call<bool>("IsGamePaused")); });
    client.transact([&] { statics.call("SetGamePaused", false); });
}

TEST_CASE("blocks: order, nesting, threads") {
    Client client;
    spear::Object actor;
    client.transact([&] { actor = client.spawn(); });
    CHECK_THROWS_AS(actor.call("K2_GetActorLocation"), spear::NotInFrame);
    CHECK_THROWS_AS((void)client.instance.end_frame(), spear::FrameMisuse);
    auto frame = client.instance.begin_frame();
    CHECK_THROWS_AS((void)client.instance.begin_frame(), spear::FrameMisuse);
    CHECK_THROWS_AS((void)client.instance.end_frame(), spear::FrameMisuse);
    std::thread([&] {
        CHECK_THROWS_AS(actor.call("K2_GetActorLocation"), spear::WrongThread);
        CHECK_THROWS_AS((void)client.instance.begin_frame(), spear::WrongThread);
        CHECK(client.game.get_class("AActor").derives_from("UClass") ==
              client.game.get_class("AActor").derives_from("UClass"));              // runs in any frame
        CHECK(client.instance.call(spear::engine_service::ping, "text") == "text"); // on the server thread
    }).join();
    frame.execute();
    CHECK_THROWS_AS((void)client.instance.begin_frame(), spear::FrameMisuse);
    client.instance.end_frame().execute();
}

TEST_CASE("get() works from any thread") {
    Client client;
    spear::Future<spear::Object> future;
    auto frame = client.instance.begin_frame();
    future = client.game.async().spawn_actor("ACameraActor");
    std::thread other([&] { CHECK_FALSE(future.get().is_null()); });
    std::this_thread::sleep_for(20ms);
    frame.execute();
    other.join();
    client.instance.end_frame().execute();
}

TEST_CASE("two clients share frames; while one holds the engine by single_step, the other is told") {
    Client one({.client_name = "the holder", .deadline = 10s});
    Client two({.deadline = 300ms});
    spear::Future<spear::Class> first, second;
    {
        auto a = one.instance.begin_frame();
        first = one.game.async().get_class("AActor");
        auto b = two.instance.begin_frame();
        second = two.game.async().get_class("AActor");
        a.execute();
        b.execute();
    }
    one.instance.end_frame().execute();
    two.instance.end_frame().execute();
    CHECK_FALSE(first.get().is_null());
    CHECK_FALSE(second.get().is_null());

    one.transact(nullptr, nullptr, {.single_step = true});
    one.instance.flush();
    const std::string text = error_text<spear::HeldByClient>([&] { two.transact([&] { two.spawn(); }); });
    CHECK(contains(text, "the holder"));
    one.transact(nullptr);
    two.instance.session()->set_deadline(10s);
    CHECK_NOTHROW(two.transact([&] { two.spawn(); }));
}

TEST_CASE("NeedsFrames: a latent function's result cannot be had while this client holds the engine") {
    Client client;
    const spear::Class system = client.game.get_class("UKismetSystemLibrary");
    spear::Future<void> delay;
    client.transact(
        [&] {
            delay = system.async<void>("Delay", arg("Duration", 0.05));
            client.game.get_class("AActor"); // holds the engine
            CHECK_THROWS_AS(delay.get(), spear::NeedsFrames);
        },
        nullptr, {.single_step = true});
    CHECK_THROWS_AS(delay.get(), spear::NeedsFrames);
    client.transact(nullptr);
    CHECK_NOTHROW(delay.get());
}
