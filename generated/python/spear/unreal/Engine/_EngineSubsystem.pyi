# generated, do not edit (Engine: Public/Subsystems/EngineSubsystem.h)
from spear.typing import AsyncObjectPath, ObjectPath
from ._Subsystem import UDynamicSubsystem, UDynamicSubsystem_async, UDynamicSubsystem_members, UDynamicSubsystem_send

class UEngineSubsystem_members(UDynamicSubsystem_members):
    """Functions and variables of UEngineSubsystem."""

class UEngineSubsystem_async(UDynamicSubsystem_async):
    """UEngineSubsystem under ``async_``: each function gives a future."""

class UEngineSubsystem_send(UDynamicSubsystem_send):
    """UEngineSubsystem under ``send_``: no function answers."""

class UEngineSubsystem(UEngineSubsystem_members, UDynamicSubsystem):
    """Base class for auto instanced and initialized systems that share the lifetime of the engine. Reach them by
    GEngine->GetEngineSubsystem<T>().

    Unreal: /Script/Engine.EngineSubsystem
    """
    @property
    def async_(self) -> UEngineSubsystem_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UEngineSubsystem_send:
        """The same functions and variables, fire-and-forget."""

class UEngineSubsystem_path(ObjectPath[UEngineSubsystem, UEngineSubsystem_async_path, UEngineSubsystem_send], UEngineSubsystem_members):
    """A variable that refers to an object of UEngineSubsystem: its path."""

class UEngineSubsystem_async_path(AsyncObjectPath[UEngineSubsystem], UEngineSubsystem_async):
    """The same under ``async_``."""
