# generated, do not edit (Engine: Public/Engine/ActorInstanceHandle.h)
from typing import TypeAlias, TypedDict
from spear.structs import Struct
from spear.typing import AsyncValuePath, Future, Property, StructPath
from ._Actor import AActor, AActor_async_path, AActor_path

class FActorInstanceHandle(Struct):
    """Handle to a unique object. It may specify a full weight actor or a light weight instance in UE; here it is
    always an actor.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/FActorInstanceHandle

    Unreal: /Script/Engine.ActorInstanceHandle
    """
    def __init__(self, Actor: AActor | None = ...) -> None: ...
    Actor: AActor | None
    """This is cached here for convenience."""

class FActorInstanceHandle_dict(TypedDict, total=False):
    """Any of the fields of FActorInstanceHandle: what a dictionary for it may hold."""
    Actor: AActor | Future[AActor] | None

FActorInstanceHandle_in: TypeAlias = FActorInstanceHandle | FActorInstanceHandle_dict | Future[FActorInstanceHandle]
"""What stands for FActorInstanceHandle as an argument: itself, a dictionary of its fields, a future."""

class FActorInstanceHandle_path(StructPath[FActorInstanceHandle, FActorInstanceHandle_in, FActorInstanceHandle_async]):
    """A variable of type FActorInstanceHandle: its path."""
    Actor: Property[AActor_path, AActor | Future[AActor] | None]
    """This is cached here for convenience."""

class FActorInstanceHandle_async(AsyncValuePath[FActorInstanceHandle, FActorInstanceHandle_in]):
    """The same under ``async_``."""
    Actor: Property[AActor_async_path, AActor | Future[AActor] | None]
