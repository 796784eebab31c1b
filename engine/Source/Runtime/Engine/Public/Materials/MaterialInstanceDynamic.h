// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Materials/MaterialInstance.h"

#include "MaterialInstanceDynamic.generated.h"

/**
 * A material instance whose parameters change while the world runs (UE: UMaterialInstanceDynamic,
 * Materials/MaterialInstanceDynamic.h). The parameter names are in Materials/Material.h; setting a name the material
 * does not have is allowed, as in UE, and has no effect on the surface.
 */
UCLASS(BlueprintType)
class ENGINE_API UMaterialInstanceDynamic : public UMaterialInstance {
    GENERATED_BODY()

public:
    /** Makes an instance over a material, in the transient package if InOuter is null. Null for a null material. */
    static UMaterialInstanceDynamic* Create(UMaterialInterface* ParentMaterial, UObject* InOuter);

    /** Makes an instance over a material with a name of its own. */
    static UMaterialInstanceDynamic* Create(UMaterialInterface* ParentMaterial, UObject* InOuter, FName Name);

    /** Overrides a scalar (float) parameter. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material", meta = (Keywords = "SetFloatParameterValue"))
    void SetScalarParameterValue(FName ParameterName, float Value);

    /** Overrides a scalar (float) parameter. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material")
    void SetScalarParameterValueByInfo(const FMaterialParameterInfo& ParameterInfo, float Value);

    /** Value of a scalar (float) parameter, 0 if there is none. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material",
        meta = (DisplayName = "GetScalarParameterValue", ScriptName = "GetScalarParameterValue",
            Keywords = "GetFloatParameterValue"))
    float K2_GetScalarParameterValue(FName ParameterName);

    /** Overrides a texture parameter; null counts as white. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material")
    void SetTextureParameterValue(FName ParameterName, UTexture* Value);

    /** Overrides a texture parameter; null counts as white. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material")
    void SetTextureParameterValueByInfo(const FMaterialParameterInfo& ParameterInfo, UTexture* Value);

    /** Value of a texture parameter, null if there is none. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material",
        meta = (DisplayName = "GetTextureParameterValue", ScriptName = "GetTextureParameterValue"))
    UTexture* K2_GetTextureParameterValue(FName ParameterName);

    /** Overrides a vector parameter; colours are linear. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material", meta = (Keywords = "SetColorParameterValue"))
    void SetVectorParameterValue(FName ParameterName, FLinearColor Value);

    /** Overrides a vector parameter; colours are linear. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material")
    void SetVectorParameterValueByInfo(const FMaterialParameterInfo& ParameterInfo, FLinearColor Value);

    /** Value of a vector parameter, transparent black if there is none. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material",
        meta = (DisplayName = "GetVectorParameterValue", ScriptName = "GetVectorParameterValue",
            Keywords = "GetColorParameterValue"))
    FLinearColor K2_GetVectorParameterValue(FName ParameterName);

    /**
     * Blends the scalar and vector parameters of two instances of one material into this instance; a null source is
     * ignored.
     *
     * @param Alpha 0 gives SourceA, 1 gives SourceB, values outside 0..1 extrapolate.
     */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material",
        meta = (DisplayName = "Interpolate Material Instance Parameters",
            ScriptName = "InterpolateMaterialInstanceParameters"))
    void K2_InterpolateMaterialInstanceParams(UMaterialInstance* SourceA, UMaterialInstance* SourceB, float Alpha);

    /** Drops all overridden parameters. */
    void ClearParameterValues();
};
