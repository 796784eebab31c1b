# generated, do not edit (Engine: Public/Subsystems/Subsystem.h)
from spear.typing import AsyncObjectPath, ObjectPath
from ..CoreUObject._NoExportTypes import UObject, UObject_async, UObject_members, UObject_send

class USubsystem_members(UObject_members):
    """Functions and variables of USubsystem."""

class USubsystem_async(UObject_async):
    """USubsystem under ``async_``: each function gives a future."""

class USubsystem_send(UObject_send):
    """USubsystem under ``send_``: no function answers."""

class USubsystem(USubsystem_members, UObject):
    """Subsystems are auto instanced classes that share the lifetime of certain engine constructs: the engine, the
    game instance, a world, a local player. One instance is made of every class that is not abstract and whose
    ShouldCreateSubsystem returns true.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Subsystems/USubsystem

    Unreal: /Script/Engine.Subsystem
    """
    @property
    def async_(self) -> USubsystem_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> USubsystem_send:
        """The same functions and variables, fire-and-forget."""

class USubsystem_path(ObjectPath[USubsystem, USubsystem_async_path, USubsystem_send], USubsystem_members):
    """A variable that refers to an object of USubsystem: its path."""

class USubsystem_async_path(AsyncObjectPath[USubsystem], USubsystem_async):
    """The same under ``async_``."""

class UDynamicSubsystem_members(USubsystem_members):
    """Functions and variables of UDynamicSubsystem."""

class UDynamicSubsystem_async(USubsystem_async):
    """UDynamicSubsystem under ``async_``: each function gives a future."""

class UDynamicSubsystem_send(USubsystem_send):
    """UDynamicSubsystem under ``send_``: no function answers."""

class UDynamicSubsystem(UDynamicSubsystem_members, USubsystem):
    """Dynamic subsystems auto populate/depopulate existing collections when modules are loaded (and only the
    engine's collection is dynamic here).

    Unreal: /Script/Engine.DynamicSubsystem
    """
    @property
    def async_(self) -> UDynamicSubsystem_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UDynamicSubsystem_send:
        """The same functions and variables, fire-and-forget."""

class UDynamicSubsystem_path(ObjectPath[UDynamicSubsystem, UDynamicSubsystem_async_path, UDynamicSubsystem_send], UDynamicSubsystem_members):
    """A variable that refers to an object of UDynamicSubsystem: its path."""

class UDynamicSubsystem_async_path(AsyncObjectPath[UDynamicSubsystem], UDynamicSubsystem_async):
    """The same under ``async_``."""
