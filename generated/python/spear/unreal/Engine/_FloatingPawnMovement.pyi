# generated, do not edit (Engine: Public/GameFramework/FloatingPawnMovement.h)
from spear.typing import AsyncFloatProperty, AsyncObjectPath, FloatProperty, ObjectPath, SendFloatProperty
from ._PawnMovementComponent import UPawnMovementComponent, UPawnMovementComponent_async, UPawnMovementComponent_members, UPawnMovementComponent_send

class UFloatingPawnMovement_members(UPawnMovementComponent_members):
    """Functions and variables of UFloatingPawnMovement."""
    MaxSpeed: FloatProperty
    """Maximum velocity magnitude allowed for the controlled Pawn, in centimetres per second.

    Unreal: UFloatingPawnMovement.MaxSpeed (float)
    """
    Acceleration: FloatProperty
    """Acceleration applied by input (rate of change of velocity), in centimetres per second squared.

    Unreal: UFloatingPawnMovement.Acceleration (float)
    """
    Deceleration: FloatProperty
    """Deceleration applied when there is no input (rate of change of velocity), in centimetres per second squared.

    Unreal: UFloatingPawnMovement.Deceleration (float)
    """
    TurningBoost: FloatProperty
    """Setting affecting extra force applied when changing direction, making turns have less drift and become more
    responsive.

    at least 0

    Unreal: UFloatingPawnMovement.TurningBoost (float)
    """

class UFloatingPawnMovement_async(UPawnMovementComponent_async):
    """UFloatingPawnMovement under ``async_``: each function gives a future."""
    MaxSpeed: AsyncFloatProperty
    """Maximum velocity magnitude allowed for the controlled Pawn, in centimetres per second."""
    Acceleration: AsyncFloatProperty
    """Acceleration applied by input (rate of change of velocity), in centimetres per second squared."""
    Deceleration: AsyncFloatProperty
    """Deceleration applied when there is no input (rate of change of velocity), in centimetres per second squared."""
    TurningBoost: AsyncFloatProperty
    """Setting affecting extra force applied when changing direction, making turns have less drift and become more responsive."""

class UFloatingPawnMovement_send(UPawnMovementComponent_send):
    """UFloatingPawnMovement under ``send_``: no function answers."""
    MaxSpeed: SendFloatProperty
    Acceleration: SendFloatProperty
    Deceleration: SendFloatProperty
    TurningBoost: SendFloatProperty

class UFloatingPawnMovement(UFloatingPawnMovement_members, UPawnMovementComponent):
    """FloatingPawnMovement is a movement component that provides simple movement for any Pawn class. Limits on speed
    and acceleration are provided, while gravity is not implemented.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/UFloatingPawnMovement

    Unreal: /Script/Engine.FloatingPawnMovement
    """
    @property
    def async_(self) -> UFloatingPawnMovement_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UFloatingPawnMovement_send:
        """The same functions and variables, fire-and-forget."""

class UFloatingPawnMovement_path(ObjectPath[UFloatingPawnMovement, UFloatingPawnMovement_async_path, UFloatingPawnMovement_send], UFloatingPawnMovement_members):
    """A variable that refers to an object of UFloatingPawnMovement: its path."""

class UFloatingPawnMovement_async_path(AsyncObjectPath[UFloatingPawnMovement], UFloatingPawnMovement_async):
    """The same under ``async_``."""
