# SPDX-License-Identifier: MIT
"""Objects of the engine, and paths to their variables.

``object.Name`` is a :class:`Member`: called, it is a function of Unreal (``actor.SetActorScale3D(NewScale3D=FVector(4, 4, 4))``); with
``get()`` and ``set()`` it is a variable, at any depth (``actor.RootComponent.RelativeLocation.X.get()``). Plain assignment writes
(``actor.bHidden = True``). ``object.async_`` does the same without waiting and gives futures; ``object.send_`` does not even answer.
(Paper, section 3, "Calling Functions and Accessing Variables".)
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, NoReturn, TypeVar, overload

from spear import _native
from spear._native import ASYNC, RAW, SYNC, Future
from spear.enums import UnrealEnum

_T = TypeVar("_T", bound="ObjectBase")


def class_argument(value: Any) -> Any:
    """What the wire takes for a class: an object, a name, or the Unreal name of a class of spear.unreal."""
    if isinstance(value, type):
        name = getattr(value, "unreal_name", None)
        if not isinstance(name, str):
            raise TypeError(f"{value.__name__} is no class of Unreal: give a name (\"AActor\"), a class object, or a class of spear.unreal")
        return name
    return value


class ObjectBase(_native.Object):
    """What every object of the engine has of its own: a short closed list. Everything else is Unreal's (:class:`UnrealObject`).

    A function or variable of Unreal that has one of these names is reached with a trailing underscore, ``object.get_``.
    """

    __slots__ = ()

    if TYPE_CHECKING:
        #: Unreal's name of the class, ``"AActor"``.
        unreal_name: ClassVar[str]
    else:

        @property
        def unreal_name(self) -> str:
            """Unreal's name of the object's class, ``"AActor"``."""
            return self._class_name

    if TYPE_CHECKING:

        @property
        def async_(self) -> AsyncBase:
            """The same functions and variables, asynchronously: each gives a Future at once, and runs in the same order."""

        @property
        def send_(self) -> SendBase:
            """Fire-and-forget: nothing is returned; failures are reported when a block ends."""

    else:
        async_, send_ = _native.Object.async_, _native.Object.send_

    def call(self, function: str, /, *args: Any, **kwargs: Any) -> Any:
        """Calls a function by Unreal's name. What it returns comes as it is: an object that is null is None."""
        return self._session.call_function(self, function, args, kwargs, SYNC | RAW)

    def get(self, path: str, /) -> Any:
        """Reads the variable at a path, "RootComponent.RelativeLocation.X", "Tags[0]", as it is: an object that is null is None."""
        return self._session.get_property(self, path, SYNC | RAW)

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

    @overload
    def get_component(self, uclass: type[_T], name: str = "") -> _T: ...
    @overload
    def get_component(self, uclass: str | ObjectBase, name: str = "") -> UnrealObject: ...
    def get_component(self, uclass: Any, name: str = "") -> Any:
        """The actor's only component of a class, or the one of that class and name. Raises UnknownObject, AmbiguousName."""
        return self._session.call(_COMPONENT_BY_NAME if name else _COMPONENT_BY_CLASS, (self, class_argument(uclass), name), {}, SYNC)

    @overload
    def get_components(self, uclass: type[_T]) -> list[_T]: ...
    @overload
    def get_components(self, uclass: str | ObjectBase) -> list[UnrealObject]: ...
    def get_components(self, uclass: Any) -> list[Any]:
        """The actor's components of a class."""
        return list(self._session.call(_COMPONENTS_BY_CLASS, (self, class_argument(uclass), ""), {}, SYNC))

    def __repr__(self) -> str:
        return f"<{self._class_name} handle={self._handle:#x}>"


_COMPONENT_BY_CLASS = "unreal_service.find_component_by_class"
_COMPONENT_BY_NAME = "unreal_service.find_component_by_name"
_COMPONENTS_BY_CLASS = "unreal_service.find_components_by_class"


class UnrealObject(ObjectBase):
    """An object of the engine. Copies share it; it does not keep it alive: using one that was destroyed raises StaleObject.

    Two are equal if they are the same object of the same session. Attributes that do not start with ``__`` and are not methods of
    ObjectBase are Unreal's functions and variables.
    """

    __slots__ = ()

    if TYPE_CHECKING:

        @property
        def async_(self) -> AsyncNamespace: ...
        @property
        def send_(self) -> SendNamespace: ...

        # These are the native half's.
        def __getattr__(self, name: str) -> Member: ...
        def __setattr__(self, name: str, value: Any) -> None: ...

    def __dir__(self) -> list[str]:
        """Methods here, then the class's functions and variables with those it inherits: what completion in a shell shows."""
        from spear.describe import member_names

        return sorted({*object.__dir__(self), *member_names(self)})


#: What objects have of their own; a test compares it with the list that stubs are made with.
OBJECT_METHODS = frozenset(name for name in vars(ObjectBase) if not name.startswith("_"))


def check_assignment(name: str) -> None:
    """Raises AttributeError for assignments to what objects have of their own; the native half asks before it writes a variable."""
    if name in OBJECT_METHODS:
        from spear.codegen.names import python_name

        spelled = python_name(name.rstrip("_"))
        raise AttributeError(f"{name!r} is a member of spear.ObjectBase; a variable of Unreal of that name is object.{spelled} here")


class AsyncBase(_native.Namespace):
    """What ``object.async_`` has of its own: the methods of ObjectBase, each giving a Future."""

    __slots__ = ()

    def call(self, function: str, /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Calls a function by Unreal's name."""
        return self._target._session.call_function(self._target, function, args, kwargs, self._mode | RAW)  # type: ignore[no-any-return]

    def get(self, path: str, /) -> Future[Any]:
        """Reads the variable at a path."""
        return self._target._session.get_property(self._target, path, self._mode | RAW)  # type: ignore[no-any-return]

    def set(self, path: str, value: Any, /) -> Future[None]:
        """Writes the variable at a path."""
        return self._target._session.set_property(self._target, path, value, self._mode)  # type: ignore[no-any-return]

    def is_valid(self) -> Future[bool]:
        """Whether the object lives when this runs."""
        return self._service("unreal_service.is_valid")  # type: ignore[no-any-return]

    def get_class(self) -> Future[UnrealObject]:
        """The class of the object."""
        return self._service("unreal_service.get_class")  # type: ignore[no-any-return]

    def get_path_name(self) -> Future[str]:
        """The object's path."""
        return self._service("unreal_service.get_path_name")  # type: ignore[no-any-return]

    @overload
    def get_component(self, uclass: type[_T], name: str = "") -> Future[_T]: ...
    @overload
    def get_component(self, uclass: str | ObjectBase, name: str = "") -> Future[UnrealObject]: ...
    def get_component(self, uclass: Any, name: str = "") -> Any:
        """The actor's only component of a class, or the one of that class and name."""
        return self._service(_COMPONENT_BY_NAME if name else _COMPONENT_BY_CLASS, class_argument(uclass), name)

    @overload
    def get_components(self, uclass: type[_T]) -> Future[list[_T]]: ...
    @overload
    def get_components(self, uclass: str | ObjectBase) -> Future[list[UnrealObject]]: ...
    def get_components(self, uclass: Any) -> Any:
        """The actor's components of a class."""
        return self._service(_COMPONENTS_BY_CLASS, class_argument(uclass), "")

    def _service(self, name: str, *args: Any) -> Any:
        return self._target._session.call(name, (self._target, *args), {}, self._mode)

    def __dir__(self) -> list[str]:
        return dir(self._target)


class AsyncNamespace(AsyncBase):
    """``object.async_``: functions and variables of an object (or of a future one), not waited for."""

    __slots__ = ()

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Member: ...
        def __setattr__(self, name: str, value: Any) -> None: ...


class SendBase(_native.Namespace):
    """What ``object.send_`` has of its own."""

    __slots__ = ()

    def call(self, function: str, /, *args: Any, **kwargs: Any) -> None:
        """Calls a function by Unreal's name."""
        self._target._session.call_function(self._target, function, args, kwargs, self._mode)

    def set(self, path: str, value: Any, /) -> None:
        """Writes the variable at a path."""
        self._target._session.set_property(self._target, path, value, self._mode)

    def __dir__(self) -> list[str]:
        return dir(self._target)


class SendNamespace(SendBase):
    """``object.send_``: functions and variables of an object (or of a future one), fire-and-forget."""

    __slots__ = ()

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Member: ...
        def __setattr__(self, name: str, value: Any) -> None: ...


class Member(_native.MemberBase):
    """A function or variable of an object, by name; nothing is sent before it is called, got or set.

    Called, it is a function, with positional or keyword arguments; omitted ones take Unreal's defaults.
    """

    __slots__ = ()

    # As the object that the variable holds: one round trip, as the server passes it on -----------------------------------------------------

    def call(self, function: str, /, *args: Any, **kwargs: Any) -> Any:
        """Calls a function of the object by Unreal's name."""
        return self._target._session.call_function(self._held(), function, args, kwargs, self._mode | RAW)

    def is_valid(self) -> Any:
        """Whether the object lives; False for null."""
        return self._service("unreal_service.is_valid")

    def get_class(self) -> Any:
        """The class of the object."""
        return self._service("unreal_service.get_class")

    def get_path_name(self) -> Any:
        """The object's path."""
        return self._service("unreal_service.get_path_name")

    def get_component(self, uclass: Any, name: str = "") -> Any:
        """The actor's only component of a class, or the one of that class and name."""
        return self._service(_COMPONENT_BY_NAME if name else _COMPONENT_BY_CLASS, class_argument(uclass), name)

    def get_components(self, uclass: Any) -> Any:
        """The actor's components of a class."""
        return self._service(_COMPONENTS_BY_CLASS, class_argument(uclass), "")

    def _held(self) -> Any:
        return self._target._session.get_property(self._target, self._path, ASYNC | RAW)

    def _service(self, name: str, *args: Any) -> Any:
        return self._target._session.call(name, (self._held(), *args), {}, self._mode)

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Member: ...
        def __setattr__(self, name: str, value: Any) -> None: ...

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
    if isinstance(key, UnrealEnum):
        key = key.unreal_entry
    if isinstance(key, str):
        escaped = key.replace("\\", "\\\\").replace('"', '\\"')
        return f'"{escaped}"'
    if isinstance(key, int) and not isinstance(key, bool):
        return str(key)
    raise TypeError(f"an index is an int or a str, not {type(key).__name__}")


def _method(function: Any) -> Any:
    """A method of objects for objects to come: they have a session too, and stand for their future in calls."""
    return function


class FutureObject(_native.FutureObjectBase):
    """What ``future.object`` gives: functions and variables of an object that is not known yet. The server passes it on (guarantee G8).

    It has what an object has. Calls are synchronous, as there; ``.async_`` and ``.send_`` too.
    """

    __slots__ = ()

    if TYPE_CHECKING:

        @property
        def async_(self) -> AsyncNamespace: ...
        @property
        def send_(self) -> SendNamespace: ...
        def __getattr__(self, name: str) -> Member: ...
        def __setattr__(self, name: str, value: Any) -> None: ...

    call, get, set = _method(ObjectBase.call), _method(ObjectBase.get), _method(ObjectBase.set)
    is_valid, get_class, get_path_name = _method(ObjectBase.is_valid), _method(ObjectBase.get_class), _method(ObjectBase.get_path_name)
    get_component, get_components = _method(ObjectBase.get_component), _method(ObjectBase.get_components)

    def __repr__(self) -> str:
        return f"<object of {self._future!r}>"
