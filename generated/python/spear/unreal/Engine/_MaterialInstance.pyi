# generated, do not edit (Engine: Public/Materials/MaterialInstance.h)
from collections.abc import Sequence
from typing import TypeAlias, TypedDict
from spear.structs import Struct
from spear.typing import (
    ArrayPath, AsyncArrayPath, AsyncBoolProperty, AsyncFloatProperty, AsyncObjectPath, AsyncValuePath, BoolProperty, FloatProperty, Future,
    ObjectPath, Property, SendProperty, StructPath, ValuePath,
)
from ..CoreUObject._NoExportTypes import FLinearColor, FLinearColor_async, FLinearColor_in, FLinearColor_path
from ._BlendMode import EBlendMode, EBlendMode_in
from ._MaterialInterface import (
    UMaterialInterface, UMaterialInterface_async, UMaterialInterface_async_path, UMaterialInterface_members, UMaterialInterface_path,
    UMaterialInterface_send,
)
from ._MaterialTypes import FMaterialParameterInfo, FMaterialParameterInfo_async, FMaterialParameterInfo_in, FMaterialParameterInfo_path
from ._Texture import UTexture, UTexture_async_path, UTexture_path

class FScalarParameterValue(Struct):
    """Overridden scalar parameter (UE: FScalarParameterValue, Materials/MaterialInstance.h).

    Unreal: /Script/Engine.ScalarParameterValue
    """
    def __init__(self, ParameterInfo: FMaterialParameterInfo = ..., ParameterValue: float = ...) -> None: ...
    ParameterInfo: FMaterialParameterInfo
    """Which parameter."""
    ParameterValue: float
    """Its value."""

class FScalarParameterValue_dict(TypedDict, total=False):
    """Any of the fields of FScalarParameterValue: what a dictionary for it may hold."""
    ParameterInfo: FMaterialParameterInfo_in
    ParameterValue: float | Future[float]

FScalarParameterValue_in: TypeAlias = FScalarParameterValue | FScalarParameterValue_dict | Future[FScalarParameterValue]
"""What stands for FScalarParameterValue as an argument: itself, a dictionary of its fields, a future."""

class FScalarParameterValue_path(StructPath[FScalarParameterValue, FScalarParameterValue_in, FScalarParameterValue_async]):
    """A variable of type FScalarParameterValue: its path."""
    ParameterInfo: Property[FMaterialParameterInfo_path, FMaterialParameterInfo_in]
    """Which parameter."""
    ParameterValue: FloatProperty
    """Its value."""

class FScalarParameterValue_async(AsyncValuePath[FScalarParameterValue, FScalarParameterValue_in]):
    """The same under ``async_``."""
    ParameterInfo: Property[FMaterialParameterInfo_async, FMaterialParameterInfo_in]
    ParameterValue: AsyncFloatProperty

class FVectorParameterValue(Struct):
    """Overridden vector parameter (UE: FVectorParameterValue, Materials/MaterialInstance.h).

    Unreal: /Script/Engine.VectorParameterValue
    """
    def __init__(self, ParameterInfo: FMaterialParameterInfo = ..., ParameterValue: FLinearColor = ...) -> None: ...
    ParameterInfo: FMaterialParameterInfo
    """Which parameter."""
    ParameterValue: FLinearColor
    """Its value; colours are linear."""

class FVectorParameterValue_dict(TypedDict, total=False):
    """Any of the fields of FVectorParameterValue: what a dictionary for it may hold."""
    ParameterInfo: FMaterialParameterInfo_in
    ParameterValue: FLinearColor_in

FVectorParameterValue_in: TypeAlias = FVectorParameterValue | FVectorParameterValue_dict | Future[FVectorParameterValue]
"""What stands for FVectorParameterValue as an argument: itself, a dictionary of its fields, a future."""

class FVectorParameterValue_path(StructPath[FVectorParameterValue, FVectorParameterValue_in, FVectorParameterValue_async]):
    """A variable of type FVectorParameterValue: its path."""
    ParameterInfo: Property[FMaterialParameterInfo_path, FMaterialParameterInfo_in]
    """Which parameter."""
    ParameterValue: Property[FLinearColor_path, FLinearColor_in]
    """Its value; colours are linear."""

class FVectorParameterValue_async(AsyncValuePath[FVectorParameterValue, FVectorParameterValue_in]):
    """The same under ``async_``."""
    ParameterInfo: Property[FMaterialParameterInfo_async, FMaterialParameterInfo_in]
    ParameterValue: Property[FLinearColor_async, FLinearColor_in]

class FTextureParameterValue(Struct):
    """Overridden texture parameter (UE: FTextureParameterValue, Materials/MaterialInstance.h).

    Unreal: /Script/Engine.TextureParameterValue
    """
    def __init__(self, ParameterInfo: FMaterialParameterInfo = ..., ParameterValue: UTexture | None = ...) -> None: ...
    ParameterInfo: FMaterialParameterInfo
    """Which parameter."""
    ParameterValue: UTexture | None
    """Its value; null counts as white."""

class FTextureParameterValue_dict(TypedDict, total=False):
    """Any of the fields of FTextureParameterValue: what a dictionary for it may hold."""
    ParameterInfo: FMaterialParameterInfo_in
    ParameterValue: UTexture | Future[UTexture] | None

FTextureParameterValue_in: TypeAlias = FTextureParameterValue | FTextureParameterValue_dict | Future[FTextureParameterValue]
"""What stands for FTextureParameterValue as an argument: itself, a dictionary of its fields, a future."""

class FTextureParameterValue_path(StructPath[FTextureParameterValue, FTextureParameterValue_in, FTextureParameterValue_async]):
    """A variable of type FTextureParameterValue: its path."""
    ParameterInfo: Property[FMaterialParameterInfo_path, FMaterialParameterInfo_in]
    """Which parameter."""
    ParameterValue: Property[UTexture_path, UTexture | Future[UTexture] | None]
    """Its value; null counts as white."""

class FTextureParameterValue_async(AsyncValuePath[FTextureParameterValue, FTextureParameterValue_in]):
    """The same under ``async_``."""
    ParameterInfo: Property[FMaterialParameterInfo_async, FMaterialParameterInfo_in]
    ParameterValue: Property[UTexture_async_path, UTexture | Future[UTexture] | None]

class FMaterialInstanceBasePropertyOverrides(Struct):
    """Properties of the base material that an instance overrides (UE: FMaterialInstanceBasePropertyOverrides,
    Materials/MaterialInstanceBasePropertyOverrides.h).

    Unreal: /Script/Engine.MaterialInstanceBasePropertyOverrides
    """
    def __init__(self, bOverride_OpacityMaskClipValue: bool = ..., bOverride_BlendMode: bool = ..., bOverride_TwoSided: bool = ..., TwoSided: bool = ..., BlendMode: EBlendMode = ..., OpacityMaskClipValue: float = ...) -> None: ...
    bOverride_OpacityMaskClipValue: bool
    """Whether OpacityMaskClipValue counts."""
    bOverride_BlendMode: bool
    """Whether BlendMode counts."""
    bOverride_TwoSided: bool
    """Whether TwoSided counts."""
    TwoSided: bool
    """Whether back faces are drawn too."""
    BlendMode: EBlendMode
    """How the surface covers what is behind it."""
    OpacityMaskClipValue: float
    """Opacity below which a masked surface has a hole."""

class FMaterialInstanceBasePropertyOverrides_dict(TypedDict, total=False):
    """Any of the fields of FMaterialInstanceBasePropertyOverrides: what a dictionary for it may hold."""
    bOverride_OpacityMaskClipValue: bool | Future[bool]
    bOverride_BlendMode: bool | Future[bool]
    bOverride_TwoSided: bool | Future[bool]
    TwoSided: bool | Future[bool]
    BlendMode: EBlendMode_in
    OpacityMaskClipValue: float | Future[float]

FMaterialInstanceBasePropertyOverrides_in: TypeAlias = FMaterialInstanceBasePropertyOverrides | FMaterialInstanceBasePropertyOverrides_dict | Future[FMaterialInstanceBasePropertyOverrides]
"""What stands for FMaterialInstanceBasePropertyOverrides as an argument: itself, a dictionary of its fields, a future."""

class FMaterialInstanceBasePropertyOverrides_path(StructPath[FMaterialInstanceBasePropertyOverrides, FMaterialInstanceBasePropertyOverrides_in, FMaterialInstanceBasePropertyOverrides_async]):
    """A variable of type FMaterialInstanceBasePropertyOverrides: its path."""
    bOverride_OpacityMaskClipValue: BoolProperty
    """Whether OpacityMaskClipValue counts."""
    bOverride_BlendMode: BoolProperty
    """Whether BlendMode counts."""
    bOverride_TwoSided: BoolProperty
    """Whether TwoSided counts."""
    TwoSided: BoolProperty
    """Whether back faces are drawn too."""
    BlendMode: Property[ValuePath[EBlendMode, EBlendMode_in], EBlendMode_in]
    """How the surface covers what is behind it."""
    OpacityMaskClipValue: FloatProperty
    """Opacity below which a masked surface has a hole."""

class FMaterialInstanceBasePropertyOverrides_async(AsyncValuePath[FMaterialInstanceBasePropertyOverrides, FMaterialInstanceBasePropertyOverrides_in]):
    """The same under ``async_``."""
    bOverride_OpacityMaskClipValue: AsyncBoolProperty
    bOverride_BlendMode: AsyncBoolProperty
    bOverride_TwoSided: AsyncBoolProperty
    TwoSided: AsyncBoolProperty
    BlendMode: Property[AsyncValuePath[EBlendMode, EBlendMode_in], EBlendMode_in]
    OpacityMaskClipValue: AsyncFloatProperty

class UMaterialInstance_members(UMaterialInterface_members):
    """Functions and variables of UMaterialInstance."""
    Parent: Property[UMaterialInterface_path, UMaterialInterface | Future[UMaterialInterface] | None]
    """The material or instance whose parameters this one overrides.

    initially nullptr

    Unreal: UMaterialInstance.Parent (UMaterialInterface*)
    """
    ScalarParameterValues: Property[ArrayPath[FScalarParameterValue, FScalarParameterValue_in, FScalarParameterValue_path, FScalarParameterValue_async], Sequence[FScalarParameterValue_in] | Future[list[FScalarParameterValue]]]
    """Overridden scalar parameters.

    Unreal: UMaterialInstance.ScalarParameterValues (TArray<FScalarParameterValue>)
    """
    VectorParameterValues: Property[ArrayPath[FVectorParameterValue, FVectorParameterValue_in, FVectorParameterValue_path, FVectorParameterValue_async], Sequence[FVectorParameterValue_in] | Future[list[FVectorParameterValue]]]
    """Overridden vector parameters.

    Unreal: UMaterialInstance.VectorParameterValues (TArray<FVectorParameterValue>)
    """
    TextureParameterValues: Property[ArrayPath[FTextureParameterValue, FTextureParameterValue_in, FTextureParameterValue_path, FTextureParameterValue_async], Sequence[FTextureParameterValue_in] | Future[list[FTextureParameterValue]]]
    """Overridden texture parameters.

    Unreal: UMaterialInstance.TextureParameterValues (TArray<FTextureParameterValue>)
    """
    BasePropertyOverrides: Property[FMaterialInstanceBasePropertyOverrides_path, FMaterialInstanceBasePropertyOverrides_in]
    """Overridden properties of the base material.

    Unreal: UMaterialInstance.BasePropertyOverrides (FMaterialInstanceBasePropertyOverrides)
    """

class UMaterialInstance_async(UMaterialInterface_async):
    """UMaterialInstance under ``async_``: each function gives a future."""
    Parent: Property[UMaterialInterface_async_path, UMaterialInterface | Future[UMaterialInterface] | None]
    """The material or instance whose parameters this one overrides."""
    ScalarParameterValues: Property[AsyncArrayPath[FScalarParameterValue, FScalarParameterValue_in, FScalarParameterValue_async], Sequence[FScalarParameterValue_in] | Future[list[FScalarParameterValue]]]
    """Overridden scalar parameters."""
    VectorParameterValues: Property[AsyncArrayPath[FVectorParameterValue, FVectorParameterValue_in, FVectorParameterValue_async], Sequence[FVectorParameterValue_in] | Future[list[FVectorParameterValue]]]
    """Overridden vector parameters."""
    TextureParameterValues: Property[AsyncArrayPath[FTextureParameterValue, FTextureParameterValue_in, FTextureParameterValue_async], Sequence[FTextureParameterValue_in] | Future[list[FTextureParameterValue]]]
    """Overridden texture parameters."""
    BasePropertyOverrides: Property[FMaterialInstanceBasePropertyOverrides_async, FMaterialInstanceBasePropertyOverrides_in]
    """Overridden properties of the base material."""

class UMaterialInstance_send(UMaterialInterface_send):
    """UMaterialInstance under ``send_``: no function answers."""
    Parent: SendProperty[UMaterialInterface | Future[UMaterialInterface] | None]
    ScalarParameterValues: SendProperty[Sequence[FScalarParameterValue_in] | Future[list[FScalarParameterValue]]]
    VectorParameterValues: SendProperty[Sequence[FVectorParameterValue_in] | Future[list[FVectorParameterValue]]]
    TextureParameterValues: SendProperty[Sequence[FTextureParameterValue_in] | Future[list[FTextureParameterValue]]]
    BasePropertyOverrides: SendProperty[FMaterialInstanceBasePropertyOverrides_in]

class UMaterialInstance(UMaterialInstance_members, UMaterialInterface):
    """A material with some parameters overridden (UE: UMaterialInstance, Materials/MaterialInstance.h).

    Unreal: /Script/Engine.MaterialInstance
    """
    @property
    def async_(self) -> UMaterialInstance_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UMaterialInstance_send:
        """The same functions and variables, fire-and-forget."""

class UMaterialInstance_path(ObjectPath[UMaterialInstance, UMaterialInstance_async_path, UMaterialInstance_send], UMaterialInstance_members):
    """A variable that refers to an object of UMaterialInstance: its path."""

class UMaterialInstance_async_path(AsyncObjectPath[UMaterialInstance], UMaterialInstance_async):
    """The same under ``async_``."""
