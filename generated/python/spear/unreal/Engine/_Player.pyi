# generated, do not edit (Engine: Public/Engine/Player.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath, Property, SendProperty
from ..CoreUObject._NoExportTypes import UObject, UObject_async, UObject_members, UObject_send
from ._PlayerController import APlayerController, APlayerController_async_path, APlayerController_path

class UPlayer_members(UObject_members):
    """Functions and variables of UPlayer."""
    PlayerController: Property[APlayerController_path, APlayerController | Future[APlayerController] | None]
    """The actor this player controls.

    Unreal: UPlayer.PlayerController (APlayerController*)
    """

class UPlayer_async(UObject_async):
    """UPlayer under ``async_``: each function gives a future."""
    PlayerController: Property[APlayerController_async_path, APlayerController | Future[APlayerController] | None]
    """The actor this player controls."""

class UPlayer_send(UObject_send):
    """UPlayer under ``send_``: no function answers."""
    PlayerController: SendProperty[APlayerController | Future[APlayerController] | None]

class UPlayer(UPlayer_members, UObject):
    """Object that represents a player, whose player controller is replaced with each world.

    Unreal: /Script/Engine.Player
    """
    @property
    def async_(self) -> UPlayer_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UPlayer_send:
        """The same functions and variables, fire-and-forget."""

class UPlayer_path(ObjectPath[UPlayer, UPlayer_async_path, UPlayer_send], UPlayer_members):
    """A variable that refers to an object of UPlayer: its path."""

class UPlayer_async_path(AsyncObjectPath[UPlayer], UPlayer_async):
    """The same under ``async_``."""
