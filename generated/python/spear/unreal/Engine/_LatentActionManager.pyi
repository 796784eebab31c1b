# generated, do not edit (Engine: Public/Engine/LatentActionManager.h)
from typing import TypeAlias, TypedDict
from spear.structs import Struct
from spear.typing import AsyncIntProperty, AsyncStrProperty, AsyncValuePath, Future, IntProperty, Property, StrProperty, StructPath
from ..CoreUObject._NoExportTypes import UObject, UObject_async_path, UObject_path

class FLatentActionInfo(Struct):
    """Tells what to call when a latent action completes: CallbackTarget->ExecutionFunction(Linkage).

    Unreal: /Script/Engine.LatentActionInfo
    """
    def __init__(self, Linkage: int = ..., UUID: int = ..., ExecutionFunction: str = ..., CallbackTarget: UObject | None = ...) -> None: ...
    Linkage: int
    """The resume point within the function to execute. INDEX_NONE: nothing to call."""
    UUID: int
    """The UUID for this action: one pending action of an object per UUID."""
    ExecutionFunction: str
    """The function to execute; takes one int32, the Linkage."""
    CallbackTarget: UObject | None
    """Object to execute the function on."""

class FLatentActionInfo_dict(TypedDict, total=False):
    """Any of the fields of FLatentActionInfo: what a dictionary for it may hold."""
    Linkage: int | Future[int]
    UUID: int | Future[int]
    ExecutionFunction: str | Future[str]
    CallbackTarget: UObject | Future[UObject] | None

FLatentActionInfo_in: TypeAlias = FLatentActionInfo | FLatentActionInfo_dict | Future[FLatentActionInfo]
"""What stands for FLatentActionInfo as an argument: itself, a dictionary of its fields, a future."""

class FLatentActionInfo_path(StructPath[FLatentActionInfo, FLatentActionInfo_in, FLatentActionInfo_async]):
    """A variable of type FLatentActionInfo: its path."""
    Linkage: IntProperty
    """The resume point within the function to execute. INDEX_NONE: nothing to call."""
    UUID: IntProperty
    """The UUID for this action: one pending action of an object per UUID."""
    ExecutionFunction: StrProperty
    """The function to execute; takes one int32, the Linkage."""
    CallbackTarget: Property[UObject_path, UObject | Future[UObject] | None]
    """Object to execute the function on."""

class FLatentActionInfo_async(AsyncValuePath[FLatentActionInfo, FLatentActionInfo_in]):
    """The same under ``async_``."""
    Linkage: AsyncIntProperty
    UUID: AsyncIntProperty
    ExecutionFunction: AsyncStrProperty
    CallbackTarget: Property[UObject_async_path, UObject | Future[UObject] | None]

class FLatentActionManager(Struct):
    """The latent action manager handles all pending latent actions for a single world.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/FLatentActionManager

    Unreal: /Script/Engine.LatentActionManager
    """
    def __init__(self) -> None: ...

class FLatentActionManager_dict(TypedDict, total=False):
    """Any of the fields of FLatentActionManager: what a dictionary for it may hold."""

FLatentActionManager_in: TypeAlias = FLatentActionManager | FLatentActionManager_dict | Future[FLatentActionManager]
"""What stands for FLatentActionManager as an argument: itself, a dictionary of its fields, a future."""

class FLatentActionManager_path(StructPath[FLatentActionManager, FLatentActionManager_in, FLatentActionManager_async]):
    """A variable of type FLatentActionManager: its path."""

class FLatentActionManager_async(AsyncValuePath[FLatentActionManager, FLatentActionManager_in]):
    """The same under ``async_``."""
