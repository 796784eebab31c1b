# SPDX-License-Identifier: MIT
"""The programs that the type checkers have passed, run: what stubs promise is what happens."""

from __future__ import annotations

import ast
import sys
from pathlib import Path

import pytest

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


def test_names_for_annotations_exist_at_run_time(source_directory: Path) -> None:
    import spear.typing

    described = ast.parse((source_directory / "python" / "spear" / "typing.pyi").read_text())
    classes = {node.name for node in described.body if isinstance(node, ast.ClassDef) and not node.name.startswith("_")}
    aliases = {node.target.id for node in described.body if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name)} - {"MYPY"}
    assert classes | aliases | {"Future"} == set(spear.typing.__all__)
    assert spear.typing.Path[bool] is spear.typing.Path  # any annotation of the stubs may be written
    assert spear.typing.ArrayPath[str, str, str, str] is spear.typing.ArrayPath
    with pytest.raises(TypeError, match="paths come from objects"):
        spear.typing.Path()


def test_paths_are_told_from_values(instance: spear.Instance) -> None:
    from spear.typing import Path as SpearPath
    from spear.unreal.Engine import AStaticMeshActor

    game = instance.get_game()
    with instance.begin_frame():
        actor = game.spawn_actor(AStaticMeshActor)
        assert isinstance(actor.bHidden, SpearPath) and not isinstance(actor.bHidden.get(), SpearPath) and not isinstance(actor, SpearPath)
        game.destroy_actor(actor)
    with instance.end_frame():
        pass
