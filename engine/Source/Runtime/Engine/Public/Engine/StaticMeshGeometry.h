// SPDX-License-Identifier: MIT
#pragma once

#include "CoreMinimal.h"

/**
 * A run of triangles that share one material slot. Embedded engine only.
 */
struct FStaticMeshGeometrySection {
    /** Index into UStaticMesh::GetStaticMaterials(). */
    int32 MaterialIndex = 0;
    /** First entry of FStaticMeshGeometry::Indices. */
    uint32 FirstIndex = 0;
    /** Triangles in this section; 3 * NumTriangles entries of Indices from FirstIndex on. */
    uint32 NumTriangles = 0;
};

/**
 * The triangles of a UStaticMesh in main memory, for renderers, ray casts and physics. Embedded engine only: UE keeps
 * this in FStaticMeshRenderData, whose layout belongs to its GPU renderer.
 *
 * Everything is in UE's mesh space: centimetres, left-handed, Z up. All vertex arrays have the same length or are empty
 * (TexCoords1 and Colors may be empty). Triangles are wound so that (C - A) x (B - A), computed with UE's
 * FVector::CrossProduct, points out of the front face.
 */
struct FStaticMeshGeometry {
    /** Vertex positions, centimetres. */
    TArray<FVector3f> Positions;
    /** Unit vertex normals. */
    TArray<FVector3f> Normals;
    /** Unit tangents along increasing U. W is +1 or -1: W * (Normal x Tangent) points up in the image, where V
     * decreases. */
    TArray<FVector4f> Tangents;
    /** First texture coordinate set, V growing downwards in the image. */
    TArray<FVector2f> TexCoords0;
    /** Second texture coordinate set, or empty. */
    TArray<FVector2f> TexCoords1;
    /** Vertex colours (linear values in 0..255), or empty. */
    TArray<FColor> Colors;
    /** Three vertex indices a triangle. */
    TArray<uint32> Indices;
    /** Sections in the order of the index array; together they cover it exactly. */
    TArray<FStaticMeshGeometrySection> Sections;

    /** Number of vertices. */
    int32 NumVertices() const { return Positions.Num(); }

    /** Number of triangles over all sections. */
    int32 NumTriangles() const { return Indices.Num() / 3; }
};
