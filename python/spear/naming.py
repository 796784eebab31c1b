# SPDX-License-Identifier: MIT
"""Names of Unreal that are spelled in another way in Python (``spear.codegen.names`` has the rule): back to Unreal's.

A name with a meaning in Python, or in this package, has an underscore at its end (``object.get_``, ``object.class_``). Names that are no
identifiers at all (Blueprints' may hold blanks) are known by the facts of their class.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from spear import _native, facts

#: Python's name of a member -> Unreal's, or, where it depends on the class, {class or struct: Unreal's name}. Filled by load().
renamed: dict[str, str | Mapping[str, str]] = {}
_loaded = False


def load() -> None:
    """Fills the table; before the first object comes. Later calls do nothing."""
    global _loaded
    if _loaded:
        return
    _loaded = True
    from spear.codegen.names import OBJECT_MEMBERS, PYTHON_WORDS, RESERVED, STRUCT_MEMBERS, python_name

    for scope in ("member", "field"):
        for word in PYTHON_WORDS | RESERVED[scope]:
            name = python_name(word, scope)
            if name != word and name not in OBJECT_MEMBERS and name not in STRUCT_MEMBERS:
                renamed[name] = word
    tables: dict[str, dict[str, str]] = {}
    for module in facts.all_files():
        for kind in (module.classes, module.structs):
            for owner, entity in kind.items():
                for name, unreal in (entity.get("names") or {}).items():
                    tables.setdefault(name, {})[owner] = unreal
    renamed.update(tables)
    _native.forget_names()


def _forget() -> None:
    global _loaded
    _loaded = False
    renamed.clear()
    _native.forget_names()
    if facts.has_instances():
        load()


facts.on_forget.append(_forget)


def unreal_name_of(target: Any, name: str) -> str:
    """Unreal's name of a member of an object; ``target`` is None where its class is not known."""
    known = renamed[name]
    if isinstance(known, str):
        return known
    if isinstance(target, _native.Object):
        for owner in target._class_names:
            if owner in known:
                return known[owner]
        if facts.class_facts(target._class_name) is not None:
            return name  # the class is known, and has no such entry: Unreal's name looks like another's name in Python
    names = set(known.values())
    return names.pop() if len(names) == 1 else name


def parameter_name(keyword: str) -> str:
    """Unreal's name of a parameter: ``class_`` stands for ``class``."""
    from spear.codegen.names import unreal_name_of as rule

    return rule(keyword, None, "parameter")
