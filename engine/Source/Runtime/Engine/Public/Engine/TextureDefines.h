// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"

#include "TextureDefines.generated.h"

/** How a texture is sampled between texels (UE: TextureFilter, Engine/TextureDefines.h). */
UENUM()
enum TextureFilter : int {
    TF_Nearest UMETA(DisplayName = "Nearest"),
    TF_Bilinear UMETA(DisplayName = "Bi-linear"),
    TF_Trilinear UMETA(DisplayName = "Tri-linear"),
    /** Use setting from the Texture Group. */
    TF_Default UMETA(DisplayName = "Default (from Texture Group)"),
    TF_MAX,
};

/** What coordinates outside 0..1 mean (UE: TextureAddress, Engine/TextureDefines.h). */
UENUM()
enum TextureAddress : int {
    TA_Wrap UMETA(DisplayName = "Wrap"),
    TA_Clamp UMETA(DisplayName = "Clamp"),
    TA_Mirror UMETA(DisplayName = "Mirror"),
    TA_MAX,
};
