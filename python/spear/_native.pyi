# SPDX-License-Identifier: MIT
"""The native half of the package: sessions, operations, values. Everything here is used through the classes of ``spear``."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Generic, TypeVar, overload

if TYPE_CHECKING:
    from spear.unreal_object import Member

_T = TypeVar("_T")

__version__: str
SYNC: int
ASYNC: int
SEND: int
#: Added to a mode: a null object is None, and nobody is asked whether that may be.
RAW: int
LEASE_OFF: int
#: (name, parent, meaning) of every error, from ``spear/error_code.hpp``.
ERROR_ROWS: list[tuple[str, str, str]]
#: (name, parameter names, "game_thread" | "any_frame" | "server_thread", documentation, signature) of every entry point.
ENTRY_POINTS: list[tuple[str, list[str], str, str, str]]

class Object:
    """An object of the engine: the session, a weak handle, the class as it was when the engine sent it."""

    @property
    def _session(self) -> Session: ...
    @property
    def _handle(self) -> int: ...
    @property
    def _class_name(self) -> str: ...
    @property
    def _class_names(self) -> tuple[str, ...]:
        """The class and those it derives from, most derived first."""
    def __eq__(self, other: object) -> bool: ...
    def __hash__(self) -> int: ...

class FutureObjectBase:
    """The object that a future will be."""

    def __init__(self, future: Future[Any], /) -> None: ...
    @property
    def _future(self) -> Future[Any]: ...
    @property
    def _session(self) -> Session: ...

class Namespace:
    """An object's functions and variables in another mode: ``object.async_``."""

    def __init__(self, target: Object | FutureObjectBase, mode: int, /) -> None: ...
    @property
    def _target(self) -> Any: ...
    @property
    def _mode(self) -> int: ...

class MemberBase:
    """A function or variable of an object, by name."""

    def __init__(self, target: Object | FutureObjectBase, path: str, mode: int, /) -> None: ...
    @property
    def _target(self) -> Any: ...
    @property
    def _path(self) -> str: ...
    @property
    def _mode(self) -> int: ...
    @property
    def async_(self) -> Member:
        """The same place, asynchronously: ``actor.RootComponent.async_.K2_GetComponentLocation()``."""
    @property
    def send_(self) -> Member:
        """The same place, fire-and-forget."""
    def __call__(self, *args: Any, **kwargs: Any) -> Any:
        """Calls the function, with positional or keyword arguments. Omitted ones take Unreal's defaults."""
    def get(self, path: str = "", /) -> Any:
        """The variable's value; a Future under ``async_``. NullObject if it is an object, and null.

        With a path: what is there, seen from the object that the variable holds (as ``object.get(path)``).
        """
    def get_or_none(self) -> Any:
        """The variable's value, None for an object that is null; a Future under ``async_``."""
    @overload
    def set(self, value: Any, /) -> Any:
        """Writes the variable, through Unreal's own setter where it has one."""
    @overload
    def set(self, path: str, value: Any, /) -> Any:
        """Writes what is at a path that begins at the object that the variable holds."""

class Future(Generic[_T]):
    """The result of an asynchronous operation. May be an argument of later operations, in any position."""

    def get(self, timeout: float | None = None) -> _T:
        """Waits while the operation is pending (at most ``timeout`` seconds), then returns its result or raises its error. Any thread."""
    def is_ready(self) -> bool:
        """Whether get() would return (or raise) at once."""
    @property
    def object(self) -> _T:
        """The object that the future will be, as the target of further calls without waiting (a FutureObject; to type checkers the object)."""
    @property
    def _session(self) -> Session: ...

class Session:
    """A session with an engine."""

    @property
    def address(self) -> str: ...
    @property
    def session_id(self) -> int: ...
    @property
    def serial(self) -> int:
        """A number that no other session of this process has; session_id is the server's."""
    @property
    def process_id(self) -> int | None: ...
    @property
    def is_open(self) -> bool: ...
    @property
    def uses_channel(self) -> bool: ...
    def statistics(self) -> tuple[tuple[int, int], tuple[int, int], tuple[int, int], tuple[int, int], int]: ...
    def begin_block(self) -> None: ...
    def end_block(self) -> None: ...
    def close_block(self, single_step: bool) -> None: ...
    def abort_block(self) -> None: ...
    def flush(self) -> None: ...
    def close(self) -> None: ...
    def call(self, entry_point: str, args: tuple[Any, ...], kwargs: Mapping[str, Any], mode: int) -> Any: ...
    def call_function(self, target: Any, function: str, args: tuple[Any, ...], kwargs: Mapping[str, Any], mode: int) -> Any: ...
    def call_many(self, objects: Any, function: str, args: tuple[Any, ...], kwargs: Mapping[str, Any], mode: int) -> Any: ...
    def get_property(self, target: Any, path: str, mode: int) -> Any: ...
    def set_property(self, target: Any, path: str, value: Any, mode: int) -> Any: ...

def connect(*, address: str, token: bytes, lease_ms: int, deadline_ms: int, timeout_ms: int, channel: bool, spin: bool) -> Session: ...
def launch(
    *, scene: str, executable: str, arguments: Sequence[str], fps: float, fixed_dt: float, address: str, paused: bool, log_file: str,
    token: bytes, lease_ms: int, deadline_ms: int, timeout_ms: int, channel: bool, spin: bool,
) -> Session: ...

class Trace:
    def __init__(self, session: Session, file: str, operations: bool, events_per_thread: int) -> None: ...
    def stop(self) -> None: ...

def list_engines() -> list[tuple[str, int]]:
    """(address, process id) of every engine of this user that runs."""
def remove_leftovers(logs_too: bool) -> list[str]:
    """Removes what killed engines of this user left behind: sockets, registry entries, shared memory, and their logs (otherwise after a day). Returns the paths."""
def describe_engine(address: str, timeout_ms: int) -> dict[str, Any]:
    """spear_version, engine, project, scene, process_id, frame, uptime, sessions of the engine at an address, without a session."""
def setup(
    *, object_class: type, struct_base: type, struct_class: Callable[[str, str, Sequence[str]], tuple[type, tuple[str, ...]]],
    enum_class: Callable[[str, str, bool, Sequence[tuple[str, int]]], tuple[type, dict[int, Any], Callable[[int], Any] | None]],
    enum_entries: Callable[[type], tuple[str, bool, list[tuple[str, int]]] | None], result_class: Callable[[str, Sequence[str]], type],
    null_result: Callable[[Any, Any, str, bool, Any], None], parameter_name: Callable[[str], str], errors: Mapping[str, type], future_object: type,
    member_class: type, async_namespace: type, send_namespace: type, renamed: Mapping[str, Any], unreal_name_of: Callable[[Any, str], str],
    check_assignment: Callable[[str], None],
) -> None: ...
def forget_names() -> None:
    """To be called whenever ``renamed`` has changed."""
