# SPDX-License-Identifier: MIT
"""Facts read from the text of a header beside the header tool, for independent_check.py: specifiers, metadata, comments, defaults, enumerator values.

Each function gives (what, the text's statement, the schema's statement); they are the same fact if both are equal. Nothing is shared with the tool.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterator
from typing import Any

Fact = tuple[str, Any, Any]


def one_line(text: str) -> str:
    """White space does not count."""
    return re.sub(r"\s+", "", text)


def specifiers(raw: str, entity: dict[str, Any]) -> Iterator[Fact]:
    """The text between the macro's parentheses, comments taken out."""
    plain = re.sub(r'("(?:\\.|[^"\\])*")|//[^\n]*|/\*.*?\*/', lambda m: m.group(1) or " ", raw, flags=re.S)
    yield "specifiers", one_line(plain), one_line(entity["source"]["specifiers"])


def metadata(raw: str, plain: str, entity: dict[str, Any], split: Callable[[str], list[str]], closing: Callable[[str, int], int]) -> Iterator[Fact]:
    """Every pair in meta=(...)."""
    found: dict[str, tuple[str, str]] = {}
    for match in re.finditer(r"\bmeta\s*=\s*\(", plain, re.I):
        opening = match.end() - 1
        end = closing(plain, opening)
        at = opening + 1
        for part in split(plain[opening + 1 : end]):
            item = raw[at : at + len(part)]
            at += len(part) + 1
            item = re.sub(r'("(?:\\.|[^"\\])*")|//[^\n]*|/\*.*?\*/', lambda m: m.group(1) or " ", item, flags=re.S)
            key, _, value = item.partition("=")
            if key.strip():
                found[key.strip().lower()] = (key.strip(), _value(value.strip()))
    written = {k.lower(): v for k, v in entity["editor"]["meta"].items()}
    for low, (key, value) in found.items():
        yield f"meta {key}", value, written.get(low)


def _value(text: str) -> str:
    strings = re.findall(r'"((?:\\.|[^"\\])*)"', text)
    if strings and re.fullmatch(r'(?:\s*"(?:\\.|[^"\\])*"\s*)+', text):
        escapes = {"n": "\n", "t": "\t", "r": "\r"}
        return re.sub(r"\\(.)", lambda m: escapes.get(m.group(1), m.group(1)), "".join(strings), flags=re.S)
    return text


def comment(raw: str, begin: int, entity: dict[str, Any]) -> Iterator[Fact]:
    """The comment that ends on the line above the macro. Several in a row: the last, for `//` all lines."""
    above = raw[:begin].rstrip(" \t")
    if above.endswith("\n"):
        above = above[:-1].rstrip(" \t")
    elif above:
        return  # something stands before the macro on its line
    if above.endswith("*/"):
        start = above.rfind("/*")
        before = above[:start].rsplit("\n", 1)[-1]
        if before.strip():
            return  # a comment behind something else
        found = above[start:]
        if not found.startswith("/**"):
            return  # Unreal's header tool has its own mind about plain block comments
    else:
        lines: list[str] = []
        for line in reversed(above.split("\n")):
            if not line.strip().startswith("//"):
                break
            lines.insert(0, line.strip())
        if not lines or re.match(r"//[^\w]*$|//.*(~|=====|-----)", lines[0]) or any(line.startswith("//~") for line in lines):
            return
        found = "\n".join(lines)
    stated = entity["source"]["comment"]
    # What the text shows has to be the end of what the schema says: comments above it may belong to it as well.
    yield "comment", one_line(found), one_line(stated)[-len(one_line(found)) :] if stated else stated


def property_default(raw: str, plain: str, begin: int, entity: dict[str, Any]) -> Iterator[Fact]:
    """The initialiser between `=` (or the braces) and the semicolon, if the statement declares one variable."""
    depth = 0
    while plain[begin : begin + 1] in (";", " ", "\t", "\n"):  # UPROPERTY(...); in front of its declaration
        begin += 1
    for end in range(begin, len(plain)):
        c = plain[end]
        depth += c in "([{"
        depth -= c in ")]}"
        if c == ";" and depth == 0:
            break
    else:
        return
    name = re.escape(entity["source"]["cpp_name"])
    match = re.search(rf"\b{name}\b\s*(?:\[[^\]]*\]\s*)*(?::\s*\d+\s*)?(=|\{{)", plain[begin:end], re.S)
    stated = entity["source"].get("default")
    if not match:
        if not re.search(r"[={]", plain[begin:end]):
            yield "default", None, stated
        return
    start = begin + match.start(1) + (1 if match.group(1) == "=" else 0)
    text = re.sub(r'("(?:\\.|[^"\\])*")|//[^\n]*|/\*.*?\*/', lambda m: m.group(1) or " ", raw[start:end], flags=re.S)
    yield "default", one_line(text), one_line(stated or "")


def parameter_defaults(raw: str, plain: str, opening: int, end: int, entity: dict[str, Any], split: Callable[[str], list[str]]) -> Iterator[Fact]:
    """The default of each parameter."""
    at = opening + 1
    parts = split(plain[opening + 1 : end])
    if len(parts) != len(entity["parameters"]):
        return
    for part, parameter in zip(parts, entity["parameters"], strict=True):
        piece, text = plain[at : at + len(part)], raw[at : at + len(part)]
        at += len(part) + 1
        macro = re.match(r"\s*UPARAM\s*\((?:[^()]|\([^()]*\))*\)", piece)
        skip = macro.end() if macro else 0
        equals = piece.find("=", skip)
        stated = parameter["source"].get("default")
        if equals < 0:
            yield f"default of {parameter['name']}", None, stated
        else:
            value = re.sub(r'("(?:\\.|[^"\\])*")|//[^\n]*|/\*.*?\*/', lambda m: m.group(1) or " ", text[equals + 1 :], flags=re.S)
            yield f"default of {parameter['name']}", one_line(value), one_line(stated or "")


def enumerators(raw: str, plain: str, begin: int, entity: dict[str, Any], split: Callable[[str], list[str]], closing: Callable[[str, int], int]) -> Iterator[Fact]:
    """Names and values of all entries, as far as Python can work them out."""
    match = re.compile(r"\benum\b[^;{]*\{", re.S).search(plain, begin)
    if not match or re.search(r"^[ \t]*#[ \t]*(?:if|else|elif)", plain[match.end() : closing(plain, match.end() - 1)], re.M):
        return
    opening = match.end() - 1
    names: dict[str, int | None] = {}
    value: int | None = -1
    body = plain[opening + 1 : closing(plain, opening)].replace("<<", "@@").replace(">>", "$$")  # no brackets of templates
    for part in split(body):
        part = part.replace("@@", "<<").replace("$$", ">>")
        text = re.sub(r"\bU(?:META|E_DEPRECATED)\w*\s*\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\)", " ", part)
        text = re.sub(r"^\s*#[^\n]*$", " ", text, flags=re.M)
        head = re.match(r"\s*(\w+)\s*(?:=(.*))?$", text.strip(), re.S)
        if not head:
            return
        name, expression = head.group(1), head.group(2)
        value = _integer(expression, names) if expression else value + 1 if value is not None else None
        names[name] = value
    stated = {e["name"].rpartition("::")[2]: e["value"] for e in entity["entries"]}
    yield "entries", list(names), list(stated)
    for name, number in names.items():
        if number is not None and name in stated:
            yield f"value of {name}", number, stated[name]


def _integer(expression: str, names: dict[str, int | None]) -> int | None:
    """The value of a plain integer expression; None for any other."""
    text = re.sub(r"\b(?:u?int\d+|uint8)\s*\(", "(", expression)
    text = re.sub(r"\b\w+::", "", text)
    text = re.sub(r"(?<=[0-9a-fA-F])(?:ull|ul|ll|u|l)\b", "", text, flags=re.I).strip()
    text = re.sub(r"\b0+(?=\d)", "0o", text) if re.search(r"\b0\d", text) else text
    try:
        tree = ast.parse(text, mode="eval")
    except SyntaxError:
        return None

    def work_out(node: ast.expr) -> int | None:
        if isinstance(node, ast.Constant) and isinstance(node.value, int):
            return int(node.value)
        if isinstance(node, ast.Name):
            return names.get(node.id)
        if isinstance(node, ast.UnaryOp):
            inner = work_out(node.operand)
            return None if inner is None else -inner if isinstance(node.op, ast.USub) else ~inner if isinstance(node.op, ast.Invert) else None
        if isinstance(node, ast.BinOp):
            left, right = work_out(node.left), work_out(node.right)
            if left is None or right is None:
                return None
            table: dict[type, Callable[[int, int], int]] = {ast.Add: lambda a, b: a + b, ast.Sub: lambda a, b: a - b, ast.Mult: lambda a, b: a * b, ast.LShift: lambda a, b: a << b,
                                                            ast.RShift: lambda a, b: a >> b, ast.BitOr: lambda a, b: a | b, ast.BitAnd: lambda a, b: a & b}
            operation = table.get(type(node.op))
            return operation(left, right) if operation else None
        return None

    return work_out(tree.body)
