# generated, do not edit (Engine: Public/GameFramework/SpectatorPawn.h)
from spear.typing import AsyncObjectPath, ObjectPath
from ._DefaultPawn import ADefaultPawn, ADefaultPawn_async, ADefaultPawn_members, ADefaultPawn_send

class ASpectatorPawn_members(ADefaultPawn_members):
    """Functions and variables of ASpectatorPawn."""

class ASpectatorPawn_async(ADefaultPawn_async):
    """ASpectatorPawn under ``async_``: each function gives a future."""

class ASpectatorPawn_send(ADefaultPawn_send):
    """ASpectatorPawn under ``send_``: no function answers."""

class ASpectatorPawn(ASpectatorPawn_members, ADefaultPawn):
    """SpectatorPawns are simple pawns that can fly around the world, used by PlayerControllers when in the spectator
    state.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/ASpectatorPawn

    Unreal: /Script/Engine.SpectatorPawn
    """
    @property
    def async_(self) -> ASpectatorPawn_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> ASpectatorPawn_send:
        """The same functions and variables, fire-and-forget."""

class ASpectatorPawn_path(ObjectPath[ASpectatorPawn, ASpectatorPawn_async_path, ASpectatorPawn_send], ASpectatorPawn_members):
    """A variable that refers to an object of ASpectatorPawn: its path."""

class ASpectatorPawn_async_path(AsyncObjectPath[ASpectatorPawn], ASpectatorPawn_async):
    """The same under ``async_``."""
