// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Engine/StreamableRenderAsset.h"
#include "Engine/TextureDefines.h"

#include "Texture.generated.h"

/**
 * Base of all textures (UE: UTexture, Engine/Texture.h).
 */
UCLASS(Abstract, BlueprintType)
class ENGINE_API UTexture : public UStreamableRenderAsset {
    GENERATED_BODY()

public:
    /** Whether colour channels hold sRGB-encoded values; data maps (normals, roughness) are linear. Alpha is always
     * linear. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Texture")
    uint8 SRGB : 1;

    /** How the texture is sampled between texels. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Texture")
    TEnumAsByte<enum TextureFilter> Filter;

    UTexture(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Width in texels of the top mip as a float, 0 without pixels (UE: UTexture::GetSurfaceWidth). */
    virtual float GetSurfaceWidth() const { return 0.0f; }

    /** Height in texels of the top mip as a float, 0 without pixels (UE: UTexture::GetSurfaceHeight). */
    virtual float GetSurfaceHeight() const { return 0.0f; }
};
