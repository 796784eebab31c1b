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


def test_g1_the_calls_of_both_blocks_run_in_program_order(round_trip: spear.Instance) -> None:
    calls = round_trip.get_game().get_class("URoundTripCalls")
    order: list[object] = []
    for block in (round_trip.begin_frame, round_trip.end_frame):
        with block():
            for _ in range(3):
                order.append(calls.async_.Ticket())
                calls.send_.Ticket()
                order.append(calls.Ticket())
    first = order[0].get()
    numbers = [entry if isinstance(entry, int) else entry.get() for entry in order]
    assert numbers == [first + 3 * (i // 2) + 2 * (i % 2) for i in range(12)]


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


def test_get_waits_without_pythons_lock(instance: spear.Instance, game: spear.Game) -> None:
    results: list[object] = []
    with instance.begin_frame():
        frame = game.get_class("UKismetSystemLibrary").async_.GetFrameCount()
        thread = threading.Thread(target=lambda: results.append(frame.get()))
        thread.start()
        while not thread.is_alive():
            pass
        sum(range(100_000))  # the other thread waits for this one to close the block
    with instance.end_frame():
        pass
    thread.join()
    assert results == [frame.get()]


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


def test_g9_g10_stepping_by_unpausing_and_pausing_is_exact(instance: spear.Instance, game: spear.Game) -> None:
    statics = game.get_class("UGameplayStatics")
    with instance.begin_frame():
        statics.SetGamePaused(bPaused=True)
    with instance.end_frame():
        pass
    last = None
    for _ in range(5):
        with instance.begin_frame():
            statics.SetGamePaused(bPaused=False)
            begin = statics.GetTimeSeconds()
        with instance.end_frame():
            statics.SetGamePaused(bPaused=True)
            end = statics.GetTimeSeconds()
        assert end - begin == pytest.approx(0.01, rel=1e-6)
        assert last is None or begin == last  # to the last bit: nothing was simulated meanwhile
        last = end
        before = frame_number(instance)
        while frame_number(instance) < before + 3:  # the engine goes on in between
            pass
    with instance.begin_frame():
        statics.SetGamePaused(bPaused=False)
    with instance.end_frame():
        pass


def test_g10_the_engine_ticks_between_transactions(instance: spear.Instance) -> None:
    first = frame_number(instance)
    instance.step(1)
    assert frame_number(instance) > first


def test_outside_of_a_block_and_between_blocks(instance: spear.Instance, game: spear.Game) -> None:
    def check(actor: spear.UnrealObject) -> None:
        with pytest.raises(spear.NotInFrame, match="begin_frame|end_frame"):
            game.spawn_actor("ACoordinateAxes")
        with pytest.raises(spear.NotInFrame):
            actor.K2_GetActorLocation()
        with pytest.raises(spear.NotInFrame):
            actor.async_.K2_GetActorLocation()
        with pytest.raises(spear.NotInFrame):
            actor.send_.K2_DestroyActor()

    with instance.begin_frame():
        actor = game.spawn_actor("ACoordinateAxes")
    check(actor)
    with instance.end_frame():
        game.destroy_actor(actor)
    check(actor)


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


def test_an_end_block_left_by_an_exception_closes_the_transaction(instance: spear.Instance, game: spear.Game) -> None:
    with instance.begin_frame():
        actor = game.spawn_actor("ACoordinateAxes")
    with pytest.raises(ZeroDivisionError):
        with instance.end_frame(single_step=True):  # what an exception leaves does not hold the engine
            actor.send_.SetActorScale3D(NewScale3D=spear.FVector(5, 1, 1))
            1 / 0
    before = frame_number(instance)
    while frame_number(instance) < before + 3:
        pass
    with instance.begin_frame():
        assert actor.GetActorScale3D().X == 5  # what was recorded has run
        game.destroy_actor(actor)
    with instance.end_frame():
        pass


def test_misused_blocks_leave_the_session_usable(instance: spear.Instance, game: spear.Game) -> None:
    with pytest.raises(spear.FrameMisuse):
        instance.end_frame().__enter__()
    with instance.begin_frame():
        for misuse in (instance.begin_frame().__enter__, instance.end_frame().__enter__, instance.flush, instance.step):
            with pytest.raises(spear.FrameMisuse):
                misuse()
        assert game.find_actors_by_class("AActor")
    with pytest.raises(spear.FrameMisuse):
        instance.begin_frame().__enter__()
    with instance.end_frame():
        pass
    instance.step(2)


def test_a_result_that_needs_frames_is_not_waited_for_while_the_engine_is_held(instance: spear.Instance, game: spear.Game) -> None:
    system = game.get_class("UKismetSystemLibrary")
    with instance.begin_frame():
        delay = system.async_.Delay(Duration=0.03)
        assert game.find_actors_by_class("AActor")  # holds the engine
        with pytest.raises(spear.NeedsFrames, match="Delay"):
            delay.get()
    with instance.end_frame(single_step=True):
        pass
    with pytest.raises(spear.NeedsFrames):
        delay.get()
    with instance.begin_frame():
        pass
    with instance.end_frame():
        pass
    delay.get()


def test_a_garbage_collection_between_begin_and_end(instance: spear.Instance, game: spear.Game) -> None:
    system = game.get_class("UKismetSystemLibrary")
    with instance.begin_frame():
        doomed = game.spawn_actor("ACoordinateAxes")
        kept = game.new_object("UProjectileMovementComponent")
        game.destroy_actor(doomed)
        system.CollectGarbage()  # in this frame, after the world's tick
        frame = system.GetFrameCount()
    with instance.end_frame():
        with pytest.raises(spear.StaleObject):
            doomed.K2_GetActorLocation()
        assert kept.is_valid()
        assert system.GetFrameCount() == frame
        game.release_object(kept)


def test_a_map_load_between_begin_and_end() -> None:
    with spear.launch(scene="", fixed_dt=0.01, fps=0, deadline=120) as instance:
        game = instance.get_game()
        statics, system = game.get_class("UGameplayStatics"), game.get_class("UKismetSystemLibrary")
        with instance.begin_frame():
            level = statics.GetCurrentLevelName()
            actor = game.spawn_actor("ACameraActor")
            statics.OpenLevel(LevelName=level)  # travels in this frame's tick
            frame = system.GetFrameCount()
        with instance.end_frame():
            with pytest.raises(spear.StaleObject):
                actor.K2_GetActorLocation()
            other = game.spawn_actor("ACameraActor")
            assert statics.GetCurrentLevelName() == level
            assert system.GetFrameCount() == frame
        instance.step(2)
        with instance.begin_frame():
            assert other.is_valid() and not actor.is_valid()
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
