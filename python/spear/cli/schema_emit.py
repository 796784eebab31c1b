# SPDX-License-Identifier: MIT
"""``spear schema stubs``, ``cpp`` and ``docs``: what is made from schemas."""

from __future__ import annotations

import os
import subprocess
import sys
import sysconfig
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from spear.cli.schema_files import SCHEMA_FILE, Failure, read_all, writing

if TYPE_CHECKING:
    from spear.codegen.output import Output

_jobs = click.option("-j", "--jobs", default=0, help="Processes. [default: one per core]")
_schemas = click.argument("files", nargs=-1, required=True, type=SCHEMA_FILE, metavar="SCHEMA...")


@click.command()
@_schemas
@click.option("-o", "--output", type=click.Path(file_okay=False, path_type=Path), help="Folder that gets spear-stubs/. [default: the active environment's site-packages]")
@_jobs
def stubs(files: tuple[Path, ...], output: Path | None, jobs: int) -> None:
    """Write typed Python for everything in the SCHEMAs: the package spear-stubs (PEP 561), found by mypy, pyright, PyCharm without settings.

    Give the schemas of the engine, its plugins and the project together: the package replaces the stubs of the embedded engine.

    \b
    Examples:
      spear schema stubs engine.json game.json            into this environment
      spear schema stubs merged.json -o typings           a folder for MYPYPATH or pyright's stubPath
    """
    folder = output if output is not None else site_packages()
    package = folder / "spear-stubs"
    written = _emit("stubs", files, package / "unreal", jobs)
    with writing(package):
        _package_files(package)
    _said(written, package)


@click.command()
@_schemas
@click.option("-o", "--output", required=True, type=click.Path(file_okay=False, path_type=Path), help="Include folder that gets spear/unreal/MODULE/TYPE.hpp.")
@_jobs
def cpp(files: tuple[Path, ...], output: Path, jobs: int) -> None:
    """Write typed C++ proxies, header-only, over the C++ SDK.

    \b
    Example:
      spear schema cpp engine.json game.json -o include
      #include <spear/unreal/Engine/AActor.hpp>
    """
    _said(_emit("cpp", files, output, jobs), output)


@click.command()
@_schemas
@click.option("-o", "--output", required=True, type=click.Path(file_okay=False, path_type=Path), help="Folder of the site.")
@click.option("--title", default="", help="Title of the site.")
@_jobs
def docs(files: tuple[Path, ...], output: Path, title: str, jobs: int) -> None:
    """Write the API reference: a static site with search that needs no server.

    \b
    Example:
      spear schema docs engine.json game.json -o site --title "My game" && xdg-open site/index.html
    """
    _said(_emit("docs", files, output, jobs, **({"title": title} if title else {})), output)
    click.echo(f"Open {output / 'index.html'}", err=True)


def site_packages() -> Path:
    """Where the active environment has its packages: that of VIRTUAL_ENV or CONDA_PREFIX, else the one this program runs in."""
    for variable in ("VIRTUAL_ENV", "CONDA_PREFIX"):
        prefix = os.environ.get(variable)
        python = Path(prefix) / "bin" / "python" if prefix else None
        if python is None or not python.exists() or Path(str(prefix)).resolve() == Path(sys.prefix).resolve():
            continue
        run = subprocess.run([str(python), "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"], capture_output=True, text=True, check=False)
        if run.returncode == 0 and run.stdout.strip():
            return Path(run.stdout.strip())
        raise Failure(f"{python} of {variable} does not run: {run.stderr.strip()}. Name a folder with -o.")
    found = Path(sysconfig.get_path("purelib"))
    if not os.access(found if found.exists() else found.parent, os.W_OK):
        raise Failure(f"{found} cannot be written. Activate a virtual environment, or name a folder with -o.")
    return found


def _package_files(package: Path) -> None:
    """What makes a folder a stub package for a part of `spear`, and the stubs of the rest of `spear`: pyright looks for them here alone."""
    import spear
    from spear.codegen.output import Output

    own = Path(spear.__file__).parent
    output = Output(package)
    output.write("py.typed", "partial\n")
    for stub in sorted(own.rglob("*.pyi")):
        relative = stub.relative_to(own)
        if relative.parts[0] not in ("unreal", "codegen"):
            output.write(relative.as_posix(), stub.read_text(encoding="utf-8"))
    output.finish()


def _emit(command: str, files: tuple[Path, ...], folder: Path, jobs: int, **options: Any) -> Output:
    from spear.codegen.cli import emit
    from spear.codegen.schema import SchemaError, SchemaSet

    schemas = SchemaSet.of(read_all(files))
    if "UObject" not in schemas.classes:
        click.echo("spear: warning: no schema declares UObject: give the engine's schema as well, or what AActor and its like have is not known", err=True)
    run: Callable[..., Output] = emit
    try:
        with writing(folder):
            return run(command, schemas, folder, progress=True, jobs=jobs, **options)
    except SchemaError as error:
        raise Failure(str(error)) from None
    except (KeyError, TypeError, AttributeError) as error:
        if os.environ.get("SPEAR_TRACEBACK"):
            raise
        raise Failure(f"a schema lacks what it must have ({type(error).__name__}: {error}); `spear schema check` says what and where (SPEAR_TRACEBACK=1 shows the place)") from None


def _said(written: Output, folder: Path) -> None:
    click.echo(f"{folder}: {written.total} files, {written.changed} changed" + (f", {written.removed} removed" if written.removed else ""), err=True)
