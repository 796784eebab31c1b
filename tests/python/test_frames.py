# SPDX-License-Identifier: MIT
"""The programming model from Python, against a real engine process (guarantees of docs/programming_model.md)."""

import threading

import pytest

import spear


def frame_number(instance: spear.Instance) -> int:
    return instance.call("engine_service.get_frame_number")


def test_g1_both_blocks_run_in_one_frame(instance: spear.Instance, game: spear.Game) -> None:
    system = game.get_class("UKismetSystemLibrary")
    with instance.begin_frame():
        begin = system.GetFrameCount()
    with instance.end_frame():
        end = system.GetFrameCount()
    assert begin == end


def test_g1_program_order_sync_and_async_mixed(instance: spear.Instance, game: spear.Game) -> None:
    with instance.begin_frame():
        actor = game.spawn_actor("ACoordinateAxes")
        for x in range(5):
            actor.send_.SetActorScale3D(NewScale3D=spear.FVector(x + 1, 1, 1))
            scale = actor.async_.GetActorScale3D()
            assert actor.GetActorScale3D().X == x + 1
            assert scale.get().X == x + 1
    with instance.end_frame():
        game.destroy_actor(actor)


def test_g2_single_step_holds_the_engine(instance: spear.Instance, game: spear.Game) -> None:
    system = game.get_class("UKismetSystemLibrary")
    frames = []
    for _ in range(5):
        with instance.begin_frame():
            frames.append(system.GetFrameCount())
        with instance.end_frame(single_step=True):
            pass
    with instance.begin_frame():
        pass
    with instance.end_frame():
        pass
    assert frames == list(range(frames[0], frames[0] + 5))


def test_g3_futures_give_the_result_later_and_from_any_thread(instance: spear.Instance, game: spear.Game) -> None:
    with instance.begin_frame():
        actor = game.async_.spawn_actor("ACoordinateAxes", location=(1, 2, 3))
        location = actor.object.async_.K2_GetActorLocation()
    with instance.end_frame():
        pass
    assert location.get() == spear.FVector(1, 2, 3)
    results: list[object] = []
    thread = threading.Thread(target=lambda: results.append(location.get()))
    thread.start()
    thread.join()
    assert results == [spear.FVector(1, 2, 3)]
    with instance.begin_frame():
        game.destroy_actor(actor)
    with instance.end_frame():
        pass


def test_g6_a_failure_does_not_stop_what_follows(instance: spear.Instance, game: spear.Game) -> None:
    with instance.begin_frame():
        actor = game.spawn_actor("ACoordinateAxes")
        with pytest.raises(spear.UnknownFunction):
            actor.NoSuchFunction()
        bad = actor.async_.K2_SetActorLocation(NewLocation="nowhere", bSweep=False, bTeleport=False)
        good = actor.async_.K2_GetActorLocation()
    with instance.end_frame():
        game.destroy_actor(actor)
    with pytest.raises(spear.WrongType) as caught:
        bad.get()
    assert caught.value.argument == "NewLocation" and "FVector" in caught.value.expected
    assert good.get() == spear.FVector(0, 0, 0)


def test_g8_futures_as_arguments_in_any_position(instance: spear.Instance, game: spear.Game) -> None:
    with instance.begin_frame():
        one = game.async_.spawn_actor("ACoordinateAxes", location=(10, 20, 30))
        two = game.async_.spawn_actor("ACoordinateAxes")
        where = one.object.async_.K2_GetActorLocation()
        two.object.async_.SetActorScale3D(NewScale3D=where)
        scale = two.object.async_.GetActorScale3D()
        third = game.async_.spawn_actor("ACoordinateAxes", location={"X": 1, "Y": 2, "Z": 3}, owner=one)
        owner = third.object.async_.GetOwner()
    with instance.end_frame():
        for actor in (third, two, one):
            game.destroy_actor(actor)
    assert scale.get() == spear.FVector(10, 20, 30)
    assert owner.get() == one.get()


def test_g8_a_failed_input_fails_its_dependants(instance: spear.Instance, game: spear.Game) -> None:
    with instance.begin_frame():
        nothing = game.async_.find_actor_by_name("NoSuchActor")
        dependant = nothing.object.async_.K2_GetActorLocation()
    with instance.end_frame():
        pass
    with pytest.raises(spear.UnknownObject):
        nothing.get()
    with pytest.raises(spear.DependencyFailed) as caught:
        dependant.get()
    assert isinstance(caught.value.__cause__, spear.UnknownObject)


def test_g10_the_engine_ticks_between_transactions(instance: spear.Instance) -> None:
    first = frame_number(instance)
    instance.step(1)
    assert frame_number(instance) > first


def test_outside_of_a_block(instance: spear.Instance, game: spear.Game) -> None:
    with pytest.raises(spear.NotInFrame, match="begin_frame"):
        game.spawn_actor("ACoordinateAxes")


def test_blocks_do_not_nest_and_come_in_pairs(instance: spear.Instance) -> None:
    with instance.begin_frame():
        with pytest.raises(spear.FrameMisuse):
            instance.begin_frame().__enter__()
    with instance.end_frame():
        pass
    with pytest.raises(spear.FrameMisuse):
        instance.end_frame().__enter__()


def test_another_thread_has_no_part_in_a_block(instance: spear.Instance, game: spear.Game) -> None:
    caught: list[BaseException] = []

    def intrude() -> None:
        try:
            game.find_actors_by_class("AActor")
        except spear.Error as error:
            caught.append(error)

    with instance.begin_frame():
        thread = threading.Thread(target=intrude)
        thread.start()
        thread.join()
    with instance.end_frame():
        pass
    assert [type(error) for error in caught] == [spear.WrongThread]


def test_a_block_left_by_an_exception_closes_the_transaction(instance: spear.Instance, game: spear.Game) -> None:
    with pytest.raises(ZeroDivisionError):
        with instance.begin_frame():
            actor = game.spawn_actor("ACoordinateAxes")
            1 / 0
    with instance.begin_frame():  # not an end_frame: the transaction is over
        assert actor.is_valid()
        game.destroy_actor(actor)
    with instance.end_frame():
        pass


def test_fire_and_forget_failures_are_reported(instance: spear.Instance, game: spear.Game) -> None:
    with instance.begin_frame():
        actor = game.spawn_actor("ACoordinateAxes")
    with pytest.raises(spear.StaleObject):
        with instance.end_frame():
            game.destroy_actor(actor)
            actor.send_.SetActorScale3D(NewScale3D=spear.FVector(1, 1, 1))
    with instance.begin_frame():
        actor.send_.SetActorScale3D(NewScale3D=spear.FVector(1, 1, 1))  # an all-asynchronous block: nothing need be known when it closes
    with pytest.raises(spear.StaleObject):  # but whoever next waits for the engine hears of it: the close of a block, or a flush
        with instance.end_frame():
            pass
        instance.flush()
