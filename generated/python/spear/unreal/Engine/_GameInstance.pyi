# generated, do not edit (Engine: Public/Engine/GameInstance.h)
from collections.abc import Sequence
from spear.typing import ArrayPath, AsyncArrayPath, AsyncObjectPath, Future, ObjectPath, Property, SendProperty
from ..CoreUObject._NoExportTypes import UObject, UObject_async, UObject_members, UObject_send
from ._LocalPlayer import ULocalPlayer, ULocalPlayer_async_path, ULocalPlayer_path

class UGameInstance_members(UObject_members):
    """Functions and variables of UGameInstance."""
    def ReceiveInit(self) -> None:
        """Opportunity for blueprints to handle the game instance being initialised.

        Unreal: UGameInstance.ReceiveInit
        """
    def ReceiveShutdown(self) -> None:
        """Opportunity for blueprints to handle the game instance being shutdown.

        Unreal: UGameInstance.ReceiveShutdown
        """
    LocalPlayers: Property[ArrayPath[ULocalPlayer | None, ULocalPlayer | Future[ULocalPlayer] | None, ULocalPlayer_path, ULocalPlayer_async_path], Sequence[ULocalPlayer | Future[ULocalPlayer] | None] | Future[list[ULocalPlayer | None]]]
    """List of locally participating players in this game instance.

    Unreal: UGameInstance.LocalPlayers (TArray<ULocalPlayer*>)
    """

class UGameInstance_async(UObject_async):
    """UGameInstance under ``async_``: each function gives a future."""
    def ReceiveInit(self) -> Future[None]:
        """Opportunity for blueprints to handle the game instance being initialised."""
    def ReceiveShutdown(self) -> Future[None]:
        """Opportunity for blueprints to handle the game instance being shutdown."""
    LocalPlayers: Property[AsyncArrayPath[ULocalPlayer | None, ULocalPlayer | Future[ULocalPlayer] | None, ULocalPlayer_async_path], Sequence[ULocalPlayer | Future[ULocalPlayer] | None] | Future[list[ULocalPlayer | None]]]
    """List of locally participating players in this game instance."""

class UGameInstance_send(UObject_send):
    """UGameInstance under ``send_``: no function answers."""
    def ReceiveInit(self) -> None:
        """Opportunity for blueprints to handle the game instance being initialised."""
    def ReceiveShutdown(self) -> None:
        """Opportunity for blueprints to handle the game instance being shutdown."""
    LocalPlayers: SendProperty[Sequence[ULocalPlayer | Future[ULocalPlayer] | None] | Future[list[ULocalPlayer | None]]]

class UGameInstance(UGameInstance_members, UObject):
    """GameInstance: high-level manager object for an instance of the running game. Spawned at game creation and not
    destroyed until game instance is shut down.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/UGameInstance

    Unreal: /Script/Engine.GameInstance
    """
    @property
    def async_(self) -> UGameInstance_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UGameInstance_send:
        """The same functions and variables, fire-and-forget."""

class UGameInstance_path(ObjectPath[UGameInstance, UGameInstance_async_path, UGameInstance_send], UGameInstance_members):
    """A variable that refers to an object of UGameInstance: its path."""

class UGameInstance_async_path(AsyncObjectPath[UGameInstance], UGameInstance_async):
    """The same under ``async_``."""
