# SPDX-License-Identifier: MIT
"""Objects, functions and variables from Python, against a real engine process."""

from collections.abc import Iterator

import numpy as np
import pytest

import spear


@pytest.fixture
def actor(instance: spear.Instance, game: spear.Game) -> Iterator[spear.UnrealObject]:
    """An actor, within an open begin_frame block."""
    with instance.begin_frame():
        spawned = game.spawn_actor("ACoordinateAxes", location=spear.FVector(1, 2, 3), tags=["test"])
        try:
            yield spawned
        finally:
            if spawned.is_valid():
                game.destroy_actor(spawned)
    with instance.end_frame():
        pass


def test_functions_take_keywords_positions_and_defaults(actor: spear.UnrealObject) -> None:
    actor.SetActorScale3D(NewScale3D=spear.FVector(4, 4, 4))
    assert actor.GetActorScale3D() == spear.FVector(4, 4, 4)
    actor.SetActorScale3D({"X": 1, "Y": 2, "Z": 3})
    assert actor.GetActorScale3D() == {"X": 1, "Y": 2, "Z": 3}
    actor.SetActorScale3D(np.array([5.0, 6.0, 7.0]))
    assert np.array_equal(actor.GetActorScale3D(), [5, 6, 7])
    assert actor.ActorHasTag("TEST")  # names compare without case


def test_out_parameters_come_back_by_name(actor: spear.UnrealObject) -> None:
    result = actor.K2_SetActorLocation(NewLocation=spear.FVector(7, 8, 9), bSweep=False, bTeleport=True)
    assert isinstance(result, tuple) and result.ReturnValue is True and result._fields == ("ReturnValue", "SweepHitResult")
    moved, hit = result
    assert moved is True and hit is result.SweepHitResult is result[1]
    bounds = actor.GetActorBounds(bOnlyCollidingComponents=False)
    origin, extent = bounds
    assert bounds.Origin is origin and bounds.BoxExtent is extent
    assert isinstance(origin, spear.FVector) and extent.X > 0


def test_variables_are_paths_of_any_depth(actor: spear.UnrealObject) -> None:
    assert actor.RootComponent.RelativeLocation.X.get() == 1
    assert actor.RootComponent.RelativeLocation.get() == spear.FVector(1, 2, 3)
    assert actor.Tags.get() == ["test"]
    assert actor.Tags[0].get() == "test"
    assert actor.get("rootcomponent.relativelocation.y") == 2  # names compare without case
    assert actor.async_.CustomTimeDilation.get().get() == 1


def test_plain_assignment_writes(actor: spear.UnrealObject) -> None:
    actor.CustomTimeDilation = 0.5
    assert actor.CustomTimeDilation.get() == 0.5
    actor.Tags = ["one", "two"]
    actor.Tags[1] = "three"
    assert actor.Tags.get() == ["one", "three"]
    actor.RootComponent.ComponentTags = ["deep"]
    assert actor.RootComponent.ComponentTags.get() == ["deep"]


def test_a_path_is_not_its_value(actor: spear.UnrealObject) -> None:
    for use in (lambda m: bool(m), lambda m: m == 1, lambda m: m + 1, lambda m: list(m), lambda m: float(m)):
        with pytest.raises(TypeError, match=r"\.get\(\)"):
            use(actor.CustomTimeDilation)


def test_enums_compare_with_numbers_and_have_names(actor: spear.UnrealObject) -> None:
    mobility = actor.RootComponent.Mobility.get()
    assert mobility.name in ("Static", "Stationary", "Movable") and mobility == int(mobility)
    actor.RootComponent.get().SetMobility(NewMobility="Movable")
    assert actor.RootComponent.Mobility.get().name == "Movable"


def test_static_functions_through_classes(game: spear.Game, actor: spear.UnrealObject) -> None:
    math = game.get_class("UKismetMathLibrary")
    assert math.Add_IntInt(2, 3) == 5
    assert math.VSize(A=spear.FVector(3, 4, 0)) == 5


def test_objects_are_equal_and_hashable(game: spear.Game, actor: spear.UnrealObject) -> None:
    again = game.find_actor_by_name(actor.get_path_name().rsplit(".", 1)[1])
    assert again == actor and len({again, actor}) == 1
    assert actor.RootComponent.get() != actor
    assert "CoordinateAxes" in repr(actor)


def test_completion_knows_functions_and_variables(actor: spear.UnrealObject) -> None:
    names = dir(actor)
    assert {"K2_GetActorLocation", "RootComponent", "SetActorScale3D", "async_"} <= set(names)


def test_finding_in_the_apartment(instance: spear.Instance, game: spear.Game) -> None:
    with instance.begin_frame():
        furniture = game.find_actors_by_tag("furniture")
        lights = game.find_actors_by_class("ALight")
        by_name = game.find_actors_by_tag_as_map("furniture")
    with instance.end_frame():
        pass
    assert len(furniture) >= 20 and len(lights) >= 8 and len(by_name) == len(furniture)


# Bad input: each its own clear error, and the engine goes on ------------------------------------------------------------------


def test_unknown_names_suggest_the_nearest(game: spear.Game, actor: spear.UnrealObject) -> None:
    with pytest.raises(spear.UnknownFunction, match="SetActorScale3D"):
        actor.SetActorScale3(NewScale3D=spear.FVector())
    with pytest.raises(spear.UnknownProperty, match="RootComponent"):
        actor.RootComponen.get()
    with pytest.raises(spear.UnknownClass, match="AStaticMeshActor"):
        game.spawn_actor("AStaticMeshActr")
    with pytest.raises(spear.UnknownArgument, match="NewScale3D"):
        actor.SetActorScale3D(NewScale=spear.FVector())


def test_wrong_values_name_argument_and_type(game: spear.Game, actor: spear.UnrealObject) -> None:
    with pytest.raises(spear.WrongType) as caught:
        actor.SetActorScale3D(NewScale3D="big")
    assert caught.value.argument == "NewScale3D" and "FVector" in str(caught.value)
    with pytest.raises(spear.MissingArgument):
        actor.SetActorScale3D()
    math = game.get_class("UKismetMathLibrary")
    with pytest.raises(spear.OutOfRange, match="int32"):
        math.Add_IntInt(A=2**40, B=1)
    with pytest.raises(spear.WrongType):
        math.Add_IntInt(A=1.5, B=1)
    with pytest.raises(spear.OutOfRange):
        actor.Tags[99].get()


def test_values_without_a_place_on_the_wire(actor: spear.UnrealObject) -> None:
    with pytest.raises(spear.WrongType, match="object"):
        actor.SetActorScale3D(NewScale3D=object())
    endless: list[object] = []
    endless.append(endless)
    with pytest.raises(spear.LimitExceeded):
        actor.SetActorScale3D(NewScale3D=endless)


def test_destroyed_objects_are_stale(game: spear.Game, actor: spear.UnrealObject) -> None:
    game.destroy_actor(actor)
    assert not actor.is_valid()
    with pytest.raises(spear.StaleObject):
        actor.K2_GetActorLocation()


def test_no_engine_and_lost_engine() -> None:
    with pytest.raises(spear.EngineNotRunning, match="spear engine"):
        spear.connect("unix:/tmp/no-such-engine.sock")
    with pytest.raises(spear.LaunchFailed):
        spear.launch(executable="/no/such/engine")
    instance = spear.launch(scene="apartment")
    instance.close()
    with pytest.raises(spear.Disconnected):
        instance.get_worlds()
    instance.close()  # harmless


# Unreal's inconvenient semantics, as they are ---------------------------------------------------------------------------------


def test_writing_relative_location_raw_moves_nothing_until_a_setter_runs(game: spear.Game, actor: spear.UnrealObject) -> None:
    root = actor.RootComponent.get()
    root.SetMobility(NewMobility="Movable")
    root.RelativeLocation = spear.FVector(100, 0, 0)
    assert root.RelativeLocation.X.get() == 100
    assert actor.K2_GetActorLocation() == spear.FVector(1, 2, 3)
    root.K2_SetRelativeLocation(NewLocation=spear.FVector(200, 0, 0), bSweep=False, bTeleport=False)
    assert actor.K2_GetActorLocation() == spear.FVector(200, 0, 0)


def test_const_references_are_inputs_and_take_literals(game: spear.Game, actor: spear.UnrealObject) -> None:
    # `const FVector&` carries CPF_OutParm in the engine; it must be neither demanded back nor returned.
    result = game.get_class("UGameplayStatics").GetActorArrayAverageLocation(Actors=[actor, actor])
    assert result == spear.FVector(1, 2, 3)


def test_destroyed_actors_linger_but_are_stale(instance: spear.Instance, game: spear.Game) -> None:
    with instance.begin_frame():
        actor = game.spawn_actor("ACoordinateAxes", name="Lingering")
        game.destroy_actor(actor)
        with pytest.raises(spear.StaleObject, match="Lingering"):
            actor.K2_GetActorLocation()
        assert game.find_actors_by_name("Lingering") == []
    with instance.end_frame():
        pass


def test_copies_share_the_object(in_block: spear.Game) -> None:
    import copy

    actor = in_block.spawn_actor("ACameraActor")
    assert copy.copy(actor) is actor and copy.deepcopy({"a": [actor]}) == {"a": [actor]}
    hit = spear.structs.struct_class("FHitResult")(Time=0.5, HitObjectHandle=actor)
    assert hit.copy() == hit and hit.copy().HitObjectHandle == actor
    with pytest.raises(TypeError, match="cannot create 'UnrealObject' instances"):
        spear.UnrealObject()
    in_block.destroy_actor(actor)
