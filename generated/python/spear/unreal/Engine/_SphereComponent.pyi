# generated, do not edit (Engine: Public/Components/SphereComponent.h)
from spear.typing import AsyncFloatProperty, AsyncObjectPath, FloatProperty, Future, ObjectPath, SendFloatProperty
from ._ShapeComponent import UShapeComponent, UShapeComponent_async, UShapeComponent_members, UShapeComponent_send

class USphereComponent_members(UShapeComponent_members):
    """Functions and variables of USphereComponent."""
    def GetScaledSphereRadius(self) -> float:
        """Returns the radius of the sphere with the component scale applied, in centimetres.

        Unreal: USphereComponent.GetScaledSphereRadius
        """
    def GetShapeScale(self) -> float:
        """Gets the scale used by this shape: the smallest absolute component of the world scale.

        Unreal: USphereComponent.GetShapeScale
        """
    def GetUnscaledSphereRadius(self) -> float:
        """Returns the radius of the sphere, ignoring the component scale, in centimetres.

        Unreal: USphereComponent.GetUnscaledSphereRadius
        """
    def SetSphereRadius(self, InSphereRadius: float | Future[float], bUpdateOverlaps: bool | Future[bool] = True) -> None:
        """Changes the sphere radius. This is the unscaled radius, before the component scale is applied.

        Unreal: USphereComponent.SetSphereRadius
        """
    SphereRadius: FloatProperty
    """The radius of the sphere, in centimetres, before the component's scale.

    at least 0

    Unreal: USphereComponent.SphereRadius (float)
    """

class USphereComponent_async(UShapeComponent_async):
    """USphereComponent under ``async_``: each function gives a future."""
    def GetScaledSphereRadius(self) -> Future[float]:
        """Returns the radius of the sphere with the component scale applied, in centimetres."""
    def GetShapeScale(self) -> Future[float]:
        """Gets the scale used by this shape: the smallest absolute component of the world scale."""
    def GetUnscaledSphereRadius(self) -> Future[float]:
        """Returns the radius of the sphere, ignoring the component scale, in centimetres."""
    def SetSphereRadius(self, InSphereRadius: float | Future[float], bUpdateOverlaps: bool | Future[bool] = True) -> Future[None]:
        """Changes the sphere radius."""
    SphereRadius: AsyncFloatProperty
    """The radius of the sphere, in centimetres, before the component's scale."""

class USphereComponent_send(UShapeComponent_send):
    """USphereComponent under ``send_``: no function answers."""
    def GetScaledSphereRadius(self) -> None:
        """Returns the radius of the sphere with the component scale applied, in centimetres."""
    def GetShapeScale(self) -> None:
        """Gets the scale used by this shape: the smallest absolute component of the world scale."""
    def GetUnscaledSphereRadius(self) -> None:
        """Returns the radius of the sphere, ignoring the component scale, in centimetres."""
    def SetSphereRadius(self, InSphereRadius: float | Future[float], bUpdateOverlaps: bool | Future[bool] = True) -> None:
        """Changes the sphere radius."""
    SphereRadius: SendFloatProperty

class USphereComponent(USphereComponent_members, UShapeComponent):
    """A sphere for simple collision. Under non-uniform scale its radius follows the smallest axis. Epic page:
    USphereComponent.

    Unreal: /Script/Engine.SphereComponent
    """
    @property
    def async_(self) -> USphereComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> USphereComponent_send:
        """The same functions and variables, fire-and-forget."""

class USphereComponent_path(ObjectPath[USphereComponent, USphereComponent_async_path, USphereComponent_send], USphereComponent_members):
    """A variable that refers to an object of USphereComponent: its path."""

class USphereComponent_async_path(AsyncObjectPath[USphereComponent], USphereComponent_async):
    """The same under ``async_``."""
