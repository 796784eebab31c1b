// SPDX-License-Identifier: MIT
#include "Materials/MaterialInstance.h"

#include "MaterialParameters.h"
#include "Materials/Material.h"

UMaterial* UMaterialInstance::GetMaterial() { return Parent ? Parent->GetMaterial() : nullptr; }

const UMaterial* UMaterialInstance::GetMaterial() const {
    const UMaterialInterface* ConstParent = Parent.Get();
    return ConstParent ? ConstParent->GetMaterial() : nullptr;
}

EBlendMode UMaterialInstance::GetBlendMode() const {
    if (BasePropertyOverrides.bOverride_BlendMode) {
        return BasePropertyOverrides.BlendMode;
    }
    return Parent ? Parent->GetBlendMode() : Super::GetBlendMode();
}

bool UMaterialInstance::IsTwoSided() const {
    if (BasePropertyOverrides.bOverride_TwoSided) {
        return BasePropertyOverrides.TwoSided != 0;
    }
    return Parent ? Parent->IsTwoSided() : Super::IsTwoSided();
}

float UMaterialInstance::GetOpacityMaskClipValue() const {
    if (BasePropertyOverrides.bOverride_OpacityMaskClipValue) {
        return BasePropertyOverrides.OpacityMaskClipValue;
    }
    return Parent ? Parent->GetOpacityMaskClipValue() : Super::GetOpacityMaskClipValue();
}

bool UMaterialInstance::GetScalarParameterValue(
    const FHashedMaterialParameterInfo& ParameterInfo, float& OutValue, bool bOveriddenOnly) const {
    if (const FScalarParameterValue* Found = FindParameter(ScalarParameterValues, ParameterInfo.GetInfo())) {
        OutValue = Found->ParameterValue;
        return true;
    }
    return Parent && Parent->GetScalarParameterValue(ParameterInfo, OutValue, bOveriddenOnly);
}

bool UMaterialInstance::GetVectorParameterValue(
    const FHashedMaterialParameterInfo& ParameterInfo, FLinearColor& OutValue, bool bOveriddenOnly) const {
    if (const FVectorParameterValue* Found = FindParameter(VectorParameterValues, ParameterInfo.GetInfo())) {
        OutValue = Found->ParameterValue;
        return true;
    }
    return Parent && Parent->GetVectorParameterValue(ParameterInfo, OutValue, bOveriddenOnly);
}

bool UMaterialInstance::GetTextureParameterValue(
    const FHashedMaterialParameterInfo& ParameterInfo, UTexture*& OutValue, bool bOveriddenOnly) const {
    if (const FTextureParameterValue* Found = FindParameter(TextureParameterValues, ParameterInfo.GetInfo())) {
        OutValue = Found->ParameterValue.Get();
        return true;
    }
    return Parent && Parent->GetTextureParameterValue(ParameterInfo, OutValue, bOveriddenOnly);
}

uint32 UMaterialInstance::GetParametersRevision() const {
    return ParametersRevision + (Parent ? Parent->GetParametersRevision() : 0u);
}

void UMaterialInstance::SetParentInternal(UMaterialInterface* NewParent) {
    for (const UMaterialInterface* Ancestor = NewParent; Ancestor != nullptr;) {
        if (Ancestor == this) {
            UE_LOG(LogTemp, Error, TEXT("%s cannot be a parent of %s: it is an instance of it already"),
                *NewParent->GetPathName(), *GetPathName());
            return;
        }
        const UMaterialInstance* Instance = Cast<UMaterialInstance>(Ancestor);
        Ancestor = Instance ? Instance->Parent.Get() : nullptr;
    }
    Parent = NewParent;
    MarkParametersChanged();
}

void UMaterialInstance::SetScalarParameterValueInternal(const FMaterialParameterInfo& ParameterInfo, float Value) {
    if (FScalarParameterValue* Found = FindParameter(ScalarParameterValues, ParameterInfo)) {
        Found->ParameterValue = Value;
    } else {
        ScalarParameterValues.Add(FScalarParameterValue(ParameterInfo, Value));
    }
    MarkParametersChanged();
}

void UMaterialInstance::SetVectorParameterValueInternal(
    const FMaterialParameterInfo& ParameterInfo, FLinearColor Value) {
    if (FVectorParameterValue* Found = FindParameter(VectorParameterValues, ParameterInfo)) {
        Found->ParameterValue = Value;
    } else {
        VectorParameterValues.Add(FVectorParameterValue(ParameterInfo, Value));
    }
    MarkParametersChanged();
}

void UMaterialInstance::SetTextureParameterValueInternal(const FMaterialParameterInfo& ParameterInfo, UTexture* Value) {
    if (FTextureParameterValue* Found = FindParameter(TextureParameterValues, ParameterInfo)) {
        Found->ParameterValue = Value;
    } else {
        TextureParameterValues.Add(FTextureParameterValue(ParameterInfo, Value));
    }
    MarkParametersChanged();
}

void UMaterialInstance::ClearParameterValuesInternal() {
    ScalarParameterValues.Empty();
    VectorParameterValues.Empty();
    TextureParameterValues.Empty();
    MarkParametersChanged();
}
