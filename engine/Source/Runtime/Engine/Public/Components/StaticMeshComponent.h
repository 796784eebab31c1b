// SPDX-License-Identifier: MIT
#pragma once

#include "Components/MeshComponent.h"
#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

#include "StaticMeshComponent.generated.h"

class UStaticMesh;

/** Shows a UStaticMesh. Epic page: UStaticMeshComponent. */
UCLASS(Blueprintable, ClassGroup = (Rendering, Common), HideCategories = (Object, Activation, "Components|Activation"),
    ShowCategories = (Mobility), EditInlineNew, meta = (BlueprintSpawnableComponent))
class ENGINE_API UStaticMeshComponent : public UMeshComponent {
    GENERATED_BODY()

private:
    /** The static mesh that this component uses to render. Change it with SetStaticMesh. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, Category = StaticMesh, meta = (AllowPrivateAccess = "true"))
    TObjectPtr<UStaticMesh> StaticMesh;

public:
    /** Controls whether the static mesh component's backface culling should be reversed. */
    UPROPERTY(EditAnywhere, BlueprintReadOnly, AdvancedDisplay, Category = Rendering)
    uint8 bReverseCulling : 1;

    UStaticMeshComponent(const FObjectInitializer& ObjectInitializer = FObjectInitializer::Get());

    /** Changes the mesh used by this instance; refused for a registered static component in a game. Returns whether it
     * changed. */
    UFUNCTION(BlueprintCallable, Category = "Components|StaticMesh")
    virtual bool SetStaticMesh(UStaticMesh* NewMesh);

    /** Gets the corners of the mesh's box, in the component's space, in centimetres. */
    UFUNCTION(BlueprintCallable, Category = "Components|StaticMesh")
    void GetLocalBounds(FVector& Min, FVector& Max) const;

    /** Controls whether the static mesh component's backface culling should be reversed. */
    UFUNCTION(BlueprintCallable, Category = "Rendering|StaticMesh")
    void SetReverseCulling(bool ReverseCulling);

    /** The mesh, or null. */
    UStaticMesh* GetStaticMesh() const { return StaticMesh; }

    // UMeshComponent, UPrimitiveComponent, USceneComponent
    virtual FBoxSphereBounds CalcBounds(const FTransform& LocalToWorld) const override;
    virtual int32 GetNumMaterials() const override;
    virtual UMaterialInterface* GetMaterial(int32 MaterialIndex) const override;
    virtual int32 GetMaterialIndex(FName MaterialSlotName) const override;
    virtual TArray<FName> GetMaterialSlotNames() const override;
    virtual bool IsMaterialSlotNameValid(FName MaterialSlotName) const override;
};
