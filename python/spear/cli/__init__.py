# SPDX-License-Identifier: MIT
"""The command line: ``spear engine``, ``demo``, ``schema``, ``trace``, ``bench``, ``doctor``, ``completion``.

Exit codes: 0 done, 1 it failed (the reason is on standard error), 2 the command line was wrong.
"""

from __future__ import annotations

import sys

import click

from spear.cli.bench import bench
from spear.cli.completion import completion
from spear.cli.demo import demo
from spear.cli.doctor import doctor
from spear.cli.engine import engine
from spear.cli.schema import schema
from spear.cli.trace import trace


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(package_name=None, version=__import__("spear").__version__, prog_name="spear")
def cli() -> None:
    """Drive Unreal Engine applications: start engines, read their reflection, measure.

    \b
    Examples:
      spear demo                                two programs drive the embedded engine
      spear engine --scene apartment --fps 60   run the embedded engine; Ctrl-C ends it
      spear engine list                         engines that run
      spear schema live                         the reflection of a running engine, as JSON
      spear trace --png out.png                 what client and engine do at the same time
      spear bench calls                         what a call costs on this machine
    """


for command in (engine, demo, schema, trace, bench, doctor, completion):
    cli.add_command(command)


def main() -> None:
    """Runs the command line; errors of the library become one line on standard error and exit code 1."""
    from spear.errors import Error

    try:
        cli.main(prog_name="spear", standalone_mode=True)
    except (Error, FileNotFoundError) as error:
        click.echo(f"spear: {error}", err=True)
        sys.exit(1)
    except BrokenPipeError:
        sys.stderr.close()  # the reader of our output left, as in `spear schema live | head`
        sys.exit(1)
