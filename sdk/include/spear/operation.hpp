// SPDX-License-Identifier: MIT
#pragma once

// The bottom of the SDK: one operation, from its arguments to the bytes of its result. Session::call, Object::call, ...
// are made of it, and so are language bindings, which write arguments and read results without going through Value:
//
//     spear::OperationBuilder operation(session, spear::unreal_service::call_function);
//     spear::encode_value(operation.out(), object.ref());
//     operation.put_shape(shape);                                // from Session::call_shape, kept by the caller
//     ... encode_value / encode_typed / put_future per argument ...
//     spear::RawResult result = operation.call();                // or .async(), .send()

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "spear/codec.hpp"
#include "spear/entry_points/all.hpp"
#include "spear/error.hpp"
#include "spear/wire_type.hpp"

namespace spear {

class Session;
struct RawResult;

using Milliseconds = std::chrono::milliseconds;

/// What a caller wants to do when a wait is about to block its thread: on the waiting thread, before it
/// sleeps, connects or asks the server, and never if the answer came within the first short spin. May run under the
/// session's lock: it must not block, nor call the SDK. (Python gives up its lock there.)
struct BeforeSleep {
    void (*function)(void* user) = nullptr;
    void* user = nullptr;

    void operator()() const {
        if (function)
            function(user);
    }
};

namespace detail {
struct OperationState;
struct OperationSlab;
} // namespace detail

/// A recorded operation that has, or will have, a result. Copyable, thread-safe; Future<T> is this with a type. When
/// the last copy goes, the server is told to forget the result.
class OperationHandle {
public:
    OperationHandle() noexcept = default;
    OperationHandle(const OperationHandle& other) noexcept : state_(other.state_) {
        if (state_)
            add_user();
    }
    OperationHandle(OperationHandle&& other) noexcept : state_(std::exchange(other.state_, nullptr)) {}
    OperationHandle& operator=(OperationHandle other) noexcept {
        std::swap(state_, other.state_);
        return *this;
    }
    ~OperationHandle() {
        if (state_)
            drop_user();
    }

    bool valid() const noexcept { return state_ != nullptr; }
    /// The operation's number: what travels when the future is an argument.
    std::uint64_t number() const noexcept;
    /// Null if it is not valid.
    const std::shared_ptr<Session>& session() const noexcept;

    /// Whether get() would return (or raise) at once.
    bool is_ready() const noexcept;

    /// Waits for the result. Any thread; blocks without holding any lock of the SDK.
    /// - If the operation is recorded in the block that this thread has open, sends what is recorded and so holds the
    /// game thread
    ///   until the block closes (G4). If another thread has recorded it, waits until that thread sends it.
    /// - Raises the operation's own error; NeedsFrames at once if the result takes further frames while this thread
    /// holds the engine;
    ///   HeldByClient, EngineBusy, EngineExited, Disconnected or DeadlineExceeded when the deadline has passed
    ///   (default: the session's).
    RawResult get(std::optional<Milliseconds> deadline = {}, BeforeSleep before_sleep = {}) const;

    /// The same wait without result or the operation's error: false if the timeout has passed.
    bool wait(Milliseconds timeout) const;

private:
    friend class Session;
    friend class OperationBuilder;
    explicit OperationHandle(detail::OperationState* state) noexcept : state_(state) {} // takes over one user of it
    void add_user() const noexcept;
    void drop_user() const noexcept;

    detail::OperationState* state_ = nullptr; // lives, and keeps its session, as long as somebody has a handle of it
};

/// A result as it came: a view of one value, and what keeps its bytes. Read it with Session::types().
struct RawResult {
    OperationHandle operation{}; ///< keeps the bytes; not valid for a result of OperationBuilder::call_here
    AnyView view{};
    std::uint16_t entry_point = 0; ///< with the shape: names the operation in errors (Session::describe_operation)
    TypeId shape = types::null;
    std::uint64_t frame = 0; ///< the engine's frame in which the operation ran
    ByteBuffer own{};        ///< the bytes, if no operation keeps them
};

/// Collects the arguments of one operation, then performs it in one of three ways. Destroyed without that, it leaves no
/// trace: if an argument cannot be converted, just let the exception pass. Belongs to one thread. Builders may nest (an
/// argument's conversion may perform operations of its own). The three ways raise NotInFrame and WrongThread
/// (game-thread operations outside of a block, or in the block of another thread), Disconnected, and FrameMisuse (an
/// argument is a future not sent yet that this operation would overtake).
class OperationBuilder {
public:
    template <typename E>
        requires requires { E::runs_on; }
    OperationBuilder(Session& session, const E&) : OperationBuilder(session, AllEntryPoints::index_of<E>()) {}
    OperationBuilder(Session& session, std::uint16_t entry_point);
    OperationBuilder(const OperationBuilder&) = delete;
    OperationBuilder& operator=(const OperationBuilder&) = delete;
    ~OperationBuilder();

    Session& session() noexcept { return session_; }
    /// Arguments are values one after another: type number and payload.
    Encoder& out() noexcept { return encoder_; }
    /// For encode_typed.
    TypeSource& types() noexcept;
    /// Appends a future as the next argument. Raises ArgumentError (a WrongType) if it is of another session.
    void put_future(const OperationHandle& operation);
    /// Appends a call or path shape as the next argument, and remembers it for error texts.
    void put_shape(ShapeId shape);

    /// Synchronous: it has run on the game thread when this returns (G3).
    RawResult call(std::optional<Milliseconds> deadline = {});
    /// The same with a result whose bytes are this builder's, where that is faster: valid until it goes, or `out()` is
    /// written again.
    RawResult call_here(std::optional<Milliseconds> deadline = {}, BeforeSleep before_sleep = {});
    /// Asynchronous: recorded; runs in program order.
    OperationHandle async();
    /// Fire-and-forget: a failure is raised when the block ends or later (frame.hpp).
    void send();

private:
    friend class Session;
    /// Writes the operation into the place for calls of the shared memory channel, if it may go there, and waits.
    bool call_directly(RawResult& result, std::optional<Milliseconds> deadline, BeforeSleep before_sleep);

    Session& session_;
    std::uint16_t entry_point_;
    TypeId shape_ = types::null;
    Encoder encoder_; // its buffer comes from, and returns to, a pool of this thread
    std::vector<OperationHandle> futures_;
};

} // namespace spear
