# generated, do not edit (Engine: Public/Materials/MaterialInstanceDynamic.h)
from spear.typing import AsyncObjectPath, Future, ObjectPath
from ..CoreUObject._NoExportTypes import FLinearColor, FLinearColor_in
from ._MaterialInstance import UMaterialInstance, UMaterialInstance_async, UMaterialInstance_members, UMaterialInstance_send
from ._MaterialTypes import FMaterialParameterInfo_in
from ._Texture import UTexture

class UMaterialInstanceDynamic_members(UMaterialInstance_members):
    """Functions and variables of UMaterialInstanceDynamic."""
    def K2_GetScalarParameterValue(self, ParameterName: str | Future[str]) -> float:
        """Value of a scalar (float) parameter, 0 if there is none.

        Unreal: UMaterialInstanceDynamic.K2_GetScalarParameterValue
        """
    def K2_GetTextureParameterValue(self, ParameterName: str | Future[str]) -> UTexture | None:
        """Value of a texture parameter, null if there is none.

        Unreal: UMaterialInstanceDynamic.K2_GetTextureParameterValue
        """
    def K2_GetVectorParameterValue(self, ParameterName: str | Future[str]) -> FLinearColor:
        """Value of a vector parameter, transparent black if there is none.

        Unreal: UMaterialInstanceDynamic.K2_GetVectorParameterValue
        """
    def K2_InterpolateMaterialInstanceParams(self, SourceA: UMaterialInstance | Future[UMaterialInstance], SourceB: UMaterialInstance | Future[UMaterialInstance], Alpha: float | Future[float]) -> None:
        """Blends the scalar and vector parameters of two instances of one material into this instance; a null source is
        ignored.

        Args:
            Alpha: 0 gives SourceA, 1 gives SourceB, values outside 0..1 extrapolate.

        Unreal: UMaterialInstanceDynamic.K2_InterpolateMaterialInstanceParams
        """
    def SetScalarParameterValue(self, ParameterName: str | Future[str], Value: float | Future[float]) -> None:
        """Overrides a scalar (float) parameter.

        Unreal: UMaterialInstanceDynamic.SetScalarParameterValue
        """
    def SetScalarParameterValueByInfo(self, ParameterInfo: FMaterialParameterInfo_in, Value: float | Future[float]) -> None:
        """Overrides a scalar (float) parameter.

        Unreal: UMaterialInstanceDynamic.SetScalarParameterValueByInfo
        """
    def SetTextureParameterValue(self, ParameterName: str | Future[str], Value: UTexture | Future[UTexture]) -> None:
        """Overrides a texture parameter; null counts as white.

        Unreal: UMaterialInstanceDynamic.SetTextureParameterValue
        """
    def SetTextureParameterValueByInfo(self, ParameterInfo: FMaterialParameterInfo_in, Value: UTexture | Future[UTexture]) -> None:
        """Overrides a texture parameter; null counts as white.

        Unreal: UMaterialInstanceDynamic.SetTextureParameterValueByInfo
        """
    def SetVectorParameterValue(self, ParameterName: str | Future[str], Value: FLinearColor_in) -> None:
        """Overrides a vector parameter; colours are linear.

        Unreal: UMaterialInstanceDynamic.SetVectorParameterValue
        """
    def SetVectorParameterValueByInfo(self, ParameterInfo: FMaterialParameterInfo_in, Value: FLinearColor_in) -> None:
        """Overrides a vector parameter; colours are linear.

        Unreal: UMaterialInstanceDynamic.SetVectorParameterValueByInfo
        """

class UMaterialInstanceDynamic_async(UMaterialInstance_async):
    """UMaterialInstanceDynamic under ``async_``: each function gives a future."""
    def K2_GetScalarParameterValue(self, ParameterName: str | Future[str]) -> Future[float]:
        """Value of a scalar (float) parameter, 0 if there is none."""
    def K2_GetTextureParameterValue(self, ParameterName: str | Future[str]) -> Future[UTexture | None]:
        """Value of a texture parameter, null if there is none."""
    def K2_GetVectorParameterValue(self, ParameterName: str | Future[str]) -> Future[FLinearColor]:
        """Value of a vector parameter, transparent black if there is none."""
    def K2_InterpolateMaterialInstanceParams(self, SourceA: UMaterialInstance | Future[UMaterialInstance], SourceB: UMaterialInstance | Future[UMaterialInstance], Alpha: float | Future[float]) -> Future[None]:
        """Blends the scalar and vector parameters of two instances of one material into this instance; a null source is ignored."""
    def SetScalarParameterValue(self, ParameterName: str | Future[str], Value: float | Future[float]) -> Future[None]:
        """Overrides a scalar (float) parameter."""
    def SetScalarParameterValueByInfo(self, ParameterInfo: FMaterialParameterInfo_in, Value: float | Future[float]) -> Future[None]:
        """Overrides a scalar (float) parameter."""
    def SetTextureParameterValue(self, ParameterName: str | Future[str], Value: UTexture | Future[UTexture]) -> Future[None]:
        """Overrides a texture parameter; null counts as white."""
    def SetTextureParameterValueByInfo(self, ParameterInfo: FMaterialParameterInfo_in, Value: UTexture | Future[UTexture]) -> Future[None]:
        """Overrides a texture parameter; null counts as white."""
    def SetVectorParameterValue(self, ParameterName: str | Future[str], Value: FLinearColor_in) -> Future[None]:
        """Overrides a vector parameter; colours are linear."""
    def SetVectorParameterValueByInfo(self, ParameterInfo: FMaterialParameterInfo_in, Value: FLinearColor_in) -> Future[None]:
        """Overrides a vector parameter; colours are linear."""

class UMaterialInstanceDynamic_send(UMaterialInstance_send):
    """UMaterialInstanceDynamic under ``send_``: no function answers."""
    def K2_GetScalarParameterValue(self, ParameterName: str | Future[str]) -> None:
        """Value of a scalar (float) parameter, 0 if there is none."""
    def K2_GetTextureParameterValue(self, ParameterName: str | Future[str]) -> None:
        """Value of a texture parameter, null if there is none."""
    def K2_GetVectorParameterValue(self, ParameterName: str | Future[str]) -> None:
        """Value of a vector parameter, transparent black if there is none."""
    def K2_InterpolateMaterialInstanceParams(self, SourceA: UMaterialInstance | Future[UMaterialInstance], SourceB: UMaterialInstance | Future[UMaterialInstance], Alpha: float | Future[float]) -> None:
        """Blends the scalar and vector parameters of two instances of one material into this instance; a null source is ignored."""
    def SetScalarParameterValue(self, ParameterName: str | Future[str], Value: float | Future[float]) -> None:
        """Overrides a scalar (float) parameter."""
    def SetScalarParameterValueByInfo(self, ParameterInfo: FMaterialParameterInfo_in, Value: float | Future[float]) -> None:
        """Overrides a scalar (float) parameter."""
    def SetTextureParameterValue(self, ParameterName: str | Future[str], Value: UTexture | Future[UTexture]) -> None:
        """Overrides a texture parameter; null counts as white."""
    def SetTextureParameterValueByInfo(self, ParameterInfo: FMaterialParameterInfo_in, Value: UTexture | Future[UTexture]) -> None:
        """Overrides a texture parameter; null counts as white."""
    def SetVectorParameterValue(self, ParameterName: str | Future[str], Value: FLinearColor_in) -> None:
        """Overrides a vector parameter; colours are linear."""
    def SetVectorParameterValueByInfo(self, ParameterInfo: FMaterialParameterInfo_in, Value: FLinearColor_in) -> None:
        """Overrides a vector parameter; colours are linear."""

class UMaterialInstanceDynamic(UMaterialInstanceDynamic_members, UMaterialInstance):
    """A material instance whose parameters change while the world runs (UE: UMaterialInstanceDynamic,
    Materials/MaterialInstanceDynamic.h). The parameter names are in Materials/Material.h; setting a name the
    material does not have is allowed, as in UE, and has no effect on the surface.

    Unreal: /Script/Engine.MaterialInstanceDynamic
    """
    @property
    def async_(self) -> UMaterialInstanceDynamic_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UMaterialInstanceDynamic_send:
        """The same functions and variables, fire-and-forget."""

class UMaterialInstanceDynamic_path(ObjectPath[UMaterialInstanceDynamic, UMaterialInstanceDynamic_async_path, UMaterialInstanceDynamic_send], UMaterialInstanceDynamic_members):
    """A variable that refers to an object of UMaterialInstanceDynamic: its path."""

class UMaterialInstanceDynamic_async_path(AsyncObjectPath[UMaterialInstanceDynamic], UMaterialInstanceDynamic_async):
    """The same under ``async_``."""
