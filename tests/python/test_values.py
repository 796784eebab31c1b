# SPDX-License-Identifier: MIT
"""Values of structs, enums, results and null objects, as a running engine takes and gives them."""

from __future__ import annotations

import copy
import enum
import pickle
import warnings

import pytest

import spear
from spear import enums, facts, nulls
from spear.unreal.Engine import AActor, ACoordinateAxes, ECollisionChannel, FHitResult, FVector_NetQuantize
from spear.unreal.RoundTrip import ERoundTripLegacy, ERoundTripMode, FRoundTripRecord  # no facts of it anywhere: learned from the engine

# Structs ----------------------------------------------------------------------------------------------------------------------------------


def test_omitted_fields_take_unreals_defaults(things: spear.UnrealObject) -> None:
    record = things.EchoRecord(FRoundTripRecord(Title="given", Place=spear.FVector(1, 2, 3)))
    assert record == {"Count": 3, "bOn": True, "Title": "given", "Place": spear.FVector(1, 2, 3), "Samples": [], "Scores": {}}
    assert type(record) is FRoundTripRecord and things.EchoRecord(FRoundTripRecord()).Title == "untitled"
    assert things.EchoRecord(record) == record and things.EchoRecord(Value={"Count": 9}).Count == 9
    assert things.EchoRecordArray([FRoundTripRecord(Count=1), {"Count": 2}, record])[1].Title == "untitled"


def test_omitted_fields_of_a_variable_stay_as_they_are(things: spear.UnrealObject) -> None:
    things.RecordValue = FRoundTripRecord(Count=7, Title="first")
    things.RecordValue = FRoundTripRecord(Title="second")
    assert things.RecordValue.Count.get() == 7 and things.RecordValue.get().Title == "second"


def test_unset_fields_have_no_value() -> None:
    hit = FHitResult(Time=0.5)
    with pytest.raises(AttributeError, match="was not given"):
        hit.Distance  # noqa: B018
    assert repr(hit) == "FHitResult(Time=0.5)" and hit.to_dict() == {"Time": 0.5} and hit == {"Time": 0.5} and hit != FHitResult()
    hit.Distance = 2
    assert hit == FHitResult(Time=0.5, Distance=2)
    assert copy.deepcopy(hit) == hit == pickle.loads(pickle.dumps(hit)) == hit.copy()
    assert "Distance" in dir(FHitResult())


def test_wrong_fields_name_the_nearest() -> None:
    with pytest.raises(TypeError, match="'Distance'"):
        FHitResult(Distanse=2)
    with pytest.raises(AttributeError, match="'Distance'"):
        FHitResult().Distanse = 2
    with pytest.raises(TypeError, match="FHitResult has 19 fields"):
        FHitResult(*range(20))
    with pytest.raises(TypeError, match="twice"):
        FHitResult(1, FaceIndex=2)


def test_structs_without_fields_known_are_the_engines_affair(round_trip: spear.Instance, things: spear.UnrealObject) -> None:
    from spear.structs import struct_class

    loose = struct_class("FNobodyKnows")
    assert things.EchoRecord(loose(Count=4)).Count == 4
    with pytest.raises(spear.WrongType, match="Count"):
        things.EchoRecord(loose(Coumt=4))


def test_derived_structs_are_their_bases(in_block: spear.Game) -> None:
    assert issubclass(FVector_NetQuantize, spear.FVector) and FVector_NetQuantize(1, 2, 3).to_numpy().tolist() == [1, 2, 3]
    actor = in_block.spawn_actor(ACoordinateAxes)
    actor.SetActorScale3D(FVector_NetQuantize(1, 2, 3))
    assert actor.GetActorScale3D() == spear.FVector(1, 2, 3)
    hit = actor.K2_SetActorLocation(NewLocation=spear.FVector(), bSweep=False, bTeleport=True).SweepHitResult
    assert type(hit) is FHitResult and isinstance(hit.Location, FVector_NetQuantize)
    in_block.destroy_actor(actor)


def test_fields_of_the_engine_join_those_of_facts() -> None:
    from spear.structs import announced, struct_class

    old = struct_class("FGrown", ["A", "Gone"])
    value = old(A=1, Gone=2)
    cls, attributes = announced("FGrown", "/Script/Nowhere.Grown", ["New One", "A"])
    assert cls is old and attributes == ("New_One", "A") and set(cls.field_names) == {"New One", "A", "Gone"}
    assert value == {"A": 1, "Gone": 2} and cls(New_One=3).to_dict() == {"New One": 3}


def test_subclasses_of_users_do_not_take_a_structs_place() -> None:
    class Mine(spear.FVector):
        __slots__ = ()

    from spear.structs import struct_class

    assert struct_class("FVector") is spear.FVector and Mine(1, 2, 3) == spear.FVector(1, 2, 3)


# Enums ------------------------------------------------------------------------------------------------------------------------------------


def test_enums_know_unreals_names() -> None:
    pawn = ECollisionChannel("ECC_Pawn")
    assert pawn is ECollisionChannel.ECC_Pawn is ECollisionChannel("ECollisionChannel::ECC_Pawn") is ECollisionChannel("ecc_pawn") is ECollisionChannel(2)
    assert isinstance(pawn, enum.IntEnum) and pawn == 2 and pawn.name == "ECC_Pawn" and issubclass(ECollisionChannel, spear.UnrealEnum)
    for wrong in ("ECC_Pwan", "EOther::ECC_Pawn", 99):
        with pytest.raises(ValueError, match="ECC_Pawn" if isinstance(wrong, str) else "99"):
            ECollisionChannel(wrong)
    with pytest.raises(AttributeError, match="ECC_Pawn"):
        ECollisionChannel.ECC_Pwan
    assert pickle.loads(pickle.dumps(pawn)) is pawn


def test_the_engines_values_are_members_of_the_same_class(things: spear.UnrealObject) -> None:
    assert things.EchoEnum(ERoundTripMode.Fast) is ERoundTripMode.Fast and things.EchoEnum("Reckless") is ERoundTripMode.Reckless
    assert things.EchoEnum(7) is ERoundTripMode.Reckless and things.EchoByteEnum(ERoundTripLegacy.RTL_Second) is ERoundTripLegacy.RTL_Second
    things.EnumValue = ERoundTripMode.Fast
    assert things.EnumValue.get() is ERoundTripMode.Fast
    assert things.EchoEnumMap({ERoundTripMode.Fast: "f", "Slow": "s"}) == {ERoundTripMode.Fast: "f", ERoundTripMode.Slow: "s"}
    things.EnumMapValue = {ERoundTripMode.Fast: "f"}
    assert things.EnumMapValue[ERoundTripMode.Fast].get() == "f"
    assert things.EchoInt32(ERoundTripMode.Reckless) == 7
    with pytest.raises(spear.WrongType, match="ERoundTripMode"):
        things.EchoEnum(ERoundTripLegacy.RTL_First)
    with pytest.raises(spear.OutOfRange):
        things.EchoInt8(enums.announced("EHuge", "", False, [("Huge", 1 << 40)])[0].Huge)


def test_enums_of_bits_combine(things: spear.UnrealObject) -> None:
    from spear.unreal.RoundTrip import ERoundTripBits

    assert issubclass(ERoundTripBits, spear.UnrealFlags)
    both = ERoundTripBits.Left | ERoundTripBits.Up
    assert things.EchoBits(both) == both and type(things.EchoBits(both)) is ERoundTripBits and things.EchoBits(ERoundTripBits.None_) == 0
    assert ERoundTripBits("Left | Up") == both and ERoundTripBits.Left in things.EchoBits(both)


def test_an_engine_with_other_numbers_gets_and_gives_the_entry_that_was_meant(things: spear.UnrealObject) -> None:
    """Classes as of stubs of another version: their members travel by name."""
    from spear.unreal.RoundTrip import ERoundTripBits

    other = enums._make("ERoundTripLegacy", "", False)
    bits = enums._make("ERoundTripBits", "", True)
    try:
        enums._add(other, [("RTL_New", 0), ("RTL_First", 1), ("RTL_Second", 2)])
        enums._add(bits, [("Right", 1), ("Left", 2), ("Down", 8)])
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # no value comes back here, so nothing warns; but it may
            assert int(things.EchoByteEnum(other.RTL_Second)) == 1 and int(things.EchoByteEnum(other.RTL_First)) == 0
            with pytest.raises(spear.OutOfRange, match="no entry 'RTL_New'"):
                things.EchoByteEnum(other.RTL_New)
            assert things.EchoBits(bits.Left).name == "Left"
            assert {member.name for member in things.EchoBits(bits.Right | bits.Left)} == {"Right", "Left"}
            with pytest.raises(spear.OutOfRange, match="no entry 'Down'"):
                things.EchoBits(bits.Left | bits.Down)
    finally:
        enums._classes["ERoundTripLegacy"] = ERoundTripLegacy
        enums._classes["ERoundTripBits"] = ERoundTripBits
    with pytest.warns(UserWarning, match="spear schema stubs"):
        cls, members, combination = enums.announced("EMoved", "", True, [("A", 1)]) and enums.announced("EMoved", "", True, [("A", 4), ("B", 2)])
    assert members[4].name == "A" and combination is not None and combination(6) == cls.A | cls.B and cls.A == 1


# Results ----------------------------------------------------------------------------------------------------------------------------------


def test_several_outputs_are_a_named_tuple(calls: spear.UnrealObject) -> None:
    result = calls.Split("left|right")
    found, left, right = result
    assert (found, left, right) == result == (True, "left", "right") and result.Left == result[1] == "left" and len(result) == 3
    assert isinstance(result, tuple) and isinstance(result, spear.Result) and result._asdict() == {"ReturnValue": True, "Left": "left", "Right": "right"}
    assert repr(result) == "Split_Result(ReturnValue=True, Left='left', Right='right')"
    assert pickle.loads(pickle.dumps(result)) == result and type(pickle.loads(pickle.dumps(result))) is type(result)
    with pytest.raises(AttributeError, match="'Left'"):
        result.Lefft
    assert calls.async_.Split("a|b").get().Right == "b"
    match result:
        case (True, first, _):
            assert first == "left"
        case _:
            raise AssertionError


def test_one_out_parameter_alone_is_a_tuple_of_one(calls: spear.UnrealObject, things: spear.UnrealObject) -> None:
    assert calls.Increment(41) == (42,) and calls.Increment(41).Value == 42
    (copied,) = things.CopyRecord(FRoundTripRecord(Count=2))
    assert copied.Count == 2


def test_results_can_be_asked_for_their_annotation(calls: spear.UnrealObject) -> None:
    from spear.unreal.RoundTrip import URoundTripCalls_Increment_Result, URoundTripCalls_Split_Result

    assert isinstance(calls.Split("a|b"), URoundTripCalls_Split_Result) and not isinstance(calls.Increment(1), URoundTripCalls_Split_Result)
    assert isinstance(calls.Increment(1), URoundTripCalls_Increment_Result)


# Null objects -----------------------------------------------------------------------------------------------------------------------------


def test_a_null_variable_raises_and_get_or_none_does_not(things: spear.UnrealObject) -> None:
    for name in ("ObjectValue", "ActorValue", "ClassValue", "WeakValue", "LazyValue", "InterfaceValue"):
        path = getattr(things, name)
        with pytest.raises(spear.NullObject, match=f"{name}.*get_or_none"):
            path.get()
        assert path.get_or_none() is None and things.get(name) is None
        future = path.async_.get()
        with pytest.raises(spear.NullObject, match=name):
            future.get()
        with pytest.raises(spear.NullObject, match=name):
            getattr(things.async_, name).get().get()
        assert path.async_.get_or_none().get() is None and things.async_.get(name).get() is None
    assert things.SoftObjectValue.get() == "" and things.OptionalValue.get() is None
    things.ObjectValue = things
    assert things.ObjectValue.get() == things == things.ObjectValue.get_or_none()
    things.ObjectValue = None
    assert things.ObjectValue.get_or_none() is None


@pytest.fixture
def never_null(monkeypatch: pytest.MonkeyPatch):
    """Facts that EchoActor, the second actor of Pair, and elements of EchoObjectArray are never null."""
    told = {
        "URoundTrip": {"super": "UObject", "never_null": ["EchoActor", "EchoObjectArray[]", "CopyObjectArray.Result[]"]},
        "URoundTripCalls": {"super": "UObject", "never_null": ["Pair.OutSecond"]},
    }
    monkeypatch.setattr(nulls.facts, "class_facts", lambda name: told.get(name))


def test_null_results_of_functions_that_never_return_null(in_block: spear.Game, things: spear.UnrealObject, calls: spear.UnrealObject, never_null: None) -> None:
    actor = in_block.spawn_actor(ACoordinateAxes)
    assert things.EchoActor(actor) == actor
    with pytest.raises(spear.NullObject, match="URoundTrip::EchoActor .*call"):
        things.EchoActor(None)
    with pytest.raises(spear.NullObject, match="EchoActor"):
        things.echoactor(Value=None)
    future = things.async_.EchoActor(None)
    with pytest.raises(spear.NullObject, match="EchoActor"):
        future.get()
    assert things.call("EchoActor", None) is None and things.async_.call("EchoActor", None).get() is None
    assert things.EchoObject(None) is None
    # In a tuple of outputs, and in a container.
    assert calls.Pair(None, actor).OutFirst is None and calls.Pair(actor, actor).ReturnValue is True
    with pytest.raises(spear.NullObject, match="as OutSecond"):
        calls.Pair(actor, None)
    assert things.EchoObjectArray([actor]) == [actor]
    with pytest.raises(spear.NullObject, match="container"):
        things.EchoObjectArray([actor, None])
    with pytest.raises(spear.NullObject, match="as Result in the container"):
        things.CopyObjectArray([None])
    assert things.CopyObjectArray([actor]).Result == [actor] and things.call("CopyObjectArray", [None]) == ([None],)
    # Of an object that is a future itself.
    things.ObjectValue = things
    deferred = things.async_.ObjectValue.get().object.async_.EchoActor(None)
    with pytest.raises(spear.NullObject, match="EchoActor"):
        deferred.get()
    in_block.destroy_actor(actor)


def test_facts_of_the_package_say_so_too(in_block: spear.Game) -> None:
    """With the facts as they are in the package: a function of the engine that never returns null by its facts."""
    assert "K2_GetRootComponent" in (facts.class_facts("AActor") or {}).get("never_null", ())
    actor = in_block.spawn_actor(AActor)
    if actor.RootComponent.get_or_none() is None:
        with pytest.raises(spear.NullObject, match="AActor::K2_GetRootComponent"):
            actor.GetRootComponent()  # the other spelling
        assert actor.call("K2_GetRootComponent") is None
    in_block.destroy_actor(actor)


# Names ------------------------------------------------------------------------------------------------------------------------------------


def test_names_with_a_meaning_in_python_have_an_underscore(calls: spear.UnrealObject) -> None:
    assert calls.async__(is_=5, lambda_=2) == 3 and calls.async_.async__(5, lambda_=1).get() == 4
    assert calls.call_() == "called" == calls.call("call") and calls.async_.call_().get() == "called"
    assert calls.get_.get() == 17 == calls.get("get")
    calls.get_ = 18
    assert calls.get_.async_.get().get() == 18
    calls.async_.get_ = 19
    assert calls.get("get") == 19
    with pytest.raises(AttributeError, match="get_"):
        calls.get = 3
    assert {"async__", "call_", "get_", "Split"} <= set(dir(calls))


def test_names_that_are_no_identifiers_come_from_facts(monkeypatch: pytest.MonkeyPatch, things: spear.UnrealObject) -> None:
    """As of a Blueprint's variable "Int32 Value"; here facts change a name that is there."""
    from spear import naming

    monkeypatch.setitem(naming.renamed, "An_Int32", {"URoundTrip": "Int32Value"})
    things.An_Int32 = 12
    assert things.An_Int32.get() == 12 == things.Int32Value.get() and things.async_.An_Int32.get().get() == 12
    monkeypatch.setitem(naming.renamed, "Int64Value", {"AOther": "Something else"})
    assert naming.unreal_name_of(things, "Int64Value") in ("Int64Value", "Something else")


def test_own_methods_are_those_of_the_closed_list() -> None:
    from spear.codegen.names import OBJECT_MEMBERS, STRUCT_MEMBERS
    from spear.unreal_object import OBJECT_METHODS, AsyncBase, Member, SendBase

    def public(cls: type) -> set[str]:
        return {name for base in cls.__mro__ if base.__module__.startswith("spear") for name in vars(base) if not name.startswith("_")}

    assert OBJECT_METHODS | {"get_or_none"} == OBJECT_MEMBERS
    assert public(spear.UnrealObject) | {"get_or_none"} == OBJECT_MEMBERS
    for cls in (AsyncBase, SendBase, Member, spear.FutureObject):
        assert public(cls) <= OBJECT_MEMBERS, cls
    for cls in (spear.Struct, spear.FVector, spear.FTransform, spear.FQuat, spear.FColor):
        assert public(cls) - set(cls.field_names) <= STRUCT_MEMBERS, cls


def test_a_path_has_what_its_object_has(in_block: spear.Game, things: spear.UnrealObject) -> None:
    actor = in_block.spawn_actor(ACoordinateAxes)
    things.ActorValue = actor
    path = things.ActorValue
    assert path.get_path_name() == actor.get_path_name() and path.is_valid() and path.call("GetActorScale3D") == spear.FVector(1, 1, 1)
    assert path.get_class() == actor.get_class() and path.get_components("USceneComponent") == actor.get_components("USceneComponent")
    path.set("CustomTimeDilation", 0.5)
    assert path.get("CustomTimeDilation") == 0.5 == path.async_.get("CustomTimeDilation").get()
    future = in_block.async_.find_actor_by_path(actor.get_path_name(), AActor)
    assert future.object.get_path_name() == actor.get_path_name() and future.object.call("GetActorScale3D") == spear.FVector(1, 1, 1)
    assert future.object.is_valid() and future.get() == actor
    in_block.destroy_actor(actor)


def test_twins_of_the_game_are_current(source_directory) -> None:
    import subprocess
    import sys

    result = subprocess.run([sys.executable, source_directory / "python" / "make_game_twins.py", "--check"], capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr


def test_twins_of_the_game(round_trip: spear.Instance) -> None:
    game = round_trip.get_game()
    with round_trip.begin_frame():
        future = game.async_.spawn_actor(ACoordinateAxes, name="Twin", location=(1, 2, 3))
        found = game.async_.find_actor_by_name("Twin", AActor)
        game.send_.destroy_actor(found)
    with round_trip.end_frame():
        assert not game.find_actors_by_name("Twin")
    assert isinstance(future.get(), ACoordinateAxes) and not future.get().is_valid()
    assert game.send_.destroy_actor.__annotations__["return"] == "None" and "Future" in game.async_.destroy_actor.__annotations__["return"]
