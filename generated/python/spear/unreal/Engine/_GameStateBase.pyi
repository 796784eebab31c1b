# generated, do not edit (Engine: Public/GameFramework/GameStateBase.h)
from collections.abc import Sequence
from spear.typing import (
    ArrayPath, AsyncArrayPath, AsyncBoolProperty, AsyncClassPath, AsyncObjectPath, BoolProperty, ClassPath, Future, ObjectPath, Property,
    SendBoolProperty, SendProperty,
)
from ..CoreUObject._Intrinsic import UClass
from ._Controller import AController
from ._GameModeBase import AGameModeBase, AGameModeBase_async_path, AGameModeBase_path
from ._Info import AInfo, AInfo_async, AInfo_members, AInfo_send
from ._PlayerState import APlayerState, APlayerState_async_path, APlayerState_path

class AGameStateBase_members(AInfo_members):
    """Functions and variables of AGameStateBase."""
    def GetPlayerStartTime(self, Controller: AController | Future[AController]) -> float:
        """Returns the time that should be used as when a player started.

        Unreal: AGameStateBase.GetPlayerStartTime
        """
    def GetServerWorldTimeSeconds(self) -> float:
        """Returns the simulated TimeSeconds on the server, will be synchronized on client and server.

        Unreal: AGameStateBase.GetServerWorldTimeSeconds
        """
    def HasBegunPlay(self) -> bool:
        """Returns true if the world has started play (called BeginPlay on actors).

        Unreal: AGameStateBase.HasBegunPlay
        """
    def HasMatchStarted(self) -> bool:
        """Returns true if the world has started match (called MatchStarted callbacks).

        Unreal: AGameStateBase.HasMatchStarted
        """
    GameModeClass: Property[ClassPath[UClass, type[AGameModeBase] | UClass | str | Future[UClass] | None], type[AGameModeBase] | UClass | str | Future[UClass] | None]
    """Class of the server's game mode, assigned by GameModeBase.

    Unreal: AGameStateBase.GameModeClass (TSubclassOf<AGameModeBase>)
    """
    AuthorityGameMode: Property[AGameModeBase_path, AGameModeBase | Future[AGameModeBase] | None]
    """Instance of the current game mode, exists only on the server. For non-authority clients, this will be NULL.

    Unreal: AGameStateBase.AuthorityGameMode (AGameModeBase*)
    """
    PlayerArray: Property[ArrayPath[APlayerState | None, APlayerState | Future[APlayerState] | None, APlayerState_path, APlayerState_async_path], Sequence[APlayerState | Future[APlayerState] | None] | Future[list[APlayerState | None]]]
    """Array of all PlayerStates, maintained on both server and clients (PlayerStates are always relevant).

    Unreal: AGameStateBase.PlayerArray (TArray<APlayerState*>)
    """
    bReplicatedHasBegunPlay: BoolProperty
    """True if BeginPlay has been called.

    Unreal: AGameStateBase.bReplicatedHasBegunPlay (bool)
    """

class AGameStateBase_async(AInfo_async):
    """AGameStateBase under ``async_``: each function gives a future."""
    def GetPlayerStartTime(self, Controller: AController | Future[AController]) -> Future[float]:
        """Returns the time that should be used as when a player started."""
    def GetServerWorldTimeSeconds(self) -> Future[float]:
        """Returns the simulated TimeSeconds on the server, will be synchronized on client and server."""
    def HasBegunPlay(self) -> Future[bool]:
        """Returns true if the world has started play (called BeginPlay on actors)."""
    def HasMatchStarted(self) -> Future[bool]:
        """Returns true if the world has started match (called MatchStarted callbacks)."""
    GameModeClass: Property[AsyncClassPath[UClass, type[AGameModeBase] | UClass | str | Future[UClass] | None], type[AGameModeBase] | UClass | str | Future[UClass] | None]
    """Class of the server's game mode, assigned by GameModeBase."""
    AuthorityGameMode: Property[AGameModeBase_async_path, AGameModeBase | Future[AGameModeBase] | None]
    """Instance of the current game mode, exists only on the server."""
    PlayerArray: Property[AsyncArrayPath[APlayerState | None, APlayerState | Future[APlayerState] | None, APlayerState_async_path], Sequence[APlayerState | Future[APlayerState] | None] | Future[list[APlayerState | None]]]
    """Array of all PlayerStates, maintained on both server and clients (PlayerStates are always relevant)."""
    bReplicatedHasBegunPlay: AsyncBoolProperty
    """True if BeginPlay has been called."""

class AGameStateBase_send(AInfo_send):
    """AGameStateBase under ``send_``: no function answers."""
    def GetPlayerStartTime(self, Controller: AController | Future[AController]) -> None:
        """Returns the time that should be used as when a player started."""
    def GetServerWorldTimeSeconds(self) -> None:
        """Returns the simulated TimeSeconds on the server, will be synchronized on client and server."""
    def HasBegunPlay(self) -> None:
        """Returns true if the world has started play (called BeginPlay on actors)."""
    def HasMatchStarted(self) -> None:
        """Returns true if the world has started match (called MatchStarted callbacks)."""
    GameModeClass: SendProperty[type[AGameModeBase] | UClass | str | Future[UClass] | None]
    AuthorityGameMode: SendProperty[AGameModeBase | Future[AGameModeBase] | None]
    PlayerArray: SendProperty[Sequence[APlayerState | Future[APlayerState] | None] | Future[list[APlayerState | None]]]
    bReplicatedHasBegunPlay: SendBoolProperty

class AGameStateBase(AGameStateBase_members, AInfo):
    """GameStateBase is a class that manages the game's global state, and is spawned by GameModeBase.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/AGameStateBase

    Unreal: /Script/Engine.GameStateBase
    """
    @property
    def async_(self) -> AGameStateBase_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> AGameStateBase_send:
        """The same functions and variables, fire-and-forget."""

class AGameStateBase_path(ObjectPath[AGameStateBase, AGameStateBase_async_path, AGameStateBase_send], AGameStateBase_members):
    """A variable that refers to an object of AGameStateBase: its path."""

class AGameStateBase_async_path(AsyncObjectPath[AGameStateBase], AGameStateBase_async):
    """The same under ``async_``."""
