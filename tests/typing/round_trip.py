# SPDX-License-Identifier: MIT
"""Every kind of value, statically and in the engine: stubs of the test module RoundTrip, whose classes have one variable and one function of each.

Checked by mypy and pyright with the stubs of RoundTrip beside those of the engine, and run against an engine that has the module loaded.
"""

from __future__ import annotations

from typing_extensions import assert_type

import spear
from spear import Future
from spear.typing import (
    ArrayPath,
    AsyncArrayPath,
    AsyncMapPath,
    AsyncPath,
    AsyncValuePath,
    ClassPath,
    MapPath,
    Path,
    SetPath,
    ValuePath,
)
from spear.unreal.CoreUObject import FColor, FScriptDelegate, FTransform, FVector, FVector_in, FVector_path, UClass, UObject
from spear.unreal.Engine import AActor, USceneComponent
from spear.unreal.RoundTrip import (
    ERoundTripLegacy,
    ERoundTripMode,
    ERoundTripMode_in,
    FRoundTripRecord,
    FRoundTripRecord_path,
    IRoundTripListener,
    URoundTrip,
    URoundTripCalls,
)


def same(found: object, expected: object) -> None:
    """Fails unless two values are equal."""
    if found != expected:
        raise AssertionError(f"found {found!r}, expected {expected!r}")


def plain_values(trip: URoundTrip) -> None:
    assert_type(trip.BoolValue.get(), bool)
    assert_type(trip.Int64Value, Path[int])
    assert_type(trip.DoubleValue.get(), float)
    assert_type(trip.StringValue.get(), str)
    assert_type(trip.NameValue.get(), str)
    assert_type(trip.TextValue.get(), str)
    trip.Int8Value = -5
    same(trip.Int8Value.get(), -5)
    trip.StringValue = "text"
    same(trip.StringValue.get(), "text")
    trip.bBitTwo = True
    same(trip.bBitTwo.get(), True)
    assert_type(trip.EnumValue, ValuePath[ERoundTripMode, ERoundTripMode_in])
    trip.EnumValue = "Reckless"
    same(trip.EnumValue.get(), ERoundTripMode.Reckless)
    trip.ByteEnumValue = ERoundTripLegacy.RTL_Second
    assert_type(trip.ByteEnumValue.get(), ERoundTripLegacy)


def references(trip: URoundTrip, actor: AActor) -> None:
    assert_type(trip.ObjectValue.get_or_none(), UObject | None)
    same(trip.ActorValue.get_or_none(), None)
    trip.ActorValue = actor
    assert_type(trip.ActorValue.get(), AActor)
    same(trip.ActorValue.get(), actor)
    assert_type(trip.ActorValue.bHidden.get(), bool)  # variables of the object referred to
    assert_type(trip.ActorValue.get_component(USceneComponent), USceneComponent)  # as the object itself
    assert_type(trip.ActorValue.async_.get_component(USceneComponent), Future[USceneComponent])
    same(trip.ActorValue.get_component(USceneComponent), actor.RootComponent.get())
    same(trip.ActorValue.is_valid(), True)
    same(trip.ActorValue.get_path_name(), actor.get_path_name())
    same(trip.ActorValue.get("CustomTimeDilation"), 1.0)
    trip.WeakValue = trip.ActorValue.async_.get()  # a future of an object
    assert_type(trip.WeakValue.get(), AActor)
    same(trip.WeakValue.get(), actor)
    trip.ActorValue = None
    same(trip.ActorValue.get_or_none(), None)
    trip.ClassValue = AActor
    assert_type(trip.ClassValue, ClassPath[UClass, type[AActor] | UClass | str | Future[UClass] | None])
    assert_type(trip.ClassValue.get(), UClass)
    assert_type(trip.ClassValue.async_.get_or_none(), Future[UClass | None])
    assert_type(trip.SoftObjectValue.get(), str)
    trip.SoftObjectValue = "/Engine/BasicShapes/Cube.Cube"
    same(trip.SoftObjectValue.get(), "/Engine/BasicShapes/Cube.Cube")
    trip.InterfaceValue = trip  # URoundTrip implements the interface
    assert_type(trip.InterfaceValue.get(), IRoundTripListener)
    trip.InterfaceValue.Hear(7)
    same(trip.LastHeard.get(), 7)


def structs(trip: URoundTrip) -> None:
    assert_type(trip.VectorValue.get(), FVector)
    assert_type(trip.TransformValue.Translation.X.get(), float)
    assert_type(trip.TransformValue.get(), FTransform)
    assert_type(trip.ColorValue.get(), FColor)
    assert_type(trip.RecordValue, FRoundTripRecord_path)
    trip.RecordValue = FRoundTripRecord(Count=3, Title="three", Place=FVector(1, 2, 3), Samples=[1, 2], Scores={"a": 1})
    assert_type(trip.RecordValue.get().Samples, list[float])
    same(trip.RecordValue.get().Scores, {"a": 1})
    trip.RecordValue = {"Count": 4, "Place": {"X": 9}}
    same(trip.RecordValue.Count.get(), 4)
    same(trip.RecordValue.Title.get(), "three")  # a dictionary leaves out what stays
    trip.RecordValue.Place.Z = 5
    same(trip.RecordValue.Place.get(), FVector(9, 2, 5))
    assert_type(trip.async_.RecordValue.Place.Z.get(), Future[float])
    assert_type(trip.RecordValue.Scores["a"], Path[int])
    assert_type(trip.async_.RecordValue.Samples, AsyncArrayPath[float, float | Future[float], AsyncPath[float]])


def containers(trip: URoundTrip) -> None:
    trip.IntArrayValue = [1, 2, 3]
    assert_type(trip.IntArrayValue.get(), list[int])
    same(trip.IntArrayValue[2].get(), 3)
    trip.IntArrayValue[2] = 30
    trip.ByteArrayValue = b"ab"
    same(trip.ByteArrayValue.get(), [97, 98])
    assert_type(trip.VectorArrayValue[0], FVector_path)
    trip.VectorArrayValue = [FVector(1, 2, 3), {"X": 4}, [5, 6, 7]]
    same(trip.VectorArrayValue[2].Y.get(), 6.0)
    assert_type(trip.ObjectArrayValue.get(), list[AActor | None])
    trip.ObjectArrayValue = [None]
    same(trip.ObjectArrayValue.get(), [None])
    trip.NameSetValue = {"one", "two"}
    assert_type(trip.NameSetValue, SetPath[str, str | Future[str]])
    assert_type(trip.NameSetValue.get(), set[str])
    same(trip.NameSetValue.get(), {"one", "two"})
    trip.StringMapValue = {"a": 1}
    trip.StringMapValue["b"] = 2
    assert_type(trip.StringMapValue["b"].get(), int)
    same(trip.StringMapValue.get(), {"a": 1, "b": 2})
    assert_type(trip.async_.StringMapValue, AsyncMapPath[str, int, int | Future[int], AsyncPath[int]])
    trip.EnumMapValue = {ERoundTripMode.Fast: "fast"}
    assert_type(trip.EnumMapValue, MapPath[ERoundTripMode, str, str | Future[str], Path[str], AsyncPath[str]])
    same(trip.EnumMapValue.get(), {ERoundTripMode.Fast: "fast"})
    same(trip.EnumMapValue["Fast"].get(), "fast")
    trip.OptionalValue = None
    assert_type(trip.OptionalValue.get(), int | None)
    same(trip.OptionalValue.get(), None)
    trip.OptionalValue = 5
    same(trip.OptionalValue.get(), 5)
    assert_type(trip.FixedValue, ArrayPath[int, int | Future[int], Path[int], AsyncPath[int]])
    trip.FixedValue = [1, 2, 3, 4]
    same(trip.FixedValue[3].get(), 4)
    assert_type(trip.async_.VectorValue.get(), Future[FVector])
    assert_type(trip.async_.EnumValue, AsyncValuePath[ERoundTripMode, ERoundTripMode_in])


def delegates(trip: URoundTrip) -> None:
    assert_type(trip.DelegateValue.get(), FScriptDelegate)
    trip.DelegateValue = {"Object": trip, "FunctionName": "OnEvent"}
    bound = trip.DelegateValue.get()
    assert_type(bound.Object, UObject | None)
    same(bound.Object, trip)
    same(bound.FunctionName, "OnEvent")
    trip.MulticastValue = [FScriptDelegate(Object=trip, FunctionName="OnEvent")]
    assert_type(trip.MulticastValue.get(), list[FScriptDelegate])
    trip.FireMulticast(Number=11)
    same(trip.LastHeard.get(), 11)
    trip.DelegateValue = None
    same(trip.DelegateValue.get().Object, None)


def functions(trip: URoundTrip, calls: URoundTripCalls) -> None:
    assert_type(trip.EchoVectorArray([FVector(1, 2, 3)]), list[FVector])
    assert_type(trip.EchoStringMap({"a": 1}), dict[str, int])
    same(trip.EchoStringMap({"a": 1}), {"a": 1})
    assert_type(trip.EchoOptional(3), int | None)
    assert_type(trip.EchoEnum("Fast"), ERoundTripMode)
    assert_type(trip.EchoSoftObject("/Engine/BasicShapes/Cube.Cube"), str)
    copied = trip.CopyRecord({"Count": 8})
    assert_type(copied.Result, FRoundTripRecord)
    same(copied.Result.Count, 8)
    (only,) = trip.CopyInt32(3)  # a single output is a tuple too
    assert_type(only, int)
    same(only, 3)
    split = calls.Split("a|b")
    assert_type(split.ReturnValue, bool)
    assert_type(split.Left, str)
    same((split.Left, split.Right), ("a", "b"))
    raised = calls.Increment(4)
    assert_type(raised.Value, int)  # a parameter by reference is a result too
    same(raised.Value, 5)
    assert_type(calls.WorldName(), str)  # the world is filled in
    vector: FVector_in = calls.async_.Snapped.get()
    assert_type(calls.async_.Length(Vector=vector), Future[float])


def main(trip: URoundTrip, calls: URoundTripCalls, actor: AActor) -> None:
    """All of it."""
    plain_values(trip)
    references(trip, actor)
    structs(trip)
    containers(trip)
    delegates(trip)
    functions(trip, calls)


__all__ = ["main", "spear"]
