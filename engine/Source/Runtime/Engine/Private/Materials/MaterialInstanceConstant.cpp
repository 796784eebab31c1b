// SPDX-License-Identifier: MIT
#include "Materials/MaterialInstanceConstant.h"

float UMaterialInstanceConstant::K2_GetScalarParameterValue(FName ParameterName) {
    float Result = 0.0f;
    GetScalarParameterValue(ParameterName, Result);
    return Result;
}

UTexture* UMaterialInstanceConstant::K2_GetTextureParameterValue(FName ParameterName) {
    UTexture* Result = nullptr;
    GetTextureParameterValue(ParameterName, Result);
    return Result;
}

FLinearColor UMaterialInstanceConstant::K2_GetVectorParameterValue(FName ParameterName) {
    FLinearColor Result(0.0f, 0.0f, 0.0f, 0.0f);
    GetVectorParameterValue(ParameterName, Result);
    return Result;
}

void UMaterialInstanceConstant::InitializeAsset(UMaterialInterface* InParent,
    const TArray<FScalarParameterValue>& Scalars, const TArray<FVectorParameterValue>& Vectors,
    const TArray<FTextureParameterValue>& Textures, const FMaterialInstanceBasePropertyOverrides& Overrides) {
    SetParentInternal(InParent);
    ScalarParameterValues = Scalars;
    VectorParameterValues = Vectors;
    TextureParameterValues = Textures;
    BasePropertyOverrides = Overrides;
    MarkParametersChanged();
}
