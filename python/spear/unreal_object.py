# SPDX-License-Identifier: MIT
"""Objects of the engine, and paths to their variables.

``object.Name`` is a :class:`Member`: called, it is a function of Unreal (``actor.SetActorScale3D(NewScale3D=FVector(4, 4, 4))``); with
``get()`` and ``set()`` it is a variable, at any depth (``actor.RootComponent.RelativeLocation.X.get()``). Plain assignment writes
(``actor.bHidden = True``). ``object.async_`` does the same without waiting and gives futures; ``object.send_`` does not even answer.
(Paper, section 3, "Calling Functions and Accessing Variables".)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NoReturn

from spear import _native
from spear._native import ASYNC, SEND, SYNC

if TYPE_CHECKING:
    from spear._native import Future

_set = object.__setattr__


class UnrealObject(_native.Object):
    """An object of the engine. Copies share it; it does not keep it alive: using one that was destroyed raises StaleObject.

    Two are equal if they are the same object of the same session. Attributes that do not start with ``_`` and are not methods below
    are Unreal's functions and variables.
    """

    __slots__ = ()

    @property
    def async_(self) -> AsyncNamespace:
        """The same functions and variables, asynchronously: each gives a Future at once, and runs in the same order."""
        return AsyncNamespace(self, ASYNC)

    @property
    def send_(self) -> AsyncNamespace:
        """Fire-and-forget: nothing is returned; failures are reported when a block ends."""
        return AsyncNamespace(self, SEND)

    def call(self, function: str, /, *args: Any, **kwargs: Any) -> Any:
        """Calls a function by name, for names that are no Python identifiers or clash with the methods here."""
        return self._session.call_function(self, function, args, kwargs, SYNC)

    def get(self, path: str, /) -> Any:
        """Reads the variable at a path, "RootComponent.RelativeLocation.X", "Tags[0]"."""
        return self._session.get_property(self, path, SYNC)

    def set(self, path: str, value: Any, /) -> None:
        """Writes the variable at a path."""
        self._session.set_property(self, path, value, SYNC)

    def is_valid(self) -> bool:
        """Whether the object still lives. Works inside and outside of blocks."""
        return bool(self._session.call("unreal_service.is_valid", (self,), {}, SYNC))

    def get_class(self) -> UnrealObject:
        """The class of the object, an object too."""
        result: UnrealObject = self._session.call("unreal_service.get_class", (self,), {}, SYNC)
        return result

    def get_path_name(self) -> str:
        """The object's path, its identity in the engine."""
        return str(self._session.call("unreal_service.get_path_name", (self,), {}, SYNC))

    def __getattr__(self, name: str) -> Member:
        if name.startswith("__"):
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
        return Member(self, name, SYNC)

    def __setattr__(self, name: str, value: Any) -> None:
        if name in _OBJECT_METHODS:
            raise AttributeError(f"{name!r} is a method of spear.UnrealObject; for a variable of that name use object.set({name!r}, value)")
        self._session.set_property(self, name, value, SYNC)

    def __dir__(self) -> list[str]:
        """Methods here, then the class's functions and variables with those it inherits: what completion in a shell shows."""
        from spear.describe import member_names

        return sorted({*object.__dir__(self), *member_names(self)})

    def __repr__(self) -> str:
        return f"<{self._class_name} handle={self._handle:#x}>"


_OBJECT_METHODS = frozenset(name for name in vars(UnrealObject) if not name.startswith("__"))


class AsyncNamespace:
    """``object.async_`` and ``object.send_``: functions and variables of an object (or of a future one), not waited for."""

    __slots__ = ("_target", "_mode")
    _target: Any
    _mode: int

    def __init__(self, target: Any, mode: int) -> None:
        _set(self, "_target", target)
        _set(self, "_mode", mode)

    def __getattr__(self, name: str) -> Member:
        if name.startswith("__"):
            raise AttributeError(name)
        return Member(self._target, name, self._mode)

    def __setattr__(self, name: str, value: Any) -> None:
        self._target._session.set_property(self._target, name, value, self._mode)

    def call(self, function: str, /, *args: Any, **kwargs: Any) -> Any:
        """Calls a function by name."""
        return self._target._session.call_function(self._target, function, args, kwargs, self._mode)

    def get(self, path: str, /) -> Any:
        """Reads the variable at a path: a Future."""
        return self._target._session.get_property(self._target, path, self._mode)

    def set(self, path: str, value: Any, /) -> Any:
        """Writes the variable at a path."""
        return self._target._session.set_property(self._target, path, value, self._mode)

    def __dir__(self) -> list[str]:
        return dir(self._target)


class Member:
    """A function or variable of an object, by name; nothing is sent before it is called, got or set."""

    __slots__ = ("_target", "_path", "_mode")
    _target: Any
    _path: str
    _mode: int

    def __init__(self, target: Any, path: str, mode: int) -> None:
        _set(self, "_target", target)
        _set(self, "_path", path)
        _set(self, "_mode", mode)

    # As a function ---------------------------------------------------------------------------------------------------

    def __call__(self, *args: Any, **kwargs: Any) -> Any:
        """Calls the function, with positional or keyword arguments. Omitted ones take Unreal's defaults."""
        target, path = self._target, self._path
        session = target._session
        if "." in path or "[" in path:
            # A function of the object that the path leads to: the server passes it on, so this is still one round trip.
            owner, _, path = path.rpartition(".")
            if not owner:
                raise TypeError(f"{self._path!r} is an element of a variable, not a function")
            target = session.get_property(target, owner, ASYNC)
        return session.call_function(target, path, args, kwargs, self._mode)

    # As a variable ---------------------------------------------------------------------------------------------------

    def get(self) -> Any:
        """The variable's value; a Future under ``async_``."""
        return self._target._session.get_property(self._target, self._path, self._mode)

    def set(self, value: Any, /) -> Any:
        """Writes the variable, through Unreal's own setter where it has one."""
        return self._target._session.set_property(self._target, self._path, value, self._mode)

    @property
    def async_(self) -> Member:
        """The same place, asynchronously: ``actor.RootComponent.async_.K2_GetComponentLocation()``."""
        return Member(self._target, self._path, ASYNC)

    @property
    def send_(self) -> Member:
        """The same place, fire-and-forget."""
        return Member(self._target, self._path, SEND)

    def __getattr__(self, name: str) -> Member:
        if name.startswith("__"):
            raise AttributeError(name)
        return Member(self._target, f"{self._path}.{name}", self._mode)

    def __setattr__(self, name: str, value: Any) -> None:
        self._target._session.set_property(self._target, f"{self._path}.{name}", value, self._mode)

    def __getitem__(self, key: int | str) -> Member:
        return Member(self._target, f"{self._path}[{_key_text(key)}]", self._mode)

    def __setitem__(self, key: int | str, value: Any) -> None:
        self._target._session.set_property(self._target, f"{self._path}[{_key_text(key)}]", value, self._mode)

    def __repr__(self) -> str:
        return f"<member {self._path} of {self._target!r}: call it, or use get() and set()>"

    def _refuse(self, *_: Any) -> NoReturn:
        raise TypeError(f"'{self._path}' is a path to a variable (or a function), not its value: use .get() to read it, or () to call it")

    def __bool__(self) -> bool:
        self._refuse()

    __eq__ = __ne__ = __lt__ = __le__ = __gt__ = __ge__ = _refuse
    __add__ = __radd__ = __sub__ = __rsub__ = __mul__ = __rmul__ = __truediv__ = __rtruediv__ = _refuse
    __neg__ = __float__ = __int__ = __index__ = __len__ = __iter__ = __contains__ = _refuse
    __hash__ = None  # type: ignore[assignment]


def _key_text(key: int | str) -> str:
    if isinstance(key, str):
        escaped = key.replace("\\", "\\\\").replace('"', '\\"')
        return f'"{escaped}"'
    if isinstance(key, int) and not isinstance(key, bool):
        return str(key)
    raise TypeError(f"an index is an int or a str, not {type(key).__name__}")


def future_object(future: Future[Any]) -> FutureObject:
    """The object that a future will be, as a target of further calls without waiting."""
    return FutureObject(future)


class FutureObject:
    """What ``future.object`` gives: functions and variables of an object that is not known yet. The server passes it on (guarantee G8).

    Calls are synchronous, as on an object; ``.async_`` and ``.send_`` as there.
    """

    __slots__ = ("_future", "_session")
    _future: Future[Any]
    _session: _Redirect

    def __init__(self, future: Future[Any]) -> None:
        _set(self, "_future", future)
        _set(self, "_session", _Redirect(future))

    @property
    def async_(self) -> AsyncNamespace:
        """Asynchronous calls on the object to come."""
        return AsyncNamespace(self, ASYNC)

    @property
    def send_(self) -> AsyncNamespace:
        """Fire-and-forget calls on the object to come."""
        return AsyncNamespace(self, SEND)

    def __getattr__(self, name: str) -> Member:
        if name.startswith("__"):
            raise AttributeError(name)
        return Member(self, name, SYNC)

    def __setattr__(self, name: str, value: Any) -> None:
        self._session.set_property(self, name, value, SYNC)

    def __repr__(self) -> str:
        return f"<object of {self._future!r}>"


class _Redirect:
    """Passes a FutureObject's operations on to the session with the future itself as the target."""

    __slots__ = ("_future",)

    def __init__(self, future: Future[Any]) -> None:
        self._future = future

    def _target(self, target: Any) -> Any:
        return self._future if isinstance(target, FutureObject) else target

    def call_function(self, target: Any, name: str, args: tuple[Any, ...], kwargs: dict[str, Any], mode: int) -> Any:
        return self._future._session.call_function(self._target(target), name, args, kwargs, mode)

    def get_property(self, target: Any, path: str, mode: int) -> Any:
        return self._future._session.get_property(self._target(target), path, mode)

    def set_property(self, target: Any, path: str, value: Any, mode: int) -> Any:
        return self._future._session.set_property(self._target(target), path, value, mode)
