# SPDX-License-Identifier: MIT
"""``spear engine``: run the embedded engine, list running engines."""

from __future__ import annotations

import json
import os

import click


class _RunByDefault(click.Group):
    """`spear engine --scene X` is `spear engine run --scene X`; options that we do not know go to the engine."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        if not args or (args[0].startswith("-") and args[0] not in ctx.help_option_names):
            args = ["run", *args]
        return super().parse_args(ctx, args)


@click.group(cls=_RunByDefault)
def engine() -> None:
    """Run the embedded engine until Ctrl-C, or list engines that run.

    `spear engine OPTIONS` is short for `spear engine run OPTIONS`.

    \b
    Examples:
      spear engine --scene apartment --fps 60
      spear engine --address tcp://127.0.0.1:5005 --fixed-dt 0.01
      spear engine run --help
      spear engine list
    """


@engine.command(context_settings={"ignore_unknown_options": True, "allow_extra_args": True})
@click.option("--scene", default="apartment", show_default=True, help="Scene by name or path of a glTF file.")
@click.option("--fps", type=float, help="Frames per second to keep; 0 runs as fast as possible. [default: 60]")
@click.option("--fixed-dt", type=float, metavar="SECONDS", help="Simulated time per frame, whatever the clock says.")
@click.option("--address", help="Where to listen: unix:/path or tcp://host:port. [default: a socket of this user]")
@click.option("--paused", is_flag=True, help="Start with the world paused.")
@click.pass_context
def run(context: click.Context, scene: str, fps: float | None, fixed_dt: float | None, address: str | None, paused: bool) -> None:
    """Run the embedded engine until Ctrl-C; exit code 0 then.

    Further options are passed to the engine itself (`spear engine -- --help` lists them).

    \b
    Example:
      spear engine --fps 60 --plugin-dir build/release/example_plugins
    """
    from spear.programs import find_program

    program = find_program("spear-engine")
    command = [str(program), "--scene", scene]
    if fps is not None:
        command += ["--fps", str(fps)]
    if fixed_dt is not None:
        command += ["--fixed-dt", str(fixed_dt)]
    if paused:
        command.append("--paused")
    command += context.args
    if address:
        command.append(f"-SpearAddress={address}")
    os.execv(program, command)  # the engine takes this process's place: its signals, its exit code


@engine.command("list")
@click.option("--json", "as_json", is_flag=True, help="For programs: a list of objects.")
def list_engines(as_json: bool) -> None:
    """Engines of this user that run, with scene and number of clients."""
    from spear import _native
    from spear.errors import Error

    rows = []
    for address, process_id in _native.list_engines():
        row: dict[str, object] = {"address": address, "process_id": process_id}
        try:
            row.update(_native.describe_engine(address, 2000))
        except Error as error:
            row["error"] = error.message
        rows.append(row)
    if as_json:
        click.echo(json.dumps(rows, indent=2))
    elif not rows:
        click.echo("No engine runs. Start one: spear engine --scene apartment")
    for row in [] if as_json else rows:
        if "error" in row:
            click.echo(f"{row['address']}  process {row['process_id']}  does not answer: {row['error']}")
        else:
            click.echo(f"{row['address']}  process {row['process_id']}  {row['engine']}  scene {row['scene']}  {row['sessions']} clients")
