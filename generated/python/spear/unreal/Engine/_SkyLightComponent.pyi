# generated, do not edit (Engine: Public/Components/SkyLightComponent.h)
from spear.typing import (
    AsyncBoolProperty, AsyncFloatProperty, AsyncObjectPath, BoolProperty, FloatProperty, Future, ObjectPath, Property, SendBoolProperty,
    SendFloatProperty, SendProperty,
)
from ..CoreUObject._NoExportTypes import FLinearColor_async, FLinearColor_in, FLinearColor_path
from ._LightComponentBase import ULightComponentBase, ULightComponentBase_async, ULightComponentBase_members, ULightComponentBase_send

class USkyLightComponent_members(ULightComponentBase_members):
    """Functions and variables of USkyLightComponent."""
    def SetIndirectLightingIntensity(self, NewIntensity: float | Future[float]) -> None:
        """Sets the scale of the indirect lighting.

        Unreal: USkyLightComponent.SetIndirectLightingIntensity
        """
    def SetIntensity(self, NewIntensity: float | Future[float]) -> None:
        """Sets the brightness of the light.

        Unreal: USkyLightComponent.SetIntensity
        """
    def SetLightColor(self, NewLightColor: FLinearColor_in) -> None:
        """Sets the colour of the light, linear.

        Unreal: USkyLightComponent.SetLightColor
        """
    def SetLowerHemisphereColor(self, InLowerHemisphereColor: FLinearColor_in) -> None:
        """Sets the colour of the lower hemisphere, linear.

        Unreal: USkyLightComponent.SetLowerHemisphereColor
        """
    def SetVolumetricScatteringIntensity(self, NewIntensity: float | Future[float]) -> None:
        """Sets the scale of the volumetric scattering.

        Unreal: USkyLightComponent.SetVolumetricScatteringIntensity
        """
    SkyDistanceThreshold: FloatProperty
    """Distance from the sky light at which any geometry should be treated as part of the sky, in centimetres.

    Unreal: USkyLightComponent.SkyDistanceThreshold (float)
    """
    bLowerHemisphereIsBlack: BoolProperty
    """Whether all distant lighting from the lower hemisphere should be set to LowerHemisphereColor.

    Unreal: USkyLightComponent.bLowerHemisphereIsBlack (bool)
    """
    LowerHemisphereColor: Property[FLinearColor_path, FLinearColor_in]
    """The colour of the lower hemisphere, linear.

    Unreal: USkyLightComponent.LowerHemisphereColor (FLinearColor)
    """

class USkyLightComponent_async(ULightComponentBase_async):
    """USkyLightComponent under ``async_``: each function gives a future."""
    def SetIndirectLightingIntensity(self, NewIntensity: float | Future[float]) -> Future[None]:
        """Sets the scale of the indirect lighting."""
    def SetIntensity(self, NewIntensity: float | Future[float]) -> Future[None]:
        """Sets the brightness of the light."""
    def SetLightColor(self, NewLightColor: FLinearColor_in) -> Future[None]:
        """Sets the colour of the light, linear."""
    def SetLowerHemisphereColor(self, InLowerHemisphereColor: FLinearColor_in) -> Future[None]:
        """Sets the colour of the lower hemisphere, linear."""
    def SetVolumetricScatteringIntensity(self, NewIntensity: float | Future[float]) -> Future[None]:
        """Sets the scale of the volumetric scattering."""
    SkyDistanceThreshold: AsyncFloatProperty
    """Distance from the sky light at which any geometry should be treated as part of the sky, in centimetres."""
    bLowerHemisphereIsBlack: AsyncBoolProperty
    """Whether all distant lighting from the lower hemisphere should be set to LowerHemisphereColor."""
    LowerHemisphereColor: Property[FLinearColor_async, FLinearColor_in]
    """The colour of the lower hemisphere, linear."""

class USkyLightComponent_send(ULightComponentBase_send):
    """USkyLightComponent under ``send_``: no function answers."""
    def SetIndirectLightingIntensity(self, NewIntensity: float | Future[float]) -> None:
        """Sets the scale of the indirect lighting."""
    def SetIntensity(self, NewIntensity: float | Future[float]) -> None:
        """Sets the brightness of the light."""
    def SetLightColor(self, NewLightColor: FLinearColor_in) -> None:
        """Sets the colour of the light, linear."""
    def SetLowerHemisphereColor(self, InLowerHemisphereColor: FLinearColor_in) -> None:
        """Sets the colour of the lower hemisphere, linear."""
    def SetVolumetricScatteringIntensity(self, NewIntensity: float | Future[float]) -> None:
        """Sets the scale of the volumetric scattering."""
    SkyDistanceThreshold: SendFloatProperty
    bLowerHemisphereIsBlack: SendBoolProperty
    LowerHemisphereColor: SendProperty[FLinearColor_in]

class USkyLightComponent(USkyLightComponent_members, ULightComponentBase):
    """Light from everything far away: the sky. Epic page: USkyLightComponent.

    Unreal: /Script/Engine.SkyLightComponent
    """
    @property
    def async_(self) -> USkyLightComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> USkyLightComponent_send:
        """The same functions and variables, fire-and-forget."""

class USkyLightComponent_path(ObjectPath[USkyLightComponent, USkyLightComponent_async_path, USkyLightComponent_send], USkyLightComponent_members):
    """A variable that refers to an object of USkyLightComponent: its path."""

class USkyLightComponent_async_path(AsyncObjectPath[USkyLightComponent], USkyLightComponent_async):
    """The same under ``async_``."""
