# generated, do not edit (Engine: Public/Components/LocalLightComponent.h)
from spear.typing import (
    AsyncFloatProperty, AsyncObjectPath, AsyncValuePath, FloatProperty, Future, ObjectPath, Property, SendFloatProperty, SendProperty, ValuePath,
)
from ._LightComponent import ULightComponent, ULightComponent_async, ULightComponent_members, ULightComponent_send
from ._Scene import ELightUnits, ELightUnits_in

class ULocalLightComponent_members(ULightComponent_members):
    """Functions and variables of ULocalLightComponent."""
    def GetUnitsConversionFactor(self, SrcUnits: ELightUnits_in, TargetUnits: ELightUnits_in, CosHalfConeAngle: float | Future[float] = -1.0) -> float:
        """Factor between two units of intensity. EV is logarithmic, no factor leads there or from there: the result is
        1.

        Args:
            CosHalfConeAngle: cosine of half the cone the light fills: -1 for all directions; lumens depend on it

        Unreal: ULocalLightComponent.GetUnitsConversionFactor (static)
        """
    def SetAttenuationRadius(self, NewRadius: float | Future[float]) -> None:
        """Sets the attenuation radius, in centimetres.

        Unreal: ULocalLightComponent.SetAttenuationRadius
        """
    def SetIntensityUnits(self, NewIntensityUnits: ELightUnits_in) -> None:
        """Sets the units used for the intensity; the number itself stays.

        Unreal: ULocalLightComponent.SetIntensityUnits
        """
    def SetInverseExposureBlend(self, NewInverseExposureBlend: float | Future[float]) -> None:
        """Sets the blend factor for the inverse exposure.

        Unreal: ULocalLightComponent.SetInverseExposureBlend
        """
    IntensityUnits: Property[ValuePath[ELightUnits, ELightUnits_in], ELightUnits_in]
    """Units used for the intensity. The peak luminous intensity is measured in candelas, the luminous power in
    lumens.

    Unreal: ULocalLightComponent.IntensityUnits (ELightUnits)
    """
    InverseExposureBlend: FloatProperty
    """Blend factor for the inverse exposure, for lights that ignore exposure. 0 is physical.

    0.0 to 1.0

    Unreal: ULocalLightComponent.InverseExposureBlend (float)
    """
    AttenuationRadius: FloatProperty
    """Bounds the light's visible influence, in centimetres. This clamping of the influence is not physically
    correct.

    at least 0.0

    Unreal: ULocalLightComponent.AttenuationRadius (float)
    """

class ULocalLightComponent_async(ULightComponent_async):
    """ULocalLightComponent under ``async_``: each function gives a future."""
    def GetUnitsConversionFactor(self, SrcUnits: ELightUnits_in, TargetUnits: ELightUnits_in, CosHalfConeAngle: float | Future[float] = -1.0) -> Future[float]:
        """Factor between two units of intensity."""
    def SetAttenuationRadius(self, NewRadius: float | Future[float]) -> Future[None]:
        """Sets the attenuation radius, in centimetres."""
    def SetIntensityUnits(self, NewIntensityUnits: ELightUnits_in) -> Future[None]:
        """Sets the units used for the intensity; the number itself stays."""
    def SetInverseExposureBlend(self, NewInverseExposureBlend: float | Future[float]) -> Future[None]:
        """Sets the blend factor for the inverse exposure."""
    IntensityUnits: Property[AsyncValuePath[ELightUnits, ELightUnits_in], ELightUnits_in]
    """Units used for the intensity."""
    InverseExposureBlend: AsyncFloatProperty
    """Blend factor for the inverse exposure, for lights that ignore exposure. 0 is physical."""
    AttenuationRadius: AsyncFloatProperty
    """Bounds the light's visible influence, in centimetres."""

class ULocalLightComponent_send(ULightComponent_send):
    """ULocalLightComponent under ``send_``: no function answers."""
    def GetUnitsConversionFactor(self, SrcUnits: ELightUnits_in, TargetUnits: ELightUnits_in, CosHalfConeAngle: float | Future[float] = -1.0) -> None:
        """Factor between two units of intensity."""
    def SetAttenuationRadius(self, NewRadius: float | Future[float]) -> None:
        """Sets the attenuation radius, in centimetres."""
    def SetIntensityUnits(self, NewIntensityUnits: ELightUnits_in) -> None:
        """Sets the units used for the intensity; the number itself stays."""
    def SetInverseExposureBlend(self, NewInverseExposureBlend: float | Future[float]) -> None:
        """Sets the blend factor for the inverse exposure."""
    IntensityUnits: SendProperty[ELightUnits_in]
    InverseExposureBlend: SendFloatProperty
    AttenuationRadius: SendFloatProperty

class ULocalLightComponent(ULocalLightComponent_members, ULightComponent):
    """A light with a place and a reach: point, spot and rectangular lights. Epic page: ULocalLightComponent.

    Unreal: /Script/Engine.LocalLightComponent
    """
    @property
    def async_(self) -> ULocalLightComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> ULocalLightComponent_send:
        """The same functions and variables, fire-and-forget."""

class ULocalLightComponent_path(ObjectPath[ULocalLightComponent, ULocalLightComponent_async_path, ULocalLightComponent_send], ULocalLightComponent_members):
    """A variable that refers to an object of ULocalLightComponent: its path."""

class ULocalLightComponent_async_path(AsyncObjectPath[ULocalLightComponent], ULocalLightComponent_async):
    """The same under ``async_``."""
