# generated, do not edit (Engine: Public/Kismet/GameplayStatics.h)
from collections.abc import Sequence
from typing import NamedTuple, TypeVar, overload
from spear.typing import AsyncObjectPath, Future, ObjectPath
from ..CoreUObject._Intrinsic import UClass, UInterface
from ..CoreUObject._NoExportTypes import FTransform_in, FVector, FVector_in, UObject
from ._Actor import AActor
from ._BlueprintFunctionLibrary import (
    UBlueprintFunctionLibrary, UBlueprintFunctionLibrary_async, UBlueprintFunctionLibrary_members, UBlueprintFunctionLibrary_send,
)
from ._EngineTypes import ESpawnActorCollisionHandlingMethod, ESpawnActorCollisionHandlingMethod_in, ESpawnActorScaleMethod, ESpawnActorScaleMethod_in
from ._GameInstance import UGameInstance
from ._GameModeBase import AGameModeBase
from ._GameStateBase import AGameStateBase
from ._Pawn import APawn
from ._PlayerCameraManager import APlayerCameraManager
from ._PlayerController import APlayerController
_T_AActor = TypeVar("_T_AActor", bound=AActor)

class UGameplayStatics_FindNearestActor_Result(NamedTuple):
    """Results of UGameplayStatics.FindNearestActor."""
    ReturnValue: AActor | None
    Distance: float

class UGameplayStatics_GetAccurateRealTime_Result(NamedTuple):
    """Results of UGameplayStatics.GetAccurateRealTime."""
    Seconds: int
    PartialSeconds: float

class UGameplayStatics_GetActorArrayBounds_Result(NamedTuple):
    """Results of UGameplayStatics.GetActorArrayBounds."""
    Center: FVector
    BoxExtent: FVector

class UGameplayStatics_GetAllActorsOfClass_Result(NamedTuple):
    """Results of UGameplayStatics.GetAllActorsOfClass."""
    OutActors: list[AActor]

class UGameplayStatics_GetAllActorsOfClassWithTag_Result(NamedTuple):
    """Results of UGameplayStatics.GetAllActorsOfClassWithTag."""
    OutActors: list[AActor]

class UGameplayStatics_GetAllActorsWithInterface_Result(NamedTuple):
    """Results of UGameplayStatics.GetAllActorsWithInterface."""
    OutActors: list[AActor]

class UGameplayStatics_GetAllActorsWithTag_Result(NamedTuple):
    """Results of UGameplayStatics.GetAllActorsWithTag."""
    OutActors: list[AActor]

class UGameplayStatics_GetKeyValue_Result(NamedTuple):
    """Results of UGameplayStatics.GetKeyValue."""
    Key: str
    Value: str

class UGameplayStatics_members(UBlueprintFunctionLibrary_members):
    """Functions and variables of UGameplayStatics."""
    def BeginDeferredActorSpawnFromClass(self, ActorClass: type[AActor] | UClass | str | Future[UClass], SpawnTransform: FTransform_in, CollisionHandlingOverride: ESpawnActorCollisionHandlingMethod_in = ESpawnActorCollisionHandlingMethod.Undefined, Owner: AActor | Future[AActor] | None = None, TransformScaleMethod: ESpawnActorScaleMethod_in = ESpawnActorScaleMethod.MultiplyWithRoot, *, WorldContextObject: UObject | Future[UObject] = ...) -> AActor:
        """Spawns an instance of an actor class, but does not run its construction. FinishSpawningActor completes it.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.BeginDeferredActorSpawnFromClass (static)
        """
    def FindNearestActor(self, Origin: FVector_in, ActorsToCheck: Sequence[AActor | Future[AActor] | None] | Future[list[AActor | None]]) -> UGameplayStatics_FindNearestActor_Result:
        """Returns the actor nearest to Origin from ActorsToCheck, and how far it is (centimetres). Null for none.

        Unreal: UGameplayStatics.FindNearestActor (static)
        """
    def FinishSpawningActor(self, Actor: AActor | Future[AActor], SpawnTransform: FTransform_in, TransformScaleMethod: ESpawnActorScaleMethod_in = ESpawnActorScaleMethod.MultiplyWithRoot) -> AActor | None:
        """Finishes the spawning of an actor: runs its construction, initialises it and begins its play. Returns the
        actor, null for null.

        Unreal: UGameplayStatics.FinishSpawningActor (static)
        """
    def GetAccurateRealTime(self) -> UGameplayStatics_GetAccurateRealTime_Result:
        """Returns the time in seconds since the application was started: the whole seconds and the rest. It is read at
        the call, not once for each frame.

        Unreal: UGameplayStatics.GetAccurateRealTime (static)
        """
    def GetActorArrayAverageLocation(self, Actors: Sequence[AActor | Future[AActor] | None] | Future[list[AActor | None]]) -> FVector:
        """Finds the average location (centroid) of an array of actors; null ones do not count. Zero for none.

        Unreal: UGameplayStatics.GetActorArrayAverageLocation (static)
        """
    def GetActorArrayBounds(self, Actors: Sequence[AActor | Future[AActor] | None] | Future[list[AActor | None]], bOnlyCollidingComponents: bool | Future[bool]) -> UGameplayStatics_GetActorArrayBounds_Result:
        """Finds the bounds of a set of actors, in centimetres.

        Unreal: UGameplayStatics.GetActorArrayBounds (static)
        """
    @overload
    def GetActorOfClass(self, ActorClass: type[_T_AActor], *, WorldContextObject: UObject | Future[UObject] = ...) -> _T_AActor | None:
        """Finds the first actor in the world of the specified class; null when there is none.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetActorOfClass (static)
        """
    @overload
    def GetActorOfClass(self, ActorClass: UClass | str | Future[UClass], *, WorldContextObject: UObject | Future[UObject] = ...) -> AActor | None: ...
    def GetAllActorsOfClass(self, ActorClass: type[AActor] | UClass | str | Future[UClass], *, WorldContextObject: UObject | Future[UObject] = ...) -> UGameplayStatics_GetAllActorsOfClass_Result:
        """Finds all actors in the world of the specified class, in the order of their spawning. This is a slow
        operation.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetAllActorsOfClass (static)
        """
    def GetAllActorsOfClassWithTag(self, ActorClass: type[AActor] | UClass | str | Future[UClass], Tag: str | Future[str], *, WorldContextObject: UObject | Future[UObject] = ...) -> UGameplayStatics_GetAllActorsOfClassWithTag_Result:
        """Finds all actors in the world of the specified class with the specified tag. This is a slow operation.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetAllActorsOfClassWithTag (static)
        """
    def GetAllActorsWithInterface(self, Interface: type[UInterface] | UClass | str | Future[UClass], *, WorldContextObject: UObject | Future[UObject] = ...) -> UGameplayStatics_GetAllActorsWithInterface_Result:
        """Finds all actors in the world with the specified interface. This is a slow operation.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetAllActorsWithInterface (static)
        """
    def GetAllActorsWithTag(self, Tag: str | Future[str], *, WorldContextObject: UObject | Future[UObject] = ...) -> UGameplayStatics_GetAllActorsWithTag_Result:
        """Finds all actors in the world with the supplied tag. This is a slow operation.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetAllActorsWithTag (static)
        """
    def GetCurrentLevelName(self, bRemovePrefixString: bool | Future[bool] = True, *, WorldContextObject: UObject | Future[UObject] = ...) -> str:
        """Gets the name of the currently open level, by default without the prefix of play-in-editor worlds (there is
        none here).

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetCurrentLevelName (static)
        """
    def GetGameInstance(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> UGameInstance | None:
        """Returns the game instance, or null when there is none.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetGameInstance (static)
        """
    def GetGameMode(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> AGameModeBase | None:
        """Returns the current game mode, or null if it cannot be retrieved.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetGameMode (static)
        """
    def GetGameState(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> AGameStateBase | None:
        """Returns the current game state, or null if it cannot be retrieved.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetGameState (static)
        """
    def GetGlobalTimeDilation(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> float:
        """Gets the current global time dilation: 1 is normal.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetGlobalTimeDilation (static)
        """
    def GetIntOption(self, Options: str | Future[str], Key: str | Future[str], DefaultValue: int | Future[int]) -> int:
        """Finds an option in an options string and returns it as an integer, or a default value.

        Unreal: UGameplayStatics.GetIntOption (static)
        """
    def GetKeyValue(self, Pair: str | Future[str]) -> UGameplayStatics_GetKeyValue_Result:
        """Breaks up a key=value pair into its key and value.

        Unreal: UGameplayStatics.GetKeyValue (static)
        """
    def GetNumPlayerControllers(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> int:
        """Returns the total number of available players.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetNumPlayerControllers (static)
        """
    def GetObjectClass(self, Object: UObject | Future[UObject]) -> UClass | None:
        """Returns the class of a passed object, null for null.

        Unreal: UGameplayStatics.GetObjectClass (static)
        """
    def GetPlatformName(self) -> str:
        """Returns the name of the current platform: "Linux".

        Unreal: UGameplayStatics.GetPlatformName (static)
        """
    def GetPlayerCameraManager(self, PlayerIndex: int | Future[int], *, WorldContextObject: UObject | Future[UObject] = ...) -> APlayerCameraManager | None:
        """Returns the camera manager for the player controller at the specified player index; null if there is none.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetPlayerCameraManager (static)
        """
    def GetPlayerController(self, PlayerIndex: int | Future[int], *, WorldContextObject: UObject | Future[UObject] = ...) -> APlayerController | None:
        """Returns the player controller found while iterating through the local and available player controllers; null
        when there is none at that index.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetPlayerController (static)
        """
    def GetPlayerPawn(self, PlayerIndex: int | Future[int], *, WorldContextObject: UObject | Future[UObject] = ...) -> APawn | None:
        """Returns the pawn for the player controller at the specified player index; null if there is none.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetPlayerPawn (static)
        """
    def GetRealTimeSeconds(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> float:
        """Returns time in seconds since the world was brought up for play: neither stopped nor dilated.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetRealTimeSeconds (static)
        """
    def GetTimeSeconds(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> float:
        """Returns time in seconds since the world was brought up for play: stops while the game is paused, is dilated.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetTimeSeconds (static)
        """
    def GetUnpausedTimeSeconds(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> float:
        """Returns time in seconds since the world was brought up for play: does not stop while the game is paused, is
        dilated.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetUnpausedTimeSeconds (static)
        """
    def GetWorldDeltaSeconds(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> float:
        """Returns the frame delta time in seconds, adjusted by time dilation.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetWorldDeltaSeconds (static)
        """
    def HasLaunchOption(self, OptionToCheck: str | Future[str]) -> bool:
        """Returns whether a command line option was given: a parameter such as -name.

        Unreal: UGameplayStatics.HasLaunchOption (static)
        """
    def HasOption(self, Options: str | Future[str], InKey: str | Future[str]) -> bool:
        """Returns whether a key exists in an options string.

        Unreal: UGameplayStatics.HasOption (static)
        """
    def IsGamePaused(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> bool:
        """Returns the game's paused state.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.IsGamePaused (static)
        """
    def OpenLevel(self, LevelName: str | Future[str], bAbsolute: bool | Future[bool] = True, Options: str | Future[str] = "", *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Travels to another level at the end of the frame. Options are like URL options, joined by question marks.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.OpenLevel (static)
        """
    def ParseOption(self, Options: str | Future[str], Key: str | Future[str]) -> str:
        """Finds an option in an options string and returns its value: "?Key=Value"; an empty string if it is not there.

        Unreal: UGameplayStatics.ParseOption (static)
        """
    def SetGamePaused(self, bPaused: bool | Future[bool], *, WorldContextObject: UObject | Future[UObject] = ...) -> bool:
        """Sets the game's paused state. Returns whether it could be set: that takes a player controller.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.SetGamePaused (static)
        """
    def SetGlobalTimeDilation(self, TimeDilation: float | Future[float], *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Sets the global time dilation: 1 is normal. Clamped to the limits in the world settings.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.SetGlobalTimeDilation (static)
        """
    def SpawnObject(self, ObjectClass: type[UObject] | UClass | str | Future[UClass], Outer: UObject | Future[UObject]) -> UObject | None:
        """Creates an object of a class that is no actor, component or widget, with an outer that must not be null. Null
        with the reason in the log if that is not possible.

        Unreal: UGameplayStatics.SpawnObject (static)
        """

class UGameplayStatics_async(UBlueprintFunctionLibrary_async):
    """UGameplayStatics under ``async_``: each function gives a future."""
    def BeginDeferredActorSpawnFromClass(self, ActorClass: type[AActor] | UClass | str | Future[UClass], SpawnTransform: FTransform_in, CollisionHandlingOverride: ESpawnActorCollisionHandlingMethod_in = ESpawnActorCollisionHandlingMethod.Undefined, Owner: AActor | Future[AActor] | None = None, TransformScaleMethod: ESpawnActorScaleMethod_in = ESpawnActorScaleMethod.MultiplyWithRoot, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[AActor]:
        """Spawns an instance of an actor class, but does not run its construction."""
    def FindNearestActor(self, Origin: FVector_in, ActorsToCheck: Sequence[AActor | Future[AActor] | None] | Future[list[AActor | None]]) -> Future[UGameplayStatics_FindNearestActor_Result]:
        """Returns the actor nearest to Origin from ActorsToCheck, and how far it is (centimetres)."""
    def FinishSpawningActor(self, Actor: AActor | Future[AActor], SpawnTransform: FTransform_in, TransformScaleMethod: ESpawnActorScaleMethod_in = ESpawnActorScaleMethod.MultiplyWithRoot) -> Future[AActor | None]:
        """Finishes the spawning of an actor: runs its construction, initialises it and begins its play."""
    def GetAccurateRealTime(self) -> Future[UGameplayStatics_GetAccurateRealTime_Result]:
        """Returns the time in seconds since the application was started: the whole seconds and the rest."""
    def GetActorArrayAverageLocation(self, Actors: Sequence[AActor | Future[AActor] | None] | Future[list[AActor | None]]) -> Future[FVector]:
        """Finds the average location (centroid) of an array of actors; null ones do not count."""
    def GetActorArrayBounds(self, Actors: Sequence[AActor | Future[AActor] | None] | Future[list[AActor | None]], bOnlyCollidingComponents: bool | Future[bool]) -> Future[UGameplayStatics_GetActorArrayBounds_Result]:
        """Finds the bounds of a set of actors, in centimetres."""
    @overload
    def GetActorOfClass(self, ActorClass: type[_T_AActor], *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[_T_AActor | None]:
        """Finds the first actor in the world of the specified class; null when there is none.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UGameplayStatics.GetActorOfClass (static)
        """
    @overload
    def GetActorOfClass(self, ActorClass: UClass | str | Future[UClass], *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[AActor | None]: ...
    def GetAllActorsOfClass(self, ActorClass: type[AActor] | UClass | str | Future[UClass], *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[UGameplayStatics_GetAllActorsOfClass_Result]:
        """Finds all actors in the world of the specified class, in the order of their spawning."""
    def GetAllActorsOfClassWithTag(self, ActorClass: type[AActor] | UClass | str | Future[UClass], Tag: str | Future[str], *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[UGameplayStatics_GetAllActorsOfClassWithTag_Result]:
        """Finds all actors in the world of the specified class with the specified tag."""
    def GetAllActorsWithInterface(self, Interface: type[UInterface] | UClass | str | Future[UClass], *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[UGameplayStatics_GetAllActorsWithInterface_Result]:
        """Finds all actors in the world with the specified interface."""
    def GetAllActorsWithTag(self, Tag: str | Future[str], *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[UGameplayStatics_GetAllActorsWithTag_Result]:
        """Finds all actors in the world with the supplied tag."""
    def GetCurrentLevelName(self, bRemovePrefixString: bool | Future[bool] = True, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[str]:
        """Gets the name of the currently open level, by default without the prefix of play-in-editor worlds (there is none here)."""
    def GetGameInstance(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[UGameInstance | None]:
        """Returns the game instance, or null when there is none."""
    def GetGameMode(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[AGameModeBase | None]:
        """Returns the current game mode, or null if it cannot be retrieved."""
    def GetGameState(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[AGameStateBase | None]:
        """Returns the current game state, or null if it cannot be retrieved."""
    def GetGlobalTimeDilation(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[float]:
        """Gets the current global time dilation: 1 is normal."""
    def GetIntOption(self, Options: str | Future[str], Key: str | Future[str], DefaultValue: int | Future[int]) -> Future[int]:
        """Finds an option in an options string and returns it as an integer, or a default value."""
    def GetKeyValue(self, Pair: str | Future[str]) -> Future[UGameplayStatics_GetKeyValue_Result]:
        """Breaks up a key=value pair into its key and value."""
    def GetNumPlayerControllers(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[int]:
        """Returns the total number of available players."""
    def GetObjectClass(self, Object: UObject | Future[UObject]) -> Future[UClass | None]:
        """Returns the class of a passed object, null for null."""
    def GetPlatformName(self) -> Future[str]:
        """Returns the name of the current platform: "Linux"."""
    def GetPlayerCameraManager(self, PlayerIndex: int | Future[int], *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[APlayerCameraManager | None]:
        """Returns the camera manager for the player controller at the specified player index; null if there is none."""
    def GetPlayerController(self, PlayerIndex: int | Future[int], *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[APlayerController | None]:
        """Returns the player controller found while iterating through the local and available player controllers; null when there is none at that index."""
    def GetPlayerPawn(self, PlayerIndex: int | Future[int], *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[APawn | None]:
        """Returns the pawn for the player controller at the specified player index; null if there is none."""
    def GetRealTimeSeconds(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[float]:
        """Returns time in seconds since the world was brought up for play: neither stopped nor dilated."""
    def GetTimeSeconds(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[float]:
        """Returns time in seconds since the world was brought up for play: stops while the game is paused, is dilated."""
    def GetUnpausedTimeSeconds(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[float]:
        """Returns time in seconds since the world was brought up for play: does not stop while the game is paused, is dilated."""
    def GetWorldDeltaSeconds(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[float]:
        """Returns the frame delta time in seconds, adjusted by time dilation."""
    def HasLaunchOption(self, OptionToCheck: str | Future[str]) -> Future[bool]:
        """Returns whether a command line option was given: a parameter such as -name."""
    def HasOption(self, Options: str | Future[str], InKey: str | Future[str]) -> Future[bool]:
        """Returns whether a key exists in an options string."""
    def IsGamePaused(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[bool]:
        """Returns the game's paused state."""
    def OpenLevel(self, LevelName: str | Future[str], bAbsolute: bool | Future[bool] = True, Options: str | Future[str] = "", *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[None]:
        """Travels to another level at the end of the frame."""
    def ParseOption(self, Options: str | Future[str], Key: str | Future[str]) -> Future[str]:
        """Finds an option in an options string and returns its value: "?Key=Value"; an empty string if it is not there."""
    def SetGamePaused(self, bPaused: bool | Future[bool], *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[bool]:
        """Sets the game's paused state."""
    def SetGlobalTimeDilation(self, TimeDilation: float | Future[float], *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[None]:
        """Sets the global time dilation: 1 is normal."""
    def SpawnObject(self, ObjectClass: type[UObject] | UClass | str | Future[UClass], Outer: UObject | Future[UObject]) -> Future[UObject | None]:
        """Creates an object of a class that is no actor, component or widget, with an outer that must not be null."""

class UGameplayStatics_send(UBlueprintFunctionLibrary_send):
    """UGameplayStatics under ``send_``: no function answers."""
    def BeginDeferredActorSpawnFromClass(self, ActorClass: type[AActor] | UClass | str | Future[UClass], SpawnTransform: FTransform_in, CollisionHandlingOverride: ESpawnActorCollisionHandlingMethod_in = ESpawnActorCollisionHandlingMethod.Undefined, Owner: AActor | Future[AActor] | None = None, TransformScaleMethod: ESpawnActorScaleMethod_in = ESpawnActorScaleMethod.MultiplyWithRoot, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Spawns an instance of an actor class, but does not run its construction."""
    def FindNearestActor(self, Origin: FVector_in, ActorsToCheck: Sequence[AActor | Future[AActor] | None] | Future[list[AActor | None]]) -> None:
        """Returns the actor nearest to Origin from ActorsToCheck, and how far it is (centimetres)."""
    def FinishSpawningActor(self, Actor: AActor | Future[AActor], SpawnTransform: FTransform_in, TransformScaleMethod: ESpawnActorScaleMethod_in = ESpawnActorScaleMethod.MultiplyWithRoot) -> None:
        """Finishes the spawning of an actor: runs its construction, initialises it and begins its play."""
    def GetAccurateRealTime(self) -> None:
        """Returns the time in seconds since the application was started: the whole seconds and the rest."""
    def GetActorArrayAverageLocation(self, Actors: Sequence[AActor | Future[AActor] | None] | Future[list[AActor | None]]) -> None:
        """Finds the average location (centroid) of an array of actors; null ones do not count."""
    def GetActorArrayBounds(self, Actors: Sequence[AActor | Future[AActor] | None] | Future[list[AActor | None]], bOnlyCollidingComponents: bool | Future[bool]) -> None:
        """Finds the bounds of a set of actors, in centimetres."""
    def GetActorOfClass(self, ActorClass: type[AActor] | UClass | str | Future[UClass], *, WorldContextObject: UObject | Future[UObject] = ...) -> None: ...
    def GetAllActorsOfClass(self, ActorClass: type[AActor] | UClass | str | Future[UClass], *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Finds all actors in the world of the specified class, in the order of their spawning."""
    def GetAllActorsOfClassWithTag(self, ActorClass: type[AActor] | UClass | str | Future[UClass], Tag: str | Future[str], *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Finds all actors in the world of the specified class with the specified tag."""
    def GetAllActorsWithInterface(self, Interface: type[UInterface] | UClass | str | Future[UClass], *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Finds all actors in the world with the specified interface."""
    def GetAllActorsWithTag(self, Tag: str | Future[str], *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Finds all actors in the world with the supplied tag."""
    def GetCurrentLevelName(self, bRemovePrefixString: bool | Future[bool] = True, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Gets the name of the currently open level, by default without the prefix of play-in-editor worlds (there is none here)."""
    def GetGameInstance(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns the game instance, or null when there is none."""
    def GetGameMode(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns the current game mode, or null if it cannot be retrieved."""
    def GetGameState(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns the current game state, or null if it cannot be retrieved."""
    def GetGlobalTimeDilation(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Gets the current global time dilation: 1 is normal."""
    def GetIntOption(self, Options: str | Future[str], Key: str | Future[str], DefaultValue: int | Future[int]) -> None:
        """Finds an option in an options string and returns it as an integer, or a default value."""
    def GetKeyValue(self, Pair: str | Future[str]) -> None:
        """Breaks up a key=value pair into its key and value."""
    def GetNumPlayerControllers(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns the total number of available players."""
    def GetObjectClass(self, Object: UObject | Future[UObject]) -> None:
        """Returns the class of a passed object, null for null."""
    def GetPlatformName(self) -> None:
        """Returns the name of the current platform: "Linux"."""
    def GetPlayerCameraManager(self, PlayerIndex: int | Future[int], *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns the camera manager for the player controller at the specified player index; null if there is none."""
    def GetPlayerController(self, PlayerIndex: int | Future[int], *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns the player controller found while iterating through the local and available player controllers; null when there is none at that index."""
    def GetPlayerPawn(self, PlayerIndex: int | Future[int], *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns the pawn for the player controller at the specified player index; null if there is none."""
    def GetRealTimeSeconds(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns time in seconds since the world was brought up for play: neither stopped nor dilated."""
    def GetTimeSeconds(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns time in seconds since the world was brought up for play: stops while the game is paused, is dilated."""
    def GetUnpausedTimeSeconds(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns time in seconds since the world was brought up for play: does not stop while the game is paused, is dilated."""
    def GetWorldDeltaSeconds(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns the frame delta time in seconds, adjusted by time dilation."""
    def HasLaunchOption(self, OptionToCheck: str | Future[str]) -> None:
        """Returns whether a command line option was given: a parameter such as -name."""
    def HasOption(self, Options: str | Future[str], InKey: str | Future[str]) -> None:
        """Returns whether a key exists in an options string."""
    def IsGamePaused(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns the game's paused state."""
    def OpenLevel(self, LevelName: str | Future[str], bAbsolute: bool | Future[bool] = True, Options: str | Future[str] = "", *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Travels to another level at the end of the frame."""
    def ParseOption(self, Options: str | Future[str], Key: str | Future[str]) -> None:
        """Finds an option in an options string and returns its value: "?Key=Value"; an empty string if it is not there."""
    def SetGamePaused(self, bPaused: bool | Future[bool], *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Sets the game's paused state."""
    def SetGlobalTimeDilation(self, TimeDilation: float | Future[float], *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Sets the global time dilation: 1 is normal."""
    def SpawnObject(self, ObjectClass: type[UObject] | UClass | str | Future[UClass], Outer: UObject | Future[UObject]) -> None:
        """Creates an object of a class that is no actor, component or widget, with an outer that must not be null."""

class UGameplayStatics(UGameplayStatics_members, UBlueprintFunctionLibrary):
    """What scripts and remote programs ask a running game: players, time, levels, and actors by class or tag. Epic
    page: UGameplayStatics.

    Unreal: /Script/Engine.GameplayStatics
    """
    @property
    def async_(self) -> UGameplayStatics_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UGameplayStatics_send:
        """The same functions and variables, fire-and-forget."""

class UGameplayStatics_path(ObjectPath[UGameplayStatics, UGameplayStatics_async_path, UGameplayStatics_send], UGameplayStatics_members):
    """A variable that refers to an object of UGameplayStatics: its path."""

class UGameplayStatics_async_path(AsyncObjectPath[UGameplayStatics], UGameplayStatics_async):
    """The same under ``async_``."""
