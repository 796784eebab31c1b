# SPDX-License-Identifier: MIT
"""Makes spear/game_twins.py: ``game.async_`` and ``game.send_``, from the functions of spear/game.py.

    python make_game_twins.py            writes it
    python make_game_twins.py --check    exit code 1 if it is not what game.py says
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from pathlib import Path

FOLDER = Path(__file__).resolve().parent / "spear"

HEAD = '''\
# SPDX-License-Identifier: MIT
# DO NOT EDIT: made from game.py by python/make_game_twins.py
"""``game.async_`` and ``game.send_``: the functions of a world, not waited for."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, TypeVar, overload

from spear._native import Future
from spear.game import _OPTIONS, ClassLike, GameBase, plain
from spear.unreal_object import ObjectBase, UnrealObject, class_argument

if TYPE_CHECKING:
    from spear.game import Rotator, Vector

_T = TypeVar("_T", bound=ObjectBase)
'''


def twin(functions: list[ast.FunctionDef], name: str, documentation: str, asynchronous: bool) -> str:
    """The source of one twin class."""
    parts = [f'\n\nclass {name}(GameBase):\n    """{documentation}"""\n']
    for index, function in enumerate(functions):
        made = ast.FunctionDef(**{field: getattr(function, field, None) for field in function._fields})
        overloaded = bool(function.decorator_list)
        declared_any = isinstance(function.returns, ast.Name) and function.returns.id == "Any"
        assert function.returns is not None, function.name
        if not asynchronous:
            # The results do not differ any more, so one declaration is left of the overloads.
            if overloaded:
                continue
            made.returns = ast.Constant(None)
            made.body = [_without_return(statement) for statement in function.body]
        elif function.name.endswith("_many"):
            made.returns = ast.Subscript(ast.Name("list"), ast.Subscript(ast.Name("Future"), ast.Name("Any")))
        elif not declared_any:
            made.returns = ast.Subscript(ast.Name("Future"), function.returns)
            made.body = [_with_return(statement) for statement in function.body]
        text = ast.unparse(ast.fix_missing_locations(made))
        if not overloaded and asynchronous and not declared_any:
            text = "\n".join(line + "  # type: ignore[no-any-return]" if line.strip().startswith("return self._") else line for line in text.split("\n"))
        if overloaded:
            text = text.replace(":\n    ...", ": ...")
        blank = "" if index and functions[index - 1].decorator_list and asynchronous else "\n"
        parts.append(blank + "".join(_indented(text)))
    return "".join(parts)


def _indented(text: str) -> Iterator[str]:
    """The lines of a function, as a method; those of its documentation are indented already."""
    inside = False
    for line in text.split("\n"):
        yield (line if inside else f"    {line}").rstrip() + "\n"
        inside ^= line.count('"""') == 1


def _without_return(statement: ast.stmt) -> ast.stmt:
    return ast.Expr(statement.value) if isinstance(statement, ast.Return) and statement.value is not None else statement


def _with_return(statement: ast.stmt) -> ast.stmt:
    is_call = isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Call)
    return ast.Return(statement.value) if is_call else statement  # type: ignore[attr-defined]


def source() -> str:
    """The whole file."""
    tree = ast.parse((FOLDER / "game.py").read_text(encoding="utf-8"))
    (game,) = [node for node in tree.body if isinstance(node, ast.ClassDef) and node.name == "Game"]
    functions = [node for node in game.body if isinstance(node, ast.FunctionDef) and not any(isinstance(d, ast.Name) and d.id == "property" for d in node.decorator_list)]
    return HEAD + twin(functions, "AsyncGame", "The functions of a world, each giving a Future at once.", True) + twin(
        functions, "SendGame", "The functions of a world, fire-and-forget.", False)


def main() -> int:
    """Writes, or checks."""
    target = FOLDER / "game_twins.py"
    text = source()
    if "--check" in sys.argv[1:]:
        if not target.exists() or target.read_text(encoding="utf-8") != text:
            print(f"{target} is not what game.py says now: run {Path(__file__).name}", file=sys.stderr)
            return 1
        return 0
    if not target.exists() or target.read_text(encoding="utf-8") != text:
        target.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
