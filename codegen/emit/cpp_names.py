# SPDX-License-Identifier: MIT
"""C++ texts that registration code needs: literals, flags, value types, names of generated functions."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

_ESCAPES = {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\r": "\\r", "\t": "\\t", "\0": "\\0"}


def literal(text: str) -> str:
    """A UTF-8 string literal."""
    return '"' + "".join(_ESCAPES.get(c, c) for c in text) + '"'


def flags(prefix: str, names: Iterable[str], cast: str) -> str:
    """``CPF_Edit | CPF_Net`` as an expression of a type."""
    listed = [f"{cast_inner(cast)}({prefix}{name})" for name in names]
    return f"{cast}({' | '.join(listed) or '0'})"


def cast_inner(cast: str) -> str:
    return "uint64" if cast == "uint64" else "uint32"


def meta_pairs(meta: Mapping[str, str]) -> list[str]:
    """Initialisers of FMetaPair."""
    return [f"{{{literal(key)}, {literal(value)}}}" for key, value in sorted(meta.items())]


def value_type(type_text: str) -> str:
    """The type of a variable that holds an argument of a parameter's type: without reference and top-level const."""
    text = type_text.strip()
    if text.endswith("&"):
        text = text.rstrip("&").strip()
    if text.endswith("const"):
        text = text[: -len("const")].strip()
    if not text.endswith("*"):
        text = re.sub(r"^const\b\s*", "", text)
    return text


def qualify(type_text: str, node: Mapping[str, Any]) -> str:
    """The type text as it reads outside of the class: delegates declared in a class get its name."""
    if node.get("owner") and node.get("name"):
        return re.sub(rf"(?<![\w:]){re.escape(node['name'])}\b", f"{node['owner']}::{node['name']}", type_text)
    for part in ("inner", "key", "value"):
        if part in node:
            type_text = qualify(type_text, node[part])
    return type_text


def file_id(module: str, path: str) -> str:
    """CURRENT_FILE_ID of a header."""
    return "FID_" + re.sub(r"\W", "_", f"{module}_{path}")


def api(module: str) -> str:
    """The export macro of a module."""
    return f"{module.upper()}_API"


def struct_function(entity: Mapping[str, Any]) -> str:
    return f"Z_Construct_UScriptStruct_{entity['name']}"


def enum_function(entity: Mapping[str, Any]) -> str:
    return f"Z_Construct_UEnum_{entity['module']}_{entity['name']}"


def delegate_function(entity: Mapping[str, Any]) -> str:
    owner = f"{entity['owner']}_" if entity["owner"] else ""
    return f"Z_Construct_UDelegateFunction_{entity['module']}_{owner}{entity['name']}"
