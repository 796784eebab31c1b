// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

#include "Scene.generated.h"

/** The units of a local light's intensity. Epic page: ELightUnits. */
UENUM()
enum class ELightUnits : uint8 {
    /** The historic scale without a unit: 625 of it are one candela. */
    Unitless,
    /** Candelas: luminous intensity in the direction of the light. */
    Candelas,
    /** Lumens: the luminous power of the whole light. */
    Lumens,
    /** Exposure value at ISO 100, as photographers count it. */
    EV UMETA(DisplayName = "EV100")
};
