# SPDX-License-Identifier: MIT
"""``spear engine``: run the embedded engine, list running engines."""

from __future__ import annotations

import json
import os

import click

from spear.cli.completion import complete_plugin, complete_scene


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
      spear engine clean
    """


@engine.command(context_settings={"ignore_unknown_options": True, "allow_extra_args": True})
@click.option("--scene", default="apartment", show_default=True, help="Scene by name or path of a glTF file.", shell_complete=complete_scene)
@click.option("--fps", type=float, help="Frames per second to keep; 0 runs as fast as possible. [default: 60]")
@click.option("--fixed-dt", type=float, metavar="SECONDS", help="Simulated time per frame, whatever the clock says.")
@click.option("--address", help="Where to listen: unix:/path or tcp://host:port (port 0: any). [default: a socket of this user]")
@click.option("--paused", is_flag=True, help="Start with the world paused.")
@click.option("--plugin-dir", multiple=True, type=click.Path(file_okay=False), help="Folder searched for plugins; may be repeated.")
@click.option("--plugin", multiple=True, help="Plugin to enable that is not enabled by default; may be repeated.", shell_complete=complete_plugin)
@click.pass_context
def run(
    context: click.Context, scene: str, fps: float | None, fixed_dt: float | None, address: str | None, paused: bool, plugin_dir: tuple[str, ...], plugin: tuple[str, ...]
) -> None:
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
    for folder in plugin_dir:
        command += ["--plugin-dir", folder]
    command += context.args
    if plugin:
        command.append(f"-EnablePlugins={','.join(plugin)}")
    if address:
        command += [f"-SpearAddress={address}", "-SpearMustListen"]
    os.execv(program, command)  # the engine takes this process's place: its signals, its exit code


@engine.command()
@click.option("--json", "as_json", is_flag=True, help="For programs: a list of paths.")
def clean(as_json: bool) -> None:
    """Remove what killed engines left behind: sockets, entries of the list, shared memory, and the logs of engines that ended badly.

    Nothing of an engine that runs is touched. Every engine that starts does the same, but keeps the logs for a day.

    \b
    Examples:
      spear engine clean
      spear engine clean --json
    """
    from spear import _native

    removed = sorted(_native.remove_leftovers(True))
    if as_json:
        click.echo(json.dumps(removed, indent=2))
        return
    for path in removed:
        click.echo(f"removed {path}")
    if not removed:
        click.echo("Nothing was left behind.")


@engine.command("list")
@click.option("--json", "as_json", is_flag=True, help="For programs: a list of objects.")
def list_engines(as_json: bool) -> None:
    """Engines of this user that run on this machine, also those on TCP: process, project, scene, address, uptime, frame, clients.

    \b
    Examples:
      spear engine list
      spear engine list --json | jq -r '.[].address'
    """
    from dataclasses import asdict

    from spear import engines

    found = engines.list_engines()
    if as_json:
        click.echo(json.dumps([{name: value for name, value in asdict(one).items() if name != "error" or value} for one in found], indent=2))
        return
    if not found:
        click.echo("No engine runs. Start one: spear engine --scene apartment")
        return
    rows = [("process", "engine", "project", "scene", "frame", "up", "clients", "address")]
    for one in found:
        if one.error:
            rows.append((str(one.process_id), "does not answer", "", "", "", "", "", one.address))
        else:
            rows.append((str(one.process_id), one.engine, one.project, one.scene, str(one.frame), _time(one.uptime), str(one.sessions), one.address))
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    for row in rows:
        click.echo("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip())


def _time(seconds: float) -> str:
    whole = int(seconds)
    return f"{whole // 3600}:{whole // 60 % 60:02}:{whole % 60:02}" if whole >= 3600 else f"{whole // 60}:{whole % 60:02}"
