# SPDX-License-Identifier: MIT
"""What Python tests share: the build tree, and an engine that runs in a process of its own."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
BUILD = Path(os.environ.get("SPEAR_BUILD_DIR", ROOT / "build" / "release"))
os.environ.setdefault("SPEAR_BUILD_DIR", str(BUILD))
if str(BUILD / "python") not in sys.path:
    sys.path.insert(0, str(BUILD / "python"))


@pytest.fixture(scope="session")
def build_directory() -> Path:
    """The build tree that is tested."""
    return BUILD


@pytest.fixture(scope="session")
def source_directory() -> Path:
    """The root of the project."""
    return ROOT


@pytest.fixture(scope="session")
def instance() -> Iterator["spear.Instance"]:  # noqa: F821
    """An engine with the apartment, at a fixed time step, as fast as it can; shared by all tests that do not harm it."""
    import spear

    with spear.launch(scene="apartment", fixed_dt=0.01, fps=500) as running:
        yield running


@pytest.fixture
def game(instance: "spear.Instance") -> "spear.Game":  # noqa: F821
    return instance.get_game()


@pytest.fixture(scope="session")
def scale_code_base(build_directory: Path) -> Path:
    """The headers of a synthetic code base as large as the real engine (tests/scale), written anew."""
    folder = build_directory / "scale" / "code_base"
    folder.parent.mkdir(parents=True, exist_ok=True)
    subprocess.run([sys.executable, str(ROOT / "tests" / "scale" / "make_code_base.py"), "-o", str(folder)], check=True, capture_output=True)
    return folder


@pytest.fixture(scope="session")
def scale_schema(scale_code_base: Path, build_directory: Path) -> Path:
    """Its schema, dumped once for all tests that begin there."""
    schema = build_directory / "scale" / "schema.json"
    program = build_directory / "bin" / "spear-header-tool"
    subprocess.run([str(program), "dump", "--quiet", "--no-cache", "--module", str(scale_code_base / "Source"), "--output", str(schema)], check=True, capture_output=True)
    return schema
