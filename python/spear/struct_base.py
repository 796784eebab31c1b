# SPDX-License-Identifier: MIT
"""What all structs of Unreal share as Python values, and the classes of those that nobody wrote by hand (see spear.structs)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, NoReturn, TypeVar

from spear import _native, facts

_S = TypeVar("_S", bound="Struct")
_classes: dict[str, type[Struct]] = {}
_set = object.__setattr__


class Struct(_native.StructBase):
    """Base of all struct values. Fields are attributes; two structs are equal if name and fields are.

    A field that was not given is *unset*: it has no value here (AttributeError), it is not sent, and the engine gives it Unreal's own
    default; written to a variable, it leaves that part of the variable as it is. The mathematical structs set every field at once.
    """

    __slots__: tuple[str, ...] = ()
    #: Unreal's name of the struct, e.g. ``"FVector"``.
    struct_name: ClassVar[str] = ""
    #: Unreal's field names in Unreal's order; empty as long as neither facts nor an engine have told them.
    field_names: ClassVar[tuple[str, ...]] = ()
    #: Wire types of the fields where all of them are numbers ("f64", "f32", "u8", ...): these travel as plain numbers.
    field_types: ClassVar[tuple[str, ...]] = ()
    #: Values of fields that are not given; empty: they stay unset.
    field_defaults: ClassVar[tuple[Any, ...]] = ()
    _attributes: ClassVar[tuple[str, ...]] = ()  # the fields' names in Python, in the same order
    _made_here: ClassVar[bool] = False  # by struct_class: fields may become known later

    def __init_subclass__(cls, **kwargs: Any) -> None:
        super().__init_subclass__(**kwargs)
        if cls.__dict__.get("struct_name"):
            cls._attributes = cls.__dict__.get("_attributes", cls.field_names)
            _classes[cls.struct_name] = cls

    def _initialise(self, *values: Any, **fields: Any) -> None:
        """What ``__init__`` of the native half leaves to Python: classes without a slot for each field, and what is given in other ways."""
        names = self._attributes
        if not fields and len(values) == len(names):
            for name, value in zip(names, values):
                _set(self, name, value)
            return
        if len(values) > len(names):
            if not names:
                _learn(type(self))
                names = self._attributes
            if len(values) > len(names):
                self._refuse_values(len(values))
        for name, default in zip(names, self.field_defaults):
            _set(self, name, default() if callable(default) else default)
        for name, value in zip(names, values):
            _set(self, name, value)
        for name, value in fields.items():
            if name not in names:
                name = self._attribute_of(name)
                names = self._attributes
            if name in names[: len(values)]:
                raise TypeError(f"{self.struct_name}: field {name!r} was given twice")
            _set(self, name, value)

    def _refuse_values(self, count: int) -> NoReturn:
        names = self._attributes
        if not names:
            raise TypeError(
                f"nothing is known of the order of the fields of {self.struct_name}: give them by name, or write the stubs of the application "
                "(spear schema stubs)")
        raise TypeError(f"{self.struct_name} has {len(names)} fields ({', '.join(names)}), {count} values were given")

    @classmethod
    def _attribute_of(cls, name: str) -> str:
        """The attribute of a field named in Unreal's or in Python's way; TypeError if there is none."""
        if name in cls._attributes:
            return name
        if name in cls.field_names:
            return cls._attributes[cls.field_names.index(name)]
        if not cls.field_names and cls._made_here and not _learn(cls):
            return name  # nobody knows better, the engine will
        if name in cls._attributes:
            return name
        raise TypeError(f"{cls.struct_name} has no field {name!r}{facts.advice(name, cls._attributes, 'its fields are')}")

    if not TYPE_CHECKING:  # type checkers know the fields, and no others

        def __getattr__(self, name: str) -> NoReturn:
            if name.startswith("__"):
                raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
            if name in self._attributes:
                raise AttributeError(f"field {name!r} of this {self.struct_name} was not given: the engine will give it Unreal's own default")
            raise AttributeError(f"{self.struct_name} has no field {name!r}{facts.nearest(name, self._attributes)}")

    def _items(self) -> Iterator[tuple[str, Any]]:
        """(Unreal's name, value) of every field that is set."""
        if not self.field_names:
            yield from vars(self).items()
        for name, attribute in zip(self.field_names, self._attributes):
            try:
                yield name, object.__getattribute__(self, attribute)
            except AttributeError:
                pass

    @classmethod
    def from_dict(cls: type[_S], values: Mapping[str, Any]) -> _S:
        """Makes the struct from a dictionary of its fields; absent ones stay unset, or keep their defaults."""
        return cls(**values)

    def to_dict(self) -> dict[str, Any]:
        """The fields that are set as plain dictionaries, by Unreal's names; nested structs too."""
        return {name: _plain(value) for name, value in self._items()}

    def copy(self: _S) -> _S:
        """An independent value: nested structs and containers are copied too."""
        import copy

        return copy.deepcopy(self)

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Struct):
            return self.struct_name == other.struct_name and dict(self._items()) == dict(other._items())
        if isinstance(other, Mapping):
            return dict(self._items()) == other
        return NotImplemented

    __hash__ = None  # type: ignore[assignment]  # mutable values

    def __iter__(self) -> Iterator[Any]:
        """The field values in order, so that ``x, y, z = vector`` works."""
        return (getattr(self, name) for name in self._attributes)

    def __dir__(self) -> list[str]:
        return sorted({*object.__dir__(self), *self._attributes})

    def __repr__(self) -> str:
        attributes = dict(zip(self.field_names, self._attributes))
        return f"{self.struct_name}({', '.join(f'{attributes.get(name, name)}={value!r}' for name, value in self._items())})"


def _checked_setattr(self: Struct, name: str, value: Any) -> None:
    """``__setattr__`` of classes made here; those written by hand have slots that do the same."""
    if name not in self._attributes:
        try:
            name = self._attribute_of(name)
        except TypeError as error:
            raise AttributeError(str(error)) from None
    _set(self, name, value)


def _plain(value: Any) -> Any:
    if isinstance(value, Struct):
        return value.to_dict()
    if isinstance(value, list):
        return [_plain(v) for v in value]
    if isinstance(value, dict):
        return {k: _plain(v) for k, v in value.items()}
    return value


def struct_class(name: str, field_names: Sequence[str] = (), module: str = "") -> type[Struct]:
    """The class of a struct by Unreal's name, always the same one; made on the spot for one not seen before.

    Its fields are those that facts tell, and those given here (an engine's, which come first and count).
    """
    known = _classes.get(name)
    if known is not None and (not field_names or known.field_names == tuple(field_names)):
        return known
    with facts.making:
        return _struct_class(name, field_names, module)


def _struct_class(name: str, field_names: Sequence[str], module: str) -> type[Struct]:
    made = _classes.get(name)
    if made is None:
        found = facts.find(module, name) if module else None
        entity = found[1] if found and found[0] == "structs" else {}
        base = struct_class(entity["super"], (), _module_of_struct(entity["super"], module)) if entity.get("super") else Struct
        namespace: dict[str, Any] = {
            "__module__": "spear.unreal." + module if module else "spear.structs", "_made_here": True, "struct_name": name,
            "field_names": (), "field_types": (), "field_defaults": (), "_attributes": (), "__setattr__": _checked_setattr,
        }
        made = type(name, (base,), namespace)
        fields = tuple(entity.get("fields") or ())
        if base is not Struct and fields == base.field_names:  # FVector_NetQuantize is an FVector in all but name
            made.field_types, made.field_defaults = base.field_types, base.field_defaults
        _set_fields(made, fields, entity.get("names"))
    if field_names and made.field_names != tuple(field_names):
        if not made._made_here:
            # An engine whose FVector is not ours: a class of its own, so that nothing is lost.
            other: type[Struct] = type(name, (Struct,), {"_made_here": True, "__module__": "spear.structs", "__setattr__": _checked_setattr})
            other.struct_name = name
            _set_fields(other, tuple(field_names))
            return other
        _set_fields(made, (*field_names, *(field for field in made.field_names if field not in field_names)))
    return made


def _set_fields(cls: type[Struct], fields: tuple[str, ...], names: Mapping[str, str] | None = None) -> None:
    if not fields:
        return
    from spear.codegen.names import ScopeNames

    python = ScopeNames(fields, "field")
    given = {unreal: attribute for attribute, unreal in (names or {}).items()}
    given.update(zip(cls.field_names, cls._attributes))  # an attribute keeps its name
    if not set(cls.field_names) <= set(fields) or (cls.field_defaults and cls.field_names != fields):
        cls.field_types, cls.field_defaults = (), ()
    cls._attributes = tuple(given.get(field) or python[field] for field in fields)
    cls.field_names = fields


def _module_of_struct(name: str, module: str) -> str:
    """The module of a struct that one of a module derives from."""
    for candidate in (module, "CoreUObject", "Engine"):
        known = facts.from_files(candidate)
        if known is not None and name in known.structs:
            return candidate
    return next((known.module for known in facts.all_files() if name in known.structs), "")


def _learn(cls: type[Struct]) -> bool:
    """Asks facts and connected engines for the fields of a class made without; whether they are known now."""
    module = cls.__module__.rpartition("spear.unreal.")[2] if cls.__module__.startswith("spear.unreal.") else ""
    if module and cls._made_here and not cls.field_names:
        for source in [facts.from_files(module), *facts.from_engines(module)]:
            entity = source.structs.get(cls.struct_name) if source is not None else None
            if entity is not None:
                _set_fields(cls, tuple(entity.get("fields") or ()), entity.get("names"))
                break
    return bool(cls.field_names)


# For the native half ---------------------------------------------------------------------------------------------------------------------


def announced(name: str, path: str, field_names: Sequence[str]) -> tuple[type[Struct], tuple[str, ...]]:
    """A struct as an engine has it: the class, and the attributes of its fields in the engine's order."""
    cls = struct_class(name, field_names, facts.module_of_path(path))
    attributes = dict(zip(cls.field_names, cls._attributes))
    return cls, tuple(attributes[field] for field in field_names)
