# SPDX-License-Identifier: MIT
"""Writes things made from reflection schemas: ``python codegen/emit --help``."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import registration  # noqa: E402
from schema import SchemaError, SchemaSet  # noqa: E402


def main() -> int:
    parser = argparse.ArgumentParser(prog="codegen/emit", description="Writes things made from reflection schemas (codegen/SCHEMA.md).")
    commands = parser.add_subparsers(dest="command", required=True)
    command = commands.add_parser("registration", help="*.generated.h and registration code that the embedded engine compiles")
    command.add_argument("schema", type=Path, help="schema of one module, from `spear-header-tool dump`")
    command.add_argument("--import", dest="imports", action="append", default=[], type=Path, metavar="SCHEMA", help="schema of a module it uses (repeatable)")
    command.add_argument("--output-dir", type=Path, required=True, help="gets include/*.generated.h and *.gen.cpp; files that stay the same are not touched")
    options = parser.parse_args()
    try:
        schemas = SchemaSet.load(options.schema, options.imports)
        written = registration.emit(schemas, options.output_dir)
    except (SchemaError, OSError) as error:
        print(f"codegen/emit: {error}", file=sys.stderr)
        return 1
    print(f"{written.changed} of {written.total} files changed", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
