# SPDX-License-Identifier: MIT
"""Types for annotations: paths to variables of objects, as typed code meets them.

``actor.bHidden`` is no value but a path to one: ``Path[bool]``. Reading is ``get()``, writing ``set(value)`` or plain assignment. Every path
has ``async_`` (the same place; ``get()`` and ``set()`` give futures) and ``send_`` (``set()`` only, nothing is answered). A path is neither true
nor false, is not compared, added or iterated over: these raise TypeError, and type checkers report them.
"""

from collections.abc import Mapping, Sequence, Set
from typing import Any, Generic, NoReturn, Protocol, TypeAlias, TypeVar, overload

from spear._native import Future as Future
from spear.unreal_object import ObjectBase, UnrealObject

_T = TypeVar("_T")  # what is read
_S = TypeVar("_S")  # what may be written
_K = TypeVar("_K")  # keys of a map, as read
_E = TypeVar("_E")  # path of an element
_A = TypeVar("_A")  # asynchronous twin
_B = TypeVar("_B")  # fire-and-forget twin
_O = TypeVar("_O", bound=ObjectBase)
_C = TypeVar("_C", bound=ObjectBase)
_P_co = TypeVar("_P_co", covariant=True)
_S_contra = TypeVar("_S_contra", contravariant=True)

MYPY: bool

class Buffer(Protocol):
    """NumPy arrays, ``array.array``, ``memoryview``: numbers in memory."""

    def __buffer__(self, flags: int, /) -> memoryview: ...

#: What stands for a struct of numbers: all its fields in order, or an array of them.
Numbers: TypeAlias = Sequence[float] | Buffer

class _NoValue:
    # Whatever holds for values, but not for paths to them. (mypy tells by the absence of __bool__, with its option truthy-bool.)
    if not MYPY:
        def __bool__(self) -> NoReturn: ...
        __iter__: None
        __contains__: None
    __hash__: None  # type: ignore[assignment]  # pyright: ignore[reportIncompatibleMethodOverride]

# Asynchronous paths ----------------------------------------------------------------------------------------------------------

class AsyncValuePath(_NoValue, Generic[_T, _S]):
    """A path under ``async_``: reads ``T``, takes ``S``."""

    def get(self) -> Future[_T]:
        """Reads the variable: a future, at once."""
    def set(self, value: _S, /) -> Future[None]:
        """Writes the variable; the future's ``get()`` raises if that fails."""

class AsyncPath(AsyncValuePath[_T, _T | Future[_T]], Generic[_T]):
    """A path under ``async_`` to a plain value: ``AsyncPath[bool]``."""

class AsyncObjectPath(AsyncValuePath[_O, _O | Future[_O] | None], Generic[_O]):
    """A path under ``async_`` to a reference to an object."""

    # The object's own get(path) and set(path, value) hold on its path too.
    @overload
    def get(self) -> Future[_O]:
        """Reads the reference; the future's ``get()`` raises NullObject for null."""
    @overload
    def get(self, path: str, /) -> Future[Any]:
        """Reads the variable at a path that begins at the object."""
    @overload
    def set(self, value: _O | Future[_O] | None, /) -> Future[None]:
        """Writes the reference."""
    @overload
    def set(self, path: str, value: Any, /) -> Future[None]:
        """Writes the variable at a path that begins at the object."""
    def get_or_none(self) -> Future[_O | None]:
        """Reads the reference; None for null."""

class AsyncClassPath(AsyncValuePath[_O, _S], Generic[_O, _S]):
    """A path under ``async_`` to a reference to a class."""

    def get_or_none(self) -> Future[_O | None]:
        """Reads the reference; None for null."""

class AsyncArrayPath(AsyncValuePath[list[_T], Sequence[_S] | Future[list[_T]]], Generic[_T, _S, _E]):
    """A path under ``async_`` to an array; an index leads to an element."""

    def __getitem__(self, index: int, /) -> _E: ...
    def __setitem__(self, index: int, value: _S, /) -> None: ...

class AsyncMapPath(AsyncValuePath[dict[_K, _T], Mapping[_K, _S] | Mapping[str, _S] | Future[dict[_K, _T]]], Generic[_K, _T, _S, _E]):
    """A path under ``async_`` to a map; a key leads to its value."""

    def __getitem__(self, key: int | str, /) -> _E: ...
    def __setitem__(self, key: int | str, value: _S, /) -> None: ...

class SendPath(_NoValue, Generic[_S]):
    """A path under ``send_``: written without an answer."""

    def set(self, value: _S, /) -> None:
        """Writes the variable; a failure is reported when the block ends."""

# Paths -----------------------------------------------------------------------------------------------------------------------

class ValuePath(_NoValue, Generic[_T, _S]):
    """A path to a variable: reads ``T``, takes ``S``."""

    def get(self) -> _T:
        """Reads the variable."""
    def set(self, value: _S, /) -> None:
        """Writes the variable, through Unreal's own setter where it has one."""
    @property
    def async_(self) -> AsyncValuePath[_T, _S]:
        """The same place, without waiting: ``get()`` and ``set()`` give futures."""
    @property
    def send_(self) -> SendPath[_S]:
        """The same place, fire-and-forget."""

class Path(ValuePath[_T, _T | Future[_T]], Generic[_T]):
    """A path to a plain value: ``Path[bool]``, ``Path[float]``, ``Path[str]``."""

    @property
    def async_(self) -> AsyncPath[_T]: ...

class StructPath(ValuePath[_T, _S], Generic[_T, _S, _A]):
    """A path to a struct; its fields are paths too: ``actor.RootComponent.RelativeLocation.X``."""

    @property
    def async_(self) -> _A: ...  # type: ignore[override]  # pyright: ignore[reportIncompatibleVariableOverride, reportIncompatibleMethodOverride]

class ObjectPath(_NoValue, Generic[_O, _A, _B]):
    """A path to a reference to an object, with the object's functions and variables. ``get()`` gives the object itself."""

    @overload
    def get(self) -> _O:
        """Reads the reference. Raises NullObject for null; ``get_or_none()`` does not."""
    @overload
    def get(self, path: str, /) -> Any:
        """Reads the variable at a path that begins at the object."""
    @overload
    def set(self, value: _O | Future[_O] | None, /) -> None:
        """Writes the reference."""
    @overload
    def set(self, path: str, value: Any, /) -> None:
        """Writes the variable at a path that begins at the object."""
    def get_or_none(self) -> _O | None:
        """Reads the reference; None for null."""
    def call(self, function: str, /, *args: Any, **kwargs: Any) -> Any:
        """Calls a function of the object by Unreal's name."""
    def is_valid(self) -> bool:
        """Whether the object lives; False for null."""
    def get_class(self) -> UnrealObject:
        """The class of the object, an object too."""
    def get_path_name(self) -> str:
        """The object's path, its identity in the engine."""
    @overload
    def get_component(self, uclass: type[_C], name: str = "") -> _C:
        """The actor's only component of a class, or the one of that class and name."""
    @overload
    def get_component(self, uclass: str | ObjectBase, name: str = "") -> UnrealObject: ...
    @overload
    def get_components(self, uclass: type[_C]) -> list[_C]:
        """The actor's components of a class."""
    @overload
    def get_components(self, uclass: str | ObjectBase) -> list[UnrealObject]: ...
    @property
    def async_(self) -> _A:
        """The object's functions and variables, without waiting: futures."""
    @property
    def send_(self) -> _B:
        """The object's functions and variables, fire-and-forget."""

class ClassPath(ValuePath[_O, _S], Generic[_O, _S]):
    """A path to a reference to a class."""

    def get_or_none(self) -> _O | None:
        """Reads the reference; None for null. ``get()`` raises NullObject."""
    @property
    def async_(self) -> AsyncClassPath[_O, _S]: ...

class ArrayPath(ValuePath[list[_T], Sequence[_S] | Future[list[_T]]], Generic[_T, _S, _E, _A]):
    """A path to an array: ``T`` is read as an element, ``S`` may be written to one, ``E`` is the path of one, ``A`` that under ``async_``."""

    def __getitem__(self, index: int, /) -> _E:
        """The path of an element."""
    def __setitem__(self, index: int, value: _S, /) -> None:
        """Writes an element."""
    @property
    def async_(self) -> AsyncArrayPath[_T, _S, _A]: ...

class SetPath(ValuePath[set[_T], Sequence[_S] | Set[_S] | Future[set[_T]]], Generic[_T, _S]):
    """A path to a set; an index leads to an element, for reading."""

    def __getitem__(self, index: int, /) -> ValuePath[_T, Any]: ...

class MapPath(ValuePath[dict[_K, _T], Mapping[_K, _S] | Mapping[str, _S] | Future[dict[_K, _T]]], Generic[_K, _T, _S, _E, _A]):
    """A path to a map; a key leads to its value. Keys of enums are their names."""

    def __getitem__(self, key: int | str, /) -> _E:
        """The path of a value."""
    def __setitem__(self, key: int | str, value: _S, /) -> None:
        """Writes a value, adds the key where it is missing."""
    @property
    def async_(self) -> AsyncMapPath[_K, _T, _S, _A]: ...

# Variables -------------------------------------------------------------------------------------------------------------------

class Property(Generic[_P_co, _S_contra]):
    """A variable in a class: read, it is a path ``P``; assigned to, it takes ``S``."""

    @overload
    def __get__(self, instance: None, owner: Any, /) -> Property[_P_co, _S_contra]: ...
    @overload
    def __get__(self, instance: object, owner: Any, /) -> _P_co: ...
    def __set__(self, instance: Any, value: _S_contra, /) -> None: ...

class SendProperty(Generic[_S]):
    """A variable under ``send_``."""

    @overload
    def __get__(self, instance: None, owner: Any, /) -> SendProperty[_S]: ...
    @overload
    def __get__(self, instance: object, owner: Any, /) -> SendPath[_S]: ...
    def __set__(self, instance: Any, value: _S, /) -> None: ...

# Variables of plain types, by name: stubs have tens of thousands of them, which type checkers then hold once.
BoolProperty: TypeAlias = Property[Path[bool], bool | Future[bool]]
IntProperty: TypeAlias = Property[Path[int], int | Future[int]]
FloatProperty: TypeAlias = Property[Path[float], float | Future[float]]
StrProperty: TypeAlias = Property[Path[str], str | Future[str]]
AsyncBoolProperty: TypeAlias = Property[AsyncPath[bool], bool | Future[bool]]
AsyncIntProperty: TypeAlias = Property[AsyncPath[int], int | Future[int]]
AsyncFloatProperty: TypeAlias = Property[AsyncPath[float], float | Future[float]]
AsyncStrProperty: TypeAlias = Property[AsyncPath[str], str | Future[str]]
SendBoolProperty: TypeAlias = SendProperty[bool | Future[bool]]
SendIntProperty: TypeAlias = SendProperty[int | Future[int]]
SendFloatProperty: TypeAlias = SendProperty[float | Future[float]]
SendStrProperty: TypeAlias = SendProperty[str | Future[str]]
