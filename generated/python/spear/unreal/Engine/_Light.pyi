# generated, do not edit (Engine: Public/Engine/Light.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath, Property, SendProperty
from ..CoreUObject._NoExportTypes import FLinearColor, FLinearColor_in
from ._Actor import AActor, AActor_async, AActor_members, AActor_send
from ._LightComponent import ULightComponent, ULightComponent_async_path, ULightComponent_path

class ALight_members(AActor_members):
    """Functions and variables of ALight."""
    def GetBrightness(self) -> float:
        """Gets the intensity of the light.

        Unreal: ALight.GetBrightness
        """
    def GetLightColor(self) -> FLinearColor:
        """Gets the colour of the light, linear.

        Unreal: ALight.GetLightColor
        """
    def IsEnabled(self) -> bool:
        """Whether the light is on.

        Unreal: ALight.IsEnabled
        """
    def SetAffectTranslucentLighting(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether the light affects translucency.

        Unreal: ALight.SetAffectTranslucentLighting
        """
    def SetBrightness(self, NewBrightness: float | Future[float]) -> None:
        """Sets the intensity of the light.

        Unreal: ALight.SetBrightness
        """
    def SetCastShadows(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether the light casts shadows.

        Unreal: ALight.SetCastShadows
        """
    def SetEnabled(self, bSetEnabled: bool | Future[bool]) -> None:
        """Turns the light on or off.

        Unreal: ALight.SetEnabled
        """
    def SetLightColor(self, NewLightColor: FLinearColor_in) -> None:
        """Sets the colour of the light, linear.

        Unreal: ALight.SetLightColor
        """
    def ToggleEnabled(self) -> None:
        """Toggles the light.

        Unreal: ALight.ToggleEnabled
        """
    LightComponent: Property[ULightComponent_path, ULightComponent | Future[ULightComponent] | None]
    """The light.

    Unreal: ALight.LightComponent (ULightComponent*)
    """

class ALight_async(AActor_async):
    """ALight under ``async_``: each function gives a future."""
    def GetBrightness(self) -> Future[float]:
        """Gets the intensity of the light."""
    def GetLightColor(self) -> Future[FLinearColor]:
        """Gets the colour of the light, linear."""
    def IsEnabled(self) -> Future[bool]:
        """Whether the light is on."""
    def SetAffectTranslucentLighting(self, bNewValue: bool | Future[bool]) -> Future[None]:
        """Sets whether the light affects translucency."""
    def SetBrightness(self, NewBrightness: float | Future[float]) -> Future[None]:
        """Sets the intensity of the light."""
    def SetCastShadows(self, bNewValue: bool | Future[bool]) -> Future[None]:
        """Sets whether the light casts shadows."""
    def SetEnabled(self, bSetEnabled: bool | Future[bool]) -> Future[None]:
        """Turns the light on or off."""
    def SetLightColor(self, NewLightColor: FLinearColor_in) -> Future[None]:
        """Sets the colour of the light, linear."""
    def ToggleEnabled(self) -> Future[None]:
        """Toggles the light."""
    LightComponent: Property[ULightComponent_async_path, ULightComponent | Future[ULightComponent] | None]
    """The light."""

class ALight_send(AActor_send):
    """ALight under ``send_``: no function answers."""
    def GetBrightness(self) -> None:
        """Gets the intensity of the light."""
    def GetLightColor(self) -> None:
        """Gets the colour of the light, linear."""
    def IsEnabled(self) -> None:
        """Whether the light is on."""
    def SetAffectTranslucentLighting(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether the light affects translucency."""
    def SetBrightness(self, NewBrightness: float | Future[float]) -> None:
        """Sets the intensity of the light."""
    def SetCastShadows(self, bNewValue: bool | Future[bool]) -> None:
        """Sets whether the light casts shadows."""
    def SetEnabled(self, bSetEnabled: bool | Future[bool]) -> None:
        """Turns the light on or off."""
    def SetLightColor(self, NewLightColor: FLinearColor_in) -> None:
        """Sets the colour of the light, linear."""
    def ToggleEnabled(self) -> None:
        """Toggles the light."""
    LightComponent: SendProperty[ULightComponent | Future[ULightComponent] | None]

class ALight(ALight_members, AActor):
    """Base of the actors with a light; its functions pass to the component. Epic page: ALight.

    Unreal: /Script/Engine.Light
    """
    @property
    def async_(self) -> ALight_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> ALight_send:
        """The same functions and variables, fire-and-forget."""

class ALight_path(ObjectPath[ALight, ALight_async_path, ALight_send], ALight_members):
    """A variable that refers to an object of ALight: its path."""

class ALight_async_path(AsyncObjectPath[ALight], ALight_async):
    """The same under ``async_``."""
