# SPDX-License-Identifier: MIT
"""``spear completion``, and what the shell completes beyond commands and options: engines that run, plugins."""

from __future__ import annotations

import os
from pathlib import Path

import click
from click.shell_completion import CompletionItem, get_completion_class

PLACES = {"bash": "~/.bashrc", "zsh": "~/.zshrc", "fish": "~/.config/fish/completions/spear.fish"}


@click.command()
@click.argument("shell", type=click.Choice(sorted(PLACES)), required=False)
def completion(shell: str | None) -> None:
    """Print the script that makes a shell complete `spear`: commands, options, addresses of running engines, plugins.

    SHELL is taken from the environment if it is not given. For a checkout, put its tools folder on the PATH first.

    \b
    Examples:
      eval "$(spear completion bash)"                                   in ~/.bashrc
      eval "$(spear completion zsh)"                                    in ~/.zshrc
      spear completion fish > ~/.config/fish/completions/spear.fish
    """
    from spear.cli import cli

    name = shell or Path(os.environ.get("SHELL", "")).name
    found = get_completion_class(name)
    if found is None or name not in PLACES:
        raise click.UsageError(f"Which shell? Give one of {', '.join(sorted(PLACES))} (SHELL is {name or 'not set'}).")
    click.echo(found(cli, {}, "spear", "_SPEAR_COMPLETE").source())


def complete_address(context: click.Context, parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """Addresses of this user's engines, with their process and scene."""
    from spear.engines import list_engines

    return [
        CompletionItem(one.address, help=f"process {one.process_id} {one.scene}".rstrip()) for one in list_engines(timeout=0.5) if one.address.startswith(incomplete)
    ]


def complete_plugin(context: click.Context, parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """Names of the plugins in the build tree and below the folders given by --plugin-dir."""
    from spear.programs import build_directory

    build = build_directory()
    folders = [Path(folder) for folder in context.params.get("plugin_dir") or ()]
    if build:
        folders += [build / name for name in ("plugins", "example_plugins")]
    names = {file.stem for folder in folders for file in folder.rglob("*.uplugin")}
    return [CompletionItem(name) for name in sorted(names) if name.lower().startswith(incomplete.lower())]


def complete_scene(context: click.Context, parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
    """Scenes of the build tree's content, else files."""
    from spear.programs import build_directory

    build = build_directory()
    names = {file.name.removesuffix(".scene.json") for file in (build / "content").rglob("*.scene.json")} if build else set()
    found = [CompletionItem(name) for name in sorted(names) if name.startswith(incomplete)]
    return found or [CompletionItem(incomplete, type="file")]
