// SPDX-License-Identifier: MIT
#include "Materials/MaterialInstanceDynamic.h"

#include "MaterialParameters.h"
#include "UObject/Package.h"

UMaterialInstanceDynamic* UMaterialInstanceDynamic::Create(UMaterialInterface* ParentMaterial, UObject* InOuter) {
    return Create(ParentMaterial, InOuter, NAME_None);
}

UMaterialInstanceDynamic* UMaterialInstanceDynamic::Create(
    UMaterialInterface* ParentMaterial, UObject* InOuter, FName Name) {
    if (ParentMaterial == nullptr) {
        UE_LOG(LogTemp, Warning, TEXT("UMaterialInstanceDynamic::Create was given no parent material"));
        return nullptr;
    }
    UObject* Outer = InOuter ? InOuter : GetTransientPackageAsObject();
    UMaterialInstanceDynamic* Result = NewObject<UMaterialInstanceDynamic>(Outer, Name);
    Result->SetParentInternal(ParentMaterial);
    return Result;
}

void UMaterialInstanceDynamic::SetScalarParameterValue(FName ParameterName, float Value) {
    SetScalarParameterValueInternal(FMaterialParameterInfo(ParameterName), Value);
}

void UMaterialInstanceDynamic::SetScalarParameterValueByInfo(const FMaterialParameterInfo& ParameterInfo, float Value) {
    SetScalarParameterValueInternal(ParameterInfo, Value);
}

float UMaterialInstanceDynamic::K2_GetScalarParameterValue(FName ParameterName) {
    float Result = 0.0f;
    GetScalarParameterValue(ParameterName, Result);
    return Result;
}

void UMaterialInstanceDynamic::SetTextureParameterValue(FName ParameterName, UTexture* Value) {
    SetTextureParameterValueInternal(FMaterialParameterInfo(ParameterName), Value);
}

void UMaterialInstanceDynamic::SetTextureParameterValueByInfo(
    const FMaterialParameterInfo& ParameterInfo, UTexture* Value) {
    SetTextureParameterValueInternal(ParameterInfo, Value);
}

UTexture* UMaterialInstanceDynamic::K2_GetTextureParameterValue(FName ParameterName) {
    UTexture* Result = nullptr;
    GetTextureParameterValue(ParameterName, Result);
    return Result;
}

void UMaterialInstanceDynamic::SetVectorParameterValue(FName ParameterName, FLinearColor Value) {
    SetVectorParameterValueInternal(FMaterialParameterInfo(ParameterName), Value);
}

void UMaterialInstanceDynamic::SetVectorParameterValueByInfo(
    const FMaterialParameterInfo& ParameterInfo, FLinearColor Value) {
    SetVectorParameterValueInternal(ParameterInfo, Value);
}

FLinearColor UMaterialInstanceDynamic::K2_GetVectorParameterValue(FName ParameterName) {
    FLinearColor Result(0.0f, 0.0f, 0.0f, 0.0f);
    GetVectorParameterValue(ParameterName, Result);
    return Result;
}

void UMaterialInstanceDynamic::K2_InterpolateMaterialInstanceParams(
    UMaterialInstance* SourceA, UMaterialInstance* SourceB, float Alpha) {
    if (SourceA == nullptr || SourceB == nullptr) {
        return;
    }
    // Copies first: this instance may be one of the sources.
    TArray<FScalarParameterValue> Scalars = SourceA->ScalarParameterValues;
    for (const FScalarParameterValue& Value : SourceB->ScalarParameterValues) {
        if (FindParameter(Scalars, Value.ParameterInfo) == nullptr) {
            Scalars.Add(Value);
        }
    }
    TArray<FVectorParameterValue> Vectors = SourceA->VectorParameterValues;
    for (const FVectorParameterValue& Value : SourceB->VectorParameterValues) {
        if (FindParameter(Vectors, Value.ParameterInfo) == nullptr) {
            Vectors.Add(Value);
        }
    }
    for (FScalarParameterValue& Value : Scalars) {
        float A = 0.0f;
        float B = 0.0f;
        if (SourceA->GetScalarParameterValue(Value.ParameterInfo, A) &&
            SourceB->GetScalarParameterValue(Value.ParameterInfo, B)) {
            Value.ParameterValue = A + (B - A) * Alpha;
        }
    }
    for (FVectorParameterValue& Value : Vectors) {
        FLinearColor A;
        FLinearColor B;
        if (SourceA->GetVectorParameterValue(Value.ParameterInfo, A) &&
            SourceB->GetVectorParameterValue(Value.ParameterInfo, B)) {
            Value.ParameterValue = A + (B - A) * Alpha;
        }
    }
    ScalarParameterValues = Scalars;
    VectorParameterValues = Vectors;
    MarkParametersChanged();
}

void UMaterialInstanceDynamic::ClearParameterValues() { ClearParameterValuesInternal(); }
