# generated, do not edit (Engine: Public/Components/BoxComponent.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath, Property, SendProperty
from ..CoreUObject._NoExportTypes import FVector, FVector_async, FVector_in, FVector_path
from ._ShapeComponent import UShapeComponent, UShapeComponent_async, UShapeComponent_members, UShapeComponent_send

class UBoxComponent_members(UShapeComponent_members):
    """Functions and variables of UBoxComponent."""
    def GetScaledBoxExtent(self) -> FVector:
        """Returns the box extents scaled by the component scale, in centimetres.

        Unreal: UBoxComponent.GetScaledBoxExtent
        """
    def GetUnscaledBoxExtent(self) -> FVector:
        """Returns the box extent, ignoring the component scale, in centimetres.

        Unreal: UBoxComponent.GetUnscaledBoxExtent
        """
    def SetBoxExtent(self, InBoxExtent: FVector_in, bUpdateOverlaps: bool | Future[bool] = True) -> None:
        """Changes the box extent. This is the unscaled size, before the component scale is applied.

        Unreal: UBoxComponent.SetBoxExtent
        """
    BoxExtent: Property[FVector_path, FVector_in]
    """The extents (radii dimensions) of the box, in centimetres, before the component's scale.

    Unreal: UBoxComponent.BoxExtent (FVector)
    """

class UBoxComponent_async(UShapeComponent_async):
    """UBoxComponent under ``async_``: each function gives a future."""
    def GetScaledBoxExtent(self) -> Future[FVector]:
        """Returns the box extents scaled by the component scale, in centimetres."""
    def GetUnscaledBoxExtent(self) -> Future[FVector]:
        """Returns the box extent, ignoring the component scale, in centimetres."""
    def SetBoxExtent(self, InBoxExtent: FVector_in, bUpdateOverlaps: bool | Future[bool] = True) -> Future[None]:
        """Changes the box extent."""
    BoxExtent: Property[FVector_async, FVector_in]
    """The extents (radii dimensions) of the box, in centimetres, before the component's scale."""

class UBoxComponent_send(UShapeComponent_send):
    """UBoxComponent under ``send_``: no function answers."""
    def GetScaledBoxExtent(self) -> None:
        """Returns the box extents scaled by the component scale, in centimetres."""
    def GetUnscaledBoxExtent(self) -> None:
        """Returns the box extent, ignoring the component scale, in centimetres."""
    def SetBoxExtent(self, InBoxExtent: FVector_in, bUpdateOverlaps: bool | Future[bool] = True) -> None:
        """Changes the box extent."""
    BoxExtent: SendProperty[FVector_in]

class UBoxComponent(UBoxComponent_members, UShapeComponent):
    """A box for simple collision. Epic page: UBoxComponent.

    Unreal: /Script/Engine.BoxComponent
    """
    @property
    def async_(self) -> UBoxComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UBoxComponent_send:
        """The same functions and variables, fire-and-forget."""

class UBoxComponent_path(ObjectPath[UBoxComponent, UBoxComponent_async_path, UBoxComponent_send], UBoxComponent_members):
    """A variable that refers to an object of UBoxComponent: its path."""

class UBoxComponent_async_path(AsyncObjectPath[UBoxComponent], UBoxComponent_async):
    """The same under ``async_``."""
