# generated, do not edit (Engine: Public/GameFramework/Controller.h)
from collections.abc import Sequence
from typing import NamedTuple, TypeAlias
from spear.typing import (
    AsyncObjectPath, AsyncStrProperty, AsyncValuePath, Future, ObjectPath, Property, SendProperty, SendStrProperty, StrProperty, ValuePath,
)
from ..CoreUObject._Intrinsic import FScriptDelegate, FScriptDelegate_in
from ..CoreUObject._NoExportTypes import FRotator, FRotator_async, FRotator_in, FRotator_path, FVector, FVector_in
from ._Actor import AActor, AActor_async, AActor_members, AActor_send
from ._Pawn import APawn, APawn_async_path, APawn_path
from ._PlayerState import APlayerState, APlayerState_async_path, APlayerState_path

FOnPossessedPawnChanged: TypeAlias = list[FScriptDelegate]
"""Called as FOnPossessedPawnChanged(OldPawn: APawn, NewPawn: APawn); a value tells what is bound.

Unreal: /Script/Engine.OnPossessedPawnChanged__DelegateSignature
"""

class AController_GetPlayerViewPoint_Result(NamedTuple):
    """Results of AController.GetPlayerViewPoint."""
    Location: FVector
    Rotation: FRotator

class AController_members(AActor_members):
    """Functions and variables of AController."""
    def GetControlRotation(self) -> FRotator:
        """Returns the current control rotation, in degrees.

        Unreal: AController.GetControlRotation
        """
    def GetDesiredRotation(self) -> FRotator:
        """Returns the rotation that the pawn should aim at: the control rotation.

        Unreal: AController.GetDesiredRotation
        """
    def GetPlayerViewPoint(self) -> AController_GetPlayerViewPoint_Result:
        """Returns Player's Point of View. For the AI this means the Pawn's 'Eyes' ViewPoint, for a Human player, this
        means the Camera's ViewPoint.

        Unreal: AController.GetPlayerViewPoint
        """
    def GetViewTarget(self) -> AActor:
        """Get the actor the controller is looking at: the pawn.

        Unreal: AController.GetViewTarget
        """
    def IsLocalController(self) -> bool:
        """Returns whether this Controller is a local controller.

        Unreal: AController.IsLocalController
        """
    def IsLocalPlayerController(self) -> bool:
        """Returns whether this Controller is a locally controlled controller.

        Unreal: AController.IsLocalPlayerController
        """
    def IsLookInputIgnored(self) -> bool:
        """Returns true if look input is ignored.

        Unreal: AController.IsLookInputIgnored
        """
    def IsMoveInputIgnored(self) -> bool:
        """Returns true if movement input is ignored.

        Unreal: AController.IsMoveInputIgnored
        """
    def IsPlayerController(self) -> bool:
        """Returns whether this Controller is a PlayerController.

        Unreal: AController.IsPlayerController
        """
    def K2_GetPawn(self) -> APawn | None:
        """Return the Pawn that is currently 'controlled' by this PlayerController.

        Unreal: AController.K2_GetPawn
        """
    def Possess(self, InPawn: APawn | Future[APawn]) -> None:
        """Handles attaching this controller to the specified pawn. Only runs on the network authority (where
        HasAuthority() returns true). Derived native classes can override OnPossess.

        Args:
            InPawn: the Pawn to be possessed.

        Unreal: AController.Possess
        """
    def ReceivePossess(self, PossessedPawn: APawn | Future[APawn]) -> None:
        """Blueprint implementable event to react to the controller possessing a pawn.

        Unreal: AController.ReceivePossess
        """
    def ReceiveUnPossess(self, UnpossessedPawn: APawn | Future[APawn]) -> None:
        """Blueprint implementable event to react to the controller unpossessing a pawn.

        Unreal: AController.ReceiveUnPossess
        """
    def ResetIgnoreInputFlags(self) -> None:
        """Stop ignoring both.

        Unreal: AController.ResetIgnoreInputFlags
        """
    def ResetIgnoreLookInput(self) -> None:
        """Stops ignoring look input by resetting the ignore look input state.

        Unreal: AController.ResetIgnoreLookInput
        """
    def ResetIgnoreMoveInput(self) -> None:
        """Stops ignoring move input by resetting the ignore move input state.

        Unreal: AController.ResetIgnoreMoveInput
        """
    def SetControlRotation(self, NewRotation: FRotator_in) -> None:
        """Set the control rotation.

        Unreal: AController.SetControlRotation
        """
    def SetIgnoreLookInput(self, bNewLookInput: bool | Future[bool]) -> None:
        """Locks or unlocks look input, consecutive calls stack up and require the same amount of calls to undo, or can
        all be undone using ResetIgnoreLookInput.

        Unreal: AController.SetIgnoreLookInput
        """
    def SetIgnoreMoveInput(self, bNewMoveInput: bool | Future[bool]) -> None:
        """Locks or unlocks movement input, consecutive calls stack up and require the same amount of calls to undo, or
        can all be undone using ResetIgnoreMoveInput.

        Unreal: AController.SetIgnoreMoveInput
        """
    def SetInitialLocationAndRotation(self, NewLocation: FVector_in, NewRotation: FRotator_in) -> None:
        """Set the initial location and rotation of the controller, as well as the control rotation. Typically used when
        the controller is first created.

        Unreal: AController.SetInitialLocationAndRotation
        """
    def StopMovement(self) -> None:
        """Aborts the move the controller is currently performing: zeroes the velocity of the pawn's root.

        Unreal: AController.StopMovement
        """
    def UnPossess(self) -> None:
        """Called to unpossess our pawn for any reason that is not the pawn being destroyed (destruction handled by
        PawnDestroyed()).

        Unreal: AController.UnPossess
        """
    PlayerState: Property[APlayerState_path, APlayerState | Future[APlayerState] | None]
    """PlayerState containing replicated information about the player using this controller (only exists for players,
    not NPCs).

    Unreal: AController.PlayerState (APlayerState*)
    """
    OnPossessedPawnChanged: Property[ValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called on both authority and clients when the possessed pawn changes (either OldPawn or NewPawn might be
    nullptr).

    Delegate: FOnPossessedPawnChanged(OldPawn: APawn, NewPawn: APawn)

    Unreal: AController.OnPossessedPawnChanged (FOnPossessedPawnChanged)
    """
    StateName: StrProperty
    """Current gameplay state this controller is in.

    Unreal: AController.StateName (FName)
    """
    ControlRotation: Property[FRotator_path, FRotator_in]
    """The control rotation of the Controller. See GetControlRotation.

    Unreal: AController.ControlRotation (FRotator)
    """
    Pawn: Property[APawn_path, APawn | Future[APawn] | None]
    """Pawn currently being controlled by this controller. Use Pawn.Possess() to take control of a pawn.

    Unreal: AController.Pawn (APawn*)
    """

class AController_async(AActor_async):
    """AController under ``async_``: each function gives a future."""
    def GetControlRotation(self) -> Future[FRotator]:
        """Returns the current control rotation, in degrees."""
    def GetDesiredRotation(self) -> Future[FRotator]:
        """Returns the rotation that the pawn should aim at: the control rotation."""
    def GetPlayerViewPoint(self) -> Future[AController_GetPlayerViewPoint_Result]:
        """Returns Player's Point of View."""
    def GetViewTarget(self) -> Future[AActor]:
        """Get the actor the controller is looking at: the pawn."""
    def IsLocalController(self) -> Future[bool]:
        """Returns whether this Controller is a local controller."""
    def IsLocalPlayerController(self) -> Future[bool]:
        """Returns whether this Controller is a locally controlled controller."""
    def IsLookInputIgnored(self) -> Future[bool]:
        """Returns true if look input is ignored."""
    def IsMoveInputIgnored(self) -> Future[bool]:
        """Returns true if movement input is ignored."""
    def IsPlayerController(self) -> Future[bool]:
        """Returns whether this Controller is a PlayerController."""
    def K2_GetPawn(self) -> Future[APawn | None]:
        """Return the Pawn that is currently 'controlled' by this PlayerController."""
    def Possess(self, InPawn: APawn | Future[APawn]) -> Future[None]:
        """Handles attaching this controller to the specified pawn."""
    def ReceivePossess(self, PossessedPawn: APawn | Future[APawn]) -> Future[None]:
        """Blueprint implementable event to react to the controller possessing a pawn."""
    def ReceiveUnPossess(self, UnpossessedPawn: APawn | Future[APawn]) -> Future[None]:
        """Blueprint implementable event to react to the controller unpossessing a pawn."""
    def ResetIgnoreInputFlags(self) -> Future[None]:
        """Stop ignoring both."""
    def ResetIgnoreLookInput(self) -> Future[None]:
        """Stops ignoring look input by resetting the ignore look input state."""
    def ResetIgnoreMoveInput(self) -> Future[None]:
        """Stops ignoring move input by resetting the ignore move input state."""
    def SetControlRotation(self, NewRotation: FRotator_in) -> Future[None]:
        """Set the control rotation."""
    def SetIgnoreLookInput(self, bNewLookInput: bool | Future[bool]) -> Future[None]:
        """Locks or unlocks look input, consecutive calls stack up and require the same amount of calls to undo, or can all be undone using ResetIgnoreLookInput."""
    def SetIgnoreMoveInput(self, bNewMoveInput: bool | Future[bool]) -> Future[None]:
        """Locks or unlocks movement input, consecutive calls stack up and require the same amount of calls to undo, or can all be undone using ResetIgnoreMoveInput."""
    def SetInitialLocationAndRotation(self, NewLocation: FVector_in, NewRotation: FRotator_in) -> Future[None]:
        """Set the initial location and rotation of the controller, as well as the control rotation."""
    def StopMovement(self) -> Future[None]:
        """Aborts the move the controller is currently performing: zeroes the velocity of the pawn's root."""
    def UnPossess(self) -> Future[None]:
        """Called to unpossess our pawn for any reason that is not the pawn being destroyed (destruction handled by PawnDestroyed())."""
    PlayerState: Property[APlayerState_async_path, APlayerState | Future[APlayerState] | None]
    """PlayerState containing replicated information about the player using this controller (only exists for players, not NPCs)."""
    OnPossessedPawnChanged: Property[AsyncValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Called on both authority and clients when the possessed pawn changes (either OldPawn or NewPawn might be nullptr)."""
    StateName: AsyncStrProperty
    """Current gameplay state this controller is in."""
    ControlRotation: Property[FRotator_async, FRotator_in]
    """The control rotation of the Controller."""
    Pawn: Property[APawn_async_path, APawn | Future[APawn] | None]
    """Pawn currently being controlled by this controller."""

class AController_send(AActor_send):
    """AController under ``send_``: no function answers."""
    def GetControlRotation(self) -> None:
        """Returns the current control rotation, in degrees."""
    def GetDesiredRotation(self) -> None:
        """Returns the rotation that the pawn should aim at: the control rotation."""
    def GetPlayerViewPoint(self) -> None:
        """Returns Player's Point of View."""
    def GetViewTarget(self) -> None:
        """Get the actor the controller is looking at: the pawn."""
    def IsLocalController(self) -> None:
        """Returns whether this Controller is a local controller."""
    def IsLocalPlayerController(self) -> None:
        """Returns whether this Controller is a locally controlled controller."""
    def IsLookInputIgnored(self) -> None:
        """Returns true if look input is ignored."""
    def IsMoveInputIgnored(self) -> None:
        """Returns true if movement input is ignored."""
    def IsPlayerController(self) -> None:
        """Returns whether this Controller is a PlayerController."""
    def K2_GetPawn(self) -> None:
        """Return the Pawn that is currently 'controlled' by this PlayerController."""
    def Possess(self, InPawn: APawn | Future[APawn]) -> None:
        """Handles attaching this controller to the specified pawn."""
    def ReceivePossess(self, PossessedPawn: APawn | Future[APawn]) -> None:
        """Blueprint implementable event to react to the controller possessing a pawn."""
    def ReceiveUnPossess(self, UnpossessedPawn: APawn | Future[APawn]) -> None:
        """Blueprint implementable event to react to the controller unpossessing a pawn."""
    def ResetIgnoreInputFlags(self) -> None:
        """Stop ignoring both."""
    def ResetIgnoreLookInput(self) -> None:
        """Stops ignoring look input by resetting the ignore look input state."""
    def ResetIgnoreMoveInput(self) -> None:
        """Stops ignoring move input by resetting the ignore move input state."""
    def SetControlRotation(self, NewRotation: FRotator_in) -> None:
        """Set the control rotation."""
    def SetIgnoreLookInput(self, bNewLookInput: bool | Future[bool]) -> None:
        """Locks or unlocks look input, consecutive calls stack up and require the same amount of calls to undo, or can all be undone using ResetIgnoreLookInput."""
    def SetIgnoreMoveInput(self, bNewMoveInput: bool | Future[bool]) -> None:
        """Locks or unlocks movement input, consecutive calls stack up and require the same amount of calls to undo, or can all be undone using ResetIgnoreMoveInput."""
    def SetInitialLocationAndRotation(self, NewLocation: FVector_in, NewRotation: FRotator_in) -> None:
        """Set the initial location and rotation of the controller, as well as the control rotation."""
    def StopMovement(self) -> None:
        """Aborts the move the controller is currently performing: zeroes the velocity of the pawn's root."""
    def UnPossess(self) -> None:
        """Called to unpossess our pawn for any reason that is not the pawn being destroyed (destruction handled by PawnDestroyed())."""
    PlayerState: SendProperty[APlayerState | Future[APlayerState] | None]
    OnPossessedPawnChanged: SendProperty[Sequence[FScriptDelegate_in] | None]
    StateName: SendStrProperty
    ControlRotation: SendProperty[FRotator_in]
    Pawn: SendProperty[APawn | Future[APawn] | None]

class AController(AController_members, AActor):
    """Controllers are non-physical actors that can possess a Pawn to control its actions. PlayerControllers are used
    by human players to control pawns.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/AController

    Unreal: /Script/Engine.Controller
    """
    @property
    def async_(self) -> AController_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> AController_send:
        """The same functions and variables, fire-and-forget."""

class AController_path(ObjectPath[AController, AController_async_path, AController_send], AController_members):
    """A variable that refers to an object of AController: its path."""

class AController_async_path(AsyncObjectPath[AController], AController_async):
    """The same under ``async_``."""
