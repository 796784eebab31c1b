// SPDX-License-Identifier: MIT
#pragma once

// The kinds of error, shared by client and server. The client has one exception class per row (error.hpp, and the same names in
// Python); inside the engine an error is a plain value (ErrorInfo), because Unreal code has no exceptions.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace spear {

/// X(name, parent, meaning). A parent stands before its children. The wire carries the row's number: append, never reorder.
#define SPEAR_ERRORS(X)                                                                                                          \
    X(Error, Error, "base of all errors of this library")                                                                       \
    X(ConnectionError, Error, "the engine cannot be reached, or no longer")                                                     \
    X(EngineNotRunning, ConnectionError, "nothing listens at the address")                                                      \
    X(EngineExited, ConnectionError, "the engine process has ended")                                                            \
    X(Disconnected, ConnectionError, "the session is closed")                                                                   \
    X(VersionMismatch, ConnectionError, "client and server speak different versions")                                           \
    X(Unauthorized, ConnectionError, "the server refused the token")                                                            \
    X(LaunchFailed, ConnectionError, "the engine executable could not be started")                                              \
    X(FrameError, Error, "wrong use of begin_frame and end_frame")                                                              \
    X(NotInFrame, FrameError, "the operation needs an open begin_frame or end_frame block")                                     \
    X(WrongThread, FrameError, "the open block belongs to another thread")                                                      \
    X(FrameMisuse, FrameError, "blocks nested or out of order")                                                                 \
    X(NeedsFrames, FrameError, "the result needs frames, but the engine is held")                                               \
    X(TransactionAborted, FrameError, "the transaction was aborted")                                                            \
    X(WaitError, Error, "a wait reached its deadline")                                                                          \
    X(DeadlineExceeded, WaitError, "no answer within the deadline")                                                             \
    X(HeldByClient, WaitError, "another client holds the engine")                                                               \
    X(EngineBusy, WaitError, "the engine runs no frames (loading, modal dialog)")                                               \
    X(LookupFailed, Error, "something named does not exist")                                                                    \
    X(UnknownClass, LookupFailed, "no such class or struct")                                                                    \
    X(UnknownFunction, LookupFailed, "no such function")                                                                        \
    X(UnknownProperty, LookupFailed, "no such property")                                                                        \
    X(UnknownObject, LookupFailed, "no such actor, component, object or asset")                                                 \
    X(UnknownEntryPoint, LookupFailed, "no such entry point")                                                                   \
    X(AmbiguousName, LookupFailed, "the name fits more than one thing")                                                         \
    X(ArgumentError, Error, "an argument does not fit")                                                                         \
    X(UnknownArgument, ArgumentError, "the function has no parameter of that name")                                             \
    X(MissingArgument, ArgumentError, "an argument without default was not given")                                              \
    X(WrongType, ArgumentError, "a value of the wrong type")                                                                    \
    X(OutOfRange, ArgumentError, "a number or index outside its range")                                                         \
    X(ObjectError, Error, "an object cannot be used so")                                                                        \
    X(StaleObject, ObjectError, "the object has been destroyed")                                                                \
    X(NullObject, ObjectError, "an object was needed, null was found")                                                          \
    X(NotCallable, ObjectError, "the function cannot be called from outside")                                                   \
    X(ReadOnly, ObjectError, "the property cannot be written")                                                                  \
    X(SpawnFailed, ObjectError, "the engine did not create the object")                                                         \
    X(DependencyFailed, Error, "an argument was a future whose operation failed")                                               \
    X(LimitExceeded, Error, "a limit of limits.hpp was exceeded")                                                               \
    X(MalformedMessage, Error, "bytes that are not of this protocol")                                                           \
    X(InternalError, Error, "a defect of this library")

enum class ErrorCode : std::uint16_t {
#define SPEAR_ERROR_ENUMERATOR(name, parent, meaning) name,
    SPEAR_ERRORS(SPEAR_ERROR_ENUMERATOR)
#undef SPEAR_ERROR_ENUMERATOR
};

struct ErrorRow {
    std::string_view name;
    ErrorCode parent;
    std::string_view meaning;
};

inline constexpr ErrorRow error_rows[] = {
#define SPEAR_ERROR_ROW(name, parent, meaning) {#name, ErrorCode::parent, meaning},
    SPEAR_ERRORS(SPEAR_ERROR_ROW)
#undef SPEAR_ERROR_ROW
};

inline constexpr std::size_t error_count = sizeof(error_rows) / sizeof(error_rows[0]);

/// The name of the error's class, e.g. "StaleObject"; "Error" for a number that this version does not know.
constexpr std::string_view error_name(ErrorCode code) {
    const auto index = static_cast<std::size_t>(code);
    return index < error_count ? error_rows[index].name : error_rows[0].name;
}

/// An error as a value: what the wire carries and what code inside the engine returns.
struct ErrorInfo {
    ErrorCode code = ErrorCode::Error;
    std::string message{};   ///< complete sentence for people: what was asked, what was found, what to do
    std::string operation{}; ///< e.g. "AActor::SetActorScale3D", "unreal_service.find_class", "RootComponent.RelativeLocation"
    std::string argument{};  ///< the argument's name, empty if none is to blame
    std::string expected{};  ///< the expected type, e.g. "FVector", empty if types are not the matter
};

} // namespace spear
