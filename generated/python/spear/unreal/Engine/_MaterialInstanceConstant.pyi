# generated, do not edit (Engine: Public/Materials/MaterialInstanceConstant.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath
from ..CoreUObject._NoExportTypes import FLinearColor
from ._MaterialInstance import UMaterialInstance, UMaterialInstance_async, UMaterialInstance_members, UMaterialInstance_send
from ._Texture import UTexture

class UMaterialInstanceConstant_members(UMaterialInstance_members):
    """Functions and variables of UMaterialInstanceConstant."""
    def K2_GetScalarParameterValue(self, ParameterName: str | Future[str]) -> float:
        """Value of a scalar parameter, 0 if there is none.

        Unreal: UMaterialInstanceConstant.K2_GetScalarParameterValue
        """
    def K2_GetTextureParameterValue(self, ParameterName: str | Future[str]) -> UTexture | None:
        """Value of a texture parameter, null if there is none.

        Unreal: UMaterialInstanceConstant.K2_GetTextureParameterValue
        """
    def K2_GetVectorParameterValue(self, ParameterName: str | Future[str]) -> FLinearColor:
        """Value of a vector parameter, transparent black if there is none.

        Unreal: UMaterialInstanceConstant.K2_GetVectorParameterValue
        """

class UMaterialInstanceConstant_async(UMaterialInstance_async):
    """UMaterialInstanceConstant under ``async_``: each function gives a future."""
    def K2_GetScalarParameterValue(self, ParameterName: str | Future[str]) -> Future[float]:
        """Value of a scalar parameter, 0 if there is none."""
    def K2_GetTextureParameterValue(self, ParameterName: str | Future[str]) -> Future[UTexture | None]:
        """Value of a texture parameter, null if there is none."""
    def K2_GetVectorParameterValue(self, ParameterName: str | Future[str]) -> Future[FLinearColor]:
        """Value of a vector parameter, transparent black if there is none."""

class UMaterialInstanceConstant_send(UMaterialInstance_send):
    """UMaterialInstanceConstant under ``send_``: no function answers."""
    def K2_GetScalarParameterValue(self, ParameterName: str | Future[str]) -> None:
        """Value of a scalar parameter, 0 if there is none."""
    def K2_GetTextureParameterValue(self, ParameterName: str | Future[str]) -> None:
        """Value of a texture parameter, null if there is none."""
    def K2_GetVectorParameterValue(self, ParameterName: str | Future[str]) -> None:
        """Value of a vector parameter, transparent black if there is none."""

class UMaterialInstanceConstant(UMaterialInstanceConstant_members, UMaterialInstance):
    """A material instance that is an asset and does not change while the world runs (UE: UMaterialInstanceConstant).
    Materials of a loaded scene are of this class; to change one, put a UMaterialInstanceDynamic over it.

    Unreal: /Script/Engine.MaterialInstanceConstant
    """
    @property
    def async_(self) -> UMaterialInstanceConstant_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UMaterialInstanceConstant_send:
        """The same functions and variables, fire-and-forget."""

class UMaterialInstanceConstant_path(ObjectPath[UMaterialInstanceConstant, UMaterialInstanceConstant_async_path, UMaterialInstanceConstant_send], UMaterialInstanceConstant_members):
    """A variable that refers to an object of UMaterialInstanceConstant: its path."""

class UMaterialInstanceConstant_async_path(AsyncObjectPath[UMaterialInstanceConstant], UMaterialInstanceConstant_async):
    """The same under ``async_``."""
