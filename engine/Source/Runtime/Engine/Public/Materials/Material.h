// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Materials/MaterialInstance.h"
#include "Materials/MaterialInterface.h"

#include "Material.generated.h"

/**
 * A material (UE: UMaterial, Materials/Material.h).
 *
 * In UE a material is a graph of expressions. In the embedded engine every material is the metallic-roughness surface
 * of glTF 2.0 and has these parameters:
 *
 * | name | kind | meaning |
 * |---|---|---|
 * | BaseColor | vector | linear colour, A is the opacity |
 * | EmissiveColor | vector | linear emitted radiance |
 * | UVTransform | vector | R, G scale and B, A offset of the texture coordinates |
 * | Metallic, Roughness, Specular | scalar | 0 to 1 |
 * | NormalScale, OcclusionStrength | scalar | strength of the maps |
 * | BaseColorTexture, EmissiveTexture | texture | sRGB colour |
 * | OcclusionRoughnessMetallicTexture | texture | R occlusion, G roughness, B metallic |
 * | NormalTexture | texture | tangent-space normals, green up |
 *
 * "/Engine/EngineMaterials/DefaultMaterial.DefaultMaterial" is a plain grey one; scenes instance
 * "/Engine/EngineMaterials/Surface.Surface".
 */
UCLASS(BlueprintType)
class ENGINE_API UMaterial : public UMaterialInterface {
    GENERATED_BODY()

public:
    /** How the surface covers what is behind it. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = "Material")
    TEnumAsByte<EBlendMode> BlendMode;

    /** Whether back faces are drawn too. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = "Material")
    uint8 TwoSided : 1;

    /** Opacity below which a masked surface has a hole. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = "Material")
    float OpacityMaskClipValue;

    UMaterial(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

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

    /** Changes the default of an existing scalar parameter; false if there is none of that name. Embedded engine only.
     */
    bool SetScalarParameterDefault(FName ParameterName, float Value);

    /** Changes the default of an existing vector parameter; false if there is none of that name. Embedded engine only.
     */
    bool SetVectorParameterDefault(FName ParameterName, FLinearColor Value);

    /** Changes the default of an existing texture parameter; false if there is none of that name. Embedded engine only.
     */
    bool SetTextureParameterDefault(FName ParameterName, UTexture* Value);

private:
    UPROPERTY()
    TArray<FScalarParameterValue> ScalarParameterDefaults;

    UPROPERTY()
    TArray<FVectorParameterValue> VectorParameterDefaults;

    UPROPERTY()
    TArray<FTextureParameterValue> TextureParameterDefaults;
};
