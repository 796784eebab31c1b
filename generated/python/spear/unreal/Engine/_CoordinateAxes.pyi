# generated, do not edit (Engine: Public/Engine/CoordinateAxes.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath, Property, SendProperty
from ._Actor import AActor, AActor_async, AActor_members, AActor_send
from ._SceneComponent import USceneComponent, USceneComponent_async_path, USceneComponent_path
from ._StaticMeshComponent import UStaticMeshComponent, UStaticMeshComponent_async_path, UStaticMeshComponent_path

class ACoordinateAxes_members(AActor_members):
    """Functions and variables of ACoordinateAxes."""
    AxesRoot: Property[USceneComponent_path, USceneComponent | Future[USceneComponent] | None]
    """The root: its location and rotation are what the arrows show.

    Unreal: ACoordinateAxes.AxesRoot (USceneComponent*)
    """
    XAxis: Property[UStaticMeshComponent_path, UStaticMeshComponent | Future[UStaticMeshComponent] | None]
    """Red arrow along +X.

    Unreal: ACoordinateAxes.XAxis (UStaticMeshComponent*)
    """
    YAxis: Property[UStaticMeshComponent_path, UStaticMeshComponent | Future[UStaticMeshComponent] | None]
    """Green arrow along +Y.

    Unreal: ACoordinateAxes.YAxis (UStaticMeshComponent*)
    """
    ZAxis: Property[UStaticMeshComponent_path, UStaticMeshComponent | Future[UStaticMeshComponent] | None]
    """Blue arrow along +Z.

    Unreal: ACoordinateAxes.ZAxis (UStaticMeshComponent*)
    """

class ACoordinateAxes_async(AActor_async):
    """ACoordinateAxes under ``async_``: each function gives a future."""
    AxesRoot: Property[USceneComponent_async_path, USceneComponent | Future[USceneComponent] | None]
    """The root: its location and rotation are what the arrows show."""
    XAxis: Property[UStaticMeshComponent_async_path, UStaticMeshComponent | Future[UStaticMeshComponent] | None]
    """Red arrow along +X."""
    YAxis: Property[UStaticMeshComponent_async_path, UStaticMeshComponent | Future[UStaticMeshComponent] | None]
    """Green arrow along +Y."""
    ZAxis: Property[UStaticMeshComponent_async_path, UStaticMeshComponent | Future[UStaticMeshComponent] | None]
    """Blue arrow along +Z."""

class ACoordinateAxes_send(AActor_send):
    """ACoordinateAxes under ``send_``: no function answers."""
    AxesRoot: SendProperty[USceneComponent | Future[USceneComponent] | None]
    XAxis: SendProperty[UStaticMeshComponent | Future[UStaticMeshComponent] | None]
    YAxis: SendProperty[UStaticMeshComponent | Future[UStaticMeshComponent] | None]
    ZAxis: SendProperty[UStaticMeshComponent | Future[UStaticMeshComponent] | None]

class ACoordinateAxes(ACoordinateAxes_members, AActor):
    """Three arrows that show where an actor is and how it is turned: X red, Y green, Z blue, each 100 centimetres
    long at scale 1.

    Embedded engine only. The arrows are UStaticMeshComponents below a plain root component, with the mesh
    "/Engine/BasicShapes/Arrow.Arrow" (along +X) and unlit-looking emissive materials.

    Unreal: /Script/Engine.CoordinateAxes
    """
    @property
    def async_(self) -> ACoordinateAxes_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> ACoordinateAxes_send:
        """The same functions and variables, fire-and-forget."""

class ACoordinateAxes_path(ObjectPath[ACoordinateAxes, ACoordinateAxes_async_path, ACoordinateAxes_send], ACoordinateAxes_members):
    """A variable that refers to an object of ACoordinateAxes: its path."""

class ACoordinateAxes_async_path(AsyncObjectPath[ACoordinateAxes], ACoordinateAxes_async):
    """The same under ``async_``."""
