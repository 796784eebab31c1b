# generated, do not edit (Engine: Public/Components/PointLightComponent.h)
from spear.typing import (
    AsyncBoolProperty, AsyncFloatProperty, AsyncObjectPath, BoolProperty, FloatProperty, Future, ObjectPath, SendBoolProperty, SendFloatProperty,
)
from ._LocalLightComponent import ULocalLightComponent, ULocalLightComponent_async, ULocalLightComponent_members, ULocalLightComponent_send

class UPointLightComponent_members(ULocalLightComponent_members):
    """Functions and variables of UPointLightComponent."""
    def SetLightFalloffExponent(self, NewLightFalloffExponent: float | Future[float]) -> None:
        """Sets the radial falloff exponent.

        Unreal: UPointLightComponent.SetLightFalloffExponent
        """
    def SetSoftSourceRadius(self, bNewValue: float | Future[float]) -> None:
        """Sets the soft radius of the light source shape, in centimetres.

        Unreal: UPointLightComponent.SetSoftSourceRadius
        """
    def SetSourceLength(self, NewValue: float | Future[float]) -> None:
        """Sets the length of the light source shape, in centimetres.

        Unreal: UPointLightComponent.SetSourceLength
        """
    def SetSourceRadius(self, bNewValue: float | Future[float]) -> None:
        """Sets the radius of the light source shape, in centimetres.

        Unreal: UPointLightComponent.SetSourceRadius
        """
    def SetUseInverseSquaredFalloff(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether to use inverse squared distance falloff.

        Unreal: UPointLightComponent.SetUseInverseSquaredFalloff
        """
    bUseInverseSquaredFalloff: BoolProperty
    """Whether to use physically based inverse squared distance falloff.

    Unreal: UPointLightComponent.bUseInverseSquaredFalloff (bool)
    """
    LightFalloffExponent: FloatProperty
    """Controls the radial falloff of the light when bUseInverseSquaredFalloff is false.

    Unreal: UPointLightComponent.LightFalloffExponent (float)
    """
    SourceRadius: FloatProperty
    """Radius of the light source shape, in centimetres.

    Unreal: UPointLightComponent.SourceRadius (float)
    """
    SoftSourceRadius: FloatProperty
    """Soft radius of the light source shape, in centimetres.

    Unreal: UPointLightComponent.SoftSourceRadius (float)
    """
    SourceLength: FloatProperty
    """Length of the light source shape along the local Z axis, in centimetres.

    Unreal: UPointLightComponent.SourceLength (float)
    """

class UPointLightComponent_async(ULocalLightComponent_async):
    """UPointLightComponent under ``async_``: each function gives a future."""
    def SetLightFalloffExponent(self, NewLightFalloffExponent: float | Future[float]) -> Future[None]:
        """Sets the radial falloff exponent."""
    def SetSoftSourceRadius(self, bNewValue: float | Future[float]) -> Future[None]:
        """Sets the soft radius of the light source shape, in centimetres."""
    def SetSourceLength(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the length of the light source shape, in centimetres."""
    def SetSourceRadius(self, bNewValue: float | Future[float]) -> Future[None]:
        """Sets the radius of the light source shape, in centimetres."""
    def SetUseInverseSquaredFalloff(self, bNewValue: bool | Future[bool]) -> Future[None]:
        """Sets whether to use inverse squared distance falloff."""
    bUseInverseSquaredFalloff: AsyncBoolProperty
    """Whether to use physically based inverse squared distance falloff."""
    LightFalloffExponent: AsyncFloatProperty
    """Controls the radial falloff of the light when bUseInverseSquaredFalloff is false."""
    SourceRadius: AsyncFloatProperty
    """Radius of the light source shape, in centimetres."""
    SoftSourceRadius: AsyncFloatProperty
    """Soft radius of the light source shape, in centimetres."""
    SourceLength: AsyncFloatProperty
    """Length of the light source shape along the local Z axis, in centimetres."""

class UPointLightComponent_send(ULocalLightComponent_send):
    """UPointLightComponent under ``send_``: no function answers."""
    def SetLightFalloffExponent(self, NewLightFalloffExponent: float | Future[float]) -> None:
        """Sets the radial falloff exponent."""
    def SetSoftSourceRadius(self, bNewValue: float | Future[float]) -> None:
        """Sets the soft radius of the light source shape, in centimetres."""
    def SetSourceLength(self, NewValue: float | Future[float]) -> None:
        """Sets the length of the light source shape, in centimetres."""
    def SetSourceRadius(self, bNewValue: float | Future[float]) -> None:
        """Sets the radius of the light source shape, in centimetres."""
    def SetUseInverseSquaredFalloff(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether to use inverse squared distance falloff."""
    bUseInverseSquaredFalloff: SendBoolProperty
    LightFalloffExponent: SendFloatProperty
    SourceRadius: SendFloatProperty
    SoftSourceRadius: SendFloatProperty
    SourceLength: SendFloatProperty

class UPointLightComponent(UPointLightComponent_members, ULocalLightComponent):
    """A light that shines in all directions from a small sphere or tube. Epic page: UPointLightComponent.

    Unreal: /Script/Engine.PointLightComponent
    """
    @property
    def async_(self) -> UPointLightComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UPointLightComponent_send:
        """The same functions and variables, fire-and-forget."""

class UPointLightComponent_path(ObjectPath[UPointLightComponent, UPointLightComponent_async_path, UPointLightComponent_send], UPointLightComponent_members):
    """A variable that refers to an object of UPointLightComponent: its path."""

class UPointLightComponent_async_path(AsyncObjectPath[UPointLightComponent], UPointLightComponent_async):
    """The same under ``async_``."""
