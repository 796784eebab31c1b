// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "MaterialTypes.h"
#include "Materials/BlendMode.h"
#include "Materials/SurfaceParameters.h"
#include "UObject/Object.h"

#include "MaterialInterface.generated.h"

class UMaterial;
class UTexture;

/**
 * What can be put on a surface: a material or an instance of one (UE: UMaterialInterface,
 * Materials/MaterialInterface.h).
 */
UCLASS(Abstract, BlueprintType)
class ENGINE_API UMaterialInterface : public UObject {
    GENERATED_BODY()

public:
    /** The material at the root of the chain of instances, null for an instance without parent. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material")
    UMaterial* GetBaseMaterial();

    /** The material at the root of the chain of instances (UE: UMaterialInterface::GetMaterial). */
    virtual UMaterial* GetMaterial();

    /** The material at the root of the chain of instances. */
    virtual const UMaterial* GetMaterial() const;

    /** How the surface covers what is behind it, overrides of instances counted. */
    virtual EBlendMode GetBlendMode() const;

    /** Whether back faces are drawn, overrides of instances counted. */
    virtual bool IsTwoSided() const;

    /** Opacity below which a masked surface has a hole. */
    virtual float GetOpacityMaskClipValue() const;

    /**
     * Value of a scalar parameter as this material sees it.
     *
     * @param ParameterInfo      name of the parameter.
     * @param OutValue           the value; unchanged when the result is false.
     * @param bOveriddenOnly     only look at what instances override, not at the default of the material.
     * @return whether there is such a parameter.
     */
    virtual bool GetScalarParameterValue(
        const FHashedMaterialParameterInfo& ParameterInfo, float& OutValue, bool bOveriddenOnly = false) const;

    /** Value of a vector parameter as this material sees it; arguments as GetScalarParameterValue. */
    virtual bool GetVectorParameterValue(
        const FHashedMaterialParameterInfo& ParameterInfo, FLinearColor& OutValue, bool bOveriddenOnly = false) const;

    /** Value of a texture parameter as this material sees it; arguments as GetScalarParameterValue. */
    virtual bool GetTextureParameterValue(
        const FHashedMaterialParameterInfo& ParameterInfo, UTexture*& OutValue, bool bOveriddenOnly = false) const;

    /** All parameters resolved, for a renderer. Embedded engine only. */
    FSurfaceParameters GetSurfaceParameters() const;

    /**
     * Grows whenever a parameter of this object or of a parent changed through the setters, so that a renderer knows
     * when to call GetSurfaceParameters again. Embedded engine only.
     */
    virtual uint32 GetParametersRevision() const;

protected:
    /** To be called by setters. */
    void MarkParametersChanged() { ++ParametersRevision; }

    /** Changes of this object alone. */
    uint32 ParametersRevision = 0;
};
