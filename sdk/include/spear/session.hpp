// SPDX-License-Identifier: MIT
#pragma once

// Session: one client's connection to one engine. Instance (instance.hpp) is made of a session and is what most
// programs hold; the session is the bottom, where entry points are called:
//
//     auto session = spear::Session::connect({.address = "unix:/run/user/1000/spear/editor.sock"});
//     spear::Object actor_class = session->call(spear::unreal_service::find_class, "AActor");
//     auto found = session->async(spear::unreal_service::find_actor_by_name, nullptr, actor_class, "Table_3");
//
// Threads: every member may be called from any thread. Blocks, and game-thread operations in them, belong to the thread
// that opened the block (WrongThread elsewhere). An I/O thread of the session receives answers and renews the lease; it
// never runs user code except the log handler (log.hpp).

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spear/arguments.hpp"
#include "spear/future.hpp"
#include "spear/operation.hpp"
#include "spear/value.hpp"

namespace spear {

class Object;

/// How to connect.
struct SessionOptions {
    /// "unix:/path", "unix:@abstract", "tcp://host:port", or empty for the only engine of this user that runs.
    std::string address{};
    /// Needed unless the address is a Unix socket or loopback.
    std::string token{};
    /// What other clients see in HeldByClient; empty: the program's name and process id.
    std::string client_name{};
    /// How long the server keeps a session whose process shows no life; the I/O thread renews it every third of that.
    /// 0: the server's default. `no_lease` for sessions under a native debugger, which stops the I/O thread as well.
    Milliseconds lease{0};
    bool no_lease = false;
    /// How long to wait for the connection.
    Milliseconds connect_timeout{10'000};
    /// How long an operation may wait for its answer before it raises (HeldByClient, EngineBusy, ...).
    Milliseconds deadline{limits::default_deadline_ms};
    /// Whether operations go through shared memory where client and engine share a machine (else, and elsewhere, by
    /// RPC: the same semantics, slower). SPEAR_CHANNEL=off in the environment of either turns it off as well.
    bool channel = true;
    /// Whether waits may spin for some microseconds before they sleep, on both sides: faster, and it keeps a core busy.
    /// Never on a single core. SPEAR_SPIN=off in the environment of either turns it off as well.
    bool spin = true;
};

/// The two kinds of block of a transaction; numbers as on the wire.
enum class BlockKind : std::uint8_t { begin = 1, end = 2 };

/// "begin_frame" or "end_frame".
constexpr std::string_view block_name(BlockKind kind) { return kind == BlockKind::begin ? "begin_frame" : "end_frame"; }

namespace detail {

/// The SDK's type for an entry point's result: objects with their session, reflected values as Value.
template <typename R>
struct ClientResultOf {
    using type = R;
};
template <>
struct ClientResultOf<ObjectRef> {
    using type = Object;
};
template <>
struct ClientResultOf<std::vector<ObjectRef>> {
    using type = std::vector<Object>;
};
template <>
struct ClientResultOf<std::map<std::string, ObjectRef>> {
    using type = std::map<std::string, Object>;
};
template <>
struct ClientResultOf<AnyView> {
    using type = Value;
};

} // namespace detail

/// What calling entry point E gives.
template <typename E>
using ClientResult = typename detail::ClientResultOf<typename E::Result>::type;

class Session final : public std::enable_shared_from_this<Session>, public TypeSource {
public:
    // Connection

    /// Connects and compares versions and entry points. Raises EngineNotRunning, VersionMismatch, Unauthorized,
    /// LimitExceeded, ArgumentError (malformed address), AmbiguousName (no address, and several engines run).
    static std::shared_ptr<Session> connect(const SessionOptions& options);
    /// Closes.
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Ends the session: an open transaction is abandoned, waits of other threads and pending futures fail with
    /// Disconnected, as does everything afterwards. Closing twice is fine.
    void close() noexcept;
    /// False once it was closed or the connection is lost.
    bool is_open() const noexcept;
    /// The server's number of this session.
    std::uint64_t id() const noexcept;
    const std::string& address() const noexcept;
    /// Whether operations go through shared memory.
    bool uses_channel() const noexcept;
    Milliseconds deadline() const noexcept;
    void set_deadline(Milliseconds deadline) noexcept;

    /// What the engine is doing, asked from its server thread.
    struct Status {
        enum class State { running, held_by_you, held_by_other, busy, exiting };
        State state = State::running;
        std::uint64_t frame = 0;    ///< the engine's frame counter
        Milliseconds frames_age{0}; ///< since the last frame began
        std::string holder{};       ///< who holds the engine, if somebody does
        std::string detail{};
    };
    Status status(Milliseconds timeout = Milliseconds(2000));

    /// Messages one way: batches of operations, or answers to them (one each). Bytes of what is in them (operations,
    /// values, announcements), without the transport's envelope.
    struct Traffic {
        std::uint64_t messages = 0;
        std::uint64_t bytes = 0;
    };
    /// What has travelled so far, counted at both ends where messages are written and read. Lease, status and this very
    /// question are not counted.
    struct Statistics {
        Traffic sent;            ///< by this client
        Traffic received;        ///< by this client
        Traffic server_received; ///< by the server, from this client
        Traffic server_sent;     ///< by the server, to this client
        /// Results that the engine keeps because futures of this session name them, as of its last batch or release. It
        /// hears of dropped futures with the next message.
        std::uint64_t kept_results = 0;
    };
    /// Asks the server thread: also answered while the engine is held. Raises Disconnected, DeadlineExceeded (default:
    /// the session's deadline).
    Statistics statistics(std::optional<Milliseconds> timeout = {});

    /// Called when the connection was lost, before an error says so, to explain it better (the launcher knows exit code
    /// and log of its engine). Runs on the thread that raises.
    using LossExplainer = std::function<std::optional<ErrorInfo>()>;
    void set_loss_explainer(LossExplainer explainer);

    // Entry points

    /// Synchronous: it has run when this returns. Arguments are values or futures.
    template <typename E, typename... A>
    ClientResult<E> call(const E& entry_point, const A&... arguments) {
        return perform<CallMode::sync>(entry_point, arguments...);
    }
    /// Asynchronous.
    template <typename E, typename... A>
    Future<ClientResult<E>> async(const E& entry_point, const A&... arguments) {
        return perform<CallMode::async>(entry_point, arguments...);
    }
    /// Fire-and-forget.
    template <typename E, typename... A>
    void send(const E& entry_point, const A&... arguments) {
        perform<CallMode::send>(entry_point, arguments...);
    }
    template <CallMode mode, typename E, typename... A>
    CallResult<mode, ClientResult<E>> perform(const E& entry_point, const A&... arguments) {
        return perform_as<mode, ClientResult<E>>(entry_point, arguments...);
    }
    /// The same with the result read as an R.
    template <CallMode mode, typename R, typename E, typename... A>
    CallResult<mode, R> perform_as(const E& entry_point, const A&... arguments) {
        OperationBuilder operation(*this, entry_point);
        detail::put_parameters<E>(operation, arguments...);
        return detail::perform<mode, R>(operation, shared_from_this());
    }

    // Blocks (Frame in frame.hpp is these as an RAII object)

    /// Opens a block for this thread. Waits while the previous block of the same kind is pending (G4). begin: first
    /// raises the fire-and-forget failures that became known since. Raises FrameMisuse (nested, or out of order),
    /// WrongThread (another thread's transaction is open), and what waits raise.
    void open_block(BlockKind kind);
    /// Closes the open block: sends what is recorded (an all-asynchronous block is one message). Then raises the
    /// fire-and-forget failures that are known: see Frame::execute. `single_step` counts for end blocks.
    void close_block(BlockKind kind, bool single_step = false);
    /// The way out when close_block cannot be reached: sends what was recorded, closes the whole transaction with an
    /// empty end block, and has failures logged. Nothing to do if no transaction is open. Any thread.
    void abandon_transaction() noexcept;
    /// Whether a block is open, and on which side of it this thread is.
    std::optional<BlockKind> open_block_of_this_thread() const noexcept;
    bool is_transaction_open() const noexcept;

    /// Waits until everything sent so far has run, then raises the first of the fire-and-forget failures not yet
    /// raised. Raises FrameMisuse within an open block.
    void flush();
    /// The fire-and-forget failures not yet raised, which it forgets.
    std::vector<ErrorInfo> take_failures();

    // Types

    /// Both sides' announced types: what decoding needs. Reading is safe while answers arrive.
    TypeTables types() const noexcept;
    ValueContext value_context() noexcept { return {types(), this}; }
    DecodeContext decode_context() noexcept { return {types(), nullptr, this}; }
    TypeId number_of(const TypeInfo& info) override;
    /// The number of a call: the function's name (aliases are resolved) and the arguments' names, empty for positional
    /// ones. The same question gives the same number, so callers may keep it, for this session.
    ShapeId call_shape(std::string_view function, std::span<const std::string_view> argument_names);
    /// The number of a property path, "RootComponent.RelativeLocation.X".
    ShapeId path_shape(std::string_view path);

    /// "unreal_service.find_class", or "SetActorScale3D" for a call of that shape.
    std::string describe_operation(std::uint16_t entry_point, TypeId shape) const;

private:
    friend class OperationHandle;
    friend class OperationBuilder;
    friend struct detail::OperationSlab;
    struct Impl;
    explicit Session(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

namespace detail {

[[noreturn]] void throw_result_error(
    CodecError error, const RawResult& result, Session& session, std::string_view wanted);

template <typename T>
T decode_result(const RawResult& result, const std::shared_ptr<Session>& session) {
    if constexpr (std::is_same_v<T, Value>) {
        return Value::decode(result.view, session->value_context());
    } else {
        T value{};
        const auto read = [&](TypeId type) {
            Decoder in(result.view.payload);
            const CodecError error = decode_element(in, type, session->decode_context(), value);
            return error == CodecError::none && !in.ok() ? CodecError::malformed : error;
        };
        CodecError error = read(result.view.type);
        if (error == CodecError::wrong_type) {
            // A function with out-parameters gives a struct, "<Function>_Result", whose first field is the return
            // value.
            const TypeInfo* info = session->types().find(result.view.type);
            if (info && info->kind == TypeKind::structure && info->name.ends_with("_Result") && !info->fields.empty() &&
                info->fields.front().name == "ReturnValue") {
                error = read(info->fields.front().type);
            }
        }
        if (error != CodecError::none)
            throw_result_error(error, result, *session, Codec<T>::name);
        return value;
    }
}

} // namespace detail
} // namespace spear

#include "spear/object.hpp" // IWYU pragma: keep (results of entry points)
