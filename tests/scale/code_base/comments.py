# SPDX-License-Identifier: MIT
"""Doc comments in the ways people write them."""

from __future__ import annotations

import random
import re

from .model import Style
from .vocabulary import ITEMS, SENTENCES, UNITS


def words_of(name: str) -> str:
    """``bMaxWaterSpeed`` -> ``max water speed``."""
    plain = name[1:] if re.match(r"b[A-Z]", name) else name
    return " ".join(re.findall(r"[A-Z]?[a-z0-9_]+|[A-Z]+(?![a-z])", plain)).lower() or name


def unit_of(name: str) -> tuple[str, str, str] | None:
    """(word, unit, how a comment says it), if the name is of something that has one."""
    return next((unit for unit in UNITS if name.endswith(unit[0])), None)


def property_comment(r: random.Random, name: str) -> list[str]:
    """Lines without marks; empty: no comment."""
    chance = r.random()
    if chance < 0.3:
        return []
    unit = unit_of(name)
    first = f"{r.choice(['The', 'How much', 'Current', 'Desired', 'Configured'])} {words_of(name)}" + (f" {unit[2]}" if unit else "")
    if chance < 0.75:
        return [first + r.choice([".", ""])]
    return [first + ".", *[r.choice(SENTENCES) + "." for _ in range(r.randint(1, 2))]]


def function_comment(r: random.Random, name: str, parameters: list[str], returns: bool) -> list[str]:
    """Lines without marks, with @param and @return in some."""
    chance = r.random()
    if chance < 0.22:
        return []
    lines = [f"{words_of(name).capitalize()} {r.choice(['of this instance', 'for the given target', 'now', 'in the next frame', 'if there is one'])}."]
    if chance < 0.5:
        return lines
    if r.random() < 0.4:
        lines += [r.choice(SENTENCES) + ".", *(["", *(f"- {r.choice(ITEMS)}" for _ in range(2)), ""] if r.random() < 0.15 else [])]
    mark = r.choice(["@", "@", "\\"])
    for parameter in parameters:
        unit = unit_of(parameter)
        if r.random() < 0.85:
            lines.append(f"{mark}param {parameter} {r.choice(['The', 'Optional', 'New'])} {words_of(parameter)}" + (f", {unit[2]}" if unit else "") + r.choice([".", ""]))
    if returns:
        lines.append(f"{mark}return{r.choice(['', 's'])} {r.choice(['True if it worked', 'The result', 'Null if nothing was found', 'The value after the change, in cm', 'A copy'])}.")
    if r.random() < 0.08:
        lines.append(f"{mark}note {r.choice(SENTENCES)}.")
    return lines


def written(lines: list[str], style: Style, indent: str) -> list[str]:
    """The comment as source text."""
    if not lines:
        return []
    if style.comment == "line":
        return [f"{indent}// {line}".rstrip() for line in lines]
    if len(lines) == 1:
        return [f"{indent}/** {lines[0]} */"]
    if style.comment == "star_less":
        return [f"{indent}/**", *(f"{indent}   {line}".rstrip() for line in lines), f"{indent}*/"]
    return [f"{indent}/**", *(f"{indent} * {line}".rstrip() for line in lines), f"{indent} */"]
