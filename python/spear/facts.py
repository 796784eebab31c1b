# SPDX-License-Identifier: MIT
"""What is known about Unreal's types without asking an engine: fields of structs, entries of enums, bases of classes, changed names.

Facts of a module come from ``facts.json`` beside its stubs: of the application's own stubs (the installed package ``spear-stubs``, written by
``spear schema stubs``) first, then of the embedded engine's, which are part of this package. What neither has is asked from the engines that
this process is connected to.
"""

from __future__ import annotations

import _thread
import os
import sys
import weakref
from collections.abc import Callable, Iterable, Iterator
from typing import Any

from spear.errors import Error

#: What facts.json holds of one type.
Entity = dict[str, Any]

_KINDS = ("classes", "structs", "enums")

#: Held while a type is made, so that threads that ask for one at once get the same.
making = _thread.RLock()

#: Called when facts were forgotten: tables made from them are made anew.
on_forget: list[Callable[[], None]] = []


class ModuleFacts:
    """The facts of one module, from a file or from a running engine."""

    def __init__(self, module: str, origin: str, document: dict[str, Any]) -> None:
        self.module = module
        self.origin = origin
        self.classes: dict[str, Entity] = document.get("classes") or {}
        self.structs: dict[str, Entity] = document.get("structs") or {}
        self.enums: dict[str, Entity] = document.get("enums") or {}
        #: "single", "multicast" or "sparse" by the delegate's name.
        self.delegates: dict[str, str] = document.get("delegates") or {}

    def names(self) -> list[str]:
        """Every type of the module."""
        return [*self.classes, *self.structs, *self.enums, *self.delegates]

    def __contains__(self, name: str) -> bool:
        return name in self.classes or name in self.structs or name in self.enums or name in self.delegates


_files: dict[str, ModuleFacts | None] = {}
_live: dict[tuple[int, str], ModuleFacts | None] = {}
_instances: weakref.WeakSet[Any] = weakref.WeakSet()  # spear.Instance, which this module must not import
_class_module: dict[str, str] | None = None


def forget() -> None:
    """Reads everything anew when it is next asked for: after new stubs were installed in a running process."""
    global _class_module
    _files.clear()
    _live.clear()
    _class_module = None
    for tell in on_forget:
        tell()


def add_instance(instance: Any) -> None:
    """Lets what no file knows be asked from a running engine."""
    _instances.add(instance)


def has_instances() -> bool:
    """Whether this process is connected to an engine."""
    return len(_instances) > 0


def folders() -> list[str]:
    """Where facts lie, the more important first."""
    found = [os.path.join(entry or os.curdir, "spear-stubs", "unreal") for entry in sys.path]
    own = os.path.join(os.path.dirname(os.path.abspath(__file__)), "unreal")
    return [folder for folder in dict.fromkeys([*found, own]) if os.path.isdir(folder)]


def modules() -> list[str]:
    """The modules that files know."""
    return sorted({entry for folder in folders() for entry in os.listdir(folder) if os.path.isfile(os.path.join(folder, entry, "facts.json"))})


def from_files(module: str) -> ModuleFacts | None:
    """The facts of a module that lie in a file; None without one."""
    if module not in _files:
        import json

        _files[module] = None
        for folder in folders():
            file = os.path.join(folder, module, "facts.json")
            try:
                with open(file, encoding="utf-8") as stream:
                    document = json.load(stream)
            except FileNotFoundError:
                continue
            except (OSError, ValueError) as error:
                raise ImportError(f"{file} cannot be read: {error}. Write the stubs anew: spear schema stubs") from error
            if not isinstance(document, dict):
                raise ImportError(f"{file} holds no facts. Write the stubs anew: spear schema stubs")
            _files[module] = ModuleFacts(module, file, document)
            break
    return _files[module]


def from_engines(module: str) -> list[ModuleFacts]:
    """The facts of a module as the engines have it that this process is connected to; empty if none has it."""
    found = []
    for instance in list(_instances):
        if not instance.is_running():
            continue
        key = (instance._session.serial, module)
        if key not in _live:
            try:
                _live[key] = _facts_of_schema(module, instance.address, instance.get_schema([module]))
            except Error:
                _live[key] = None  # it has no such module, or has ended: then it knows nothing
        facts = _live[key]
        if facts is not None:
            found.append(facts)
    return found


def find(module: str, name: str) -> tuple[str, Entity] | None:
    """("classes" | "structs" | "enums", facts) of a type of a module; asks connected engines for what no file knows."""
    sources = [from_files(module)]
    if sources[0] is None or name not in sources[0]:
        sources += from_engines(module)
    for facts in sources:
        if facts is not None:
            for kind in _KINDS:
                entity = getattr(facts, kind).get(name)
                if entity is not None:
                    return kind, entity
    return None


def module_of_class(name: str) -> str:
    """The module of a class that a file knows; empty for others."""
    global _class_module
    if _class_module is None:
        _class_module = {}
        for facts in all_files():
            for known in facts.classes:
                _class_module.setdefault(known, facts.module)
    return _class_module.get(name, "")


def class_facts(name: str) -> Entity | None:
    """The facts of a class of any module that a file knows."""
    facts = from_files(module_of_class(name)) if module_of_class(name) else None
    return facts.classes.get(name) if facts else None


def all_files() -> Iterator[ModuleFacts]:
    """The facts of every module that files know; a file that cannot be read is left out here, and raises when its module is imported."""
    for module in modules():
        try:
            facts = from_files(module)
        except ImportError:
            continue
        if facts is not None:
            yield facts


def module_of_path(path: str) -> str:
    """``/Script/Engine.HitResult`` -> ``Engine``; empty for what is defined in content."""
    return path[len("/Script/"):].partition(".")[0] if path.startswith("/Script/") else ""


def nearest(name: str, known: Iterable[str]) -> str:
    """"; did you mean 'X'?" with the nearest names, or nothing."""
    import difflib

    choices = list(known)
    folded = {choice.lower(): choice for choice in choices}
    near = [folded[match] for match in difflib.get_close_matches(name.lower(), folded, 3, 0.7)]
    return f"; did you mean {' or '.join(map(repr, near))}?" if near else ""


def advice(name: str, known: Iterable[str], what: str) -> str:
    """The nearest names, or else what there is: "; its fields are X, Y, Z"."""
    choices = list(known)
    listed = ", ".join(choices[:12]) + (", ..." if len(choices) > 12 else "")
    return nearest(name, choices) or (f"; {what} {listed}" if choices else "")


def _facts_of_schema(module: str, origin: str, schema: dict[str, Any]) -> ModuleFacts | None:
    """The facts that a live schema tells: all but what only comments say (never_null)."""
    from spear.codegen.names import ScopeNames, short_entry_name

    document: dict[str, Any] = {kind: {} for kind in _KINDS}
    structs = {entity["name"]: entity for entity in schema.get("structs", ())}
    for entity in schema.get("classes", ()):
        members = [member["name"] for part in ("functions", "properties") for member in entity[part]]
        document["classes"][entity["name"]] = {
            "super": entity["super"], "interfaces": entity["interfaces"], "never_null": [], "names": ScopeNames(members).table(),
        }
    for name, entity in structs.items():
        fields: list[str] = []
        part: dict[str, Any] | None = entity
        while part is not None:
            fields = [field["name"] for field in part["properties"]] + fields
            if part["super"] is not None and part["super"] not in structs:
                break  # of another module: the inherited fields come with the first value
            part = structs.get(part["super"])
        document["structs"][name] = {"super": entity["super"], "fields": fields if part is None else [], "names": ScopeNames(fields, "field").table()}
    for entity in schema.get("enums", ()):
        entries = [[short_entry_name(entry["name"]), entry["value"]] for entry in entity["entries"]]
        document["enums"][entity["name"]] = {
            "flags": "Flags" in entity["flags"], "entries": entries, "names": ScopeNames([name for name, _ in entries], "entry").table(),
        }
    document["delegates"] = {entity["name"]: entity["kind"] for entity in schema.get("delegates", ())}
    facts = ModuleFacts(module, origin, document)
    return facts if facts.names() else None
