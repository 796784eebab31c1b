# generated, do not edit (Engine: Public/Engine/TargetPoint.h)
from spear.typing import AsyncObjectPath, ObjectPath
from ._Actor import AActor, AActor_async, AActor_members, AActor_send

class ATargetPoint_members(AActor_members):
    """Functions and variables of ATargetPoint."""

class ATargetPoint_async(AActor_async):
    """ATargetPoint under ``async_``: each function gives a future."""

class ATargetPoint_send(AActor_send):
    """ATargetPoint under ``send_``: no function answers."""

class ATargetPoint(ATargetPoint_members, AActor):
    """A place in the world, to be found by others. Epic page: ATargetPoint.

    Unreal: /Script/Engine.TargetPoint
    """
    @property
    def async_(self) -> ATargetPoint_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> ATargetPoint_send:
        """The same functions and variables, fire-and-forget."""

class ATargetPoint_path(ObjectPath[ATargetPoint, ATargetPoint_async_path, ATargetPoint_send], ATargetPoint_members):
    """A variable that refers to an object of ATargetPoint: its path."""

class ATargetPoint_async_path(AsyncObjectPath[ATargetPoint], ATargetPoint_async):
    """The same under ``async_``."""
