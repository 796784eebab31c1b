# SPDX-License-Identifier: MIT
"""Traces of a real engine: they parse, spans nest, and each transaction is where the guarantees say."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest

import spear
from spear import trace

TRANSACTIONS = 5


@pytest.fixture
def client(instance: spear.Instance) -> Iterator[spear.Instance]:
    with spear.connect(instance.address) as session:
        yield session


@pytest.fixture
def actor(client: spear.Instance) -> Iterator[spear.UnrealObject]:
    game = client.get_game()
    with client.begin_frame():
        made = game.spawn_actor("ACoordinateAxes")
    with client.end_frame():
        pass
    yield made
    with client.begin_frame():
        game.destroy_actor(made)
    with client.end_frame():
        pass


def run_asynchronously(instance: spear.Instance, client: spear.Instance, actor: spear.UnrealObject) -> None:
    """Transactions of asynchronous operations alone, each of which is in the engine as a whole before its frame begins: another client holds
    the engine until it is. So it never is the engine that waits for this client, on however slow a machine."""
    instance.step(1)  # whatever frame was under way is over now: only whole frames are in a trace
    with spear.connect(instance.address) as holder:
        for number in range(TRANSACTIONS):
            with holder.begin_frame():
                holder.get_game().find_actors_by_class("AActor")  # synchronous: the engine is held from here on
                with client.begin_frame():
                    actor.send_.K2_SetActorLocation(NewLocation=spear.FVector(number, 0, 0), bSweep=False, bTeleport=True)
                with client.end_frame():
                    actor.async_.K2_GetActorLocation()
                client.call("engine_service.ping", text="")  # answered once the blocks before it have arrived
            with holder.end_frame():
                pass
        client.flush()
    instance.step(1)


def of_client(recorded: trace.Recorded, name: str, client: spear.Instance) -> list[trace.Span]:
    return [span for span in recorded.spans if span.name == name and span.arguments.get("session") == client._session.session_id]


def test_asynchronous_transactions(instance: spear.Instance, client: spear.Instance, actor: spear.UnrealObject, tmp_path: Path) -> None:
    file = tmp_path / "trace.json"
    with client.trace(file):
        run_asynchronously(instance, client, actor)
    recorded = trace.read(file)
    assert recorded.dropped == 0 and not of_client(recorded, "waiting for client", client)
    check_nesting(recorded)
    (game_thread,) = recorded.game_threads()
    assert recorded.threads[game_thread] == "game thread"
    frames = [span for span in recorded.of_thread(*game_thread) if trace.is_frame(span)]
    numbers = [frame.arguments["frame"] for frame in frames]
    assert numbers == list(range(numbers[0], numbers[0] + len(numbers)))

    begin_works, end_works = of_client(recorded, "begin work", client), of_client(recorded, "end work", client)
    assert len(begin_works) == len(end_works) == TRANSACTIONS
    ticks = [span for span in recorded.of_thread(*game_thread) if span.name == "world tick"]
    for begin_work, end_work in zip(begin_works, end_works):
        assert begin_work.arguments["transaction"] == end_work.arguments["transaction"]
        frame = next(frame for frame in frames if frame.begin <= begin_work.begin <= frame.end)  # both in one frame, its tick in between
        assert frame.begin <= begin_work.begin and begin_work.end <= end_work.begin and end_work.end <= frame.end
        assert any(begin_work.end <= tick.begin and tick.end <= end_work.begin for tick in ticks)
    # One clock for both processes: what is sent is worked on later, and the client's blocks are there.
    for block, works in (("begin_frame", begin_works), ("end_frame", end_works)):
        recordings = of_client(recorded, f"{block} block", client)
        assert [span.arguments["transaction"] for span in recordings] == [work.arguments["transaction"] for work in works]
        for recording, work in zip(recordings, works):
            assert recording.end <= work.begin
    assert len(of_client(recorded, "receive", client)) >= 2 * TRANSACTIONS


def check_nesting(recorded: trace.Recorded) -> None:
    """Of two spans of a thread, one is within the other, or they have nothing in common."""
    for key in {(span.process, span.thread) for span in recorded.spans}:
        open_spans: list[trace.Span] = []
        for span in recorded.of_thread(*key):
            while open_spans and open_spans[-1].end <= span.begin:
                open_spans.pop()
            assert not open_spans or span.end <= open_spans[-1].end, (open_spans[-1], span)
            open_spans.append(span)


def test_synchronous_operations_by_name(instance: spear.Instance, client: spear.Instance, actor: spear.UnrealObject, tmp_path: Path) -> None:
    file = tmp_path / "trace.json"
    with client.trace(file, operations=True):
        instance.step(1)
        with client.begin_frame():
            actor.SetActorScale3D(NewScale3D=spear.FVector(2, 2, 2))
            actor.RootComponent.RelativeScale3D.X.get()
        with client.end_frame():
            pass
        instance.step(1)
    recorded = trace.read(file)
    check_nesting(recorded)
    operations = [span.name for span in recorded.spans if span.category == "operation"]
    assert {"SetActorScale3D", "RootComponent.RelativeScale3D.X"} <= set(operations)
    (begin_work,) = of_client(recorded, "begin work", client)
    within = [span.name for span in recorded.spans if span.category == "operation" and begin_work.begin <= span.begin and span.end <= begin_work.end]
    assert within == ["SetActorScale3D", "RootComponent.RelativeScale3D.X"]
    summary = trace.summarise(recorded)
    assert len(summary) == 1 and summary[0].frames > 0 and summary[0].transactions >= 1
    assert "waiting for clients" in trace.describe(summary, 0)


def test_full_buffers_drop_and_count(client: spear.Instance, tmp_path: Path) -> None:
    file = tmp_path / "trace.json"
    with client.trace(file, events_per_thread=10):
        client.step(20, single_step=True)  # twenty frames: more than ten events of the game thread
        client.step(1)
    assert trace.read(file).dropped > 0
    assert "were dropped" in trace.describe([], 5)


def test_one_recording_at_a_time(instance: spear.Instance, client: spear.Instance, tmp_path: Path) -> None:
    recording = client.trace(tmp_path / "one.json")
    with pytest.raises(spear.ArgumentError, match="recorded already"):
        client.trace(tmp_path / "two.json")
    instance.call("trace_service.start", operations=False, events_per_thread=100)  # as another program would
    with pytest.raises(spear.UnknownObject, match="another one"):
        recording.stop()
    recording.stop()
    assert trace.read(tmp_path / "one.json").game_threads() == []  # this program alone
    with pytest.raises(spear.LimitExceeded, match="max_trace_events"):
        client.trace(tmp_path / "three.json", events_per_thread=1 << 40)
    with pytest.raises(spear.ConnectionError, match="cannot be written"):
        client.trace(tmp_path / "no" / "folder.json").stop()


def test_merge(tmp_path: Path) -> None:
    for number, base in enumerate((5000, 2000)):
        event = {"ph": "X", "name": "world tick", "cat": "game", "pid": number, "tid": 1, "ts": 1.0, "dur": 2.0, "args": {}}
        document = {"traceEvents": [event], "otherData": {"clock_base_ns": base, "dropped_events": 1}}
        (tmp_path / f"{number}.json").write_text(json.dumps(document))
    trace.merge([tmp_path / "0.json", tmp_path / "1.json"], tmp_path / "all.json")
    recorded = trace.read(tmp_path / "all.json")
    assert [(span.process, span.begin) for span in recorded.spans] == [(0, 4.0), (1, 1.0)] and recorded.dropped == 2
    (tmp_path / "none.json").write_text("{}")
    with pytest.raises(ValueError, match="is no trace"):
        trace.read(tmp_path / "none.json")
