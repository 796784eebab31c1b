// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"

#include "MaterialTypes.generated.h"

/** What a material parameter belongs to (UE: EMaterialParameterAssociation, MaterialTypes.h). */
UENUM(BlueprintType)
enum EMaterialParameterAssociation : int {
    LayerParameter,
    BlendParameter,
    GlobalParameter,
};

/**
 * Identifies a material parameter (UE: FMaterialParameterInfo, MaterialTypes.h). The embedded engine's materials have
 * no layers, so the association is GlobalParameter and the index INDEX_NONE for every parameter that exists.
 */
USTRUCT(BlueprintType)
struct FMaterialParameterInfo {
    GENERATED_BODY()

    /** Parameter name; compared without case, like every FName. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Parameter")
    FName Name;

    /** Whether this is a global parameter or belongs to a layer or blend. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Parameter")
    TEnumAsByte<EMaterialParameterAssociation> Association = EMaterialParameterAssociation::GlobalParameter;

    /** Layer or blend index, INDEX_NONE for a global parameter. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Parameter")
    int32 Index = INDEX_NONE;

    FMaterialParameterInfo() = default;

    FMaterialParameterInfo(const FName& InName,
        EMaterialParameterAssociation InAssociation = EMaterialParameterAssociation::GlobalParameter,
        int32 InIndex = INDEX_NONE)
        : Name(InName), Association(InAssociation), Index(InIndex) {}

    FMaterialParameterInfo(const TCHAR* InName,
        EMaterialParameterAssociation InAssociation = EMaterialParameterAssociation::GlobalParameter,
        int32 InIndex = INDEX_NONE)
        : Name(InName), Association(InAssociation), Index(InIndex) {}

    friend bool operator==(const FMaterialParameterInfo& A, const FMaterialParameterInfo& B) {
        return A.Name == B.Name && A.Association == B.Association && A.Index == B.Index;
    }

    friend bool operator!=(const FMaterialParameterInfo& A, const FMaterialParameterInfo& B) { return !(A == B); }
};

/**
 * Parameter key of the getters of UMaterialInterface (UE: FHashedMaterialParameterInfo, MaterialTypes.h); made
 * implicitly from a name or an FMaterialParameterInfo.
 */
struct FHashedMaterialParameterInfo {
    FHashedMaterialParameterInfo(const FName& InName) : Info(InName) {}
    FHashedMaterialParameterInfo(const TCHAR* InName) : Info(InName) {}
    FHashedMaterialParameterInfo(const FMaterialParameterInfo& InInfo) : Info(InInfo) {}

    /** Name of the parameter. */
    FName GetName() const { return Info.Name; }

    /** The whole key. */
    const FMaterialParameterInfo& GetInfo() const { return Info; }

private:
    FMaterialParameterInfo Info;
};
