# generated, do not edit (Engine: Public/Engine/DirectionalLight.h)
from spear.typing import AsyncObjectPath, ObjectPath
from ._Light import ALight, ALight_async, ALight_members, ALight_send

class ADirectionalLight_members(ALight_members):
    """Functions and variables of ADirectionalLight."""

class ADirectionalLight_async(ALight_async):
    """ADirectionalLight under ``async_``: each function gives a future."""

class ADirectionalLight_send(ALight_send):
    """ADirectionalLight under ``send_``: no function answers."""

class ADirectionalLight(ADirectionalLight_members, ALight):
    """An actor with a directional light: the sun or the moon. Epic page: ADirectionalLight.

    Unreal: /Script/Engine.DirectionalLight
    """
    @property
    def async_(self) -> ADirectionalLight_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> ADirectionalLight_send:
        """The same functions and variables, fire-and-forget."""

class ADirectionalLight_path(ObjectPath[ADirectionalLight, ADirectionalLight_async_path, ADirectionalLight_send], ADirectionalLight_members):
    """A variable that refers to an object of ADirectionalLight: its path."""

class ADirectionalLight_async_path(AsyncObjectPath[ADirectionalLight], ADirectionalLight_async):
    """The same under ``async_``."""
