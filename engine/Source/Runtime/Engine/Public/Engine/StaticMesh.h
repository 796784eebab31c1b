// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"
#include "Engine/StaticMeshGeometry.h"
#include "Engine/StreamableRenderAsset.h"
#include "UObject/Object.h"

#include "StaticMesh.generated.h"

class UMaterialInterface;

/**
 * One material slot of a static mesh (UE: FStaticMaterial, Engine/StaticMesh.h).
 */
USTRUCT(BlueprintType)
struct FStaticMaterial {
    GENERATED_BODY()

    FStaticMaterial() = default;

    /** Makes a slot from a material and an optional name, as UE's constructor does. */
    explicit FStaticMaterial(UMaterialInterface* InMaterialInterface, FName InMaterialSlotName = NAME_None)
        : MaterialInterface(InMaterialInterface), MaterialSlotName(InMaterialSlotName) {}

    /** The material that sections of this slot are drawn with. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "StaticMesh")
    TObjectPtr<UMaterialInterface> MaterialInterface = nullptr;

    /** Name by which the slot is found, see UStaticMesh::GetMaterialIndex. */
    UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "StaticMesh")
    FName MaterialSlotName;
};

/**
 * A mesh of triangles with material slots and no animation (UE: UStaticMesh, Engine/StaticMesh.h).
 *
 * The embedded engine keeps one level of detail, with its triangles in main memory; GetGeometry gives them to
 * renderers.
 */
UCLASS(BlueprintType)
class ENGINE_API UStaticMesh : public UStreamableRenderAsset {
    GENERATED_BODY()

public:
    /** Bounds of the mesh in mesh space: box and sphere round the same centre, centimetres. */
    UFUNCTION(BlueprintPure, Category = "StaticMesh")
    FBoxSphereBounds GetBounds() const;

    /** Axis-aligned box of the mesh in mesh space, centimetres. An empty mesh gives an empty box at the origin. */
    UFUNCTION(BlueprintPure, Category = "StaticMesh")
    FBox GetBoundingBox() const;

    /** Number of levels of detail: 1, or 0 for a mesh without triangles. */
    UFUNCTION(BlueprintPure, Category = "StaticMesh")
    int32 GetNumLODs() const;

    /** Number of triangles of a level of detail; 0 for a level that does not exist. */
    UFUNCTION(BlueprintPure, Category = "StaticMesh")
    int32 GetNumTriangles(int32 LODIndex) const;

    /** Number of sections (runs of triangles of one material slot) of a level of detail; 0 for one that does not exist.
     */
    UFUNCTION(BlueprintPure, Category = "StaticMesh")
    int32 GetNumSections(int32 InLOD) const;

    /** Number of vertices of a level of detail; 0 for a level that does not exist. */
    int32 GetNumVertices(int32 LODIndex) const;

    /** Material of a slot, or null if there is no such slot. */
    UFUNCTION(BlueprintCallable, Category = "StaticMesh")
    UMaterialInterface* GetMaterial(int32 MaterialIndex) const;

    /** Index of the slot with this name, or INDEX_NONE. */
    UFUNCTION(BlueprintCallable, Category = "StaticMesh")
    int32 GetMaterialIndex(FName MaterialSlotName) const;

    /** Adds a material slot and returns its name: "Slot_<n>", made unique among the slots. */
    UFUNCTION(BlueprintCallable, Category = "StaticMesh")
    FName AddMaterial(UMaterialInterface* Material);

    /** Replaces the material of an existing slot; other indices are ignored. */
    UFUNCTION(BlueprintCallable, Category = "StaticMesh")
    void SetMaterial(int32 MaterialIndex, UMaterialInterface* NewMaterial);

    /** The material slots. */
    UFUNCTION(BlueprintGetter)
    const TArray<FStaticMaterial>& GetStaticMaterials() const { return StaticMaterials; }

    /** The material slots, to be changed in place. */
    TArray<FStaticMaterial>& GetStaticMaterials() { return StaticMaterials; }

    /** Replaces all material slots. */
    UFUNCTION(BlueprintSetter)
    void SetStaticMaterials(const TArray<FStaticMaterial>& InStaticMaterials);

    /** The triangles in main memory. Embedded engine only. */
    const FStaticMeshGeometry& GetGeometry() const { return Geometry; }

    /**
     * Replaces the triangles and recomputes the bounds. Embedded engine only.
     *
     * @param InGeometry triangles in UE's mesh space; see FStaticMeshGeometry for what must hold.
     * @param OutError   what is wrong with InGeometry if it was refused.
     * @return whether InGeometry was consistent; if not, the mesh keeps what it had.
     */
    bool SetGeometry(FStaticMeshGeometry&& InGeometry, FString& OutError);

    /** Grows with every SetGeometry, so that a renderer knows when to rebuild. Embedded engine only. */
    uint32 GetGeometryRevision() const { return GeometryRevision; }

private:
    UPROPERTY(EditAnywhere, BlueprintGetter = GetStaticMaterials, BlueprintSetter = SetStaticMaterials,
        Category = "StaticMesh")
    TArray<FStaticMaterial> StaticMaterials;

    FStaticMeshGeometry Geometry;
    FBox BoundingBox = FBox(FVector::ZeroVector, FVector::ZeroVector);
    FBoxSphereBounds Bounds = FBoxSphereBounds(FVector::ZeroVector, FVector::ZeroVector, 0.0);
    uint32 GeometryRevision = 0;
};
