# SPDX-License-Identifier: MIT
"""What calling a function of Unreal looks like from outside: one account of it for stubs, proxies, reference and run time.

The rules are the server's (``CallPlanBuilder.cpp``), so that what is promised is what happens:

- an input is every parameter that is not an output alone; ``const T&`` is an input; ``UPARAM(ref) T&`` is input and output;
- the world context is filled in by the server unless it is given by keyword; latent information is always the server's;
- an input with a default in the metadata (``CPP_Default_X``) may be omitted, any other must be given;
- the result is the return value alone; with outputs it is a tuple, return value (``ReturnValue``) first; a single output is a tuple too;
- functions with a custom thunk cannot be called from outside.

Whether an object may be null is told by evidence: what the comment says, the function's name, defaults and metadata.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from .documentation import comment_of
from .names import ScopeNames, python_name, short_entry_name
from .schema import SchemaSet

Entity = Mapping[str, Any]

#: Type nodes that hold one object, or none.
OBJECT_KINDS = frozenset({"object", "weak_object", "lazy_object", "interface", "class"})
NUMBER_KINDS = frozenset({"int8", "int16", "int32", "int64", "uint8", "uint16", "uint32", "uint64", "float", "double"})
INTEGER_KINDS = NUMBER_KINDS - {"float", "double"}
ENUM_KINDS = frozenset({"enum", "byte_enum"})

_NULL_WORDS = re.compile(
    r"\bnull(?:ptr)?\b|\bNone\b|\bif any\b|\bif there is (?:one|any)\b|\bif (?:it )?exists\b|\bif (?:one )?(?:was |is )?found\b|\bnot found\b|"
    r"\bno such\b|\b(?:may|can) be (?:empty|invalid|unset|missing)\b|\bcould not be\b|\bif it fails\b|\bon failure\b",
    re.IGNORECASE,
)
_NULL_NAMES = re.compile(
    r"^(?:K2_)?(?:BP_)?(?:Find|Try|GetOptional)(?:[A-Z_0-9]|$)|(?:IfAny|IfExists|OrNull|IfValid)$|"
    # what is looked up by something, and what need not be there: the owner of an object, what it is attached to
    r"^(?:K2_)?(?:BP_)?Get\w*By[A-Z]|^(?:K2_)?(?:BP_)?Get\w*(?:Owner|Instigator|Parent|Parent(?:Actor|Component)|Child(?:Actor|Component))$|"
    r"^(?:K2_)?Get(?:Controller|Pawn)$"
)


@dataclass(frozen=True)
class Parameter:
    """An input, in the order in which positional arguments fill them."""

    name: str
    python_name: str
    type: Entity  # a type node of the schema
    array_dim: int
    #: May be omitted.
    optional: bool
    #: The default as the metadata has it (normalised text); None if there is none. An empty text means a default-constructed value.
    default_text: str | None
    #: The default as it stands in the C++ header, if that is known.
    default_source: str | None
    #: The default as an expression of Python / of C++ with the SDK's types; None if there is none or its text says nothing.
    default_python: str | None
    default_cpp: str | None
    #: The null object is welcome.
    nullable: bool
    #: Only by keyword: the world context.
    keyword_only: bool
    #: Also an output (UPARAM(ref)).
    is_reference: bool
    entity: Entity


@dataclass(frozen=True)
class Output:
    """The return value (``ReturnValue``) or an out-parameter."""

    name: str
    python_name: str
    type: Entity
    array_dim: int
    nullable: bool
    is_return: bool
    entity: Entity


@dataclass(frozen=True)
class Signature:
    name: str
    inputs: tuple[Parameter, ...]
    outputs: tuple[Output, ...]
    #: "none", "single" (the return value alone) or "tuple" (every other case).
    returns: str
    static: bool
    latent: bool
    #: Also among the inputs, as the last one.
    world_context: Parameter | None
    #: False: calling it raises NotCallable (custom thunk).
    callable: bool
    deprecated: str
    #: Results that raise NullObject when they are null: "Function" (the only result), "Function.ReturnValue" or "Function.Parameter" (one of
    #: several), each with "[]" behind it where it is an array or set of objects, none of which is null.
    never_null: tuple[str, ...]


def is_output(parameter: Entity) -> bool:
    return "OutParm" in parameter["flags"] and "ConstParm" not in parameter["flags"]


def is_pure_output(parameter: Entity) -> bool:
    return is_output(parameter) and "ReferenceParm" not in parameter["flags"]


def meta_of(entity: Entity) -> Mapping[str, str]:
    """The metadata; empty where the tier is absent."""
    found: Mapping[str, str] = entity.get("editor", {}).get("meta", {})
    return found


def meta_value(entity: Entity, key: str) -> str | None:
    """A metadata value; keys compare without case."""
    meta = meta_of(entity)
    if key in meta:
        return meta[key]
    lowered = key.lower()
    return next((value for name, value in meta.items() if name.lower() == lowered), None)


def deprecated_text(entity: Entity) -> str:
    """Why something should not be used any more; "" if it may."""
    meta = meta_of(entity)
    text = entity.get("source", {}).get("deprecated") or meta.get("DeprecationMessage") or ""
    written = re.fullmatch(r'\s*([\w.]+)\s*,\s*(?:TEXT\s*\(\s*)?"((?:[^"\\]|\\.)*)"\s*\)?\s*', text)  # UE_DEPRECATED(5.2, "Call F().")
    if written:
        text = f"{written[2]} (since {written[1]})"
    if not text and ("DeprecatedFunction" in meta or "DeprecatedProperty" in meta or "DeprecatedNode" in meta):
        text = "deprecated"
    return str(text)


def signature(function: Entity, schemas: SchemaSet) -> Signature:
    """The signature of a function or delegate."""
    parameters = function["parameters"]
    is_static = "Static" in function["flags"]
    declared_context = (meta_value(function, "WorldContext") or "").lower()
    context: Entity | None = None
    latent = False
    listed: list[Entity] = []
    for parameter in parameters:
        name = parameter["name"].lower()
        if parameter["type"]["kind"] == "struct" and parameter["type"]["name"] == "FLatentActionInfo":
            latent = True
        elif context is None and parameter["type"]["kind"] == "object" and (
            name == declared_context or (not declared_context and is_static and name == "worldcontextobject")
        ):
            context = parameter
        elif not is_pure_output(parameter):
            listed.append(parameter)
    python = ScopeNames([p["name"] for p in listed] + ([context["name"]] if context else []), "parameter")
    inputs = [_input(p, function, schemas, python[p["name"]], False) for p in listed]
    world_context = _input(context, function, schemas, python[context["name"]], True) if context else None
    if world_context:
        inputs.append(world_context)

    out_parameters = [p for p in parameters if is_output(p)]
    returned = function["returns"]
    names = ScopeNames(["ReturnValue"] * bool(returned) + [p["name"] for p in out_parameters], "result")
    says_null = _says_null(function)
    outputs: list[Output] = []
    if returned:
        outputs.append(Output("ReturnValue", names["ReturnValue"], returned["type"], returned.get("array_dim", 1), says_null, True, returned))
    # An out-parameter is left alone when there is nothing to give: an object there may be null. Lists are empty then.
    for parameter in out_parameters:
        nullable = says_null or parameter["type"]["kind"] not in ("array", "set")
        outputs.append(Output(parameter["name"], names[parameter["name"]], parameter["type"], parameter["array_dim"], nullable, False, parameter))
    returns = "none" if not outputs else "single" if len(outputs) == 1 and returned else "tuple"
    return Signature(
        function["name"], tuple(inputs), tuple(outputs), returns, is_static, latent, world_context,
        meta_value(function, "CustomThunk") is None and not function.get("source", {}).get("custom_thunk", False), deprecated_text(function),
        _never_null(function["name"], returns, outputs),
    )


def _never_null(function: str, returns: str, outputs: list[Output]) -> tuple[str, ...]:
    found = []
    for output in outputs:
        name = function if returns == "single" else f"{function}.{output.name}"
        if output.nullable or output.array_dim > 1:
            continue
        if output.type["kind"] in OBJECT_KINDS:
            found.append(name)
        elif output.type["kind"] in ("array", "set") and output.type["inner"]["kind"] in OBJECT_KINDS:
            found.append(name + "[]")
    return tuple(found)


def _says_null(function: Entity) -> bool:
    if _NULL_NAMES.search(function["name"]):
        return True
    # A comment's words on parameters say nothing of the result.
    text = re.sub(r"[@\\]param\b[^@\\]*", " ", comment_of(function))
    return bool(_NULL_WORDS.search(text))


def _input(parameter: Entity, function: Entity, schemas: SchemaSet, name: str, keyword_only: bool) -> Parameter:
    node = parameter["type"]
    text = meta_value(function, "CPP_Default_" + parameter["name"])
    if text is None:
        text = parameter.get("editor", {}).get("default")
    nullable = node["kind"] in OBJECT_KINDS | {"soft_object", "soft_class"} and (text in ("None", "") or _may_be_null(parameter))
    return Parameter(
        parameter["name"], name, node, parameter["array_dim"], keyword_only or text is not None, text, parameter.get("source", {}).get("default"),
        None if text is None else python_default(text, node, schemas), None if text is None else cpp_default(text, node, schemas),
        nullable, keyword_only, is_output(parameter), parameter,
    )


def _may_be_null(parameter: Entity) -> bool:
    meta = {key.lower() for key in meta_of(parameter)}
    return bool(meta & {"allownull", "optional", "nullable"})


# Defaults --------------------------------------------------------------------------------------------------------------------


def python_default(text: str, node: Entity, schemas: SchemaSet) -> str | None:
    """A default of the metadata (SCHEMA.md section 8) as an expression of Python."""
    kind = node["kind"]
    if kind == "bool":
        return "True" if text.lower() == "true" else "False"
    if kind in INTEGER_KINDS:
        return text if re.fullmatch(r"-?\d+", text) else None
    if kind in ("float", "double"):
        return _number(text)
    if kind in ("string", "name"):
        return _quoted(text)
    if kind == "text":
        match = re.fullmatch(r'INVTEXT\("((?:[^"\\]|\\.)*)"\)', text)
        return _quoted(match[1] if match else text)
    if kind in OBJECT_KINDS or kind in ("soft_object", "soft_class", "optional"):
        return "None" if text in ("None", "", "()") else None
    if kind in ENUM_KINDS:
        entry = _entry(text, node, schemas)
        return None if entry is None else f"{node['name']}.{python_name(entry, 'entry')}"
    if kind == "struct":
        values = _struct_values(text, node, schemas)
        if values is None:
            return None
        arguments = ", ".join(f"{python_name(field, 'field')}={value}" for field, value in values)
        return f"{node['name']}({arguments})"
    if kind in ("array", "set") and text in ("", "()"):
        return "[]"
    if kind == "map" and text in ("", "()"):
        return "{}"
    return None


def cpp_default(text: str, node: Entity, schemas: SchemaSet) -> str | None:
    """The same as an expression of C++ with the SDK's types."""
    kind = node["kind"]
    if kind == "bool":
        return "true" if text.lower() == "true" else "false"
    if kind in INTEGER_KINDS:
        if text == "-9223372036854775808":
            return "(-9223372036854775807 - 1)"
        if not re.fullmatch(r"-?\d+", text):
            return None
        return text + "u" * (kind in ("uint32", "uint64") and int(text) > 2**31 - 1)
    if kind in ("float", "double"):
        number = _number(text)
        return None if number is None or "float" in number else number + ("f" if kind == "float" else "")
    if kind in ("string", "utf8_string", "ansi_string", "name", "text"):
        match = re.fullmatch(r'INVTEXT\("((?:[^"\\]|\\.)*)"\)', text) if kind == "text" else None
        return _quoted(match[1] if match else text, '"')
    if kind in OBJECT_KINDS or kind in ("soft_object", "soft_class", "optional", "array", "set", "map"):
        return "{}" if text in ("None", "", "()") else None
    if kind in ENUM_KINDS:
        entry = _entry(text, node, schemas)
        return None if entry is None else f"{node['name']}::{entry}"
    if kind == "struct":
        values = _struct_values(text, node, schemas)
        if values is None:
            return None
        designated = ", ".join(f".{field} = {value}" for field, value in values)
        return f"{node['name']}{{{designated}}}"
    return None


def _number(text: str) -> str | None:
    try:
        value = float(text)
    except ValueError:
        return None
    return repr(value) if abs(value) != float("inf") and value == value else f'float("{value}")'


def _quoted(text: str, mark: str = "") -> str:
    if mark:
        escapes = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\r": "\\r", "\t": "\\t"}
        return '"' + "".join(escapes.get(c, c) for c in text) + '"'
    return repr(text) if '"' in text else '"' + repr("'" + text)[2:-1] + '"'


def _entry(text: str, node: Entity, schemas: SchemaSet) -> str | None:
    """The short name of the entry that a default names, as the enum spells it."""
    enum = schemas.enums.get(node["name"])
    wanted = short_entry_name(text)
    if enum is None:
        return None
    names: list[str] = [short_entry_name(entry["name"]) for entry in enum["entries"]]
    return next((name for name in names if name == wanted), next((name for name in names if name.lower() == wanted.lower()), None))


#: The fields of UE's core structs, for runs in which their schema is not.
_CORE_FIELDS: Mapping[str, tuple[str, ...]] = {
    "FVector": ("X", "Y", "Z"), "FVector2D": ("X", "Y"), "FVector4": ("X", "Y", "Z", "W"), "FRotator": ("Pitch", "Yaw", "Roll"),
    "FQuat": ("X", "Y", "Z", "W"), "FLinearColor": ("R", "G", "B", "A"), "FColor": ("B", "G", "R", "A"),
}


def _struct_values(text: str, node: Entity, schemas: SchemaSet) -> list[tuple[str, str]] | None:
    """Field and value of a struct's default where all are numbers; an empty list for a default-constructed one."""
    text = text.strip()
    if text in ("", "()"):
        return []
    struct = schemas.structs.get(node["name"])
    fields = tuple(p["name"] for p in struct["properties"]) if struct else _CORE_FIELDS.get(node["name"], ())
    integers = node["name"] == "FColor" or bool(struct and all(p["type"]["kind"] in INTEGER_KINDS for p in struct["properties"]))
    if text.startswith("(") and text.endswith(")"):
        pairs = [part.partition("=") for part in text[1:-1].split(",")]
        values = [(name.strip(), value.strip()) for name, _, value in pairs]
    else:
        parts = [part.strip() for part in text.split(",")]
        if len(parts) != len(fields):
            return None
        values = list(zip(fields, parts))
    result = []
    for name, value in values:
        number = _number(value)
        if number is None or "float" in number or name not in fields:
            return None
        result.append((name, str(int(float(number))) if integers else number))
    order = {field: index for index, field in enumerate(fields)}
    return sorted(result, key=lambda pair: order[pair[0]])
