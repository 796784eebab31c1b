// SPDX-License-Identifier: MIT
// Calls allocate nothing in the steady state: counted in this process, on this thread, and in the engine, on its game
// thread.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cstdint>
#include <functional>
#include <vector>

#include "spear/spear.hpp"

extern "C" std::uint64_t spear_test_allocations();

namespace {

using spear::unreal::FVector;

struct Counts {
    std::uint64_t client = 0;
    std::int64_t engine = 0;
};

struct Fixture {
    spear::Instance instance = spear::launch({.fps = 0,
        .executable = SPEAR_TEST_ENGINE,
        .arguments = {"--plugin-dir", SPEAR_TEST_PLUGINS}});
    spear::Object trip, calls;

    Fixture() {
        transact([&] {
            trip = instance.game().new_object("URoundTrip");
            calls = instance.game().new_object("URoundTripCalls");
        });
    }
    void transact(const std::function<void()>& begin) {
        auto frame = instance.begin_frame();
        begin();
        frame.execute();
        instance.end_frame().execute();
    }
    /// What `work` allocates; begins and ends in a block.
    Counts count(const std::function<void()>& work) {
        Counts before, after;
        before.engine = calls.call<std::int64_t>("Allocations");
        before.client = spear_test_allocations();
        work();
        after.client = spear_test_allocations();
        after.engine = calls.call<std::int64_t>("Allocations");
        return {after.client - before.client, after.engine - before.engine};
    }
};

} // namespace

TEST_CASE("synchronous calls allocate nothing") {
    Fixture engine;
    const auto work = [&] {
        for (int i = 0; i < 1000; ++i) {
            REQUIRE(engine.trip.call<FVector>("EchoVector", FVector{1.0 * i, 2, 3}).X == i);
            REQUIRE(engine.trip.call<std::int32_t>("EchoInt32", i) == i);
        }
    };
    engine.transact([&] {
        work();
        (void)engine.count(work); // its own calls take the general way once
        const Counts counts = engine.count(work);
        CHECK(counts.client == 0);
        CHECK(counts.engine == 0);
    });
}

TEST_CASE("transactions of asynchronous calls allocate nothing, whether futures are kept or not") {
    Fixture engine;
    std::vector<spear::Future<FVector>> futures;
    futures.reserve(1000);
    const auto record = [&](int calls) {
        for (int i = 0; i < calls; ++i) {
            futures.push_back(engine.trip.async<FVector>("EchoVector", FVector{1.0 * i, 2, 3}));
            engine.trip.send("EchoVector", FVector{4, 5, 6});
        }
    };
    const auto run = [&](int calls) {
        return [&, calls] {
            for (int round = 0; round < 50; ++round) {
                auto begin = engine.instance.begin_frame();
                futures.clear(); // those of the last round
                record(calls);
                begin.execute();
                engine.instance.end_frame().execute();
            }
            engine.instance.flush();
        };
    };
    const auto count = [&](int calls) {
        engine.transact([&] { (void)engine.calls.call<std::int64_t>("Allocations"); });
        const auto look = [&] {
            Counts now;
            engine.transact([&] { now.engine = engine.calls.call<std::int64_t>("Allocations"); });
            now.client = spear_test_allocations();
            return now;
        };
        run(calls)();
        // Buffers grow to the largest that each ever held, and how many are on their way at once depends on when the threads
        // run: the steady state comes after some runs. A call or transaction that allocates lets it never come.
        Counts grown;
        for (int runs = 0; runs < 20; ++runs) {
            const Counts before = look();
            run(calls)();
            const Counts after = look();
            grown = {after.client - before.client, after.engine - before.engine};
            if (grown.client <= 4) {
                break;
            }
            MESSAGE("not yet steady after ", runs + 1, " runs: ", grown.client, " in the client");
        }
        return grown;
    };
    const Counts few = count(1), many = count(500);
    MESSAGE("50 transactions of 2 and of 1000 calls: ", few.client, " and ", many.client, " in the client, ", few.engine,
        " and ", many.engine, " on the game thread");
    // What does not depend on the number of calls is the engine's own, of its frames; 0 in the client.
    CHECK(many.client <= 4);
    CHECK(many.engine <= few.engine + 4);
}
