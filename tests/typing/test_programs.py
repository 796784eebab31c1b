# SPDX-License-Identifier: MIT
"""The programs that the type checkers have passed, run: what stubs promise is what happens."""

from __future__ import annotations

import sys
from pathlib import Path

import spear

sys.path.insert(0, str(Path(__file__).resolve().parent))


def test_the_sample_program_runs(instance: spear.Instance) -> None:
    import sample_program

    sample_program.main(instance)


def test_every_kind_of_value_is_what_its_stub_says(round_trip_engine: spear.Instance) -> None:
    import round_trip
    from spear.unreal.Engine import AStaticMeshActor
    from spear.unreal.RoundTrip import URoundTrip, URoundTripCalls

    game = round_trip_engine.get_game()
    with round_trip_engine.begin_frame():
        trip, calls = game.new_object(URoundTrip), game.new_object(URoundTripCalls)
        actor = game.spawn_actor(AStaticMeshActor)
        try:
            round_trip.main(trip, calls, actor)
        finally:
            game.destroy_actor(actor)
    with round_trip_engine.end_frame():
        pass
