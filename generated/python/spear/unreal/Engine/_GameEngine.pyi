# generated, do not edit (Engine: Public/Engine/GameEngine.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath, Property, SendProperty
from ._Engine import UEngine, UEngine_async, UEngine_members, UEngine_send
from ._GameInstance import UGameInstance, UGameInstance_async_path, UGameInstance_path

class UGameEngine_members(UEngine_members):
    """Functions and variables of UGameEngine."""
    GameInstance: Property[UGameInstance_path, UGameInstance | Future[UGameInstance] | None]
    """The game instance.

    Unreal: UGameEngine.GameInstance (UGameInstance*)
    """

class UGameEngine_async(UEngine_async):
    """UGameEngine under ``async_``: each function gives a future."""
    GameInstance: Property[UGameInstance_async_path, UGameInstance | Future[UGameInstance] | None]
    """The game instance."""

class UGameEngine_send(UEngine_send):
    """UGameEngine under ``send_``: no function answers."""
    GameInstance: SendProperty[UGameInstance | Future[UGameInstance] | None]

class UGameEngine(UGameEngine_members, UEngine):
    """Engine that manages core systems that enable a game: one game instance, its viewport, its world.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/UGameEngine

    Unreal: /Script/Engine.GameEngine
    """
    @property
    def async_(self) -> UGameEngine_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UGameEngine_send:
        """The same functions and variables, fire-and-forget."""

class UGameEngine_path(ObjectPath[UGameEngine, UGameEngine_async_path, UGameEngine_send], UGameEngine_members):
    """A variable that refers to an object of UGameEngine: its path."""

class UGameEngine_async_path(AsyncObjectPath[UGameEngine], UGameEngine_async):
    """The same under ``async_``."""
