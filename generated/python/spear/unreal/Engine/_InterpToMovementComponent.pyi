# generated, do not edit (Engine: Public/Components/InterpToMovementComponent.h)
from collections.abc import Sequence
from typing import TypeAlias, TypedDict
from spear.enums import UnrealEnum
from spear.structs import Struct
from spear.typing import (
    ArrayPath, AsyncArrayPath, AsyncBoolProperty, AsyncFloatProperty, AsyncObjectPath, AsyncValuePath, BoolProperty, FloatProperty, Future,
    ObjectPath, Property, SendFloatProperty, SendProperty, StructPath, ValuePath,
)
from ..CoreUObject._Intrinsic import FScriptDelegate, FScriptDelegate_in
from ..CoreUObject._NoExportTypes import FVector, FVector_async, FVector_in, FVector_path
from ._MovementComponent import UMovementComponent, UMovementComponent_async, UMovementComponent_members, UMovementComponent_send

class EInterpToBehaviourType(UnrealEnum):
    """What happens at the end of the path. Epic page: EInterpToBehaviourType.

    Unreal: /Script/Engine.EInterpToBehaviourType
    """
    OneShot = 0
    """Move to the last control point and stop."""
    OneShot_Reverse = 1
    """Move to the last control point, then back to the first, and stop."""
    Loop_Reset = 2
    """Move to the last control point, jump to the first, and so on."""
    PingPong = 3
    """Move to and fro."""

EInterpToBehaviourType_in: TypeAlias = EInterpToBehaviourType | str | Future[EInterpToBehaviourType]
"""What stands for EInterpToBehaviourType as an argument: an entry, the name that Unreal gives it, a future."""

class FInterpControlPoint(Struct):
    """One point of the path. Epic page: FInterpControlPoint.

    Unreal: /Script/Engine.InterpControlPoint
    """
    def __init__(self, PositionControlPoint: FVector = ..., bPositionIsRelative: bool = ...) -> None: ...
    PositionControlPoint: FVector
    """Location of the control point, in centimetres."""
    bPositionIsRelative: bool
    """Whether the position is relative to where the component started, or absolute."""

class FInterpControlPoint_dict(TypedDict, total=False):
    """Any of the fields of FInterpControlPoint: what a dictionary for it may hold."""
    PositionControlPoint: FVector_in
    bPositionIsRelative: bool | Future[bool]

FInterpControlPoint_in: TypeAlias = FInterpControlPoint | FInterpControlPoint_dict | Future[FInterpControlPoint]
"""What stands for FInterpControlPoint as an argument: itself, a dictionary of its fields, a future."""

class FInterpControlPoint_path(StructPath[FInterpControlPoint, FInterpControlPoint_in, FInterpControlPoint_async]):
    """A variable of type FInterpControlPoint: its path."""
    PositionControlPoint: Property[FVector_path, FVector_in]
    """Location of the control point, in centimetres."""
    bPositionIsRelative: BoolProperty
    """Whether the position is relative to where the component started, or absolute."""

class FInterpControlPoint_async(AsyncValuePath[FInterpControlPoint, FInterpControlPoint_in]):
    """The same under ``async_``."""
    PositionControlPoint: Property[FVector_async, FVector_in]
    bPositionIsRelative: AsyncBoolProperty

FOnInterpToReverseDelegate: TypeAlias = list[FScriptDelegate]
"""Broadcast when the component changes direction, at a time along the path (0 to 1).

Called as FOnInterpToReverseDelegate(ImpactResult: FHitResult, Time: float); a value tells what is bound.

Unreal: /Script/Engine.OnInterpToReverseDelegate__DelegateSignature
"""

FOnInterpToResetDelegate: TypeAlias = list[FScriptDelegate]
"""Broadcast when the component jumps back to the start.

Called as FOnInterpToResetDelegate(ImpactResult: FHitResult, Time: float); a value tells what is bound.

Unreal: /Script/Engine.OnInterpToResetDelegate__DelegateSignature
"""

FOnInterpToStopDelegate: TypeAlias = list[FScriptDelegate]
"""Broadcast when the component stops at the end.

Called as FOnInterpToStopDelegate(ImpactResult: FHitResult, Time: float); a value tells what is bound.

Unreal: /Script/Engine.OnInterpToStopDelegate__DelegateSignature
"""

class UInterpToMovementComponent_members(UMovementComponent_members):
    """Functions and variables of UInterpToMovementComponent."""
    def AddControlPointPosition(self, Pos: FVector_in, bPositionIsRelative: bool | Future[bool] = True) -> None:
        """Adds a control point to the end of the path.

        Unreal: UInterpToMovementComponent.AddControlPointPosition
        """
    def FinaliseControlPoints(self) -> None:
        """Computes the lengths after the control points were added.

        Unreal: UInterpToMovementComponent.FinaliseControlPoints
        """
    def ResetControlPoints(self) -> None:
        """Removes all control points.

        Unreal: UInterpToMovementComponent.ResetControlPoints
        """
    def RestartMovement(self, InitialDirection: float | Future[float] = 1.0) -> None:
        """Starts again from the first point (direction 1) or from the last one backwards (direction -1).

        Unreal: UInterpToMovementComponent.RestartMovement
        """
    Duration: FloatProperty
    """How long to take to move from the first point to the last, in seconds.

    Unreal: UInterpToMovementComponent.Duration (float)
    """
    BehaviourType: Property[ValuePath[EInterpToBehaviourType, EInterpToBehaviourType_in], EInterpToBehaviourType_in]
    """What happens at the end of the path.

    Unreal: UInterpToMovementComponent.BehaviourType (EInterpToBehaviourType)
    """
    ControlPoints: Property[ArrayPath[FInterpControlPoint, FInterpControlPoint_in, FInterpControlPoint_path, FInterpControlPoint_async], Sequence[FInterpControlPoint_in] | Future[list[FInterpControlPoint]]]
    """The points of the path. FinaliseControlPoints must run after changing them.

    Unreal: UInterpToMovementComponent.ControlPoints (TArray<FInterpControlPoint>)
    """
    OnInterpToReverse: Property[ValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called when the component changes direction.

    Delegate: FOnInterpToReverseDelegate(ImpactResult: FHitResult, Time: float)

    Unreal: UInterpToMovementComponent.OnInterpToReverse (FOnInterpToReverseDelegate)
    """
    OnInterpToReset: Property[ValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called when the component jumps back to the start.

    Delegate: FOnInterpToResetDelegate(ImpactResult: FHitResult, Time: float)

    Unreal: UInterpToMovementComponent.OnInterpToReset (FOnInterpToResetDelegate)
    """
    OnInterpToStop: Property[ValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called when the component stops.

    Delegate: FOnInterpToStopDelegate(ImpactResult: FHitResult, Time: float)

    Unreal: UInterpToMovementComponent.OnInterpToStop (FOnInterpToStopDelegate)
    """

class UInterpToMovementComponent_async(UMovementComponent_async):
    """UInterpToMovementComponent under ``async_``: each function gives a future."""
    def AddControlPointPosition(self, Pos: FVector_in, bPositionIsRelative: bool | Future[bool] = True) -> Future[None]:
        """Adds a control point to the end of the path."""
    def FinaliseControlPoints(self) -> Future[None]:
        """Computes the lengths after the control points were added."""
    def ResetControlPoints(self) -> Future[None]:
        """Removes all control points."""
    def RestartMovement(self, InitialDirection: float | Future[float] = 1.0) -> Future[None]:
        """Starts again from the first point (direction 1) or from the last one backwards (direction -1)."""
    Duration: AsyncFloatProperty
    """How long to take to move from the first point to the last, in seconds."""
    BehaviourType: Property[AsyncValuePath[EInterpToBehaviourType, EInterpToBehaviourType_in], EInterpToBehaviourType_in]
    """What happens at the end of the path."""
    ControlPoints: Property[AsyncArrayPath[FInterpControlPoint, FInterpControlPoint_in, FInterpControlPoint_async], Sequence[FInterpControlPoint_in] | Future[list[FInterpControlPoint]]]
    """The points of the path."""
    OnInterpToReverse: Property[AsyncValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called when the component changes direction."""
    OnInterpToReset: Property[AsyncValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called when the component jumps back to the start."""
    OnInterpToStop: Property[AsyncValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called when the component stops."""

class UInterpToMovementComponent_send(UMovementComponent_send):
    """UInterpToMovementComponent under ``send_``: no function answers."""
    def AddControlPointPosition(self, Pos: FVector_in, bPositionIsRelative: bool | Future[bool] = True) -> None:
        """Adds a control point to the end of the path."""
    def FinaliseControlPoints(self) -> None:
        """Computes the lengths after the control points were added."""
    def ResetControlPoints(self) -> None:
        """Removes all control points."""
    def RestartMovement(self, InitialDirection: float | Future[float] = 1.0) -> None:
        """Starts again from the first point (direction 1) or from the last one backwards (direction -1)."""
    Duration: SendFloatProperty
    BehaviourType: SendProperty[EInterpToBehaviourType_in]
    ControlPoints: SendProperty[Sequence[FInterpControlPoint_in] | Future[list[FInterpControlPoint]]]
    OnInterpToReverse: SendProperty[Sequence[FScriptDelegate_in] | None]
    OnInterpToReset: SendProperty[Sequence[FScriptDelegate_in] | None]
    OnInterpToStop: SendProperty[Sequence[FScriptDelegate_in] | None]

class UInterpToMovementComponent(UInterpToMovementComponent_members, UMovementComponent):
    """Moves the updated component along a path of control points at a constant speed. Epic page:
    UInterpToMovementComponent.

    Unreal: /Script/Engine.InterpToMovementComponent
    """
    @property
    def async_(self) -> UInterpToMovementComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UInterpToMovementComponent_send:
        """The same functions and variables, fire-and-forget."""

class UInterpToMovementComponent_path(ObjectPath[UInterpToMovementComponent, UInterpToMovementComponent_async_path, UInterpToMovementComponent_send], UInterpToMovementComponent_members):
    """A variable that refers to an object of UInterpToMovementComponent: its path."""

class UInterpToMovementComponent_async_path(AsyncObjectPath[UInterpToMovementComponent], UInterpToMovementComponent_async):
    """The same under ``async_``."""
