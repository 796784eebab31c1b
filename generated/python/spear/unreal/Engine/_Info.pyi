# generated, do not edit (Engine: Public/GameFramework/Info.h)
from spear.typing import AsyncObjectPath, ObjectPath
from ._Actor import AActor, AActor_async, AActor_members, AActor_send

class AInfo_members(AActor_members):
    """Functions and variables of AInfo."""

class AInfo_async(AActor_async):
    """AInfo under ``async_``: each function gives a future."""

class AInfo_send(AActor_send):
    """AInfo under ``send_``: no function answers."""

class AInfo(AInfo_members, AActor):
    """Info is the base class of an Actor that isn't meant to have a physical representation in the world, used
    primarily for "manager" type classes that hold settings data about the world, but might need to be an Actor
    for replication purposes.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/AInfo

    Unreal: /Script/Engine.Info
    """
    @property
    def async_(self) -> AInfo_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> AInfo_send:
        """The same functions and variables, fire-and-forget."""

class AInfo_path(ObjectPath[AInfo, AInfo_async_path, AInfo_send], AInfo_members):
    """A variable that refers to an object of AInfo: its path."""

class AInfo_async_path(AsyncObjectPath[AInfo], AInfo_async):
    """The same under ``async_``."""
