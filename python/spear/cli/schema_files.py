# SPDX-License-Identifier: MIT
"""Schema files as the command line reads and writes them: every trouble is one clear sentence, no output is ever half written."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any

import click

#: A schema is read from standard input where a file is called so.
STANDARD_INPUT = Path("-")


class Trouble(click.ClickException):
    """An error whose exit code is 2, for commands where 1 has a meaning of its own (`spear schema diff`)."""

    exit_code = 2

    def show(self, file: IO[Any] | None = None) -> None:
        """Prints the error as the program's other errors."""
        click.echo(f"spear: {self.format_message()}", file=file, err=file is None)


class Failure(click.ClickException):
    """An error with exit code 1."""

    def show(self, file: IO[Any] | None = None) -> None:
        """Prints the error as the program's other errors."""
        click.echo(f"spear: {self.format_message()}", file=file, err=file is None)


#: A schema file; whether it can be read is said by :func:`read`, in the same words for all commands.
SCHEMA_FILE = click.Path(path_type=Path)


def read(file: Path) -> dict[str, Any]:
    """The schema in a file (``-``: standard input). Raises Failure with the file's name and what is wrong with it."""
    from spear.codegen.schema import SchemaError, load_schema

    if file == STANDARD_INPUT:
        return _read_standard_input()
    if file.is_dir():
        raise Failure(f"{file} is a folder; a schema is a file, e.g. from `spear schema dump -o schema.json`")
    try:
        return load_schema(file)
    except FileNotFoundError:
        raise Failure(f"{file} does not exist") from None
    except OSError as error:
        raise Failure(f"{file} cannot be read: {error.strerror}") from None
    except SchemaError as error:
        raise Failure(str(error)) from None


def _read_standard_input() -> dict[str, Any]:
    import tempfile

    from spear.codegen.schema import SchemaError, load_schema

    with tempfile.TemporaryDirectory(prefix="spear-") as folder:
        copy = Path(folder) / "standard-input"
        copy.write_bytes(sys.stdin.buffer.read())
        try:
            return load_schema(copy)
        except SchemaError as error:
            raise Failure(str(error).replace(str(copy), "standard input")) from None


def read_all(files: Sequence[Path]) -> list[dict[str, Any]]:
    """Several schemas, with a progress bar for large ones. The first that cannot be read ends it."""
    if list(files).count(STANDARD_INPUT) > 1:
        raise Failure("standard input ('-') can be read only once")
    return [read(file) for file in progress(files, "reading", large(files))]


def large(files: Iterable[Path]) -> bool:
    """Whether it takes seconds to read these files."""
    return sum(file.stat().st_size for file in files if file.is_file()) > 20_000_000


def progress(items: Sequence[Any], title: str, show: bool = True) -> Iterator[Any]:
    """The items, with a progress bar if standard error is a terminal."""
    if not show or not sys.stderr.isatty() or len(items) < 2:
        yield from items
        return
    from tqdm import tqdm  # type: ignore[import-untyped]

    yield from tqdm(items, desc=title, unit="", leave=False, dynamic_ncols=True)


def text_of(document: Any) -> str:
    """A schema as the file that the header tool writes."""
    return json.dumps(document, indent=2, sort_keys=True, ensure_ascii=False) + "\n"


def write(text: str, output: Path | None) -> None:
    """Writes to a file as a whole or not at all; to standard output if there is none."""
    if output is None or output == STANDARD_INPUT:
        click.echo(text, nl=False)
        return
    with writing(output):
        temporary = output.with_name(f"{output.name}.{os.getpid()}.new")
        try:
            temporary.write_text(text, encoding="utf-8")
            temporary.replace(output)
        except BaseException:
            temporary.unlink(missing_ok=True)
            raise


@contextmanager
def writing(target: Path) -> Iterator[None]:
    """Says in one sentence why something could not be written."""
    try:
        yield
    except OSError as error:
        where = error.filename or target
        raise Failure(f"cannot write {target}: {error.strerror or error}" + (f" ({where})" if str(where) != str(target) else "")) from None
