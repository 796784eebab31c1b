# generated, do not edit (Engine: Public/Engine/SpotLight.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath, Property, SendProperty
from ._Light import ALight, ALight_async, ALight_members, ALight_send
from ._SpotLightComponent import USpotLightComponent, USpotLightComponent_async_path, USpotLightComponent_path

class ASpotLight_members(ALight_members):
    """Functions and variables of ASpotLight."""
    def SetInnerConeAngle(self, NewInnerConeAngle: float | Future[float]) -> None:
        """Sets the inner cone angle of the light, in degrees.

        Unreal: ASpotLight.SetInnerConeAngle
        """
    def SetOuterConeAngle(self, NewOuterConeAngle: float | Future[float]) -> None:
        """Sets the outer cone angle of the light, in degrees.

        Unreal: ASpotLight.SetOuterConeAngle
        """
    SpotLightComponent: Property[USpotLightComponent_path, USpotLightComponent | Future[USpotLightComponent] | None]
    """The light.

    Unreal: ASpotLight.SpotLightComponent (USpotLightComponent*)
    """

class ASpotLight_async(ALight_async):
    """ASpotLight under ``async_``: each function gives a future."""
    def SetInnerConeAngle(self, NewInnerConeAngle: float | Future[float]) -> Future[None]:
        """Sets the inner cone angle of the light, in degrees."""
    def SetOuterConeAngle(self, NewOuterConeAngle: float | Future[float]) -> Future[None]:
        """Sets the outer cone angle of the light, in degrees."""
    SpotLightComponent: Property[USpotLightComponent_async_path, USpotLightComponent | Future[USpotLightComponent] | None]
    """The light."""

class ASpotLight_send(ALight_send):
    """ASpotLight under ``send_``: no function answers."""
    def SetInnerConeAngle(self, NewInnerConeAngle: float | Future[float]) -> None:
        """Sets the inner cone angle of the light, in degrees."""
    def SetOuterConeAngle(self, NewOuterConeAngle: float | Future[float]) -> None:
        """Sets the outer cone angle of the light, in degrees."""
    SpotLightComponent: SendProperty[USpotLightComponent | Future[USpotLightComponent] | None]

class ASpotLight(ASpotLight_members, ALight):
    """An actor with a spot light. Epic page: ASpotLight.

    Unreal: /Script/Engine.SpotLight
    """
    @property
    def async_(self) -> ASpotLight_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> ASpotLight_send:
        """The same functions and variables, fire-and-forget."""

class ASpotLight_path(ObjectPath[ASpotLight, ASpotLight_async_path, ASpotLight_send], ASpotLight_members):
    """A variable that refers to an object of ASpotLight: its path."""

class ASpotLight_async_path(AsyncObjectPath[ASpotLight], ASpotLight_async):
    """The same under ``async_``."""
