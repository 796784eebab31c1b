# SPDX-License-Identifier: MIT
"""Where the programs of SPEAR are: beside the package in a build tree, or on the PATH."""

from __future__ import annotations

import os
import shutil
from pathlib import Path


def build_directory() -> Path | None:
    """The build tree this package runs from: ``SPEAR_BUILD_DIR``, or the one that holds the package."""
    named = os.environ.get("SPEAR_BUILD_DIR")
    if named:
        return Path(named)
    beside = Path(__file__).absolute().parent.parent.parent  # not resolved: the build tree holds links
    return beside if (beside / "bin" / "spear-engine").exists() else None


def source_directory() -> Path | None:
    """The source tree, if the package runs from a build tree in it."""
    build = build_directory()
    root = build.parent.parent if build else None
    return root if root and (root / "codegen").is_dir() else None


def find_program(name: str) -> Path:
    """The program of that name. Raises FileNotFoundError with what was looked at."""
    build = build_directory()
    if build and (build / "bin" / name).exists():
        return build / "bin" / name
    on_path = shutil.which(name)
    if on_path:
        return Path(on_path)
    looked = f"{build / 'bin'} and the PATH" if build else "the PATH (SPEAR_BUILD_DIR is not set)"
    raise FileNotFoundError(f"The program {name} was not found in {looked}. Build SPEAR (tools/build), or set SPEAR_BUILD_DIR to its build tree.")
