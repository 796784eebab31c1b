// SPDX-License-Identifier: MIT
#include "SceneConversion.h"

namespace SceneConversion {
namespace {

FVector3f MapPosition(const float* V) {
    constexpr float Scale = static_cast<float>(UnitsPerMetre);
    return FVector3f(V[0] * Scale, V[2] * Scale, V[1] * Scale);
}

FVector3f MapDirection(const float* V) { return FVector3f(V[0], V[2], V[1]); }

FVector3f UnitOr(const FVector3f& V, const FVector3f& Default) {
    const float Length = static_cast<float>(FMath::Sqrt(V.X * V.X + V.Y * V.Y + V.Z * V.Z));
    return Length > 1e-12f ? V / Length : Default;
}

/** Any unit vector perpendicular to a unit vector. */
FVector3f Perpendicular(const FVector3f& Normal) {
    const FVector3f Axis = FMath::Abs(Normal.X) < 0.9f ? FVector3f(1.0f, 0.0f, 0.0f) : FVector3f(0.0f, 1.0f, 0.0f);
    return UnitOr(Axis - Normal * FVector3f::DotProduct(Axis, Normal), FVector3f(0.0f, 0.0f, 1.0f));
}

uint8 Channel(float Value) { return static_cast<uint8>(FMath::Clamp(Value, 0.0f, 1.0f) * 255.0f + 0.5f); }

/** Adds one vertex of a primitive with what the primitive has. */
void AddVertex(FStaticMeshGeometry& Out, const SceneFile::FPrimitive& In, uint32 Index, bool bSecondSet, bool bColors) {
    Out.Positions.Add(MapPosition(&In.Positions[3 * Index]));
    if (!In.Normals.empty()) {
        Out.Normals.Add(UnitOr(MapDirection(&In.Normals[3 * Index]), FVector3f(0.0f, 0.0f, 1.0f)));
    }
    if (!In.Tangents.empty() && !In.Normals.empty()) {
        const float* T = &In.Tangents[4 * Index];
        const FVector3f Direction = UnitOr(MapDirection(T), Perpendicular(Out.Normals.Last()));
        Out.Tangents.Add(FVector4f(Direction.X, Direction.Y, Direction.Z, T[3] < 0.0f ? 1.0f : -1.0f));
    }
    Out.TexCoords0.Add(In.TexCoords0.empty() ? FVector2f(0.0f, 0.0f)
                                             : FVector2f(In.TexCoords0[2 * Index], In.TexCoords0[2 * Index + 1]));
    if (bSecondSet) {
        Out.TexCoords1.Add(In.TexCoords1.empty() ? FVector2f(0.0f, 0.0f)
                                                 : FVector2f(In.TexCoords1[2 * Index], In.TexCoords1[2 * Index + 1]));
    }
    if (bColors) {
        const float* C = In.Colors.empty() ? nullptr : &In.Colors[4 * Index];
        Out.Colors.Add(
            C ? FColor(Channel(C[0]), Channel(C[1]), Channel(C[2]), Channel(C[3])) : FColor(255, 255, 255, 255));
    }
}

/** One primitive on its own, indices from 0. */
FStaticMeshGeometry ConvertPrimitive(const SceneFile::FPrimitive& In, bool bSecondSet, bool bColors) {
    FStaticMeshGeometry Out;
    if (In.Normals.empty()) {
        // Without normals faces are flat (glTF 2.0, section 3.7.2.1), so that no two triangles can share a vertex.
        for (uint32 Corner = 0; Corner < In.Indices.size(); ++Corner) {
            AddVertex(Out, In, In.Indices[Corner], bSecondSet, bColors);
            Out.Indices.Add(Corner);
        }
        for (int32 Corner = 0; Corner + 2 < Out.Positions.Num(); Corner += 3) {
            const FVector3f AB = Out.Positions[Corner + 1] - Out.Positions[Corner];
            const FVector3f AC = Out.Positions[Corner + 2] - Out.Positions[Corner];
            const FVector3f Normal = UnitOr(FVector3f::CrossProduct(AC, AB), FVector3f(0.0f, 0.0f, 1.0f));
            for (int32 Repeat = 0; Repeat < 3; ++Repeat) {
                Out.Normals.Add(Normal);
            }
        }
    } else {
        const uint32 Count = static_cast<uint32>(In.Positions.size() / 3);
        for (uint32 Index = 0; Index < Count; ++Index) {
            AddVertex(Out, In, Index, bSecondSet, bColors);
        }
        Out.Indices.Reserve(static_cast<int32>(In.Indices.size()));
        for (const uint32 Index : In.Indices) {
            Out.Indices.Add(Index);
        }
    }
    if (Out.Tangents.Num() != Out.Positions.Num()) {
        ComputeTangents(Out);
    }
    return Out;
}

} // namespace

FString ToString(const std::string& Text) { return FString(UTF8_TO_TCHAR(Text.c_str())); }

std::string ToStd(const FString& Text) { return std::string(TCHAR_TO_UTF8(*Text)); }

FVector Position(const std::array<double, 3>& Metres) {
    return FVector(Metres[0], Metres[2], Metres[1]) * UnitsPerMetre;
}

FQuat Rotation(const std::array<double, 4>& Quaternion) {
    return FQuat(-Quaternion[0], -Quaternion[2], -Quaternion[1], Quaternion[3]);
}

FTransform NodeTransform(const SceneFile::FNode& Node) {
    return FTransform(
        Rotation(Node.Rotation), Position(Node.Translation), FVector(Node.Scale[0], Node.Scale[2], Node.Scale[1]));
}

FQuat LookRotation() { return FQuat(FRotator(0.0, -90.0, 0.0)); }

void ComputeTangents(FStaticMeshGeometry& Geometry) {
    const int32 Count = Geometry.Positions.Num();
    TArray<FVector3f> AlongU;
    TArray<FVector3f> AlongUp;
    AlongU.SetNumZeroed(Count);
    AlongUp.SetNumZeroed(Count);
    for (int32 Corner = 0; Corner + 2 < Geometry.Indices.Num(); Corner += 3) {
        const int32 I0 = static_cast<int32>(Geometry.Indices[Corner]);
        const int32 I1 = static_cast<int32>(Geometry.Indices[Corner + 1]);
        const int32 I2 = static_cast<int32>(Geometry.Indices[Corner + 2]);
        const FVector3f E1 = Geometry.Positions[I1] - Geometry.Positions[I0];
        const FVector3f E2 = Geometry.Positions[I2] - Geometry.Positions[I0];
        const FVector2f D1 = Geometry.TexCoords0[I1] - Geometry.TexCoords0[I0];
        const FVector2f D2 = Geometry.TexCoords0[I2] - Geometry.TexCoords0[I0];
        const float Determinant = D1.X * D2.Y - D2.X * D1.Y;
        if (FMath::Abs(Determinant) < 1e-20f) {
            continue;
        }
        // Only the directions count; the sum weighs triangles by their area in space through the length of the edges.
        const float Sign = Determinant > 0.0f ? 1.0f : -1.0f;
        const FVector3f U = (E1 * D2.Y - E2 * D1.Y) * Sign;
        const FVector3f Up = (E1 * D2.X - E2 * D1.X) * Sign;
        for (const int32 Index : {I0, I1, I2}) {
            AlongU[Index] = AlongU[Index] + U;
            AlongUp[Index] = AlongUp[Index] + Up;
        }
    }
    Geometry.Tangents.Empty(Count);
    for (int32 Index = 0; Index < Count; ++Index) {
        const FVector3f& Normal = Geometry.Normals[Index];
        const FVector3f Flat = AlongU[Index] - Normal * FVector3f::DotProduct(AlongU[Index], Normal);
        const FVector3f Tangent = UnitOr(Flat, Perpendicular(Normal));
        const float W =
            FVector3f::DotProduct(FVector3f::CrossProduct(Normal, Tangent), AlongUp[Index]) < 0.0f ? -1.0f : 1.0f;
        Geometry.Tangents.Add(FVector4f(Tangent.X, Tangent.Y, Tangent.Z, W));
    }
}

FStaticMeshGeometry Geometry(const SceneFile::FMesh& Mesh) {
    bool bSecondSet = false;
    bool bColors = false;
    for (const SceneFile::FPrimitive& Primitive : Mesh.Primitives) {
        bSecondSet = bSecondSet || !Primitive.TexCoords1.empty();
        bColors = bColors || !Primitive.Colors.empty();
    }
    FStaticMeshGeometry Result;
    int32 Slot = 0;
    for (const SceneFile::FPrimitive& Primitive : Mesh.Primitives) {
        FStaticMeshGeometry Piece = ConvertPrimitive(Primitive, bSecondSet, bColors);
        FStaticMeshGeometrySection Section;
        Section.MaterialIndex = Slot++;
        Section.FirstIndex = static_cast<uint32>(Result.Indices.Num());
        Section.NumTriangles = static_cast<uint32>(Piece.Indices.Num() / 3);
        Result.Sections.Add(Section);
        const uint32 Base = static_cast<uint32>(Result.Positions.Num());
        Result.Indices.Reserve(Result.Indices.Num() + Piece.Indices.Num());
        for (const uint32 Index : Piece.Indices) {
            Result.Indices.Add(Base + Index);
        }
        Result.Positions.Append(Piece.Positions);
        Result.Normals.Append(Piece.Normals);
        Result.Tangents.Append(Piece.Tangents);
        Result.TexCoords0.Append(Piece.TexCoords0);
        Result.TexCoords1.Append(Piece.TexCoords1);
        Result.Colors.Append(Piece.Colors);
    }
    return Result;
}

} // namespace SceneConversion
