# SPDX-License-Identifier: MIT
"""G8 from Python: futures as arguments in every position; the messages that travel; results kept. (docs/guarantees.md)"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator

import pytest

import spear


def eventually(condition: Callable[[], bool]) -> bool:
    """Waits until a condition holds; false if it does not within a time that only a broken program takes."""
    ends = time.monotonic() + 30
    while not condition():
        if time.monotonic() > ends:
            return False
        time.sleep(0.002)
    return True


@pytest.fixture
def client(round_trip: spear.Instance) -> Iterator[spear.Instance]:
    """A session of its own."""
    with spear.connect(round_trip.address, deadline=60) as connected:
        yield connected


@pytest.fixture
def trip(client: spear.Instance) -> spear.UnrealObject:
    with client.begin_frame():
        made = client.get_game().new_object("URoundTrip")
    with client.end_frame():
        pass
    return made


def settled(client: spear.Instance) -> spear.Statistics:
    """All answers are there: both ends have counted the same."""
    client.flush()
    now = client.statistics()
    assert now.sent == now.server_received and now.received == now.server_sent
    return now


def test_g8_futures_in_arrays_sets_maps_structs_and_nested(client: spear.Instance, trip: spear.UnrealObject) -> None:
    before = settled(client)
    with client.begin_frame():
        vector = trip.async_.EchoVector(Value=spear.FVector(1, 2, 3))
        number = trip.async_.EchoDouble(Value=7.5)
        count = trip.async_.EchoInt32(Value=42)
        text = trip.async_.EchoString(Value="text")
        array = trip.async_.EchoVectorArray(Value=[vector, spear.FVector(0, 0, 0), vector])
        names = trip.async_.EchoNameSet(Value=[text, "other"])
        by_name = trip.async_.EchoStringMap(Value={"a": count, "b": 1})
        in_dict = trip.async_.EchoVector(Value={"X": number, "Y": 0, "Z": number})
        in_struct = trip.async_.EchoVector(Value=spear.FVector(number, 0, number))
        record = trip.async_.EchoRecord(Value={"Samples": [number, 1.0, number], "Place": vector, "Title": text})
        records = trip.async_.EchoRecordArray(Value=[{"Place": vector}, {"Samples": [number]}])
        trip.send_.set("VectorArrayValue", array)
        stored = trip.async_.get("VectorArrayValue")
    with client.end_frame():
        in_end = trip.async_.EchoVector(Value=vector)
    after = settled(client)
    assert (after.sent.messages - before.sent.messages, after.received.messages - before.received.messages) == (2, 2)
    one = spear.FVector(1, 2, 3)
    assert array.get() == [one, spear.FVector(0, 0, 0), one] == stored.get()
    assert set(names.get()) == {"text", "other"}
    assert by_name.get() == {"a": 42, "b": 1}
    assert in_dict.get() == in_struct.get() == spear.FVector(7.5, 0, 7.5)
    assert list(record.get().Samples) == [7.5, 1, 7.5] and record.get().Place == one and record.get().Title == "text"
    assert records.get()[0].Place == one and list(records.get()[1].Samples) == [7.5]
    assert in_end.get() == one


def test_g8_futures_of_earlier_transactions_and_dropped_ones(client: spear.Instance, trip: spear.UnrealObject) -> None:
    with client.begin_frame():
        earlier = trip.async_.EchoVector(Value=spear.FVector(1, 2, 3))
    with client.end_frame():
        pass
    client.step(2)
    with client.begin_frame():
        assert trip.EchoVector(Value=earlier) == spear.FVector(1, 2, 3)
        dropped = trip.async_.EchoVector(Value=earlier)
        both = trip.async_.EchoVectorArray(Value=[dropped, dropped])
        del dropped
    with client.end_frame():
        pass
    assert both.get() == [spear.FVector(1, 2, 3)] * 2


def test_g8_a_future_of_another_session_is_refused(round_trip: spear.Instance, client: spear.Instance, trip: spear.UnrealObject) -> None:
    with spear.connect(round_trip.address, deadline=60) as other:
        with other.begin_frame():
            foreign = other.get_game().new_object("URoundTrip").async_.EchoInt32(Value=1)
        with other.end_frame():
            pass
        with client.begin_frame():
            with pytest.raises(spear.WrongType, match="another session"):
                trip.EchoInt32(Value=foreign)
            with pytest.raises(spear.WrongType, match="another session"):
                trip.async_.EchoIntArray(Value=[foreign])
            assert trip.EchoInt32(Value=2) == 2
        with client.end_frame():
            pass


def test_g8_a_failed_input_fails_its_dependants_in_every_position(client: spear.Instance, trip: spear.UnrealObject) -> None:
    with client.begin_frame():
        bad = trip.async_.EchoVector(Value="no vector")
        first = trip.async_.EchoVector(Value=bad)
        dependants = [
            first, trip.async_.EchoVector(Value=first), trip.async_.EchoVectorArray(Value=[bad]), trip.async_.EchoRecord(Value={"Place": bad}),
            trip.async_.EchoVectorMap(Value={"a": bad}), trip.async_.set("VectorValue", bad),
        ]
        fine = trip.async_.EchoInt32(Value=3)
    with client.end_frame():
        pass
    for dependant in dependants:
        with pytest.raises(spear.DependencyFailed) as caught:
            dependant.get()
        original = caught.value.__cause__
        assert isinstance(original, spear.WrongType) and original.operation == "URoundTrip::EchoVector" and original.argument == "Value"
    assert fine.get() == 3


def test_g8_an_all_asynchronous_block_is_one_message_each_way_whatever_its_size(client: spear.Instance, trip: spear.UnrealObject) -> None:
    last = settled(client)
    for operations in (0, 1, 10, 1000, 10_000):
        with client.begin_frame():
            futures = [trip.async_.EchoInt32(Value=i) for i in range(operations)]
        with client.end_frame():
            for i in range(operations):
                trip.send_.EchoInt32(Value=i)
        now = settled(client)
        assert now.sent.messages - last.sent.messages == 2, operations
        assert now.received.messages - last.received.messages == 2, operations
        assert now.sent.bytes - last.sent.bytes >= 20 * operations
        assert [future.get() for future in futures[-3:]] == list(range(operations))[-3:]
        last = now
    with client.begin_frame():
        for i in range(5):
            trip.send_.EchoInt32(Value=i)
            trip.EchoInt32(Value=i)
    with client.end_frame():
        pass
    assert settled(client).sent.messages - last.sent.messages == 5 + 2  # each synchronous call, and the ends of the blocks


def test_dropped_futures_free_their_results_in_the_engine(client: spear.Instance, trip: spear.UnrealObject) -> None:
    def falls_to(count: int) -> bool:
        client.step()  # the engine hears of it with the next message
        return eventually(lambda: client.statistics().kept_results == count)

    assert falls_to(0)
    with client.begin_frame():
        futures = [trip.async_.EchoInt32(Value=i) for i in range(100)]
    with client.end_frame():
        pass
    client.flush()
    assert client.statistics().kept_results == 100
    del futures[10:]
    assert falls_to(10)
    copy = futures[0]
    futures.clear()
    assert falls_to(1)
    assert copy.get() == 0
