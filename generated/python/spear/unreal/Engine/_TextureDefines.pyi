# generated, do not edit (Engine: Public/Engine/TextureDefines.h)
from typing import TypeAlias
from spear.enums import UnrealEnum
from spear.typing import Future

class TextureFilter(UnrealEnum):
    """How a texture is sampled between texels (UE: TextureFilter, Engine/TextureDefines.h).

    Unreal: /Script/Engine.TextureFilter
    """
    TF_Nearest = 0
    TF_Bilinear = 1
    TF_Trilinear = 2
    TF_Default = 3
    """Use setting from the Texture Group."""
    TF_MAX = 4

TextureFilter_in: TypeAlias = TextureFilter | str | Future[TextureFilter]
"""What stands for TextureFilter as an argument: an entry, the name that Unreal gives it, a future."""

class TextureAddress(UnrealEnum):
    """What coordinates outside 0..1 mean (UE: TextureAddress, Engine/TextureDefines.h).

    Unreal: /Script/Engine.TextureAddress
    """
    TA_Wrap = 0
    TA_Clamp = 1
    TA_Mirror = 2
    TA_MAX = 3

TextureAddress_in: TypeAlias = TextureAddress | str | Future[TextureAddress]
"""What stands for TextureAddress as an argument: an entry, the name that Unreal gives it, a future."""
