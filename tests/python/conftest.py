# SPDX-License-Identifier: MIT
"""An engine with the test module RoundTrip: every kind of property, as a variable, an argument and an output."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

import spear


@pytest.fixture(scope="session")
def round_trip(build_directory: Path) -> Iterator[spear.Instance]:
    """Shared by the tests that need types of all kinds."""
    with spear.launch(scene="apartment", fixed_dt=0.01, fps=500, arguments=["--plugin-dir", str(build_directory / "test_plugins")]) as running:
        yield running


@pytest.fixture
def in_block(round_trip: spear.Instance) -> Iterator[spear.Game]:
    """The game of that engine, within an open begin_frame block."""
    with round_trip.begin_frame():
        yield round_trip.get_game()
    with round_trip.end_frame():
        pass


@pytest.fixture
def things(in_block: spear.Game) -> Iterator[spear.UnrealObject]:
    """A URoundTrip."""
    made = in_block.new_object("URoundTrip")
    yield made
    in_block.release_object(made)


@pytest.fixture
def calls(in_block: spear.Game) -> Iterator[spear.UnrealObject]:
    """A URoundTripCalls."""
    made = in_block.new_object("URoundTripCalls")
    yield made
    in_block.release_object(made)
