// SPDX-License-Identifier: MIT
// Blocks: G6, order and nesting, threads, exceptions of the user, results that need frames, and what may happen to objects
// between begin and end.
#include <stdexcept>
#include <string>
#include <thread>

#include "engine_fixture.hpp"

using namespace end_to_end;

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
    CHECK_THROWS_AS(client.instance.flush(), spear::FrameMisuse);
    CHECK_THROWS_AS(client.instance.step(), spear::FrameMisuse);
    frame.execute();
    CHECK_FALSE(frame.is_open());
    CHECK_THROWS_AS(frame.execute(), spear::FrameMisuse);
    CHECK_THROWS_AS((void)client.instance.begin_frame(), spear::FrameMisuse);
    CHECK_THROWS_AS(client.instance.step(), spear::FrameMisuse);
    CHECK_THROWS_AS(actor.call("K2_GetActorLocation"), spear::NotInFrame); // between the blocks
    std::thread([&] { CHECK_THROWS_AS((void)client.instance.end_frame(), spear::WrongThread); }).join();
    client.instance.end_frame().execute();
    CHECK_THROWS_AS((void)client.instance.end_frame(), spear::FrameMisuse);
    CHECK(client.frames_go_on());
}

TEST_CASE("outside of blocks, operations of the game thread raise NotInFrame in all three ways; others work") {
    Client client;
    spear::Object actor;
    client.transact([&] { actor = client.spawn(); });
    const std::string text =
        error_text<spear::NotInFrame>([&] { actor.call("K2_SetActorLocation", FVector{}, false, false); });
    CHECK(contains(text, "K2_SetActorLocation"));
    CHECK(contains(text, "begin_frame"));
    CHECK_THROWS_AS(actor.async<FVector>("K2_GetActorLocation"), spear::NotInFrame);
    CHECK_THROWS_AS(actor.send("K2_DestroyActor"), spear::NotInFrame);
    CHECK_THROWS_AS(client.game.spawn_actor("ACameraActor"), spear::NotInFrame);
    CHECK(client.instance.call(spear::engine_service::ping, "x") == "x"); // server thread
    CHECK(client.game.get_class("AActor").class_name() == "UClass");      // any frame
    client.transact([&] { CHECK(actor.call<FVector>("K2_GetActorLocation") == FVector{}); });
}

TEST_CASE("another thread has no part in an open block, in none of the three ways, and cannot close it") {
    Client client;
    spear::Object actor;
    client.transact([&] { actor = client.spawn(); });
    auto frame = client.instance.begin_frame();
    std::thread([&] {
        CHECK_THROWS_AS(actor.call("K2_GetActorLocation"), spear::WrongThread);
        CHECK_THROWS_AS(actor.async<FVector>("K2_GetActorLocation"), spear::WrongThread);
        CHECK_THROWS_AS(actor.send("K2_DestroyActor"), spear::WrongThread);
        CHECK_THROWS_AS(frame.execute(), spear::WrongThread);
    }).join();
    CHECK(frame.is_open());
    CHECK(actor.call<FVector>("K2_GetActorLocation") == FVector{}); // the block is as it was
    frame.execute();
    client.instance.end_frame().execute();
}

TEST_CASE("a block that is forgotten closes the transaction with what was recorded") {
    Client client;
    spear::Object actor;
    client.transact([&] { actor = client.spawn(); });
    {
        auto frame = client.instance.begin_frame();
        actor.send("K2_SetActorLocation", FVector{7, 0, 0}, false, arg("bTeleport", true));
    }
    {
        auto begin = client.instance.begin_frame(); // not an end_frame: that transaction is over
        CHECK(actor.call<FVector>("K2_GetActorLocation").X == 7);
        begin.execute();
        auto end = client.instance.end_frame();
    }
    client.transact(nullptr);
    CHECK(client.frames_go_on());
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

TEST_CASE("NeedsFrames: also in the end block, and for other threads while the engine is held") {
    Client client;
    const spear::Class system = client.game.get_class("UKismetSystemLibrary");
    spear::Future<void> delay;
    client.transact(
        [&] {
            delay = system.async<void>("Delay", arg("Duration", 0.05));
            client.game.get_class("AActor"); // holds the engine
            const std::string text = error_text<spear::NeedsFrames>([&] { delay.get(); });
            CHECK(contains(text, "Delay"));
            std::thread([&] { CHECK_THROWS_AS(delay.get(50ms), spear::NeedsFrames); }).join();
        },
        [&] { CHECK_THROWS_AS(delay.get(), spear::NeedsFrames); });
    CHECK_NOTHROW(delay.get()); // the engine goes on
}

TEST_CASE("a garbage collection between begin and end of a frame") {
    Client client;
    const spear::Class system = client.game.get_class("UKismetSystemLibrary");
    spear::Object doomed, kept, released;
    spear::Future<spear::Object> future;
    spear::Future<std::string> before, after, in_vain;
    client.transact(
        [&] {
            doomed = client.spawn();
            future = client.game.async().spawn_actor("ACameraActor");
            kept = client.game.new_object("URoundTripCalls");
            released = client.game.new_object("URoundTripCalls");
            before = kept.async<std::string>("WhoAmI");
            client.game.destroy_actor(doomed);
            future.send("K2_DestroyActor");
            client.game.release_object(released);
            system.call("CollectGarbage"); // in this frame, after the world's tick
        },
        [&] {
            CHECK_THROWS_AS(doomed.call("K2_GetActorLocation"), spear::StaleObject);
            CHECK_THROWS_AS(future.call("K2_GetActorLocation"), spear::StaleObject);
            CHECK_THROWS_AS(released.call("WhoAmI"), spear::StaleObject);
            CHECK_FALSE(doomed.is_valid());
            after = kept.async<std::string>("WhoAmI"); // the session keeps it alive
            in_vain = released.async<std::string>("WhoAmI");
        });
    CHECK(after.get() == "parent");
    CHECK_THROWS_AS(in_vain.get(), spear::StaleObject);
    CHECK(frame_of(before) == frame_of(after));
}

TEST_CASE("a garbage collection in the middle of a block") {
    Client client;
    client.transact([&] {
        const spear::Object kept = client.game.new_object("URoundTripCalls");
        const spear::Object released = client.game.new_object("URoundTripCalls");
        client.game.release_object(released);
        CHECK_NOTHROW(released.call("WhoAmI")); // lingers, as in Unreal
        kept.call("CollectNow");
        CHECK_THROWS_AS(released.call("WhoAmI"), spear::StaleObject);
        CHECK(kept.call<std::string>("WhoAmI") == "parent");
        CHECK_NOTHROW(client.spawn());
    });
}

TEST_CASE("a map load between begin and end of a frame") {
    spear::Instance instance = spear::launch(launch_options());
    const spear::Game game = instance.game();
    const spear::Class statics = game.get_class("UGameplayStatics");
    spear::Object actor, kept, spawned;
    std::string level;
    spear::Future<std::string> before;
    {
        auto frame = instance.begin_frame();
        level = statics.call<std::string>("GetCurrentLevelName");
        actor = game.spawn_actor("ACameraActor");
        kept = game.new_object("URoundTripCalls");
        before = kept.async<std::string>("WhoAmI");
        statics.call("OpenLevel", arg("LevelName", level)); // travels in this frame's tick
        frame.execute();
    }
    {
        auto frame = instance.end_frame();
        CHECK_THROWS_AS(actor.call("K2_GetActorLocation"), spear::StaleObject); // of a world that is gone
        const auto after = kept.async<std::string>("WhoAmI");
        spawned = game.spawn_actor("ACameraActor"); // in the new one
        CHECK(spawned.call<FVector>("K2_GetActorLocation") == FVector{});
        CHECK(statics.call<std::string>("GetCurrentLevelName") == level);
        CHECK(frame_of(after) == frame_of(before));
        frame.execute();
    }
    instance.step(2);
    auto frame = instance.begin_frame();
    CHECK(spawned.is_valid());
    CHECK_FALSE(actor.is_valid());
    frame.execute();
    instance.end_frame().execute();
}
