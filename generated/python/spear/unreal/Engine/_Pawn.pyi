# generated, do not edit (Engine: Public/GameFramework/Pawn.h)
from collections.abc import Sequence
from typing import TypeAlias
from spear.typing import (
    AsyncBoolProperty, AsyncFloatProperty, AsyncObjectPath, AsyncValuePath, BoolProperty, FloatProperty, Future, ObjectPath, Property,
    SendBoolProperty, SendFloatProperty, SendProperty, ValuePath,
)
from ..CoreUObject._Intrinsic import FScriptDelegate, FScriptDelegate_in
from ..CoreUObject._NoExportTypes import FRotator, FVector, FVector_async, FVector_in, FVector_path
from ._Actor import AActor, AActor_async, AActor_members, AActor_send
from ._Controller import AController, AController_async_path, AController_path
from ._EngineTypes import EAutoReceiveInput, EAutoReceiveInput_in
from ._PawnMovementComponent import UPawnMovementComponent
from ._PlayerController import APlayerController
from ._PlayerState import APlayerState, APlayerState_async_path, APlayerState_path

FPawnControllerChangedSignature: TypeAlias = list[FScriptDelegate]
"""Called as FPawnControllerChangedSignature(Pawn: APawn, OldController: AController, NewController: AController); a value tells what is bound.

Unreal: /Script/Engine.PawnControllerChangedSignature__DelegateSignature
"""

class APawn_members(AActor_members):
    """Functions and variables of APawn."""
    def AddControllerPitchInput(self, Val: float | Future[float]) -> None:
        """Add input (affecting Pitch) to the Controller's ControlRotation, if it is a local PlayerController. Degrees.

        Unreal: APawn.AddControllerPitchInput
        """
    def AddControllerRollInput(self, Val: float | Future[float]) -> None:
        """Add input (affecting Roll) to the Controller's ControlRotation, if it is a local PlayerController. Degrees.

        Unreal: APawn.AddControllerRollInput
        """
    def AddControllerYawInput(self, Val: float | Future[float]) -> None:
        """Add input (affecting Yaw) to the Controller's ControlRotation, if it is a local PlayerController. Degrees.

        Unreal: APawn.AddControllerYawInput
        """
    def AddMovementInput(self, WorldDirection: FVector_in, ScaleValue: float | Future[float] = 1.0, bForce: bool | Future[bool] = False) -> None:
        """Add movement input along the given world direction vector (usually normalized) scaled by 'ScaleValue'. If
        ScaleValue < 0, movement will be in the opposite direction. Base Pawn classes won't automatically apply
        movement, it's up to the user to do so in a Tick event (or a movement component consumes it).

        Args:
            WorldDirection: direction in world space to apply input.
            ScaleValue: scale to apply to input. This can be used for analog input, ie a value of 0.5 applies half the normal value, while -1.0 would reverse the direction.
            bForce: if true always add the input, ignoring the result of IsMoveInputIgnored().

        Unreal: APawn.AddMovementInput
        """
    def ConsumeMovementInputVector(self) -> FVector:
        """Returns the pending input vector and resets it to zero.

        Unreal: APawn.ConsumeMovementInputVector
        """
    def DetachFromControllerPendingDestroy(self) -> None:
        """Call this function to detach safely pawn from its controller, knowing that we will be destroyed soon.

        Unreal: APawn.DetachFromControllerPendingDestroy
        """
    def GetBaseAimRotation(self) -> FRotator:
        """Return our base aim rotation: that of the view.

        Unreal: APawn.GetBaseAimRotation
        """
    def GetControlRotation(self) -> FRotator:
        """Get the rotation of the Controller, often the 'view' rotation of this Pawn.

        Unreal: APawn.GetControlRotation
        """
    def GetController(self) -> AController | None:
        """Returns controller for this actor.

        Unreal: APawn.GetController
        """
    def GetLastMovementInputVector(self) -> FVector:
        """Return the last input vector in world space that was processed by ConsumeMovementInputVector().

        Unreal: APawn.GetLastMovementInputVector
        """
    def GetLocalViewingPlayerController(self) -> APlayerController:
        """Returns local Player Controller viewing this pawn, whether it is possessing or spectating the pawn.

        Unreal: APawn.GetLocalViewingPlayerController
        """
    def GetMovementComponent(self) -> UPawnMovementComponent:
        """Return our PawnMovementComponent, if we have one.

        Unreal: APawn.GetMovementComponent
        """
    def GetPendingMovementInputVector(self) -> FVector:
        """Return the pending input vector in world space. This is the most up-to-date value before it is consumed by a
        movement component.

        Unreal: APawn.GetPendingMovementInputVector
        """
    def IsLocallyControlled(self) -> bool:
        """Returns true if controlled by a local (not network) Controller.

        Unreal: APawn.IsLocallyControlled
        """
    def IsMoveInputIgnored(self) -> bool:
        """Helper to see if move input is ignored. If our controller is a PlayerController, checks
        Controller->IsMoveInputIgnored().

        Unreal: APawn.IsMoveInputIgnored
        """
    def IsPawnControlled(self) -> bool:
        """Check if this actor is currently being controlled at all (the actor has a valid Controller).

        Unreal: APawn.IsPawnControlled
        """
    def IsPlayerControlled(self) -> bool:
        """Returns true if controlled by a human player (possessed by a PlayerController).

        Unreal: APawn.IsPlayerControlled
        """
    def ReceiveControllerChanged(self, OldController: AController | Future[AController], NewController: AController | Future[AController]) -> None:
        """Event called after a pawn's controller has changed, on the server and owning client.

        Unreal: APawn.ReceiveControllerChanged
        """
    def ReceivePossessed(self, NewController: AController | Future[AController]) -> None:
        """Event called when the Pawn is possessed by a Controller. Only called on the server (or in standalone).

        Unreal: APawn.ReceivePossessed
        """
    def ReceiveUnpossessed(self, OldController: AController | Future[AController]) -> None:
        """Event called when the Pawn is no longer possessed by a Controller. Only called on the server (or in
        standalone).

        Unreal: APawn.ReceiveUnpossessed
        """
    bUseControllerRotationPitch: BoolProperty
    """If true, this Pawn's pitch will be updated to match the Controller's ControlRotation pitch, if controlled by a
    PlayerController.

    Unreal: APawn.bUseControllerRotationPitch (bool)
    """
    bUseControllerRotationYaw: BoolProperty
    """If true, this Pawn's yaw will be updated to match the Controller's ControlRotation yaw, if controlled by a
    PlayerController.

    Unreal: APawn.bUseControllerRotationYaw (bool)
    """
    bUseControllerRotationRoll: BoolProperty
    """If true, this Pawn's roll will be updated to match the Controller's ControlRotation roll, if controlled by a
    PlayerController.

    Unreal: APawn.bUseControllerRotationRoll (bool)
    """
    BaseEyeHeight: FloatProperty
    """Base eye height above collision center, in centimetres.

    Unreal: APawn.BaseEyeHeight (float)
    """
    AutoPossessPlayer: Property[ValuePath[EAutoReceiveInput, EAutoReceiveInput_in], EAutoReceiveInput_in]
    """Determines which PlayerController, if any, should automatically possess the pawn when the level starts or when
    the pawn is spawned.

    Unreal: APawn.AutoPossessPlayer (TEnumAsByte<EAutoReceiveInput::Type>)
    """
    PlayerState: Property[APlayerState_path, APlayerState | Future[APlayerState] | None]
    """If Pawn is possessed by a player, points to its PlayerState.

    Unreal: APawn.PlayerState (APlayerState*)
    """
    Controller: Property[AController_path, AController | Future[AController] | None]
    """Controller currently possessing this Actor.

    Unreal: APawn.Controller (AController*)
    """
    PreviousController: Property[AController_path, AController | Future[AController] | None]
    """Previous controller that was controlling this pawn since the last controller change notification.

    Unreal: APawn.PreviousController (AController*)
    """
    ReceiveControllerChangedDelegate: Property[ValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Event called after a pawn's controller has changed, on the server and owning client. This will happen at the
    same time as the delegate on GameInstance.

    Delegate: FPawnControllerChangedSignature(Pawn: APawn, OldController: AController, NewController: AController)

    Unreal: APawn.ReceiveControllerChangedDelegate (FPawnControllerChangedSignature)
    """
    ControlInputVector: Property[FVector_path, FVector_in]
    """Accumulated control input vector, stored in world space. This is the pending input, which is cleared (zeroed)
    once consumed.

    Unreal: APawn.ControlInputVector (FVector)
    """
    LastControlInputVector: Property[FVector_path, FVector_in]
    """The last control input vector that was processed by ConsumeMovementInputVector().

    Unreal: APawn.LastControlInputVector (FVector)
    """

class APawn_async(AActor_async):
    """APawn under ``async_``: each function gives a future."""
    def AddControllerPitchInput(self, Val: float | Future[float]) -> Future[None]:
        """Add input (affecting Pitch) to the Controller's ControlRotation, if it is a local PlayerController."""
    def AddControllerRollInput(self, Val: float | Future[float]) -> Future[None]:
        """Add input (affecting Roll) to the Controller's ControlRotation, if it is a local PlayerController."""
    def AddControllerYawInput(self, Val: float | Future[float]) -> Future[None]:
        """Add input (affecting Yaw) to the Controller's ControlRotation, if it is a local PlayerController."""
    def AddMovementInput(self, WorldDirection: FVector_in, ScaleValue: float | Future[float] = 1.0, bForce: bool | Future[bool] = False) -> Future[None]:
        """Add movement input along the given world direction vector (usually normalized) scaled by 'ScaleValue'."""
    def ConsumeMovementInputVector(self) -> Future[FVector]:
        """Returns the pending input vector and resets it to zero."""
    def DetachFromControllerPendingDestroy(self) -> Future[None]:
        """Call this function to detach safely pawn from its controller, knowing that we will be destroyed soon."""
    def GetBaseAimRotation(self) -> Future[FRotator]:
        """Return our base aim rotation: that of the view."""
    def GetControlRotation(self) -> Future[FRotator]:
        """Get the rotation of the Controller, often the 'view' rotation of this Pawn."""
    def GetController(self) -> Future[AController | None]:
        """Returns controller for this actor."""
    def GetLastMovementInputVector(self) -> Future[FVector]:
        """Return the last input vector in world space that was processed by ConsumeMovementInputVector()."""
    def GetLocalViewingPlayerController(self) -> Future[APlayerController]:
        """Returns local Player Controller viewing this pawn, whether it is possessing or spectating the pawn."""
    def GetMovementComponent(self) -> Future[UPawnMovementComponent]:
        """Return our PawnMovementComponent, if we have one."""
    def GetPendingMovementInputVector(self) -> Future[FVector]:
        """Return the pending input vector in world space."""
    def IsLocallyControlled(self) -> Future[bool]:
        """Returns true if controlled by a local (not network) Controller."""
    def IsMoveInputIgnored(self) -> Future[bool]:
        """Helper to see if move input is ignored."""
    def IsPawnControlled(self) -> Future[bool]:
        """Check if this actor is currently being controlled at all (the actor has a valid Controller)."""
    def IsPlayerControlled(self) -> Future[bool]:
        """Returns true if controlled by a human player (possessed by a PlayerController)."""
    def ReceiveControllerChanged(self, OldController: AController | Future[AController], NewController: AController | Future[AController]) -> Future[None]:
        """Event called after a pawn's controller has changed, on the server and owning client."""
    def ReceivePossessed(self, NewController: AController | Future[AController]) -> Future[None]:
        """Event called when the Pawn is possessed by a Controller."""
    def ReceiveUnpossessed(self, OldController: AController | Future[AController]) -> Future[None]:
        """Event called when the Pawn is no longer possessed by a Controller."""
    bUseControllerRotationPitch: AsyncBoolProperty
    """If true, this Pawn's pitch will be updated to match the Controller's ControlRotation pitch, if controlled by a PlayerController."""
    bUseControllerRotationYaw: AsyncBoolProperty
    """If true, this Pawn's yaw will be updated to match the Controller's ControlRotation yaw, if controlled by a PlayerController."""
    bUseControllerRotationRoll: AsyncBoolProperty
    """If true, this Pawn's roll will be updated to match the Controller's ControlRotation roll, if controlled by a PlayerController."""
    BaseEyeHeight: AsyncFloatProperty
    """Base eye height above collision center, in centimetres."""
    AutoPossessPlayer: Property[AsyncValuePath[EAutoReceiveInput, EAutoReceiveInput_in], EAutoReceiveInput_in]
    """Determines which PlayerController, if any, should automatically possess the pawn when the level starts or when the pawn is spawned."""
    PlayerState: Property[APlayerState_async_path, APlayerState | Future[APlayerState] | None]
    """If Pawn is possessed by a player, points to its PlayerState."""
    Controller: Property[AController_async_path, AController | Future[AController] | None]
    """Controller currently possessing this Actor."""
    PreviousController: Property[AController_async_path, AController | Future[AController] | None]
    """Previous controller that was controlling this pawn since the last controller change notification."""
    ReceiveControllerChangedDelegate: Property[AsyncValuePath[list[FScriptDelegate], Sequence[FScriptDelegate_in] | None], Sequence[FScriptDelegate_in] | None]
    """Event called after a pawn's controller has changed, on the server and owning client."""
    ControlInputVector: Property[FVector_async, FVector_in]
    """Accumulated control input vector, stored in world space."""
    LastControlInputVector: Property[FVector_async, FVector_in]
    """The last control input vector that was processed by ConsumeMovementInputVector()."""

class APawn_send(AActor_send):
    """APawn under ``send_``: no function answers."""
    def AddControllerPitchInput(self, Val: float | Future[float]) -> None:
        """Add input (affecting Pitch) to the Controller's ControlRotation, if it is a local PlayerController."""
    def AddControllerRollInput(self, Val: float | Future[float]) -> None:
        """Add input (affecting Roll) to the Controller's ControlRotation, if it is a local PlayerController."""
    def AddControllerYawInput(self, Val: float | Future[float]) -> None:
        """Add input (affecting Yaw) to the Controller's ControlRotation, if it is a local PlayerController."""
    def AddMovementInput(self, WorldDirection: FVector_in, ScaleValue: float | Future[float] = 1.0, bForce: bool | Future[bool] = False) -> None:
        """Add movement input along the given world direction vector (usually normalized) scaled by 'ScaleValue'."""
    def ConsumeMovementInputVector(self) -> None:
        """Returns the pending input vector and resets it to zero."""
    def DetachFromControllerPendingDestroy(self) -> None:
        """Call this function to detach safely pawn from its controller, knowing that we will be destroyed soon."""
    def GetBaseAimRotation(self) -> None:
        """Return our base aim rotation: that of the view."""
    def GetControlRotation(self) -> None:
        """Get the rotation of the Controller, often the 'view' rotation of this Pawn."""
    def GetController(self) -> None:
        """Returns controller for this actor."""
    def GetLastMovementInputVector(self) -> None:
        """Return the last input vector in world space that was processed by ConsumeMovementInputVector()."""
    def GetLocalViewingPlayerController(self) -> None:
        """Returns local Player Controller viewing this pawn, whether it is possessing or spectating the pawn."""
    def GetMovementComponent(self) -> None:
        """Return our PawnMovementComponent, if we have one."""
    def GetPendingMovementInputVector(self) -> None:
        """Return the pending input vector in world space."""
    def IsLocallyControlled(self) -> None:
        """Returns true if controlled by a local (not network) Controller."""
    def IsMoveInputIgnored(self) -> None:
        """Helper to see if move input is ignored."""
    def IsPawnControlled(self) -> None:
        """Check if this actor is currently being controlled at all (the actor has a valid Controller)."""
    def IsPlayerControlled(self) -> None:
        """Returns true if controlled by a human player (possessed by a PlayerController)."""
    def ReceiveControllerChanged(self, OldController: AController | Future[AController], NewController: AController | Future[AController]) -> None:
        """Event called after a pawn's controller has changed, on the server and owning client."""
    def ReceivePossessed(self, NewController: AController | Future[AController]) -> None:
        """Event called when the Pawn is possessed by a Controller."""
    def ReceiveUnpossessed(self, OldController: AController | Future[AController]) -> None:
        """Event called when the Pawn is no longer possessed by a Controller."""
    bUseControllerRotationPitch: SendBoolProperty
    bUseControllerRotationYaw: SendBoolProperty
    bUseControllerRotationRoll: SendBoolProperty
    BaseEyeHeight: SendFloatProperty
    AutoPossessPlayer: SendProperty[EAutoReceiveInput_in]
    PlayerState: SendProperty[APlayerState | Future[APlayerState] | None]
    Controller: SendProperty[AController | Future[AController] | None]
    PreviousController: SendProperty[AController | Future[AController] | None]
    ReceiveControllerChangedDelegate: SendProperty[Sequence[FScriptDelegate_in] | None]
    ControlInputVector: SendProperty[FVector_in]
    LastControlInputVector: SendProperty[FVector_in]

class APawn(APawn_members, AActor):
    """Pawn is the base class of all actors that can be possessed by players or AI. They are the physical
    representations of players and creatures in a level.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/APawn

    Unreal: /Script/Engine.Pawn
    """
    @property
    def async_(self) -> APawn_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> APawn_send:
        """The same functions and variables, fire-and-forget."""

class APawn_path(ObjectPath[APawn, APawn_async_path, APawn_send], APawn_members):
    """A variable that refers to an object of APawn: its path."""

class APawn_async_path(AsyncObjectPath[APawn], APawn_async):
    """The same under ``async_``."""
