# generated, do not edit (Engine: Public/GameFramework/PlayerController.h)
from typing import NamedTuple
from spear.typing import (
    AsyncBoolProperty, AsyncClassPath, AsyncObjectPath, BoolProperty, ClassPath, Future, ObjectPath, Property, SendBoolProperty, SendProperty,
)
from ..CoreUObject._Intrinsic import UClass
from ..CoreUObject._NoExportTypes import FRotator_async, FRotator_in, FRotator_path
from ._Actor import AActor
from ._Controller import AController, AController_async, AController_members, AController_send
from ._Pawn import APawn, APawn_async_path, APawn_path
from ._Player import UPlayer, UPlayer_async_path, UPlayer_path
from ._PlayerCameraManager import (
    APlayerCameraManager, APlayerCameraManager_async_path, APlayerCameraManager_path, EViewTargetBlendFunction, EViewTargetBlendFunction_in,
)

class APlayerController_GetViewportSize_Result(NamedTuple):
    """Results of APlayerController.GetViewportSize."""
    SizeX: int
    SizeY: int

class APlayerController_members(AController_members):
    """Functions and variables of APlayerController."""
    def AddPitchInput(self, Val: float | Future[float]) -> None:
        """Add Pitch (look up) input. This value is multiplied by InputPitchScale. Degrees.

        Unreal: APlayerController.AddPitchInput
        """
    def AddRollInput(self, Val: float | Future[float]) -> None:
        """Add Roll input. Degrees.

        Unreal: APlayerController.AddRollInput
        """
    def AddYawInput(self, Val: float | Future[float]) -> None:
        """Add Yaw (turn) input. Degrees.

        Unreal: APlayerController.AddYawInput
        """
    def ConsoleCommand(self, Command: str | Future[str], bWriteToLog: bool | Future[bool] = True) -> str:
        """Executes a console command: of the player, the engine, or the variable of that name.

        Returns:
            its output.

        Unreal: APlayerController.ConsoleCommand
        """
    def GetViewportSize(self) -> APlayerController_GetViewportSize_Result:
        """Helper to get the size of the viewport, in pixels. Returns 0, 0 if there is no viewport.

        Unreal: APlayerController.GetViewportSize
        """
    def Pause(self) -> None:
        """Command to try to pause the game: toggles.

        Unreal: APlayerController.Pause
        """
    def RestartLevel(self) -> None:
        """Restarts the current level.

        Unreal: APlayerController.RestartLevel
        """
    def SetName(self, S: str | Future[str]) -> None:
        """Change name of local player.

        Unreal: APlayerController.SetName
        """
    def SetViewTargetWithBlend(self, NewViewTarget: AActor | Future[AActor], BlendTime: float | Future[float] = 0.0, BlendFunc: EViewTargetBlendFunction_in = EViewTargetBlendFunction.VTBlend_Linear, BlendExp: float | Future[float] = 0.0, bLockOutgoing: bool | Future[bool] = False) -> None:
        """Set the view target blending with variable control.

        Args:
            NewViewTarget: new actor to set as view target.
            BlendTime: time taken to blend, in seconds.
            BlendFunc: cubic, Linear etc functions for blending.
            BlendExp: exponent, used by certain blend functions to control the shape of the curve.
            bLockOutgoing: if true, lock outgoing viewtarget to last frame's camera position for the remainder of the blend.

        Unreal: APlayerController.SetViewTargetWithBlend
        """
    Player: Property[UPlayer_path, UPlayer | Future[UPlayer] | None]
    """UPlayer associated with this PlayerController. Could be a local player or a net connection.

    Unreal: APlayerController.Player (UPlayer*)
    """
    AcknowledgedPawn: Property[APawn_path, APawn | Future[APawn] | None]
    """Used in net games so client can acknowledge it possessed a specific pawn: always the pawn here.

    Unreal: APlayerController.AcknowledgedPawn (APawn*)
    """
    PlayerCameraManager: Property[APlayerCameraManager_path, APlayerCameraManager | Future[APlayerCameraManager] | None]
    """Camera manager associated with this Player Controller.

    Unreal: APlayerController.PlayerCameraManager (APlayerCameraManager*)
    """
    PlayerCameraManagerClass: Property[ClassPath[UClass, type[APlayerCameraManager] | UClass | str | Future[UClass] | None], type[APlayerCameraManager] | UClass | str | Future[UClass] | None]
    """PlayerCamera class should be set for each game, otherwise Engine.PlayerCameraManager is used.

    Unreal: APlayerController.PlayerCameraManagerClass (TSubclassOf<APlayerCameraManager>)
    """
    bAutoManageActiveCameraTarget: BoolProperty
    """True to allow this player controller to manage the camera target for you, typically by using the possessed
    pawn as the camera target. Set to false if you want to manually control the camera target.

    Unreal: APlayerController.bAutoManageActiveCameraTarget (bool)
    """
    RotationInput: Property[FRotator_path, FRotator_in]
    """Rotation input collected in this frame, in degrees; applied by UpdateRotation.

    Unreal: APlayerController.RotationInput (FRotator)
    """

class APlayerController_async(AController_async):
    """APlayerController under ``async_``: each function gives a future."""
    def AddPitchInput(self, Val: float | Future[float]) -> Future[None]:
        """Add Pitch (look up) input."""
    def AddRollInput(self, Val: float | Future[float]) -> Future[None]:
        """Add Roll input."""
    def AddYawInput(self, Val: float | Future[float]) -> Future[None]:
        """Add Yaw (turn) input."""
    def ConsoleCommand(self, Command: str | Future[str], bWriteToLog: bool | Future[bool] = True) -> Future[str]:
        """Executes a console command: of the player, the engine, or the variable of that name."""
    def GetViewportSize(self) -> Future[APlayerController_GetViewportSize_Result]:
        """Helper to get the size of the viewport, in pixels."""
    def Pause(self) -> Future[None]:
        """Command to try to pause the game: toggles."""
    def RestartLevel(self) -> Future[None]:
        """Restarts the current level."""
    def SetName(self, S: str | Future[str]) -> Future[None]:
        """Change name of local player."""
    def SetViewTargetWithBlend(self, NewViewTarget: AActor | Future[AActor], BlendTime: float | Future[float] = 0.0, BlendFunc: EViewTargetBlendFunction_in = EViewTargetBlendFunction.VTBlend_Linear, BlendExp: float | Future[float] = 0.0, bLockOutgoing: bool | Future[bool] = False) -> Future[None]:
        """Set the view target blending with variable control."""
    Player: Property[UPlayer_async_path, UPlayer | Future[UPlayer] | None]
    """UPlayer associated with this PlayerController."""
    AcknowledgedPawn: Property[APawn_async_path, APawn | Future[APawn] | None]
    """Used in net games so client can acknowledge it possessed a specific pawn: always the pawn here."""
    PlayerCameraManager: Property[APlayerCameraManager_async_path, APlayerCameraManager | Future[APlayerCameraManager] | None]
    """Camera manager associated with this Player Controller."""
    PlayerCameraManagerClass: Property[AsyncClassPath[UClass, type[APlayerCameraManager] | UClass | str | Future[UClass] | None], type[APlayerCameraManager] | UClass | str | Future[UClass] | None]
    """PlayerCamera class should be set for each game, otherwise Engine.PlayerCameraManager is used."""
    bAutoManageActiveCameraTarget: AsyncBoolProperty
    """True to allow this player controller to manage the camera target for you, typically by using the possessed pawn as the camera target."""
    RotationInput: Property[FRotator_async, FRotator_in]
    """Rotation input collected in this frame, in degrees; applied by UpdateRotation."""

class APlayerController_send(AController_send):
    """APlayerController under ``send_``: no function answers."""
    def AddPitchInput(self, Val: float | Future[float]) -> None:
        """Add Pitch (look up) input."""
    def AddRollInput(self, Val: float | Future[float]) -> None:
        """Add Roll input."""
    def AddYawInput(self, Val: float | Future[float]) -> None:
        """Add Yaw (turn) input."""
    def ConsoleCommand(self, Command: str | Future[str], bWriteToLog: bool | Future[bool] = True) -> None:
        """Executes a console command: of the player, the engine, or the variable of that name."""
    def GetViewportSize(self) -> None:
        """Helper to get the size of the viewport, in pixels."""
    def Pause(self) -> None:
        """Command to try to pause the game: toggles."""
    def RestartLevel(self) -> None:
        """Restarts the current level."""
    def SetName(self, S: str | Future[str]) -> None:
        """Change name of local player."""
    def SetViewTargetWithBlend(self, NewViewTarget: AActor | Future[AActor], BlendTime: float | Future[float] = 0.0, BlendFunc: EViewTargetBlendFunction_in = EViewTargetBlendFunction.VTBlend_Linear, BlendExp: float | Future[float] = 0.0, bLockOutgoing: bool | Future[bool] = False) -> None:
        """Set the view target blending with variable control."""
    Player: SendProperty[UPlayer | Future[UPlayer] | None]
    AcknowledgedPawn: SendProperty[APawn | Future[APawn] | None]
    PlayerCameraManager: SendProperty[APlayerCameraManager | Future[APlayerCameraManager] | None]
    PlayerCameraManagerClass: SendProperty[type[APlayerCameraManager] | UClass | str | Future[UClass] | None]
    bAutoManageActiveCameraTarget: SendBoolProperty
    RotationInput: SendProperty[FRotator_in]

class APlayerController(APlayerController_members, AController):
    """PlayerControllers are used by human players to control Pawns. ControlRotation (accessed via
    GetControlRotation()), determines the aiming orientation of the controlled Pawn.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/GameFramework/APlayerController

    Unreal: /Script/Engine.PlayerController
    """
    @property
    def async_(self) -> APlayerController_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> APlayerController_send:
        """The same functions and variables, fire-and-forget."""

class APlayerController_path(ObjectPath[APlayerController, APlayerController_async_path, APlayerController_send], APlayerController_members):
    """A variable that refers to an object of APlayerController: its path."""

class APlayerController_async_path(AsyncObjectPath[APlayerController], APlayerController_async):
    """The same under ``async_``."""
