# SPDX-License-Identifier: MIT
"""``spear schema diff``: what an upgrade breaks."""

from __future__ import annotations

import json
import sys
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from spear.cli.schema_files import SCHEMA_FILE, Failure, Trouble, read_all

if TYPE_CHECKING:
    from spear.codegen.diff import Change

_COLOURS = {"removed": "red", "changed": "yellow", "added": "green"}
_MARKS = {"removed": "-", "changed": "~", "added": "+"}
_ONLY = ("breaking", "compatible", "removed", "changed", "added")


@click.command()
@click.argument("old", type=SCHEMA_FILE)
@click.argument("new", type=SCHEMA_FILE)
@click.option("--tier", type=click.Choice(["runtime", "editor", "source"]), default="editor", show_default=True,
              help="How deep: what reflection always knows; also defaults and metadata; also comments, C++ spelling and headers.")
@click.option("--only", type=click.Choice(_ONLY), multiple=True, help="Only such changes (repeatable: --only breaking --only changed shows those that are both).")
@click.option("-m", "--module", "modules", multiple=True, help="Only changes in this module (repeatable).")
@click.option("--import", "imports", type=SCHEMA_FILE, multiple=True, help="Schema that both refer to, e.g. the engine's: it tells which class derives from which (repeatable).")
@click.option("--json", "as_json", is_flag=True, help="For programs: one object with counts and all changes.")
def diff(old: Path, new: Path, tier: str, only: tuple[str, ...], modules: tuple[str, ...], imports: tuple[Path, ...], as_json: bool) -> None:
    """Compare two schemas: what is gone, what changed, what is new, and what of it breaks programs written for OLD.

    Breaking: something is gone, or a type, the order, direction or number of parameters, a value, a base class changed. A member that moved
    up to a base class, a new parameter with a default at the end, a parameter that takes more: compatible.

    Either may be '-', the standard input. Exit codes: 0 nothing to show, 1 differences, 2 trouble.

    \b
    Examples:
      spear schema diff engine-5.4.json engine-5.5.json --only breaking
      spear schema live | spear schema diff schema.json - --tier runtime
      spear schema diff old.json new.json --json | jq '.changes[] | select(.kind == "enum")'
    """
    from spear.codegen import diff as logic
    from spear.codegen.schema import SchemaSet

    try:
        left, right, *others = read_all([old, new, *imports])
    except Failure as failure:
        raise Trouble(failure.message) from None
    try:
        changes = logic.diff(SchemaSet.of([left], others), SchemaSet.of([right], others), tier)
    except (KeyError, TypeError, AttributeError) as error:
        raise Trouble(f"{old} or {new} lacks what a schema must have ({type(error).__name__}: {error}); `spear schema check` says what and where") from None
    severities, kinds = {o for o in only if o in _ONLY[:2]}, {o for o in only if o in _ONLY[2:]}
    changes = [c for c in changes if (not severities or c.severity in severities) and (not kinds or c.change in kinds) and (not modules or c.module in modules)]
    if as_json:
        click.echo(json.dumps(_as_json(old, new, tier, changes), indent=2, ensure_ascii=False))
    else:
        _print(old, new, changes)
    sys.exit(1 if changes else 0)


def _counts(changes: list[Change]) -> dict[str, int]:
    found = Counter(c.severity for c in changes) + Counter(c.change for c in changes)
    return {name: found[name] for name in _ONLY}


def _as_json(old: Path, new: Path, tier: str, changes: list[Change]) -> dict[str, Any]:
    return {"format": "spear-schema-diff", "version": 1, "old": str(old), "new": str(new), "tier": tier, "counts": _counts(changes), "changes": [c.to_dict() for c in changes]}


def _print(old: Path, new: Path, changes: list[Change]) -> None:
    for severity, title in (("breaking", "Breaking"), ("compatible", "Compatible")):
        chosen = [c for c in changes if c.severity == severity]
        if not chosen:
            continue
        click.secho(f"{title} ({len(chosen)})", bold=True)
        module = None
        for c in chosen:
            if c.module != module:
                module = c.module
                click.echo(f"  {module}")
            click.secho(f"    {_MARKS[c.change]} ", fg=_COLOURS[c.change], nl=False)
            click.echo(f"{c.kind} ", nl=False)
            click.secho(c.subject, bold=True, nl=False)
            click.echo(f" {c.text}")
    if not changes:
        click.echo(f"{old} and {new}: no difference to show")
        return
    counts = _counts(changes)
    click.echo(f"{counts['breaking']} breaking, {counts['compatible']} compatible: {counts['removed']} removed, {counts['changed']} changed, {counts['added']} added")
