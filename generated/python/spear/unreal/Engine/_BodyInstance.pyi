# generated, do not edit (Engine: Public/PhysicsEngine/BodyInstance.h)
from typing import TypeAlias, TypedDict
from spear.structs import Struct
from spear.typing import AsyncStrProperty, AsyncValuePath, Future, Property, StrProperty, StructPath, ValuePath
from ._EngineTypes import (
    ECollisionChannel, ECollisionChannel_in, ECollisionEnabled, ECollisionEnabled_in, FCollisionResponseContainer, FCollisionResponseContainer_async,
    FCollisionResponseContainer_in, FCollisionResponseContainer_path,
)

class FBodyInstance(Struct):
    """The collision settings of a component: what it takes part in, its object type and its responses, or the
    profile they come from. Mass, damping and the like belong to simulation and are absent. Epic page:
    FBodyInstance.

    Unreal: /Script/Engine.BodyInstance
    """
    def __init__(self, CollisionProfileName: str = ..., CollisionEnabled: ECollisionEnabled = ..., ObjectType: ECollisionChannel = ..., CollisionResponses: FCollisionResponseContainer = ...) -> None: ...
    CollisionProfileName: str
    """Name of the collision profile; `Custom` when the settings were changed one by one."""
    CollisionEnabled: ECollisionEnabled
    """What collision the body takes part in."""
    ObjectType: ECollisionChannel
    """The type of the body, by which others respond to it."""
    CollisionResponses: FCollisionResponseContainer
    """How the body responds to each channel."""

class FBodyInstance_dict(TypedDict, total=False):
    """Any of the fields of FBodyInstance: what a dictionary for it may hold."""
    CollisionProfileName: str | Future[str]
    CollisionEnabled: ECollisionEnabled_in
    ObjectType: ECollisionChannel_in
    CollisionResponses: FCollisionResponseContainer_in

FBodyInstance_in: TypeAlias = FBodyInstance | FBodyInstance_dict | Future[FBodyInstance]
"""What stands for FBodyInstance as an argument: itself, a dictionary of its fields, a future."""

class FBodyInstance_path(StructPath[FBodyInstance, FBodyInstance_in, FBodyInstance_async]):
    """A variable of type FBodyInstance: its path."""
    CollisionProfileName: StrProperty
    """Name of the collision profile; `Custom` when the settings were changed one by one."""
    CollisionEnabled: Property[ValuePath[ECollisionEnabled, ECollisionEnabled_in], ECollisionEnabled_in]
    """What collision the body takes part in."""
    ObjectType: Property[ValuePath[ECollisionChannel, ECollisionChannel_in], ECollisionChannel_in]
    """The type of the body, by which others respond to it."""
    CollisionResponses: Property[FCollisionResponseContainer_path, FCollisionResponseContainer_in]
    """How the body responds to each channel."""

class FBodyInstance_async(AsyncValuePath[FBodyInstance, FBodyInstance_in]):
    """The same under ``async_``."""
    CollisionProfileName: AsyncStrProperty
    CollisionEnabled: Property[AsyncValuePath[ECollisionEnabled, ECollisionEnabled_in], ECollisionEnabled_in]
    ObjectType: Property[AsyncValuePath[ECollisionChannel, ECollisionChannel_in], ECollisionChannel_in]
    CollisionResponses: Property[FCollisionResponseContainer_async, FCollisionResponseContainer_in]
