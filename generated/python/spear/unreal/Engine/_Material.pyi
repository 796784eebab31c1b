# generated, do not edit (Engine: Public/Materials/Material.h)
from collections.abc import Sequence
from spear.typing import (
    ArrayPath, AsyncArrayPath, AsyncBoolProperty, AsyncFloatProperty, AsyncObjectPath, AsyncValuePath, BoolProperty, FloatProperty, Future,
    ObjectPath, Property, SendBoolProperty, SendFloatProperty, SendProperty, ValuePath,
)
from ._BlendMode import EBlendMode, EBlendMode_in
from ._MaterialInstance import (
    FScalarParameterValue, FScalarParameterValue_async, FScalarParameterValue_in, FScalarParameterValue_path, FTextureParameterValue,
    FTextureParameterValue_async, FTextureParameterValue_in, FTextureParameterValue_path, FVectorParameterValue, FVectorParameterValue_async,
    FVectorParameterValue_in, FVectorParameterValue_path,
)
from ._MaterialInterface import UMaterialInterface, UMaterialInterface_async, UMaterialInterface_members, UMaterialInterface_send

class UMaterial_members(UMaterialInterface_members):
    """Functions and variables of UMaterial."""
    BlendMode: Property[ValuePath[EBlendMode, EBlendMode_in], EBlendMode_in]
    """How the surface covers what is behind it.

    Unreal: UMaterial.BlendMode (TEnumAsByte<EBlendMode>)
    """
    TwoSided: BoolProperty
    """Whether back faces are drawn too.

    Unreal: UMaterial.TwoSided (bool)
    """
    OpacityMaskClipValue: FloatProperty
    """Opacity below which a masked surface has a hole.

    Unreal: UMaterial.OpacityMaskClipValue (float)
    """
    ScalarParameterDefaults: Property[ArrayPath[FScalarParameterValue, FScalarParameterValue_in, FScalarParameterValue_path, FScalarParameterValue_async], Sequence[FScalarParameterValue_in] | Future[list[FScalarParameterValue]]]
    """Unreal: UMaterial.ScalarParameterDefaults (TArray<FScalarParameterValue>)"""
    VectorParameterDefaults: Property[ArrayPath[FVectorParameterValue, FVectorParameterValue_in, FVectorParameterValue_path, FVectorParameterValue_async], Sequence[FVectorParameterValue_in] | Future[list[FVectorParameterValue]]]
    """Unreal: UMaterial.VectorParameterDefaults (TArray<FVectorParameterValue>)"""
    TextureParameterDefaults: Property[ArrayPath[FTextureParameterValue, FTextureParameterValue_in, FTextureParameterValue_path, FTextureParameterValue_async], Sequence[FTextureParameterValue_in] | Future[list[FTextureParameterValue]]]
    """Unreal: UMaterial.TextureParameterDefaults (TArray<FTextureParameterValue>)"""

class UMaterial_async(UMaterialInterface_async):
    """UMaterial under ``async_``: each function gives a future."""
    BlendMode: Property[AsyncValuePath[EBlendMode, EBlendMode_in], EBlendMode_in]
    """How the surface covers what is behind it."""
    TwoSided: AsyncBoolProperty
    """Whether back faces are drawn too."""
    OpacityMaskClipValue: AsyncFloatProperty
    """Opacity below which a masked surface has a hole."""
    ScalarParameterDefaults: Property[AsyncArrayPath[FScalarParameterValue, FScalarParameterValue_in, FScalarParameterValue_async], Sequence[FScalarParameterValue_in] | Future[list[FScalarParameterValue]]]
    VectorParameterDefaults: Property[AsyncArrayPath[FVectorParameterValue, FVectorParameterValue_in, FVectorParameterValue_async], Sequence[FVectorParameterValue_in] | Future[list[FVectorParameterValue]]]
    TextureParameterDefaults: Property[AsyncArrayPath[FTextureParameterValue, FTextureParameterValue_in, FTextureParameterValue_async], Sequence[FTextureParameterValue_in] | Future[list[FTextureParameterValue]]]

class UMaterial_send(UMaterialInterface_send):
    """UMaterial under ``send_``: no function answers."""
    BlendMode: SendProperty[EBlendMode_in]
    TwoSided: SendBoolProperty
    OpacityMaskClipValue: SendFloatProperty
    ScalarParameterDefaults: SendProperty[Sequence[FScalarParameterValue_in] | Future[list[FScalarParameterValue]]]
    VectorParameterDefaults: SendProperty[Sequence[FVectorParameterValue_in] | Future[list[FVectorParameterValue]]]
    TextureParameterDefaults: SendProperty[Sequence[FTextureParameterValue_in] | Future[list[FTextureParameterValue]]]

class UMaterial(UMaterial_members, UMaterialInterface):
    """A material (UE: UMaterial, Materials/Material.h).

    In UE a material is a graph of expressions. In the embedded engine every material is the metallic-roughness
    surface of glTF 2.0 and has these parameters:

    | name | kind | meaning |

    | BaseColor | vector | linear colour, A is the opacity | | EmissiveColor | vector | linear emitted radiance |
    | UVTransform | vector | R, G scale and B, A offset of the texture coordinates | | Metallic, Roughness,
    Specular | scalar | 0 to 1 | | NormalScale, OcclusionStrength | scalar | strength of the maps | |
    BaseColorTexture, EmissiveTexture | texture | sRGB colour | | OcclusionRoughnessMetallicTexture | texture | R
    occlusion, G roughness, B metallic | | NormalTexture | texture | tangent-space normals, green up |

    "/Engine/EngineMaterials/DefaultMaterial.DefaultMaterial" is a plain grey one; scenes instance
    "/Engine/EngineMaterials/Surface.Surface".

    Unreal: /Script/Engine.Material
    """
    @property
    def async_(self) -> UMaterial_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UMaterial_send:
        """The same functions and variables, fire-and-forget."""

class UMaterial_path(ObjectPath[UMaterial, UMaterial_async_path, UMaterial_send], UMaterial_members):
    """A variable that refers to an object of UMaterial: its path."""

class UMaterial_async_path(AsyncObjectPath[UMaterial], UMaterial_async):
    """The same under ``async_``."""
