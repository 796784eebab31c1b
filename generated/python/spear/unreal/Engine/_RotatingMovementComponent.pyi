# generated, do not edit (Engine: Public/GameFramework/RotatingMovementComponent.h)
from spear.typing import AsyncBoolProperty, AsyncObjectPath, BoolProperty, ObjectPath, Property, SendBoolProperty, SendProperty
from ..CoreUObject._NoExportTypes import FRotator_async, FRotator_in, FRotator_path, FVector_async, FVector_in, FVector_path
from ._MovementComponent import UMovementComponent, UMovementComponent_async, UMovementComponent_members, UMovementComponent_send

class URotatingMovementComponent_members(UMovementComponent_members):
    """Functions and variables of URotatingMovementComponent."""
    RotationRate: Property[FRotator_path, FRotator_in]
    """How fast to update roll/pitch/yaw of the component we update, in degrees per second.

    Unreal: URotatingMovementComponent.RotationRate (FRotator)
    """
    PivotTranslation: Property[FVector_path, FVector_in]
    """Translation of pivot point around which we rotate, relative to the current rotation, in centimetres.

    Unreal: URotatingMovementComponent.PivotTranslation (FVector)
    """
    bRotationInLocalSpace: BoolProperty
    """Whether rotation is applied in local or world space.

    Unreal: URotatingMovementComponent.bRotationInLocalSpace (bool)
    """

class URotatingMovementComponent_async(UMovementComponent_async):
    """URotatingMovementComponent under ``async_``: each function gives a future."""
    RotationRate: Property[FRotator_async, FRotator_in]
    """How fast to update roll/pitch/yaw of the component we update, in degrees per second."""
    PivotTranslation: Property[FVector_async, FVector_in]
    """Translation of pivot point around which we rotate, relative to the current rotation, in centimetres."""
    bRotationInLocalSpace: AsyncBoolProperty
    """Whether rotation is applied in local or world space."""

class URotatingMovementComponent_send(UMovementComponent_send):
    """URotatingMovementComponent under ``send_``: no function answers."""
    RotationRate: SendProperty[FRotator_in]
    PivotTranslation: SendProperty[FVector_in]
    bRotationInLocalSpace: SendBoolProperty

class URotatingMovementComponent(URotatingMovementComponent_members, UMovementComponent):
    """Turns the updated component at a constant rate, optionally about a pivot. Epic page:
    URotatingMovementComponent.

    Unreal: /Script/Engine.RotatingMovementComponent
    """
    @property
    def async_(self) -> URotatingMovementComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> URotatingMovementComponent_send:
        """The same functions and variables, fire-and-forget."""

class URotatingMovementComponent_path(ObjectPath[URotatingMovementComponent, URotatingMovementComponent_async_path, URotatingMovementComponent_send], URotatingMovementComponent_members):
    """A variable that refers to an object of URotatingMovementComponent: its path."""

class URotatingMovementComponent_async_path(AsyncObjectPath[URotatingMovementComponent], URotatingMovementComponent_async):
    """The same under ``async_``."""
