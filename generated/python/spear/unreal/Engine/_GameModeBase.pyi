# generated, do not edit (Engine: Public/GameFramework/GameModeBase.h)
from spear.typing import (
    AsyncBoolProperty, AsyncClassPath, AsyncObjectPath, AsyncStrProperty, BoolProperty, ClassPath, Future, ObjectPath, Property, SendBoolProperty,
    SendProperty, SendStrProperty, StrProperty,
)
from ..CoreUObject._Intrinsic import UClass
from ..CoreUObject._NoExportTypes import FTransform_in
from ._Actor import AActor
from ._Controller import AController
from ._GameStateBase import AGameStateBase, AGameStateBase_async_path, AGameStateBase_path
from ._Info import AInfo, AInfo_async, AInfo_members, AInfo_send
from ._Pawn import APawn
from ._PlayerController import APlayerController
from ._PlayerState import APlayerState

class AGameModeBase_members(AInfo_members):
    """Functions and variables of AGameModeBase."""
    def ChangeName(self, Controller: AController | Future[AController], NewName: str | Future[str], bNameChange: bool | Future[bool]) -> None:
        """Sets the name for a controller.

        Args:
            NewName: ;
            bNameChange: true if this is a change of an older name.

        Unreal: AGameModeBase.ChangeName
        """
    def ChoosePlayerStart(self, Player: AController | Future[AController]) -> AActor:
        """Return the 'best' player start for this player to spawn from: the first one.

        Unreal: AGameModeBase.ChoosePlayerStart
        """
    def FindPlayerStart(self, Player: AController | Future[AController], IncomingName: str | Future[str] = "") -> AActor | None:
        """Return the specific player start actor that should be used for the next spawn.

        Args:
            IncomingName: tag of a player start to use.

        Unreal: AGameModeBase.FindPlayerStart
        """
    def GetDefaultPawnClassForController(self, InController: AController | Future[AController]) -> UClass:
        """Returns default pawn class for given controller.

        Unreal: AGameModeBase.GetDefaultPawnClassForController
        """
    def GetNumPlayers(self) -> int:
        """Returns number of active human players, excluding spectators.

        Unreal: AGameModeBase.GetNumPlayers
        """
    def HasMatchStarted(self) -> bool:
        """Returns true if the match start callbacks have been called.

        Unreal: AGameModeBase.HasMatchStarted
        """
    def InitStartSpot(self, StartSpot: AActor | Future[AActor], NewPlayer: AController | Future[AController]) -> None:
        """Called from RestartPlayerAtPlayerStart, can be used to initialize the start spawn actor.

        Unreal: AGameModeBase.InitStartSpot
        """
    def K2_OnLogout(self, ExitingController: AController | Future[AController]) -> None:
        """Implementable event when a Controller with a PlayerState leaves the game.

        Unreal: AGameModeBase.K2_OnLogout
        """
    def K2_PostLogin(self, NewPlayer: APlayerController | Future[APlayerController]) -> None:
        """Notification that a player has successfully logged in, and has been given a player controller.

        Unreal: AGameModeBase.K2_PostLogin
        """
    def PlayerCanRestart(self, Player: APlayerController | Future[APlayerController]) -> bool:
        """Returns true if it's valid to call RestartPlayer. By default will call Player->CanRestartPlayer.

        Unreal: AGameModeBase.PlayerCanRestart
        """
    def ResetLevel(self) -> None:
        """Overridable function called when resetting level. This is used to reset the game state while staying in the
        same map.

        Unreal: AGameModeBase.ResetLevel
        """
    def RestartPlayer(self, NewPlayer: AController | Future[AController]) -> None:
        """Tries to spawn the player's pawn, at the location returned by FindPlayerStart.

        Unreal: AGameModeBase.RestartPlayer
        """
    def RestartPlayerAtPlayerStart(self, NewPlayer: AController | Future[AController], StartSpot: AActor | Future[AActor]) -> None:
        """Tries to spawn the player's pawn at the specified actor's location.

        Unreal: AGameModeBase.RestartPlayerAtPlayerStart
        """
    def RestartPlayerAtTransform(self, NewPlayer: AController | Future[AController], SpawnTransform: FTransform_in) -> None:
        """Tries to spawn the player's pawn at a specific location.

        Unreal: AGameModeBase.RestartPlayerAtTransform
        """
    def ShouldReset(self, ActorToReset: AActor | Future[AActor]) -> bool:
        """Overridable function to determine whether an Actor should have Reset called when the game has Reset called on
        it.

        Unreal: AGameModeBase.ShouldReset
        """
    def SpawnDefaultPawnAtTransform(self, NewPlayer: AController | Future[AController], SpawnTransform: FTransform_in) -> APawn:
        """Called during RestartPlayer to actually spawn the player's pawn, when using a transform.

        Unreal: AGameModeBase.SpawnDefaultPawnAtTransform
        """
    def SpawnDefaultPawnFor(self, NewPlayer: AController | Future[AController], StartSpot: AActor | Future[AActor]) -> APawn:
        """Called during RestartPlayer to actually spawn the player's pawn, when using a start spot.

        Unreal: AGameModeBase.SpawnDefaultPawnFor
        """
    def StartPlay(self) -> None:
        """Transitions to calls BeginPlay on actors.

        Unreal: AGameModeBase.StartPlay
        """
    OptionsString: StrProperty
    """Save options string and parse it when needed.

    Unreal: AGameModeBase.OptionsString (FString)
    """
    GameStateClass: Property[ClassPath[UClass, type[AGameStateBase] | UClass | str | Future[UClass] | None], type[AGameStateBase] | UClass | str | Future[UClass] | None]
    """Class of GameState associated with this GameMode.

    Unreal: AGameModeBase.GameStateClass (TSubclassOf<AGameStateBase>)
    """
    PlayerControllerClass: Property[ClassPath[UClass, type[APlayerController] | UClass | str | Future[UClass] | None], type[APlayerController] | UClass | str | Future[UClass] | None]
    """The class of PlayerController to spawn for players logging in.

    Unreal: AGameModeBase.PlayerControllerClass (TSubclassOf<APlayerController>)
    """
    PlayerStateClass: Property[ClassPath[UClass, type[APlayerState] | UClass | str | Future[UClass] | None], type[APlayerState] | UClass | str | Future[UClass] | None]
    """A PlayerState of this class will be associated with every player to replicate relevant player information to
    all clients.

    Unreal: AGameModeBase.PlayerStateClass (TSubclassOf<APlayerState>)
    """
    DefaultPawnClass: Property[ClassPath[UClass, type[APawn] | UClass | str | Future[UClass] | None], type[APawn] | UClass | str | Future[UClass] | None]
    """The default pawn class used by players.

    Unreal: AGameModeBase.DefaultPawnClass (TSubclassOf<APawn>)
    """
    GameState: Property[AGameStateBase_path, AGameStateBase | Future[AGameStateBase] | None]
    """GameState is used to replicate game state relevant properties to all clients.

    Unreal: AGameModeBase.GameState (AGameStateBase*)
    """
    DefaultPlayerNameText: StrProperty
    """The default player name assigned to players that join with no name specified.

    Unreal: AGameModeBase.DefaultPlayerNameText (FString)
    """
    bStartPlayersAsSpectators: BoolProperty
    """Whether players should immediately spawn when logging in, or stay as spectators until they manually spawn.

    Unreal: AGameModeBase.bStartPlayersAsSpectators (bool)
    """
    bPauseable: BoolProperty
    """Whether the game is pauseable.

    Unreal: AGameModeBase.bPauseable (bool)
    """

class AGameModeBase_async(AInfo_async):
    """AGameModeBase under ``async_``: each function gives a future."""
    def ChangeName(self, Controller: AController | Future[AController], NewName: str | Future[str], bNameChange: bool | Future[bool]) -> Future[None]:
        """Sets the name for a controller."""
    def ChoosePlayerStart(self, Player: AController | Future[AController]) -> Future[AActor]:
        """Return the 'best' player start for this player to spawn from: the first one."""
    def FindPlayerStart(self, Player: AController | Future[AController], IncomingName: str | Future[str] = "") -> Future[AActor | None]:
        """Return the specific player start actor that should be used for the next spawn."""
    def GetDefaultPawnClassForController(self, InController: AController | Future[AController]) -> Future[UClass]:
        """Returns default pawn class for given controller."""
    def GetNumPlayers(self) -> Future[int]:
        """Returns number of active human players, excluding spectators."""
    def HasMatchStarted(self) -> Future[bool]:
        """Returns true if the match start callbacks have been called."""
    def InitStartSpot(self, StartSpot: AActor | Future[AActor], NewPlayer: AController | Future[AController]) -> Future[None]:
        """Called from RestartPlayerAtPlayerStart, can be used to initialize the start spawn actor."""
    def K2_OnLogout(self, ExitingController: AController | Future[AController]) -> Future[None]:
        """Implementable event when a Controller with a PlayerState leaves the game."""
    def K2_PostLogin(self, NewPlayer: APlayerController | Future[APlayerController]) -> Future[None]:
        """Notification that a player has successfully logged in, and has been given a player controller."""
    def PlayerCanRestart(self, Player: APlayerController | Future[APlayerController]) -> Future[bool]:
        """Returns true if it's valid to call RestartPlayer."""
    def ResetLevel(self) -> Future[None]:
        """Overridable function called when resetting level."""
    def RestartPlayer(self, NewPlayer: AController | Future[AController]) -> Future[None]:
        """Tries to spawn the player's pawn, at the location returned by FindPlayerStart."""
    def RestartPlayerAtPlayerStart(self, NewPlayer: AController | Future[AController], StartSpot: AActor | Future[AActor]) -> Future[None]:
        """Tries to spawn the player's pawn at the specified actor's location."""
    def RestartPlayerAtTransform(self, NewPlayer: AController | Future[AController], SpawnTransform: FTransform_in) -> Future[None]:
        """Tries to spawn the player's pawn at a specific location."""
    def ShouldReset(self, ActorToReset: AActor | Future[AActor]) -> Future[bool]:
        """Overridable function to determine whether an Actor should have Reset called when the game has Reset called on it."""
    def SpawnDefaultPawnAtTransform(self, NewPlayer: AController | Future[AController], SpawnTransform: FTransform_in) -> Future[APawn]:
        """Called during RestartPlayer to actually spawn the player's pawn, when using a transform."""
    def SpawnDefaultPawnFor(self, NewPlayer: AController | Future[AController], StartSpot: AActor | Future[AActor]) -> Future[APawn]:
        """Called during RestartPlayer to actually spawn the player's pawn, when using a start spot."""
    def StartPlay(self) -> Future[None]:
        """Transitions to calls BeginPlay on actors."""
    OptionsString: AsyncStrProperty
    """Save options string and parse it when needed."""
    GameStateClass: Property[AsyncClassPath[UClass, type[AGameStateBase] | UClass | str | Future[UClass] | None], type[AGameStateBase] | UClass | str | Future[UClass] | None]
    """Class of GameState associated with this GameMode."""
    PlayerControllerClass: Property[AsyncClassPath[UClass, type[APlayerController] | UClass | str | Future[UClass] | None], type[APlayerController] | UClass | str | Future[UClass] | None]
    """The class of PlayerController to spawn for players logging in."""
    PlayerStateClass: Property[AsyncClassPath[UClass, type[APlayerState] | UClass | str | Future[UClass] | None], type[APlayerState] | UClass | str | Future[UClass] | None]
    """A PlayerState of this class will be associated with every player to replicate relevant player information to all clients."""
    DefaultPawnClass: Property[AsyncClassPath[UClass, type[APawn] | UClass | str | Future[UClass] | None], type[APawn] | UClass | str | Future[UClass] | None]
    """The default pawn class used by players."""
    GameState: Property[AGameStateBase_async_path, AGameStateBase | Future[AGameStateBase] | None]
    """GameState is used to replicate game state relevant properties to all clients."""
    DefaultPlayerNameText: AsyncStrProperty
    """The default player name assigned to players that join with no name specified."""
    bStartPlayersAsSpectators: AsyncBoolProperty
    """Whether players should immediately spawn when logging in, or stay as spectators until they manually spawn."""
    bPauseable: AsyncBoolProperty
    """Whether the game is pauseable."""

class AGameModeBase_send(AInfo_send):
    """AGameModeBase under ``send_``: no function answers."""
    def ChangeName(self, Controller: AController | Future[AController], NewName: str | Future[str], bNameChange: bool | Future[bool]) -> None:
        """Sets the name for a controller."""
    def ChoosePlayerStart(self, Player: AController | Future[AController]) -> None:
        """Return the 'best' player start for this player to spawn from: the first one."""
    def FindPlayerStart(self, Player: AController | Future[AController], IncomingName: str | Future[str] = "") -> None:
        """Return the specific player start actor that should be used for the next spawn."""
    def GetDefaultPawnClassForController(self, InController: AController | Future[AController]) -> None:
        """Returns default pawn class for given controller."""
    def GetNumPlayers(self) -> None:
        """Returns number of active human players, excluding spectators."""
    def HasMatchStarted(self) -> None:
        """Returns true if the match start callbacks have been called."""
    def InitStartSpot(self, StartSpot: AActor | Future[AActor], NewPlayer: AController | Future[AController]) -> None:
        """Called from RestartPlayerAtPlayerStart, can be used to initialize the start spawn actor."""
    def K2_OnLogout(self, ExitingController: AController | Future[AController]) -> None:
        """Implementable event when a Controller with a PlayerState leaves the game."""
    def K2_PostLogin(self, NewPlayer: APlayerController | Future[APlayerController]) -> None:
        """Notification that a player has successfully logged in, and has been given a player controller."""
    def PlayerCanRestart(self, Player: APlayerController | Future[APlayerController]) -> None:
        """Returns true if it's valid to call RestartPlayer."""
    def ResetLevel(self) -> None:
        """Overridable function called when resetting level."""
    def RestartPlayer(self, NewPlayer: AController | Future[AController]) -> None:
        """Tries to spawn the player's pawn, at the location returned by FindPlayerStart."""
    def RestartPlayerAtPlayerStart(self, NewPlayer: AController | Future[AController], StartSpot: AActor | Future[AActor]) -> None:
        """Tries to spawn the player's pawn at the specified actor's location."""
    def RestartPlayerAtTransform(self, NewPlayer: AController | Future[AController], SpawnTransform: FTransform_in) -> None:
        """Tries to spawn the player's pawn at a specific location."""
    def ShouldReset(self, ActorToReset: AActor | Future[AActor]) -> None:
        """Overridable function to determine whether an Actor should have Reset called when the game has Reset called on it."""
    def SpawnDefaultPawnAtTransform(self, NewPlayer: AController | Future[AController], SpawnTransform: FTransform_in) -> None:
        """Called during RestartPlayer to actually spawn the player's pawn, when using a transform."""
    def SpawnDefaultPawnFor(self, NewPlayer: AController | Future[AController], StartSpot: AActor | Future[AActor]) -> None:
        """Called during RestartPlayer to actually spawn the player's pawn, when using a start spot."""
    def StartPlay(self) -> None:
        """Transitions to calls BeginPlay on actors."""
    OptionsString: SendStrProperty
    GameStateClass: SendProperty[type[AGameStateBase] | UClass | str | Future[UClass] | None]
    PlayerControllerClass: SendProperty[type[APlayerController] | UClass | str | Future[UClass] | None]
    PlayerStateClass: SendProperty[type[APlayerState] | UClass | str | Future[UClass] | None]
    DefaultPawnClass: SendProperty[type[APawn] | UClass | str | Future[UClass] | None]
    GameState: SendProperty[AGameStateBase | Future[AGameStateBase] | None]
    DefaultPlayerNameText: SendStrProperty
    bStartPlayersAsSpectators: SendBoolProperty
    bPauseable: SendBoolProperty

class AGameModeBase(AGameModeBase_members, AInfo):
    """The GameModeBase defines the game being played. It governs the game rules, scoring, what actors are allowed to
    exist in this game type, and who may enter the game. It is only instanced on the server and will never exist
    on the client.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/AGameModeBase

    Unreal: /Script/Engine.GameModeBase
    """
    @property
    def async_(self) -> AGameModeBase_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> AGameModeBase_send:
        """The same functions and variables, fire-and-forget."""

class AGameModeBase_path(ObjectPath[AGameModeBase, AGameModeBase_async_path, AGameModeBase_send], AGameModeBase_members):
    """A variable that refers to an object of AGameModeBase: its path."""

class AGameModeBase_async_path(AsyncObjectPath[AGameModeBase], AGameModeBase_async):
    """The same under ``async_``."""
