// SPDX-License-Identifier: MIT
// Clients that do not keep to the protocol, exceed limits, or vanish: each gets its error, the engine goes on, other
// clients notice nothing.
#include <random>
#include <string>
#include <vector>

#include "raw_client.hpp"

using namespace end_to_end;
using spear::ErrorCode;
using Batch = RawClient::Batch;
namespace service = spear::unreal_service;
namespace types = spear::types;

TEST_CASE("blocks and transactions out of order are refused, one by one") {
    RawClient client;
    REQUIRE(client.connected());
    const auto refused = [&](const Batch& batch) {
        const auto reply = client.exchange(batch);
        REQUIRE(reply);
        return reply->has_error ? reply->error : ErrorCode::Error;
    };
    CHECK(refused(closing(1, end)) == ErrorCode::FrameMisuse);
    CHECK(refused(closing(0, begin)) == ErrorCode::FrameMisuse);
    CHECK_FALSE(client.exchange(closing(5, begin))->has_error);
    CHECK(refused(closing(5, begin)) == ErrorCode::FrameMisuse);
    CHECK(refused(closing(6, begin)) == ErrorCode::FrameMisuse);
    CHECK(refused(closing(4, end)) == ErrorCode::FrameMisuse);
    CHECK_FALSE(client.exchange(closing(5, end))->has_error);
    CHECK(refused(closing(5, end)) == ErrorCode::FrameMisuse);
    CHECK(refused(closing(5, begin)) == ErrorCode::FrameMisuse);
    CHECK_FALSE(client.exchange(closing(9, begin))->has_error);
    Batch aborts = closing(9, end);
    aborts.abort = true;
    CHECK_FALSE(client.exchange(aborts)->has_error);

    Batch outside; // a game-thread operation outside of blocks
    RawClient::add(
        outside, service::destroy_actor, 1, [](spear::Encoder& out) { spear::encode_value(out, spear::ObjectRef{}); });
    CHECK(client.exchange(outside)->errors().at(1).code == ErrorCode::NotInFrame);
    CHECK(Client().frames_go_on());
}

TEST_CASE("an aborting begin block runs what it has, and no end block is awaited") {
    RawClient client;
    Batch batch = closing(1, begin);
    batch.abort = true;
    add_find_class(batch, 1, "AActor");
    CHECK(client.exchange(batch)->values().size() == 1);
    CHECK(Client().frames_go_on());
    CHECK(client.exchange(closing(2, begin)).has_value());
    CHECK(client.exchange(closing(2, end)).has_value());
}

TEST_CASE("malformed batches end the session, not the engine") {
    const auto drops = [](Batch batch) {
        RawClient client;
        REQUIRE(client.connected());
        (void)client.submit(batch);
        return client.lost();
    };
    Batch batch;
    batch.operations.resize(7, std::byte{1}); // no whole header
    CHECK(drops(batch));

    batch = {};
    add_find_class(batch, 1, "AActor");
    batch.operations.pop_back(); // shorter than it says
    CHECK(drops(batch));

    batch = {};
    add_find_class(batch, 0, "AActor"); // no operation has number 0
    CHECK(drops(batch));

    batch = {};
    add_find_class(batch, 1, "AActor");
    batch.operations[8] = std::byte{0xff}; // an entry point that does not exist
    batch.operations[9] = std::byte{0xff};
    CHECK(drops(batch));

    batch = {};
    add_find_class(batch, 1, "AActor");
    announce(batch, types::first_client_type + 1, {}); // a number out of order
    CHECK(drops(batch));

    batch = {};
    batch.block = 3;
    CHECK(drops(batch));
    CHECK(Client().frames_go_on());
}

TEST_CASE("random bytes as arguments, announcements and batches") {
    std::mt19937 random(12345);
    const auto noise = [&](std::size_t size) {
        std::vector<std::byte> bytes(size);
        for (std::byte& byte : bytes) {
            // Small numbers hit types and counts more often than large ones.
            byte = static_cast<std::byte>(random() % 4 ? random() % 24 : random());
        }
        return bytes;
    };
    for (int round = 0; round < 60; ++round) {
        RawClient client;
        REQUIRE(client.connected());
        std::uint64_t number = 0;
        Batch batch = closing(1, begin);
        announce(batch, 64,
            {spear::TypeKind::structure, "FVector", "", 0, 0, {{"X", types::f64}, {"Y", types::any}}, {}, 1});
        announce(batch, 65, {spear::TypeKind::array, "", "", 64, 0, {}, {}, 1});
        announce(batch, 66, {spear::TypeKind::call_shape, "SetActorScale3D", "", 0, 0, {{"", types::any}}, {}, 1});
        announce(batch, 67, {spear::TypeKind::path_shape, "Tags[0]", "", 0, 0, {}, {}, 1});
        if (round % 3 == 0) {
            const auto more = noise(64);
            batch.types.insert(batch.types.end(), more.begin(), more.end());
        }
        spear::AllEntryPoints::for_each([&](auto entry_point) {
            if (decltype(entry_point)::name == "engine_service.request_exit")
                return;
            RawClient::add(batch, entry_point, ++number, [&](spear::Encoder& out) {
                const auto bytes = noise(random() % 96);
                out.put_raw(bytes.data(), bytes.size());
            });
        });
        if (round % 5 == 0) {
            const auto more = noise(40);
            batch.operations.insert(batch.operations.end(), more.begin(), more.end());
        }
        const auto reply = client.exchange(batch);
        if (reply && !reply->has_error) {
            CHECK(reply->values().size() + reply->errors().size() == number);
            (void)client.exchange(closing(1, end));
        }
    }
    CHECK(Client().frames_go_on());
}

TEST_CASE("well-formed shapes with garbage in the values") {
    RawClient client;
    Client helper;
    spear::Object object;
    std::mt19937 random(99);
    Batch setup = closing(1, begin);
    RawClient::add(
        setup, service::new_object, 1,
        [](spear::Encoder& out) {
            put_text(out, "URoundTrip");
            spear::encode_value(out, spear::ObjectRef{});
            put_text(out, "");
        },
        spear::OperationFlags::keep_result);
    spear::TypeId next = 64;
    std::vector<spear::TypeId> calls, paths;
    for (const char* kind : {"Bool", "Int8", "UInt64", "Double", "String", "Name", "Enum", "ByteEnum", "Actor", "Class",
             "Weak", "SoftObject", "Interface", "Transform", "Record", "ByteArray", "StringArray", "VectorArray",
             "RecordArray", "NameSet", "StringMap", "VectorMap", "Optional", "Delegate"}) {
        announce(setup, next,
            {spear::TypeKind::call_shape, std::string("Echo") + kind, "", 0, 0, {{"Value", types::any}}, {}, 1});
        calls.push_back(next++);
        announce(setup, next, {spear::TypeKind::path_shape, std::string(kind) + "Value", "", 0, 0, {}, {}, 1});
        paths.push_back(next++);
    }
    CHECK_FALSE(client.exchange(setup)->has_error);
    CHECK_FALSE(client.exchange(closing(1, end))->has_error);

    std::uint64_t number = 1;
    for (std::uint64_t transaction = 2; transaction < 40; ++transaction) {
        Batch batch = closing(transaction, begin);
        const std::uint64_t first = number + 1;
        for (int index = 0; index < 200; ++index) {
            const auto garbage = [&](spear::Encoder& out) {
                out.put(static_cast<spear::TypeId>(random() % 20));
                for (std::size_t left = random() % 40; left != 0; --left) {
                    out.put(static_cast<std::uint8_t>(random() % 3 ? random() % 20 : random()));
                }
            };
            const bool is_call = random() % 2 != 0;
            const spear::TypeId shape = is_call ? calls[random() % calls.size()] : paths[random() % paths.size()];
            const auto put = [&](spear::Encoder& out) {
                out.put(types::future);
                out.put(std::uint64_t{1});
                spear::encode_value(out, spear::ShapeId{shape});
                garbage(out);
            };
            if (is_call)
                RawClient::add(batch, service::call_function, ++number, put);
            else
                RawClient::add(batch, service::set_property, ++number, put);
        }
        const auto reply = client.exchange(batch);
        REQUIRE(reply);
        CHECK(reply->values().size() + reply->errors().size() == number - first + 1);
        CHECK_FALSE(client.exchange(closing(transaction, end))->has_error);
    }
    CHECK(helper.frames_go_on());
}

TEST_CASE("a client that goes in the middle of a block, or of single_step, releases the game thread") {
    for (const int where : {0, 1, 2, 3}) {
        CAPTURE(where);
        Client witness;
        RawClient client;
        REQUIRE(client.connected());
        Batch opens;
        opens.transaction = 1;
        opens.block = begin;
        add_find_class(opens, 1, "AActor");
        opens.closes = where != 0;
        REQUIRE(client.exchange(opens));
        if (where >= 2) {
            Batch ends;
            ends.transaction = 1;
            ends.block = end;
            add_find_class(ends, 2, "AActor");
            ends.closes = where == 3;
            ends.single_step = where == 3;
            REQUIRE(client.exchange(ends));
        }
        const std::uint64_t before = witness.frame_number();
        std::this_thread::sleep_for(100ms);
        CHECK(witness.frame_number() <= before + 1); // held
        CHECK(witness.instance.session()->status().holder == "a raw client");
        client.close();
        CHECK(witness.frames_go_on());
    }
}

TEST_CASE("two clients: one transaction of each in a frame; while one holds, the other's facts are still answered") {
    Client first, second;
    std::uint64_t frame = 0;
    {
        auto block = first.instance.begin_frame();
        (void)first.game.find_actors_by_class("AActor");                 // holds
        CHECK(second.game.get_class("AActor").class_name() == "UClass"); // outside of blocks: answered during the hold
        CHECK(second.instance.session()->status().state == spear::Session::Status::State::held_by_other);
        CHECK(first.instance.session()->status().state == spear::Session::Status::State::held_by_you);
        auto other = second.instance.begin_frame();
        const auto ran = second.game.async().find_actors_by_class("AActor");
        other.execute();
        second.arrive(); // two connections: nothing else orders the messages
        block.execute();
        frame = frame_of(ran);
    }
    const auto last = [&] {
        auto block = first.instance.end_frame();
        const auto ran = first.game.async().find_actors_by_class("AActor");
        block.execute();
        second.instance.end_frame().execute();
        return frame_of(ran);
    }();
    CHECK(last == frame);
}

TEST_CASE("versions: an entry point that the server does not have, or has differently") {
    std::vector<std::string> signatures = RawClient::all_signatures();
    signatures.push_back("unreal_service.find_class(name: int32) -> object @any_frame");
    RawClient client(signatures);
    CHECK_FALSE(client.connected());
    CHECK(client.connect_error().code == static_cast<std::uint16_t>(ErrorCode::VersionMismatch));
    CHECK(contains(client.connect_error().message, "unreal_service.find_class(name: string)"));

    RawClient fewer({RawClient::all_signatures()[0]}); // fewer, in the client's own order, are fine
    CHECK(fewer.connected());
}

TEST_CASE("the live schema has what the engine has") {
    Client client;
    const spear::Value described = client.instance.call(service::describe_class, "AActor");
    CHECK(described["name"] == spear::Value("AActor"));
    CHECK(described["super"] == spear::Value("UObject"));
    CHECK(described["path"] == spear::Value("/Script/Engine.Actor"));
    CHECK(described["functions"].size() > 20);

    const spear::Value schema = client.instance.call(service::get_schema, std::vector<std::string>{"RoundTrip"});
    CHECK(schema["format"] == spear::Value("spear-schema"));
    CHECK(schema["modules"].size() == 1);
    CHECK(schema["classes"].size() == 4);
    CHECK(schema["structs"].size() == 2);
    CHECK(schema["enums"].size() == 3);
    CHECK(schema["delegates"].size() == 2);
    CHECK(schema["enums"][1]["entries"].size() == 2); // without the generated _MAX
    error_text<spear::UnknownObject>(
        [&] { client.instance.call(service::get_schema, std::vector<std::string>{"RoundTipr"}); });
    CHECK(client.instance.call(service::get_schema, std::vector<std::string>{})["classes"].size() > 40);
}
