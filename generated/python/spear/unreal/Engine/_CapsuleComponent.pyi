# generated, do not edit (Engine: Public/Components/CapsuleComponent.h)
from typing import NamedTuple
from spear.typing import AsyncFloatProperty, AsyncObjectPath, FloatProperty, Future, ObjectPath, SendFloatProperty
from ._ShapeComponent import UShapeComponent, UShapeComponent_async, UShapeComponent_members, UShapeComponent_send

class UCapsuleComponent_GetScaledCapsuleSize_Result(NamedTuple):
    """Results of UCapsuleComponent.GetScaledCapsuleSize."""
    OutRadius: float
    OutHalfHeight: float

class UCapsuleComponent_GetUnscaledCapsuleSize_Result(NamedTuple):
    """Results of UCapsuleComponent.GetUnscaledCapsuleSize."""
    OutRadius: float
    OutHalfHeight: float

class UCapsuleComponent_members(UShapeComponent_members):
    """Functions and variables of UCapsuleComponent."""
    def GetScaledCapsuleHalfHeight(self) -> float:
        """Returns the capsule half-height scaled by the component scale, in centimetres, the hemispheres included.

        Unreal: UCapsuleComponent.GetScaledCapsuleHalfHeight
        """
    def GetScaledCapsuleHalfHeight_WithoutHemisphere(self) -> float:
        """Returns the scaled half-height without the hemispheres.

        Unreal: UCapsuleComponent.GetScaledCapsuleHalfHeight_WithoutHemisphere
        """
    def GetScaledCapsuleRadius(self) -> float:
        """Returns the capsule radius scaled by the component scale, in centimetres.

        Unreal: UCapsuleComponent.GetScaledCapsuleRadius
        """
    def GetScaledCapsuleSize(self) -> UCapsuleComponent_GetScaledCapsuleSize_Result:
        """Returns the capsule radius and half-height scaled by the component scale.

        Unreal: UCapsuleComponent.GetScaledCapsuleSize
        """
    def GetShapeScale(self) -> float:
        """Gets the scale used by this shape: the smallest absolute component of the world scale.

        Unreal: UCapsuleComponent.GetShapeScale
        """
    def GetUnscaledCapsuleHalfHeight(self) -> float:
        """Returns the capsule half-height, ignoring the component scale, in centimetres, the hemispheres included.

        Unreal: UCapsuleComponent.GetUnscaledCapsuleHalfHeight
        """
    def GetUnscaledCapsuleHalfHeight_WithoutHemisphere(self) -> float:
        """Returns the unscaled half-height without the hemispheres.

        Unreal: UCapsuleComponent.GetUnscaledCapsuleHalfHeight_WithoutHemisphere
        """
    def GetUnscaledCapsuleRadius(self) -> float:
        """Returns the capsule radius, ignoring the component scale, in centimetres.

        Unreal: UCapsuleComponent.GetUnscaledCapsuleRadius
        """
    def GetUnscaledCapsuleSize(self) -> UCapsuleComponent_GetUnscaledCapsuleSize_Result:
        """Returns the capsule radius and half-height, ignoring the component scale.

        Unreal: UCapsuleComponent.GetUnscaledCapsuleSize
        """
    def SetCapsuleHalfHeight(self, HalfHeight: float | Future[float], bUpdateOverlaps: bool | Future[bool] = True) -> None:
        """Sets the capsule half-height. This is the unscaled half-height, before the component scale is applied.

        Unreal: UCapsuleComponent.SetCapsuleHalfHeight
        """
    def SetCapsuleRadius(self, Radius: float | Future[float], bUpdateOverlaps: bool | Future[bool] = True) -> None:
        """Sets the capsule radius. This is the unscaled radius, before the component scale is applied.

        Unreal: UCapsuleComponent.SetCapsuleRadius
        """
    def SetCapsuleSize(self, InRadius: float | Future[float], InHalfHeight: float | Future[float], bUpdateOverlaps: bool | Future[bool] = True) -> None:
        """Changes the capsule size. This is the unscaled size, before the component scale is applied.

        Unreal: UCapsuleComponent.SetCapsuleSize
        """
    CapsuleHalfHeight: FloatProperty
    """Half-height, from the centre of the capsule to the end of its top or bottom hemisphere, in centimetres. Never
    less than the radius.

    at least 0

    Unreal: UCapsuleComponent.CapsuleHalfHeight (float)
    """
    CapsuleRadius: FloatProperty
    """Radius of the cap hemispheres and of the centre cylinder, in centimetres. Never more than the half-height.

    at least 0

    Unreal: UCapsuleComponent.CapsuleRadius (float)
    """

class UCapsuleComponent_async(UShapeComponent_async):
    """UCapsuleComponent under ``async_``: each function gives a future."""
    def GetScaledCapsuleHalfHeight(self) -> Future[float]:
        """Returns the capsule half-height scaled by the component scale, in centimetres, the hemispheres included."""
    def GetScaledCapsuleHalfHeight_WithoutHemisphere(self) -> Future[float]:
        """Returns the scaled half-height without the hemispheres."""
    def GetScaledCapsuleRadius(self) -> Future[float]:
        """Returns the capsule radius scaled by the component scale, in centimetres."""
    def GetScaledCapsuleSize(self) -> Future[UCapsuleComponent_GetScaledCapsuleSize_Result]:
        """Returns the capsule radius and half-height scaled by the component scale."""
    def GetShapeScale(self) -> Future[float]:
        """Gets the scale used by this shape: the smallest absolute component of the world scale."""
    def GetUnscaledCapsuleHalfHeight(self) -> Future[float]:
        """Returns the capsule half-height, ignoring the component scale, in centimetres, the hemispheres included."""
    def GetUnscaledCapsuleHalfHeight_WithoutHemisphere(self) -> Future[float]:
        """Returns the unscaled half-height without the hemispheres."""
    def GetUnscaledCapsuleRadius(self) -> Future[float]:
        """Returns the capsule radius, ignoring the component scale, in centimetres."""
    def GetUnscaledCapsuleSize(self) -> Future[UCapsuleComponent_GetUnscaledCapsuleSize_Result]:
        """Returns the capsule radius and half-height, ignoring the component scale."""
    def SetCapsuleHalfHeight(self, HalfHeight: float | Future[float], bUpdateOverlaps: bool | Future[bool] = True) -> Future[None]:
        """Sets the capsule half-height."""
    def SetCapsuleRadius(self, Radius: float | Future[float], bUpdateOverlaps: bool | Future[bool] = True) -> Future[None]:
        """Sets the capsule radius."""
    def SetCapsuleSize(self, InRadius: float | Future[float], InHalfHeight: float | Future[float], bUpdateOverlaps: bool | Future[bool] = True) -> Future[None]:
        """Changes the capsule size."""
    CapsuleHalfHeight: AsyncFloatProperty
    """Half-height, from the centre of the capsule to the end of its top or bottom hemisphere, in centimetres."""
    CapsuleRadius: AsyncFloatProperty
    """Radius of the cap hemispheres and of the centre cylinder, in centimetres."""

class UCapsuleComponent_send(UShapeComponent_send):
    """UCapsuleComponent under ``send_``: no function answers."""
    def GetScaledCapsuleHalfHeight(self) -> None:
        """Returns the capsule half-height scaled by the component scale, in centimetres, the hemispheres included."""
    def GetScaledCapsuleHalfHeight_WithoutHemisphere(self) -> None:
        """Returns the scaled half-height without the hemispheres."""
    def GetScaledCapsuleRadius(self) -> None:
        """Returns the capsule radius scaled by the component scale, in centimetres."""
    def GetScaledCapsuleSize(self) -> None:
        """Returns the capsule radius and half-height scaled by the component scale."""
    def GetShapeScale(self) -> None:
        """Gets the scale used by this shape: the smallest absolute component of the world scale."""
    def GetUnscaledCapsuleHalfHeight(self) -> None:
        """Returns the capsule half-height, ignoring the component scale, in centimetres, the hemispheres included."""
    def GetUnscaledCapsuleHalfHeight_WithoutHemisphere(self) -> None:
        """Returns the unscaled half-height without the hemispheres."""
    def GetUnscaledCapsuleRadius(self) -> None:
        """Returns the capsule radius, ignoring the component scale, in centimetres."""
    def GetUnscaledCapsuleSize(self) -> None:
        """Returns the capsule radius and half-height, ignoring the component scale."""
    def SetCapsuleHalfHeight(self, HalfHeight: float | Future[float], bUpdateOverlaps: bool | Future[bool] = True) -> None:
        """Sets the capsule half-height."""
    def SetCapsuleRadius(self, Radius: float | Future[float], bUpdateOverlaps: bool | Future[bool] = True) -> None:
        """Sets the capsule radius."""
    def SetCapsuleSize(self, InRadius: float | Future[float], InHalfHeight: float | Future[float], bUpdateOverlaps: bool | Future[bool] = True) -> None:
        """Changes the capsule size."""
    CapsuleHalfHeight: SendFloatProperty
    CapsuleRadius: SendFloatProperty

class UCapsuleComponent(UCapsuleComponent_members, UShapeComponent):
    """A capsule along the local Z axis for simple collision. Epic page: UCapsuleComponent.

    Unreal: /Script/Engine.CapsuleComponent
    """
    @property
    def async_(self) -> UCapsuleComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UCapsuleComponent_send:
        """The same functions and variables, fire-and-forget."""

class UCapsuleComponent_path(ObjectPath[UCapsuleComponent, UCapsuleComponent_async_path, UCapsuleComponent_send], UCapsuleComponent_members):
    """A variable that refers to an object of UCapsuleComponent: its path."""

class UCapsuleComponent_async_path(AsyncObjectPath[UCapsuleComponent], UCapsuleComponent_async):
    """The same under ``async_``."""
