# generated, do not edit (Engine: Public/Subsystems/GameInstanceSubsystem.h)
from spear.typing import AsyncObjectPath, ObjectPath
from ._Subsystem import USubsystem, USubsystem_async, USubsystem_members, USubsystem_send

class UGameInstanceSubsystem_members(USubsystem_members):
    """Functions and variables of UGameInstanceSubsystem."""

class UGameInstanceSubsystem_async(USubsystem_async):
    """UGameInstanceSubsystem under ``async_``: each function gives a future."""

class UGameInstanceSubsystem_send(USubsystem_send):
    """UGameInstanceSubsystem under ``send_``: no function answers."""

class UGameInstanceSubsystem(UGameInstanceSubsystem_members, USubsystem):
    """Base class for auto instanced and initialized systems that share the lifetime of the game instance.

    Unreal: /Script/Engine.GameInstanceSubsystem
    """
    @property
    def async_(self) -> UGameInstanceSubsystem_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UGameInstanceSubsystem_send:
        """The same functions and variables, fire-and-forget."""

class UGameInstanceSubsystem_path(ObjectPath[UGameInstanceSubsystem, UGameInstanceSubsystem_async_path, UGameInstanceSubsystem_send], UGameInstanceSubsystem_members):
    """A variable that refers to an object of UGameInstanceSubsystem: its path."""

class UGameInstanceSubsystem_async_path(AsyncObjectPath[UGameInstanceSubsystem], UGameInstanceSubsystem_async):
    """The same under ``async_``."""
