# SPDX-License-Identifier: MIT
"""A user's environment in a folder: a virtual environment that holds the Python package and, maybe, a ``spear-stubs`` package."""

from __future__ import annotations

import subprocess
import venv
from pathlib import Path


def make_environment(folder: Path, package: Path) -> Path:
    """A virtual environment whose site-packages hold the ``spear`` of the build tree; gives its interpreter."""
    venv.create(folder, with_pip=False, symlinks=True)
    python = folder / "bin" / "python"
    link = site_packages(python) / "spear"
    if not link.is_symlink():
        link.symlink_to(package / "spear", target_is_directory=True)
    return python


def site_packages(python: Path) -> Path:
    """Where an interpreter's packages lie."""
    result = subprocess.run([str(python), "-c", "import sysconfig; print(sysconfig.get_path('purelib'))"], capture_output=True, text=True, check=True)
    return Path(result.stdout.strip())
