# generated, do not edit (Engine: Public/Engine/NetSerialization.h)
from typing import TypeAlias
from spear.typing import AsyncValuePath, Future, Numbers, StructPath
from ..CoreUObject._NoExportTypes import FVector, FVector_async_members, FVector_dict, FVector_members

class FVector_NetQuantize(FVector):
    """FVector that UE rounds to integers when it is replicated.

    Unreal: /Script/Engine.Vector_NetQuantize
    """
    def __init__(self, X: float = ..., Y: float = ..., Z: float = ...) -> None: ...

class FVector_NetQuantize_dict(FVector_dict, total=False):
    """Any of the fields of FVector_NetQuantize: what a dictionary for it may hold."""

FVector_NetQuantize_in: TypeAlias = FVector_NetQuantize | FVector_NetQuantize_dict | Future[FVector_NetQuantize] | Numbers
"""What stands for FVector_NetQuantize as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FVector_NetQuantize_members(FVector_members):
    """The fields of FVector_NetQuantize, as paths."""

class FVector_NetQuantize_async_members(FVector_async_members):
    """The fields of FVector_NetQuantize, as paths under ``async_``."""

class FVector_NetQuantize_path(StructPath[FVector_NetQuantize, FVector_NetQuantize_in, FVector_NetQuantize_async], FVector_NetQuantize_members):
    """A variable of type FVector_NetQuantize: its path."""

class FVector_NetQuantize_async(AsyncValuePath[FVector_NetQuantize, FVector_NetQuantize_in], FVector_NetQuantize_async_members):
    """The same under ``async_``."""

class FVector_NetQuantize100(FVector):
    """FVector that UE rounds to one hundredth when it is replicated.

    Unreal: /Script/Engine.Vector_NetQuantize100
    """
    def __init__(self, X: float = ..., Y: float = ..., Z: float = ...) -> None: ...

class FVector_NetQuantize100_dict(FVector_dict, total=False):
    """Any of the fields of FVector_NetQuantize100: what a dictionary for it may hold."""

FVector_NetQuantize100_in: TypeAlias = FVector_NetQuantize100 | FVector_NetQuantize100_dict | Future[FVector_NetQuantize100] | Numbers
"""What stands for FVector_NetQuantize100 as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FVector_NetQuantize100_members(FVector_members):
    """The fields of FVector_NetQuantize100, as paths."""

class FVector_NetQuantize100_async_members(FVector_async_members):
    """The fields of FVector_NetQuantize100, as paths under ``async_``."""

class FVector_NetQuantize100_path(StructPath[FVector_NetQuantize100, FVector_NetQuantize100_in, FVector_NetQuantize100_async], FVector_NetQuantize100_members):
    """A variable of type FVector_NetQuantize100: its path."""

class FVector_NetQuantize100_async(AsyncValuePath[FVector_NetQuantize100, FVector_NetQuantize100_in], FVector_NetQuantize100_async_members):
    """The same under ``async_``."""

class FVector_NetQuantizeNormal(FVector):
    """Unit FVector that UE sends as 16 bits a component when it is replicated.

    Unreal: /Script/Engine.Vector_NetQuantizeNormal
    """
    def __init__(self, X: float = ..., Y: float = ..., Z: float = ...) -> None: ...

class FVector_NetQuantizeNormal_dict(FVector_dict, total=False):
    """Any of the fields of FVector_NetQuantizeNormal: what a dictionary for it may hold."""

FVector_NetQuantizeNormal_in: TypeAlias = FVector_NetQuantizeNormal | FVector_NetQuantizeNormal_dict | Future[FVector_NetQuantizeNormal] | Numbers
"""What stands for FVector_NetQuantizeNormal as an argument: itself, a dictionary of its fields, a future, its numbers in order."""

class FVector_NetQuantizeNormal_members(FVector_members):
    """The fields of FVector_NetQuantizeNormal, as paths."""

class FVector_NetQuantizeNormal_async_members(FVector_async_members):
    """The fields of FVector_NetQuantizeNormal, as paths under ``async_``."""

class FVector_NetQuantizeNormal_path(StructPath[FVector_NetQuantizeNormal, FVector_NetQuantizeNormal_in, FVector_NetQuantizeNormal_async], FVector_NetQuantizeNormal_members):
    """A variable of type FVector_NetQuantizeNormal: its path."""

class FVector_NetQuantizeNormal_async(AsyncValuePath[FVector_NetQuantizeNormal, FVector_NetQuantizeNormal_in], FVector_NetQuantizeNormal_async_members):
    """The same under ``async_``."""
