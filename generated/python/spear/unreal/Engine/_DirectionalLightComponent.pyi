# generated, do not edit (Engine: Public/Components/DirectionalLightComponent.h)
from spear.typing import (
    AsyncBoolProperty, AsyncFloatProperty, AsyncIntProperty, AsyncObjectPath, BoolProperty, FloatProperty, Future, IntProperty, ObjectPath,
    SendBoolProperty, SendFloatProperty, SendIntProperty,
)
from ._LightComponent import ULightComponent, ULightComponent_async, ULightComponent_members, ULightComponent_send

class UDirectionalLightComponent_members(ULightComponent_members):
    """Functions and variables of UDirectionalLightComponent."""
    def SetAtmosphereSunLight(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether the light interacts with the atmosphere.

        Unreal: UDirectionalLightComponent.SetAtmosphereSunLight
        """
    def SetAtmosphereSunLightIndex(self, NewValue: int | Future[int]) -> None:
        """Sets which of the atmosphere's lights this is.

        Unreal: UDirectionalLightComponent.SetAtmosphereSunLightIndex
        """
    def SetDynamicShadowDistanceMovableLight(self, NewValue: float | Future[float]) -> None:
        """Sets how far dynamic shadows reach, in centimetres.

        Unreal: UDirectionalLightComponent.SetDynamicShadowDistanceMovableLight
        """
    def SetLightSourceAngle(self, NewValue: float | Future[float]) -> None:
        """Sets the angle that the light source subtends, in degrees.

        Unreal: UDirectionalLightComponent.SetLightSourceAngle
        """
    def SetLightSourceSoftAngle(self, NewValue: float | Future[float]) -> None:
        """Sets the angle that the soft light source subtends, in degrees.

        Unreal: UDirectionalLightComponent.SetLightSourceSoftAngle
        """
    LightSourceAngle: FloatProperty
    """Angle that the light source subtends, in degrees. The sun's is 0.5357.

    Unreal: UDirectionalLightComponent.LightSourceAngle (float)
    """
    LightSourceSoftAngle: FloatProperty
    """Angle that the soft light source subtends, in degrees.

    Unreal: UDirectionalLightComponent.LightSourceSoftAngle (float)
    """
    DynamicShadowDistanceMovableLight: FloatProperty
    """How far the dynamic shadows of a movable light reach, in centimetres.

    Unreal: UDirectionalLightComponent.DynamicShadowDistanceMovableLight (float)
    """
    bAtmosphereSunLight: BoolProperty
    """Whether the directional light can interact with the atmosphere: it draws the sun's disc and lights the sky.

    Unreal: UDirectionalLightComponent.bAtmosphereSunLight (bool)
    """
    AtmosphereSunLightIndex: IntProperty
    """Two atmosphere lights are supported: 0 is the sun, 1 for instance the moon.

    0 to 1

    Unreal: UDirectionalLightComponent.AtmosphereSunLightIndex (int32)
    """

class UDirectionalLightComponent_async(ULightComponent_async):
    """UDirectionalLightComponent under ``async_``: each function gives a future."""
    def SetAtmosphereSunLight(self, bNewValue: bool | Future[bool]) -> Future[None]:
        """Sets whether the light interacts with the atmosphere."""
    def SetAtmosphereSunLightIndex(self, NewValue: int | Future[int]) -> Future[None]:
        """Sets which of the atmosphere's lights this is."""
    def SetDynamicShadowDistanceMovableLight(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets how far dynamic shadows reach, in centimetres."""
    def SetLightSourceAngle(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the angle that the light source subtends, in degrees."""
    def SetLightSourceSoftAngle(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the angle that the soft light source subtends, in degrees."""
    LightSourceAngle: AsyncFloatProperty
    """Angle that the light source subtends, in degrees."""
    LightSourceSoftAngle: AsyncFloatProperty
    """Angle that the soft light source subtends, in degrees."""
    DynamicShadowDistanceMovableLight: AsyncFloatProperty
    """How far the dynamic shadows of a movable light reach, in centimetres."""
    bAtmosphereSunLight: AsyncBoolProperty
    """Whether the directional light can interact with the atmosphere: it draws the sun's disc and lights the sky."""
    AtmosphereSunLightIndex: AsyncIntProperty
    """Two atmosphere lights are supported: 0 is the sun, 1 for instance the moon."""

class UDirectionalLightComponent_send(ULightComponent_send):
    """UDirectionalLightComponent under ``send_``: no function answers."""
    def SetAtmosphereSunLight(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether the light interacts with the atmosphere."""
    def SetAtmosphereSunLightIndex(self, NewValue: int | Future[int]) -> None:
        """Sets which of the atmosphere's lights this is."""
    def SetDynamicShadowDistanceMovableLight(self, NewValue: float | Future[float]) -> None:
        """Sets how far dynamic shadows reach, in centimetres."""
    def SetLightSourceAngle(self, NewValue: float | Future[float]) -> None:
        """Sets the angle that the light source subtends, in degrees."""
    def SetLightSourceSoftAngle(self, NewValue: float | Future[float]) -> None:
        """Sets the angle that the soft light source subtends, in degrees."""
    LightSourceAngle: SendFloatProperty
    LightSourceSoftAngle: SendFloatProperty
    DynamicShadowDistanceMovableLight: SendFloatProperty
    bAtmosphereSunLight: SendBoolProperty
    AtmosphereSunLightIndex: SendIntProperty

class UDirectionalLightComponent(UDirectionalLightComponent_members, ULightComponent):
    """A light whose rays are parallel: the sun or the moon. Its intensity is in lux, its direction the local X axis.
    Epic page: UDirectionalLightComponent.

    Unreal: /Script/Engine.DirectionalLightComponent
    """
    @property
    def async_(self) -> UDirectionalLightComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UDirectionalLightComponent_send:
        """The same functions and variables, fire-and-forget."""

class UDirectionalLightComponent_path(ObjectPath[UDirectionalLightComponent, UDirectionalLightComponent_async_path, UDirectionalLightComponent_send], UDirectionalLightComponent_members):
    """A variable that refers to an object of UDirectionalLightComponent: its path."""

class UDirectionalLightComponent_async_path(AsyncObjectPath[UDirectionalLightComponent], UDirectionalLightComponent_async):
    """The same under ``async_``."""
