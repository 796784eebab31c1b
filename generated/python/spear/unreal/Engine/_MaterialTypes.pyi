# generated, do not edit (Engine: Public/MaterialTypes.h)
from typing import TypeAlias, TypedDict
from spear.enums import UnrealEnum
from spear.structs import Struct
from spear.typing import AsyncIntProperty, AsyncStrProperty, AsyncValuePath, Future, IntProperty, Property, StrProperty, StructPath, ValuePath

class EMaterialParameterAssociation(UnrealEnum):
    """What a material parameter belongs to (UE: EMaterialParameterAssociation, MaterialTypes.h).

    Unreal: /Script/Engine.EMaterialParameterAssociation
    """
    LayerParameter = 0
    BlendParameter = 1
    GlobalParameter = 2

EMaterialParameterAssociation_in: TypeAlias = EMaterialParameterAssociation | str | Future[EMaterialParameterAssociation]
"""What stands for EMaterialParameterAssociation as an argument: an entry, the name that Unreal gives it, a future."""

class FMaterialParameterInfo(Struct):
    """Identifies a material parameter (UE: FMaterialParameterInfo, MaterialTypes.h). The embedded engine's materials
    have no layers, so the association is GlobalParameter and the index INDEX_NONE for every parameter that
    exists.

    Unreal: /Script/Engine.MaterialParameterInfo
    """
    def __init__(self, Name: str = ..., Association: EMaterialParameterAssociation = ..., Index: int = ...) -> None: ...
    Name: str
    """Parameter name; compared without case, like every FName."""
    Association: EMaterialParameterAssociation
    """Whether this is a global parameter or belongs to a layer or blend."""
    Index: int
    """Layer or blend index, INDEX_NONE for a global parameter."""

class FMaterialParameterInfo_dict(TypedDict, total=False):
    """Any of the fields of FMaterialParameterInfo: what a dictionary for it may hold."""
    Name: str | Future[str]
    Association: EMaterialParameterAssociation_in
    Index: int | Future[int]

FMaterialParameterInfo_in: TypeAlias = FMaterialParameterInfo | FMaterialParameterInfo_dict | Future[FMaterialParameterInfo]
"""What stands for FMaterialParameterInfo as an argument: itself, a dictionary of its fields, a future."""

class FMaterialParameterInfo_path(StructPath[FMaterialParameterInfo, FMaterialParameterInfo_in, FMaterialParameterInfo_async]):
    """A variable of type FMaterialParameterInfo: its path."""
    Name: StrProperty
    """Parameter name; compared without case, like every FName."""
    Association: Property[ValuePath[EMaterialParameterAssociation, EMaterialParameterAssociation_in], EMaterialParameterAssociation_in]
    """Whether this is a global parameter or belongs to a layer or blend."""
    Index: IntProperty
    """Layer or blend index, INDEX_NONE for a global parameter."""

class FMaterialParameterInfo_async(AsyncValuePath[FMaterialParameterInfo, FMaterialParameterInfo_in]):
    """The same under ``async_``."""
    Name: AsyncStrProperty
    Association: Property[AsyncValuePath[EMaterialParameterAssociation, EMaterialParameterAssociation_in], EMaterialParameterAssociation_in]
    Index: AsyncIntProperty
