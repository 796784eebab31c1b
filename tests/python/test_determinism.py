# SPDX-License-Identifier: MIT
"""G9 in short: 100 steps of moving and attached actors, from Python and from C++, idle and under load, have the same bits.

The long form is a command: tests/soak/determinism.py.
"""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest


@pytest.fixture(scope="module")
def determinism(source_directory: Path) -> ModuleType:
    path = source_directory / "tests" / "soak" / "determinism.py"
    specification = importlib.util.spec_from_file_location("spear_soak_determinism", path)
    assert specification is not None and specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def test_g9_the_same_steps_give_the_same_bits_from_python_and_cpp_under_load_and_idle(determinism: ModuleType) -> None:
    steps = 100
    first, frames = determinism.run("Python", steps)
    assert len(first) == steps * determinism.GROUPS * 5 * determinism.NUMBERS_PER_ACTOR * 8
    assert frames > steps
    half = len(first) // 2
    assert first[:half] != first[half:]  # things move
    assert determinism.first_difference(first, determinism.run("C++", steps)[0], steps) == ""
    assert determinism.first_difference(first, determinism.run("Python", steps, load=2)[0], steps) == ""
