# generated, do not edit (Engine: Public/Components/ArrowComponent.h)
from spear.typing import AsyncFloatProperty, AsyncObjectPath, FloatProperty, Future, ObjectPath, Property, SendFloatProperty, SendProperty
from ..CoreUObject._NoExportTypes import FColor_async, FColor_in, FColor_path, FLinearColor_in
from ._PrimitiveComponent import UPrimitiveComponent, UPrimitiveComponent_async, UPrimitiveComponent_members, UPrimitiveComponent_send

class UArrowComponent_members(UPrimitiveComponent_members):
    """Functions and variables of UArrowComponent."""
    def SetArrowColor(self, NewColor: FLinearColor_in) -> None:
        """Updates the arrow's colour, linear.

        Unreal: UArrowComponent.SetArrowColor
        """
    def SetArrowLength(self, NewLength: float | Future[float]) -> None:
        """Updates the arrow's length, in centimetres.

        Unreal: UArrowComponent.SetArrowLength
        """
    def SetArrowSize(self, NewSize: float | Future[float]) -> None:
        """Updates the arrow's size.

        Unreal: UArrowComponent.SetArrowSize
        """
    ArrowColor: Property[FColor_path, FColor_in]
    """Colour to draw the arrow.

    Unreal: UArrowComponent.ArrowColor (FColor)
    """
    ArrowSize: FloatProperty
    """Relative size to scale the drawn arrow by.

    Unreal: UArrowComponent.ArrowSize (float)
    """
    ArrowLength: FloatProperty
    """Total length of the drawn arrow including the head, in centimetres.

    Unreal: UArrowComponent.ArrowLength (float)
    """

class UArrowComponent_async(UPrimitiveComponent_async):
    """UArrowComponent under ``async_``: each function gives a future."""
    def SetArrowColor(self, NewColor: FLinearColor_in) -> Future[None]:
        """Updates the arrow's colour, linear."""
    def SetArrowLength(self, NewLength: float | Future[float]) -> Future[None]:
        """Updates the arrow's length, in centimetres."""
    def SetArrowSize(self, NewSize: float | Future[float]) -> Future[None]:
        """Updates the arrow's size."""
    ArrowColor: Property[FColor_async, FColor_in]
    """Colour to draw the arrow."""
    ArrowSize: AsyncFloatProperty
    """Relative size to scale the drawn arrow by."""
    ArrowLength: AsyncFloatProperty
    """Total length of the drawn arrow including the head, in centimetres."""

class UArrowComponent_send(UPrimitiveComponent_send):
    """UArrowComponent under ``send_``: no function answers."""
    def SetArrowColor(self, NewColor: FLinearColor_in) -> None:
        """Updates the arrow's colour, linear."""
    def SetArrowLength(self, NewLength: float | Future[float]) -> None:
        """Updates the arrow's length, in centimetres."""
    def SetArrowSize(self, NewSize: float | Future[float]) -> None:
        """Updates the arrow's size."""
    ArrowColor: SendProperty[FColor_in]
    ArrowSize: SendFloatProperty
    ArrowLength: SendFloatProperty

class UArrowComponent(UArrowComponent_members, UPrimitiveComponent):
    """An arrow along the local X axis, to mark a direction. Hidden in game by default. Epic page: UArrowComponent.

    Unreal: /Script/Engine.ArrowComponent
    """
    @property
    def async_(self) -> UArrowComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UArrowComponent_send:
        """The same functions and variables, fire-and-forget."""

class UArrowComponent_path(ObjectPath[UArrowComponent, UArrowComponent_async_path, UArrowComponent_send], UArrowComponent_members):
    """A variable that refers to an object of UArrowComponent: its path."""

class UArrowComponent_async_path(AsyncObjectPath[UArrowComponent], UArrowComponent_async):
    """The same under ``async_``."""
