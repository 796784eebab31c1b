# generated, do not edit (Engine: Public/Materials/MaterialInterface.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath
from ..CoreUObject._NoExportTypes import UObject, UObject_async, UObject_members, UObject_send
from ._Material import UMaterial

class UMaterialInterface_members(UObject_members):
    """Functions and variables of UMaterialInterface."""
    def GetBaseMaterial(self) -> UMaterial | None:
        """The material at the root of the chain of instances, null for an instance without parent.

        Unreal: UMaterialInterface.GetBaseMaterial
        """

class UMaterialInterface_async(UObject_async):
    """UMaterialInterface under ``async_``: each function gives a future."""
    def GetBaseMaterial(self) -> Future[UMaterial | None]:
        """The material at the root of the chain of instances, null for an instance without parent."""

class UMaterialInterface_send(UObject_send):
    """UMaterialInterface under ``send_``: no function answers."""
    def GetBaseMaterial(self) -> None:
        """The material at the root of the chain of instances, null for an instance without parent."""

class UMaterialInterface(UMaterialInterface_members, UObject):
    """What can be put on a surface: a material or an instance of one (UE: UMaterialInterface,
    Materials/MaterialInterface.h).

    Unreal: /Script/Engine.MaterialInterface
    """
    @property
    def async_(self) -> UMaterialInterface_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UMaterialInterface_send:
        """The same functions and variables, fire-and-forget."""

class UMaterialInterface_path(ObjectPath[UMaterialInterface, UMaterialInterface_async_path, UMaterialInterface_send], UMaterialInterface_members):
    """A variable that refers to an object of UMaterialInterface: its path."""

class UMaterialInterface_async_path(AsyncObjectPath[UMaterialInterface], UMaterialInterface_async):
    """The same under ``async_``."""
