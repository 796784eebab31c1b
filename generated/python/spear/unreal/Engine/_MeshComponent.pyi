# generated, do not edit (Engine: Public/Components/MeshComponent.h)
from collections.abc import Sequence
from spear.typing import ArrayPath, AsyncArrayPath, AsyncObjectPath, Future, ObjectPath, Property, SendProperty
from ..CoreUObject._NoExportTypes import FVector_in
from ._MaterialInterface import UMaterialInterface, UMaterialInterface_async_path, UMaterialInterface_path
from ._PrimitiveComponent import UPrimitiveComponent, UPrimitiveComponent_async, UPrimitiveComponent_members, UPrimitiveComponent_send

class UMeshComponent_members(UPrimitiveComponent_members):
    """Functions and variables of UMeshComponent."""
    def GetMaterialIndex(self, MaterialSlotName: str | Future[str]) -> int:
        """Returns the index of the slot with that name, or INDEX_NONE.

        Unreal: UMeshComponent.GetMaterialIndex
        """
    def GetMaterialSlotNames(self) -> list[str]:
        """Returns the names of the slots.

        Unreal: UMeshComponent.GetMaterialSlotNames
        """
    def GetMaterials(self) -> list[UMaterialInterface]:
        """Returns the materials in use, one for each slot.

        Unreal: UMeshComponent.GetMaterials
        """
    def IsMaterialSlotNameValid(self, MaterialSlotName: str | Future[str]) -> bool:
        """Whether there is a slot with that name.

        Unreal: UMeshComponent.IsMaterialSlotNameValid
        """
    def SetOverlayMaterial(self, NewOverlayMaterial: UMaterialInterface | Future[UMaterialInterface]) -> None:
        """Sets the translucent material to blend on top of this mesh.

        Unreal: UMeshComponent.SetOverlayMaterial
        """
    def SetScalarParameterValueOnMaterials(self, ParameterName: str | Future[str], ParameterValue: float | Future[float]) -> None:
        """Sets a scalar parameter on every dynamic material instance of this component, making instances where there are
        none.

        Unreal: UMeshComponent.SetScalarParameterValueOnMaterials
        """
    def SetVectorParameterValueOnMaterials(self, ParameterName: str | Future[str], ParameterValue: FVector_in) -> None:
        """Sets a vector parameter on every dynamic material instance of this component, making instances where there are
        none.

        Unreal: UMeshComponent.SetVectorParameterValueOnMaterials
        """
    OverrideMaterials: Property[ArrayPath[UMaterialInterface | None, UMaterialInterface | Future[UMaterialInterface] | None, UMaterialInterface_path, UMaterialInterface_async_path], Sequence[UMaterialInterface | Future[UMaterialInterface] | None] | Future[list[UMaterialInterface | None]]]
    """Per-component material overrides. These must NOT be set directly or a race condition can occur in UE's
    renderer: use SetMaterial.

    Unreal: UMeshComponent.OverrideMaterials (TArray<UMaterialInterface*>)
    """
    OverlayMaterial: Property[UMaterialInterface_path, UMaterialInterface | Future[UMaterialInterface] | None]
    """Translucent material to blend on top of this mesh.

    Unreal: UMeshComponent.OverlayMaterial (UMaterialInterface*)
    """

class UMeshComponent_async(UPrimitiveComponent_async):
    """UMeshComponent under ``async_``: each function gives a future."""
    def GetMaterialIndex(self, MaterialSlotName: str | Future[str]) -> Future[int]:
        """Returns the index of the slot with that name, or INDEX_NONE."""
    def GetMaterialSlotNames(self) -> Future[list[str]]:
        """Returns the names of the slots."""
    def GetMaterials(self) -> Future[list[UMaterialInterface]]:
        """Returns the materials in use, one for each slot."""
    def IsMaterialSlotNameValid(self, MaterialSlotName: str | Future[str]) -> Future[bool]:
        """Whether there is a slot with that name."""
    def SetOverlayMaterial(self, NewOverlayMaterial: UMaterialInterface | Future[UMaterialInterface]) -> Future[None]:
        """Sets the translucent material to blend on top of this mesh."""
    def SetScalarParameterValueOnMaterials(self, ParameterName: str | Future[str], ParameterValue: float | Future[float]) -> Future[None]:
        """Sets a scalar parameter on every dynamic material instance of this component, making instances where there are none."""
    def SetVectorParameterValueOnMaterials(self, ParameterName: str | Future[str], ParameterValue: FVector_in) -> Future[None]:
        """Sets a vector parameter on every dynamic material instance of this component, making instances where there are none."""
    OverrideMaterials: Property[AsyncArrayPath[UMaterialInterface | None, UMaterialInterface | Future[UMaterialInterface] | None, UMaterialInterface_async_path], Sequence[UMaterialInterface | Future[UMaterialInterface] | None] | Future[list[UMaterialInterface | None]]]
    """Per-component material overrides."""
    OverlayMaterial: Property[UMaterialInterface_async_path, UMaterialInterface | Future[UMaterialInterface] | None]
    """Translucent material to blend on top of this mesh."""

class UMeshComponent_send(UPrimitiveComponent_send):
    """UMeshComponent under ``send_``: no function answers."""
    def GetMaterialIndex(self, MaterialSlotName: str | Future[str]) -> None:
        """Returns the index of the slot with that name, or INDEX_NONE."""
    def GetMaterialSlotNames(self) -> None:
        """Returns the names of the slots."""
    def GetMaterials(self) -> None:
        """Returns the materials in use, one for each slot."""
    def IsMaterialSlotNameValid(self, MaterialSlotName: str | Future[str]) -> None:
        """Whether there is a slot with that name."""
    def SetOverlayMaterial(self, NewOverlayMaterial: UMaterialInterface | Future[UMaterialInterface]) -> None:
        """Sets the translucent material to blend on top of this mesh."""
    def SetScalarParameterValueOnMaterials(self, ParameterName: str | Future[str], ParameterValue: float | Future[float]) -> None:
        """Sets a scalar parameter on every dynamic material instance of this component, making instances where there are none."""
    def SetVectorParameterValueOnMaterials(self, ParameterName: str | Future[str], ParameterValue: FVector_in) -> None:
        """Sets a vector parameter on every dynamic material instance of this component, making instances where there are none."""
    OverrideMaterials: SendProperty[Sequence[UMaterialInterface | Future[UMaterialInterface] | None] | Future[list[UMaterialInterface | None]]]
    OverlayMaterial: SendProperty[UMaterialInterface | Future[UMaterialInterface] | None]

class UMeshComponent(UMeshComponent_members, UPrimitiveComponent):
    """Abstract base for components that render a collection of triangles, with one material for each slot. Epic
    page: UMeshComponent.

    Unreal: /Script/Engine.MeshComponent
    """
    @property
    def async_(self) -> UMeshComponent_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UMeshComponent_send:
        """The same functions and variables, fire-and-forget."""

class UMeshComponent_path(ObjectPath[UMeshComponent, UMeshComponent_async_path, UMeshComponent_send], UMeshComponent_members):
    """A variable that refers to an object of UMeshComponent: its path."""

class UMeshComponent_async_path(AsyncObjectPath[UMeshComponent], UMeshComponent_async):
    """The same under ``async_``."""
