// SPDX-License-Identifier: MIT
// G8: futures as arguments, in every position, resolved by the server; and what travels: counted messages, results kept.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine_fixture.hpp"

using namespace end_to_end;

namespace {

/// What has travelled since the last look.
struct Counted {
    spear::Session::Statistics last;
    explicit Counted(Client& client) : last(settled(client)) {}
    /// All answers are there: both ends have counted the same.
    static spear::Session::Statistics settled(Client& client) {
        client.instance.flush();
        const spear::Session::Statistics now = client.instance.statistics();
        CHECK(now.sent.messages == now.server_received.messages);
        CHECK(now.sent.bytes == now.server_received.bytes);
        CHECK(now.received.messages == now.server_sent.messages);
        CHECK(now.received.bytes == now.server_sent.bytes);
        return now;
    }
    /// Messages to the server and from it.
    std::pair<std::uint64_t, std::uint64_t> messages(Client& client) {
        const auto before = last;
        last = settled(client);
        return {last.sent.messages - before.sent.messages, last.received.messages - before.received.messages};
    }
};
using Messages = std::pair<std::uint64_t, std::uint64_t>;

} // namespace

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


TEST_CASE("G8: futures as elements of arrays and sets, values of maps, fields of structs, and nested in each other") {
    Client client;
    spear::Object trip;
    client.transact([&] { trip = client.game.new_object("URoundTrip"); });
    Counted counted(client);
    spear::Future<std::vector<FVector>> array;
    spear::Future<std::vector<std::string>> strings, set;
    spear::Future<std::map<std::string, std::int32_t>> map;
    spear::Future<FVector> structure;
    spear::Future<spear::Value> record, records;
    spear::Future<std::vector<FVector>> stored;
    client.transact([&] {
        const auto vector = trip.async<FVector>("EchoVector", FVector{1, 2, 3});
        const auto number = trip.async<double>("EchoDouble", 7.5);
        const auto count = trip.async<std::int32_t>("EchoInt32", 42);
        const auto text = trip.async<std::string>("EchoString", "text");
        array = trip.async<std::vector<FVector>>("EchoVectorArray", std::vector{vector, vector});
        strings = trip.async<std::vector<std::string>>("EchoStringArray", std::vector{text, text, text});
        set = trip.async<std::vector<std::string>>(
            "EchoNameSet", std::vector{text, trip.async<std::string>("EchoName", "other")});
        map = trip.async<std::map<std::string, std::int32_t>>(
            "EchoStringMap", std::map<std::string, spear::Future<std::int32_t>>{{"a", count}, {"b", count}});
        structure = trip.async<FVector>(
            "EchoVector", std::map<std::string, spear::Future<double>>{{"X", number}, {"Y", number}, {"Z", number}});
        // A struct's array of numbers, and an array of structs: futures in the third level.
        record = trip.async<spear::Value>("EchoRecord",
            std::map<std::string, std::vector<spear::Future<double>>>{{"Samples", {number, number, number}}});
        records = trip.async<spear::Value>("EchoRecordArray",
            std::vector{std::map<std::string, spear::Future<FVector>>{{"Place", vector}},
                std::map<std::string, spear::Future<FVector>>{{"Place", vector}}});
        trip["VectorArrayValue"].send_set(array);                      // a value of a property
        stored = trip["VectorArrayValue"].async_get<std::vector<FVector>>();
    });
    CHECK(counted.messages(client) == Messages{2, 2}); // no round trip: one message for each block
    CHECK(array.get() == std::vector<FVector>{{1, 2, 3}, {1, 2, 3}});
    CHECK(strings.get() == std::vector<std::string>{"text", "text", "text"});
    CHECK(set.get() == std::vector<std::string>{"text", "other"});
    CHECK(map.get() == std::map<std::string, std::int32_t>{{"a", 42}, {"b", 42}});
    CHECK(structure.get() == FVector{7.5, 7.5, 7.5});
    CHECK(record.get()["Samples"].as<std::vector<double>>() == std::vector<double>{7.5, 7.5, 7.5});
    CHECK(record.get()["Title"] == spear::Value("untitled")); // members not given have Unreal's own values
    CHECK(records.get()[1]["Place"].as<FVector>() == FVector{1, 2, 3});
    CHECK(stored.get() == array.get());
}

TEST_CASE("G8: futures of another transaction, of the begin block in the end block, and of results long read") {
    Client client;
    spear::Object trip;
    spear::Future<FVector> first, in_end, later;
    client.transact(
        [&] {
            trip = client.game.new_object("URoundTrip");
            first = trip.async<FVector>("EchoVector", FVector{1, 2, 3});
        },
        [&] { in_end = trip.async<FVector>("EchoVector", first); });
    CHECK(first.get() == FVector{1, 2, 3});
    client.instance.step(3);
    client.transact([&] {
        later = trip.async<FVector>("EchoVector", first);
        CHECK(trip.call<FVector>("EchoVector", later) == FVector{1, 2, 3}); // of a synchronous call
        trip["VectorValue"].set(later);
        CHECK(trip["VectorValue"].get<FVector>() == FVector{1, 2, 3});
    });
    CHECK(in_end.get() == FVector{1, 2, 3});
    CHECK(later.get() == FVector{1, 2, 3});
}

TEST_CASE("G8: a future that was dropped before its operation is sent still serves as the argument it is") {
    Client client;
    spear::Object trip;
    spear::Future<std::vector<FVector>> all;
    client.transact([&] {
        trip = client.game.new_object("URoundTrip");
        std::optional dropped(trip.async<FVector>("EchoVector", FVector{1, 2, 3}));
        auto twice = trip.async<FVector>("EchoVector", *dropped);
        all = trip.async<std::vector<FVector>>("EchoVectorArray", std::vector{*dropped, twice});
        dropped.reset();
        twice = {};
    });
    CHECK(all.get() == std::vector<FVector>{{1, 2, 3}, {1, 2, 3}});
}

TEST_CASE("G8: futures of another session, of no operation, and not sent yet are refused with clear words") {
    Client client, other;
    spear::Object trip;
    spear::Future<FVector> foreign;
    other.transact([&] {
        foreign = other.game.new_object("URoundTrip").async<FVector>("EchoVector", FVector{1, 2, 3});
    });
    client.transact([&] {
        trip = client.game.new_object("URoundTrip");
        std::string text = error_text<spear::WrongType>([&] { trip.call<FVector>("EchoVector", foreign); });
        CHECK(contains(text, "another session"));
        CHECK(contains(text, "EchoVector"));
        CHECK_THROWS_AS(
            trip.send("EchoVectorArray", std::vector{foreign}), spear::WrongType); // wherever it stands
        CHECK_THROWS_AS(trip.async<FVector>("EchoVector", spear::Future<FVector>()), spear::ArgumentError);
        const auto recorded = trip.async<std::string>("EchoString", "text");
        text = error_text<spear::FrameMisuse>([&] { // the server thread would see it before the block goes out
            client.instance.call(spear::engine_service::ping, recorded);
        });
        CHECK(contains(text, "overtake"));
        CHECK(trip.call<FVector>("EchoVector", FVector{1, 1, 1}) == FVector{1, 1, 1}); // none of it did any harm
    });
}

TEST_CASE("G8: a failed input fails its dependants, in every position, with the original error attached; others run") {
    Client client;
    spear::Object trip;
    std::vector<spear::OperationHandle> dependants;
    spear::Future<FVector> chained, fine;
    spear::Future<spear::Value> nested;
    client.transact([&] {
        trip = client.game.new_object("URoundTrip");
        const auto bad = trip.async<FVector>("EchoVector", "no vector");
        const auto bad_object = client.game.async().find_actor_by_name("NoSuchActor");
        const auto first = trip.async<FVector>("EchoVector", bad); // argument
        chained = trip.async<FVector>("EchoVector", first);        // argument of a dependant
        dependants = {first.operation(),
            trip.async<spear::Value>("EchoVectorArray", std::vector{bad}).operation(), // element
            trip["VectorValue"].async_set(bad).operation(),                           // value
            trip.async<spear::Value>("EchoRecord", std::map<std::string, spear::Future<FVector>>{{"Place", bad}})
                .operation()};                                                         // member
        nested = bad_object.async<spear::Value>("GetFullName");                        // object
        fine = trip.async<FVector>("EchoVector", FVector{4, 5, 6});
    });
    const auto original_of = [](const auto& get) -> std::optional<spear::ErrorInfo> {
        try {
            get();
        } catch (const spear::DependencyFailed& error) {
            CHECK(error.original());
            return error.original() ? std::optional(*error.original()) : std::nullopt;
        }
        FAIL_CHECK("no DependencyFailed was raised");
        return std::nullopt;
    };
    for (const spear::OperationHandle& dependant : dependants) {
        const auto original = original_of([&] { (void)dependant.get(); });
        REQUIRE(original);
        CHECK(original->code == spear::ErrorCode::WrongType);
        CHECK(contains(original->operation, "EchoVector"));
        CHECK(original->argument == "Value");
    }
    CHECK(original_of([&] { chained.get(); })->code == spear::ErrorCode::WrongType); // the first, not the one between
    CHECK(original_of([&] { nested.get(); })->code == spear::ErrorCode::UnknownObject);
    CHECK(fine.get() == FVector{4, 5, 6});
}

TEST_CASE("G8: an all-asynchronous block is one message each way, whatever its size") {
    Client client;
    spear::Object trip;
    client.transact([&] { trip = client.game.new_object("URoundTrip"); });
    Counted counted(client);
    for (const int operations : {0, 1, 10, 1000, 30'000}) {
        CAPTURE(operations);
        spear::Future<std::int32_t> last;
        client.transact(
            [&] {
                for (int i = 0; i < operations; ++i)
                    last = trip.async<std::int32_t>("EchoInt32", i);
            },
            [&] {
                for (int i = 0; i < operations; ++i)
                    trip.send("EchoInt32", i);
            });
        CHECK(counted.messages(client) == Messages{2, 2});
    }
    // A block of many megabytes, too: more than the ring of a channel holds at once.
    const std::vector<std::uint8_t> bytes(2'000'000, 1);
    spear::Future<spear::Value> echoed;
    client.transact([&] { echoed = trip.async<spear::Value>("EchoByteArray", bytes); });
    const std::uint64_t sent = counted.last.sent.bytes;
    const std::uint64_t received = counted.last.received.bytes;
    CHECK(counted.messages(client) == Messages{2, 2});
    CHECK(counted.last.sent.bytes - sent > bytes.size());
    CHECK(counted.last.received.bytes - received > bytes.size());
}

TEST_CASE("messages of synchronous operations: one each way for each, with all that was recorded before it") {
    Client client;
    spear::Object trip;
    client.transact([&] { trip = client.game.new_object("URoundTrip"); });
    Counted counted(client);
    client.transact([&] {
        for (int i = 0; i < 5; ++i) {
            trip.send("EchoInt32", 1);
            trip.send("EchoInt32", 2);
            trip.call("EchoInt32", 3);
        }
    });
    CHECK(counted.messages(client) == Messages{5 + 1 + 1, 5 + 1 + 1}); // and the ends of the two blocks
    client.instance.call(spear::engine_service::ping, "");
    CHECK(counted.messages(client) == Messages{1, 1});
    client.instance.session()->status();
    CHECK(counted.messages(client) == Messages{0, 0}); // no part of it
    client.instance.close();
    CHECK_THROWS_AS(client.instance.statistics(), spear::Disconnected);
}

TEST_CASE("dropped futures free their results in the server") {
    Client client;
    spear::Object trip;
    client.transact([&] { trip = client.game.new_object("URoundTrip"); });
    client.instance.flush();
    const auto kept = [&] { return client.instance.statistics().kept_results; };
    // The server hears of what was dropped with the next message, and acts on it in a frame.
    const auto falls_to = [&](std::uint64_t count) {
        client.transact(nullptr);
        client.instance.flush();
        return eventually([&] { return kept() == count; });
    };
    REQUIRE(falls_to(0));
    std::vector<spear::Future<std::int32_t>> futures;
    client.transact([&] {
        for (int i = 0; i < 100; ++i)
            futures.push_back(trip.async<std::int32_t>("EchoInt32", i));
        for (int i = 0; i < 100; ++i)
            trip.send("EchoInt32", i); // keeps nothing
    });
    client.instance.flush();
    CHECK(kept() == 100);
    futures.resize(10);
    CHECK(falls_to(10));
    const std::vector copies(futures);
    futures.clear();
    CHECK(falls_to(10)); // copies share the result
    CHECK(copies[9].get() == 9);

    client.transact([&] { // dropped before they are sent, and while they are under way; also failed ones
        for (int i = 0; i < 50; ++i)
            (void)trip.async<std::int32_t>("EchoInt32", i);
        (void)trip.async<std::int32_t>("NoSuchFunction");
    });
    CHECK(falls_to(10));
}

TEST_CASE("dropped futures of latent functions free their results, too") {
    Client client;
    const spear::Class system = client.game.get_class("UKismetSystemLibrary");
    client.transact([&] {
        auto dropped = system.async<void>("Delay", arg("Duration", 0.02));
        const auto finished = system.async<void>("Delay", arg("Duration", 0.0));
        client.game.get_class("AActor"); // both have begun
    });
    CHECK(eventually([&] {
        client.transact(nullptr);
        client.instance.flush();
        return client.instance.statistics().kept_results == 0;
    }));
    CHECK(client.frames_go_on());
}
