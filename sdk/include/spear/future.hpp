// SPDX-License-Identifier: MIT
#pragma once

// Future<T>: the result of an asynchronous operation.
//
//     spear::Future<spear::unreal::FVector> location = actor.async<spear::unreal::FVector>("K2_GetActorLocation");
//     other.send("K2_SetActorLocation", spear::arg("NewLocation", location), ...);   // an argument of later operations
//     (G8) fmt::print("{}\n", location.get().X);                                          // or its value

#include <optional>
#include <utility>

#include "spear/operation.hpp"

namespace spear {

namespace detail {

/// What a Future<T> can do because of its T; object.hpp gives futures of objects calls and properties.
template <typename T>
struct FutureMixin {};

/// Reads a result as a T. Raises WrongType, OutOfRange or MalformedMessage, naming the operation.
template <typename T>
T decode_result(const RawResult& result, const std::shared_ptr<Session>& session);

} // namespace detail

/// Copyable; copies share the result, which is kept in the server for later arguments until the last copy goes. T may
/// be void.
template <typename T>
class Future : public detail::FutureMixin<T> {
public:
    using value_type = T;

    Future() = default;
    explicit Future(OperationHandle operation) : operation_(std::move(operation)) {}

    /// Whether it belongs to an operation; a default-constructed one does not, and raises ArgumentError wherever it is
    /// used.
    bool valid() const noexcept { return operation_.valid(); }
    /// Whether get() would return (or raise) at once.
    bool is_ready() const noexcept { return operation_.is_ready(); }
    /// Waits for the operation and gives its result, or raises its error. See OperationHandle::get for threads, blocks
    /// and deadline.
    T get(std::optional<Milliseconds> deadline = {}) const {
        const RawResult result = operation_.get(deadline);
        if constexpr (!std::is_void_v<T>) {
            return detail::decode_result<T>(result, operation_.session());
        }
    }
    /// Waits without raising the operation's error; false if the timeout has passed.
    bool wait(Milliseconds timeout) const { return operation_.wait(timeout); }
    const OperationHandle& operation() const noexcept { return operation_; }

private:
    OperationHandle operation_;
};

namespace detail {
template <typename T>
inline constexpr bool is_future = false;
template <typename T>
inline constexpr bool is_future<Future<T>> = true;
} // namespace detail

/// How an operation is performed: see OperationBuilder.
enum class CallMode { sync, async, send };

namespace detail {
template <CallMode mode, typename R>
struct CallResultOf {
    using type = R;
};
template <typename R>
struct CallResultOf<CallMode::async, R> {
    using type = Future<R>;
};
template <typename R>
struct CallResultOf<CallMode::send, R> {
    using type = void;
};
} // namespace detail

/// R, Future<R> or void.
template <CallMode mode, typename R>
using CallResult = typename detail::CallResultOf<mode, R>::type;

namespace detail {
/// Performs a finished builder's operation.
template <CallMode mode, typename R>
CallResult<mode, R> perform(OperationBuilder& operation, const std::shared_ptr<Session>& session) {
    if constexpr (mode == CallMode::send) {
        operation.send();
    } else if constexpr (mode == CallMode::async) {
        return Future<R>(operation.async());
    } else if constexpr (std::is_void_v<R>) {
        operation.call_here();
    } else {
        return decode_result<R>(operation.call_here(), session);
    }
}
} // namespace detail

} // namespace spear
