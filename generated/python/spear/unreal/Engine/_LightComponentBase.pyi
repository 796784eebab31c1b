# generated, do not edit (Engine: Public/Components/LightComponentBase.h)
from spear.typing import (
    AsyncBoolProperty, AsyncFloatProperty, AsyncObjectPath, BoolProperty, FloatProperty, Future, ObjectPath, Property, SendBoolProperty,
    SendFloatProperty, SendProperty,
)
from ..CoreUObject._NoExportTypes import FColor_async, FColor_in, FColor_path, FLinearColor
from ._SceneComponent import USceneComponent, USceneComponent_async, USceneComponent_members, USceneComponent_send

class ULightComponentBase_members(USceneComponent_members):
    """Functions and variables of ULightComponentBase."""
    def GetLightColor(self) -> FLinearColor:
        """Gets the light colour as a linear colour.

        Unreal: ULightComponentBase.GetLightColor
        """
    def SetAffectGlobalIllumination(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether the light affects global illumination.

        Unreal: ULightComponentBase.SetAffectGlobalIllumination
        """
    def SetAffectReflection(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether the light shows up in reflections.

        Unreal: ULightComponentBase.SetAffectReflection
        """
    def SetCastShadows(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether this light casts shadows.

        Unreal: ULightComponentBase.SetCastShadows
        """
    Intensity: FloatProperty
    """Total energy that the light emits: lux for a directional light, else in the light's IntensityUnits.

    Unreal: ULightComponentBase.Intensity (float)
    """
    LightColor: Property[FColor_path, FColor_in]
    """Filter colour of the light (sRGB). Note that this can change the light's effective intensity.

    Unreal: ULightComponentBase.LightColor (FColor)
    """
    bAffectsWorld: BoolProperty
    """Whether the light can affect the world, or whether it is disabled.

    Unreal: ULightComponentBase.bAffectsWorld (bool)
    """
    CastShadows: BoolProperty
    """Whether the light should cast any shadows.

    Unreal: ULightComponentBase.CastShadows (bool)
    """
    CastStaticShadows: BoolProperty
    """Whether the light should cast shadows from static objects.

    Unreal: ULightComponentBase.CastStaticShadows (bool)
    """
    CastDynamicShadows: BoolProperty
    """Whether the light should cast shadows from dynamic objects.

    Unreal: ULightComponentBase.CastDynamicShadows (bool)
    """
    bAffectTranslucentLighting: BoolProperty
    """Whether the light affects translucency or not.

    Unreal: ULightComponentBase.bAffectTranslucentLighting (bool)
    """
    bAffectReflection: BoolProperty
    """Whether the light shows up in reflections.

    Unreal: ULightComponentBase.bAffectReflection (bool)
    """
    bAffectGlobalIllumination: BoolProperty
    """Whether the light affects global illumination.

    Unreal: ULightComponentBase.bAffectGlobalIllumination (bool)
    """
    IndirectLightingIntensity: FloatProperty
    """Scales the indirect lighting contribution from this light. A value of 0 disables it.

    Unreal: ULightComponentBase.IndirectLightingIntensity (float)
    """
    VolumetricScatteringIntensity: FloatProperty
    """Intensity of the volumetric scattering from this light. This scales Intensity and LightColor.

    Unreal: ULightComponentBase.VolumetricScatteringIntensity (float)
    """

class ULightComponentBase_async(USceneComponent_async):
    """ULightComponentBase under ``async_``: each function gives a future."""
    def GetLightColor(self) -> Future[FLinearColor]:
        """Gets the light colour as a linear colour."""
    def SetAffectGlobalIllumination(self, bNewValue: bool | Future[bool]) -> Future[None]:
        """Sets whether the light affects global illumination."""
    def SetAffectReflection(self, bNewValue: bool | Future[bool]) -> Future[None]:
        """Sets whether the light shows up in reflections."""
    def SetCastShadows(self, bNewValue: bool | Future[bool]) -> Future[None]:
        """Sets whether this light casts shadows."""
    Intensity: AsyncFloatProperty
    """Total energy that the light emits: lux for a directional light, else in the light's IntensityUnits."""
    LightColor: Property[FColor_async, FColor_in]
    """Filter colour of the light (sRGB)."""
    bAffectsWorld: AsyncBoolProperty
    """Whether the light can affect the world, or whether it is disabled."""
    CastShadows: AsyncBoolProperty
    """Whether the light should cast any shadows."""
    CastStaticShadows: AsyncBoolProperty
    """Whether the light should cast shadows from static objects."""
    CastDynamicShadows: AsyncBoolProperty
    """Whether the light should cast shadows from dynamic objects."""
    bAffectTranslucentLighting: AsyncBoolProperty
    """Whether the light affects translucency or not."""
    bAffectReflection: AsyncBoolProperty
    """Whether the light shows up in reflections."""
    bAffectGlobalIllumination: AsyncBoolProperty
    """Whether the light affects global illumination."""
    IndirectLightingIntensity: AsyncFloatProperty
    """Scales the indirect lighting contribution from this light."""
    VolumetricScatteringIntensity: AsyncFloatProperty
    """Intensity of the volumetric scattering from this light."""

class ULightComponentBase_send(USceneComponent_send):
    """ULightComponentBase under ``send_``: no function answers."""
    def GetLightColor(self) -> None:
        """Gets the light colour as a linear colour."""
    def SetAffectGlobalIllumination(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether the light affects global illumination."""
    def SetAffectReflection(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether the light shows up in reflections."""
    def SetCastShadows(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether this light casts shadows."""
    Intensity: SendFloatProperty
    LightColor: SendProperty[FColor_in]
    bAffectsWorld: SendBoolProperty
    CastShadows: SendBoolProperty
    CastStaticShadows: SendBoolProperty
    CastDynamicShadows: SendBoolProperty
    bAffectTranslucentLighting: SendBoolProperty
    bAffectReflection: SendBoolProperty
    bAffectGlobalIllumination: SendBoolProperty
    IndirectLightingIntensity: SendFloatProperty
    VolumetricScatteringIntensity: SendFloatProperty

class ULightComponentBase(ULightComponentBase_members, USceneComponent):
    """What all lights, sky lights included, have in common. Epic page: ULightComponentBase.

    Unreal: /Script/Engine.LightComponentBase
    """
    @property
    def async_(self) -> ULightComponentBase_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> ULightComponentBase_send:
        """The same functions and variables, fire-and-forget."""

class ULightComponentBase_path(ObjectPath[ULightComponentBase, ULightComponentBase_async_path, ULightComponentBase_send], ULightComponentBase_members):
    """A variable that refers to an object of ULightComponentBase: its path."""

class ULightComponentBase_async_path(AsyncObjectPath[ULightComponentBase], ULightComponentBase_async):
    """The same under ``async_``."""
