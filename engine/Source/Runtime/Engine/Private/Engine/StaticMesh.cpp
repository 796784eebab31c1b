// SPDX-License-Identifier: MIT
#include "Engine/StaticMesh.h"

#include "Materials/MaterialInterface.h"

FBoxSphereBounds UStaticMesh::GetBounds() const { return Bounds; }

FBox UStaticMesh::GetBoundingBox() const { return BoundingBox; }

int32 UStaticMesh::GetNumLODs() const { return Geometry.NumTriangles() > 0 ? 1 : 0; }

int32 UStaticMesh::GetNumTriangles(int32 LODIndex) const { return LODIndex == 0 ? Geometry.NumTriangles() : 0; }

int32 UStaticMesh::GetNumSections(int32 InLOD) const { return InLOD == 0 ? Geometry.Sections.Num() : 0; }

int32 UStaticMesh::GetNumVertices(int32 LODIndex) const { return LODIndex == 0 ? Geometry.NumVertices() : 0; }

UMaterialInterface* UStaticMesh::GetMaterial(int32 MaterialIndex) const {
    return StaticMaterials.IsValidIndex(MaterialIndex) ? StaticMaterials[MaterialIndex].MaterialInterface.Get()
                                                       : nullptr;
}

int32 UStaticMesh::GetMaterialIndex(FName MaterialSlotName) const {
    for (int32 Index = 0; Index < StaticMaterials.Num(); ++Index) {
        if (StaticMaterials[Index].MaterialSlotName == MaterialSlotName) {
            return Index;
        }
    }
    return INDEX_NONE;
}

FName UStaticMesh::AddMaterial(UMaterialInterface* Material) {
    int32 Number = StaticMaterials.Num();
    FName Name(*FString::Printf(TEXT("Slot_%d"), Number));
    while (GetMaterialIndex(Name) != INDEX_NONE) {
        Name = FName(*FString::Printf(TEXT("Slot_%d"), ++Number));
    }
    StaticMaterials.Add(FStaticMaterial(Material, Name));
    return Name;
}

void UStaticMesh::SetMaterial(int32 MaterialIndex, UMaterialInterface* NewMaterial) {
    if (StaticMaterials.IsValidIndex(MaterialIndex)) {
        StaticMaterials[MaterialIndex].MaterialInterface = NewMaterial;
    }
}

void UStaticMesh::SetStaticMaterials(const TArray<FStaticMaterial>& InStaticMaterials) {
    StaticMaterials = InStaticMaterials;
}

bool UStaticMesh::SetGeometry(FStaticMeshGeometry&& InGeometry, FString& OutError) {
    const int32 NumVertices = InGeometry.Positions.Num();
    const auto Fits = [NumVertices](int32 Count, bool bMayBeEmpty) {
        return Count == NumVertices || (bMayBeEmpty && Count == 0);
    };
    if (!Fits(InGeometry.Normals.Num(), false) || !Fits(InGeometry.Tangents.Num(), false) ||
        !Fits(InGeometry.TexCoords0.Num(), false) || !Fits(InGeometry.TexCoords1.Num(), true) ||
        !Fits(InGeometry.Colors.Num(), true)) {
        OutError = FString::Printf(
            TEXT("%s: there are %d positions, but %d normals, %d tangents and %d texture coordinates"), *GetPathName(),
            NumVertices, InGeometry.Normals.Num(), InGeometry.Tangents.Num(), InGeometry.TexCoords0.Num());
        return false;
    }
    for (const uint32 Index : InGeometry.Indices) {
        if (Index >= static_cast<uint32>(NumVertices)) {
            OutError = FString::Printf(
                TEXT("%s: a triangle uses vertex %u, but there are %d"), *GetPathName(), Index, NumVertices);
            return false;
        }
    }
    uint32 Covered = 0;
    for (const FStaticMeshGeometrySection& Section : InGeometry.Sections) {
        if (Section.FirstIndex != Covered ||
            Section.NumTriangles > (static_cast<uint32>(InGeometry.Indices.Num()) - Covered) / 3) {
            OutError = FString::Printf(TEXT("%s: the sections do not follow each other over the %d indices"),
                *GetPathName(), InGeometry.Indices.Num());
            return false;
        }
        Covered += 3 * Section.NumTriangles;
    }
    if (Covered != static_cast<uint32>(InGeometry.Indices.Num())) {
        OutError = FString::Printf(
            TEXT("%s: the sections cover %u of %d indices"), *GetPathName(), Covered, InGeometry.Indices.Num());
        return false;
    }
    Geometry = MoveTemp(InGeometry);
    if (NumVertices > 0) {
        FVector Min(Geometry.Positions[0]);
        FVector Max = Min;
        for (const FVector3f& Position : Geometry.Positions) {
            const FVector Point(Position);
            Min = Min.ComponentMin(Point);
            Max = Max.ComponentMax(Point);
        }
        BoundingBox = FBox(Min, Max);
        double SquaredRadius = 0.0;
        const FVector Centre = BoundingBox.GetCenter();
        for (const FVector3f& Position : Geometry.Positions) {
            SquaredRadius = FMath::Max(SquaredRadius, FVector::DistSquared(FVector(Position), Centre));
        }
        Bounds = FBoxSphereBounds(Centre, BoundingBox.GetExtent(), FMath::Sqrt(SquaredRadius));
    } else {
        BoundingBox = FBox(FVector::ZeroVector, FVector::ZeroVector);
        Bounds = FBoxSphereBounds(FVector::ZeroVector, FVector::ZeroVector, 0.0);
    }
    ++GeometryRevision;
    return true;
}
