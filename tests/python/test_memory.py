# SPDX-License-Identifier: MIT
"""Calls leave nothing behind: the short form of tests/soak/memory.py, which makes a million of every kind."""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import spear

CALLS = 2000
"""Of each kind, in four parts: a leak grows in each by 16 bytes per call at least, everything else not in all four."""


@pytest.fixture(scope="module")
def soak(source_directory: Path, build_directory: Path) -> Iterator[Any]:
    specification = importlib.util.spec_from_file_location("soak_memory", source_directory / "tests" / "soak" / "memory.py")
    assert specification and specification.loader
    module = importlib.util.module_from_spec(specification)
    sys.modules["soak_memory"] = module
    specification.loader.exec_module(module)
    # An engine of its own: what other tests leave to be collected would be counted.
    with spear.launch(scene="", fps=0, fixed_dt=0.01, arguments=["--plugin-dir", str(build_directory / "test_plugins")]) as instance:
        yield module.Soak(instance, instance.process_id)


def test_calls_leave_nothing_behind(soak: Any) -> None:
    leaks = {kind: leaks for kind in soak.kinds if (leaks := soak.measure(kind, CALLS).leaks())}
    assert not leaks
