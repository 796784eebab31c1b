# generated, do not edit (Engine: Public/Engine/GameViewportClient.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath, Property, SendProperty
from ..CoreUObject._NoExportTypes import UObject, UObject_async, UObject_members, UObject_send
from ._GameInstance import UGameInstance, UGameInstance_async_path, UGameInstance_path
from ._World import UWorld, UWorld_async_path, UWorld_path

class UGameViewportClient_members(UObject_members):
    """Functions and variables of UGameViewportClient."""
    World: Property[UWorld_path, UWorld | Future[UWorld] | None]
    """The relative world context for this viewport.

    Unreal: UGameViewportClient.World (UWorld*)
    """
    GameInstance: Property[UGameInstance_path, UGameInstance | Future[UGameInstance] | None]
    """The game instance of this viewport.

    Unreal: UGameViewportClient.GameInstance (UGameInstance*)
    """

class UGameViewportClient_async(UObject_async):
    """UGameViewportClient under ``async_``: each function gives a future."""
    World: Property[UWorld_async_path, UWorld | Future[UWorld] | None]
    """The relative world context for this viewport."""
    GameInstance: Property[UGameInstance_async_path, UGameInstance | Future[UGameInstance] | None]
    """The game instance of this viewport."""

class UGameViewportClient_send(UObject_send):
    """UGameViewportClient under ``send_``: no function answers."""
    World: SendProperty[UWorld | Future[UWorld] | None]
    GameInstance: SendProperty[UGameInstance | Future[UGameInstance] | None]

class UGameViewportClient(UGameViewportClient_members, UObject):
    """A game viewport is a high-level abstract interface for the platform specific rendering, audio, and input
    subsystems. This one is headless: it has a size, which sensors and projections use, but no window.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/UGameViewportClient

    Unreal: /Script/Engine.GameViewportClient
    """
    @property
    def async_(self) -> UGameViewportClient_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UGameViewportClient_send:
        """The same functions and variables, fire-and-forget."""

class UGameViewportClient_path(ObjectPath[UGameViewportClient, UGameViewportClient_async_path, UGameViewportClient_send], UGameViewportClient_members):
    """A variable that refers to an object of UGameViewportClient: its path."""

class UGameViewportClient_async_path(AsyncObjectPath[UGameViewportClient], UGameViewportClient_async):
    """The same under ``async_``."""
