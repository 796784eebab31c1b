# SPDX-License-Identifier: MIT
"""``spear schema``: reflection schemas from headers and from running engines."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import click


@click.group()
def schema() -> None:
    """Reflection schemas: read them from C++ headers or a running engine, check and count them."""


@schema.command(context_settings={"ignore_unknown_options": True, "help_option_names": []})
@click.argument("arguments", nargs=-1, type=click.UNPROCESSED)
def dump(arguments: tuple[str, ...]) -> None:
    """Read Unreal C++ headers, offline, and write schema.json (all options: `spear schema dump --help`)."""
    from spear.programs import find_program

    sys.exit(subprocess.run([str(find_program("spear-header-tool")), "dump", *arguments], check=False).returncode)


@schema.command()
@click.argument("address", default="")
@click.option("-m", "--module", "modules", multiple=True, help="Only this module (repeatable).")
@click.option("-o", "--output", type=click.Path(dir_okay=False, path_type=Path), help="File to write. [default: standard output]")
def live(address: str, modules: tuple[str, ...], output: Path | None) -> None:
    """Read the reflection of the running engine at ADDRESS (the only one that runs, if it is left out)."""
    import spear

    with spear.connect(address) as instance:
        text = json.dumps(instance.get_schema(modules), indent=1, sort_keys=True, ensure_ascii=False) + "\n"
    if output is None:
        click.echo(text, nl=False)
    else:
        temporary = output.with_name(output.name + ".new")
        temporary.write_text(text, encoding="utf-8")
        temporary.replace(output)  # never a half-written file


@schema.command()
@click.argument("file", type=click.Path(exists=True, dir_okay=False, path_type=Path))
def check(file: Path) -> None:
    """Check that FILE is a schema (against the JSON Schema)."""
    import jsonschema  # type: ignore[import-untyped]

    from spear.programs import source_directory

    root = source_directory()
    if root is None:
        raise FileNotFoundError("The JSON Schema lies in the source tree (codegen/schema.schema.json). Run it there: tools/spear schema check")
    rules = json.loads((root / "codegen" / "schema.schema.json").read_text(encoding="utf-8"))
    errors = sorted(jsonschema.Draft202012Validator(rules).iter_errors(_read(file)), key=lambda e: list(map(str, e.absolute_path)))
    for error in errors[:20]:
        click.echo(f"{file}: /{'/'.join(map(str, error.absolute_path))}: {error.message}", err=True)
    if errors:
        click.echo(f"{file}: {len(errors)} errors", err=True)
        sys.exit(1)
    click.echo(f"{file}: a good schema")


@schema.command()
@click.argument("file", type=click.Path(exists=True, dir_okay=False, path_type=Path))
@click.option("--json", "as_json", is_flag=True, help="For programs.")
def stats(file: Path, as_json: bool) -> None:
    """Count what is in FILE, per module."""
    document = _read(file)
    names = ("classes", "structs", "enums", "delegates", "functions", "properties")
    rows: dict[str, dict[str, int]] = {}
    for kind in ("classes", "structs", "enums", "delegates"):
        for entity in document.get(kind, []):
            row = rows.setdefault(entity["module"], dict.fromkeys(names, 0))
            row[kind] += 1
            row["functions"] += len(entity.get("functions", []))
            row["properties"] += len(entity.get("properties", []))
    rows["total"] = {name: sum(row[name] for row in rows.values()) for name in names}
    if as_json:
        click.echo(json.dumps(rows, indent=2))
        return
    width = max(map(len, rows))
    click.echo(" " * width + "".join(f"{name:>12}" for name in names))
    for module, row in rows.items():
        click.echo(f"{module:<{width}}" + "".join(f"{row[name]:>12}" for name in names))


def _read(file: Path) -> dict[str, Any]:
    try:
        document = json.loads(file.read_text(encoding="utf-8"))
    except (ValueError, UnicodeDecodeError) as error:
        raise click.ClickException(f"{file} is no JSON: {error}") from None
    if not isinstance(document, dict) or document.get("format") != "spear-schema":
        raise click.ClickException(f"{file} is JSON, but no SPEAR schema (its \"format\" is not \"spear-schema\")")
    if document.get("version") != 1:
        raise click.ClickException(f"{file} has schema version {document.get('version')}; this program reads version 1")
    return document
