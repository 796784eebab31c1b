# SPDX-License-Identifier: MIT
"""What tests and fixtures of the schema tools share. (Not in conftest.py: with several folders of tests in one run, `import conftest` may give another one.)"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

#: The fixture `dump`.
Dump = Callable[..., Path]


class Command:
    """`spear schema ...` in a process of its own."""

    def __init__(self, build_directory: Path, folder: Path):
        self.folder = folder
        self.environment = {name: value for name, value in os.environ.items() if name not in ("VIRTUAL_ENV", "CONDA_PREFIX")}
        self.environment |= {"PYTHONPATH": str(build_directory / "python"), "SPEAR_BUILD_DIR": str(build_directory)}

    def __call__(self, *arguments: str | Path, code: int = 0, stdin: str | None = None, **environment: str) -> subprocess.CompletedProcess[str]:
        """Runs it and asserts the exit code; never a traceback."""
        result = subprocess.run([sys.executable, "-m", "spear", "schema", *map(str, arguments)], capture_output=True, text=True, check=False, cwd=self.folder,
                                env={**self.environment, **environment}, input=stdin)
        assert result.returncode == code, f"exit code {result.returncode}:\n{result.stdout[-2000:]}\n{result.stderr[-2000:]}"
        assert "Traceback" not in result.stderr, result.stderr
        return result


def load(path: Path) -> Any:
    """A JSON file."""
    return json.loads(path.read_text(encoding="utf-8"))
