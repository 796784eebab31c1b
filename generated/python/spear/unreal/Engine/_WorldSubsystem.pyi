# generated, do not edit (Engine: Public/Subsystems/WorldSubsystem.h)
from spear.typing import AsyncObjectPath, ObjectPath
from ._Subsystem import USubsystem, USubsystem_async, USubsystem_members, USubsystem_send

class UWorldSubsystem_members(USubsystem_members):
    """Functions and variables of UWorldSubsystem."""

class UWorldSubsystem_async(USubsystem_async):
    """UWorldSubsystem under ``async_``: each function gives a future."""

class UWorldSubsystem_send(USubsystem_send):
    """UWorldSubsystem under ``send_``: no function answers."""

class UWorldSubsystem(UWorldSubsystem_members, USubsystem):
    """Base class for auto instanced and initialized systems that share the lifetime of a UWorld.

    Unreal: /Script/Engine.WorldSubsystem
    """
    @property
    def async_(self) -> UWorldSubsystem_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UWorldSubsystem_send:
        """The same functions and variables, fire-and-forget."""

class UWorldSubsystem_path(ObjectPath[UWorldSubsystem, UWorldSubsystem_async_path, UWorldSubsystem_send], UWorldSubsystem_members):
    """A variable that refers to an object of UWorldSubsystem: its path."""

class UWorldSubsystem_async_path(AsyncObjectPath[UWorldSubsystem], UWorldSubsystem_async):
    """The same under ``async_``."""

class UTickableWorldSubsystem_members(UWorldSubsystem_members):
    """Functions and variables of UTickableWorldSubsystem."""

class UTickableWorldSubsystem_async(UWorldSubsystem_async):
    """UTickableWorldSubsystem under ``async_``: each function gives a future."""

class UTickableWorldSubsystem_send(UWorldSubsystem_send):
    """UTickableWorldSubsystem under ``send_``: no function answers."""

class UTickableWorldSubsystem(UTickableWorldSubsystem_members, UWorldSubsystem):
    """Base class for auto instanced and initialized systems that share the lifetime of a UWorld and are ticking
    along with it.

    Unreal: /Script/Engine.TickableWorldSubsystem
    """
    @property
    def async_(self) -> UTickableWorldSubsystem_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UTickableWorldSubsystem_send:
        """The same functions and variables, fire-and-forget."""

class UTickableWorldSubsystem_path(ObjectPath[UTickableWorldSubsystem, UTickableWorldSubsystem_async_path, UTickableWorldSubsystem_send], UTickableWorldSubsystem_members):
    """A variable that refers to an object of UTickableWorldSubsystem: its path."""

class UTickableWorldSubsystem_async_path(AsyncObjectPath[UTickableWorldSubsystem], UTickableWorldSubsystem_async):
    """The same under ``async_``."""
