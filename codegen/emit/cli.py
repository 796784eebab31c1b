# SPDX-License-Identifier: MIT
"""The command line of the emitters: ``python codegen/emit --help``."""

from __future__ import annotations

import argparse
import sys
from importlib import import_module
from pathlib import Path
from typing import Any

from .output import Output
from .schema import SchemaError, SchemaSet

#: Command -> the module that holds its ``emit()``, imported only when it is asked for.
EMITTERS = {"stubs": "python_stubs", "cpp": "cpp_proxies", "docs": "reference"}


def emit(command: str, schemas: SchemaSet, output_dir: Path, **options: Any) -> Output:
    """Runs one emitter of :data:`EMITTERS` on a set of schemas."""
    result: Output = import_module(f".{EMITTERS[command]}", __package__).emit(schemas, output_dir, **options)
    return result


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="codegen/emit", description="Writes things made from reflection schemas (codegen/SCHEMA.md).", formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="examples:\n  python codegen/emit stubs Engine.schema.json Game.schema.json --output-dir stubs\n"
               "  python codegen/emit docs schema.json --output-dir site --title \"My game\"\n\nExit codes: 0 written, 1 a schema or a file was not as it must be, 2 wrong usage.")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")

    command = commands.add_parser("registration", help="*.generated.h and registration code that the embedded engine compiles")
    command.add_argument("schema", type=Path, help="schema of one module, from `spear-header-tool dump`")
    command.add_argument("--import", dest="imports", action="append", default=[], type=Path, metavar="SCHEMA", help="schema of a module it uses (repeatable)")
    command.add_argument("--output-dir", type=Path, required=True, help="gets include/*.generated.h and *.gen.cpp; files that stay the same are not touched")

    for name, text in (("stubs", "typed Python stubs (spear/unreal/MODULE/...)"), ("cpp", "typed C++ proxies (spear/unreal/MODULE/TYPE.hpp)"), ("docs", "the API reference, a static site")):
        command = commands.add_parser(name, help=text)
        command.add_argument("schemas", type=Path, nargs="+", metavar="SCHEMA", help="schemas that together say everything that is known")
        command.add_argument("--output-dir", type=Path, required=True, metavar="DIR", help="files that stay the same are not touched, files no longer made are removed")
        command.add_argument("--jobs", type=int, default=0, metavar="N", help="processes (default: one per core)")
        if name == "docs":
            command.add_argument("--title", default="", help="title of the site")
    return parser


def main(arguments: list[str] | None = None) -> int:
    """Parses the command line and writes. Gives the exit code."""
    options = _parser().parse_args(arguments)
    try:
        if options.command == "registration":
            registration = import_module(".registration", __package__)
            written = registration.emit(SchemaSet.load(options.schema, options.imports), options.output_dir)
        else:
            extra = {"title": options.title} if options.command == "docs" and options.title else {}
            written = emit(options.command, SchemaSet.load_all(options.schemas), options.output_dir, progress=True, jobs=options.jobs, **extra)
    except (SchemaError, OSError) as error:
        print(f"codegen/emit: {error}", file=sys.stderr)
        return 1
    print(f"{written.changed} of {written.total} files changed", file=sys.stderr)
    return 0
