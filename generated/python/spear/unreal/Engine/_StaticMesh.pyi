# generated, do not edit (Engine: Public/Engine/StaticMesh.h)
from collections.abc import Sequence
from typing import TypeAlias, TypedDict
from spear.structs import Struct
from spear.typing import (
    ArrayPath, AsyncArrayPath, AsyncObjectPath, AsyncStrProperty, AsyncValuePath, Future, ObjectPath, Property, SendProperty, StrProperty, StructPath,
)
from ..CoreUObject._NoExportTypes import FBox, FBoxSphereBounds
from ._MaterialInterface import UMaterialInterface, UMaterialInterface_async_path, UMaterialInterface_path
from ._StreamableRenderAsset import UStreamableRenderAsset, UStreamableRenderAsset_async, UStreamableRenderAsset_members, UStreamableRenderAsset_send

class FStaticMaterial(Struct):
    """One material slot of a static mesh (UE: FStaticMaterial, Engine/StaticMesh.h).

    Unreal: /Script/Engine.StaticMaterial
    """
    def __init__(self, MaterialInterface: UMaterialInterface | None = ..., MaterialSlotName: str = ...) -> None: ...
    MaterialInterface: UMaterialInterface | None
    """The material that sections of this slot are drawn with."""
    MaterialSlotName: str
    """Name by which the slot is found, see UStaticMesh::GetMaterialIndex."""

class FStaticMaterial_dict(TypedDict, total=False):
    """Any of the fields of FStaticMaterial: what a dictionary for it may hold."""
    MaterialInterface: UMaterialInterface | Future[UMaterialInterface] | None
    MaterialSlotName: str | Future[str]

FStaticMaterial_in: TypeAlias = FStaticMaterial | FStaticMaterial_dict | Future[FStaticMaterial]
"""What stands for FStaticMaterial as an argument: itself, a dictionary of its fields, a future."""

class FStaticMaterial_path(StructPath[FStaticMaterial, FStaticMaterial_in, FStaticMaterial_async]):
    """A variable of type FStaticMaterial: its path."""
    MaterialInterface: Property[UMaterialInterface_path, UMaterialInterface | Future[UMaterialInterface] | None]
    """The material that sections of this slot are drawn with."""
    MaterialSlotName: StrProperty
    """Name by which the slot is found, see UStaticMesh::GetMaterialIndex."""

class FStaticMaterial_async(AsyncValuePath[FStaticMaterial, FStaticMaterial_in]):
    """The same under ``async_``."""
    MaterialInterface: Property[UMaterialInterface_async_path, UMaterialInterface | Future[UMaterialInterface] | None]
    MaterialSlotName: AsyncStrProperty

class UStaticMesh_members(UStreamableRenderAsset_members):
    """Functions and variables of UStaticMesh."""
    def AddMaterial(self, Material: UMaterialInterface | Future[UMaterialInterface]) -> str:
        """Adds a material slot and returns its name: "Slot_<n>", made unique among the slots.

        Unreal: UStaticMesh.AddMaterial
        """
    def GetBoundingBox(self) -> FBox:
        """Axis-aligned box of the mesh in mesh space, centimetres. An empty mesh gives an empty box at the origin.

        Unreal: UStaticMesh.GetBoundingBox
        """
    def GetBounds(self) -> FBoxSphereBounds:
        """Bounds of the mesh in mesh space: box and sphere round the same centre, centimetres.

        Unreal: UStaticMesh.GetBounds
        """
    def GetMaterial(self, MaterialIndex: int | Future[int]) -> UMaterialInterface | None:
        """Material of a slot, or null if there is no such slot.

        Unreal: UStaticMesh.GetMaterial
        """
    def GetMaterialIndex(self, MaterialSlotName: str | Future[str]) -> int:
        """Index of the slot with this name, or INDEX_NONE.

        Unreal: UStaticMesh.GetMaterialIndex
        """
    def GetNumLODs(self) -> int:
        """Number of levels of detail: 1, or 0 for a mesh without triangles.

        Unreal: UStaticMesh.GetNumLODs
        """
    def GetNumSections(self, InLOD: int | Future[int]) -> int:
        """Number of sections (runs of triangles of one material slot) of a level of detail; 0 for one that does not
        exist.

        Unreal: UStaticMesh.GetNumSections
        """
    def GetNumTriangles(self, LODIndex: int | Future[int]) -> int:
        """Number of triangles of a level of detail; 0 for a level that does not exist.

        Unreal: UStaticMesh.GetNumTriangles
        """
    def GetStaticMaterials(self) -> list[FStaticMaterial]:
        """The material slots.

        Unreal: UStaticMesh.GetStaticMaterials
        """
    def SetMaterial(self, MaterialIndex: int | Future[int], NewMaterial: UMaterialInterface | Future[UMaterialInterface]) -> None:
        """Replaces the material of an existing slot; other indices are ignored.

        Unreal: UStaticMesh.SetMaterial
        """
    def SetStaticMaterials(self, InStaticMaterials: Sequence[FStaticMaterial_in] | Future[list[FStaticMaterial]]) -> None:
        """Replaces all material slots.

        Unreal: UStaticMesh.SetStaticMaterials
        """
    StaticMaterials: Property[ArrayPath[FStaticMaterial, FStaticMaterial_in, FStaticMaterial_path, FStaticMaterial_async], Sequence[FStaticMaterial_in] | Future[list[FStaticMaterial]]]
    """Unreal: UStaticMesh.StaticMaterials (TArray<FStaticMaterial>)"""

class UStaticMesh_async(UStreamableRenderAsset_async):
    """UStaticMesh under ``async_``: each function gives a future."""
    def AddMaterial(self, Material: UMaterialInterface | Future[UMaterialInterface]) -> Future[str]:
        """Adds a material slot and returns its name: "Slot_<n>", made unique among the slots."""
    def GetBoundingBox(self) -> Future[FBox]:
        """Axis-aligned box of the mesh in mesh space, centimetres."""
    def GetBounds(self) -> Future[FBoxSphereBounds]:
        """Bounds of the mesh in mesh space: box and sphere round the same centre, centimetres."""
    def GetMaterial(self, MaterialIndex: int | Future[int]) -> Future[UMaterialInterface | None]:
        """Material of a slot, or null if there is no such slot."""
    def GetMaterialIndex(self, MaterialSlotName: str | Future[str]) -> Future[int]:
        """Index of the slot with this name, or INDEX_NONE."""
    def GetNumLODs(self) -> Future[int]:
        """Number of levels of detail: 1, or 0 for a mesh without triangles."""
    def GetNumSections(self, InLOD: int | Future[int]) -> Future[int]:
        """Number of sections (runs of triangles of one material slot) of a level of detail; 0 for one that does not exist."""
    def GetNumTriangles(self, LODIndex: int | Future[int]) -> Future[int]:
        """Number of triangles of a level of detail; 0 for a level that does not exist."""
    def GetStaticMaterials(self) -> Future[list[FStaticMaterial]]:
        """The material slots."""
    def SetMaterial(self, MaterialIndex: int | Future[int], NewMaterial: UMaterialInterface | Future[UMaterialInterface]) -> Future[None]:
        """Replaces the material of an existing slot; other indices are ignored."""
    def SetStaticMaterials(self, InStaticMaterials: Sequence[FStaticMaterial_in] | Future[list[FStaticMaterial]]) -> Future[None]:
        """Replaces all material slots."""
    StaticMaterials: Property[AsyncArrayPath[FStaticMaterial, FStaticMaterial_in, FStaticMaterial_async], Sequence[FStaticMaterial_in] | Future[list[FStaticMaterial]]]

class UStaticMesh_send(UStreamableRenderAsset_send):
    """UStaticMesh under ``send_``: no function answers."""
    def AddMaterial(self, Material: UMaterialInterface | Future[UMaterialInterface]) -> None:
        """Adds a material slot and returns its name: "Slot_<n>", made unique among the slots."""
    def GetBoundingBox(self) -> None:
        """Axis-aligned box of the mesh in mesh space, centimetres."""
    def GetBounds(self) -> None:
        """Bounds of the mesh in mesh space: box and sphere round the same centre, centimetres."""
    def GetMaterial(self, MaterialIndex: int | Future[int]) -> None:
        """Material of a slot, or null if there is no such slot."""
    def GetMaterialIndex(self, MaterialSlotName: str | Future[str]) -> None:
        """Index of the slot with this name, or INDEX_NONE."""
    def GetNumLODs(self) -> None:
        """Number of levels of detail: 1, or 0 for a mesh without triangles."""
    def GetNumSections(self, InLOD: int | Future[int]) -> None:
        """Number of sections (runs of triangles of one material slot) of a level of detail; 0 for one that does not exist."""
    def GetNumTriangles(self, LODIndex: int | Future[int]) -> None:
        """Number of triangles of a level of detail; 0 for a level that does not exist."""
    def GetStaticMaterials(self) -> None:
        """The material slots."""
    def SetMaterial(self, MaterialIndex: int | Future[int], NewMaterial: UMaterialInterface | Future[UMaterialInterface]) -> None:
        """Replaces the material of an existing slot; other indices are ignored."""
    def SetStaticMaterials(self, InStaticMaterials: Sequence[FStaticMaterial_in] | Future[list[FStaticMaterial]]) -> None:
        """Replaces all material slots."""
    StaticMaterials: SendProperty[Sequence[FStaticMaterial_in] | Future[list[FStaticMaterial]]]

class UStaticMesh(UStaticMesh_members, UStreamableRenderAsset):
    """A mesh of triangles with material slots and no animation (UE: UStaticMesh, Engine/StaticMesh.h).

    The embedded engine keeps one level of detail, with its triangles in main memory; GetGeometry gives them to
    renderers.

    Unreal: /Script/Engine.StaticMesh
    """
    @property
    def async_(self) -> UStaticMesh_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UStaticMesh_send:
        """The same functions and variables, fire-and-forget."""

class UStaticMesh_path(ObjectPath[UStaticMesh, UStaticMesh_async_path, UStaticMesh_send], UStaticMesh_members):
    """A variable that refers to an object of UStaticMesh: its path."""

class UStaticMesh_async_path(AsyncObjectPath[UStaticMesh], UStaticMesh_async):
    """The same under ``async_``."""
