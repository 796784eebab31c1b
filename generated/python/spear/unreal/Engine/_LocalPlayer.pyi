# generated, do not edit (Engine: Public/Engine/LocalPlayer.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath, Property, SendProperty
from ._GameViewportClient import UGameViewportClient, UGameViewportClient_async_path, UGameViewportClient_path
from ._Player import UPlayer, UPlayer_async, UPlayer_members, UPlayer_send

class ULocalPlayer_members(UPlayer_members):
    """Functions and variables of ULocalPlayer."""
    def GetControllerId(self) -> int:
        """The controller ID which this player accepts input from.

        Unreal: ULocalPlayer.GetControllerId
        """
    ViewportClient: Property[UGameViewportClient_path, UGameViewportClient | Future[UGameViewportClient] | None]
    """The primary viewport containing this player's view.

    Unreal: ULocalPlayer.ViewportClient (UGameViewportClient*)
    """

class ULocalPlayer_async(UPlayer_async):
    """ULocalPlayer under ``async_``: each function gives a future."""
    def GetControllerId(self) -> Future[int]:
        """The controller ID which this player accepts input from."""
    ViewportClient: Property[UGameViewportClient_async_path, UGameViewportClient | Future[UGameViewportClient] | None]
    """The primary viewport containing this player's view."""

class ULocalPlayer_send(UPlayer_send):
    """ULocalPlayer under ``send_``: no function answers."""
    def GetControllerId(self) -> None:
        """The controller ID which this player accepts input from."""
    ViewportClient: SendProperty[UGameViewportClient | Future[UGameViewportClient] | None]

class ULocalPlayer(ULocalPlayer_members, UPlayer):
    """Each player that is active on the current client has a LocalPlayer. It stays active across maps. There may be
    none spawned in the case of a dedicated server.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/ULocalPlayer

    Unreal: /Script/Engine.LocalPlayer
    """
    @property
    def async_(self) -> ULocalPlayer_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> ULocalPlayer_send:
        """The same functions and variables, fire-and-forget."""

class ULocalPlayer_path(ObjectPath[ULocalPlayer, ULocalPlayer_async_path, ULocalPlayer_send], ULocalPlayer_members):
    """A variable that refers to an object of ULocalPlayer: its path."""

class ULocalPlayer_async_path(AsyncObjectPath[ULocalPlayer], ULocalPlayer_async):
    """The same under ``async_``."""
