# generated, do not edit (Engine: Public/Components/RectLightComponent.h)
from spear.typing import AsyncFloatProperty, AsyncObjectPath, FloatProperty, Future, ObjectPath, Property, SendFloatProperty, SendProperty
from ._LocalLightComponent import ULocalLightComponent, ULocalLightComponent_async, ULocalLightComponent_members, ULocalLightComponent_send
from ._Texture import UTexture, UTexture_async_path, UTexture_path

class URectLightComponent_members(ULocalLightComponent_members):
    """Functions and variables of URectLightComponent."""
    def SetBarnDoorAngle(self, NewValue: float | Future[float]) -> None:
        """Sets the angle of the barn doors, in degrees.

        Unreal: URectLightComponent.SetBarnDoorAngle
        """
    def SetBarnDoorLength(self, NewValue: float | Future[float]) -> None:
        """Sets the length of the barn doors, in centimetres.

        Unreal: URectLightComponent.SetBarnDoorLength
        """
    def SetSourceHeight(self, NewValue: float | Future[float]) -> None:
        """Sets the height of the rectangle, in centimetres.

        Unreal: URectLightComponent.SetSourceHeight
        """
    def SetSourceTexture(self, bNewValue: UTexture | Future[UTexture]) -> None:
        """Sets the texture mapped to the rectangle.

        Unreal: URectLightComponent.SetSourceTexture
        """
    def SetSourceWidth(self, bNewValue: float | Future[float]) -> None:
        """Sets the width of the rectangle, in centimetres.

        Unreal: URectLightComponent.SetSourceWidth
        """
    SourceWidth: FloatProperty
    """Width of the light source rectangle (local Y), in centimetres.

    Unreal: URectLightComponent.SourceWidth (float)
    """
    SourceHeight: FloatProperty
    """Height of the light source rectangle (local Z), in centimetres.

    Unreal: URectLightComponent.SourceHeight (float)
    """
    BarnDoorAngle: FloatProperty
    """Angle of the barn doors attached to the rectangle, in degrees.

    Unreal: URectLightComponent.BarnDoorAngle (float)
    """
    BarnDoorLength: FloatProperty
    """Length of the barn doors attached to the rectangle, in centimetres.

    Unreal: URectLightComponent.BarnDoorLength (float)
    """
    SourceTexture: Property[UTexture_path, UTexture | Future[UTexture] | None]
    """Texture mapped to the light source rectangle.

    Unreal: URectLightComponent.SourceTexture (UTexture*)
    """

class URectLightComponent_async(ULocalLightComponent_async):
    """URectLightComponent under ``async_``: each function gives a future."""
    def SetBarnDoorAngle(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the angle of the barn doors, in degrees."""
    def SetBarnDoorLength(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the length of the barn doors, in centimetres."""
    def SetSourceHeight(self, NewValue: float | Future[float]) -> Future[None]:
        """Sets the height of the rectangle, in centimetres."""
    def SetSourceTexture(self, bNewValue: UTexture | Future[UTexture]) -> Future[None]:
        """Sets the texture mapped to the rectangle."""
    def SetSourceWidth(self, bNewValue: float | Future[float]) -> Future[None]:
        """Sets the width of the rectangle, in centimetres."""
    SourceWidth: AsyncFloatProperty
    """Width of the light source rectangle (local Y), in centimetres."""
    SourceHeight: AsyncFloatProperty
    """Height of the light source rectangle (local Z), in centimetres."""
    BarnDoorAngle: AsyncFloatProperty
    """Angle of the barn doors attached to the rectangle, in degrees."""
    BarnDoorLength: AsyncFloatProperty
    """Length of the barn doors attached to the rectangle, in centimetres."""
    SourceTexture: Property[UTexture_async_path, UTexture | Future[UTexture] | None]
    """Texture mapped to the light source rectangle."""

class URectLightComponent_send(ULocalLightComponent_send):
    """URectLightComponent under ``send_``: no function answers."""
    def SetBarnDoorAngle(self, NewValue: float | Future[float]) -> None:
        """Sets the angle of the barn doors, in degrees."""
    def SetBarnDoorLength(self, NewValue: float | Future[float]) -> None:
        """Sets the length of the barn doors, in centimetres."""
    def SetSourceHeight(self, NewValue: float | Future[float]) -> None:
        """Sets the height of the rectangle, in centimetres."""
    def SetSourceTexture(self, bNewValue: UTexture | Future[UTexture]) -> None:
        """Sets the texture mapped to the rectangle."""
    def SetSourceWidth(self, bNewValue: float | Future[float]) -> None:
        """Sets the width of the rectangle, in centimetres."""
    SourceWidth: SendFloatProperty
    SourceHeight: SendFloatProperty
    BarnDoorAngle: SendFloatProperty
    BarnDoorLength: SendFloatProperty
    SourceTexture: SendProperty[UTexture | Future[UTexture] | None]

class URectLightComponent(URectLightComponent_members, ULocalLightComponent):
    """A light from a rectangle in the local YZ plane that shines along the local X axis. Epic page:
    URectLightComponent.

    Unreal: /Script/Engine.RectLightComponent
    """
    @property
    def async_(self) -> URectLightComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> URectLightComponent_send:
        """The same functions and variables, fire-and-forget."""

class URectLightComponent_path(ObjectPath[URectLightComponent, URectLightComponent_async_path, URectLightComponent_send], URectLightComponent_members):
    """A variable that refers to an object of URectLightComponent: its path."""

class URectLightComponent_async_path(AsyncObjectPath[URectLightComponent], URectLightComponent_async):
    """The same under ``async_``."""
