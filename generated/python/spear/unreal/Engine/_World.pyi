# generated, do not edit (Engine: Public/Engine/World.h)
from collections.abc import Sequence
from spear.typing import ArrayPath, AsyncArrayPath, AsyncObjectPath, Future, ObjectPath, Property, SendProperty
from ..CoreUObject._NoExportTypes import UObject, UObject_async, UObject_members, UObject_send
from ._GameInstance import UGameInstance, UGameInstance_async_path, UGameInstance_path
from ._GameModeBase import AGameModeBase, AGameModeBase_async_path, AGameModeBase_path
from ._GameStateBase import AGameStateBase, AGameStateBase_async_path, AGameStateBase_path
from ._Level import ULevel, ULevel_async_path, ULevel_path
from ._WorldSettings import AWorldSettings

class UWorld_members(UObject_members):
    """Functions and variables of UWorld."""
    def K2_GetWorldSettings(self) -> AWorldSettings:
        """Returns the AWorldSettings actor associated with this world.

        Unreal: UWorld.K2_GetWorldSettings
        """
    PersistentLevel: Property[ULevel_path, ULevel | Future[ULevel] | None]
    """Persistent level containing the world info, default brush and actors spawned during gameplay among other
    things.

    Unreal: UWorld.PersistentLevel (ULevel*)
    """
    Levels: Property[ArrayPath[ULevel | None, ULevel | Future[ULevel] | None, ULevel_path, ULevel_async_path], Sequence[ULevel | Future[ULevel] | None] | Future[list[ULevel | None]]]
    """Array of levels currently in this world. Not serialized to disk to avoid hard references.

    Unreal: UWorld.Levels (TArray<ULevel*>)
    """
    CurrentLevel: Property[ULevel_path, ULevel | Future[ULevel] | None]
    """Pointer to the current level being edited. Level has to be in the Levels array and == PersistentLevel in the
    game.

    Unreal: UWorld.CurrentLevel (ULevel*)
    """
    OwningGameInstance: Property[UGameInstance_path, UGameInstance | Future[UGameInstance] | None]
    """The world's game instance.

    Unreal: UWorld.OwningGameInstance (UGameInstance*)
    """
    AuthorityGameMode: Property[AGameModeBase_path, AGameModeBase | Future[AGameModeBase] | None]
    """The current GameMode, valid only on the server.

    Unreal: UWorld.AuthorityGameMode (AGameModeBase*)
    """
    GameState: Property[AGameStateBase_path, AGameStateBase | Future[AGameStateBase] | None]
    """The replicated actor which contains game state information that can be accessible to clients.

    Unreal: UWorld.GameState (AGameStateBase*)
    """

class UWorld_async(UObject_async):
    """UWorld under ``async_``: each function gives a future."""
    def K2_GetWorldSettings(self) -> Future[AWorldSettings]:
        """Returns the AWorldSettings actor associated with this world."""
    PersistentLevel: Property[ULevel_async_path, ULevel | Future[ULevel] | None]
    """Persistent level containing the world info, default brush and actors spawned during gameplay among other things."""
    Levels: Property[AsyncArrayPath[ULevel | None, ULevel | Future[ULevel] | None, ULevel_async_path], Sequence[ULevel | Future[ULevel] | None] | Future[list[ULevel | None]]]
    """Array of levels currently in this world."""
    CurrentLevel: Property[ULevel_async_path, ULevel | Future[ULevel] | None]
    """Pointer to the current level being edited."""
    OwningGameInstance: Property[UGameInstance_async_path, UGameInstance | Future[UGameInstance] | None]
    """The world's game instance."""
    AuthorityGameMode: Property[AGameModeBase_async_path, AGameModeBase | Future[AGameModeBase] | None]
    """The current GameMode, valid only on the server."""
    GameState: Property[AGameStateBase_async_path, AGameStateBase | Future[AGameStateBase] | None]
    """The replicated actor which contains game state information that can be accessible to clients."""

class UWorld_send(UObject_send):
    """UWorld under ``send_``: no function answers."""
    def K2_GetWorldSettings(self) -> None:
        """Returns the AWorldSettings actor associated with this world."""
    PersistentLevel: SendProperty[ULevel | Future[ULevel] | None]
    Levels: SendProperty[Sequence[ULevel | Future[ULevel] | None] | Future[list[ULevel | None]]]
    CurrentLevel: SendProperty[ULevel | Future[ULevel] | None]
    OwningGameInstance: SendProperty[UGameInstance | Future[UGameInstance] | None]
    AuthorityGameMode: SendProperty[AGameModeBase | Future[AGameModeBase] | None]
    GameState: SendProperty[AGameStateBase | Future[AGameStateBase] | None]

class UWorld(UWorld_members, UObject):
    """The World is the top level object representing a map or a sandbox in which Actors and Components will exist
    and be rendered.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/UWorld

    Unreal: /Script/Engine.World
    """
    @property
    def async_(self) -> UWorld_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UWorld_send:
        """The same functions and variables, fire-and-forget."""

class UWorld_path(ObjectPath[UWorld, UWorld_async_path, UWorld_send], UWorld_members):
    """A variable that refers to an object of UWorld: its path."""

class UWorld_async_path(AsyncObjectPath[UWorld], UWorld_async):
    """The same under ``async_``."""
