# generated, do not edit (Engine: Public/Engine/TimerHandle.h)
from typing import TypeAlias, TypedDict
from spear.structs import Struct
from spear.typing import AsyncIntProperty, AsyncValuePath, Future, IntProperty, Numbers, StructPath

class FTimerHandle(Struct):
    """Unique handle that can be used to distinguish timers that have identical delegates.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/FTimerHandle

    Unreal: /Script/Engine.TimerHandle
    """
    def __init__(self, Handle: int = ...) -> None: ...
    Handle: int
    """Serial number of the timer; 0 is no timer."""

class FTimerHandle_dict(TypedDict, total=False):
    """Any of the fields of FTimerHandle: what a dictionary for it may hold."""
    Handle: int | Future[int]

FTimerHandle_in: TypeAlias = FTimerHandle | FTimerHandle_dict | Future[FTimerHandle] | Numbers
"""What stands for FTimerHandle as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FTimerHandle_path(StructPath[FTimerHandle, FTimerHandle_in, FTimerHandle_async]):
    """A variable of type FTimerHandle: its path."""
    Handle: IntProperty
    """Serial number of the timer; 0 is no timer."""

class FTimerHandle_async(AsyncValuePath[FTimerHandle, FTimerHandle_in]):
    """The same under ``async_``."""
    Handle: AsyncIntProperty
