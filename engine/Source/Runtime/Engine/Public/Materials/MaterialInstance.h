// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Engine/Texture.h"
#include "MaterialTypes.h"
#include "Materials/MaterialInterface.h"

#include "MaterialInstance.generated.h"

/** Overridden scalar parameter (UE: FScalarParameterValue, Materials/MaterialInstance.h). */
USTRUCT(BlueprintType)
struct FScalarParameterValue {
    GENERATED_BODY()

    /** Which parameter. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Parameter")
    FMaterialParameterInfo ParameterInfo;

    /** Its value. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Parameter")
    float ParameterValue = 0.0f;

    FScalarParameterValue() = default;

    FScalarParameterValue(const FMaterialParameterInfo& InParameterInfo, float InValue)
        : ParameterInfo(InParameterInfo), ParameterValue(InValue) {}
};

/** Overridden vector parameter (UE: FVectorParameterValue, Materials/MaterialInstance.h). */
USTRUCT(BlueprintType)
struct FVectorParameterValue {
    GENERATED_BODY()

    /** Which parameter. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Parameter")
    FMaterialParameterInfo ParameterInfo;

    /** Its value; colours are linear. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Parameter")
    FLinearColor ParameterValue = FLinearColor(0.0f, 0.0f, 0.0f, 0.0f);

    FVectorParameterValue() = default;

    FVectorParameterValue(const FMaterialParameterInfo& InParameterInfo, const FLinearColor& InValue)
        : ParameterInfo(InParameterInfo), ParameterValue(InValue) {}
};

/** Overridden texture parameter (UE: FTextureParameterValue, Materials/MaterialInstance.h). */
USTRUCT(BlueprintType)
struct FTextureParameterValue {
    GENERATED_BODY()

    /** Which parameter. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Parameter")
    FMaterialParameterInfo ParameterInfo;

    /** Its value; null counts as white. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Parameter")
    TObjectPtr<UTexture> ParameterValue = nullptr;

    FTextureParameterValue() = default;

    FTextureParameterValue(const FMaterialParameterInfo& InParameterInfo, UTexture* InValue)
        : ParameterInfo(InParameterInfo), ParameterValue(InValue) {}
};

/**
 * Properties of the base material that an instance overrides (UE: FMaterialInstanceBasePropertyOverrides,
 * Materials/MaterialInstanceBasePropertyOverrides.h).
 */
USTRUCT(BlueprintType)
struct FMaterialInstanceBasePropertyOverrides {
    GENERATED_BODY()

    /** Whether OpacityMaskClipValue counts. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Material")
    uint8 bOverride_OpacityMaskClipValue : 1;

    /** Whether BlendMode counts. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Material")
    uint8 bOverride_BlendMode : 1;

    /** Whether TwoSided counts. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Material")
    uint8 bOverride_TwoSided : 1;

    /** Whether back faces are drawn too. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Material")
    uint8 TwoSided : 1;

    /** How the surface covers what is behind it. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Material")
    TEnumAsByte<EBlendMode> BlendMode = BLEND_Opaque;

    /** Opacity below which a masked surface has a hole. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Material")
    float OpacityMaskClipValue = 0.3333f;

    FMaterialInstanceBasePropertyOverrides()
        : bOverride_OpacityMaskClipValue(0), bOverride_BlendMode(0), bOverride_TwoSided(0), TwoSided(0) {}
};

/**
 * A material with some parameters overridden (UE: UMaterialInstance, Materials/MaterialInstance.h).
 */
UCLASS(Abstract, BlueprintType)
class ENGINE_API UMaterialInstance : public UMaterialInterface {
    GENERATED_BODY()

public:
    /** The material or instance whose parameters this one overrides. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = "MaterialInstance")
    TObjectPtr<UMaterialInterface> Parent = nullptr;

    /** Overridden scalar parameters. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = "MaterialInstance")
    TArray<FScalarParameterValue> ScalarParameterValues;

    /** Overridden vector parameters. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = "MaterialInstance")
    TArray<FVectorParameterValue> VectorParameterValues;

    /** Overridden texture parameters. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = "MaterialInstance")
    TArray<FTextureParameterValue> TextureParameterValues;

    /** Overridden properties of the base material. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = "MaterialInstance")
    FMaterialInstanceBasePropertyOverrides BasePropertyOverrides;

    virtual UMaterial* GetMaterial() override;
    virtual const UMaterial* GetMaterial() const override;
    virtual EBlendMode GetBlendMode() const override;
    virtual bool IsTwoSided() const override;
    virtual float GetOpacityMaskClipValue() const override;
    virtual bool GetScalarParameterValue(
        const FHashedMaterialParameterInfo& ParameterInfo, float& OutValue, bool bOveriddenOnly = false) const override;
    virtual bool GetVectorParameterValue(const FHashedMaterialParameterInfo& ParameterInfo, FLinearColor& OutValue,
        bool bOveriddenOnly = false) const override;
    virtual bool GetTextureParameterValue(const FHashedMaterialParameterInfo& ParameterInfo, UTexture*& OutValue,
        bool bOveriddenOnly = false) const override;
    virtual uint32 GetParametersRevision() const override;

protected:
    /** Sets the parent; a parent that has this instance among its own parents is refused with a log line. */
    void SetParentInternal(UMaterialInterface* NewParent);

    /** Overrides a scalar parameter. */
    void SetScalarParameterValueInternal(const FMaterialParameterInfo& ParameterInfo, float Value);

    /** Overrides a vector parameter. */
    void SetVectorParameterValueInternal(const FMaterialParameterInfo& ParameterInfo, FLinearColor Value);

    /** Overrides a texture parameter. */
    void SetTextureParameterValueInternal(const FMaterialParameterInfo& ParameterInfo, UTexture* Value);

    /** Drops all overridden parameters. */
    void ClearParameterValuesInternal();
};
