# SPDX-License-Identifier: MIT
"""Several clients of one engine, from Python: order, sharing of frames, holding, engines that run no frames. (docs/guarantees.md)"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

import spear


@pytest.fixture
def connect(round_trip: spear.Instance) -> Iterator[Callable[..., spear.Instance]]:
    """Makes sessions of their own, closed at the end of the test."""
    made: list[spear.Instance] = []

    def one_more(deadline: float = 60, **options: str) -> spear.Instance:
        made.append(spear.connect(round_trip.address, deadline=deadline, **options))
        return made[-1]

    yield one_more
    for instance in reversed(made):
        instance.close()


def arrive(client: spear.Instance) -> None:
    """Returns when the server has everything that this client has sent."""
    client.call("engine_service.ping", "")


def test_begin_works_run_in_order_of_arrival_and_end_works_in_the_same(connect: Callable[..., spear.Instance]) -> None:
    holder, a, b = connect(), connect(), connect()
    system = holder.get_game().get_class("UKismetSystemLibrary")
    # "Ticket" gives a number that tells in which order the calls of all clients ran.
    calls = {client: client.get_game().get_class("URoundTripCalls").async_ for client in (holder, a, b)}
    others = [b, a]
    with holder.begin_frame():
        begins = [calls[holder].Ticket()]
        begins[0].get()  # holds the engine: the others arrive meanwhile
        frame = system.GetFrameCount()
        for client in others:
            with client.begin_frame():
                begins.append(calls[client].Ticket())
            arrive(client)
        assert not begins[-1].is_ready()
    ends = []
    for client in reversed(others):
        with client.end_frame():
            ends.append(calls[client].Ticket())
        arrive(client)
    with holder.end_frame():
        ends.append(calls[holder].Ticket())
        assert system.GetFrameCount() == frame
    first = begins[0].get()
    assert [future.get() for future in begins] == [first, first + 1, first + 2]
    assert [future.get() for future in reversed(ends)] == [first + 3, first + 4, first + 5]


def test_while_one_holds_by_single_step_others_wait_up_to_their_deadline(connect: Callable[..., spear.Instance]) -> None:
    holder, waiting = connect(), connect(deadline=0.2)
    with holder.begin_frame():
        pass
    with holder.end_frame(single_step=True):
        pass
    holder.flush()
    with pytest.raises(spear.HeldByClient, match="single_step"):
        with waiting.begin_frame():
            waiting.get_game().spawn_actor("ACameraActor")
    assert waiting.get_game().get_class("AActor").unreal_name  # facts need no frame
    holder.step(1)
    with connect().begin_frame():
        pass


def test_sessions_of_several_threads_at_once(connect: Callable[..., spear.Instance]) -> None:
    wrong: list[object] = []

    def work(client: spear.Instance, number: int) -> None:
        try:
            game = client.get_game()
            with client.begin_frame():
                actor = game.spawn_actor("ACameraActor")
            with client.end_frame():
                pass
            for i in range(20):
                place = spear.FVector(i, number, 0)
                with client.begin_frame():
                    actor.send_.K2_SetActorLocation(NewLocation=place, bSweep=False, bTeleport=True)
                    later = actor.async_.K2_GetActorLocation()
                with client.end_frame(single_step=number == 0):
                    if actor.K2_GetActorLocation() != place:
                        wrong.append((number, i, "sync"))
                if later.get() != place:
                    wrong.append((number, i, "async"))
            with client.begin_frame():
                game.destroy_actor(actor)
            with client.end_frame():
                pass
        except BaseException as error:
            wrong.append(error)

    threads = [threading.Thread(target=work, args=(connect(), number)) for number in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert wrong == []


def test_an_engine_that_runs_no_frames_is_busy(connect: Callable[..., spear.Instance], tmp_path: Path) -> None:
    blocker, client = connect(), connect(deadline=1.5)
    calls = blocker.get_game().get_class("URoundTripCalls")
    with blocker.begin_frame():
        blocked = calls.async_.BlockFrames(Folder=str(tmp_path))
    with blocker.end_frame():
        pass
    while not (tmp_path / "began").exists():
        time.sleep(0.002)
    with pytest.raises(spear.EngineBusy, match="no frame"):
        with client.begin_frame():
            client.get_game().find_actors_by_class("AActor")
    assert client.call("engine_service.ping", "still there") == "still there"
    (tmp_path / "go").touch()
    blocked.get()
    with connect() as other, other.begin_frame():
        assert other.get_game().find_actors_by_class("AActor")


def test_lease_off_and_others(round_trip: spear.Instance) -> None:
    for lease in ("off", 60, None):
        with spear.connect(round_trip.address, lease=lease, deadline=60) as client:
            client.step()
    with pytest.raises(ValueError, match="off"):
        spear.connect(round_trip.address, lease="never")


def test_objects_and_futures_outlive_their_session_and_raise_disconnected(connect: Callable[..., spear.Instance]) -> None:
    client = connect()
    with client.begin_frame():
        actor = client.get_game().spawn_actor("ACameraActor", location=(1, 2, 3))
        location = actor.async_.K2_GetActorLocation()
    with client.end_frame():
        pass
    client.flush()
    client.close()
    client.close()
    assert location.get() == spear.FVector(1, 2, 3)  # its answer had come
    with pytest.raises(spear.Disconnected):
        actor.K2_GetActorLocation()
    with pytest.raises(spear.Disconnected):
        client.begin_frame().__enter__()
    with pytest.raises(spear.Disconnected):
        client.statistics()
