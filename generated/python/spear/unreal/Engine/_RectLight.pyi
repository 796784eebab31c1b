# generated, do not edit (Engine: Public/Engine/RectLight.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath, Property, SendProperty
from ._Light import ALight, ALight_async, ALight_members, ALight_send
from ._RectLightComponent import URectLightComponent, URectLightComponent_async_path, URectLightComponent_path

class ARectLight_members(ALight_members):
    """Functions and variables of ARectLight."""
    RectLightComponent: Property[URectLightComponent_path, URectLightComponent | Future[URectLightComponent] | None]
    """The light.

    Unreal: ARectLight.RectLightComponent (URectLightComponent*)
    """

class ARectLight_async(ALight_async):
    """ARectLight under ``async_``: each function gives a future."""
    RectLightComponent: Property[URectLightComponent_async_path, URectLightComponent | Future[URectLightComponent] | None]
    """The light."""

class ARectLight_send(ALight_send):
    """ARectLight under ``send_``: no function answers."""
    RectLightComponent: SendProperty[URectLightComponent | Future[URectLightComponent] | None]

class ARectLight(ARectLight_members, ALight):
    """An actor with a rectangular light. Epic page: ARectLight.

    Unreal: /Script/Engine.RectLight
    """
    @property
    def async_(self) -> ARectLight_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> ARectLight_send:
        """The same functions and variables, fire-and-forget."""

class ARectLight_path(ObjectPath[ARectLight, ARectLight_async_path, ARectLight_send], ARectLight_members):
    """A variable that refers to an object of ARectLight: its path."""

class ARectLight_async_path(AsyncObjectPath[ARectLight], ARectLight_async):
    """The same under ``async_``."""
