// SPDX-License-Identifier: MIT
// What a Session puts on the wire, and how it reads what comes back. The other end is the real wire library with a peer
// that records batches and answers as a test tells it; no engine. What the engine does with batches is tested in
// tests/end_to_end.
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <doctest/doctest.h>
#include <unistd.h>

#include "spear/spear.hpp"
#include "spear_wire.h"

using namespace spear;
using namespace std::chrono_literals;

namespace {

struct Operation {
    std::uint64_t number;
    std::uint16_t entry_point;
    OperationFlags flags;
    std::vector<std::byte> arguments;
};

struct Recorded {
    std::uint64_t session, request, transaction;
    std::uint8_t block;
    bool closes, abort, single_step;
    std::vector<Operation> operations;
    std::vector<std::uint64_t> releases;
};

/// A peer at a Unix socket. Unless told to hold back, it answers each wanted operation with the u64 number of it.
class Peer {
public:
    using Answer = std::function<void(const Operation&, Encoder&)>; ///< writes one answer record, or nothing

    explicit Peer(Answer answer = echo) : answer_(std::move(answer)) {
        address_ = "unix:@spear-sdk-test-" + std::to_string(::getpid()) + "-" + std::to_string(++count_);
        spear_server_callbacks callbacks{};
        callbacks.user = this;
        callbacks.connect = [](void* user, const spear_hello* hello, spear_wire_error*) {
            static_cast<Peer*>(user)->lease_ms = hello->lease_ms;
            return 1;
        };
        callbacks.disconnect = [](void*, std::uint64_t, const char*) {};
        callbacks.submit = [](void* user, std::uint64_t session, std::uint64_t request, const spear_batch* batch) {
            static_cast<Peer*>(user)->receive(session, request, *batch);
        };
        callbacks.status = [](void* user, std::uint64_t, spear_status* status) {
            *status = static_cast<Peer*>(user)->status;
        };
        callbacks.describe = [](void*, spear_description*) {};
        spear_server_options options{};
        options.address = address_.c_str();
        options.spear_version = version.data();
        options.default_lease_ms = limits::default_lease_ms;
        options.max_message_bytes = limits::max_message_bytes;
        options.max_sessions = 4;
        options.registry_directory = "";
        spear_wire_error error{};
        server_ = spear_server_start(&options, &callbacks, &error);
        INFO(error.message);
        REQUIRE(server_);
    }
    ~Peer() { stop(); }
    void stop() {
        if (server_)
            spear_server_stop(std::exchange(server_, nullptr));
    }

    std::shared_ptr<Session> connect(Milliseconds deadline = 5s) {
        return Session::connect({.address = address_, .deadline = deadline});
    }

    /// The next batch; fails the test if none comes.
    Recorded next() {
        std::unique_lock lock(mutex_);
        REQUIRE(changed_.wait_for(lock, 60s, [&] { return !batches_.empty(); }));
        Recorded batch = std::move(batches_.front());
        batches_.pop_front();
        return batch;
    }
    bool is_quiet(Milliseconds time = 50ms) {
        std::unique_lock lock(mutex_);
        return !changed_.wait_for(lock, time, [&] { return !batches_.empty(); });
    }
    void hold_back(bool value) { holds_back_ = value; }
    void reply(const Recorded& batch) {
        Encoder answers;
        for (const Operation& operation : batch.operations)
            answer_(operation, answers);
        spear_answers out{};
        out.answers = {reinterpret_cast<const std::uint8_t*>(answers.buffer.data()), answers.buffer.size()};
        spear_server_reply(server_, batch.session, batch.request, &out);
    }
    void refuse(const Recorded& batch, ErrorCode code, const char* message) {
        spear_answers out{};
        out.has_error = 1;
        out.error_code = static_cast<std::uint16_t>(code);
        out.error_message = message;
        spear_server_reply(server_, batch.session, batch.request, &out);
    }

    static void succeed(const Operation& operation, Encoder& out) {
        const std::size_t at = begin_answer(out, operation.number, AnswerState::succeeded);
        encode_value(out, operation.number);
        end_answer(out, at);
    }
    static void fail(const Operation& operation, Encoder& out, ErrorCode code, const char* message,
        AnswerState state = AnswerState::failed) {
        const std::size_t at = begin_answer(out, operation.number, state);
        encode_error(out, {code, message, "operation", "", ""});
        end_answer(out, at);
    }
    static void echo(const Operation& operation, Encoder& out) {
        if (operation.flags != OperationFlags::none)
            succeed(operation, out);
    }

    const std::string& address() const { return address_; }

    spear_status status{};
    std::atomic<std::uint32_t> lease_ms{0}; ///< of the client that connected last

private:
    void receive(std::uint64_t session, std::uint64_t request, const spear_batch& batch) {
        Recorded recorded{session, request, batch.transaction, batch.block, batch.closes != 0, batch.abort != 0,
            batch.single_step != 0, {}, {batch.releases, batch.releases + batch.release_count}};
        Decoder in({reinterpret_cast<const std::byte*>(batch.operations.data), batch.operations.size});
        while (in.ok() && in.remaining() != 0) {
            const OperationHeader header = decode_operation_header(in);
            const auto raw = in.get_raw(header.bytes);
            recorded.operations.push_back({header.number, header.entry_point, header.flags, {raw.begin(), raw.end()}});
        }
        if (!holds_back_)
            reply(recorded);
        const std::lock_guard lock(mutex_);
        batches_.push_back(std::move(recorded));
        changed_.notify_all();
    }

    static inline int count_ = 0;
    Answer answer_;
    std::string address_;
    spear_server* server_ = nullptr;
    std::atomic<bool> holds_back_{false};
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Recorded> batches_;
};

constexpr auto& any_operation = unreal_service::get_path_name; // takes an object, runs in any frame
const auto release = unreal_service::release_object;           // takes an object, runs on the game thread
const ObjectRef object{0x1'0000'0001, types::null};

Future<Value> record_async(Session& session) {
    OperationBuilder operation(session, unreal_service::get_property);
    encode_value(operation.out(), object);
    operation.put_shape(session.path_shape("A.B"));
    return Future<Value>(operation.async());
}
Value run(Session& session) {
    OperationBuilder operation(session, unreal_service::get_property);
    encode_value(operation.out(), object);
    operation.put_shape(session.path_shape("A.B"));
    return detail::perform<CallMode::sync, Value>(operation, session.shared_from_this());
}

} // namespace

TEST_CASE("G5 G8: a block of asynchronous operations is one message, sent when it closes, and does not wait") {
    Peer peer;
    peer.hold_back(true);
    const auto session = peer.connect();
    Future<Value> a, b;
    {
        Frame frame(session, BlockKind::begin);
        a = record_async(*session);
        b = record_async(*session);
        session->send(release, object);
        CHECK(peer.is_quiet());
        frame.execute();
    }
    const Recorded begin = peer.next();
    CHECK(begin.block == SPEAR_BLOCK_BEGIN);
    CHECK(begin.closes);
    CHECK_FALSE(begin.abort);
    REQUIRE(begin.operations.size() == 3);
    CHECK(begin.operations[0].number == a.operation().number());
    CHECK(begin.operations[2].flags == OperationFlags::none);
    Frame(session, BlockKind::end).execute();
    const Recorded end = peer.next();
    CHECK(end.block == SPEAR_BLOCK_END);
    CHECK(end.transaction == begin.transaction);
    CHECK(end.operations.empty());
    CHECK_FALSE(a.is_ready());
    peer.reply(begin);
    CHECK(a.get() == Value(a.operation().number()));
    CHECK(b.get() == Value(b.operation().number()));
    peer.reply(end);
}

TEST_CASE("G4: the first synchronous operation sends what is recorded; the close sends the rest") {
    Peer peer;
    const auto session = peer.connect();
    Frame frame(session, BlockKind::begin);
    const auto future = record_async(*session);
    CHECK(run(*session) == Value(future.operation().number() + 1));
    const Recorded first = peer.next();
    CHECK_FALSE(first.closes);
    CHECK(first.operations.size() == 2);
    run(*session);
    CHECK(peer.next().operations.size() == 1);
    record_async(*session);
    frame.execute();
    const Recorded last = peer.next();
    CHECK(last.closes);
    CHECK(last.operations.size() == 1);
}

TEST_CASE("G4: get() of a future of the own open block sends it and waits; another thread's get() waits for that") {
    Peer peer;
    const auto session = peer.connect();
    Frame frame(session, BlockKind::begin);
    const auto future = record_async(*session);
    std::thread other([&] { CHECK(future.get() == Value(future.operation().number())); });
    CHECK(future.get() == Value(future.operation().number()));
    other.join();
    CHECK_FALSE(peer.next().closes);
    frame.execute();
}

TEST_CASE("G4: entering a block waits while the previous block of that kind is pending") {
    Peer peer;
    peer.hold_back(true);
    const auto session = peer.connect();
    Frame(session, BlockKind::begin).execute();
    Frame(session, BlockKind::end).execute();
    const Recorded begin = peer.next();
    const Recorded end = peer.next();
    session->set_deadline(100ms);
    peer.status.state = SPEAR_STATE_HELD_BY_OTHER;
    std::snprintf(peer.status.holder, sizeof peer.status.holder, "somebody");
    try {
        Frame(session, BlockKind::begin).execute();
        FAIL("no error");
    } catch (const HeldByClient& error) {
        CHECK(std::string(error.what()).find("somebody") != std::string::npos);
    }
    peer.reply(begin);
    Frame(session, BlockKind::begin).execute(); // the end may still be pending
    CHECK_THROWS_AS(Frame(session, BlockKind::end).execute(), HeldByClient);
    peer.reply(end);
    Frame(session, BlockKind::end).execute();
}

TEST_CASE("a deadline says what the engine does") {
    Peer peer;
    peer.hold_back(true);
    const auto session = peer.connect(50ms);
    const auto ask = [&] { session->call(engine_service::ping, "x"); };
    peer.status.state = SPEAR_STATE_BUSY;
    CHECK_THROWS_AS(ask(), EngineBusy);
    peer.status.state = SPEAR_STATE_HELD_BY_YOU;
    CHECK_THROWS_AS(ask(), NeedsFrames);
    peer.status.state = SPEAR_STATE_EXITING;
    CHECK_THROWS_AS(ask(), EngineExited);
    peer.status.state = SPEAR_STATE_RUNNING;
    CHECK_THROWS_AS(ask(), DeadlineExceeded);
}

TEST_CASE("game-thread operations need a block, of this thread, and blocks come in order") {
    Peer peer;
    const auto session = peer.connect();
    CHECK_THROWS_AS(run(*session), NotInFrame);
    CHECK_THROWS_AS((void)Frame(session, BlockKind::end), FrameMisuse);
    {
        Frame frame(session, BlockKind::begin);
        CHECK_THROWS_AS((void)Frame(session, BlockKind::begin), FrameMisuse);
        CHECK_THROWS_AS((void)Frame(session, BlockKind::end), FrameMisuse);
        CHECK_THROWS_AS(session->flush(), FrameMisuse);
        std::thread([&] {
            CHECK_THROWS_AS(run(*session), WrongThread);
            CHECK_THROWS_AS((void)Frame(session, BlockKind::begin), WrongThread);
            CHECK_THROWS_AS(frame.execute(), WrongThread);
            CHECK(session->perform_as<CallMode::sync, std::uint64_t>(any_operation, object) !=
                  0); // any frame: any thread
        }).join();
        CHECK(frame.is_open());
        frame.execute();
        CHECK_THROWS_AS(frame.execute(), FrameMisuse);
    }
    CHECK_THROWS_AS(run(*session), NotInFrame);
    CHECK_THROWS_AS((void)Frame(session, BlockKind::begin), FrameMisuse);
    Frame(session, BlockKind::end).execute();
}

TEST_CASE("operations of the server thread travel on their own, also within a block") {
    Peer peer;
    const auto session = peer.connect();
    Frame frame(session, BlockKind::begin);
    record_async(*session);
    session->perform_as<CallMode::sync, std::uint64_t>(engine_service::ping, "x");
    const Recorded ping = peer.next();
    CHECK(ping.block == SPEAR_BLOCK_NONE);
    CHECK(ping.operations.size() == 1);
    frame.execute();
    CHECK(peer.next().operations.size() == 1);
}

TEST_CASE("a block left by an exception submits what was recorded and closes the transaction") {
    Peer peer;
    const auto session = peer.connect();
    try {
        Frame frame(session, BlockKind::begin);
        record_async(*session);
        throw std::runtime_error("the user's");
    } catch (const std::runtime_error& error) {
        CHECK(std::string(error.what()) == "the user's");
    }
    const Recorded left = peer.next();
    CHECK(left.block == SPEAR_BLOCK_BEGIN);
    CHECK(left.closes);
    CHECK(left.abort);
    CHECK(left.operations.size() == 1);
    CHECK(peer.is_quiet());
    Frame(session, BlockKind::begin).execute();
}

TEST_CASE("an argument that cannot be converted leaves no trace") {
    Peer peer;
    const auto session = peer.connect();
    Frame frame(session, BlockKind::begin);
    const Object target(session, object);
    CHECK_THROWS_AS(target.send("F", 1, Future<Value>()), ArgumentError);
    frame.execute();
    CHECK(peer.next().operations.empty());
}

TEST_CASE("G6: fire-and-forget failures are raised by the execute() that knows them, else by the next block or flush") {
    Peer peer([](const Operation& operation, Encoder& out) {
        if (operation.flags == OperationFlags::none)
            Peer::fail(operation, out, ErrorCode::StaleObject, "gone");
        else
            Peer::succeed(operation, out);
    });
    const auto session = peer.connect();
    SUBCASE("a block that holds the game thread waits for them; the transaction is closed") {
        Frame frame(session, BlockKind::begin);
        run(*session);
        session->send(release, object);
        session->send(release, object);
        try {
            frame.execute();
            FAIL("no error");
        } catch (const StaleObject& error) {
            CHECK(std::string(error.what()).find("1 more") != std::string::npos);
        }
        peer.next();
        CHECK(peer.next().closes);
        const Recorded end = peer.next();
        CHECK(end.block == SPEAR_BLOCK_END);
        CHECK(end.operations.empty());
        Frame(session, BlockKind::begin).execute();
    }
    SUBCASE("flush") {
        Frame frame(session, BlockKind::begin);
        session->send(release, object);
        try {
            frame.execute();
        } catch (const StaleObject&) {
            return; // the answer was faster than the return from the close: as good
        }
        CHECK_THROWS_AS(session->flush(), StaleObject);
        CHECK_NOTHROW(session->flush());
    }
    SUBCASE("next begin_frame") {
        peer.hold_back(true);
        Frame begin(session, BlockKind::begin);
        session->send(release, object);
        begin.execute();
        Frame(session, BlockKind::end).execute();
        peer.reply(peer.next());
        peer.reply(peer.next());
        peer.hold_back(false);
        CHECK_THROWS_AS((void)Frame(session, BlockKind::begin), StaleObject);
        Frame(session, BlockKind::begin).execute();
    }
}

TEST_CASE("G6: an asynchronous failure is stored in its future; others are untouched") {
    Peer peer([](const Operation& operation, Encoder& out) {
        if (operation.number == 2)
            Peer::fail(operation, out, ErrorCode::UnknownFunction, "no such function");
        else
            Peer::succeed(operation, out);
    });
    const auto session = peer.connect();
    Frame frame(session, BlockKind::begin);
    const auto a = record_async(*session), b = record_async(*session), c = record_async(*session);
    frame.execute();
    CHECK_NOTHROW(a.get());
    CHECK_THROWS_AS(b.get(), UnknownFunction);
    CHECK_THROWS_AS(b.get(), UnknownFunction);
    CHECK_NOTHROW(c.get());
}

TEST_CASE("G6: DependencyFailed carries the error of the argument") {
    Peer peer([](const Operation& operation, Encoder& out) {
        Peer::fail(operation, out, operation.number == 1 ? ErrorCode::UnknownObject : ErrorCode::DependencyFailed,
            operation.number == 1 ? "first" : "dependent");
    });
    const auto session = peer.connect();
    Frame frame(session, BlockKind::begin);
    const Future<Object> actor = session->async(unreal_service::find_actor_by_name, nullptr, "AActor", "x");
    const auto location = actor.async("K2_GetActorLocation");
    frame.execute();
    try {
        location.get();
        FAIL("no error");
    } catch (const DependencyFailed& error) {
        REQUIRE(error.original());
        CHECK(error.original()->code == ErrorCode::UnknownObject);
    }
}

TEST_CASE("G8: a future travels as its number; it is released when its last copy and last use are gone") {
    Peer peer;
    const auto session = peer.connect();
    std::uint64_t number = 0;
    {
        Frame frame(session, BlockKind::begin);
        {
            const auto future = record_async(*session);
            number = future.operation().number();
            const Object target(session, object);
            target.send("F", arg("A", future), 1);
        }
        frame.execute();
    }
    const Recorded begin = peer.next();
    CHECK(begin.releases.empty());
    Decoder in(begin.operations[1].arguments);
    in.get_raw(4 + 8);
    in.get_raw(4 + 4);
    CHECK(in.get<TypeId>() == types::future);
    CHECK(in.get<std::uint64_t>() == number);
    Frame(session, BlockKind::end).execute();
    session->flush();
    std::vector<std::uint64_t> released =
        peer.next().releases; // with the end block if the begin block was answered before it was sent
    Frame(session, BlockKind::begin).execute();
    for (const std::uint64_t late : peer.next().releases)
        released.push_back(late);
    CHECK(released == std::vector<std::uint64_t>{number});
}

TEST_CASE("G7: an aborted batch fails its futures with TransactionAborted") {
    Peer peer;
    peer.hold_back(true);
    const auto session = peer.connect();
    Frame frame(session, BlockKind::begin);
    const auto future = record_async(*session);
    frame.execute();
    peer.refuse(peer.next(), ErrorCode::TransactionAborted, "the engine is exiting");
    CHECK_THROWS_AS(future.get(), TransactionAborted);
}

TEST_CASE("late results: NeedsFrames while this thread holds the engine, else they are waited for") {
    std::atomic<int> refusals{3};
    Peer peer([&](const Operation& operation, Encoder& out) {
        if (operation.entry_point == AllEntryPoints::index_of<decltype(engine_service::wait_for_result)>()) {
            if (refusals-- > 0)
                Peer::fail(operation, out, ErrorCode::NeedsFrames, "held");
            else
                Peer::succeed(operation, out);
        } else {
            Peer::fail(operation, out, ErrorCode::NeedsFrames, "latent", AnswerState::pending);
        }
    });
    const auto session = peer.connect();
    Future<Value> future;
    {
        Frame frame(session, BlockKind::begin);
        future = record_async(*session);
        CHECK_THROWS_AS(future.get(), NeedsFrames);
        frame.execute();
    }
    CHECK_THROWS_AS(future.get(), NeedsFrames); // the game thread waits for the end block
    Frame(session, BlockKind::end, {.single_step = true}).execute();
    CHECK_THROWS_AS(future.get(), NeedsFrames);
    Frame(session, BlockKind::begin).execute();
    Frame(session, BlockKind::end).execute();
    CHECK_FALSE(future.is_ready());
    CHECK_NOTHROW(future.get());
}

TEST_CASE("after close or loss everything raises Disconnected, also what waits already") {
    Peer peer;
    peer.hold_back(true);
    const auto session = peer.connect();
    Future<Value> future;
    {
        Frame frame(session, BlockKind::begin);
        future = record_async(*session);
        frame.execute();
    }
    std::thread waiting([&] { CHECK_THROWS_AS(future.get(), Disconnected); });
    std::this_thread::sleep_for(20ms);
    SUBCASE("closed") { session->close(); }
    SUBCASE("lost") { peer.stop(); }
    waiting.join();
    CHECK_FALSE(session->is_open());
    CHECK_THROWS_AS(future.get(), Disconnected);
    CHECK_THROWS_AS(session->call(engine_service::ping, "x"), Disconnected);
    CHECK_THROWS_AS((void)Frame(session, BlockKind::end), Disconnected);
    session->close();
}

TEST_CASE("a result of another type than asked for names operation, value and type") {
    Peer peer;
    const auto session = peer.connect();
    Frame frame(session, BlockKind::begin);
    const Object target(session, object);
    try {
        target.call<unreal::FVector>("GetActorLocation");
        FAIL("no error");
    } catch (const WrongType& error) {
        CHECK(error.info().operation == "K2_GetActorLocation");
        CHECK(error.info().expected == "FVector");
    }
    CHECK(target.call<std::uint8_t>("F") == 2);
    CHECK_THROWS_AS(Object().call("F"), NullObject);
}

TEST_CASE("limits: what no message may carry is refused when it is recorded; the block stays usable") {
    Peer peer;
    const auto session = peer.connect();
    Frame frame(session, BlockKind::begin);
    const Object target(session, object);
    CHECK_THROWS_AS(target.send("F", std::string(limits::max_message_bytes, 'x')), LimitExceeded);
    CHECK_NOTHROW(target.send("F", "x"));
    frame.execute();
    CHECK(peer.next().operations.size() == 1);
}

TEST_CASE("limits: a session announces so many types, and one more is refused before it is sent") {
    Peer peer;
    const auto session = peer.connect();
    TypeInfo info;
    info.kind = TypeKind::path_shape;
    const auto announce_until = [&](std::size_t count) {
        for (std::size_t i = session->types().client->next() - types::first_client_type; i < count; ++i) {
            info.name = std::to_string(i);
            session->number_of(info);
        }
    };
    announce_until(limits::max_announcements);
    CHECK_THROWS_AS(announce_until(limits::max_announcements + 1), LimitExceeded);
    CHECK_THROWS_AS(session->path_shape("A.B"), LimitExceeded);
}

TEST_CASE("limits: leases that are too short or too long become the shortest and the longest") {
    Peer peer;
    const auto agreed = [&](Milliseconds lease, bool no_lease = false) {
        Session::connect({.address = peer.address(), .lease = lease, .no_lease = no_lease});
        return peer.lease_ms.load();
    };
    CHECK(agreed(1ms) == limits::min_lease_ms);
    CHECK(agreed(1234ms) == 1234);
    CHECK(agreed(Milliseconds(limits::max_lease_ms) + 1ms) == limits::max_lease_ms);
    CHECK(agreed(0ms) == limits::default_lease_ms);
    CHECK(agreed(0ms, true) == SPEAR_LEASE_OFF);
}

TEST_CASE("statistics: both ends count messages and bytes where they write and read them") {
    Peer peer;
    const auto session = peer.connect();
    const auto none = session->statistics();
    CHECK(none.sent.messages == 0);
    CHECK(none.server_received.messages == 0);
    std::string text(1000, 'x');
    for (int i = 0; i < 3; ++i)
        session->async(engine_service::ping, text).wait(60s);
    const auto now = session->statistics();
    CHECK(now.sent.messages == 3);
    CHECK(now.sent.bytes > 3000);
    CHECK(now.received.messages == 3);
    CHECK(now.received.bytes > 3 * 8);
    CHECK(now.server_received.messages == 3);
    CHECK(now.server_received.bytes == now.sent.bytes);
    CHECK(now.server_sent.messages == 3);
    CHECK(now.server_sent.bytes == now.received.bytes);
}

TEST_CASE("many threads at once") {
    Peer peer;
    const auto session = peer.connect();
    std::vector<std::thread> threads;
    for (int t = 0; t < 8; ++t) {
        threads.emplace_back([&] {
            for (int i = 0; i < 200; ++i) {
                const auto future = session->async(any_operation, object);
                const auto copy = future;
                CHECK(copy.operation().get().view.type == types::u64);
                session->perform_as<CallMode::sync, std::uint64_t>(engine_service::ping, "x");
            }
        });
    }
    for (auto& thread : threads)
        thread.join();
}
