# generated, do not edit (Engine: Public/Engine/Level.h)
from spear.typing import AsyncBoolProperty, AsyncObjectPath, BoolProperty, Future, ObjectPath, Property, SendBoolProperty, SendProperty
from ..CoreUObject._NoExportTypes import UObject, UObject_async, UObject_members, UObject_send
from ._World import UWorld, UWorld_async_path, UWorld_path
from ._WorldSettings import AWorldSettings, AWorldSettings_async_path, AWorldSettings_path

class ULevel_members(UObject_members):
    """Functions and variables of ULevel."""
    OwningWorld: Property[UWorld_path, UWorld | Future[UWorld] | None]
    """The World that has this level in its Levels array.

    Unreal: ULevel.OwningWorld (UWorld*)
    """
    bIsVisible: BoolProperty
    """Whether the level is currently visible/ associated with the world.

    Unreal: ULevel.bIsVisible (bool)
    """
    WorldSettings: Property[AWorldSettings_path, AWorldSettings | Future[AWorldSettings] | None]
    """Actor that holds the settings of the level.

    Unreal: ULevel.WorldSettings (AWorldSettings*)
    """

class ULevel_async(UObject_async):
    """ULevel under ``async_``: each function gives a future."""
    OwningWorld: Property[UWorld_async_path, UWorld | Future[UWorld] | None]
    """The World that has this level in its Levels array."""
    bIsVisible: AsyncBoolProperty
    """Whether the level is currently visible/ associated with the world."""
    WorldSettings: Property[AWorldSettings_async_path, AWorldSettings | Future[AWorldSettings] | None]
    """Actor that holds the settings of the level."""

class ULevel_send(UObject_send):
    """ULevel under ``send_``: no function answers."""
    OwningWorld: SendProperty[UWorld | Future[UWorld] | None]
    bIsVisible: SendBoolProperty
    WorldSettings: SendProperty[AWorldSettings | Future[AWorldSettings] | None]

class ULevel(ULevel_members, UObject):
    """A Level is a collection of Actors. The actors of a world live in its persistent level: that is their outer, so
    that their path reads "/Game/Scenes/apartment.apartment:PersistentLevel.Chair_1".

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/ULevel

    Unreal: /Script/Engine.Level
    """
    @property
    def async_(self) -> ULevel_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> ULevel_send:
        """The same functions and variables, fire-and-forget."""

class ULevel_path(ObjectPath[ULevel, ULevel_async_path, ULevel_send], ULevel_members):
    """A variable that refers to an object of ULevel: its path."""

class ULevel_async_path(AsyncObjectPath[ULevel], ULevel_async):
    """The same under ``async_``."""
