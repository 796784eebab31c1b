// SPDX-License-Identifier: MIT
// Frames: the guarantees G1 to G5, G9 and G10 of the programming model (docs/guarantees.md), as a client sees them.
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

TEST_CASE("G1: the calls of both blocks run in program order, however they are made") {
    Client client;
    const spear::Class calls = client.game.get_class("URoundTripCalls");
    for (int round = 0; round < 3; ++round) {
        std::vector<std::int64_t> order;
        std::vector<spear::Future<std::int64_t>> futures;
        const auto work = [&] {
            for (int i = 0; i < 4; ++i) {
                futures.push_back(calls.async<std::int64_t>("Ticket"));
                calls.send("Ticket");
                order.push_back(calls.call<std::int64_t>("Ticket"));
                order.push_back(futures.back().get() + 2); // ran two before it
            }
        };
        client.transact(work, work);
        for (std::size_t i = 0; i < 8; ++i) {
            CHECK(order[2 * i] == order[2 * i + 1]);
            CHECK(order[2 * i] == order[0] + 3 * static_cast<std::int64_t>(i));
            CHECK(frame_of(futures[i]) == frame_of(futures[0]));
        }
    }
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
    CHECK(eventually([&] { return client.frame_number() == last + 1; })); // the beginning of the next frame
    CHECK(client.frames_stand());
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

TEST_CASE("G3: an asynchronous operation returns at once, also while the engine cannot run it") {
    Client holder, client;
    const spear::Class calls = client.game.get_class("URoundTripCalls");
    auto held = holder.instance.begin_frame();
    (void)holder.game.find_actors_by_class("AActor");
    auto frame = client.instance.begin_frame();
    const auto first = calls.async<std::int64_t>("Ticket");
    const auto second = calls.async<std::int64_t>("Ticket");
    frame.execute(); // does not wait either
    client.arrive();
    CHECK_FALSE(first.is_ready());
    CHECK_FALSE(second.wait(50ms));
    CHECK_THROWS_AS(second.get(50ms), spear::HeldByClient);
    held.execute();
    holder.instance.end_frame().execute();
    client.instance.end_frame().execute();
    CHECK(second.get() == first.get() + 1); // a wait that failed can be repeated
    CHECK(first.is_ready());
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
        CHECK(client.frames_stand());
        frame.execute();
    }
    CHECK(client.frames_stand()); // the game thread waits at the end of that frame for the end block
    {
        auto frame = client.instance.end_frame();
        const auto future = client.game.async().get_class("AActor");
        CHECK(future.get().class_name() == "UClass"); // get() of a future of this block holds as well
        CHECK(client.frames_stand());
        frame.execute();
    }
    CHECK(client.frames_go_on());
}

TEST_CASE("G4: the next begin_frame is queued while the previous end is pending; a second one of a kind waits") {
    Client holder({.client_name = "the holder", .deadline = 10s}), client;
    const spear::Class calls = client.game.get_class("URoundTripCalls");
    spear::Future<std::int64_t> at_begin, at_end, at_next;
    const auto record = [&](spear::Frame frame, spear::Future<std::int64_t>& future) {
        future = calls.async<std::int64_t>("Ticket");
        frame.execute();
        client.arrive();
    };
    auto held = holder.instance.begin_frame();
    (void)holder.game.find_actors_by_class("AActor");
    record(client.instance.begin_frame(), at_begin);
    CHECK_FALSE(at_begin.is_ready()); // the frame's begin works are in order of arrival

    held.execute(); // now the frame runs, and at its end the engine waits for the holder's end block
    CHECK_NOTHROW(at_begin.get());
    record(client.instance.end_frame(), at_end); // its turn is after the holder's
    record(client.instance.begin_frame(), at_next);
    CHECK_FALSE(at_end.is_ready());

    client.instance.session()->set_deadline(100ms);
    std::string text = error_text<spear::HeldByClient>([&] { (void)client.instance.end_frame(); });
    CHECK(contains(text, "The previous end_frame block"));
    CHECK(contains(text, "the holder"));
    CHECK_FALSE(at_end.is_ready());
    client.instance.session()->set_deadline(10s);

    holder.instance.end_frame().execute();
    client.instance.end_frame().execute(); // opening it waited for the one before
    CHECK(at_end.is_ready());
    CHECK(frame_of(at_end) == frame_of(at_begin));
    CHECK(at_next.get() > at_end.get());
    CHECK(frame_of(at_next) > frame_of(at_end));

    // A begin_frame block waits for the begin_frame block before it.
    client.instance.flush();
    auto again = holder.instance.begin_frame();
    (void)holder.game.find_actors_by_class("AActor");
    client.transact([&] { at_begin = calls.async<std::int64_t>("Ticket"); });
    client.instance.session()->set_deadline(100ms);
    text = error_text<spear::HeldByClient>([&] { (void)client.instance.begin_frame(); });
    CHECK(contains(text, "The previous begin_frame block"));
    client.instance.session()->set_deadline(10s);
    again.execute();
    holder.instance.end_frame().execute();
    client.transact([&] { CHECK(at_begin.is_ready()); });
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

TEST_CASE("G9 G10: stepping by unpausing and pausing is exact, and the engine goes on in between") {
    Client client;
    const spear::Class statics = client.game.get_class("UGameplayStatics");
    client.transact([&] { statics.call("SetGamePaused", true); });
    double last = -1;
    for (int step = 0; step < 5; ++step) {
        double at_begin = 0, at_end = 0;
        client.transact(
            [&] {
                statics.call("SetGamePaused", false);
                at_begin = statics.call<double>("GetTimeSeconds");
            },
            [&] {
                statics.call("SetGamePaused", true);
                at_end = statics.call<double>("GetTimeSeconds");
            });
        CHECK(at_end - at_begin == doctest::Approx(fixed_dt).epsilon(1e-7));
        if (step != 0)
            CHECK(at_begin == last); // to the last bit: nothing was simulated meanwhile
        last = at_end;
        CHECK(client.frames_go_on());
    }
    client.transact([&] { statics.call("SetGamePaused", false); });
}

TEST_CASE("G10: between transactions the engine ticks, also while the world is paused") {
    Client client;
    const spear::Class statics = client.game.get_class("UGameplayStatics");
    client.transact([&] { statics.call("SetGamePaused", true); });
    CHECK(client.frames_go_on());
    client.transact([&] { CHECK(statics.call<bool>("IsGamePaused")); });
    client.transact([&] { statics.call("SetGamePaused", false); });
}

