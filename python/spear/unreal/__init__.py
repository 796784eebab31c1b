# SPDX-License-Identifier: MIT
"""Unreal's types by their modules: ``from spear.unreal.Engine import AActor, FHitResult, ECollisionChannel``.

Every module of Unreal is one here, with no connection and whether or not there are stubs for it. Names are made when they are first asked
for, and are the same object each time: classes (``U...``, ``A...``, ``I...``) for lookups and ``isinstance``, structs (``F...``), enums
(``E...``). Where facts are known (stubs, or a connected engine) a name that is not among them is an error that says which are near.

The types that editors and type checkers see are in stubs beside this file; ``spear schema stubs`` writes those of your own project.
"""

from __future__ import annotations

import re
import sys
import types
from collections.abc import Sequence
from importlib.machinery import ModuleSpec
from typing import Any

from spear import facts

_PREFIX = __name__ + "."
#: What stubs add to the name of a type: kinds of it that only annotations name.
_HELPERS = re.compile(r"^(?P<type>.+?)_(?P<kind>async_path|async_members|members|path|async|send|dict|in|Result)$")


class UnrealModule(types.ModuleType):
    """A module of Unreal."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(f"module {self.__name__!r} has no attribute {name!r}")
        try:
            made = _make(self.__name__[len(_PREFIX):], name)
        except AttributeError as error:
            if _is_import(sys._getframe(1)):  # Python would say "cannot import name", and drop the advice
                raise ImportError(str(error), name=self.__name__) from None
            raise
        self.__dict__[name] = made
        return made

    def __dir__(self) -> list[str]:
        """The types that are known: by facts, by connected engines, or by having been asked for."""
        module = self.__name__[len(_PREFIX):]
        known = {name for name in self.__dict__ if not name.startswith("__")}
        sources = [facts.from_files(module)]
        if sources[0] is None:
            sources += facts.from_engines(module)
        for source in sources:
            if source is not None:
                known.update(source.names())
        return sorted(known)

    def __repr__(self) -> str:
        return f"<module {self.__name__!r}: types of Unreal>"


def _is_import(frame: types.FrameType) -> bool:
    """Whether a frame is at ``from module import name``, and not at ``module.name``."""
    import opcode

    return frame.f_lasti >= 0 and opcode.opname[frame.f_code.co_code[frame.f_lasti]] == "IMPORT_FROM"


class _Importer:
    """Finds and makes the modules; Python's import system calls it."""

    @staticmethod
    def find_spec(name: str, path: Sequence[str] | None = None, target: types.ModuleType | None = None) -> ModuleSpec | None:
        """Every ``spear.unreal.<Name>`` exists."""
        if not name.startswith(_PREFIX):
            return None
        module = name[len(_PREFIX):]
        if "." in module or not module.isidentifier() or module.startswith("_"):
            return None
        return ModuleSpec(name, _Importer, origin="Unreal")  # type: ignore[arg-type]  # a loader by its methods

    @staticmethod
    def create_module(spec: ModuleSpec) -> types.ModuleType:
        """The module, empty."""
        return UnrealModule(spec.name, f"Types of Unreal's module {spec.name[len(_PREFIX):]}, made when they are asked for.")

    @staticmethod
    def exec_module(module: types.ModuleType) -> None:
        """Reads the facts, so that a broken file is an ImportError and no riddle later."""
        facts.from_files(module.__name__[len(_PREFIX):])


def _make(module: str, name: str) -> Any:
    """A type of a module by its name; AttributeError with the nearest names."""
    from spear.enums import enum_class
    from spear.structs import struct_class
    from spear.unreal_classes import unreal_class

    found = facts.find(module, name)
    if found is not None:
        kind = found[0]
        if kind == "classes":
            return unreal_class("I" + name[1:] if _is_interface(name, found[1]) else name, module)
        return struct_class(name, (), module) if kind == "structs" else enum_class(name, module)

    if name[:1] in ("I", "U"):  # interfaces go by two names
        other = ("U" if name[0] == "I" else "I") + name[1:]
        found = facts.find(module, other)
        if found is not None and found[0] == "classes" and _is_interface(other, found[1]):
            return unreal_class("I" + name[1:], module)

    for source in [facts.from_files(module), *facts.from_engines(module)]:
        if source is not None and name in source.delegates:  # a delegate is a value of its bindings
            return struct_class("FScriptDelegate", (), "CoreUObject") if source.delegates[name] == "single" else list

    helper = _HELPERS.match(name)
    if helper and (facts.find(module, helper["type"]) or helper["kind"] == "Result" or facts.from_files(module) is None):
        return _helper(module, helper["type"], helper["kind"], name)

    own = facts.from_files(module)
    known = [source for source in [own, *facts.from_engines(module)] if source is not None]
    if not known:
        if re.match(r"[UAI][A-Z0-9_]", name):
            return unreal_class(name, module)
        if re.match(r"F[A-Z0-9_]", name):
            return struct_class(name, (), module)
        if re.match(r"E[A-Z0-9_]", name):
            return enum_class(name, module)
        raise AttributeError(f"module {_PREFIX}{module} has no {name!r}: types of Unreal begin with U, A or I (classes), F (structs), E (enums)")
    raise AttributeError(_advice(module, name, known))


def _is_interface(name: str, entity: dict[str, Any]) -> bool:
    if name[0] == "I":
        return True
    parent: str | None = name
    while parent is not None:
        if parent == "UInterface":
            return True
        parent = (facts.class_facts(parent) or (entity if parent == name else {})).get("super")
    return False


def _helper(module: str, name: str, kind: str, full: str) -> Any:
    """What only annotations name, as something that can be imported (and, where that makes sense, asked ``isinstance``)."""
    from spear.results import Result
    from spear.unreal_object import AsyncNamespace, Member, ObjectBase, SendNamespace

    if kind in ("dict", "in"):
        return dict if kind == "dict" else object
    bases: dict[str, type] = {
        "members": ObjectBase, "path": Member, "async": AsyncNamespace, "async_members": AsyncNamespace, "async_path": Member,
        "send": SendNamespace, "Result": Result,
    }
    base = bases[kind]

    class Annotation(type):
        def __instancecheck__(cls, instance: object) -> bool:
            # The class of a result is named after its function alone; those of a path's target are the engine's affair.
            return isinstance(instance, base) and (kind != "Result" or full.endswith("_" + type(instance).__name__))

        def __call__(cls, *args: Any, **kwargs: Any) -> Any:
            raise TypeError(f"{full} is for annotations: such values come from objects of the engine")

        def __repr__(cls) -> str:
            return f"<annotation {_PREFIX}{module}.{full}>"

    return Annotation(full, (), {"__module__": _PREFIX + module, "__doc__": f"For annotations: {kind} of {name}."})


def _advice(module: str, name: str, known: Sequence[facts.ModuleFacts]) -> str:
    names = [entry for source in known for entry in source.names()]
    near = facts.nearest(name, names)
    if not near:
        elsewhere = next((source.module for source in facts.all_files() if source.module != module and name in source), "")
        near = f"; it is in {_PREFIX}{elsewhere}" if elsewhere else ""
    own = facts.from_files(module)
    origin = f" according to {own.origin}" if own is not None else ""
    return f"module {_PREFIX}{module} has no {name!r}{origin}{near}. If your application has it: spear schema stubs, or connect to it first"


def __getattr__(name: str) -> Any:
    """``spear.unreal.Engine`` without an import of its own, for modules that are known."""
    if not name.startswith("_") and name in facts.modules():
        import importlib

        return importlib.import_module(_PREFIX + name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}; modules of Unreal are imported: import {_PREFIX}{name}")


def __dir__() -> list[str]:
    return sorted({*facts.modules(), *(name[len(_PREFIX):] for name in sys.modules if name.startswith(_PREFIX))})


if _Importer not in sys.meta_path:
    sys.meta_path.insert(0, _Importer)  # before the folders of stubs are taken for namespace packages
