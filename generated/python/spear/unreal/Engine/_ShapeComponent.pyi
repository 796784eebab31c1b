# generated, do not edit (Engine: Public/Components/ShapeComponent.h)
from spear.typing import AsyncObjectPath, ObjectPath, Property, SendProperty
from ..CoreUObject._NoExportTypes import FColor_async, FColor_in, FColor_path
from ._PrimitiveComponent import UPrimitiveComponent, UPrimitiveComponent_async, UPrimitiveComponent_members, UPrimitiveComponent_send

class UShapeComponent_members(UPrimitiveComponent_members):
    """Functions and variables of UShapeComponent."""
    ShapeColor: Property[FColor_path, FColor_in]
    """Colour used to draw the shape.

    Unreal: UShapeComponent.ShapeColor (FColor)
    """

class UShapeComponent_async(UPrimitiveComponent_async):
    """UShapeComponent under ``async_``: each function gives a future."""
    ShapeColor: Property[FColor_async, FColor_in]
    """Colour used to draw the shape."""

class UShapeComponent_send(UPrimitiveComponent_send):
    """UShapeComponent under ``send_``: no function answers."""
    ShapeColor: SendProperty[FColor_in]

class UShapeComponent(UShapeComponent_members, UPrimitiveComponent):
    """Base of the simple shapes: box, sphere and capsule. Hidden in game by default. Epic page: UShapeComponent.

    Unreal: /Script/Engine.ShapeComponent
    """
    @property
    def async_(self) -> UShapeComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UShapeComponent_send:
        """The same functions and variables, fire-and-forget."""

class UShapeComponent_path(ObjectPath[UShapeComponent, UShapeComponent_async_path, UShapeComponent_send], UShapeComponent_members):
    """A variable that refers to an object of UShapeComponent: its path."""

class UShapeComponent_async_path(AsyncObjectPath[UShapeComponent], UShapeComponent_async):
    """The same under ``async_``."""
