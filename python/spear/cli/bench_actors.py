# SPDX-License-Identifier: MIT
"""How many actors Python moves per frame: by plain calls in a loop, and by one call for many (``game.call_many``)."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import numpy as np

import spear

ACTORS = 10_000
FRAMES = 20


def measure(instance: spear.Instance, actors: int = ACTORS, frames: int = FRAMES) -> list[dict[str, Any]]:
    """One row for each way of moving so many actors to new places in every frame.

    what: the way; actors; frames: how many were measured; record_ms: the time that Python takes to record the calls of one frame;
    ms_per_frame: from the beginning of one transaction to that of the next, with the engine's work in it, which overlaps with the
    recording of the next; actors_per_second. Medians would hide what waits, so both times are means over all frames.
    """
    game = instance.get_game()
    spawned: list[Any] = []
    for _ in range(-(-actors // 1000)):
        with instance.begin_frame():
            spawned += [game.async_.spawn_actor("ACameraActor") for _ in range(min(1000, actors - len(spawned)))]
        with instance.end_frame():
            pass
    moved = [future.get() for future in spawned]
    places = np.random.default_rng(1).uniform(-1000, 1000, (actors, 3))

    def loop(frame: int) -> None:
        for actor, place in zip(moved, vectors):
            actor.send_.K2_SetActorLocation(NewLocation=place, bSweep=False, bTeleport=True)

    def loop_futures(frame: int) -> list[Any]:
        return [actor.async_.K2_SetActorLocation(NewLocation=place, bSweep=False, bTeleport=True) for actor, place in zip(moved, vectors)]

    def many(frame: int) -> None:
        game.send_.call_many(moved, "K2_SetActorLocation", NewLocation=places + frame, bSweep=False, bTeleport=True)

    def many_futures(frame: int) -> list[Any]:
        return game.async_.call_many(moved, "K2_SetActorLocation", NewLocation=places + frame, bSweep=False, bTeleport=True)

    vectors = [spear.FVector(*place) for place in places.tolist()]
    ways: dict[str, Callable[[int], Any]] = {
        "plain calls in a loop, fire and forget": loop, "plain calls in a loop, futures": loop_futures,
        "call_many with an array, fire and forget": many, "call_many with an array, futures": many_futures,
    }
    rows = [_measure_way(instance, what, record, actors, frames) for what, record in ways.items()]
    with instance.begin_frame():
        game.send_.call_many(moved, "K2_DestroyActor")
    with instance.end_frame():
        pass
    instance.flush()
    return rows


def _measure_way(instance: spear.Instance, what: str, record: Callable[[int], Any], actors: int, frames: int) -> dict[str, Any]:
    recording = 0.0
    began = 0.0
    for frame in range(-2, frames):  # two to warm up
        if frame == 0:
            instance.flush()
            recording, began = 0.0, time.perf_counter()
        with instance.begin_frame():
            started = time.perf_counter()
            kept = record(frame)
            recording += time.perf_counter() - started
        with instance.end_frame():
            pass
        del kept
    instance.flush()
    elapsed = time.perf_counter() - began
    return {
        "what": what, "actors": actors, "frames": frames, "record_ms": recording * 1e3 / frames, "ms_per_frame": elapsed * 1e3 / frames,
        "actors_per_second": actors * frames / elapsed,
    }
