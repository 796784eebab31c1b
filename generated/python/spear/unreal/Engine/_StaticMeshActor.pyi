# generated, do not edit (Engine: Public/Engine/StaticMeshActor.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath, Property, SendProperty
from ._Actor import AActor, AActor_async, AActor_members, AActor_send
from ._EngineTypes import EComponentMobility_in
from ._StaticMeshComponent import UStaticMeshComponent, UStaticMeshComponent_async_path, UStaticMeshComponent_path

class AStaticMeshActor_members(AActor_members):
    """Functions and variables of AStaticMeshActor."""
    def SetMobility(self, InMobility: EComponentMobility_in) -> None:
        """Sets how often the mesh is allowed to move.

        Unreal: AStaticMeshActor.SetMobility
        """
    StaticMeshComponent: Property[UStaticMeshComponent_path, UStaticMeshComponent | Future[UStaticMeshComponent] | None]
    """The mesh's component, the root of this actor.

    Unreal: AStaticMeshActor.StaticMeshComponent (UStaticMeshComponent*)
    """

class AStaticMeshActor_async(AActor_async):
    """AStaticMeshActor under ``async_``: each function gives a future."""
    def SetMobility(self, InMobility: EComponentMobility_in) -> Future[None]:
        """Sets how often the mesh is allowed to move."""
    StaticMeshComponent: Property[UStaticMeshComponent_async_path, UStaticMeshComponent | Future[UStaticMeshComponent] | None]
    """The mesh's component, the root of this actor."""

class AStaticMeshActor_send(AActor_send):
    """AStaticMeshActor under ``send_``: no function answers."""
    def SetMobility(self, InMobility: EComponentMobility_in) -> None:
        """Sets how often the mesh is allowed to move."""
    StaticMeshComponent: SendProperty[UStaticMeshComponent | Future[UStaticMeshComponent] | None]

class AStaticMeshActor(AStaticMeshActor_members, AActor):
    """An actor that shows a static mesh; static by default. Epic page: AStaticMeshActor.

    Unreal: /Script/Engine.StaticMeshActor
    """
    @property
    def async_(self) -> AStaticMeshActor_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> AStaticMeshActor_send:
        """The same functions and variables, fire-and-forget."""

class AStaticMeshActor_path(ObjectPath[AStaticMeshActor, AStaticMeshActor_async_path, AStaticMeshActor_send], AStaticMeshActor_members):
    """A variable that refers to an object of AStaticMeshActor: its path."""

class AStaticMeshActor_async_path(AsyncObjectPath[AStaticMeshActor], AStaticMeshActor_async):
    """The same under ``async_``."""
