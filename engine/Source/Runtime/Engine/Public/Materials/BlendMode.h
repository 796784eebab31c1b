// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"

#include "BlendMode.generated.h"

/** How a surface covers what is behind it (UE: EBlendMode, Engine/EngineTypes.h). The embedded engine's materials use
 * the first three. */
UENUM(BlueprintType)
enum EBlendMode : int {
    BLEND_Opaque UMETA(DisplayName = "Opaque"),
    BLEND_Masked UMETA(DisplayName = "Masked"),
    BLEND_Translucent UMETA(DisplayName = "Translucent"),
    BLEND_Additive UMETA(DisplayName = "Additive"),
    BLEND_Modulate UMETA(DisplayName = "Modulate"),
    BLEND_AlphaComposite UMETA(DisplayName = "AlphaComposite (Premultiplied Alpha)"),
    BLEND_AlphaHoldout UMETA(DisplayName = "AlphaHoldout"),
    BLEND_MAX,
};
