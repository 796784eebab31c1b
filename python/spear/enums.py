# SPDX-License-Identifier: MIT
"""Enums of Unreal as enums of Python.

An enum is an ``IntEnum`` (``IntFlag`` where Unreal's entries are bits) that also knows Unreal's names:
``ECollisionChannel("ECC_Pawn")``, ``ECollisionChannel("ECollisionChannel::ECC_Pawn")``. Its values travel together with their names, so an
engine that numbers the entries in another way still gets, and gives, the entry that was meant.

An enum that is imported while nobody knows it (no stubs, no connection) gets its entries later, but is an ``IntEnum`` whatever it turns out to be.
"""

from __future__ import annotations

import enum
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar

from spear import facts

if TYPE_CHECKING:
    from typing_extensions import Self

_classes: dict[str, type[_UnrealValue]] = {}


class _EnumMeta(enum.EnumMeta):
    """Makes members known that only a running engine can tell."""

    if not TYPE_CHECKING:  # a type checker knows the entries from the stubs, and no others

        def __call__(cls, value: Any, *args: Any, **kwargs: Any) -> Any:
            if not args and not kwargs and cls.__dict__.get("unreal_name") and not cls._member_map_ and not learn(cls):
                if isinstance(value, str):
                    return cls._by_name(value)  # raises, with advice
                raise ValueError(_unknown(cls, str(value)))
            return super().__call__(value, *args, **kwargs)

        def __getattr__(cls, name: str) -> Any:
            if not name.startswith("_") and cls.__dict__.get("unreal_name"):
                learn(cls)
                member = cls._member_map_.get(name)
                if member is not None:
                    return member
                raise AttributeError(_unknown(cls, name))
            raise AttributeError(f"type object {cls.__name__!r} has no attribute {name!r}")

        def __getitem__(cls, name: str) -> Any:
            if name not in cls._member_map_:
                learn(cls)
            return super().__getitem__(name)

    def __dir__(cls) -> list[str]:
        return sorted({*super().__dir__(), *cls._member_map_})


class _UnrealValue:
    """What both kinds share."""

    #: The enum's name, e.g. ``"ECollisionChannel"``.
    unreal_name: ClassVar[str] = ""
    _module_name: ClassVar[str]
    _unreal_names: ClassVar[dict[str, str]]  # Unreal's name of an entry by the member's, where they differ

    @classmethod
    def _by_name(cls, text: str) -> Any:
        """The member of one of Unreal's names, with or without the enum's own before it, without regard to case."""
        word = text.strip()
        if "::" in word:
            scope, _, word = word.rpartition("::")
            if scope.lower() != cls.unreal_name.lower():
                raise ValueError(f"{text!r} is no entry of {cls.unreal_name}, but of {scope}")
        for _ in range(2):
            members: Mapping[str, Any] = cls._member_map_  # type: ignore[attr-defined]
            wanted = word.lower()
            for name, member in members.items():
                if wanted in (name.lower(), cls._unreal_names.get(name, name).lower()):
                    return member
            if not learn(cls):
                break
        raise ValueError(_unknown(cls, word))


class UnrealEnum(_UnrealValue, enum.IntEnum, metaclass=_EnumMeta):
    """Base of all enums of Unreal: numbers with Unreal's names."""

    if TYPE_CHECKING:

        def __new__(cls, value: int | str) -> Self: ...

    @property
    def unreal_entry(self) -> str:
        """Unreal's name of the entry, which Python may have to spell in another way (``None_``)."""
        return self._unreal_names.get(self.name, self.name)

    @classmethod
    def _missing_(cls, value: object) -> Any:
        if isinstance(value, str):
            return cls._by_name(value)
        if isinstance(value, int) and learn(cls) and value in cls._value2member_map_:
            return cls._value2member_map_[value]
        return super()._missing_(value)


class UnrealFlags(_UnrealValue, enum.IntFlag, metaclass=_EnumMeta):
    """Base of all enums of Unreal whose entries are bits (``UENUM(Flags)``); ``E("A | B")`` is ``E.A | E.B``."""

    if TYPE_CHECKING:

        def __new__(cls, value: int | str) -> Self: ...

    @classmethod
    def _missing_(cls, value: object) -> Any:
        if isinstance(value, str):
            made = cls(0)
            for part in value.split("|"):
                made |= cls._by_name(part)
            return made
        return super()._missing_(value)


def _unknown(cls: type[_UnrealValue], name: str) -> str:
    known: list[str] = list(cls._member_map_)  # type: ignore[attr-defined]
    if not known:
        return (f"nothing is known of the entries of {cls.unreal_name}, so neither of {name!r}: write the stubs of the application "
                "(spear schema stubs), or connect to an engine that has it first")
    return f"{cls.unreal_name} has no entry {name!r}{facts.advice(name, known, 'its entries are')}"


def enum_class(name: str, module: str = "") -> type[_UnrealValue]:
    """The class of an enum by Unreal's name: always the same one, with the entries that facts tell."""
    with facts.making:
        return _enum_class(name, module)


def _enum_class(name: str, module: str) -> type[_UnrealValue]:
    made = _classes.get(name)
    if made is None:
        found = facts.find(module, name) if module else None
        entity = found[1] if found and found[0] == "enums" else None
        made = _make(name, module, bool(entity and entity.get("flags")))
        if entity:
            _add(made, [(str(entry), int(value)) for entry, value in entity["entries"]], entity.get("names"))
    elif module and not made._module_name:
        made._module_name = module
        made.__module__ = "spear.unreal." + module
    return made


def _make(name: str, module: str, flags: bool) -> type[_UnrealValue]:
    base: Any = UnrealFlags if flags else UnrealEnum
    made: type[_UnrealValue] = base(name, [], module="spear.unreal." + module if module else "spear.enums")
    made.unreal_name = name
    made._module_name = module
    made._unreal_names = {}
    _classes[name] = made
    return made


def _add(cls: Any, entries: Sequence[tuple[str, int]], names: Mapping[str, str] | None = None) -> None:
    """Adds what is missing of Unreal's entries. Members that are there keep their numbers."""
    from spear.codegen.names import ScopeNames

    python = ScopeNames([entry for entry, _ in entries], "entry")
    given = {unreal: member for member, unreal in (names or {}).items()}
    there = {cls._unreal_names.get(member, member).lower(): member for member in cls._member_map_}
    for entry, value in entries:
        if entry.lower() in there:
            continue
        member_name = given.get(entry) or python[entry]
        if member_name in cls._member_map_:
            continue
        same = cls._value2member_map_.get(value)
        if same is not None and cls._member_map_.get(same.name) is same:
            member = same  # a second name of one number is an alias, as in any enum of Python
        else:
            member = int.__new__(cls, value)
            member._name_, member._value_ = member_name, value
            member.__objclass__ = cls
            member._sort_order_ = len(cls._member_names_)
            cls._member_names_.append(member_name)
            cls._value2member_map_[value] = member
            if issubclass(cls, enum.Flag) and hasattr(cls, "_flag_mask_"):
                cls._flag_mask_ |= value
                cls._all_bits_ = 2 ** (cls._flag_mask_.bit_length()) - 1
                if value > 0 and value & (value - 1) == 0 and hasattr(cls, "_singles_mask_"):
                    cls._singles_mask_ |= value
        cls._member_map_[member_name] = member
        type.__setattr__(cls, member_name, member)
        if member_name != entry:
            cls._unreal_names[member_name] = entry


def learn(cls: Any) -> bool:
    """Asks the facts, then connected engines, for entries that the class does not have yet; whether there were any."""
    with facts.making:
        return _learn(cls)


def _learn(cls: Any) -> bool:
    before = len(cls._member_map_)
    module = cls.__dict__.get("_module_name", "")
    if module:
        sources = [facts.from_files(module), *facts.from_engines(module)]
        for source in sources:
            entity = source.enums.get(cls.unreal_name) if source is not None else None
            if entity is not None:
                _add(cls, [(str(entry), int(value)) for entry, value in entity["entries"]], entity.get("names"))
    return len(cls._member_map_) > before


# For the native half ---------------------------------------------------------------------------------------------------------------------


def announced(name: str, path: str, flags: bool, entries: Sequence[tuple[str, int]]) -> tuple[type, dict[int, Any], Callable[[int], Any] | None]:
    """An enum as an engine has it: the class, members by the *engine's* numbers, and for flags what makes the member of a combination."""
    with facts.making:
        return _announced(name, path, flags, entries)


def _announced(name: str, path: str, flags: bool, entries: Sequence[tuple[str, int]]) -> tuple[type, dict[int, Any], Callable[[int], Any] | None]:
    module = facts.module_of_path(path)
    if name not in _classes and not (module and facts.find(module, name)):
        _make(name, module, flags)
    cls: Any = enum_class(name, module)
    _add(cls, entries)
    by_entry = {cls._unreal_names.get(member, member).lower(): value for member, value in cls._member_map_.items()}
    by_number: dict[int, Any] = {}
    other = []
    for entry, number in entries:
        member = by_entry[entry.lower()]
        by_number.setdefault(number, member)
        if int(member) != number:
            other.append(f"{entry} is {number} there, {int(member)} here")
    if other:
        import warnings

        warnings.warn(
            f"the engine numbers the entries of {name} in another way than the stubs ({'; '.join(other[:3])}). Names are what counts, but write "
            "the stubs of this engine: spear schema stubs", stacklevel=2,
        )
    if not issubclass(cls, UnrealFlags):
        return cls, by_number, None

    def combination(number: int) -> Any:
        made = 0
        for bit, member in by_number.items():
            if bit and bit & (bit - 1) == 0 and number & bit:
                made |= int(member)
                number &= ~bit
        return cls(made | number)

    return cls, by_number, combination


def wire_entries(cls: type) -> tuple[str, bool, list[tuple[str, int]]] | None:
    """Name, whether the entries are bits, and Unreal's entries of an enum class; None for a class that is no enum of Unreal."""
    if not issubclass(cls, _UnrealValue):
        return None
    members: Mapping[str, Any] = cls._member_map_  # type: ignore[attr-defined]
    return cls.unreal_name, issubclass(cls, UnrealFlags), [(cls._unreal_names.get(name, name), int(member)) for name, member in members.items()]
