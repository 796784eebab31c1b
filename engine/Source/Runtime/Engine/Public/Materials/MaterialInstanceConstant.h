// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Materials/MaterialInstance.h"

#include "MaterialInstanceConstant.generated.h"

/**
 * A material instance that is an asset and does not change while the world runs (UE: UMaterialInstanceConstant).
 * Materials of a loaded scene are of this class; to change one, put a UMaterialInstanceDynamic over it.
 */
UCLASS(BlueprintType)
class ENGINE_API UMaterialInstanceConstant : public UMaterialInstance {
    GENERATED_BODY()

public:
    /** Value of a scalar parameter, 0 if there is none. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material",
        meta = (DisplayName = "GetScalarParameterValue", ScriptName = "GetScalarParameterValue",
            Keywords = "GetFloatParameterValue"))
    float K2_GetScalarParameterValue(FName ParameterName);

    /** Value of a texture parameter, null if there is none. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material",
        meta = (DisplayName = "GetTextureParameterValue", ScriptName = "GetTextureParameterValue"))
    UTexture* K2_GetTextureParameterValue(FName ParameterName);

    /** Value of a vector parameter, transparent black if there is none. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material",
        meta = (DisplayName = "GetVectorParameterValue", ScriptName = "GetVectorParameterValue"))
    FLinearColor K2_GetVectorParameterValue(FName ParameterName);

    /** Sets parent and overrides at load time. Embedded engine only (UE: editor-only setters of the same meaning). */
    void InitializeAsset(UMaterialInterface* InParent, const TArray<FScalarParameterValue>& Scalars,
        const TArray<FVectorParameterValue>& Vectors, const TArray<FTextureParameterValue>& Textures,
        const FMaterialInstanceBasePropertyOverrides& Overrides);
};
