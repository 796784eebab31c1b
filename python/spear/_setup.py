# SPDX-License-Identifier: MIT
"""Tells the native half which Python classes to make: objects, structs, enums, errors."""

from __future__ import annotations

import enum
from collections.abc import Sequence

from spear import _native, errors, structs
from spear.unreal_object import UnrealObject, future_object


def _enum_class(name: str, entries: Sequence[tuple[str, int]]) -> type[enum.IntEnum]:
    """An enum of Unreal as an IntEnum: compares with numbers, and has Unreal's names."""
    members: dict[str, int] = {}
    for entry, value in entries:
        # Names that Python reserves get an underscore, as in the stubs; the first of two names for one value wins, as in Unreal.
        members.setdefault(entry + "_" if entry in ("None", "True", "False", "mro") else entry, value)
    made: type[enum.IntEnum] = enum.IntEnum(name, members)  # type: ignore[misc]  # a name known at run time only
    return made


_native.setup(UnrealObject, structs.Struct, structs.struct_class, _enum_class, errors.BY_NAME, future_object)
