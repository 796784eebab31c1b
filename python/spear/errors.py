# SPDX-License-Identifier: MIT
"""The errors of SPEAR: the same names and hierarchy as in C++ (``spear/error_code.hpp``; a test compares them).

Each carries ``message`` (what was asked, what was found, what to do), ``operation``, ``argument`` and ``expected``; the last three are
empty where they do not apply.
"""

from __future__ import annotations


class Error(Exception):
    """Base of all errors of this library."""

    message: str
    operation: str
    argument: str
    expected: str

    def __init__(self, message: str = "", operation: str = "", argument: str = "", expected: str = "") -> None:
        super().__init__(message)
        self.message = message
        self.operation = operation
        self.argument = argument
        self.expected = expected


class ConnectionError(Error):  # noqa: A001 - the name in every language; it is also the built-in's meaning
    """The engine cannot be reached, or no longer."""


class EngineNotRunning(ConnectionError):
    """Nothing listens at the address."""


class EngineExited(ConnectionError):
    """The engine process has ended."""


class Disconnected(ConnectionError):
    """The session is closed."""


class VersionMismatch(ConnectionError):
    """Client and server speak different versions."""


class Unauthorized(ConnectionError):
    """The server refused the token."""


class LaunchFailed(ConnectionError):
    """The engine executable could not be started."""


class FrameError(Error):
    """Wrong use of begin_frame and end_frame."""


class NotInFrame(FrameError):
    """The operation needs an open begin_frame or end_frame block."""


class WrongThread(FrameError):
    """The open block belongs to another thread."""


class FrameMisuse(FrameError):
    """Blocks nested or out of order."""


class NeedsFrames(FrameError):
    """The result needs frames, but the engine is held."""


class TransactionAborted(FrameError):
    """The transaction was aborted."""


class WaitError(Error):
    """A wait reached its deadline."""


class DeadlineExceeded(WaitError):
    """No answer within the deadline."""


class HeldByClient(WaitError):
    """Another client holds the engine."""


class EngineBusy(WaitError):
    """The engine runs no frames (loading, modal dialog)."""


class LookupFailed(Error):
    """Something named does not exist."""


class UnknownClass(LookupFailed):
    """No such class or struct."""


class UnknownFunction(LookupFailed):
    """No such function."""


class UnknownProperty(LookupFailed):
    """No such property."""


class UnknownObject(LookupFailed):
    """No such actor, component, object or asset."""


class UnknownEntryPoint(LookupFailed):
    """No such entry point."""


class AmbiguousName(LookupFailed):
    """The name fits more than one thing."""


class ArgumentError(Error):
    """An argument does not fit."""


class UnknownArgument(ArgumentError):
    """The function has no parameter of that name."""


class MissingArgument(ArgumentError):
    """An argument without default was not given."""


class WrongType(ArgumentError):
    """A value of the wrong type."""


class OutOfRange(ArgumentError):
    """A number or index outside its range."""


class ObjectError(Error):
    """An object cannot be used so."""


class StaleObject(ObjectError):
    """The object has been destroyed."""


class NullObject(ObjectError):
    """An object was needed, null was found."""


class NotCallable(ObjectError):
    """The function cannot be called from outside."""


class ReadOnly(ObjectError):
    """The property cannot be written."""


class SpawnFailed(ObjectError):
    """The engine did not create the object."""


class DependencyFailed(Error):
    """An argument was a future whose operation failed."""


class LimitExceeded(Error):
    """A limit of limits.hpp was exceeded."""


class MalformedMessage(Error):
    """Bytes that are not of this protocol."""


class InternalError(Error):
    """A defect of this library."""


#: Every error class by name.
BY_NAME: dict[str, type[Error]] = {
    value.__name__: value for value in list(globals().values()) if isinstance(value, type) and issubclass(value, Error)
}
