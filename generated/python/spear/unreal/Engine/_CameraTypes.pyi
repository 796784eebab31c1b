# generated, do not edit (Engine: Public/Camera/CameraTypes.h)
from typing import TypeAlias, TypedDict
from spear.enums import UnrealEnum
from spear.structs import Struct
from spear.typing import AsyncBoolProperty, AsyncFloatProperty, AsyncValuePath, BoolProperty, FloatProperty, Future, Property, StructPath, ValuePath
from ..CoreUObject._NoExportTypes import FRotator, FRotator_async, FRotator_in, FRotator_path, FVector, FVector_async, FVector_in, FVector_path

class ECameraProjectionMode(UnrealEnum):
    """How a camera projects. Epic page: ECameraProjectionMode::Type.

    Unreal: /Script/Engine.ECameraProjectionMode
    """
    Perspective = 0
    """Things get smaller with distance."""
    Orthographic = 1
    """Things keep their size."""

ECameraProjectionMode_in: TypeAlias = ECameraProjectionMode | str | Future[ECameraProjectionMode]
"""What stands for ECameraProjectionMode as an argument: an entry, the name that Unreal gives it, a future."""

class FMinimalViewInfo(Struct):
    """Where a view is taken from and with which lens. Epic page: FMinimalViewInfo.

    Unreal: /Script/Engine.MinimalViewInfo
    """
    def __init__(self, Location: FVector = ..., Rotation: FRotator = ..., FOV: float = ..., DesiredFOV: float = ..., OrthoWidth: float = ..., OrthoNearClipPlane: float = ..., OrthoFarClipPlane: float = ..., PerspectiveNearClipPlane: float = ..., AspectRatio: float = ..., bConstrainAspectRatio: bool = ..., ProjectionMode: ECameraProjectionMode = ...) -> None: ...
    Location: FVector
    """Location of the view, in centimetres."""
    Rotation: FRotator
    """Rotation of the view, in degrees."""
    FOV: float
    """The horizontal field of view, in degrees, in perspective mode (ignored in orthographic mode)."""
    DesiredFOV: float
    """The originally desired horizontal field of view before any adjustments for a different aspect ratio."""
    OrthoWidth: float
    """The desired width of the orthographic view, in centimetres (ignored in perspective mode)."""
    OrthoNearClipPlane: float
    """The near plane distance of the orthographic view, in centimetres."""
    OrthoFarClipPlane: float
    """The far plane distance of the orthographic view, in centimetres."""
    PerspectiveNearClipPlane: float
    """The near plane distance of the perspective view, in centimetres. Not positive: the engine's default."""
    AspectRatio: float
    """Aspect ratio (width over height)."""
    bConstrainAspectRatio: bool
    """If true, black bars will be added if the destination view has a different aspect ratio than this camera
    requested.
    """
    ProjectionMode: ECameraProjectionMode
    """The type of camera."""

class FMinimalViewInfo_dict(TypedDict, total=False):
    """Any of the fields of FMinimalViewInfo: what a dictionary for it may hold."""
    Location: FVector_in
    Rotation: FRotator_in
    FOV: float | Future[float]
    DesiredFOV: float | Future[float]
    OrthoWidth: float | Future[float]
    OrthoNearClipPlane: float | Future[float]
    OrthoFarClipPlane: float | Future[float]
    PerspectiveNearClipPlane: float | Future[float]
    AspectRatio: float | Future[float]
    bConstrainAspectRatio: bool | Future[bool]
    ProjectionMode: ECameraProjectionMode_in

FMinimalViewInfo_in: TypeAlias = FMinimalViewInfo | FMinimalViewInfo_dict | Future[FMinimalViewInfo]
"""What stands for FMinimalViewInfo as an argument: itself, a dictionary of its fields, a future."""

class FMinimalViewInfo_path(StructPath[FMinimalViewInfo, FMinimalViewInfo_in, FMinimalViewInfo_async]):
    """A variable of type FMinimalViewInfo: its path."""
    Location: Property[FVector_path, FVector_in]
    """Location of the view, in centimetres."""
    Rotation: Property[FRotator_path, FRotator_in]
    """Rotation of the view, in degrees."""
    FOV: FloatProperty
    """The horizontal field of view, in degrees, in perspective mode (ignored in orthographic mode)."""
    DesiredFOV: FloatProperty
    """The originally desired horizontal field of view before any adjustments for a different aspect ratio."""
    OrthoWidth: FloatProperty
    """The desired width of the orthographic view, in centimetres (ignored in perspective mode)."""
    OrthoNearClipPlane: FloatProperty
    """The near plane distance of the orthographic view, in centimetres."""
    OrthoFarClipPlane: FloatProperty
    """The far plane distance of the orthographic view, in centimetres."""
    PerspectiveNearClipPlane: FloatProperty
    """The near plane distance of the perspective view, in centimetres. Not positive: the engine's default."""
    AspectRatio: FloatProperty
    """Aspect ratio (width over height)."""
    bConstrainAspectRatio: BoolProperty
    """If true, black bars will be added if the destination view has a different aspect ratio than this camera
    requested.
    """
    ProjectionMode: Property[ValuePath[ECameraProjectionMode, ECameraProjectionMode_in], ECameraProjectionMode_in]
    """The type of camera."""

class FMinimalViewInfo_async(AsyncValuePath[FMinimalViewInfo, FMinimalViewInfo_in]):
    """The same under ``async_``."""
    Location: Property[FVector_async, FVector_in]
    Rotation: Property[FRotator_async, FRotator_in]
    FOV: AsyncFloatProperty
    DesiredFOV: AsyncFloatProperty
    OrthoWidth: AsyncFloatProperty
    OrthoNearClipPlane: AsyncFloatProperty
    OrthoFarClipPlane: AsyncFloatProperty
    PerspectiveNearClipPlane: AsyncFloatProperty
    AspectRatio: AsyncFloatProperty
    bConstrainAspectRatio: AsyncBoolProperty
    ProjectionMode: Property[AsyncValuePath[ECameraProjectionMode, ECameraProjectionMode_in], ECameraProjectionMode_in]
