# generated, do not edit (Engine: Public/Materials/BlendMode.h)
from typing import TypeAlias
from spear.enums import UnrealEnum
from spear.typing import Future

class EBlendMode(UnrealEnum):
    """How a surface covers what is behind it (UE: EBlendMode, Engine/EngineTypes.h). The embedded engine's materials
    use the first three.

    Unreal: /Script/Engine.EBlendMode
    """
    BLEND_Opaque = 0
    BLEND_Masked = 1
    BLEND_Translucent = 2
    BLEND_Additive = 3
    BLEND_Modulate = 4
    BLEND_AlphaComposite = 5
    BLEND_AlphaHoldout = 6
    BLEND_MAX = 7

EBlendMode_in: TypeAlias = EBlendMode | str | Future[EBlendMode]
"""What stands for EBlendMode as an argument: an entry, the name that Unreal gives it, a future."""
