# generated, do not edit (Engine: Public/Engine/SkyLight.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath, Property, SendProperty
from ._Info import AInfo, AInfo_async, AInfo_members, AInfo_send
from ._SkyLightComponent import USkyLightComponent, USkyLightComponent_async_path, USkyLightComponent_path

class ASkyLight_members(AInfo_members):
    """Functions and variables of ASkyLight."""
    LightComponent: Property[USkyLightComponent_path, USkyLightComponent | Future[USkyLightComponent] | None]
    """The light.

    Unreal: ASkyLight.LightComponent (USkyLightComponent*)
    """

class ASkyLight_async(AInfo_async):
    """ASkyLight under ``async_``: each function gives a future."""
    LightComponent: Property[USkyLightComponent_async_path, USkyLightComponent | Future[USkyLightComponent] | None]
    """The light."""

class ASkyLight_send(AInfo_send):
    """ASkyLight under ``send_``: no function answers."""
    LightComponent: SendProperty[USkyLightComponent | Future[USkyLightComponent] | None]

class ASkyLight(ASkyLight_members, AInfo):
    """An actor with a sky light. Epic page: ASkyLight.

    Unreal: /Script/Engine.SkyLight
    """
    @property
    def async_(self) -> ASkyLight_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> ASkyLight_send:
        """The same functions and variables, fire-and-forget."""

class ASkyLight_path(ObjectPath[ASkyLight, ASkyLight_async_path, ASkyLight_send], ASkyLight_members):
    """A variable that refers to an object of ASkyLight: its path."""

class ASkyLight_async_path(AsyncObjectPath[ASkyLight], ASkyLight_async):
    """The same under ``async_``."""
