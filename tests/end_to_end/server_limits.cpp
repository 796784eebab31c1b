// SPDX-License-Identifier: MIT
// The limits of spear/limits.hpp: each one is exceeded, gives its error, and leaves the engine and other clients as they
// were. (limits::default_deadline_ms and limits::game_thread_wake_ms are no limits of what a client may do.)
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "raw_client.hpp"

using namespace end_to_end;
using spear::ErrorCode;
using Batch = RawClient::Batch;
namespace service = spear::unreal_service;
namespace types = spear::types;
namespace limits = spear::limits;

namespace {

using Frames = std::remove_cv_t<decltype(spear::engine_service::get_frame_number)>;

/// Many operations without arguments, quickly.
void add_many(Batch& batch, std::uint64_t& number, std::size_t count, spear::OperationFlags flags) {
    spear::Encoder one;
    batch.operations.reserve(batch.operations.size() + count * spear::OperationHeader::size);
    for (std::size_t index = 0; index < count; ++index) {
        one.buffer.clear();
        spear::end_operation(
            one, spear::begin_operation(one, ++number, spear::AllEntryPoints::index_of<Frames>(), flags));
        batch.operations.insert(batch.operations.end(), one.buffer.begin(), one.buffer.end());
    }
}

/// A URoundTrip and the batch that made it, as operation 1.
Batch new_round_trip(const char* name = "URoundTrip") {
    Batch batch;
    RawClient::add(
        batch, service::new_object, 1,
        [&](spear::Encoder& out) {
            put_text(out, name);
            spear::encode_value(out, spear::ObjectRef{});
            put_text(out, "");
        },
        spear::OperationFlags::keep_result);
    return batch;
}

} // namespace

TEST_CASE("limits: max_value_depth, in values whose type is not known and in those of a function") {
    RawClient client;
    std::uint64_t transaction = 0, number = 0;
    Batch batch; // nesting
    RawClient::add(batch, service::find_class, ++number, [](spear::Encoder& out) {
        for (std::size_t depth = 0; depth < limits::max_value_depth + 10; ++depth) {
            out.put(types::list);
            out.put(std::uint32_t{1});
        }
        out.put(types::null);
    });
    CHECK(error_of(client, ++transaction, batch)->code == ErrorCode::WrongType);

    CHECK(Client().frames_go_on());
}

TEST_CASE("limits: max_string_bytes") {
    RawClient client;
    std::uint64_t transaction = 0, number = 0;
    Batch batch; // a string longer than the limit says
    RawClient::add(batch, service::find_class, ++number, [](spear::Encoder& out) {
        out.put(types::string);
        out.put_text(std::string(limits::max_string_bytes + 1, 'x'));
    });
    CHECK(error_of(client, ++transaction, batch)->code == ErrorCode::MalformedMessage);

    CHECK(Client().frames_go_on());
}

TEST_CASE("limits: max_elements, and more elements than bytes") {
    RawClient client;
    std::uint64_t transaction = 0, number = 0;
    Batch batch; // more elements than bytes
    RawClient::add(batch, service::get_schema, ++number, [](spear::Encoder& out) {
        out.put(types::list);
        out.put(std::uint32_t{0xffff'ffff});
    });
    CHECK(error_of(client, ++transaction, batch)->code == ErrorCode::MalformedMessage);

    CHECK(Client().frames_go_on());
}

TEST_CASE("limits: max_operations_per_block, in one batch and in several of a block") {
    RawClient client;
    std::uint64_t number = 0;
    Batch batch = closing(1, begin);
    add_many(batch, number, limits::max_operations_per_block + 1, spear::OperationFlags::none);
    auto reply = client.exchange(batch);
    REQUIRE(reply);
    CHECK(reply->error == ErrorCode::LimitExceeded);
    // The operations were refused; the block closed all the same.
    CHECK_FALSE(client.exchange(closing(1, end))->has_error);

    batch = {};
    batch.transaction = 2;
    batch.block = begin;
    add_many(batch, number, limits::max_operations_per_block, spear::OperationFlags::none);
    reply = client.exchange(batch);
    REQUIRE(reply);
    CHECK_FALSE(reply->has_error);
    batch = closing(2, begin);
    add_find_class(batch, ++number, "AActor");
    reply = client.exchange(batch);
    REQUIRE(reply);
    CHECK(reply->error == ErrorCode::LimitExceeded);
    CHECK_FALSE(client.exchange(closing(2, end))->has_error);
    CHECK(Client().frames_go_on());
}

TEST_CASE("limits: max_decoded_bytes: a short list of very many empty structs") {
    RawClient client;
    std::uint64_t transaction = 0, number = 0;
    Batch batch = new_round_trip();
    announce(batch, 64, {spear::TypeKind::call_shape, "EchoRecordArray", "", 0, 0, {{"Value", types::any}}, {}, 1});
    const std::uint64_t object = 1;
    number = 1;
    RawClient::add(batch, service::call_function, ++number, [&](spear::Encoder& out) {
        out.put(types::future);
        out.put(object);
        spear::encode_value(out, spear::ShapeId{64});
        const std::uint32_t count = 9'000'000;
        out.put(types::list);
        out.put(count);
        for (std::uint32_t index = 0; index < count; ++index) {
            out.put(types::dict);
            out.put(std::uint32_t{0});
        }
    });
    CHECK(error_of(client, ++transaction, batch)->code == ErrorCode::LimitExceeded);

    CHECK(Client().frames_go_on());
}

TEST_CASE("limits: max_queued_transactions") {
    RawClient client;
    std::uint64_t transaction = 0;
    // Queued transactions: another client keeps the engine from taking them.
    RawClient holder;
    Batch holds;
    holds.transaction = 1;
    holds.block = begin;
    add_find_class(holds, 1, "AActor");
    REQUIRE(holder.exchange(holds));
    std::vector<std::uint64_t> requests;
    for (std::size_t index = 0; index <= limits::max_queued_transactions; ++index) {
        requests.push_back(client.submit(closing(++transaction, begin)));
        requests.push_back(client.submit(closing(transaction, end)));
    }
    auto reply = client.wait(requests[2 * limits::max_queued_transactions]);
    REQUIRE(reply);
    CHECK(reply->error == ErrorCode::FrameMisuse);
    holder.close();
    for (std::size_t index = 0; index < 2 * limits::max_queued_transactions; ++index) {
        reply = client.wait(requests[index]);
        REQUIRE(reply);
        CHECK_FALSE(reply->has_error);
    }
    CHECK(Client().frames_go_on());
}

TEST_CASE("a result larger than a message is an error of its operation") {
    Client client;
    client.transact([&] {
        const spear::Object calls = client.game.new_object("URoundTripCalls");
        error_text<spear::LimitExceeded>([&] { calls.call("Bytes", std::int64_t{spear::limits::max_message_bytes}); });
        CHECK(calls.call("Bytes", 1000).size() == 1000);
    });
}

TEST_CASE("limits: max_path_segments") {
    Client client;
    client.transact([&] {
        const spear::Object calls = client.game.new_object("URoundTripCalls");
        std::string path = "Other";
        for (std::size_t segments = 1; segments < limits::max_path_segments; ++segments)
            path += ".Other";
        CHECK_THROWS_AS(calls[path].get<spear::Value>(), spear::NullObject); // it is as long as may be, and ends early
        CHECK(contains(error_text<spear::LimitExceeded>([&] { calls[path + ".Other"].get<spear::Value>(); }),
            "max_path_segments"));
    });
}

TEST_CASE("limits: max_type_weight: a few announcements that describe a value of very many parts end the session") {
    RawClient client;
    REQUIRE(client.connected());
    Batch batch;
    announce(batch, 64, {spear::TypeKind::structure, "FVector", "", 0, 0, {{"X", types::f64}, {"Y", types::f64}}, {}, 1});
    for (spear::TypeId number = 65; number < 65 + 40; ++number)
        announce(batch, number,
            {spear::TypeKind::structure, "FVector", "", 0, 0, {{"X", number - 1}, {"Y", number - 1}}, {}, 1});
    add_find_class(batch, 1, "AActor");
    (void)client.submit(batch);
    CHECK(client.lost());
    CHECK(Client().frames_go_on());
}

TEST_CASE("limits: max_announcements: one type too many ends the session; the SDK says so before it sends") {
    RawClient client;
    REQUIRE(client.connected());
    Batch batch;
    const spear::TypeInfo path{spear::TypeKind::path_shape, "A", "", 0, 0, {}, {}, 1};
    spear::Encoder out;
    for (std::size_t index = 0; index < limits::max_announcements; ++index)
        spear::encode_announcement(out, types::first_client_type + static_cast<spear::TypeId>(index), path);
    batch.types.assign(out.buffer.begin(), out.buffer.end());
    add_find_class(batch, 1, "AActor");
    auto reply = client.exchange(batch);
    REQUIRE(reply);
    CHECK(reply->values().size() == 1);
    batch = {};
    announce(batch, types::first_client_type + static_cast<spear::TypeId>(limits::max_announcements), path);
    add_find_class(batch, 2, "AActor");
    (void)client.submit(batch);
    CHECK(client.lost());
    CHECK(Client().frames_go_on());
}

TEST_CASE("limits: max_kept_results") {
    RawClient client;
    std::uint64_t number = 0;
    Batch batch = closing(1, begin);
    constexpr std::size_t too_many = 3, first = limits::max_operations_per_block;
    static_assert(limits::max_kept_results > first && limits::max_kept_results < 2 * first);
    add_many(batch, number, first, spear::OperationFlags::keep_result);
    auto reply = client.exchange(batch);
    REQUIRE(reply);
    CHECK(reply->errors().empty());
    CHECK_FALSE(client.exchange(closing(1, end))->has_error);
    batch = closing(2, begin);
    add_many(batch, number, limits::max_kept_results - first + too_many, spear::OperationFlags::keep_result);
    reply = client.exchange(batch);
    REQUIRE(reply);
    const auto errors = reply->errors();
    CHECK(errors.size() == too_many);
    CHECK(errors.rbegin()->first == number);
    CHECK(errors.rbegin()->second.code == ErrorCode::LimitExceeded);
    // Room again, once some are dropped.
    Batch drops = closing(2, end);
    drops.releases = {1, 2, 3};
    CHECK_FALSE(client.exchange(drops)->has_error);
    batch = closing(3, begin);
    add_many(batch, number, 3, spear::OperationFlags::keep_result);
    CHECK(client.exchange(batch)->errors().empty());
    CHECK_FALSE(client.exchange(closing(3, end))->has_error);
    CHECK(Client().frames_go_on());
}

TEST_CASE("limits: max_sessions") {
    std::vector<std::unique_ptr<RawClient>> clients;
    while (clients.size() <= limits::max_sessions && (clients.empty() || clients.back()->connected()))
        clients.push_back(std::make_unique<RawClient>(RawClient::all_signatures(), limits::max_lease_ms));
    REQUIRE_FALSE(clients.back()->connected());
    CHECK(clients.back()->connect_error().code == static_cast<std::uint16_t>(ErrorCode::LimitExceeded));
    CHECK(contains(clients.back()->connect_error().message, std::to_string(limits::max_sessions)));
    CHECK(clients.size() <= limits::max_sessions); // the shared one counts too
    CHECK_THROWS_AS(Client(), spear::LimitExceeded);
    clients.resize(clients.size() - 2);
    CHECK(eventually([] { // the server has heard of it
        try {
            return Client().frames_go_on();
        } catch (const spear::LimitExceeded&) {
            return false;
        }
    }));
}

TEST_CASE("limits: max_queued_bytes, of an engine that is told a smaller one") {
    spear::LaunchOptions options = launch_options();
    options.arguments.push_back("-SpearQueuedBytes=2000000"); // the constant would want a gigabyte
    spear::Instance instance = spear::launch(options);
    Client holder({.deadline = 30s}, instance);
    auto held = holder.instance.begin_frame();
    (void)holder.game.find_actors_by_class("AActor");

    RawClient client(RawClient::all_signatures(), 60'000, instance);
    const std::string text(1'200'000, 'x');
    Batch batch = closing(1, begin);
    add_find_class(batch, 1, text);
    const std::uint64_t waits = client.submit(batch); // for its frame
    batch = closing(1, end);
    add_find_class(batch, 2, text);
    auto reply = client.exchange(batch);
    REQUIRE(reply);
    CHECK(reply->error == ErrorCode::LimitExceeded);
    CHECK(contains(reply->message, "max_queued_bytes"));
    held.execute();
    holder.instance.end_frame().execute();
    reply = client.wait(waits);
    REQUIRE(reply);
    CHECK(reply->errors().at(1).code == ErrorCode::UnknownClass);

    batch = closing(2, begin); // room again: what was refused closed its block all the same
    add_find_class(batch, 3, text);
    CHECK(client.exchange(batch)->errors().size() == 1);
    CHECK_FALSE(client.exchange(closing(2, end))->has_error);
    CHECK(holder.frames_go_on());
}
