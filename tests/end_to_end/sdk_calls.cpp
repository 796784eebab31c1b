// SPDX-License-Identifier: MIT
// Reflected calls on their short ways: synchronous ones beside the batches, plain ones without a look at names, and back
// to the general way whenever something is not as it was before.
#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "engine_fixture.hpp"

using namespace end_to_end;

namespace {

/// A session with an object whose functions give back what they get.
struct Calls : Client {
    spear::Object trip, calls;
    Calls() {
        transact([&] {
            trip = game.new_object("URoundTrip");
            calls = game.new_object("URoundTripCalls");
        });
    }
};

} // namespace

TEST_CASE("calls: the same call a thousand times, each with its own arguments and result") {
    Calls client;
    client.transact([&] {
        for (int i = 0; i < 1000; ++i) {
            CHECK(client.trip.call<std::int32_t>("EchoInt32", i) == i);
            CHECK(client.calls.call<double>("Length", FVector{3.0 * i, 4.0 * i, 0}) == doctest::Approx(5.0 * i));
        }
    });
    std::vector<spear::Future<std::int32_t>> futures;
    client.transact([&] {
        for (int i = 0; i < 1000; ++i)
            futures.push_back(client.trip.async<std::int32_t>("EchoInt32", i));
    });
    for (int i = 0; i < 1000; ++i)
        CHECK(futures[static_cast<std::size_t>(i)].get() == i);
}

TEST_CASE("calls: other types of argument for the same function are converted or refused as ever") {
    Calls client;
    const spear::Object& trip = client.trip;
    const auto refused = [&](auto&& call, spear::ErrorCode code) {
        try {
            call();
        } catch (const spear::Error& error) {
            return error.code() == code && error.info().operation.find("EchoInt32") != std::string::npos;
        }
        return false;
    };
    client.transact([&] {
        for (int round = 0; round < 3; ++round) {
            CHECK(trip.call<std::int32_t>("EchoInt32", 7) == 7);
            CHECK(trip.call<std::int32_t>("EchoInt32", std::int64_t{8}) == 8);
            CHECK(trip.call<std::int32_t>("EchoInt32", std::uint8_t{9}) == 9);
            CHECK(refused([&] { trip.call("EchoInt32", std::int64_t{1} << 40); }, spear::ErrorCode::OutOfRange));
            CHECK(refused([&] { trip.call("EchoInt32", "seven"); }, spear::ErrorCode::WrongType));
            CHECK(refused([&] { trip.call("EchoInt32", 7.5); }, spear::ErrorCode::WrongType));
            CHECK(refused([&] { trip.call("EchoInt32"); }, spear::ErrorCode::MissingArgument));
            CHECK(client.calls.call<double>("Length", FVector{0, 3, 4}) == 5);
            CHECK(client.calls.call<double>("Length", std::map<std::string, double>{{"X", 6.0}, {"Y", 8.0}}) == 10);
            CHECK(client.calls.call<double>("Length", std::vector<double>{1.0, 2.0, 2.0}) == 3);
            CHECK(client.calls.call<double>("Length", arg("Vector", FVector{2, 3, 6})) == 7);
        }
    });
}

TEST_CASE("calls: objects that are destroyed, collected, and followed by others in their place") {
    Calls client;
    client.transact([&] {
        for (int round = 0; round < 5; ++round) {
            const spear::Object actor = client.spawn({1.0 * round, 2, 3});
            for (int i = 0; i < 3; ++i)
                CHECK(actor.call<FVector>("K2_GetActorLocation") == FVector{1.0 * round, 2, 3});
            actor.call("K2_DestroyActor");
            CHECK_THROWS_AS(actor.call<FVector>("K2_GetActorLocation"), spear::StaleObject);
            client.calls.call("CollectNow"); // a garbage collection, within the block
            CHECK_THROWS_AS(actor.call<FVector>("K2_GetActorLocation"), spear::StaleObject);
            CHECK(client.trip.call<std::int32_t>("EchoInt32", round) == round);
        }
    });
    // The same within one message.
    std::vector<spear::Future<FVector>> before, after;
    std::vector<spear::Future<std::int32_t>> others;
    client.transact([&] {
        for (int round = 0; round < 5; ++round) {
            const spear::Object actor = client.spawn({1, 2, 3});
            before.push_back(actor.async<FVector>("K2_GetActorLocation"));
            before.push_back(actor.async<FVector>("K2_GetActorLocation"));
            actor.send("K2_DestroyActor");
            after.push_back(actor.async<FVector>("K2_GetActorLocation"));
            client.calls.send("CollectNow");
            after.push_back(actor.async<FVector>("K2_GetActorLocation"));
            others.push_back(client.trip.async<std::int32_t>("EchoInt32", round));
        }
    });
    for (const auto& future : before)
        CHECK(future.get() == FVector{1, 2, 3});
    for (const auto& future : after)
        CHECK_THROWS_AS(future.get(), spear::StaleObject);
    for (int round = 0; round < 5; ++round)
        CHECK(others[static_cast<std::size_t>(round)].get() == round);
}

TEST_CASE("calls: synchronous, asynchronous and fire-and-forget ones run in program order, also around errors") {
    Calls client;
    const spear::Object& calls = client.calls;
    client.transact([&] {
        std::int64_t last = calls.call<std::int64_t>("Ticket");
        for (int round = 0; round < 50; ++round) {
            const auto first = calls.async<std::int64_t>("Ticket");
            calls.send("Ticket");
            CHECK_THROWS_AS(client.trip.call("NoSuchFunction"), spear::UnknownFunction);
            const std::int64_t now = calls.call<std::int64_t>("Ticket");
            CHECK(first.get() == last + 1);
            CHECK(now == last + 3);
            CHECK(calls.call<std::int64_t>("Ticket") == now + 1);
            last = now + 1;
        }
    });
}

TEST_CASE("calls: results of every size, and with types that are new") {
    Calls client;
    client.transact([&] {
        CHECK(client.trip.call<std::int32_t>("EchoInt32", 1) == 1);
        for (const std::int64_t size : {0, 1, 900, 1000, 1004, 1005, 1008, 1009, 5000, 300'000, 3})
            CHECK(client.calls.call<std::vector<std::uint8_t>>("Bytes", size).size() == static_cast<std::size_t>(size));
        const std::string text(5000, 'x'); // arguments too large for a call
        CHECK(client.calls.call<std::string>("Describe", text).find(text) != std::string::npos);
        const spear::Object actor = client.spawn();
        CHECK(actor.call<FRotator>("K2_GetActorRotation") == FRotator{});
        CHECK(actor.call<unreal::FTransform>("GetTransform").Scale3D == FVector{1, 1, 1});
        CHECK(actor.call<spear::Object>("K2_GetRootComponent").class_name() != "");
    });
}

TEST_CASE("calls: results are kept one by one, and in ranges, whatever of them is given up first") {
    Calls client;
    const auto kept = [&] { return client.instance.statistics().kept_results; };
    const auto falls_to = [&](std::uint64_t count) {
        return eventually([&] {
            client.transact(nullptr);
            client.instance.flush();
            return kept() == count;
        });
    };
    REQUIRE(falls_to(0));
    std::vector<spear::Future<std::int32_t>> futures;
    client.transact([&] {
        for (int i = 0; i < 3000; ++i)
            futures.push_back(client.trip.async<std::int32_t>("EchoInt32", i));
        for (int i = 0; i < 10; ++i)
            futures.push_back(client.trip.async<std::int32_t>("EchoInt32", futures.back()));
    });
    client.instance.flush();
    CHECK(kept() == 3010);
    // Every third, then all but one of what is left, then all.
    std::vector<spear::Future<std::int32_t>> some;
    for (std::size_t i = 0; i < futures.size(); i += 3)
        some.push_back(futures[i]);
    futures.clear();
    CHECK(falls_to(some.size()));
    for (std::size_t i = 0; i < some.size(); ++i)
        CHECK(some[i].get() == static_cast<std::int32_t>(std::min<std::size_t>(3 * i, 2999)));
    const spear::Future<std::int32_t> last = some[500];
    some.clear();
    CHECK(falls_to(1));
    spear::Future<std::int32_t> again; // what is left still serves as an argument
    client.transact([&] { again = client.trip.async<std::int32_t>("EchoInt32", last); });
    CHECK(again.get() == 1500);
}
