// SPDX-License-Identifier: MIT
#pragma once

#include "Components/PrimitiveComponent.h"
#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

#include "MeshComponent.generated.h"

class UMaterialInterface;

/** Abstract base for components that render a collection of triangles, with one material for each slot. Epic page:
 * UMeshComponent. */
UCLASS(Abstract, ClassGroup = (Rendering, Common), HideCategories = (Object, LOD, PhysicsVolume), EditInlineNew)
class ENGINE_API UMeshComponent : public UPrimitiveComponent {
    GENERATED_BODY()

public:
    /** Per-component material overrides. These must NOT be set directly or a race condition can occur in UE's renderer:
     * use SetMaterial. */
    UPROPERTY(EditAnywhere, AdvancedDisplay, Category = Rendering)
    TArray<TObjectPtr<UMaterialInterface>> OverrideMaterials;

    /** Translucent material to blend on top of this mesh. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, AdvancedDisplay, Category = Rendering)
    TObjectPtr<UMaterialInterface> OverlayMaterial;

    UMeshComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Returns the materials in use, one for each slot. */
    UFUNCTION(BlueprintCallable, Category = "Components|Mesh")
    virtual TArray<UMaterialInterface*> GetMaterials() const;

    /** Returns the index of the slot with that name, or INDEX_NONE. */
    UFUNCTION(BlueprintCallable, Category = "Components|Mesh")
    virtual int32 GetMaterialIndex(FName MaterialSlotName) const;

    /** Returns the names of the slots. */
    UFUNCTION(BlueprintCallable, Category = "Components|Mesh")
    virtual TArray<FName> GetMaterialSlotNames() const;

    /** Whether there is a slot with that name. */
    UFUNCTION(BlueprintCallable, Category = "Components|Mesh")
    virtual bool IsMaterialSlotNameValid(FName MaterialSlotName) const;

    /** Sets a scalar parameter on every dynamic material instance of this component, making instances where there are
     * none. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material")
    void SetScalarParameterValueOnMaterials(const FName ParameterName, const float ParameterValue);

    /** Sets a vector parameter on every dynamic material instance of this component, making instances where there are
     * none. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material")
    void SetVectorParameterValueOnMaterials(const FName ParameterName, const FVector ParameterValue);

    /** Sets the translucent material to blend on top of this mesh. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|Material")
    void SetOverlayMaterial(UMaterialInterface* NewOverlayMaterial);

    /** Number of entries of the override list. */
    int32 GetNumOverrideMaterials() const { return OverrideMaterials.Num(); }
    /** Drops all overrides: the materials of the mesh are used again. */
    virtual void EmptyOverrideMaterials();

    // UPrimitiveComponent
    virtual int32 GetNumMaterials() const override;
    virtual UMaterialInterface* GetMaterial(int32 ElementIndex) const override;
    virtual UMaterialInterface* GetMaterialByName(FName MaterialSlotName) const override;
    virtual void SetMaterial(int32 ElementIndex, UMaterialInterface* Material) override;
    virtual void SetMaterialByName(FName MaterialSlotName, UMaterialInterface* Material) override;

private:
    UMaterialInstanceDynamic* GetOrMakeDynamicMaterial(int32 ElementIndex);
};
