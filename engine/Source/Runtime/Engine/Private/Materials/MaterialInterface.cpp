// SPDX-License-Identifier: MIT
#include "Materials/MaterialInterface.h"

#include "Engine/Texture2D.h"
#include "Materials/Material.h"

UMaterial* UMaterialInterface::GetBaseMaterial() { return GetMaterial(); }

UMaterial* UMaterialInterface::GetMaterial() { return nullptr; }

const UMaterial* UMaterialInterface::GetMaterial() const { return nullptr; }

EBlendMode UMaterialInterface::GetBlendMode() const { return BLEND_Opaque; }

bool UMaterialInterface::IsTwoSided() const { return false; }

float UMaterialInterface::GetOpacityMaskClipValue() const { return 0.3333f; }

bool UMaterialInterface::GetScalarParameterValue(const FHashedMaterialParameterInfo&, float&, bool) const {
    return false;
}

bool UMaterialInterface::GetVectorParameterValue(const FHashedMaterialParameterInfo&, FLinearColor&, bool) const {
    return false;
}

bool UMaterialInterface::GetTextureParameterValue(const FHashedMaterialParameterInfo&, UTexture*&, bool) const {
    return false;
}

uint32 UMaterialInterface::GetParametersRevision() const { return ParametersRevision; }

FSurfaceParameters UMaterialInterface::GetSurfaceParameters() const {
    FSurfaceParameters Result;
    GetVectorParameterValue(TEXT("BaseColor"), Result.BaseColor);
    GetVectorParameterValue(TEXT("EmissiveColor"), Result.EmissiveColor);
    GetScalarParameterValue(TEXT("Metallic"), Result.Metallic);
    GetScalarParameterValue(TEXT("Roughness"), Result.Roughness);
    GetScalarParameterValue(TEXT("Specular"), Result.Specular);
    GetScalarParameterValue(TEXT("NormalScale"), Result.NormalScale);
    GetScalarParameterValue(TEXT("OcclusionStrength"), Result.OcclusionStrength);
    FLinearColor Transform(1.0f, 1.0f, 0.0f, 0.0f);
    GetVectorParameterValue(TEXT("UVTransform"), Transform);
    Result.UVScale = FVector2f(Transform.R, Transform.G);
    Result.UVOffset = FVector2f(Transform.B, Transform.A);
    const auto Texture = [this](const TCHAR* Name) -> UTexture2D* {
        UTexture* Value = nullptr;
        GetTextureParameterValue(Name, Value);
        return Cast<UTexture2D>(Value);
    };
    Result.BaseColorTexture = Texture(TEXT("BaseColorTexture"));
    Result.OcclusionRoughnessMetallicTexture = Texture(TEXT("OcclusionRoughnessMetallicTexture"));
    Result.NormalTexture = Texture(TEXT("NormalTexture"));
    Result.EmissiveTexture = Texture(TEXT("EmissiveTexture"));
    Result.BlendMode = GetBlendMode();
    Result.bTwoSided = IsTwoSided();
    Result.OpacityMaskClipValue = GetOpacityMaskClipValue();
    return Result;
}
