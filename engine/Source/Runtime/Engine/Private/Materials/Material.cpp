// SPDX-License-Identifier: MIT
#include "Materials/Material.h"

#include "MaterialParameters.h"

UMaterial::UMaterial(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer), BlendMode(BLEND_Opaque), TwoSided(0), OpacityMaskClipValue(0.3333f) {
    const FSurfaceParameters Defaults;
    const auto Scalar = [this](const TCHAR* Name, float Value) {
        ScalarParameterDefaults.Add(FScalarParameterValue(FMaterialParameterInfo(Name), Value));
    };
    Scalar(TEXT("Metallic"), Defaults.Metallic);
    Scalar(TEXT("Roughness"), Defaults.Roughness);
    Scalar(TEXT("Specular"), Defaults.Specular);
    Scalar(TEXT("NormalScale"), Defaults.NormalScale);
    Scalar(TEXT("OcclusionStrength"), Defaults.OcclusionStrength);
    const auto Vector = [this](const TCHAR* Name, const FLinearColor& Value) {
        VectorParameterDefaults.Add(FVectorParameterValue(FMaterialParameterInfo(Name), Value));
    };
    Vector(TEXT("BaseColor"), Defaults.BaseColor);
    Vector(TEXT("EmissiveColor"), Defaults.EmissiveColor);
    Vector(TEXT("UVTransform"), FLinearColor(1.0f, 1.0f, 0.0f, 0.0f));
    for (const TCHAR* Name : {TEXT("BaseColorTexture"), TEXT("OcclusionRoughnessMetallicTexture"),
             TEXT("NormalTexture"), TEXT("EmissiveTexture")}) {
        TextureParameterDefaults.Add(FTextureParameterValue(FMaterialParameterInfo(Name), nullptr));
    }
}

UMaterial* UMaterial::GetMaterial() { return this; }

const UMaterial* UMaterial::GetMaterial() const { return this; }

EBlendMode UMaterial::GetBlendMode() const { return BlendMode; }

bool UMaterial::IsTwoSided() const { return TwoSided != 0; }

float UMaterial::GetOpacityMaskClipValue() const { return OpacityMaskClipValue; }

bool UMaterial::GetScalarParameterValue(
    const FHashedMaterialParameterInfo& ParameterInfo, float& OutValue, bool bOveriddenOnly) const {
    const FScalarParameterValue* Found =
        bOveriddenOnly ? nullptr : FindParameter(ScalarParameterDefaults, ParameterInfo.GetInfo());
    if (Found == nullptr) {
        return false;
    }
    OutValue = Found->ParameterValue;
    return true;
}

bool UMaterial::GetVectorParameterValue(
    const FHashedMaterialParameterInfo& ParameterInfo, FLinearColor& OutValue, bool bOveriddenOnly) const {
    const FVectorParameterValue* Found =
        bOveriddenOnly ? nullptr : FindParameter(VectorParameterDefaults, ParameterInfo.GetInfo());
    if (Found == nullptr) {
        return false;
    }
    OutValue = Found->ParameterValue;
    return true;
}

bool UMaterial::GetTextureParameterValue(
    const FHashedMaterialParameterInfo& ParameterInfo, UTexture*& OutValue, bool bOveriddenOnly) const {
    const FTextureParameterValue* Found =
        bOveriddenOnly ? nullptr : FindParameter(TextureParameterDefaults, ParameterInfo.GetInfo());
    if (Found == nullptr) {
        return false;
    }
    OutValue = Found->ParameterValue.Get();
    return true;
}

bool UMaterial::SetScalarParameterDefault(FName ParameterName, float Value) {
    FScalarParameterValue* Found = FindParameter(ScalarParameterDefaults, FMaterialParameterInfo(ParameterName));
    if (Found == nullptr) {
        return false;
    }
    Found->ParameterValue = Value;
    MarkParametersChanged();
    return true;
}

bool UMaterial::SetVectorParameterDefault(FName ParameterName, FLinearColor Value) {
    FVectorParameterValue* Found = FindParameter(VectorParameterDefaults, FMaterialParameterInfo(ParameterName));
    if (Found == nullptr) {
        return false;
    }
    Found->ParameterValue = Value;
    MarkParametersChanged();
    return true;
}

bool UMaterial::SetTextureParameterDefault(FName ParameterName, UTexture* Value) {
    FTextureParameterValue* Found = FindParameter(TextureParameterDefaults, FMaterialParameterInfo(ParameterName));
    if (Found == nullptr) {
        return false;
    }
    Found->ParameterValue = Value;
    MarkParametersChanged();
    return true;
}
