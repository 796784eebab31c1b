# generated, do not edit (Engine: Public/Components/StaticMeshComponent.h)
from typing import NamedTuple
from spear.typing import AsyncBoolProperty, AsyncObjectPath, BoolProperty, Future, ObjectPath, Property, SendBoolProperty, SendProperty
from ..CoreUObject._NoExportTypes import FVector
from ._MeshComponent import UMeshComponent, UMeshComponent_async, UMeshComponent_members, UMeshComponent_send
from ._StaticMesh import UStaticMesh, UStaticMesh_async_path, UStaticMesh_path

class UStaticMeshComponent_GetLocalBounds_Result(NamedTuple):
    """Results of UStaticMeshComponent.GetLocalBounds."""
    Min: FVector
    Max: FVector

class UStaticMeshComponent_members(UMeshComponent_members):
    """Functions and variables of UStaticMeshComponent."""
    def GetLocalBounds(self) -> UStaticMeshComponent_GetLocalBounds_Result:
        """Gets the corners of the mesh's box, in the component's space, in centimetres.

        Unreal: UStaticMeshComponent.GetLocalBounds
        """
    def SetReverseCulling(self, ReverseCulling: bool | Future[bool]) -> None:
        """Controls whether the static mesh component's backface culling should be reversed.

        Unreal: UStaticMeshComponent.SetReverseCulling
        """
    def SetStaticMesh(self, NewMesh: UStaticMesh | Future[UStaticMesh]) -> bool:
        """Changes the mesh used by this instance; refused for a registered static component in a game. Returns whether
        it changed.

        Unreal: UStaticMeshComponent.SetStaticMesh
        """
    StaticMesh: Property[UStaticMesh_path, UStaticMesh | Future[UStaticMesh] | None]
    """The static mesh that this component uses to render. Change it with SetStaticMesh.

    Unreal: UStaticMeshComponent.StaticMesh (UStaticMesh*)
    """
    bReverseCulling: BoolProperty
    """Controls whether the static mesh component's backface culling should be reversed.

    Unreal: UStaticMeshComponent.bReverseCulling (bool)
    """

class UStaticMeshComponent_async(UMeshComponent_async):
    """UStaticMeshComponent under ``async_``: each function gives a future."""
    def GetLocalBounds(self) -> Future[UStaticMeshComponent_GetLocalBounds_Result]:
        """Gets the corners of the mesh's box, in the component's space, in centimetres."""
    def SetReverseCulling(self, ReverseCulling: bool | Future[bool]) -> Future[None]:
        """Controls whether the static mesh component's backface culling should be reversed."""
    def SetStaticMesh(self, NewMesh: UStaticMesh | Future[UStaticMesh]) -> Future[bool]:
        """Changes the mesh used by this instance; refused for a registered static component in a game."""
    StaticMesh: Property[UStaticMesh_async_path, UStaticMesh | Future[UStaticMesh] | None]
    """The static mesh that this component uses to render."""
    bReverseCulling: AsyncBoolProperty
    """Controls whether the static mesh component's backface culling should be reversed."""

class UStaticMeshComponent_send(UMeshComponent_send):
    """UStaticMeshComponent under ``send_``: no function answers."""
    def GetLocalBounds(self) -> None:
        """Gets the corners of the mesh's box, in the component's space, in centimetres."""
    def SetReverseCulling(self, ReverseCulling: bool | Future[bool]) -> None:
        """Controls whether the static mesh component's backface culling should be reversed."""
    def SetStaticMesh(self, NewMesh: UStaticMesh | Future[UStaticMesh]) -> None:
        """Changes the mesh used by this instance; refused for a registered static component in a game."""
    StaticMesh: SendProperty[UStaticMesh | Future[UStaticMesh] | None]
    bReverseCulling: SendBoolProperty

class UStaticMeshComponent(UStaticMeshComponent_members, UMeshComponent):
    """Shows a UStaticMesh. Epic page: UStaticMeshComponent.

    Unreal: /Script/Engine.StaticMeshComponent
    """
    @property
    def async_(self) -> UStaticMeshComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UStaticMeshComponent_send:
        """The same functions and variables, fire-and-forget."""

class UStaticMeshComponent_path(ObjectPath[UStaticMeshComponent, UStaticMeshComponent_async_path, UStaticMeshComponent_send], UStaticMeshComponent_members):
    """A variable that refers to an object of UStaticMeshComponent: its path."""

class UStaticMeshComponent_async_path(AsyncObjectPath[UStaticMeshComponent], UStaticMeshComponent_async):
    """The same under ``async_``."""
