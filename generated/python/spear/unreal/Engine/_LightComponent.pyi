# generated, do not edit (Engine: Public/Components/LightComponent.h)
from spear.typing import (
    AsyncBoolProperty, AsyncFloatProperty, AsyncObjectPath, BoolProperty, FloatProperty, Future, ObjectPath, Property, SendBoolProperty,
    SendFloatProperty, SendProperty,
)
from ..CoreUObject._NoExportTypes import FLinearColor_in
from ._EngineTypes import FLightingChannels_async, FLightingChannels_in, FLightingChannels_path
from ._LightComponentBase import ULightComponentBase, ULightComponentBase_async, ULightComponentBase_members, ULightComponentBase_send

class ULightComponent_members(ULightComponentBase_members):
    """Functions and variables of ULightComponent."""
    def SetAffectTranslucentLighting(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether the light affects translucency.

        Unreal: ULightComponent.SetAffectTranslucentLighting
        """
    def SetDiffuseScale(self, NewValue: float | Future[float]) -> None:
        """Sets the multiplier on diffuse lighting.

        Unreal: ULightComponent.SetDiffuseScale
        """
    def SetIndirectLightingIntensity(self, NewIntensity: float | Future[float]) -> None:
        """Sets the scale of the indirect lighting.

        Unreal: ULightComponent.SetIndirectLightingIntensity
        """
    def SetIntensity(self, NewIntensity: float | Future[float]) -> None:
        """Sets the intensity of the light, in the light's units.

        Unreal: ULightComponent.SetIntensity
        """
    def SetLightColor(self, NewLightColor: FLinearColor_in, bSRGB: bool | Future[bool] = True) -> None:
        """Sets the colour of the light.

        Args:
            NewLightColor: the colour, linear
            bSRGB: whether to store it gamma-encoded (the usual; the component reads it that way)

        Unreal: ULightComponent.SetLightColor
        """
    def SetLightingChannels(self, bChannel0: bool | Future[bool], bChannel1: bool | Future[bool], bChannel2: bool | Future[bool]) -> None:
        """Sets the lighting channels.

        Unreal: ULightComponent.SetLightingChannels
        """
    def SetShadowBias(self, NewValue: float | Future[float]) -> None:
        """Sets the shadow bias.

        Unreal: ULightComponent.SetShadowBias
        """
    def SetShadowSlopeBias(self, NewValue: float | Future[float]) -> None:
        """Sets the shadow slope bias.

        Unreal: ULightComponent.SetShadowSlopeBias
        """
    def SetSpecularScale(self, NewValue: float | Future[float]) -> None:
        """Sets the multiplier on specular highlights.

        Unreal: ULightComponent.SetSpecularScale
        """
    def SetTemperature(self, NewTemperature: float | Future[float]) -> None:
        """Sets the colour temperature of the light, in kelvin.

        Unreal: ULightComponent.SetTemperature
        """
    def SetUseTemperature(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether the colour temperature counts.

        Unreal: ULightComponent.SetUseTemperature
        """
    def SetVolumetricScatteringIntensity(self, NewIntensity: float | Future[float]) -> None:
        """Sets the scale of the volumetric scattering.

        Unreal: ULightComponent.SetVolumetricScatteringIntensity
        """
    Temperature: FloatProperty
    """Colour temperature in kelvin of the blackbody illuminant. White (D65) is 6500 K.

    Unreal: ULightComponent.Temperature (float)
    """
    MaxDrawDistance: FloatProperty
    """Distance at which the light is culled, in centimetres. 0 disables it.

    Unreal: ULightComponent.MaxDrawDistance (float)
    """
    MaxDistanceFadeRange: FloatProperty
    """Distance over which the light fades before MaxDrawDistance, in centimetres.

    Unreal: ULightComponent.MaxDistanceFadeRange (float)
    """
    bUseTemperature: BoolProperty
    """Whether the temperature, as a blackbody colour, multiplies the light colour.

    Unreal: ULightComponent.bUseTemperature (bool)
    """
    ShadowBias: FloatProperty
    """Controls how accurate self shadowing of the whole scene's shadows from this light is.

    Unreal: ULightComponent.ShadowBias (float)
    """
    ShadowSlopeBias: FloatProperty
    """Controls how accurate self shadowing is on slopes.

    Unreal: ULightComponent.ShadowSlopeBias (float)
    """
    SpecularScale: FloatProperty
    """Multiplier on specular highlights. Use only with great care: any value besides 1 is not physical.

    Unreal: ULightComponent.SpecularScale (float)
    """
    DiffuseScale: FloatProperty
    """Multiplier on diffuse lighting. Use only with great care: any value besides 1 is not physical.

    Unreal: ULightComponent.DiffuseScale (float)
    """
    LightingChannels: Property[FLightingChannels_path, FLightingChannels_in]
    """Channels that this light should affect.

    Unreal: ULightComponent.LightingChannels (FLightingChannels)
    """

class ULightComponent_async(ULightComponentBase_async):
    """ULightComponent under ``async_``: each function gives a future."""
    def SetAffectTranslucentLighting(self, bNewValue: bool | Future[bool]) -> Future[None]:
        """Sets whether the light affects translucency."""
    def SetDiffuseScale(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the multiplier on diffuse lighting."""
    def SetIndirectLightingIntensity(self, NewIntensity: float | Future[float]) -> Future[None]:
        """Sets the scale of the indirect lighting."""
    def SetIntensity(self, NewIntensity: float | Future[float]) -> Future[None]:
        """Sets the intensity of the light, in the light's units."""
    def SetLightColor(self, NewLightColor: FLinearColor_in, bSRGB: bool | Future[bool] = True) -> Future[None]:
        """Sets the colour of the light."""
    def SetLightingChannels(self, bChannel0: bool | Future[bool], bChannel1: bool | Future[bool], bChannel2: bool | Future[bool]) -> Future[None]:
        """Sets the lighting channels."""
    def SetShadowBias(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the shadow bias."""
    def SetShadowSlopeBias(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the shadow slope bias."""
    def SetSpecularScale(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the multiplier on specular highlights."""
    def SetTemperature(self, NewTemperature: float | Future[float]) -> Future[None]:
        """Sets the colour temperature of the light, in kelvin."""
    def SetUseTemperature(self, bNewValue: bool | Future[bool]) -> Future[None]:
        """Sets whether the colour temperature counts."""
    def SetVolumetricScatteringIntensity(self, NewIntensity: float | Future[float]) -> Future[None]:
        """Sets the scale of the volumetric scattering."""
    Temperature: AsyncFloatProperty
    """Colour temperature in kelvin of the blackbody illuminant."""
    MaxDrawDistance: AsyncFloatProperty
    """Distance at which the light is culled, in centimetres. 0 disables it."""
    MaxDistanceFadeRange: AsyncFloatProperty
    """Distance over which the light fades before MaxDrawDistance, in centimetres."""
    bUseTemperature: AsyncBoolProperty
    """Whether the temperature, as a blackbody colour, multiplies the light colour."""
    ShadowBias: AsyncFloatProperty
    """Controls how accurate self shadowing of the whole scene's shadows from this light is."""
    ShadowSlopeBias: AsyncFloatProperty
    """Controls how accurate self shadowing is on slopes."""
    SpecularScale: AsyncFloatProperty
    """Multiplier on specular highlights."""
    DiffuseScale: AsyncFloatProperty
    """Multiplier on diffuse lighting."""
    LightingChannels: Property[FLightingChannels_async, FLightingChannels_in]
    """Channels that this light should affect."""

class ULightComponent_send(ULightComponentBase_send):
    """ULightComponent under ``send_``: no function answers."""
    def SetAffectTranslucentLighting(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether the light affects translucency."""
    def SetDiffuseScale(self, NewValue: float | Future[float]) -> None:
        """Sets the multiplier on diffuse lighting."""
    def SetIndirectLightingIntensity(self, NewIntensity: float | Future[float]) -> None:
        """Sets the scale of the indirect lighting."""
    def SetIntensity(self, NewIntensity: float | Future[float]) -> None:
        """Sets the intensity of the light, in the light's units."""
    def SetLightColor(self, NewLightColor: FLinearColor_in, bSRGB: bool | Future[bool] = True) -> None:
        """Sets the colour of the light."""
    def SetLightingChannels(self, bChannel0: bool | Future[bool], bChannel1: bool | Future[bool], bChannel2: bool | Future[bool]) -> None:
        """Sets the lighting channels."""
    def SetShadowBias(self, NewValue: float | Future[float]) -> None:
        """Sets the shadow bias."""
    def SetShadowSlopeBias(self, NewValue: float | Future[float]) -> None:
        """Sets the shadow slope bias."""
    def SetSpecularScale(self, NewValue: float | Future[float]) -> None:
        """Sets the multiplier on specular highlights."""
    def SetTemperature(self, NewTemperature: float | Future[float]) -> None:
        """Sets the colour temperature of the light, in kelvin."""
    def SetUseTemperature(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether the colour temperature counts."""
    def SetVolumetricScatteringIntensity(self, NewIntensity: float | Future[float]) -> None:
        """Sets the scale of the volumetric scattering."""
    Temperature: SendFloatProperty
    MaxDrawDistance: SendFloatProperty
    MaxDistanceFadeRange: SendFloatProperty
    bUseTemperature: SendBoolProperty
    ShadowBias: SendFloatProperty
    ShadowSlopeBias: SendFloatProperty
    SpecularScale: SendFloatProperty
    DiffuseScale: SendFloatProperty
    LightingChannels: SendProperty[FLightingChannels_in]

class ULightComponent(ULightComponent_members, ULightComponentBase):
    """A light that comes from a direction or a place (every light but the sky light). Epic page: ULightComponent.

    Unreal: /Script/Engine.LightComponent
    """
    @property
    def async_(self) -> ULightComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> ULightComponent_send:
        """The same functions and variables, fire-and-forget."""

class ULightComponent_path(ObjectPath[ULightComponent, ULightComponent_async_path, ULightComponent_send], ULightComponent_members):
    """A variable that refers to an object of ULightComponent: its path."""

class ULightComponent_async_path(AsyncObjectPath[ULightComponent], ULightComponent_async):
    """The same under ``async_``."""
