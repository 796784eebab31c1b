# generated, do not edit (Engine: Public/Subsystems/LocalPlayerSubsystem.h)
from spear.typing import AsyncObjectPath, ObjectPath
from ._Subsystem import USubsystem, USubsystem_async, USubsystem_members, USubsystem_send

class ULocalPlayerSubsystem_members(USubsystem_members):
    """Functions and variables of ULocalPlayerSubsystem."""

class ULocalPlayerSubsystem_async(USubsystem_async):
    """ULocalPlayerSubsystem under ``async_``: each function gives a future."""

class ULocalPlayerSubsystem_send(USubsystem_send):
    """ULocalPlayerSubsystem under ``send_``: no function answers."""

class ULocalPlayerSubsystem(ULocalPlayerSubsystem_members, USubsystem):
    """Base class for auto instanced and initialized subsystems that share the lifetime of local players.

    Unreal: /Script/Engine.LocalPlayerSubsystem
    """
    @property
    def async_(self) -> ULocalPlayerSubsystem_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> ULocalPlayerSubsystem_send:
        """The same functions and variables, fire-and-forget."""

class ULocalPlayerSubsystem_path(ObjectPath[ULocalPlayerSubsystem, ULocalPlayerSubsystem_async_path, ULocalPlayerSubsystem_send], ULocalPlayerSubsystem_members):
    """A variable that refers to an object of ULocalPlayerSubsystem: its path."""

class ULocalPlayerSubsystem_async_path(AsyncObjectPath[ULocalPlayerSubsystem], ULocalPlayerSubsystem_async):
    """The same under ``async_``."""
