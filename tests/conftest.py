# SPDX-License-Identifier: MIT
"""What Python tests share: the build tree, and an engine that runs in a process of its own."""

from __future__ import annotations

import os
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

    with spear.launch(scene="apartment", fixed_dt=0.01, fps=0) as running:
        yield running


@pytest.fixture
def game(instance: "spear.Instance") -> "spear.Game":  # noqa: F821
    return instance.get_game()
