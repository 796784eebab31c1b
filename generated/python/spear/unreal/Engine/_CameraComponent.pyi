# generated, do not edit (Engine: Public/Camera/CameraComponent.h)
from typing import NamedTuple
from spear.typing import (
    AsyncBoolProperty, AsyncFloatProperty, AsyncObjectPath, AsyncValuePath, BoolProperty, FloatProperty, Future, ObjectPath, Property,
    SendBoolProperty, SendFloatProperty, SendProperty, ValuePath,
)
from ._CameraTypes import ECameraProjectionMode, ECameraProjectionMode_in, FMinimalViewInfo
from ._SceneComponent import USceneComponent, USceneComponent_async, USceneComponent_members, USceneComponent_send

class UCameraComponent_GetCameraView_Result(NamedTuple):
    """Results of UCameraComponent.GetCameraView."""
    DesiredView: FMinimalViewInfo
    """receives the view"""

class UCameraComponent_members(USceneComponent_members):
    """Functions and variables of UCameraComponent."""
    def GetCameraView(self, DeltaTime: float | Future[float]) -> UCameraComponent_GetCameraView_Result:
        """Returns the camera's point of view.

        Args:
            DeltaTime: time since the last frame, in seconds

        Returns:
            DesiredView: receives the view

        Unreal: UCameraComponent.GetCameraView
        """
    def SetAspectRatio(self, InAspectRatio: float | Future[float]) -> None:
        """Sets the aspect ratio.

        Unreal: UCameraComponent.SetAspectRatio
        """
    def SetConstraintAspectRatio(self, bInConstrainAspectRatio: bool | Future[bool]) -> None:
        """Sets whether the aspect ratio is constrained.

        Unreal: UCameraComponent.SetConstraintAspectRatio
        """
    def SetFieldOfView(self, InFieldOfView: float | Future[float]) -> None:
        """Sets the horizontal field of view, in degrees.

        Unreal: UCameraComponent.SetFieldOfView
        """
    def SetOrthoFarClipPlane(self, InOrthoFarClipPlane: float | Future[float]) -> None:
        """Sets the far plane distance of the orthographic view, in centimetres.

        Unreal: UCameraComponent.SetOrthoFarClipPlane
        """
    def SetOrthoNearClipPlane(self, InOrthoNearClipPlane: float | Future[float]) -> None:
        """Sets the near plane distance of the orthographic view, in centimetres.

        Unreal: UCameraComponent.SetOrthoNearClipPlane
        """
    def SetOrthoWidth(self, InOrthoWidth: float | Future[float]) -> None:
        """Sets the width of the orthographic view, in centimetres.

        Unreal: UCameraComponent.SetOrthoWidth
        """
    def SetProjectionMode(self, InProjectionMode: ECameraProjectionMode_in) -> None:
        """Sets the type of camera.

        Unreal: UCameraComponent.SetProjectionMode
        """
    def SetUseFieldOfViewForLOD(self, bInUseFieldOfViewForLOD: bool | Future[bool]) -> None:
        """Sets whether the field of view counts for the level of detail.

        Unreal: UCameraComponent.SetUseFieldOfViewForLOD
        """
    FieldOfView: FloatProperty
    """The horizontal field of view, in degrees, in perspective mode (ignored in orthographic mode).

    unit deg; 0.001 to 360.0

    Unreal: UCameraComponent.FieldOfView (float)
    """
    OrthoWidth: FloatProperty
    """The desired width of the orthographic view, in centimetres (ignored in perspective mode).

    Unreal: UCameraComponent.OrthoWidth (float)
    """
    OrthoNearClipPlane: FloatProperty
    """The near plane distance of the orthographic view, in centimetres.

    Unreal: UCameraComponent.OrthoNearClipPlane (float)
    """
    OrthoFarClipPlane: FloatProperty
    """The far plane distance of the orthographic view, in centimetres.

    Unreal: UCameraComponent.OrthoFarClipPlane (float)
    """
    AspectRatio: FloatProperty
    """Aspect ratio (width over height).

    0.1 to 100.0

    Unreal: UCameraComponent.AspectRatio (float)
    """
    bConstrainAspectRatio: BoolProperty
    """If true, black bars will be added if the destination view has a different aspect ratio than this camera
    requested.

    Unreal: UCameraComponent.bConstrainAspectRatio (bool)
    """
    bUseFieldOfViewForLOD: BoolProperty
    """If true, account for the field of view angle when computing which level of detail to use for meshes.

    Unreal: UCameraComponent.bUseFieldOfViewForLOD (bool)
    """
    bUsePawnControlRotation: BoolProperty
    """If this camera component is placed on a pawn, should it use the view/control rotation of the pawn where
    possible?

    Unreal: UCameraComponent.bUsePawnControlRotation (bool)
    """
    ProjectionMode: Property[ValuePath[ECameraProjectionMode, ECameraProjectionMode_in], ECameraProjectionMode_in]
    """The type of camera.

    Unreal: UCameraComponent.ProjectionMode (TEnumAsByte<ECameraProjectionMode::Type>)
    """

class UCameraComponent_async(USceneComponent_async):
    """UCameraComponent under ``async_``: each function gives a future."""
    def GetCameraView(self, DeltaTime: float | Future[float]) -> Future[UCameraComponent_GetCameraView_Result]:
        """Returns the camera's point of view."""
    def SetAspectRatio(self, InAspectRatio: float | Future[float]) -> Future[None]:
        """Sets the aspect ratio."""
    def SetConstraintAspectRatio(self, bInConstrainAspectRatio: bool | Future[bool]) -> Future[None]:
        """Sets whether the aspect ratio is constrained."""
    def SetFieldOfView(self, InFieldOfView: float | Future[float]) -> Future[None]:
        """Sets the horizontal field of view, in degrees."""
    def SetOrthoFarClipPlane(self, InOrthoFarClipPlane: float | Future[float]) -> Future[None]:
        """Sets the far plane distance of the orthographic view, in centimetres."""
    def SetOrthoNearClipPlane(self, InOrthoNearClipPlane: float | Future[float]) -> Future[None]:
        """Sets the near plane distance of the orthographic view, in centimetres."""
    def SetOrthoWidth(self, InOrthoWidth: float | Future[float]) -> Future[None]:
        """Sets the width of the orthographic view, in centimetres."""
    def SetProjectionMode(self, InProjectionMode: ECameraProjectionMode_in) -> Future[None]:
        """Sets the type of camera."""
    def SetUseFieldOfViewForLOD(self, bInUseFieldOfViewForLOD: bool | Future[bool]) -> Future[None]:
        """Sets whether the field of view counts for the level of detail."""
    FieldOfView: AsyncFloatProperty
    """The horizontal field of view, in degrees, in perspective mode (ignored in orthographic mode)."""
    OrthoWidth: AsyncFloatProperty
    """The desired width of the orthographic view, in centimetres (ignored in perspective mode)."""
    OrthoNearClipPlane: AsyncFloatProperty
    """The near plane distance of the orthographic view, in centimetres."""
    OrthoFarClipPlane: AsyncFloatProperty
    """The far plane distance of the orthographic view, in centimetres."""
    AspectRatio: AsyncFloatProperty
    """Aspect ratio (width over height)."""
    bConstrainAspectRatio: AsyncBoolProperty
    """If true, black bars will be added if the destination view has a different aspect ratio than this camera requested."""
    bUseFieldOfViewForLOD: AsyncBoolProperty
    """If true, account for the field of view angle when computing which level of detail to use for meshes."""
    bUsePawnControlRotation: AsyncBoolProperty
    """If this camera component is placed on a pawn, should it use the view/control rotation of the pawn where possible?"""
    ProjectionMode: Property[AsyncValuePath[ECameraProjectionMode, ECameraProjectionMode_in], ECameraProjectionMode_in]
    """The type of camera."""

class UCameraComponent_send(USceneComponent_send):
    """UCameraComponent under ``send_``: no function answers."""
    def GetCameraView(self, DeltaTime: float | Future[float]) -> None:
        """Returns the camera's point of view."""
    def SetAspectRatio(self, InAspectRatio: float | Future[float]) -> None:
        """Sets the aspect ratio."""
    def SetConstraintAspectRatio(self, bInConstrainAspectRatio: bool | Future[bool]) -> None:
        """Sets whether the aspect ratio is constrained."""
    def SetFieldOfView(self, InFieldOfView: float | Future[float]) -> None:
        """Sets the horizontal field of view, in degrees."""
    def SetOrthoFarClipPlane(self, InOrthoFarClipPlane: float | Future[float]) -> None:
        """Sets the far plane distance of the orthographic view, in centimetres."""
    def SetOrthoNearClipPlane(self, InOrthoNearClipPlane: float | Future[float]) -> None:
        """Sets the near plane distance of the orthographic view, in centimetres."""
    def SetOrthoWidth(self, InOrthoWidth: float | Future[float]) -> None:
        """Sets the width of the orthographic view, in centimetres."""
    def SetProjectionMode(self, InProjectionMode: ECameraProjectionMode_in) -> None:
        """Sets the type of camera."""
    def SetUseFieldOfViewForLOD(self, bInUseFieldOfViewForLOD: bool | Future[bool]) -> None:
        """Sets whether the field of view counts for the level of detail."""
    FieldOfView: SendFloatProperty
    OrthoWidth: SendFloatProperty
    OrthoNearClipPlane: SendFloatProperty
    OrthoFarClipPlane: SendFloatProperty
    AspectRatio: SendFloatProperty
    bConstrainAspectRatio: SendBoolProperty
    bUseFieldOfViewForLOD: SendBoolProperty
    bUsePawnControlRotation: SendBoolProperty
    ProjectionMode: SendProperty[ECameraProjectionMode_in]

class UCameraComponent(UCameraComponent_members, USceneComponent):
    """A point of view and a lens; actors that have an active one are seen through it. It looks along the local X
    axis. Epic page: UCameraComponent.

    Unreal: /Script/Engine.CameraComponent
    """
    @property
    def async_(self) -> UCameraComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UCameraComponent_send:
        """The same functions and variables, fire-and-forget."""

class UCameraComponent_path(ObjectPath[UCameraComponent, UCameraComponent_async_path, UCameraComponent_send], UCameraComponent_members):
    """A variable that refers to an object of UCameraComponent: its path."""

class UCameraComponent_async_path(AsyncObjectPath[UCameraComponent], UCameraComponent_async):
    """The same under ``async_``."""
