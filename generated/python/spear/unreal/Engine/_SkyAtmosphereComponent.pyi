# generated, do not edit (Engine: Public/Components/SkyAtmosphereComponent.h)
from typing import TypeAlias
from spear.enums import UnrealEnum
from spear.typing import (
    AsyncFloatProperty, AsyncObjectPath, AsyncValuePath, FloatProperty, Future, ObjectPath, Property, SendFloatProperty, SendProperty, ValuePath,
)
from ..CoreUObject._NoExportTypes import FColor_async, FColor_in, FColor_path, FLinearColor_async, FLinearColor_in, FLinearColor_path
from ._Info import AInfo, AInfo_async, AInfo_members, AInfo_send
from ._SceneComponent import USceneComponent, USceneComponent_async, USceneComponent_members, USceneComponent_send

class ESkyAtmosphereTransformMode(UnrealEnum):
    """Where the planet of a sky atmosphere is. Epic page: ESkyAtmosphereTransformMode.

    Unreal: /Script/Engine.ESkyAtmosphereTransformMode
    """
    PlanetTopAtAbsoluteWorldOrigin = 0
    """The top of the planet is at the world's origin."""
    PlanetTopAtComponentTransform = 1
    """The top of the planet is at the component."""
    PlanetCenterAtComponentTransform = 2
    """The centre of the planet is at the component."""

ESkyAtmosphereTransformMode_in: TypeAlias = ESkyAtmosphereTransformMode | str | Future[ESkyAtmosphereTransformMode]
"""What stands for ESkyAtmosphereTransformMode as an argument: an entry, the name that Unreal gives it, a future."""

class USkyAtmosphereComponent_members(USceneComponent_members):
    """Functions and variables of USkyAtmosphereComponent."""
    def SetAtmosphereHeight(self, NewValue: float | Future[float]) -> None:
        """Sets the height of the atmosphere, in kilometres.

        Unreal: USkyAtmosphereComponent.SetAtmosphereHeight
        """
    def SetBottomRadius(self, NewValue: float | Future[float]) -> None:
        """Sets the planet's radius, in kilometres.

        Unreal: USkyAtmosphereComponent.SetBottomRadius
        """
    def SetGroundAlbedo(self, NewValue: FColor_in) -> None:
        """Sets the ground albedo.

        Unreal: USkyAtmosphereComponent.SetGroundAlbedo
        """
    def SetMieAnisotropy(self, NewValue: float | Future[float]) -> None:
        """Sets the eccentricity of the Mie phase function.

        Unreal: USkyAtmosphereComponent.SetMieAnisotropy
        """
    def SetMieExponentialDistribution(self, NewValue: float | Future[float]) -> None:
        """Sets the altitude of the Mie distribution, in kilometres.

        Unreal: USkyAtmosphereComponent.SetMieExponentialDistribution
        """
    def SetMieScatteringScale(self, NewValue: float | Future[float]) -> None:
        """Sets the Mie scattering scale.

        Unreal: USkyAtmosphereComponent.SetMieScatteringScale
        """
    def SetMultiScatteringFactor(self, NewValue: float | Future[float]) -> None:
        """Sets the factor on the multiple scattering.

        Unreal: USkyAtmosphereComponent.SetMultiScatteringFactor
        """
    def SetRayleighExponentialDistribution(self, NewValue: float | Future[float]) -> None:
        """Sets the altitude of the Rayleigh distribution, in kilometres.

        Unreal: USkyAtmosphereComponent.SetRayleighExponentialDistribution
        """
    def SetRayleighScattering(self, NewValue: FLinearColor_in) -> None:
        """Sets the Rayleigh scattering coefficients.

        Unreal: USkyAtmosphereComponent.SetRayleighScattering
        """
    def SetRayleighScatteringScale(self, NewValue: float | Future[float]) -> None:
        """Sets the Rayleigh scattering scale.

        Unreal: USkyAtmosphereComponent.SetRayleighScatteringScale
        """
    TransformMode: Property[ValuePath[ESkyAtmosphereTransformMode, ESkyAtmosphereTransformMode_in], ESkyAtmosphereTransformMode_in]
    """Where the planet is.

    Unreal: USkyAtmosphereComponent.TransformMode (ESkyAtmosphereTransformMode)
    """
    BottomRadius: FloatProperty
    """The radius of the planet from its centre to the ground, in kilometres.

    0.1 to 10000.0

    Unreal: USkyAtmosphereComponent.BottomRadius (float)
    """
    GroundAlbedo: Property[FColor_path, FColor_in]
    """The ground albedo that tints the light bouncing off the ground.

    Unreal: USkyAtmosphereComponent.GroundAlbedo (FColor)
    """
    AtmosphereHeight: FloatProperty
    """The height of the atmosphere layer above the ground, in kilometres.

    at least 0.1

    Unreal: USkyAtmosphereComponent.AtmosphereHeight (float)
    """
    MultiScatteringFactor: FloatProperty
    """Factor on the multiple scattering: 1 is physical.

    0.0 to 100.0

    Unreal: USkyAtmosphereComponent.MultiScatteringFactor (float)
    """
    RayleighScatteringScale: FloatProperty
    """Rayleigh scattering coefficient scale, per kilometre.

    at least 0.0

    Unreal: USkyAtmosphereComponent.RayleighScatteringScale (float)
    """
    RayleighScattering: Property[FLinearColor_path, FLinearColor_in]
    """The Rayleigh scattering coefficients resulting from molecules in the air, relative to each other.

    Unreal: USkyAtmosphereComponent.RayleighScattering (FLinearColor)
    """
    RayleighExponentialDistribution: FloatProperty
    """The altitude at which the Rayleigh scattering effect is reduced to 40 %, in kilometres.

    at least 0.001

    Unreal: USkyAtmosphereComponent.RayleighExponentialDistribution (float)
    """
    MieScatteringScale: FloatProperty
    """Mie scattering coefficient scale, per kilometre.

    at least 0.0

    Unreal: USkyAtmosphereComponent.MieScatteringScale (float)
    """
    MieAnisotropy: FloatProperty
    """The phase function's eccentricity: 0 scatters all round, 1 only forward.

    0.0 to 0.999

    Unreal: USkyAtmosphereComponent.MieAnisotropy (float)
    """
    MieExponentialDistribution: FloatProperty
    """The altitude at which the Mie effects are reduced to 40 %, in kilometres.

    at least 0.001

    Unreal: USkyAtmosphereComponent.MieExponentialDistribution (float)
    """

class USkyAtmosphereComponent_async(USceneComponent_async):
    """USkyAtmosphereComponent under ``async_``: each function gives a future."""
    def SetAtmosphereHeight(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the height of the atmosphere, in kilometres."""
    def SetBottomRadius(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the planet's radius, in kilometres."""
    def SetGroundAlbedo(self, NewValue: FColor_in) -> Future[None]:
        """Sets the ground albedo."""
    def SetMieAnisotropy(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the eccentricity of the Mie phase function."""
    def SetMieExponentialDistribution(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the altitude of the Mie distribution, in kilometres."""
    def SetMieScatteringScale(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the Mie scattering scale."""
    def SetMultiScatteringFactor(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the factor on the multiple scattering."""
    def SetRayleighExponentialDistribution(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the altitude of the Rayleigh distribution, in kilometres."""
    def SetRayleighScattering(self, NewValue: FLinearColor_in) -> Future[None]:
        """Sets the Rayleigh scattering coefficients."""
    def SetRayleighScatteringScale(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the Rayleigh scattering scale."""
    TransformMode: Property[AsyncValuePath[ESkyAtmosphereTransformMode, ESkyAtmosphereTransformMode_in], ESkyAtmosphereTransformMode_in]
    """Where the planet is."""
    BottomRadius: AsyncFloatProperty
    """The radius of the planet from its centre to the ground, in kilometres."""
    GroundAlbedo: Property[FColor_async, FColor_in]
    """The ground albedo that tints the light bouncing off the ground."""
    AtmosphereHeight: AsyncFloatProperty
    """The height of the atmosphere layer above the ground, in kilometres."""
    MultiScatteringFactor: AsyncFloatProperty
    """Factor on the multiple scattering: 1 is physical."""
    RayleighScatteringScale: AsyncFloatProperty
    """Rayleigh scattering coefficient scale, per kilometre."""
    RayleighScattering: Property[FLinearColor_async, FLinearColor_in]
    """The Rayleigh scattering coefficients resulting from molecules in the air, relative to each other."""
    RayleighExponentialDistribution: AsyncFloatProperty
    """The altitude at which the Rayleigh scattering effect is reduced to 40 %, in kilometres."""
    MieScatteringScale: AsyncFloatProperty
    """Mie scattering coefficient scale, per kilometre."""
    MieAnisotropy: AsyncFloatProperty
    """The phase function's eccentricity: 0 scatters all round, 1 only forward."""
    MieExponentialDistribution: AsyncFloatProperty
    """The altitude at which the Mie effects are reduced to 40 %, in kilometres."""

class USkyAtmosphereComponent_send(USceneComponent_send):
    """USkyAtmosphereComponent under ``send_``: no function answers."""
    def SetAtmosphereHeight(self, NewValue: float | Future[float]) -> None:
        """Sets the height of the atmosphere, in kilometres."""
    def SetBottomRadius(self, NewValue: float | Future[float]) -> None:
        """Sets the planet's radius, in kilometres."""
    def SetGroundAlbedo(self, NewValue: FColor_in) -> None:
        """Sets the ground albedo."""
    def SetMieAnisotropy(self, NewValue: float | Future[float]) -> None:
        """Sets the eccentricity of the Mie phase function."""
    def SetMieExponentialDistribution(self, NewValue: float | Future[float]) -> None:
        """Sets the altitude of the Mie distribution, in kilometres."""
    def SetMieScatteringScale(self, NewValue: float | Future[float]) -> None:
        """Sets the Mie scattering scale."""
    def SetMultiScatteringFactor(self, NewValue: float | Future[float]) -> None:
        """Sets the factor on the multiple scattering."""
    def SetRayleighExponentialDistribution(self, NewValue: float | Future[float]) -> None:
        """Sets the altitude of the Rayleigh distribution, in kilometres."""
    def SetRayleighScattering(self, NewValue: FLinearColor_in) -> None:
        """Sets the Rayleigh scattering coefficients."""
    def SetRayleighScatteringScale(self, NewValue: float | Future[float]) -> None:
        """Sets the Rayleigh scattering scale."""
    TransformMode: SendProperty[ESkyAtmosphereTransformMode_in]
    BottomRadius: SendFloatProperty
    GroundAlbedo: SendProperty[FColor_in]
    AtmosphereHeight: SendFloatProperty
    MultiScatteringFactor: SendFloatProperty
    RayleighScatteringScale: SendFloatProperty
    RayleighScattering: SendProperty[FLinearColor_in]
    RayleighExponentialDistribution: SendFloatProperty
    MieScatteringScale: SendFloatProperty
    MieAnisotropy: SendFloatProperty
    MieExponentialDistribution: SendFloatProperty

class USkyAtmosphereComponent(USkyAtmosphereComponent_members, USceneComponent):
    """The air that makes the sky blue, lit by directional lights with bAtmosphereSunLight. Epic page:
    USkyAtmosphereComponent.

    Unreal: /Script/Engine.SkyAtmosphereComponent
    """
    @property
    def async_(self) -> USkyAtmosphereComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> USkyAtmosphereComponent_send:
        """The same functions and variables, fire-and-forget."""

class USkyAtmosphereComponent_path(ObjectPath[USkyAtmosphereComponent, USkyAtmosphereComponent_async_path, USkyAtmosphereComponent_send], USkyAtmosphereComponent_members):
    """A variable that refers to an object of USkyAtmosphereComponent: its path."""

class USkyAtmosphereComponent_async_path(AsyncObjectPath[USkyAtmosphereComponent], USkyAtmosphereComponent_async):
    """The same under ``async_``."""

class ASkyAtmosphere_members(AInfo_members):
    """Functions and variables of ASkyAtmosphere."""
    SkyAtmosphereComponent: Property[USkyAtmosphereComponent_path, USkyAtmosphereComponent | Future[USkyAtmosphereComponent] | None]
    """The atmosphere.

    Unreal: ASkyAtmosphere.SkyAtmosphereComponent (USkyAtmosphereComponent*)
    """

class ASkyAtmosphere_async(AInfo_async):
    """ASkyAtmosphere under ``async_``: each function gives a future."""
    SkyAtmosphereComponent: Property[USkyAtmosphereComponent_async_path, USkyAtmosphereComponent | Future[USkyAtmosphereComponent] | None]
    """The atmosphere."""

class ASkyAtmosphere_send(AInfo_send):
    """ASkyAtmosphere under ``send_``: no function answers."""
    SkyAtmosphereComponent: SendProperty[USkyAtmosphereComponent | Future[USkyAtmosphereComponent] | None]

class ASkyAtmosphere(ASkyAtmosphere_members, AInfo):
    """An actor with a sky atmosphere. Epic page: ASkyAtmosphere.

    Unreal: /Script/Engine.SkyAtmosphere
    """
    @property
    def async_(self) -> ASkyAtmosphere_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> ASkyAtmosphere_send:
        """The same functions and variables, fire-and-forget."""

class ASkyAtmosphere_path(ObjectPath[ASkyAtmosphere, ASkyAtmosphere_async_path, ASkyAtmosphere_send], ASkyAtmosphere_members):
    """A variable that refers to an object of ASkyAtmosphere: its path."""

class ASkyAtmosphere_async_path(AsyncObjectPath[ASkyAtmosphere], ASkyAtmosphere_async):
    """The same under ``async_``."""
