# generated, do not edit (Engine: Public/Engine/Scene.h)
from typing import TypeAlias
from spear.enums import UnrealEnum
from spear.typing import Future

class ELightUnits(UnrealEnum):
    """The units of a local light's intensity. Epic page: ELightUnits.

    Unreal: /Script/Engine.ELightUnits
    """
    Unitless = 0
    """The historic scale without a unit: 625 of it are one candela."""
    Candelas = 1
    """Candelas: luminous intensity in the direction of the light."""
    Lumens = 2
    """Lumens: the luminous power of the whole light."""
    EV = 3
    """Exposure value at ISO 100, as photographers count it."""

ELightUnits_in: TypeAlias = ELightUnits | str | Future[ELightUnits]
"""What stands for ELightUnits as an argument: an entry, the name that Unreal gives it, a future."""
