# generated, do not edit (Engine: Public/Engine/Texture.h)
from spear.typing import (
    AsyncBoolProperty, AsyncObjectPath, AsyncValuePath, BoolProperty, ObjectPath, Property, SendBoolProperty, SendProperty, ValuePath,
)
from ._StreamableRenderAsset import UStreamableRenderAsset, UStreamableRenderAsset_async, UStreamableRenderAsset_members, UStreamableRenderAsset_send
from ._TextureDefines import TextureFilter, TextureFilter_in

class UTexture_members(UStreamableRenderAsset_members):
    """Functions and variables of UTexture."""
    SRGB: BoolProperty
    """Whether colour channels hold sRGB-encoded values; data maps (normals, roughness) are linear. Alpha is always
    linear.

    Unreal: UTexture.SRGB (bool)
    """
    Filter: Property[ValuePath[TextureFilter, TextureFilter_in], TextureFilter_in]
    """How the texture is sampled between texels.

    Unreal: UTexture.Filter (TEnumAsByte<TextureFilter>)
    """

class UTexture_async(UStreamableRenderAsset_async):
    """UTexture under ``async_``: each function gives a future."""
    SRGB: AsyncBoolProperty
    """Whether colour channels hold sRGB-encoded values; data maps (normals, roughness) are linear."""
    Filter: Property[AsyncValuePath[TextureFilter, TextureFilter_in], TextureFilter_in]
    """How the texture is sampled between texels."""

class UTexture_send(UStreamableRenderAsset_send):
    """UTexture under ``send_``: no function answers."""
    SRGB: SendBoolProperty
    Filter: SendProperty[TextureFilter_in]

class UTexture(UTexture_members, UStreamableRenderAsset):
    """Base of all textures (UE: UTexture, Engine/Texture.h).

    Unreal: /Script/Engine.Texture
    """
    @property
    def async_(self) -> UTexture_async:
        """The same functions and variables without waiting: each gives a Future at once."""
    @property
    def send_(self) -> UTexture_send:
        """The same functions and variables, fire-and-forget."""

class UTexture_path(ObjectPath[UTexture, UTexture_async_path, UTexture_send], UTexture_members):
    """A variable that refers to an object of UTexture: its path."""

class UTexture_async_path(AsyncObjectPath[UTexture], UTexture_async):
    """The same under ``async_``."""
