# SPDX-License-Identifier: MIT
"""One function called for many objects at once: game.call_many and its twins."""

from __future__ import annotations

import numpy as np
import pytest

import spear


@pytest.fixture
def actors(in_block: spear.Game):
    made = [in_block.spawn_actor("ACameraActor") for _ in range(5)]
    yield made
    for actor in made:
        if actor.is_valid():
            in_block.destroy_actor(actor)


def places_of(actors: list[spear.UnrealObject]) -> list[list[float]]:
    return [list(actor.K2_GetActorLocation()) for actor in actors]


def test_one_row_of_an_array_for_each(in_block: spear.Game, actors: list[spear.UnrealObject]) -> None:
    places = np.arange(15, dtype=np.float64).reshape(5, 3)
    results = in_block.call_many(actors, "K2_SetActorLocation", NewLocation=places, bSweep=False, bTeleport=True)
    assert len(results) == 5 and all(result.ReturnValue is True for result in results)
    assert places_of(actors) == places.tolist()
    assert [list(place) for place in in_block.call_many(actors, "K2_GetActorLocation")] == places.tolist()


@pytest.mark.parametrize("places", [
    np.arange(30, dtype=np.float32).reshape(5, 6)[:, ::2], [spear.FVector(i, 2, 3) for i in range(5)], tuple([i, 2, 3] for i in range(5)),
    np.asfortranarray(np.arange(15).reshape(5, 3)), [{"X": 1, "Y": i, "Z": 2} for i in range(5)],
], ids=["not contiguous", "structs", "lists", "integers in Fortran's order", "dictionaries"])
def test_values_of_all_kinds(in_block: spear.Game, actors: list[spear.UnrealObject], places: object) -> None:
    in_block.call_many(actors, "K2_SetActorLocation", NewLocation=places, bSweep=False, bTeleport=True)
    wanted = [list(place.values()) if isinstance(place, dict) else list(place) for place in places]  # type: ignore[attr-defined]
    assert places_of(actors) == wanted


def test_one_value_for_all(in_block: spear.Game, actors: list[spear.UnrealObject]) -> None:
    in_block.call_many(actors, "SetActorScale3D", NewScale3D=spear.FVector(2, 2, 2))
    assert all(scale == spear.FVector(2, 2, 2) for scale in in_block.call_many(actors, "GetActorScale3D"))
    in_block.call_many(np.array(actors, dtype=object), "SetActorScale3D", spear.FVector(3, 3, 3))
    assert all(scale == spear.FVector(3, 3, 3) for scale in in_block.call_many(tuple(actors), "GetActorScale3D"))


def test_one_object_for_all_calls(in_block: spear.Game, calls: spear.UnrealObject) -> None:
    assert in_block.call_many(calls, "Needed", First=np.array([5, 6, 7]), Second=[1, 2, 3]) == [4, 4, 4]
    assert in_block.call_many(calls, "Needed", np.array([5, 6, 7], dtype=np.uint8), Second=1) == [4, 5, 6]
    assert in_block.call_many([calls, calls], "Length", np.array([[3.0, 4, 0], [0, 0, 2]])) == [5.0, 2.0]
    assert in_block.call_many([], "Needed") == [] == in_block.async_.call_many([], "Needed")


def test_asynchronously(in_block: spear.Game, actors: list[spear.UnrealObject]) -> None:
    futures = in_block.async_.call_many(actors, "K2_SetActorLocation", np.ones((5, 3)), False, True)
    located = in_block.async_.call_many(actors, "K2_GetActorLocation")
    in_block.send_.call_many(actors, "SetActorScale3D", NewScale3D=located)  # futures as arguments
    assert [future.get().ReturnValue for future in futures] == [True] * 5 and located[4].get() == spear.FVector(1, 1, 1)
    born = in_block.async_.spawn_actor("ACameraActor", location=(1, 2, 3))
    assert in_block.call_many([born, born.object, actors[0]], "K2_GetActorLocation") == [spear.FVector(1, 2, 3)] * 2 + [spear.FVector(1, 1, 1)]
    in_block.destroy_actor(born)


def test_errors(in_block: spear.Game, actors: list[spear.UnrealObject], calls: spear.UnrealObject) -> None:
    with pytest.raises(ValueError, match="NewLocation has 4 values, but objects has 5"):
        in_block.call_many(actors, "K2_SetActorLocation", NewLocation=np.ones((4, 3)), bSweep=False, bTeleport=True)
    with pytest.raises(ValueError, match="Second has 2 values, but First has 3"):
        in_block.call_many(calls, "Needed", First=[1, 2, 3], Second=[1, 2])
    with pytest.raises(spear.UnknownFunction, match="NoSuch"):
        in_block.call_many(actors, "NoSuch")
    with pytest.raises(spear.WrongType, match="cannot be sent"):
        in_block.call_many(actors, "K2_SetActorLocation", NewLocation=[object()] * 5, bSweep=False, bTeleport=True)
    in_block.destroy_actor(actors[1])
    with pytest.raises(spear.StaleObject):
        in_block.call_many(actors, "SetActorScale3D", NewScale3D=spear.FVector(7, 7, 7))
    assert [actors[i].GetActorScale3D().X for i in (0, 2, 3, 4)] == [7, 7, 7, 7]  # the others ran
    with pytest.raises(TypeError):
        in_block.call_many(17, "SetActorScale3D")  # type: ignore[arg-type]
