# SPDX-License-Identifier: MIT
"""``spear schema``: reflection schemas from headers and from running engines, and what is made from them."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import click

from spear.cli.completion import complete_address
from spear.cli.schema_diff import diff
from spear.cli.schema_emit import cpp, docs, stubs
from spear.cli.schema_files import SCHEMA_FILE, Failure, read, text_of, write
from spear.cli.schema_merge import merge


@click.group()
def schema() -> None:
    """Reflection schemas: read them from C++ headers or a running engine, compare and merge them, make stubs, proxies and a reference.

    \b
    Examples:
      spear schema dump --project MyGame/MyGame.uproject -o schema.json   from headers, offline
      spear schema live -o live.json                                      from a running engine
      spear schema stubs engine.json schema.json                          typed Python into this environment
      spear schema diff old.json new.json                                 what an upgrade breaks
    """


class _DumpCommand(click.Command):
    """Options and help are the header tool's own."""

    def get_help(self, ctx: click.Context) -> str:
        from spear.programs import find_program

        run = subprocess.run([str(find_program("spear-header-tool")), "dump", "--help"], capture_output=True, text=True, check=False)
        if run.returncode != 0:
            raise Failure(f"spear-header-tool dump --help failed: {run.stderr.strip()}")
        return run.stdout.replace("spear-header-tool dump", "spear schema dump").rstrip()


@schema.command(cls=_DumpCommand, context_settings={"ignore_unknown_options": True, "allow_interspersed_args": False}, options_metavar="[OPTIONS]")
@click.argument("arguments", nargs=-1, type=click.UNPROCESSED, metavar="")
@click.pass_context
def dump(context: click.Context, arguments: tuple[str, ...]) -> None:
    """Read Unreal C++ headers, offline, and write schema.json."""
    from spear.programs import find_program

    if not arguments:
        click.echo(context.get_help())
        context.exit(2)
    if "--help" in arguments or "-h" in arguments:
        click.echo(context.get_help())
        return
    code = subprocess.run([str(find_program("spear-header-tool")), "dump", *arguments], check=False).returncode
    sys.exit(code if code >= 0 else 128 - code)  # as a shell says that a signal ended it


@schema.command()
@click.argument("address", default="", shell_complete=complete_address)
@click.option("-m", "--module", "modules", multiple=True, help="Only this module (repeatable).")
@click.option("-o", "--output", type=click.Path(path_type=Path), help="File to write. [default: standard output]")
def live(address: str, modules: tuple[str, ...], output: Path | None) -> None:
    """Read the reflection of the running engine at ADDRESS (the only one that runs, if it is left out).

    \b
    Examples:
      spear schema live -o live.json
      spear schema live tcp:127.0.0.1:30000 -m Engine | less
    """
    import spear

    if output is not None and output.is_dir():
        raise Failure(f"{output} is a folder; -o wants the name of a file")
    with spear.connect(address) as instance:
        document = instance.get_schema(modules)
    write(text_of(document), output)


@schema.command()
@click.argument("files", nargs=-1, required=True, type=SCHEMA_FILE, metavar="FILE...")
@click.option("--rules", is_flag=True, help="Print the JSON Schema itself and end.", is_eager=True, expose_value=False,
              callback=lambda context, parameter, value: _print_rules(context) if value else None)
@click.option("-j", "--jobs", default=0, help="Processes. [default: one per core]")
def check(files: tuple[Path, ...], jobs: int) -> None:
    """Check that each FILE is a schema, down to the last key (against the JSON Schema). Exit code 1 if one is not.

    \b
    Examples:
      spear schema check schema.json
      spear schema live | spear schema check -
    """
    bad = False
    for file in files:
        try:
            errors = _errors(read(file), jobs)
        except Failure as failure:
            failure.show()
            bad = True
            continue
        for line in errors[:20]:
            click.echo(f"{file}: {line}", err=True)
        if errors:
            click.echo(f"{file}: {len(errors)} errors" + (", the first 20 are shown" if len(errors) > 20 else ""), err=True)
            bad = True
        else:
            click.echo(f"{file}: a good schema")
    if bad:
        sys.exit(1)


def _rules() -> dict[str, Any]:
    from spear import codegen

    path = Path(codegen.__file__).parent / "schema.schema.json"
    try:
        rules: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise Failure(f"the JSON Schema is missing from this installation: {path}: {error.strerror}") from None
    return rules


def _print_rules(context: click.Context) -> None:
    click.echo(json.dumps(_rules(), indent=2))
    context.exit()


def _errors(document: dict[str, Any], jobs: int) -> list[str]:
    """What is wrong with a schema: "/path/of/keys: message". Its lists are checked in pieces, on all cores."""
    import jsonschema  # type: ignore[import-untyped]

    from spear.codegen.parallel import for_each

    rules = _rules()
    kinds = ("modules", "classes", "structs", "enums", "delegates")
    frame = {key: value for key, value in document.items() if key not in kinds}
    size = 100
    pieces = [(None, 0), *((kind, start) for kind in kinds for start in range(0, len(document[kind]), size))]

    def validate(piece: tuple[str | None, int]) -> list[tuple[list[Any], str]]:
        kind, start = piece
        part = {**frame, **{k: document[k][start : start + size] if k == kind else [] for k in kinds}}
        found = []
        for error in jsonschema.Draft202012Validator(rules).iter_errors(part):
            where = list(error.absolute_path)
            if (where[:1] == [kind] and len(where) > 1) or kind is None:
                found.append(([kind, where[1] + start, *where[2:]] if kind else where, _message(error)))
        return found

    errors = [error for part in for_each(pieces, validate, jobs=jobs if len(pieces) > 4 else 1, progress=True, title="checking") for error in part]
    return [f"/{'/'.join(map(str, where))}: {message}" for where, message in sorted(errors, key=lambda e: [(str(type(k)), k) for k in e[0]])]


def _message(error: Any) -> str:
    """The message of a validation error; inside "one of these" the one that fits best says more."""
    from jsonschema.exceptions import best_match  # type: ignore[import-untyped]

    inner = best_match(error.context) if error.context else None
    text = f"{inner.message}" if inner is not None else error.message
    return text if len(text) <= 300 else text[:297] + "..."


@schema.command()
@click.argument("files", nargs=-1, required=True, type=SCHEMA_FILE, metavar="FILE...")
@click.option("--json", "as_json", is_flag=True, help="For programs.")
def stats(files: tuple[Path, ...], as_json: bool) -> None:
    """Count what is in FILES, per module. A module that is in several files counts once, as it is in the last.

    \b
    Examples:
      spear schema stats engine.json game.json
      spear schema stats schema.json --json
    """
    rows: dict[str, dict[str, int]] = {}
    bad = False
    for file in files:
        try:
            document = read(file)
        except Failure as failure:  # the others are counted all the same
            failure.show()
            bad = True
            continue
        rows.update(_counts(document))
    rows = {name: rows[name] for name in sorted(rows)}
    names = list(_COUNTED)
    total = {name: sum(row[name] for row in rows.values()) for name in names}
    if as_json:
        click.echo(json.dumps({**rows, "total": total}, indent=2))
    elif rows:
        width = max(len(name) for name in [*rows, "total"])
        click.echo(" " * width + "".join(f"{name:>12}" for name in names))
        for module, row in [*rows.items(), ("total", total)]:
            click.echo(f"{module:<{width}}" + "".join(f"{row[name]:>12,}" for name in names))
    if bad:
        sys.exit(1)


_COUNTED = ("headers", "classes", "structs", "enums", "delegates", "functions", "parameters", "properties", "entries")


def _counts(document: dict[str, Any]) -> dict[str, dict[str, int]]:
    rows = {module["name"]: {**dict.fromkeys(_COUNTED, 0), "headers": len(module.get("source", {}).get("headers", []))} for module in document["modules"]}
    for kind in ("classes", "structs", "enums", "delegates"):
        for entity in document[kind]:
            row = rows.setdefault(entity["module"], dict.fromkeys(_COUNTED, 0))
            row[kind] += 1
            row["entries"] += len(entity.get("entries", []))
            row["properties"] += len(entity.get("properties", []))
            row["functions"] += len(entity.get("functions", []))
            row["parameters"] += sum(len(f["parameters"]) for f in [*entity.get("functions", []), *([entity] if kind == "delegates" else [])])
    return rows


for command in (diff, merge, stubs, cpp, docs):
    schema.add_command(command)
