# SPDX-License-Identifier: MIT
"""Golden stubs: whatever the emitter writes for the test modules is compared with checked-in files, text for text.

After a change that is meant: ``SPEAR_UPDATE_GOLDEN=1 pytest tests/typing/test_golden.py``, then read the difference.
"""

from __future__ import annotations

import difflib
import os
import shutil
from pathlib import Path

GOLDEN = Path(__file__).resolve().parent / "golden"
UPDATE = os.environ.get("SPEAR_UPDATE_GOLDEN") == "1"


def compare(made: Path, golden: Path) -> None:
    """The files of two folders; differences as a diff. Golden files have the suffix .golden, so that no tool takes them for stubs."""
    if UPDATE:
        shutil.rmtree(golden, ignore_errors=True)
        golden.mkdir(parents=True)
        for path in made.iterdir():
            shutil.copy(path, golden / (path.name + ".golden"))
    new = {path.name: path.read_text() for path in made.iterdir()}
    old = {path.name.removesuffix(".golden"): path.read_text() for path in golden.iterdir()}
    assert new.keys() == old.keys()
    for name in new:
        difference = difflib.unified_diff(old[name].splitlines(), new[name].splitlines(), f"golden/{name}", f"made/{name}", lineterm="")
        assert new[name] == old[name], "\n".join(difference)


def test_round_trip(round_trip_stubs: Path) -> None:
    compare(round_trip_stubs / "RoundTrip", GOLDEN / "RoundTrip")


def test_odd_shapes(awkward_stubs: Path) -> None:
    compare(awkward_stubs / "Awkward", GOLDEN / "Awkward")
