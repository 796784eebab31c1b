# SPDX-License-Identifier: MIT
"""What a class has, from the running engine: for ``dir()``, completion in a shell, and ``help``-like printing."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from spear._native import SYNC

if TYPE_CHECKING:
    from spear._native import Session
    from spear.unreal_object import UnrealObject

_cache: dict[tuple[int, str], dict[str, Any]] = {}


def describe_class(session: Session, class_name: str) -> dict[str, Any]:
    """The class in the form of the schema (its own functions and properties, ``super``); asked once per session."""
    key = (session.serial, class_name)
    if key not in _cache:
        _cache[key] = session.call("unreal_service.describe_class", (class_name,), {}, SYNC)
    return _cache[key]


def member_names(unreal_object: UnrealObject) -> list[str]:
    """Names of all functions and properties of the object's class, inherited ones too, as Python spells them; empty if the engine cannot be asked."""
    from spear.codegen.names import python_names
    from spear.errors import Error

    names: list[str] = []
    try:
        current: str | None = unreal_object._class_name
        while current:
            entity = describe_class(unreal_object._session, current)
            names += [f["name"] for f in entity.get("functions", ())]
            names += [p["name"] for p in entity.get("properties", ())]
            current = entity.get("super")
    except Error:
        pass  # completion must not raise
    return python_names(dict.fromkeys(names))
