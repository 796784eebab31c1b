# generated, do not edit (Engine: Public/Camera/CameraActor.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath, Property, SendProperty
from ._Actor import AActor, AActor_async, AActor_members, AActor_send
from ._CameraComponent import UCameraComponent, UCameraComponent_async_path, UCameraComponent_path
from ._SceneComponent import USceneComponent, USceneComponent_async_path, USceneComponent_path

class ACameraActor_members(AActor_members):
    """Functions and variables of ACameraActor."""
    CameraComponent: Property[UCameraComponent_path, UCameraComponent | Future[UCameraComponent] | None]
    """The camera component for this camera.

    Unreal: ACameraActor.CameraComponent (UCameraComponent*)
    """
    SceneComponent: Property[USceneComponent_path, USceneComponent | Future[USceneComponent] | None]
    """The root of this actor.

    Unreal: ACameraActor.SceneComponent (USceneComponent*)
    """

class ACameraActor_async(AActor_async):
    """ACameraActor under ``async_``: each function gives a future."""
    CameraComponent: Property[UCameraComponent_async_path, UCameraComponent | Future[UCameraComponent] | None]
    """The camera component for this camera."""
    SceneComponent: Property[USceneComponent_async_path, USceneComponent | Future[USceneComponent] | None]
    """The root of this actor."""

class ACameraActor_send(AActor_send):
    """ACameraActor under ``send_``: no function answers."""
    CameraComponent: SendProperty[UCameraComponent | Future[UCameraComponent] | None]
    SceneComponent: SendProperty[USceneComponent | Future[USceneComponent] | None]

class ACameraActor(ACameraActor_members, AActor):
    """A camera that can be placed in a level. Epic page: ACameraActor.

    Unreal: /Script/Engine.CameraActor
    """
    @property
    def async_(self) -> ACameraActor_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> ACameraActor_send:
        """The same functions and variables, fire-and-forget."""

class ACameraActor_path(ObjectPath[ACameraActor, ACameraActor_async_path, ACameraActor_send], ACameraActor_members):
    """A variable that refers to an object of ACameraActor: its path."""

class ACameraActor_async_path(AsyncObjectPath[ACameraActor], ACameraActor_async):
    """The same under ``async_``."""
