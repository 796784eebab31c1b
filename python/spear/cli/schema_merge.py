# SPDX-License-Identifier: MIT
"""``spear schema merge``: engine, plugins and project as one; headers' facts over a live dump."""

from __future__ import annotations

import json
from pathlib import Path

import click

from spear.cli.schema_files import SCHEMA_FILE, Failure, read_all, text_of, write


@click.command()
@click.argument("files", nargs=-1, required=True, type=SCHEMA_FILE, metavar="FILE...")
@click.option("-o", "--output", type=click.Path(path_type=Path), help="File to write. [default: standard output]")
@click.option("--strict", is_flag=True, help="Conflicts are errors: nothing is written then, exit code 1.")
@click.option("--report", type=click.Path(path_type=Path), help="Write all conflicts to this file, as JSON.")
@click.option("-q", "--quiet", is_flag=True, help="Do not list conflicts.")
def merge(files: tuple[Path, ...], output: Path | None, strict: bool, report: Path | None, quiet: bool) -> None:
    """Make one schema of several: engine, plugins and project; or the facts of headers (comments, C++ spelling, lines) over a live dump.

    For a type that is in several FILES, a live dump decides what exists and what its runtime tier says; dumps of headers add source. Of two
    files of one kind, the later one decides. What was decided against a file is a conflict, listed on standard error.

    \b
    Examples:
      spear schema merge engine.json plugins.json game.json -o all.json
      spear schema merge live.json schema.json -o merged.json --report conflicts.json
    """
    from spear.codegen import merge as logic

    if output is not None and output.is_dir():
        raise Failure(f"{output} is a folder; -o wants the name of a file")
    documents = read_all(files)
    try:
        merged, conflicts = logic.merge([(str(file), document) for file, document in zip(files, documents, strict=True)])
    except (KeyError, TypeError, AttributeError) as error:
        raise Failure(f"one of the files lacks what a schema must have ({type(error).__name__}: {error}); `spear schema check` says what and where") from None
    if not quiet:
        for conflict in conflicts[:50]:
            click.echo(conflict.text, err=True)
        if len(conflicts) > 50:
            click.echo(f"... and {len(conflicts) - 50} more" + ("" if report else " (--report FILE has all)"), err=True)
    if report is not None:
        write(json.dumps({"format": "spear-schema-merge-report", "version": 1, "conflicts": [c.to_dict() for c in conflicts]}, indent=2, ensure_ascii=False) + "\n", report)
    if strict and conflicts:
        raise Failure(f"{len(conflicts)} conflicts; nothing was written (--strict)")
    write(text_of(merged), output)
    if output is not None and not quiet:
        click.echo(f"{output}: {len(merged['modules'])} modules, {sum(len(merged[k]) for k in ('classes', 'structs', 'enums', 'delegates'))} types, {len(conflicts)} conflicts", err=True)
