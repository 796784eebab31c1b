// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Materials/BlendMode.h"

class UTexture2D;

/**
 * What a renderer needs of a material, all parameters resolved through the chain of instances. Embedded engine only: UE
 * compiles a material graph to shaders; here every material is the metallic-roughness model of glTF 2.0 with the
 * parameters named in Materials/Material.h.
 *
 * A texture multiplies its factor; a null texture counts as 1 (a flat normal for Normal).
 */
struct FSurfaceParameters {
    /** Linear base colour; A is the opacity. */
    FLinearColor BaseColor = FLinearColor(1.0f, 1.0f, 1.0f, 1.0f);
    /** Linear emitted radiance, any magnitude. */
    FLinearColor EmissiveColor = FLinearColor(0.0f, 0.0f, 0.0f, 1.0f);
    /** 0 dielectric, 1 metal. */
    float Metallic = 0.0f;
    /** Perceptual roughness, 0 to 1. */
    float Roughness = 0.5f;
    /** UE's Specular input, 0 to 1; 0.5 is a reflectance of 0.04 at normal incidence. */
    float Specular = 0.5f;
    /** Scale of the X and Y components of the normal map. */
    float NormalScale = 1.0f;
    /** How much of the occlusion texture applies, 0 to 1. */
    float OcclusionStrength = 1.0f;
    /** For BLEND_Masked: opacity below this is a hole. */
    float OpacityMaskClipValue = 0.3333f;
    /** Texture coordinates are multiplied by this, then UVOffset is added. */
    FVector2f UVScale = FVector2f(1.0f, 1.0f);
    /** Added to the scaled texture coordinates. */
    FVector2f UVOffset = FVector2f(0.0f, 0.0f);
    /** sRGB colour and opacity. */
    UTexture2D* BaseColorTexture = nullptr;
    /** R ambient occlusion, G roughness, B metallic; linear. */
    UTexture2D* OcclusionRoughnessMetallicTexture = nullptr;
    /** Tangent-space normal, OpenGL convention as in glTF (green points up the image); linear. */
    UTexture2D* NormalTexture = nullptr;
    /** sRGB emitted colour. */
    UTexture2D* EmissiveTexture = nullptr;
    /** How the surface covers what is behind it. */
    EBlendMode BlendMode = BLEND_Opaque;
    /** Whether back faces are drawn too. */
    bool bTwoSided = false;
};
