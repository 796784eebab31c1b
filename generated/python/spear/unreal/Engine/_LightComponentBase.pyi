# generated, do not edit (Engine: Public/Components/LightComponentBase.h)
from spear.typing import AsyncObjectPath, AsyncPath, Future, ObjectPath, Path, Property, SendProperty
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
    Intensity: Property[Path[float], float | Future[float]]
    """Total energy that the light emits: lux for a directional light, else in the light's IntensityUnits.

    Unreal: ULightComponentBase.Intensity (float)
    """
    LightColor: Property[FColor_path, FColor_in]
    """Filter colour of the light (sRGB). Note that this can change the light's effective intensity.

    Unreal: ULightComponentBase.LightColor (FColor)
    """
    bAffectsWorld: Property[Path[bool], bool | Future[bool]]
    """Whether the light can affect the world, or whether it is disabled.

    Unreal: ULightComponentBase.bAffectsWorld (bool)
    """
    CastShadows: Property[Path[bool], bool | Future[bool]]
    """Whether the light should cast any shadows.

    Unreal: ULightComponentBase.CastShadows (bool)
    """
    CastStaticShadows: Property[Path[bool], bool | Future[bool]]
    """Whether the light should cast shadows from static objects.

    Unreal: ULightComponentBase.CastStaticShadows (bool)
    """
    CastDynamicShadows: Property[Path[bool], bool | Future[bool]]
    """Whether the light should cast shadows from dynamic objects.

    Unreal: ULightComponentBase.CastDynamicShadows (bool)
    """
    bAffectTranslucentLighting: Property[Path[bool], bool | Future[bool]]
    """Whether the light affects translucency or not.

    Unreal: ULightComponentBase.bAffectTranslucentLighting (bool)
    """
    bAffectReflection: Property[Path[bool], bool | Future[bool]]
    """Whether the light shows up in reflections.

    Unreal: ULightComponentBase.bAffectReflection (bool)
    """
    bAffectGlobalIllumination: Property[Path[bool], bool | Future[bool]]
    """Whether the light affects global illumination.

    Unreal: ULightComponentBase.bAffectGlobalIllumination (bool)
    """
    IndirectLightingIntensity: Property[Path[float], float | Future[float]]
    """Scales the indirect lighting contribution from this light. A value of 0 disables it.

    Unreal: ULightComponentBase.IndirectLightingIntensity (float)
    """
    VolumetricScatteringIntensity: Property[Path[float], float | Future[float]]
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
    Intensity: Property[AsyncPath[float], float | Future[float]]
    """Total energy that the light emits: lux for a directional light, else in the light's IntensityUnits."""
    LightColor: Property[FColor_async, FColor_in]
    """Filter colour of the light (sRGB)."""
    bAffectsWorld: Property[AsyncPath[bool], bool | Future[bool]]
    """Whether the light can affect the world, or whether it is disabled."""
    CastShadows: Property[AsyncPath[bool], bool | Future[bool]]
    """Whether the light should cast any shadows."""
    CastStaticShadows: Property[AsyncPath[bool], bool | Future[bool]]
    """Whether the light should cast shadows from static objects."""
    CastDynamicShadows: Property[AsyncPath[bool], bool | Future[bool]]
    """Whether the light should cast shadows from dynamic objects."""
    bAffectTranslucentLighting: Property[AsyncPath[bool], bool | Future[bool]]
    """Whether the light affects translucency or not."""
    bAffectReflection: Property[AsyncPath[bool], bool | Future[bool]]
    """Whether the light shows up in reflections."""
    bAffectGlobalIllumination: Property[AsyncPath[bool], bool | Future[bool]]
    """Whether the light affects global illumination."""
    IndirectLightingIntensity: Property[AsyncPath[float], float | Future[float]]
    """Scales the indirect lighting contribution from this light."""
    VolumetricScatteringIntensity: Property[AsyncPath[float], float | Future[float]]
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
    Intensity: SendProperty[float | Future[float]]
    LightColor: SendProperty[FColor_in]
    bAffectsWorld: SendProperty[bool | Future[bool]]
    CastShadows: SendProperty[bool | Future[bool]]
    CastStaticShadows: SendProperty[bool | Future[bool]]
    CastDynamicShadows: SendProperty[bool | Future[bool]]
    bAffectTranslucentLighting: SendProperty[bool | Future[bool]]
    bAffectReflection: SendProperty[bool | Future[bool]]
    bAffectGlobalIllumination: SendProperty[bool | Future[bool]]
    IndirectLightingIntensity: SendProperty[float | Future[float]]
    VolumetricScatteringIntensity: SendProperty[float | Future[float]]

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
