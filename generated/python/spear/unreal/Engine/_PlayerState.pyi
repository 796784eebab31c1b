# generated, do not edit (Engine: Public/GameFramework/PlayerState.h)
from collections.abc import Sequence
from typing import TypeAlias
from spear.typing import (
    AsyncFloatProperty, AsyncIntProperty, AsyncObjectPath, AsyncStrProperty, AsyncValuePath, FloatProperty, Future, IntProperty, ObjectPath, Property,
    SendFloatProperty, SendIntProperty, SendProperty, SendStrProperty, StrProperty, ValuePath,
)
from ..CoreUObject._Intrinsic import FScriptDelegate, FScriptDelegate_in
from ._Info import AInfo, AInfo_async, AInfo_members, AInfo_send
from ._Pawn import APawn, APawn_async_path, APawn_path
from ._PlayerController import APlayerController

FOnPlayerStatePawnSet: TypeAlias = list[FScriptDelegate]
"""Called as FOnPlayerStatePawnSet(Player: APlayerState, NewPawn: APawn, OldPawn: APawn); a value tells what is bound.

Unreal: /Script/Engine.OnPlayerStatePawnSet__DelegateSignature
"""

class APlayerState_members(AInfo_members):
    """Functions and variables of APlayerState."""
    def GetPawn(self) -> APawn | None:
        """Return the pawn controlled by this Player State.

        Unreal: APlayerState.GetPawn
        """
    def GetPlayerController(self) -> APlayerController | None:
        """Return the player controller that created this player state, or null for remote clients.

        Unreal: APlayerState.GetPlayerController
        """
    def GetPlayerId(self) -> int:
        """Unique net id number: sequential.

        Unreal: APlayerState.GetPlayerId
        """
    def GetPlayerName(self) -> str:
        """Player name, or blank if none.

        Unreal: APlayerState.GetPlayerName
        """
    OnPawnSet: Property[ValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Broadcast whenever this player's possessed pawn is set.

    Delegate: FOnPlayerStatePawnSet(Player: APlayerState, NewPawn: APawn, OldPawn: APawn)

    Unreal: APlayerState.OnPawnSet (FOnPlayerStatePawnSet)
    """
    Score: FloatProperty
    """Player's current score.

    Unreal: APlayerState.Score (float)
    """
    PlayerId: IntProperty
    """Unique net id number.

    Unreal: APlayerState.PlayerId (int32)
    """
    PlayerNamePrivate: StrProperty
    """Player name, or blank if none.

    Unreal: APlayerState.PlayerNamePrivate (FString)
    """
    PawnPrivate: Property[APawn_path, APawn | Future[APawn] | None]
    """The pawn that is controlled by this player.

    Unreal: APlayerState.PawnPrivate (APawn*)
    """

class APlayerState_async(AInfo_async):
    """APlayerState under ``async_``: each function gives a future."""
    def GetPawn(self) -> Future[APawn | None]:
        """Return the pawn controlled by this Player State."""
    def GetPlayerController(self) -> Future[APlayerController | None]:
        """Return the player controller that created this player state, or null for remote clients."""
    def GetPlayerId(self) -> Future[int]:
        """Unique net id number: sequential."""
    def GetPlayerName(self) -> Future[str]:
        """Player name, or blank if none."""
    OnPawnSet: Property[AsyncValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Broadcast whenever this player's possessed pawn is set."""
    Score: AsyncFloatProperty
    """Player's current score."""
    PlayerId: AsyncIntProperty
    """Unique net id number."""
    PlayerNamePrivate: AsyncStrProperty
    """Player name, or blank if none."""
    PawnPrivate: Property[APawn_async_path, APawn | Future[APawn] | None]
    """The pawn that is controlled by this player."""

class APlayerState_send(AInfo_send):
    """APlayerState under ``send_``: no function answers."""
    def GetPawn(self) -> None:
        """Return the pawn controlled by this Player State."""
    def GetPlayerController(self) -> None:
        """Return the player controller that created this player state, or null for remote clients."""
    def GetPlayerId(self) -> None:
        """Unique net id number: sequential."""
    def GetPlayerName(self) -> None:
        """Player name, or blank if none."""
    OnPawnSet: SendProperty[Sequence[FScriptDelegate_in] | None]
    Score: SendFloatProperty
    PlayerId: SendIntProperty
    PlayerNamePrivate: SendStrProperty
    PawnPrivate: SendProperty[APawn | Future[APawn] | None]

class APlayerState(APlayerState_members, AInfo):
    """A PlayerState is created for every player. It contains information about the player, such as name and score.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/APlayerState

    Unreal: /Script/Engine.PlayerState
    """
    @property
    def async_(self) -> APlayerState_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> APlayerState_send:
        """The same functions and variables, fire-and-forget."""

class APlayerState_path(ObjectPath[APlayerState, APlayerState_async_path, APlayerState_send], APlayerState_members):
    """A variable that refers to an object of APlayerState: its path."""

class APlayerState_async_path(AsyncObjectPath[APlayerState], APlayerState_async):
    """The same under ``async_``."""
