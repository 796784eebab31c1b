# SPDX-License-Identifier: MIT
"""``spear demo``: the paper's first program, in C++ and in Python."""

from __future__ import annotations

import subprocess
import sys

import click


@click.command()
@click.option("--steps", default=100, show_default=True, help="Frames of the ball's flight.")
def demo(steps: int) -> None:
    """Let a C++ and a Python program drive the embedded engine, each its own, and compare what they print."""
    from spear.programs import find_program, source_directory

    root = source_directory()
    if root is None:
        raise FileNotFoundError("The demo needs the source tree (examples/getting_started). Run it there: tools/spear demo")
    programs = {
        "C++": [str(find_program("getting_started")), "--steps", str(steps)],
        "Python": [sys.executable, str(root / "examples" / "getting_started" / "getting_started.py"), "--steps", str(steps)],
    }
    outputs = {}
    for language, command in programs.items():
        click.secho(f"--- {language}", bold=True)
        result = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
        click.echo(result.stdout, nl=False)
        if result.returncode != 0:
            click.echo(f"spear: the {language} program failed with exit code {result.returncode}", err=True)
            sys.exit(1)
        outputs[language] = result.stdout
    if outputs["C++"] != outputs["Python"]:
        click.echo("spear: the two programs printed different things", err=True)
        sys.exit(1)
    click.secho("Both printed the same.", fg="green")
