# generated, do not edit (Engine: Public/Kismet/KismetSystemLibrary.h)
from collections.abc import Sequence
from typing import NamedTuple, TypeAlias
from spear.enums import UnrealEnum
from spear.typing import AsyncObjectPath, Future, ObjectPath
from ..CoreUObject._Intrinsic import FScriptDelegate_in, UClass, UInterface
from ..CoreUObject._NoExportTypes import (
    FLinearColor_in, FRotator_in, FSoftObjectPath, FSoftObjectPath_in, FTransform_in, FVector, FVector_in, UObject,
)
from ._Actor import AActor
from ._BlueprintFunctionLibrary import (
    UBlueprintFunctionLibrary, UBlueprintFunctionLibrary_async, UBlueprintFunctionLibrary_members, UBlueprintFunctionLibrary_send,
)
from ._PlayerController import APlayerController
from ._PrimitiveComponent import UPrimitiveComponent
from ._SceneComponent import USceneComponent
from ._TimerHandle import FTimerHandle, FTimerHandle_in

class EMoveComponentAction(UnrealEnum):
    """What MoveComponentTo does. Epic page: EMoveComponentAction::Type.

    Unreal: /Script/Engine.EMoveComponentAction
    """
    Move = 0
    """Move to target over specified time."""
    Stop = 1
    """If currently moving, stop."""
    Return = 2
    """If currently moving, return to where you started, over the time elapsed so far."""

EMoveComponentAction_in: TypeAlias = EMoveComponentAction | str | Future[EMoveComponentAction]
"""What stands for EMoveComponentAction as an argument: an entry, the name that Unreal gives it, a future."""

class EQuitPreference(UnrealEnum):
    """How a game is left. Epic page: EQuitPreference::Type.

    Unreal: /Script/Engine.EQuitPreference
    """
    Quit = 0
    """Exit the game completely."""
    Background = 1
    """Move the application to the background."""

EQuitPreference_in: TypeAlias = EQuitPreference | str | Future[EQuitPreference]
"""What stands for EQuitPreference as an argument: an entry, the name that Unreal gives it, a future."""

class UKismetSystemLibrary_BreakSoftObjectPath_Result(NamedTuple):
    """Results of UKismetSystemLibrary.BreakSoftObjectPath."""
    PathString: str

class UKismetSystemLibrary_GetActorListFromComponentList_Result(NamedTuple):
    """Results of UKismetSystemLibrary.GetActorListFromComponentList."""
    OutActorList: list[AActor]

class UKismetSystemLibrary_GetComponentBounds_Result(NamedTuple):
    """Results of UKismetSystemLibrary.GetComponentBounds."""
    Origin: FVector
    BoxExtent: FVector
    SphereRadius: float

class UKismetSystemLibrary_K2_ClearAndInvalidateTimerHandle_Result(NamedTuple):
    """Results of UKismetSystemLibrary.K2_ClearAndInvalidateTimerHandle."""
    Handle: FTimerHandle

class UKismetSystemLibrary_K2_InvalidateTimerHandle_Result(NamedTuple):
    """Results of UKismetSystemLibrary.K2_InvalidateTimerHandle."""
    ReturnValue: FTimerHandle
    Handle: FTimerHandle

class UKismetSystemLibrary_ParseParamValue_Result(NamedTuple):
    """Results of UKismetSystemLibrary.ParseParamValue."""
    ReturnValue: bool
    OutValue: str

class UKismetSystemLibrary_members(UBlueprintFunctionLibrary_members):
    """Functions and variables of UKismetSystemLibrary."""
    def BreakSoftObjectPath(self, InSoftObjectPath: FSoftObjectPath_in) -> UKismetSystemLibrary_BreakSoftObjectPath_Result:
        """Gets the path string out of a soft object path.

        Unreal: UKismetSystemLibrary.BreakSoftObjectPath (static)
        """
    def CollectGarbage(self) -> None:
        """Deletes all unreferenced objects, keeping only referenced objects (this command will be queued and happen at
        the end of the frame).

        Unreal: UKismetSystemLibrary.CollectGarbage (static)
        """
    def Conv_ObjectToClass(self, Object: UObject | Future[UObject], Class: type[UObject] | UClass | str | Future[UClass]) -> UClass | None:
        """Casts from an object to a class; null when it is no class or not derived from the wanted one.

        Unreal: UKismetSystemLibrary.Conv_ObjectToClass (static)
        """
    def Conv_ObjectToSoftObjectReference(self, Object: UObject | Future[UObject]) -> str:
        """Converts an object to a soft reference to it.

        Unreal: UKismetSystemLibrary.Conv_ObjectToSoftObjectReference (static)
        """
    def Conv_SoftObjectReferenceToObject(self, SoftObject: str | UObject | Future[str] | Future[UObject]) -> UObject | None:
        """Resolves a soft reference to an object that is loaded; null if it is not.

        Unreal: UKismetSystemLibrary.Conv_SoftObjectReferenceToObject (static)
        """
    def Conv_SoftObjectReferenceToString(self, SoftObjectReference: str | UObject | Future[str] | Future[UObject]) -> str:
        """Converts a soft object reference to its path.

        Unreal: UKismetSystemLibrary.Conv_SoftObjectReferenceToString (static)
        """
    def Delay(self, Duration: float | Future[float], *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Performs a latent action with a delay (specified in seconds). Calling again while it is counting down will be
        ignored.

        Args:
            WorldContextObject: The world; the server fills it in.

        Latent: completes in a later frame.

        Unreal: UKismetSystemLibrary.Delay (static)
        """
    def DelayUntilNextTick(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Performs a latent action with a delay of one tick. Calling again while it is counting down will be ignored.

        Args:
            WorldContextObject: The world; the server fills it in.

        Latent: completes in a later frame.

        Unreal: UKismetSystemLibrary.DelayUntilNextTick (static)
        """
    def DoesClassImplementInterface(self, TestClass: type[UObject] | UClass | str | Future[UClass], Interface: type[UInterface] | UClass | str | Future[UClass]) -> bool:
        """Determines if the passed class implements the supplied interface.

        Unreal: UKismetSystemLibrary.DoesClassImplementInterface (static)
        """
    def DoesImplementInterface(self, TestObject: UObject | Future[UObject], Interface: type[UInterface] | UClass | str | Future[UClass]) -> bool:
        """Determines if the passed object implements the supplied interface.

        Unreal: UKismetSystemLibrary.DoesImplementInterface (static)
        """
    def EqualEqual_SoftObjectReference(self, A: str | UObject | Future[str] | Future[UObject], B: str | UObject | Future[str] | Future[UObject]) -> bool:
        """Returns true if the soft object references are equal (A == B).

        Unreal: UKismetSystemLibrary.EqualEqual_SoftObjectReference (static)
        """
    def ExecuteConsoleCommand(self, Command: str | Future[str], SpecificPlayer: APlayerController | Future[APlayerController] | None = None, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Executes a console command, optionally on a specific player controller.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UKismetSystemLibrary.ExecuteConsoleCommand (static)
        """
    def GetActorListFromComponentList(self, ComponentList: Sequence[UPrimitiveComponent | Future[UPrimitiveComponent] | None] | Future[list[UPrimitiveComponent | None]], ActorClassFilter: type[UObject] | UClass | str | Future[UClass]) -> UKismetSystemLibrary_GetActorListFromComponentList_Result:
        """Returns the distinct owners of a list of components, optionally only those of a class.

        Unreal: UKismetSystemLibrary.GetActorListFromComponentList (static)
        """
    def GetBuildConfiguration(self) -> str:
        """Returns the build configuration.

        Unreal: UKismetSystemLibrary.GetBuildConfiguration (static)
        """
    def GetClassDisplayName(self, Class: type[UObject] | UClass | str | Future[UClass]) -> str:
        """Returns the display name of a class; an empty string for null.

        Unreal: UKismetSystemLibrary.GetClassDisplayName (static)
        """
    def GetCommandLine(self) -> str:
        """Returns the command line the process was launched with.

        Unreal: UKismetSystemLibrary.GetCommandLine (static)
        """
    def GetComponentBounds(self, Component: USceneComponent | Future[USceneComponent]) -> UKismetSystemLibrary_GetComponentBounds_Result:
        """Gets the bounds of a component in world space, in centimetres; zero for null.

        Unreal: UKismetSystemLibrary.GetComponentBounds (static)
        """
    def GetConsoleVariableBoolValue(self, VariableName: str | Future[str]) -> bool:
        """Gets whether a console variable has a non-zero value; false with a warning in the log if there is none.

        Unreal: UKismetSystemLibrary.GetConsoleVariableBoolValue (static)
        """
    def GetConsoleVariableFloatValue(self, VariableName: str | Future[str]) -> float:
        """Gets the value of a console variable as a float; 0 with a warning in the log if there is none.

        Unreal: UKismetSystemLibrary.GetConsoleVariableFloatValue (static)
        """
    def GetConsoleVariableIntValue(self, VariableName: str | Future[str]) -> int:
        """Gets the value of a console variable as an integer; 0 with a warning in the log if there is none.

        Unreal: UKismetSystemLibrary.GetConsoleVariableIntValue (static)
        """
    def GetConsoleVariableStringValue(self, VariableName: str | Future[str]) -> str:
        """Gets the value of a console variable as text; an empty string with a warning in the log if there is none.

        Unreal: UKismetSystemLibrary.GetConsoleVariableStringValue (static)
        """
    def GetDisplayName(self, Object: UObject | Future[UObject]) -> str:
        """Returns the display name (or actor label), for displaying. In the embedded engine that is the object name;
        "None" for null.

        Unreal: UKismetSystemLibrary.GetDisplayName (static)
        """
    def GetEngineVersion(self) -> str:
        """Returns the version of the engine. The embedded engine says so in it.

        Unreal: UKismetSystemLibrary.GetEngineVersion (static)
        """
    def GetFrameCount(self) -> int:
        """Returns the number of the current frame.

        Unreal: UKismetSystemLibrary.GetFrameCount (static)
        """
    def GetGameName(self) -> str:
        """Returns the name of the current project.

        Unreal: UKismetSystemLibrary.GetGameName (static)
        """
    def GetGameTimeInSeconds(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> float:
        """Gets the current game time, in seconds. This stops when the game is paused and is affected by time dilation.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UKismetSystemLibrary.GetGameTimeInSeconds (static)
        """
    def GetObjectName(self, Object: UObject | Future[UObject]) -> str:
        """Returns the actual object name; "None" for null.

        Unreal: UKismetSystemLibrary.GetObjectName (static)
        """
    def GetOuterObject(self, Object: UObject | Future[UObject]) -> UObject:
        """Returns the outer object of an object.

        Unreal: UKismetSystemLibrary.GetOuterObject (static)
        """
    def GetPathName(self, Object: UObject | Future[UObject]) -> str:
        """Returns the full path to the specified object; "None" for null.

        Unreal: UKismetSystemLibrary.GetPathName (static)
        """
    def GetPlatformUserName(self) -> str:
        """Returns the name of the user who runs the process.

        Unreal: UKismetSystemLibrary.GetPlatformUserName (static)
        """
    def GetProjectContentDirectory(self) -> str:
        """Returns the content directory of the current project.

        Unreal: UKismetSystemLibrary.GetProjectContentDirectory (static)
        """
    def GetProjectDirectory(self) -> str:
        """Returns the directory of the current project.

        Unreal: UKismetSystemLibrary.GetProjectDirectory (static)
        """
    def GetProjectSavedDirectory(self) -> str:
        """Returns the saved directory of the current project.

        Unreal: UKismetSystemLibrary.GetProjectSavedDirectory (static)
        """
    def IsDedicatedServer(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> bool:
        """Returns whether this is running on a dedicated server.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UKismetSystemLibrary.IsDedicatedServer (static)
        """
    def IsServer(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> bool:
        """Returns whether this process is (also) the server. Without a network it is.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UKismetSystemLibrary.IsServer (static)
        """
    def IsStandalone(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> bool:
        """Returns whether this game instance is stand-alone (no networking).

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UKismetSystemLibrary.IsStandalone (static)
        """
    def IsValid(self, Object: UObject | Future[UObject]) -> bool:
        """Returns true if the object is usable: non-null and not pending destruction.

        Unreal: UKismetSystemLibrary.IsValid (static)
        """
    def IsValidClass(self, Class: type[UObject] | UClass | str | Future[UClass]) -> bool:
        """Returns true if the class is usable: non-null and not pending destruction.

        Unreal: UKismetSystemLibrary.IsValidClass (static)
        """
    def IsValidSoftObjectReference(self, SoftObjectReference: str | UObject | Future[str] | Future[UObject]) -> bool:
        """Returns true if the soft object reference is not null.

        Unreal: UKismetSystemLibrary.IsValidSoftObjectReference (static)
        """
    def K2_ClearAndInvalidateTimerHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> UKismetSystemLibrary_K2_ClearAndInvalidateTimerHandle_Result:
        """Clears the timer and invalidates the handle.

        Args:
            Handle: Also a result.
            WorldContextObject: The world; the server fills it in.

        Unreal: UKismetSystemLibrary.K2_ClearAndInvalidateTimerHandle (static)
        """
    def K2_ClearTimer(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> None:
        """Clears a set timer.

        Unreal: UKismetSystemLibrary.K2_ClearTimer (static)
        """
    def K2_GetTimerElapsedTimeHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> float:
        """Returns elapsed time for the given handle (time since current countdown iteration began), in seconds; 0 if
        there is no such timer.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UKismetSystemLibrary.K2_GetTimerElapsedTimeHandle (static)
        """
    def K2_GetTimerRemainingTimeHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> float:
        """Returns time until the timer will next execute its function, in seconds; 0 if there is no such timer.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UKismetSystemLibrary.K2_GetTimerRemainingTimeHandle (static)
        """
    def K2_InvalidateTimerHandle(self, Handle: FTimerHandle_in) -> UKismetSystemLibrary_K2_InvalidateTimerHandle_Result:
        """Invalidates the supplied timer handle and returns it. The timer itself goes on.

        Args:
            Handle: Also a result.

        Unreal: UKismetSystemLibrary.K2_InvalidateTimerHandle (static)
        """
    def K2_IsTimerActive(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> bool:
        """Returns true if a timer exists and is active for the given function, false otherwise.

        Unreal: UKismetSystemLibrary.K2_IsTimerActive (static)
        """
    def K2_IsTimerActiveHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> bool:
        """Returns true if a timer exists and is active for the given handle, false otherwise.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UKismetSystemLibrary.K2_IsTimerActiveHandle (static)
        """
    def K2_IsValidTimerHandle(self, Handle: FTimerHandle_in) -> bool:
        """Returns whether the timer handle is valid. This does not indicate that there is an active timer that this
        handle references.

        Unreal: UKismetSystemLibrary.K2_IsValidTimerHandle (static)
        """
    def K2_PauseTimer(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> None:
        """Pauses a set timer at its current elapsed time.

        Unreal: UKismetSystemLibrary.K2_PauseTimer (static)
        """
    def K2_PauseTimerHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Pauses a timer at its current elapsed time.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UKismetSystemLibrary.K2_PauseTimerHandle (static)
        """
    def K2_SetTimer(self, Object: UObject | Future[UObject], FunctionName: str | Future[str], Time: float | Future[float], bLooping: bool | Future[bool], bMaxOncePerFrame: bool | Future[bool] = False, InitialStartDelay: float | Future[float] = 0.0, InitialStartDelayVariance: float | Future[float] = 0.0) -> FTimerHandle:
        """Sets a timer to execute a function of an object. Setting an existing timer will reset that timer with updated
        parameters; a time of 0 or less clears it.

        Unreal: UKismetSystemLibrary.K2_SetTimer (static)
        """
    def K2_SetTimerDelegate(self, Delegate: FScriptDelegate_in | None, Time: float | Future[float], bLooping: bool | Future[bool], bMaxOncePerFrame: bool | Future[bool] = False, InitialStartDelay: float | Future[float] = 0.0, InitialStartDelayVariance: float | Future[float] = 0.0) -> FTimerHandle:
        """Sets a timer to execute a delegate. Setting an existing timer will reset that timer with updated parameters; a
        time of 0 or less clears it.

        Unreal: UKismetSystemLibrary.K2_SetTimerDelegate (static)
        """
    def K2_SetTimerForNextTick(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> FTimerHandle:
        """Sets a timer to execute a function of an object on the next tick.

        Unreal: UKismetSystemLibrary.K2_SetTimerForNextTick (static)
        """
    def K2_TimerExists(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> bool:
        """Returns true if a timer exists for the given function, false otherwise.

        Unreal: UKismetSystemLibrary.K2_TimerExists (static)
        """
    def K2_UnPauseTimer(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> None:
        """Resumes a paused timer from its current elapsed time.

        Unreal: UKismetSystemLibrary.K2_UnPauseTimer (static)
        """
    def K2_UnPauseTimerHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Resumes a paused timer from its current elapsed time.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UKismetSystemLibrary.K2_UnPauseTimerHandle (static)
        """
    def LoadAsset_Blocking(self, Asset: str | UObject | Future[str] | Future[UObject]) -> UObject:
        """Resolves or loads a soft object reference immediately.

        Unreal: UKismetSystemLibrary.LoadAsset_Blocking (static)
        """
    def MakeLiteralBool(self, Value: bool | Future[bool]) -> bool:
        """Creates a literal: returns the value.

        Unreal: UKismetSystemLibrary.MakeLiteralBool (static)
        """
    def MakeLiteralByte(self, Value: int | Future[int]) -> int:
        """Creates a literal: returns the value.

        Unreal: UKismetSystemLibrary.MakeLiteralByte (static)
        """
    def MakeLiteralDouble(self, Value: float | Future[float]) -> float:
        """Creates a literal: returns the value.

        Unreal: UKismetSystemLibrary.MakeLiteralDouble (static)
        """
    def MakeLiteralFloat(self, Value: float | Future[float]) -> float:
        """Creates a literal: returns the value.

        Unreal: UKismetSystemLibrary.MakeLiteralFloat (static)
        """
    def MakeLiteralInt(self, Value: int | Future[int]) -> int:
        """Creates a literal: returns the value.

        Unreal: UKismetSystemLibrary.MakeLiteralInt (static)
        """
    def MakeLiteralInt64(self, Value: int | Future[int]) -> int:
        """Creates a literal: returns the value.

        Unreal: UKismetSystemLibrary.MakeLiteralInt64 (static)
        """
    def MakeLiteralName(self, Value: str | Future[str]) -> str:
        """Creates a literal: returns the value.

        Unreal: UKismetSystemLibrary.MakeLiteralName (static)
        """
    def MakeLiteralString(self, Value: str | Future[str]) -> str:
        """Creates a literal: returns the value.

        Unreal: UKismetSystemLibrary.MakeLiteralString (static)
        """
    def MakeLiteralText(self, Value: str | Future[str]) -> str:
        """Creates a literal: returns the value.

        Unreal: UKismetSystemLibrary.MakeLiteralText (static)
        """
    def MakeSoftObjectPath(self, PathString: str | Future[str]) -> FSoftObjectPath:
        """Builds a soft object path from a string that contains a full path.

        Unreal: UKismetSystemLibrary.MakeSoftObjectPath (static)
        """
    def MoveComponentTo(self, TargetRelativeLocation: FVector_in, TargetRelativeRotation: FRotator_in, bEaseOut: bool | Future[bool], bEaseIn: bool | Future[bool], OverTime: float | Future[float], bForceShortestRotationPath: bool | Future[bool], MoveAction: EMoveComponentAction_in, *, Component: USceneComponent | Future[USceneComponent] = ...) -> None:
        """Interpolates a component to the specified relative location and rotation over a time (seconds). Move starts,
        Stop leaves the component where it is, Return moves it back to where it started.

        Args:
            Component: The world; the server fills it in.

        Latent: completes in a later frame.

        Unreal: UKismetSystemLibrary.MoveComponentTo (static)
        """
    def ParseParam(self, InString: str | Future[str], InParam: str | Future[str]) -> bool:
        """Returns whether a string has a -parameter.

        Unreal: UKismetSystemLibrary.ParseParam (static)
        """
    def ParseParamValue(self, InString: str | Future[str], InParam: str | Future[str]) -> UKismetSystemLibrary_ParseParamValue_Result:
        """Returns "value" if a string has "param=value".

        Unreal: UKismetSystemLibrary.ParseParamValue (static)
        """
    def PrintString(self, InString: str | Future[str] = "Hello", bPrintToScreen: bool | Future[bool] = True, bPrintToLog: bool | Future[bool] = True, TextColor: FLinearColor_in = ..., Duration: float | Future[float] = 2.0, Key: str | Future[str] = "None", *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Prints a string to the log, and optionally to the list of messages on the screen. If bPrintToLog is false the
        log gets it as Verbose.

        Args:
            TextColor: Default FLinearColor(R=0.0, G=0.66, B=1.0, A=1.0).
            WorldContextObject: The world; the server fills it in.

        Unreal: UKismetSystemLibrary.PrintString (static)
        """
    def PrintText(self, InText: str | Future[str], bPrintToScreen: bool | Future[bool] = True, bPrintToLog: bool | Future[bool] = True, TextColor: FLinearColor_in = ..., Duration: float | Future[float] = 2.0, Key: str | Future[str] = "None", *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Prints text to the log, and optionally to the list of messages on the screen.

        Args:
            TextColor: Default FLinearColor(R=0.0, G=0.66, B=1.0, A=1.0).
            WorldContextObject: The world; the server fills it in.

        Unreal: UKismetSystemLibrary.PrintText (static)
        """
    def PrintWarning(self, InString: str | Future[str]) -> None:
        """Prints a warning string to the log.

        Unreal: UKismetSystemLibrary.PrintWarning (static)
        """
    def QuitGame(self, SpecificPlayer: APlayerController | Future[APlayerController], QuitPreference: EQuitPreference_in, bIgnorePlatformRestrictions: bool | Future[bool], *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Exits the current game at the end of the frame. Background is the same here as Quit.

        Args:
            WorldContextObject: The world; the server fills it in.

        Unreal: UKismetSystemLibrary.QuitGame (static)
        """
    def RetriggerableDelay(self, Duration: float | Future[float], *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Performs a latent action with a retriggerable delay (specified in seconds). Calling again while it is counting
        down will reset the countdown to Duration.

        Args:
            WorldContextObject: The world; the server fills it in.

        Latent: completes in a later frame.

        Unreal: UKismetSystemLibrary.RetriggerableDelay (static)
        """
    def SetBoolPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: bool | Future[bool]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is,
        with a warning in the log.

        Unreal: UKismetSystemLibrary.SetBoolPropertyByName (static)
        """
    def SetBytePropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: int | Future[int]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is,
        with a warning in the log.

        Unreal: UKismetSystemLibrary.SetBytePropertyByName (static)
        """
    def SetClassPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: type[UObject] | UClass | str | Future[UClass]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is,
        with a warning in the log.

        Unreal: UKismetSystemLibrary.SetClassPropertyByName (static)
        """
    def SetDoublePropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: float | Future[float]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is,
        with a warning in the log.

        Unreal: UKismetSystemLibrary.SetDoublePropertyByName (static)
        """
    def SetInt64PropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: int | Future[int]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is,
        with a warning in the log.

        Unreal: UKismetSystemLibrary.SetInt64PropertyByName (static)
        """
    def SetIntPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: int | Future[int]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is,
        with a warning in the log.

        Unreal: UKismetSystemLibrary.SetIntPropertyByName (static)
        """
    def SetLinearColorPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: FLinearColor_in) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is,
        with a warning in the log.

        Unreal: UKismetSystemLibrary.SetLinearColorPropertyByName (static)
        """
    def SetNamePropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: str | Future[str]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is,
        with a warning in the log.

        Unreal: UKismetSystemLibrary.SetNamePropertyByName (static)
        """
    def SetObjectPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: UObject | Future[UObject]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is,
        with a warning in the log.

        Unreal: UKismetSystemLibrary.SetObjectPropertyByName (static)
        """
    def SetRotatorPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: FRotator_in) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is,
        with a warning in the log.

        Unreal: UKismetSystemLibrary.SetRotatorPropertyByName (static)
        """
    def SetStringPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: str | Future[str]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is,
        with a warning in the log.

        Unreal: UKismetSystemLibrary.SetStringPropertyByName (static)
        """
    def SetTransformPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: FTransform_in) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is,
        with a warning in the log.

        Unreal: UKismetSystemLibrary.SetTransformPropertyByName (static)
        """
    def SetVectorPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: FVector_in) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is,
        with a warning in the log.

        Unreal: UKismetSystemLibrary.SetVectorPropertyByName (static)
        """

class UKismetSystemLibrary_async(UBlueprintFunctionLibrary_async):
    """UKismetSystemLibrary under ``async_``: each function gives a future."""
    def BreakSoftObjectPath(self, InSoftObjectPath: FSoftObjectPath_in) -> Future[UKismetSystemLibrary_BreakSoftObjectPath_Result]:
        """Gets the path string out of a soft object path."""
    def CollectGarbage(self) -> Future[None]:
        """Deletes all unreferenced objects, keeping only referenced objects (this command will be queued and happen at the end of the frame)."""
    def Conv_ObjectToClass(self, Object: UObject | Future[UObject], Class: type[UObject] | UClass | str | Future[UClass]) -> Future[UClass | None]:
        """Casts from an object to a class; null when it is no class or not derived from the wanted one."""
    def Conv_ObjectToSoftObjectReference(self, Object: UObject | Future[UObject]) -> Future[str]:
        """Converts an object to a soft reference to it."""
    def Conv_SoftObjectReferenceToObject(self, SoftObject: str | UObject | Future[str] | Future[UObject]) -> Future[UObject | None]:
        """Resolves a soft reference to an object that is loaded; null if it is not."""
    def Conv_SoftObjectReferenceToString(self, SoftObjectReference: str | UObject | Future[str] | Future[UObject]) -> Future[str]:
        """Converts a soft object reference to its path."""
    def Delay(self, Duration: float | Future[float], *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[None]:
        """Performs a latent action with a delay (specified in seconds)."""
    def DelayUntilNextTick(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[None]:
        """Performs a latent action with a delay of one tick."""
    def DoesClassImplementInterface(self, TestClass: type[UObject] | UClass | str | Future[UClass], Interface: type[UInterface] | UClass | str | Future[UClass]) -> Future[bool]:
        """Determines if the passed class implements the supplied interface."""
    def DoesImplementInterface(self, TestObject: UObject | Future[UObject], Interface: type[UInterface] | UClass | str | Future[UClass]) -> Future[bool]:
        """Determines if the passed object implements the supplied interface."""
    def EqualEqual_SoftObjectReference(self, A: str | UObject | Future[str] | Future[UObject], B: str | UObject | Future[str] | Future[UObject]) -> Future[bool]:
        """Returns true if the soft object references are equal (A == B)."""
    def ExecuteConsoleCommand(self, Command: str | Future[str], SpecificPlayer: APlayerController | Future[APlayerController] | None = None, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[None]:
        """Executes a console command, optionally on a specific player controller."""
    def GetActorListFromComponentList(self, ComponentList: Sequence[UPrimitiveComponent | Future[UPrimitiveComponent] | None] | Future[list[UPrimitiveComponent | None]], ActorClassFilter: type[UObject] | UClass | str | Future[UClass]) -> Future[UKismetSystemLibrary_GetActorListFromComponentList_Result]:
        """Returns the distinct owners of a list of components, optionally only those of a class."""
    def GetBuildConfiguration(self) -> Future[str]:
        """Returns the build configuration."""
    def GetClassDisplayName(self, Class: type[UObject] | UClass | str | Future[UClass]) -> Future[str]:
        """Returns the display name of a class; an empty string for null."""
    def GetCommandLine(self) -> Future[str]:
        """Returns the command line the process was launched with."""
    def GetComponentBounds(self, Component: USceneComponent | Future[USceneComponent]) -> Future[UKismetSystemLibrary_GetComponentBounds_Result]:
        """Gets the bounds of a component in world space, in centimetres; zero for null."""
    def GetConsoleVariableBoolValue(self, VariableName: str | Future[str]) -> Future[bool]:
        """Gets whether a console variable has a non-zero value; false with a warning in the log if there is none."""
    def GetConsoleVariableFloatValue(self, VariableName: str | Future[str]) -> Future[float]:
        """Gets the value of a console variable as a float; 0 with a warning in the log if there is none."""
    def GetConsoleVariableIntValue(self, VariableName: str | Future[str]) -> Future[int]:
        """Gets the value of a console variable as an integer; 0 with a warning in the log if there is none."""
    def GetConsoleVariableStringValue(self, VariableName: str | Future[str]) -> Future[str]:
        """Gets the value of a console variable as text; an empty string with a warning in the log if there is none."""
    def GetDisplayName(self, Object: UObject | Future[UObject]) -> Future[str]:
        """Returns the display name (or actor label), for displaying."""
    def GetEngineVersion(self) -> Future[str]:
        """Returns the version of the engine."""
    def GetFrameCount(self) -> Future[int]:
        """Returns the number of the current frame."""
    def GetGameName(self) -> Future[str]:
        """Returns the name of the current project."""
    def GetGameTimeInSeconds(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[float]:
        """Gets the current game time, in seconds."""
    def GetObjectName(self, Object: UObject | Future[UObject]) -> Future[str]:
        """Returns the actual object name; "None" for null."""
    def GetOuterObject(self, Object: UObject | Future[UObject]) -> Future[UObject]:
        """Returns the outer object of an object."""
    def GetPathName(self, Object: UObject | Future[UObject]) -> Future[str]:
        """Returns the full path to the specified object; "None" for null."""
    def GetPlatformUserName(self) -> Future[str]:
        """Returns the name of the user who runs the process."""
    def GetProjectContentDirectory(self) -> Future[str]:
        """Returns the content directory of the current project."""
    def GetProjectDirectory(self) -> Future[str]:
        """Returns the directory of the current project."""
    def GetProjectSavedDirectory(self) -> Future[str]:
        """Returns the saved directory of the current project."""
    def IsDedicatedServer(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[bool]:
        """Returns whether this is running on a dedicated server."""
    def IsServer(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[bool]:
        """Returns whether this process is (also) the server."""
    def IsStandalone(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[bool]:
        """Returns whether this game instance is stand-alone (no networking)."""
    def IsValid(self, Object: UObject | Future[UObject]) -> Future[bool]:
        """Returns true if the object is usable: non-null and not pending destruction."""
    def IsValidClass(self, Class: type[UObject] | UClass | str | Future[UClass]) -> Future[bool]:
        """Returns true if the class is usable: non-null and not pending destruction."""
    def IsValidSoftObjectReference(self, SoftObjectReference: str | UObject | Future[str] | Future[UObject]) -> Future[bool]:
        """Returns true if the soft object reference is not null."""
    def K2_ClearAndInvalidateTimerHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[UKismetSystemLibrary_K2_ClearAndInvalidateTimerHandle_Result]:
        """Clears the timer and invalidates the handle."""
    def K2_ClearTimer(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> Future[None]:
        """Clears a set timer."""
    def K2_GetTimerElapsedTimeHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[float]:
        """Returns elapsed time for the given handle (time since current countdown iteration began), in seconds; 0 if there is no such timer."""
    def K2_GetTimerRemainingTimeHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[float]:
        """Returns time until the timer will next execute its function, in seconds; 0 if there is no such timer."""
    def K2_InvalidateTimerHandle(self, Handle: FTimerHandle_in) -> Future[UKismetSystemLibrary_K2_InvalidateTimerHandle_Result]:
        """Invalidates the supplied timer handle and returns it."""
    def K2_IsTimerActive(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> Future[bool]:
        """Returns true if a timer exists and is active for the given function, false otherwise."""
    def K2_IsTimerActiveHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[bool]:
        """Returns true if a timer exists and is active for the given handle, false otherwise."""
    def K2_IsValidTimerHandle(self, Handle: FTimerHandle_in) -> Future[bool]:
        """Returns whether the timer handle is valid."""
    def K2_PauseTimer(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> Future[None]:
        """Pauses a set timer at its current elapsed time."""
    def K2_PauseTimerHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[None]:
        """Pauses a timer at its current elapsed time."""
    def K2_SetTimer(self, Object: UObject | Future[UObject], FunctionName: str | Future[str], Time: float | Future[float], bLooping: bool | Future[bool], bMaxOncePerFrame: bool | Future[bool] = False, InitialStartDelay: float | Future[float] = 0.0, InitialStartDelayVariance: float | Future[float] = 0.0) -> Future[FTimerHandle]:
        """Sets a timer to execute a function of an object."""
    def K2_SetTimerDelegate(self, Delegate: FScriptDelegate_in | None, Time: float | Future[float], bLooping: bool | Future[bool], bMaxOncePerFrame: bool | Future[bool] = False, InitialStartDelay: float | Future[float] = 0.0, InitialStartDelayVariance: float | Future[float] = 0.0) -> Future[FTimerHandle]:
        """Sets a timer to execute a delegate."""
    def K2_SetTimerForNextTick(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> Future[FTimerHandle]:
        """Sets a timer to execute a function of an object on the next tick."""
    def K2_TimerExists(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> Future[bool]:
        """Returns true if a timer exists for the given function, false otherwise."""
    def K2_UnPauseTimer(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> Future[None]:
        """Resumes a paused timer from its current elapsed time."""
    def K2_UnPauseTimerHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[None]:
        """Resumes a paused timer from its current elapsed time."""
    def LoadAsset_Blocking(self, Asset: str | UObject | Future[str] | Future[UObject]) -> Future[UObject]:
        """Resolves or loads a soft object reference immediately."""
    def MakeLiteralBool(self, Value: bool | Future[bool]) -> Future[bool]:
        """Creates a literal: returns the value."""
    def MakeLiteralByte(self, Value: int | Future[int]) -> Future[int]:
        """Creates a literal: returns the value."""
    def MakeLiteralDouble(self, Value: float | Future[float]) -> Future[float]:
        """Creates a literal: returns the value."""
    def MakeLiteralFloat(self, Value: float | Future[float]) -> Future[float]:
        """Creates a literal: returns the value."""
    def MakeLiteralInt(self, Value: int | Future[int]) -> Future[int]:
        """Creates a literal: returns the value."""
    def MakeLiteralInt64(self, Value: int | Future[int]) -> Future[int]:
        """Creates a literal: returns the value."""
    def MakeLiteralName(self, Value: str | Future[str]) -> Future[str]:
        """Creates a literal: returns the value."""
    def MakeLiteralString(self, Value: str | Future[str]) -> Future[str]:
        """Creates a literal: returns the value."""
    def MakeLiteralText(self, Value: str | Future[str]) -> Future[str]:
        """Creates a literal: returns the value."""
    def MakeSoftObjectPath(self, PathString: str | Future[str]) -> Future[FSoftObjectPath]:
        """Builds a soft object path from a string that contains a full path."""
    def MoveComponentTo(self, TargetRelativeLocation: FVector_in, TargetRelativeRotation: FRotator_in, bEaseOut: bool | Future[bool], bEaseIn: bool | Future[bool], OverTime: float | Future[float], bForceShortestRotationPath: bool | Future[bool], MoveAction: EMoveComponentAction_in, *, Component: USceneComponent | Future[USceneComponent] = ...) -> Future[None]:
        """Interpolates a component to the specified relative location and rotation over a time (seconds)."""
    def ParseParam(self, InString: str | Future[str], InParam: str | Future[str]) -> Future[bool]:
        """Returns whether a string has a -parameter."""
    def ParseParamValue(self, InString: str | Future[str], InParam: str | Future[str]) -> Future[UKismetSystemLibrary_ParseParamValue_Result]:
        """Returns "value" if a string has "param=value"."""
    def PrintString(self, InString: str | Future[str] = "Hello", bPrintToScreen: bool | Future[bool] = True, bPrintToLog: bool | Future[bool] = True, TextColor: FLinearColor_in = ..., Duration: float | Future[float] = 2.0, Key: str | Future[str] = "None", *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[None]:
        """Prints a string to the log, and optionally to the list of messages on the screen."""
    def PrintText(self, InText: str | Future[str], bPrintToScreen: bool | Future[bool] = True, bPrintToLog: bool | Future[bool] = True, TextColor: FLinearColor_in = ..., Duration: float | Future[float] = 2.0, Key: str | Future[str] = "None", *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[None]:
        """Prints text to the log, and optionally to the list of messages on the screen."""
    def PrintWarning(self, InString: str | Future[str]) -> Future[None]:
        """Prints a warning string to the log."""
    def QuitGame(self, SpecificPlayer: APlayerController | Future[APlayerController], QuitPreference: EQuitPreference_in, bIgnorePlatformRestrictions: bool | Future[bool], *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[None]:
        """Exits the current game at the end of the frame."""
    def RetriggerableDelay(self, Duration: float | Future[float], *, WorldContextObject: UObject | Future[UObject] = ...) -> Future[None]:
        """Performs a latent action with a retriggerable delay (specified in seconds)."""
    def SetBoolPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: bool | Future[bool]) -> Future[None]:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetBytePropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: int | Future[int]) -> Future[None]:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetClassPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: type[UObject] | UClass | str | Future[UClass]) -> Future[None]:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetDoublePropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: float | Future[float]) -> Future[None]:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetInt64PropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: int | Future[int]) -> Future[None]:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetIntPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: int | Future[int]) -> Future[None]:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetLinearColorPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: FLinearColor_in) -> Future[None]:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetNamePropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: str | Future[str]) -> Future[None]:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetObjectPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: UObject | Future[UObject]) -> Future[None]:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetRotatorPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: FRotator_in) -> Future[None]:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetStringPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: str | Future[str]) -> Future[None]:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetTransformPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: FTransform_in) -> Future[None]:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetVectorPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: FVector_in) -> Future[None]:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""

class UKismetSystemLibrary_send(UBlueprintFunctionLibrary_send):
    """UKismetSystemLibrary under ``send_``: no function answers."""
    def BreakSoftObjectPath(self, InSoftObjectPath: FSoftObjectPath_in) -> None:
        """Gets the path string out of a soft object path."""
    def CollectGarbage(self) -> None:
        """Deletes all unreferenced objects, keeping only referenced objects (this command will be queued and happen at the end of the frame)."""
    def Conv_ObjectToClass(self, Object: UObject | Future[UObject], Class: type[UObject] | UClass | str | Future[UClass]) -> None:
        """Casts from an object to a class; null when it is no class or not derived from the wanted one."""
    def Conv_ObjectToSoftObjectReference(self, Object: UObject | Future[UObject]) -> None:
        """Converts an object to a soft reference to it."""
    def Conv_SoftObjectReferenceToObject(self, SoftObject: str | UObject | Future[str] | Future[UObject]) -> None:
        """Resolves a soft reference to an object that is loaded; null if it is not."""
    def Conv_SoftObjectReferenceToString(self, SoftObjectReference: str | UObject | Future[str] | Future[UObject]) -> None:
        """Converts a soft object reference to its path."""
    def Delay(self, Duration: float | Future[float], *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Performs a latent action with a delay (specified in seconds)."""
    def DelayUntilNextTick(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Performs a latent action with a delay of one tick."""
    def DoesClassImplementInterface(self, TestClass: type[UObject] | UClass | str | Future[UClass], Interface: type[UInterface] | UClass | str | Future[UClass]) -> None:
        """Determines if the passed class implements the supplied interface."""
    def DoesImplementInterface(self, TestObject: UObject | Future[UObject], Interface: type[UInterface] | UClass | str | Future[UClass]) -> None:
        """Determines if the passed object implements the supplied interface."""
    def EqualEqual_SoftObjectReference(self, A: str | UObject | Future[str] | Future[UObject], B: str | UObject | Future[str] | Future[UObject]) -> None:
        """Returns true if the soft object references are equal (A == B)."""
    def ExecuteConsoleCommand(self, Command: str | Future[str], SpecificPlayer: APlayerController | Future[APlayerController] | None = None, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Executes a console command, optionally on a specific player controller."""
    def GetActorListFromComponentList(self, ComponentList: Sequence[UPrimitiveComponent | Future[UPrimitiveComponent] | None] | Future[list[UPrimitiveComponent | None]], ActorClassFilter: type[UObject] | UClass | str | Future[UClass]) -> None:
        """Returns the distinct owners of a list of components, optionally only those of a class."""
    def GetBuildConfiguration(self) -> None:
        """Returns the build configuration."""
    def GetClassDisplayName(self, Class: type[UObject] | UClass | str | Future[UClass]) -> None:
        """Returns the display name of a class; an empty string for null."""
    def GetCommandLine(self) -> None:
        """Returns the command line the process was launched with."""
    def GetComponentBounds(self, Component: USceneComponent | Future[USceneComponent]) -> None:
        """Gets the bounds of a component in world space, in centimetres; zero for null."""
    def GetConsoleVariableBoolValue(self, VariableName: str | Future[str]) -> None:
        """Gets whether a console variable has a non-zero value; false with a warning in the log if there is none."""
    def GetConsoleVariableFloatValue(self, VariableName: str | Future[str]) -> None:
        """Gets the value of a console variable as a float; 0 with a warning in the log if there is none."""
    def GetConsoleVariableIntValue(self, VariableName: str | Future[str]) -> None:
        """Gets the value of a console variable as an integer; 0 with a warning in the log if there is none."""
    def GetConsoleVariableStringValue(self, VariableName: str | Future[str]) -> None:
        """Gets the value of a console variable as text; an empty string with a warning in the log if there is none."""
    def GetDisplayName(self, Object: UObject | Future[UObject]) -> None:
        """Returns the display name (or actor label), for displaying."""
    def GetEngineVersion(self) -> None:
        """Returns the version of the engine."""
    def GetFrameCount(self) -> None:
        """Returns the number of the current frame."""
    def GetGameName(self) -> None:
        """Returns the name of the current project."""
    def GetGameTimeInSeconds(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Gets the current game time, in seconds."""
    def GetObjectName(self, Object: UObject | Future[UObject]) -> None:
        """Returns the actual object name; "None" for null."""
    def GetOuterObject(self, Object: UObject | Future[UObject]) -> None:
        """Returns the outer object of an object."""
    def GetPathName(self, Object: UObject | Future[UObject]) -> None:
        """Returns the full path to the specified object; "None" for null."""
    def GetPlatformUserName(self) -> None:
        """Returns the name of the user who runs the process."""
    def GetProjectContentDirectory(self) -> None:
        """Returns the content directory of the current project."""
    def GetProjectDirectory(self) -> None:
        """Returns the directory of the current project."""
    def GetProjectSavedDirectory(self) -> None:
        """Returns the saved directory of the current project."""
    def IsDedicatedServer(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns whether this is running on a dedicated server."""
    def IsServer(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns whether this process is (also) the server."""
    def IsStandalone(self, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns whether this game instance is stand-alone (no networking)."""
    def IsValid(self, Object: UObject | Future[UObject]) -> None:
        """Returns true if the object is usable: non-null and not pending destruction."""
    def IsValidClass(self, Class: type[UObject] | UClass | str | Future[UClass]) -> None:
        """Returns true if the class is usable: non-null and not pending destruction."""
    def IsValidSoftObjectReference(self, SoftObjectReference: str | UObject | Future[str] | Future[UObject]) -> None:
        """Returns true if the soft object reference is not null."""
    def K2_ClearAndInvalidateTimerHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Clears the timer and invalidates the handle."""
    def K2_ClearTimer(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> None:
        """Clears a set timer."""
    def K2_GetTimerElapsedTimeHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns elapsed time for the given handle (time since current countdown iteration began), in seconds; 0 if there is no such timer."""
    def K2_GetTimerRemainingTimeHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns time until the timer will next execute its function, in seconds; 0 if there is no such timer."""
    def K2_InvalidateTimerHandle(self, Handle: FTimerHandle_in) -> None:
        """Invalidates the supplied timer handle and returns it."""
    def K2_IsTimerActive(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> None:
        """Returns true if a timer exists and is active for the given function, false otherwise."""
    def K2_IsTimerActiveHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Returns true if a timer exists and is active for the given handle, false otherwise."""
    def K2_IsValidTimerHandle(self, Handle: FTimerHandle_in) -> None:
        """Returns whether the timer handle is valid."""
    def K2_PauseTimer(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> None:
        """Pauses a set timer at its current elapsed time."""
    def K2_PauseTimerHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Pauses a timer at its current elapsed time."""
    def K2_SetTimer(self, Object: UObject | Future[UObject], FunctionName: str | Future[str], Time: float | Future[float], bLooping: bool | Future[bool], bMaxOncePerFrame: bool | Future[bool] = False, InitialStartDelay: float | Future[float] = 0.0, InitialStartDelayVariance: float | Future[float] = 0.0) -> None:
        """Sets a timer to execute a function of an object."""
    def K2_SetTimerDelegate(self, Delegate: FScriptDelegate_in | None, Time: float | Future[float], bLooping: bool | Future[bool], bMaxOncePerFrame: bool | Future[bool] = False, InitialStartDelay: float | Future[float] = 0.0, InitialStartDelayVariance: float | Future[float] = 0.0) -> None:
        """Sets a timer to execute a delegate."""
    def K2_SetTimerForNextTick(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> None:
        """Sets a timer to execute a function of an object on the next tick."""
    def K2_TimerExists(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> None:
        """Returns true if a timer exists for the given function, false otherwise."""
    def K2_UnPauseTimer(self, Object: UObject | Future[UObject], FunctionName: str | Future[str]) -> None:
        """Resumes a paused timer from its current elapsed time."""
    def K2_UnPauseTimerHandle(self, Handle: FTimerHandle_in, *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Resumes a paused timer from its current elapsed time."""
    def LoadAsset_Blocking(self, Asset: str | UObject | Future[str] | Future[UObject]) -> None:
        """Resolves or loads a soft object reference immediately."""
    def MakeLiteralBool(self, Value: bool | Future[bool]) -> None:
        """Creates a literal: returns the value."""
    def MakeLiteralByte(self, Value: int | Future[int]) -> None:
        """Creates a literal: returns the value."""
    def MakeLiteralDouble(self, Value: float | Future[float]) -> None:
        """Creates a literal: returns the value."""
    def MakeLiteralFloat(self, Value: float | Future[float]) -> None:
        """Creates a literal: returns the value."""
    def MakeLiteralInt(self, Value: int | Future[int]) -> None:
        """Creates a literal: returns the value."""
    def MakeLiteralInt64(self, Value: int | Future[int]) -> None:
        """Creates a literal: returns the value."""
    def MakeLiteralName(self, Value: str | Future[str]) -> None:
        """Creates a literal: returns the value."""
    def MakeLiteralString(self, Value: str | Future[str]) -> None:
        """Creates a literal: returns the value."""
    def MakeLiteralText(self, Value: str | Future[str]) -> None:
        """Creates a literal: returns the value."""
    def MakeSoftObjectPath(self, PathString: str | Future[str]) -> None:
        """Builds a soft object path from a string that contains a full path."""
    def MoveComponentTo(self, TargetRelativeLocation: FVector_in, TargetRelativeRotation: FRotator_in, bEaseOut: bool | Future[bool], bEaseIn: bool | Future[bool], OverTime: float | Future[float], bForceShortestRotationPath: bool | Future[bool], MoveAction: EMoveComponentAction_in, *, Component: USceneComponent | Future[USceneComponent] = ...) -> None:
        """Interpolates a component to the specified relative location and rotation over a time (seconds)."""
    def ParseParam(self, InString: str | Future[str], InParam: str | Future[str]) -> None:
        """Returns whether a string has a -parameter."""
    def ParseParamValue(self, InString: str | Future[str], InParam: str | Future[str]) -> None:
        """Returns "value" if a string has "param=value"."""
    def PrintString(self, InString: str | Future[str] = "Hello", bPrintToScreen: bool | Future[bool] = True, bPrintToLog: bool | Future[bool] = True, TextColor: FLinearColor_in = ..., Duration: float | Future[float] = 2.0, Key: str | Future[str] = "None", *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Prints a string to the log, and optionally to the list of messages on the screen."""
    def PrintText(self, InText: str | Future[str], bPrintToScreen: bool | Future[bool] = True, bPrintToLog: bool | Future[bool] = True, TextColor: FLinearColor_in = ..., Duration: float | Future[float] = 2.0, Key: str | Future[str] = "None", *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Prints text to the log, and optionally to the list of messages on the screen."""
    def PrintWarning(self, InString: str | Future[str]) -> None:
        """Prints a warning string to the log."""
    def QuitGame(self, SpecificPlayer: APlayerController | Future[APlayerController], QuitPreference: EQuitPreference_in, bIgnorePlatformRestrictions: bool | Future[bool], *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Exits the current game at the end of the frame."""
    def RetriggerableDelay(self, Duration: float | Future[float], *, WorldContextObject: UObject | Future[UObject] = ...) -> None:
        """Performs a latent action with a retriggerable delay (specified in seconds)."""
    def SetBoolPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: bool | Future[bool]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetBytePropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: int | Future[int]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetClassPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: type[UObject] | UClass | str | Future[UClass]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetDoublePropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: float | Future[float]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetInt64PropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: int | Future[int]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetIntPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: int | Future[int]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetLinearColorPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: FLinearColor_in) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetNamePropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: str | Future[str]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetObjectPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: UObject | Future[UObject]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetRotatorPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: FRotator_in) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetStringPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: str | Future[str]) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetTransformPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: FTransform_in) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""
    def SetVectorPropertyByName(self, Object: UObject | Future[UObject], PropertyName: str | Future[str], Value: FVector_in) -> None:
        """Sets a property of an object by its name; a property that is not there or has another type stays as it is, with a warning in the log."""

class UKismetSystemLibrary(UKismetSystemLibrary_members, UBlueprintFunctionLibrary):
    """General services for scripts and remote programs: objects, console, printing, delays and timers. Epic page:
    UKismetSystemLibrary.

    Unreal: /Script/Engine.KismetSystemLibrary
    """
    @property
    def async_(self) -> UKismetSystemLibrary_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UKismetSystemLibrary_send:
        """The same functions and variables, fire-and-forget."""

class UKismetSystemLibrary_path(ObjectPath[UKismetSystemLibrary, UKismetSystemLibrary_async_path, UKismetSystemLibrary_send], UKismetSystemLibrary_members):
    """A variable that refers to an object of UKismetSystemLibrary: its path."""

class UKismetSystemLibrary_async_path(AsyncObjectPath[UKismetSystemLibrary], UKismetSystemLibrary_async):
    """The same under ``async_``."""
