# SPDX-License-Identifier: MIT
"""Names of Unreal as names of Python and C++: one rule for stubs, run time, proxies and reference.

Imports nothing of the emitter, as the run time uses it too (``spear.codegen.names``). Most names stay as they are. A name that a language
reserves, or that the SDK itself uses in that place, gets a trailing underscore, which ``unreal_name_of`` takes off again; what cannot be an
identifier at all (names of Blueprints hold blanks) is changed in a way that only a table of names undoes (``facts.json``, ``ScopeNames``).
"""

from __future__ import annotations

import keyword
import re
import unicodedata
from collections.abc import Iterable, Mapping

#: Python's own words: never names of anything.
PYTHON_WORDS = frozenset(keyword.kwlist)

#: Types that annotations in the body of a class name; a member of such a name would hide them.
_ANNOTATION_WORDS = frozenset({"bool", "bytes", "dict", "float", "int", "list", "object", "set", "str", "tuple", "type"})

#: What objects, paths to variables and their asynchronous twins have themselves. Short and closed.
OBJECT_MEMBERS = frozenset({
    "async_", "send_", "call", "get", "set", "get_or_none", "is_valid", "get_class", "get_path_name", "get_component", "get_components",
    "unreal_name",
})

#: What values of structs have themselves, and paths to structs.
STRUCT_MEMBERS = frozenset({
    "async_", "send_", "get", "set", "get_or_none", "struct_name", "field_names", "field_types", "field_defaults", "from_dict", "to_dict", "copy",
    "from_numpy", "to_numpy", "to_matrix", "from_matrix",
})

#: What entries of enums have themselves, as integers too.
ENUM_MEMBERS = frozenset({
    "as_integer_ratio", "bit_count", "bit_length", "conjugate", "denominator", "from_bytes", "imag", "is_integer", "mro", "name", "numerator", "real",
    "to_bytes", "unreal_entry", "value",
})

#: By the place where a name of Unreal stands: the words it may not be there.
RESERVED: Mapping[str, frozenset[str]] = {
    # functions and variables of an object
    "member": _ANNOTATION_WORDS | OBJECT_MEMBERS | {"async", "send", "self"},
    # fields of a struct, as a value and as a path
    "field": _ANNOTATION_WORDS | STRUCT_MEMBERS | {"async", "send", "self"},
    # entries of an enum
    "entry": _ANNOTATION_WORDS | ENUM_MEMBERS | {"self"},
    # parameters of a function
    "parameter": frozenset({"self"}),
    # fields of the named tuple that a function with several results returns
    "result": frozenset({"count", "index", "self"}),
    # classes, structs, enums
    "type": frozenset({"Any", "ClassVar", "NamedTuple", "TypedDict"}),
}

#: Attributes of objects that Python code must never meet as names of Unreal.
_PRIVATE = frozenset({"_class_name", "_class_names", "_future", "_handle", "_mode", "_path", "_session", "_target"})

#: ``async_`` and ``send_`` are the SDK's, so these two words get two underscores where objects and structs are concerned.
_DOUBLE = frozenset({"async", "send"})

CPP_WORDS = frozenset(
    "alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t char32_t class compl concept const consteval "
    "constexpr constinit const_cast continue co_await co_return co_yield decltype default delete do double dynamic_cast else enum explicit export "
    "extern false float for friend goto if inline int long mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected "
    "public register reinterpret_cast requires return short signed sizeof static static_assert static_cast struct switch template this thread_local "
    "throw true try typedef typeid typename union unsigned using virtual void volatile wchar_t while xor xor_eq".split()
)


def _identifier(name: str) -> str:
    """The name with everything replaced that no identifier may hold. Python reads identifiers in the normal form NFKC."""
    text = unicodedata.normalize("NFKC", name)
    if not text.isidentifier():
        text = "".join(c if ("a" + c).isidentifier() else "_" for c in text)
        if not text or not text.isidentifier():
            text = "x" + text
    return text


def _mark(name: str, scope: str) -> str:
    """The underscores that a reserved name gets; "" if it is not reserved."""
    word = name.rstrip("_")
    if scope in ("member", "field") and word in _DOUBLE:
        return "__"
    return "_" if word in PYTHON_WORDS or word in RESERVED[scope] or name in RESERVED[scope] else ""


def python_name(unreal_name: str, scope: str = "member") -> str:
    """The Python name of a name of Unreal; ``scope`` is a key of RESERVED."""
    name = _identifier(unreal_name)
    if name.startswith("__") or name in _PRIVATE or (scope in ("entry", "result") and name.startswith("_")):
        name = "x" + name  # private to Python's classes, or to ours
    return name + _mark(name, scope)


def python_names(unreal_names: Iterable[str], scope: str = "member") -> list[str]:
    """The Python names of everything in one scope, distinct ones, in the order given (see ScopeNames)."""
    listed = list(unreal_names)
    names = ScopeNames(listed, scope)
    return [names[unreal] for unreal in listed]


def unreal_name_of(name: str, table: Mapping[str, str] | None = None, scope: str = "member") -> str:
    """The name of Unreal behind a Python name. ``table``: Python name -> name of Unreal, where the rule alone does not tell."""
    if table and name in table:
        return table[name]
    mark = _mark(name.rstrip("_"), scope)
    if mark and name.endswith(mark):
        return name[: -len(mark)]
    return name


class ScopeNames:
    """The Python names of everything in one scope (members of a class, fields of a struct, parameters): distinct ones.

    Names that need no change have the first claim on themselves; then come the others in the order given; a name already taken gets
    ``_2``, ``_3`` ...
    """

    def __init__(self, unreal_names: Iterable[str], scope: str = "member", taken: Iterable[str] = ()) -> None:
        self.scope = scope
        self._python: dict[str, str] = {}
        used = set(taken)
        listed = list(dict.fromkeys(unreal_names))
        for unreal in listed:
            if python_name(unreal, scope) == unreal and unreal not in used:
                self._python[unreal] = unreal
                used.add(unreal)
        for unreal in listed:
            if unreal not in self._python:
                wanted = python_name(unreal, scope)
                name, number = wanted, 1
                while name in used:
                    number += 1
                    name = f"{wanted}_{number}"
                self._python[unreal] = name
                used.add(name)

    def __getitem__(self, unreal_name: str) -> str:
        return self._python[unreal_name]

    def table(self) -> dict[str, str]:
        """Python name -> name of Unreal, for the names that ``unreal_name_of`` cannot tell by its rule."""
        return {name: unreal for unreal, name in self._python.items() if unreal_name_of(name, None, self.scope) != unreal}


def cpp_name(unreal_name: str, reserved: Iterable[str] = ()) -> str:
    """The C++ name of a name of Unreal: an identifier that is no word of C++ and none of ``reserved`` (the SDK's own in that place)."""
    name = re.sub(r"[^0-9A-Za-z_]", "_", unreal_name)
    if not name or name[0].isdigit():
        name = "x" + name
    if name.startswith("_") and (len(name) == 1 or name[1] == "_" or name[1].isupper()):
        name = "x" + name  # reserved for the implementation
    name = re.sub(r"__+", "_", name) if "__" in name else name
    word = name.rstrip("_")
    return name + "_" if word in CPP_WORDS or word in set(reserved) else name


def short_entry_name(entry_name: str) -> str:
    """``EFoo::Bar`` -> ``Bar``; ``ECC_Pawn`` stays."""
    return entry_name.rpartition("::")[2]
