// SPDX-License-Identifier: MIT
#pragma once

// From glTF's space (metres, right-handed, Y up) to UE's (centimetres, left-handed, Z up):
//     UE (X, Y, Z) = 100 * glTF (x, z, y)
// The map swaps two axes, so it is a reflection. A rotation by an angle about an axis becomes one by the negative angle
// about the mapped axis; cross products change sign, hence triangles keep their index order and tangents flip their W.

#include "CoreMinimal.h"
#include "Engine/StaticMeshGeometry.h"

#include "../ThirdParty/GltfFile.h"

namespace SceneConversion {

/** Centimetres in a metre. */
inline constexpr double UnitsPerMetre = 100.0;

/** A text of the file as FString. */
FString ToString(const std::string& Text);

/** A path or text for the file layer. */
std::string ToStd(const FString& Text);

/** A position in metres as a position in centimetres. */
FVector Position(const std::array<double, 3>& Metres);

/** A unit quaternion. */
FQuat Rotation(const std::array<double, 4>& Quaternion);

/** A node's own transform. */
FTransform NodeTransform(const SceneFile::FNode& Node);

/** glTF's lights and cameras look along -Z, UE's along +X: to be applied before the node's rotation. */
FQuat LookRotation();

/** A whole mesh: sections in the order of the primitives; missing normals and tangents are computed. */
FStaticMeshGeometry Geometry(const SceneFile::FMesh& Mesh);

/** Fills Tangents from positions, normals and texture coordinates, or with any perpendicular where those give none. */
void ComputeTangents(FStaticMeshGeometry& Geometry);

} // namespace SceneConversion
