# generated, do not edit (Engine: Public/Components/SpotLightComponent.h)
from spear.typing import AsyncFloatProperty, AsyncObjectPath, FloatProperty, Future, ObjectPath, SendFloatProperty
from ._PointLightComponent import UPointLightComponent, UPointLightComponent_async, UPointLightComponent_members, UPointLightComponent_send

class USpotLightComponent_members(UPointLightComponent_members):
    """Functions and variables of USpotLightComponent."""
    def SetInnerConeAngle(self, NewInnerConeAngle: float | Future[float]) -> None:
        """Sets the inner cone angle, in degrees.

        Unreal: USpotLightComponent.SetInnerConeAngle
        """
    def SetOuterConeAngle(self, NewOuterConeAngle: float | Future[float]) -> None:
        """Sets the outer cone angle, in degrees.

        Unreal: USpotLightComponent.SetOuterConeAngle
        """
    InnerConeAngle: FloatProperty
    """Half the angle of the cone of full intensity, in degrees.

    Unreal: USpotLightComponent.InnerConeAngle (float)
    """
    OuterConeAngle: FloatProperty
    """Half the angle of the cone outside which there is no light, in degrees.

    Unreal: USpotLightComponent.OuterConeAngle (float)
    """

class USpotLightComponent_async(UPointLightComponent_async):
    """USpotLightComponent under ``async_``: each function gives a future."""
    def SetInnerConeAngle(self, NewInnerConeAngle: float | Future[float]) -> Future[None]:
        """Sets the inner cone angle, in degrees."""
    def SetOuterConeAngle(self, NewOuterConeAngle: float | Future[float]) -> Future[None]:
        """Sets the outer cone angle, in degrees."""
    InnerConeAngle: AsyncFloatProperty
    """Half the angle of the cone of full intensity, in degrees."""
    OuterConeAngle: AsyncFloatProperty
    """Half the angle of the cone outside which there is no light, in degrees."""

class USpotLightComponent_send(UPointLightComponent_send):
    """USpotLightComponent under ``send_``: no function answers."""
    def SetInnerConeAngle(self, NewInnerConeAngle: float | Future[float]) -> None:
        """Sets the inner cone angle, in degrees."""
    def SetOuterConeAngle(self, NewOuterConeAngle: float | Future[float]) -> None:
        """Sets the outer cone angle, in degrees."""
    InnerConeAngle: SendFloatProperty
    OuterConeAngle: SendFloatProperty

class USpotLightComponent(USpotLightComponent_members, UPointLightComponent):
    """A point light that shines in a cone along the local X axis. Epic page: USpotLightComponent.

    Unreal: /Script/Engine.SpotLightComponent
    """
    @property
    def async_(self) -> USpotLightComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> USpotLightComponent_send:
        """The same functions and variables, fire-and-forget."""

class USpotLightComponent_path(ObjectPath[USpotLightComponent, USpotLightComponent_async_path, USpotLightComponent_send], USpotLightComponent_members):
    """A variable that refers to an object of USpotLightComponent: its path."""

class USpotLightComponent_async_path(AsyncObjectPath[USpotLightComponent], USpotLightComponent_async):
    """The same under ``async_``."""
