# SPDX-License-Identifier: MIT
"""``spear trace``: what client and engine do at the same time."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import click

from spear.cli.completion import complete_address


@click.command(context_settings={"ignore_unknown_options": False})
@click.option("-o", "--output", type=click.Path(dir_okay=False, path_type=Path), default=Path("trace.json"), show_default=True, help="The trace file.")
@click.option("--png", type=click.Path(dir_okay=False, path_type=Path), help="A picture of some frames.")
@click.option("--frames", type=click.IntRange(1, 200), default=5, show_default=True, help="Frames in the picture.")
@click.option("--first-frame", type=int, help="The picture's first frame, by the engine's number. [default: in the middle]")
@click.option("--seconds", type=click.FloatRange(min=0, min_open=True), default=5.0, show_default=True, help="How long to record a running engine.")
@click.option("--address", default="", help="The engine to record; needed if several run.", shell_complete=complete_address)
@click.option("--token", default="", help="The engine's token, if it has one.")
@click.option("--operations", is_flag=True, help="Each single operation as well.")
@click.option("--read", "existing", type=click.Path(exists=True, dir_okay=False, path_type=Path), help="Record nothing: summary and picture of this trace.")
@click.argument("command", nargs=-1, type=click.UNPROCESSED)
def trace(
    output: Path, png: Path | None, frames: int, first_frame: int | None, seconds: float, address: str, token: str, operations: bool, existing: Path | None, command: tuple[str, ...]
) -> None:
    """Record what client, server and game threads do, as a file for ui.perfetto.dev or chrome://tracing, and print a summary.

    With COMMAND, records that program (any that uses SPEAR, in C++ or Python) and the engines it drives, until it ends. Without, records a running
    engine for some seconds. In a program: `with instance.trace("out.json"):`, `spear::Trace`.

    \b
    Examples:
      spear trace --png out.png -- python examples/steady_state/steady_state.py
      spear trace --seconds 2 -o out.json
      spear trace --read out.json --png out.png --frames 3
    """
    from spear import trace as traces

    code = 0
    if existing:
        output = existing
    elif command:
        code = _record_program(command, output, operations)
    else:
        _record_engine(output, address, token, seconds, operations)
    recorded = traces.read(output)
    click.echo(traces.describe(traces.summarise(recorded), recorded.dropped))
    if not existing:
        click.echo(f"{output}: open it in https://ui.perfetto.dev or chrome://tracing")
    if png:
        from spear.trace_picture import draw

        try:
            draw(recorded, png, frames, first_frame)
        except ValueError as error:
            raise click.ClickException(str(error)) from error
        click.echo(f"{png}: {frames} frames")
    sys.exit(code)


def _record_engine(output: Path, address: str, token: str, seconds: float, operations: bool) -> None:
    import spear

    with spear.connect(address, token=token) as instance, instance.trace(output, operations=operations):
        first = instance.call("engine_service.get_frame_number")
        try:
            time.sleep(seconds)
            patience = time.monotonic() + 30
            while instance.call("engine_service.get_frame_number") < first + 3 and time.monotonic() < patience:
                time.sleep(0.01)  # a slow engine: at least one whole frame shall be in the trace, unless somebody holds it
        except KeyboardInterrupt:
            click.echo("Ended early.", err=True)


def _record_program(command: tuple[str, ...], output: Path, operations: bool) -> int:
    """Runs the program; the trace is of all its processes. Returns its exit code."""
    from spear import trace as traces

    with tempfile.TemporaryDirectory(prefix="spear-trace-") as folder:
        environment = {**os.environ, "SPEAR_TRACE": f"{folder}/%p.json", "SPEAR_TRACE_OPERATIONS": "1" if operations else "0"}
        try:
            code = subprocess.run(command, env=environment, check=False).returncode
        except OSError as error:
            raise click.ClickException(f"{command[0]} cannot be run: {error.strerror}") from error
        files = sorted(Path(folder).glob("*.json"))
        if not files:
            raise click.ClickException(
                f"{command[0]} (exit code {code}) left no trace: it connected to no engine, or ended by a signal before it closed its sessions."
            )
        traces.merge(files, output)
    return code
