# generated, do not edit (Engine: Public/Engine/PointLight.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath, Property, SendProperty
from ._Light import ALight, ALight_async, ALight_members, ALight_send
from ._PointLightComponent import UPointLightComponent, UPointLightComponent_async_path, UPointLightComponent_path

class APointLight_members(ALight_members):
    """Functions and variables of APointLight."""
    def SetLightFalloffExponent(self, NewLightFalloffExponent: float | Future[float]) -> None:
        """Sets the falloff exponent of the light.

        Unreal: APointLight.SetLightFalloffExponent
        """
    def SetRadius(self, NewRadius: float | Future[float]) -> None:
        """Sets the radius of the light, in centimetres.

        Unreal: APointLight.SetRadius
        """
    PointLightComponent: Property[UPointLightComponent_path, UPointLightComponent | Future[UPointLightComponent] | None]
    """The light.

    Unreal: APointLight.PointLightComponent (UPointLightComponent*)
    """

class APointLight_async(ALight_async):
    """APointLight under ``async_``: each function gives a future."""
    def SetLightFalloffExponent(self, NewLightFalloffExponent: float | Future[float]) -> Future[None]:
        """Sets the falloff exponent of the light."""
    def SetRadius(self, NewRadius: float | Future[float]) -> Future[None]:
        """Sets the radius of the light, in centimetres."""
    PointLightComponent: Property[UPointLightComponent_async_path, UPointLightComponent | Future[UPointLightComponent] | None]
    """The light."""

class APointLight_send(ALight_send):
    """APointLight under ``send_``: no function answers."""
    def SetLightFalloffExponent(self, NewLightFalloffExponent: float | Future[float]) -> None:
        """Sets the falloff exponent of the light."""
    def SetRadius(self, NewRadius: float | Future[float]) -> None:
        """Sets the radius of the light, in centimetres."""
    PointLightComponent: SendProperty[UPointLightComponent | Future[UPointLightComponent] | None]

class APointLight(APointLight_members, ALight):
    """An actor with a point light. Epic page: APointLight.

    Unreal: /Script/Engine.PointLight
    """
    @property
    def async_(self) -> APointLight_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> APointLight_send:
        """The same functions and variables, fire-and-forget."""

class APointLight_path(ObjectPath[APointLight, APointLight_async_path, APointLight_send], APointLight_members):
    """A variable that refers to an object of APointLight: its path."""

class APointLight_async_path(AsyncObjectPath[APointLight], APointLight_async):
    """The same under ``async_``."""
