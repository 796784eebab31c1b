# generated, do not edit (Engine: Public/Camera/PlayerCameraManager.h)
from typing import TypeAlias, TypedDict
from spear.enums import UnrealEnum
from spear.structs import Struct
from spear.typing import (
    AsyncBoolProperty, AsyncFloatProperty, AsyncObjectPath, AsyncValuePath, BoolProperty, FloatProperty, Future, ObjectPath, Property,
    SendFloatProperty, SendProperty, StructPath, ValuePath,
)
from ..CoreUObject._NoExportTypes import FRotator, FVector
from ._Actor import AActor, AActor_async, AActor_async_path, AActor_members, AActor_path, AActor_send
from ._CameraTypes import FMinimalViewInfo, FMinimalViewInfo_async, FMinimalViewInfo_in, FMinimalViewInfo_path
from ._PlayerController import APlayerController, APlayerController_async_path, APlayerController_path
from ._PlayerState import APlayerState, APlayerState_async_path, APlayerState_path

class EViewTargetBlendFunction(UnrealEnum):
    """Options that define how to blend when changing view targets.

    Unreal: /Script/Engine.EViewTargetBlendFunction
    """
    VTBlend_Linear = 0
    """Camera does a simple linear interpolation."""
    VTBlend_Cubic = 1
    """Camera has a slight ease in and ease out, but amount of ease cannot be tweaked."""
    VTBlend_EaseIn = 2
    """Camera immediately accelerates, but smoothly decelerates into the target. Ease amount controlled by BlendExp."""
    VTBlend_EaseOut = 3
    """Camera smoothly accelerates, but does not decelerate into the target. Ease amount controlled by BlendExp."""
    VTBlend_EaseInOut = 4
    """Camera smoothly accelerates and decelerates. Ease amount controlled by BlendExp."""
    VTBlend_PreBlended = 5
    """The game's camera system has already performed the blending. Engine should not blend at all."""
    VTBlend_MAX = 6

EViewTargetBlendFunction_in: TypeAlias = EViewTargetBlendFunction | str | Future[EViewTargetBlendFunction]
"""What stands for EViewTargetBlendFunction as an argument: an entry, the name that Unreal gives it, a future."""

class FCameraCacheEntry(Struct):
    """Cached camera POV info, stored as optimization so we only need to do a full camera update once per tick.

    Unreal: /Script/Engine.CameraCacheEntry
    """
    def __init__(self, TimeStamp: float = ..., POV: FMinimalViewInfo = ...) -> None: ...
    TimeStamp: float
    """World time this entry was created."""
    POV: FMinimalViewInfo
    """Camera POV to cache."""

class FCameraCacheEntry_dict(TypedDict, total=False):
    """Any of the fields of FCameraCacheEntry: what a dictionary for it may hold."""
    TimeStamp: float | Future[float]
    POV: FMinimalViewInfo_in

FCameraCacheEntry_in: TypeAlias = FCameraCacheEntry | FCameraCacheEntry_dict | Future[FCameraCacheEntry]
"""What stands for FCameraCacheEntry as an argument: itself, a dictionary of its fields, a future."""

class FCameraCacheEntry_path(StructPath[FCameraCacheEntry, FCameraCacheEntry_in, FCameraCacheEntry_async]):
    """A variable of type FCameraCacheEntry: its path."""
    TimeStamp: FloatProperty
    """World time this entry was created."""
    POV: Property[FMinimalViewInfo_path, FMinimalViewInfo_in]
    """Camera POV to cache."""

class FCameraCacheEntry_async(AsyncValuePath[FCameraCacheEntry, FCameraCacheEntry_in]):
    """The same under ``async_``."""
    TimeStamp: AsyncFloatProperty
    POV: Property[FMinimalViewInfo_async, FMinimalViewInfo_in]

class FTViewTarget(Struct):
    """A ViewTarget is the primary actor the camera is associated with.

    Unreal: /Script/Engine.TViewTarget
    """
    def __init__(self, Target: AActor | None = ..., POV: FMinimalViewInfo = ..., PlayerState: APlayerState | None = ...) -> None: ...
    Target: AActor | None
    """Target Actor used to compute POV."""
    POV: FMinimalViewInfo
    """Computed point of view."""
    PlayerState: APlayerState | None
    """PlayerState (used to follow same player through pawn transitions, etc., when spectating)."""

class FTViewTarget_dict(TypedDict, total=False):
    """Any of the fields of FTViewTarget: what a dictionary for it may hold."""
    Target: AActor | Future[AActor] | None
    POV: FMinimalViewInfo_in
    PlayerState: APlayerState | Future[APlayerState] | None

FTViewTarget_in: TypeAlias = FTViewTarget | FTViewTarget_dict | Future[FTViewTarget]
"""What stands for FTViewTarget as an argument: itself, a dictionary of its fields, a future."""

class FTViewTarget_path(StructPath[FTViewTarget, FTViewTarget_in, FTViewTarget_async]):
    """A variable of type FTViewTarget: its path."""
    Target: Property[AActor_path, AActor | Future[AActor] | None]
    """Target Actor used to compute POV."""
    POV: Property[FMinimalViewInfo_path, FMinimalViewInfo_in]
    """Computed point of view."""
    PlayerState: Property[APlayerState_path, APlayerState | Future[APlayerState] | None]
    """PlayerState (used to follow same player through pawn transitions, etc., when spectating)."""

class FTViewTarget_async(AsyncValuePath[FTViewTarget, FTViewTarget_in]):
    """The same under ``async_``."""
    Target: Property[AActor_async_path, AActor | Future[AActor] | None]
    POV: Property[FMinimalViewInfo_async, FMinimalViewInfo_in]
    PlayerState: Property[APlayerState_async_path, APlayerState | Future[APlayerState] | None]

class FViewTargetTransitionParams(Struct):
    """A set of parameters to describe how to transition between view targets.

    Unreal: /Script/Engine.ViewTargetTransitionParams
    """
    def __init__(self, BlendTime: float = ..., BlendFunction: EViewTargetBlendFunction = ..., BlendExp: float = ..., bLockOutgoing: bool = ...) -> None: ...
    BlendTime: float
    """Total duration of blend to pending view target, in seconds. 0 means no blending."""
    BlendFunction: EViewTargetBlendFunction
    """Function to apply to the blend parameter."""
    BlendExp: float
    """Exponent, used by certain blend functions to control the shape of the curve."""
    bLockOutgoing: bool
    """If true, lock outgoing viewtarget to last frame's camera POV for the remainder of the blend."""

class FViewTargetTransitionParams_dict(TypedDict, total=False):
    """Any of the fields of FViewTargetTransitionParams: what a dictionary for it may hold."""
    BlendTime: float | Future[float]
    BlendFunction: EViewTargetBlendFunction_in
    BlendExp: float | Future[float]
    bLockOutgoing: bool | Future[bool]

FViewTargetTransitionParams_in: TypeAlias = FViewTargetTransitionParams | FViewTargetTransitionParams_dict | Future[FViewTargetTransitionParams]
"""What stands for FViewTargetTransitionParams as an argument: itself, a dictionary of its fields, a future."""

class FViewTargetTransitionParams_path(StructPath[FViewTargetTransitionParams, FViewTargetTransitionParams_in, FViewTargetTransitionParams_async]):
    """A variable of type FViewTargetTransitionParams: its path."""
    BlendTime: FloatProperty
    """Total duration of blend to pending view target, in seconds. 0 means no blending."""
    BlendFunction: Property[ValuePath[EViewTargetBlendFunction, EViewTargetBlendFunction_in], EViewTargetBlendFunction_in]
    """Function to apply to the blend parameter."""
    BlendExp: FloatProperty
    """Exponent, used by certain blend functions to control the shape of the curve."""
    bLockOutgoing: BoolProperty
    """If true, lock outgoing viewtarget to last frame's camera POV for the remainder of the blend."""

class FViewTargetTransitionParams_async(AsyncValuePath[FViewTargetTransitionParams, FViewTargetTransitionParams_in]):
    """The same under ``async_``."""
    BlendTime: AsyncFloatProperty
    BlendFunction: Property[AsyncValuePath[EViewTargetBlendFunction, EViewTargetBlendFunction_in], EViewTargetBlendFunction_in]
    BlendExp: AsyncFloatProperty
    bLockOutgoing: AsyncBoolProperty

class APlayerCameraManager_members(AActor_members):
    """Functions and variables of APlayerCameraManager."""
    def GetCameraLocation(self) -> FVector:
        """Returns camera's current location, in centimetres.

        Unreal: APlayerCameraManager.GetCameraLocation
        """
    def GetCameraRotation(self) -> FRotator:
        """Returns camera's current rotation, in degrees.

        Unreal: APlayerCameraManager.GetCameraRotation
        """
    def GetFOVAngle(self) -> float:
        """Returns the camera's current full FOV angle, in degrees.

        Unreal: APlayerCameraManager.GetFOVAngle
        """
    def GetOwningPlayerController(self) -> APlayerController:
        """Returns the PlayerController that owns this camera.

        Unreal: APlayerCameraManager.GetOwningPlayerController
        """
    PCOwner: Property[APlayerController_path, APlayerController | Future[APlayerController] | None]
    """PlayerController that owns this Camera actor.

    Unreal: APlayerCameraManager.PCOwner (APlayerController*)
    """
    DefaultFOV: FloatProperty
    """FOV to use by default, in degrees.

    Unreal: APlayerCameraManager.DefaultFOV (float)
    """
    LockedFOV: FloatProperty
    """Value to lock FOV to, in degrees. 0: not locked.

    Unreal: APlayerCameraManager.LockedFOV (float)
    """
    ViewTarget: Property[FTViewTarget_path, FTViewTarget_in]
    """Current ViewTarget.

    Unreal: APlayerCameraManager.ViewTarget (FTViewTarget)
    """
    PendingViewTarget: Property[FTViewTarget_path, FTViewTarget_in]
    """Pending view target for blending.

    Unreal: APlayerCameraManager.PendingViewTarget (FTViewTarget)
    """
    ViewPitchMin: FloatProperty
    """Minimum view pitch, in degrees.

    Unreal: APlayerCameraManager.ViewPitchMin (float)
    """
    ViewPitchMax: FloatProperty
    """Maximum view pitch, in degrees.

    Unreal: APlayerCameraManager.ViewPitchMax (float)
    """
    ViewYawMin: FloatProperty
    """Minimum view yaw, in degrees.

    Unreal: APlayerCameraManager.ViewYawMin (float)
    """
    ViewYawMax: FloatProperty
    """Maximum view yaw, in degrees.

    Unreal: APlayerCameraManager.ViewYawMax (float)
    """
    ViewRollMin: FloatProperty
    """Minimum view roll, in degrees.

    Unreal: APlayerCameraManager.ViewRollMin (float)
    """
    ViewRollMax: FloatProperty
    """Maximum view roll, in degrees.

    Unreal: APlayerCameraManager.ViewRollMax (float)
    """
    CameraCachePrivate: Property[FCameraCacheEntry_path, FCameraCacheEntry_in]
    """Cached camera properties.

    Unreal: APlayerCameraManager.CameraCachePrivate (FCameraCacheEntry)
    """
    LastFrameCameraCachePrivate: Property[FCameraCacheEntry_path, FCameraCacheEntry_in]
    """Cached camera properties, one frame old.

    Unreal: APlayerCameraManager.LastFrameCameraCachePrivate (FCameraCacheEntry)
    """

class APlayerCameraManager_async(AActor_async):
    """APlayerCameraManager under ``async_``: each function gives a future."""
    def GetCameraLocation(self) -> Future[FVector]:
        """Returns camera's current location, in centimetres."""
    def GetCameraRotation(self) -> Future[FRotator]:
        """Returns camera's current rotation, in degrees."""
    def GetFOVAngle(self) -> Future[float]:
        """Returns the camera's current full FOV angle, in degrees."""
    def GetOwningPlayerController(self) -> Future[APlayerController]:
        """Returns the PlayerController that owns this camera."""
    PCOwner: Property[APlayerController_async_path, APlayerController | Future[APlayerController] | None]
    """PlayerController that owns this Camera actor."""
    DefaultFOV: AsyncFloatProperty
    """FOV to use by default, in degrees."""
    LockedFOV: AsyncFloatProperty
    """Value to lock FOV to, in degrees. 0: not locked."""
    ViewTarget: Property[FTViewTarget_async, FTViewTarget_in]
    """Current ViewTarget."""
    PendingViewTarget: Property[FTViewTarget_async, FTViewTarget_in]
    """Pending view target for blending."""
    ViewPitchMin: AsyncFloatProperty
    """Minimum view pitch, in degrees."""
    ViewPitchMax: AsyncFloatProperty
    """Maximum view pitch, in degrees."""
    ViewYawMin: AsyncFloatProperty
    """Minimum view yaw, in degrees."""
    ViewYawMax: AsyncFloatProperty
    """Maximum view yaw, in degrees."""
    ViewRollMin: AsyncFloatProperty
    """Minimum view roll, in degrees."""
    ViewRollMax: AsyncFloatProperty
    """Maximum view roll, in degrees."""
    CameraCachePrivate: Property[FCameraCacheEntry_async, FCameraCacheEntry_in]
    """Cached camera properties."""
    LastFrameCameraCachePrivate: Property[FCameraCacheEntry_async, FCameraCacheEntry_in]
    """Cached camera properties, one frame old."""

class APlayerCameraManager_send(AActor_send):
    """APlayerCameraManager under ``send_``: no function answers."""
    def GetCameraLocation(self) -> None:
        """Returns camera's current location, in centimetres."""
    def GetCameraRotation(self) -> None:
        """Returns camera's current rotation, in degrees."""
    def GetFOVAngle(self) -> None:
        """Returns the camera's current full FOV angle, in degrees."""
    def GetOwningPlayerController(self) -> None:
        """Returns the PlayerController that owns this camera."""
    PCOwner: SendProperty[APlayerController | Future[APlayerController] | None]
    DefaultFOV: SendFloatProperty
    LockedFOV: SendFloatProperty
    ViewTarget: SendProperty[FTViewTarget_in]
    PendingViewTarget: SendProperty[FTViewTarget_in]
    ViewPitchMin: SendFloatProperty
    ViewPitchMax: SendFloatProperty
    ViewYawMin: SendFloatProperty
    ViewYawMax: SendFloatProperty
    ViewRollMin: SendFloatProperty
    ViewRollMax: SendFloatProperty
    CameraCachePrivate: SendProperty[FCameraCacheEntry_in]
    LastFrameCameraCachePrivate: SendProperty[FCameraCacheEntry_in]

class APlayerCameraManager(APlayerCameraManager_members, AActor):
    """A PlayerCameraManager is responsible for managing the camera for a particular player. It defines the final
    view properties used by other systems (e.g. the renderer), meaning you can think of it as your virtual eyeball
    in the world. It can compute the final camera properties directly, or it can arbitrate/blend between other
    objects or actors that influence the camera.

    https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Camera/APlayerCameraManager

    Unreal: /Script/Engine.PlayerCameraManager
    """
    @property
    def async_(self) -> APlayerCameraManager_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> APlayerCameraManager_send:
        """The same functions and variables, fire-and-forget."""

class APlayerCameraManager_path(ObjectPath[APlayerCameraManager, APlayerCameraManager_async_path, APlayerCameraManager_send], APlayerCameraManager_members):
    """A variable that refers to an object of APlayerCameraManager: its path."""

class APlayerCameraManager_async_path(AsyncObjectPath[APlayerCameraManager], APlayerCameraManager_async):
    """The same under ``async_``."""
