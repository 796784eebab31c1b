# generated, do not edit (Engine: Public/Engine/StreamableRenderAsset.h)
from spear.typing import AsyncObjectPath, ObjectPath
from ..CoreUObject._NoExportTypes import UObject, UObject_async, UObject_members, UObject_send

class UStreamableRenderAsset_members(UObject_members):
    """Functions and variables of UStreamableRenderAsset."""

class UStreamableRenderAsset_async(UObject_async):
    """UStreamableRenderAsset under ``async_``: each function gives a future."""

class UStreamableRenderAsset_send(UObject_send):
    """UStreamableRenderAsset under ``send_``: no function answers."""

class UStreamableRenderAsset(UStreamableRenderAsset_members, UObject):
    """Base of the assets a renderer consumes: meshes and textures. Mirrors UE's UStreamableRenderAsset; the embedded
    engine keeps every asset fully resident, so nothing of UE's streaming interface exists here.

    Unreal: /Script/Engine.StreamableRenderAsset
    """
    @property
    def async_(self) -> UStreamableRenderAsset_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UStreamableRenderAsset_send:
        """The same functions and variables, fire-and-forget."""

class UStreamableRenderAsset_path(ObjectPath[UStreamableRenderAsset, UStreamableRenderAsset_async_path, UStreamableRenderAsset_send], UStreamableRenderAsset_members):
    """A variable that refers to an object of UStreamableRenderAsset: its path."""

class UStreamableRenderAsset_async_path(AsyncObjectPath[UStreamableRenderAsset], UStreamableRenderAsset_async):
    """The same under ``async_``."""
