// SPDX-License-Identifier: MIT
// What UE ships as files below /Engine, made here in code: basic shapes and plain materials.

#include "CoreMinimal.h"
#include "Engine/StaticMesh.h"
#include "Materials/Material.h"
#include "Materials/MaterialInstanceConstant.h"
#include "SceneConversion.h"
#include "UObject/ContentLoader.h"
#include "UObject/Package.h"
#include "UObject/UObjectGlobals.h"

namespace {

/** Builds the triangles of one basic shape, in centimetres. */
class FShapeBuilder {
public:
    /** Adds a vertex and returns its index. */
    uint32 Vertex(const FVector& Position, const FVector& Normal, double U, double V) {
        Geometry.Positions.Add(FVector3f(Position));
        Geometry.Normals.Add(FVector3f(Normal.GetSafeNormal()));
        Geometry.TexCoords0.Add(FVector2f(static_cast<float>(U), static_cast<float>(V)));
        return static_cast<uint32>(Geometry.Positions.Num() - 1);
    }

    /** Adds a triangle, turned so that its front is where its normals point. */
    void Triangle(uint32 A, uint32 B, uint32 C) {
        const auto Point = [this](uint32 Index) { return FVector(Geometry.Positions[static_cast<int32>(Index)]); };
        const FVector Front = FVector::CrossProduct(Point(C) - Point(A), Point(B) - Point(A));
        if (Front.IsNearlyZero(1e-9)) {
            return;
        }
        const FVector Normal(Geometry.Normals[static_cast<int32>(A)] + Geometry.Normals[static_cast<int32>(B)] +
                             Geometry.Normals[static_cast<int32>(C)]);
        if (FVector::DotProduct(Front, Normal) < 0.0) {
            Swap(B, C);
        }
        Geometry.Indices.Add(A);
        Geometry.Indices.Add(B);
        Geometry.Indices.Add(C);
    }

    /** A rectangle round Centre spanned by two half sides. */
    void Rectangle(const FVector& Centre, const FVector& HalfU, const FVector& HalfV, const FVector& Normal) {
        const uint32 A = Vertex(Centre - HalfU - HalfV, Normal, 0.0, 0.0);
        const uint32 B = Vertex(Centre + HalfU - HalfV, Normal, 1.0, 0.0);
        const uint32 C = Vertex(Centre + HalfU + HalfV, Normal, 1.0, 1.0);
        const uint32 D = Vertex(Centre - HalfU + HalfV, Normal, 0.0, 1.0);
        Triangle(A, B, C);
        Triangle(A, C, D);
    }

    /** A band round an axis through Base between two rings; the frame maps (around, around, along). */
    void Band(double LowRadius, double LowHeight, double HighRadius, double HighHeight, int32 Segments) {
        const double Slope = LowRadius - HighRadius;
        const double Rise = HighHeight - LowHeight;
        TArray<uint32> Low;
        TArray<uint32> High;
        for (int32 Step = 0; Step <= Segments; ++Step) {
            const double Turn = static_cast<double>(Step) / Segments;
            const FVector Out = Around(Turn);
            const FVector Normal = Out * Rise + FVector(0.0, 0.0, Slope);
            Low.Add(Vertex(Out * LowRadius + FVector(0.0, 0.0, LowHeight), Normal, Turn, 1.0));
            High.Add(Vertex(Out * HighRadius + FVector(0.0, 0.0, HighHeight), Normal, Turn, 0.0));
        }
        for (int32 Step = 0; Step < Segments; ++Step) {
            Triangle(Low[Step], Low[Step + 1], High[Step + 1]);
            Triangle(Low[Step], High[Step + 1], High[Step]);
        }
    }

    /** A disc at a height, facing up or down. */
    void Disc(double InnerRadius, double Radius, double Height, double Direction, int32 Segments) {
        const FVector Normal(0.0, 0.0, Direction);
        TArray<uint32> Inner;
        TArray<uint32> Rim;
        for (int32 Step = 0; Step <= Segments; ++Step) {
            const FVector Out = Around(static_cast<double>(Step) / Segments);
            Rim.Add(Vertex(Out * Radius + FVector(0.0, 0.0, Height), Normal, 0.5 + 0.5 * Out.X, 0.5 + 0.5 * Out.Y));
            const double Share = InnerRadius / Radius;
            Inner.Add(Vertex(Out * InnerRadius + FVector(0.0, 0.0, Height), Normal, 0.5 + 0.5 * Share * Out.X,
                0.5 + 0.5 * Share * Out.Y));
        }
        for (int32 Step = 0; Step < Segments; ++Step) {
            Triangle(Inner[Step], Rim[Step], Rim[Step + 1]);
            Triangle(Inner[Step], Rim[Step + 1], Inner[Step + 1]);
        }
    }

    void Sphere(double Radius, int32 Segments) {
        const int32 Rings = Segments / 2;
        TArray<uint32> Grid;
        for (int32 Ring = 0; Ring <= Rings; ++Ring) {
            const double Polar = UE_DOUBLE_PI * Ring / Rings;
            for (int32 Step = 0; Step <= Segments; ++Step) {
                const double Turn = static_cast<double>(Step) / Segments;
                const FVector Direction = Around(Turn) * FMath::Sin(Polar) + FVector(0.0, 0.0, FMath::Cos(Polar));
                Grid.Add(Vertex(Direction * Radius, Direction, Turn, static_cast<double>(Ring) / Rings));
            }
        }
        const int32 Row = Segments + 1;
        for (int32 Ring = 0; Ring < Rings; ++Ring) {
            for (int32 Step = 0; Step < Segments; ++Step) {
                const int32 Corner = Ring * Row + Step;
                Triangle(Grid[Corner], Grid[Corner + 1], Grid[Corner + Row + 1]);
                Triangle(Grid[Corner], Grid[Corner + Row + 1], Grid[Corner + Row]);
            }
        }
    }

    /** Turns what points along +Z to point along +X. */
    void TurnUpToForward() {
        for (TArray<FVector3f>* Vectors : {&Geometry.Positions, &Geometry.Normals}) {
            for (FVector3f& V : *Vectors) {
                V = FVector3f(V.Z, V.Y, -V.X);
            }
        }
    }

    FStaticMeshGeometry Finish() {
        FStaticMeshGeometrySection Section;
        Section.NumTriangles = static_cast<uint32>(Geometry.Indices.Num() / 3);
        Geometry.Sections.Add(Section);
        SceneConversion::ComputeTangents(Geometry);
        return MoveTemp(Geometry);
    }

private:
    static FVector Around(double Turn) {
        return FVector(FMath::Cos(Turn * 2.0 * UE_DOUBLE_PI), FMath::Sin(Turn * 2.0 * UE_DOUBLE_PI), 0.0);
    }

    FStaticMeshGeometry Geometry;
};

/** The shapes of UE's /Engine/BasicShapes: one metre across, centred (Plane: in Z = 0). Arrow is ours: from the origin
 * to +X, one metre long. */
bool BuildShape(const FString& Name, FStaticMeshGeometry& OutGeometry) {
    FShapeBuilder Builder;
    constexpr double Half = 50.0;
    constexpr int32 Segments = 48;
    if (Name == TEXT("Cube")) {
        const FVector X(Half, 0.0, 0.0);
        const FVector Y(0.0, Half, 0.0);
        const FVector Z(0.0, 0.0, Half);
        for (const double Side : {1.0, -1.0}) {
            Builder.Rectangle(X * Side, Y, Z * -1.0, X * Side);
            Builder.Rectangle(Y * Side, X, Z * -1.0, Y * Side);
            Builder.Rectangle(Z * Side, X, Y, Z * Side);
        }
    } else if (Name == TEXT("Plane")) {
        Builder.Rectangle(
            FVector::ZeroVector, FVector(Half, 0.0, 0.0), FVector(0.0, Half, 0.0), FVector(0.0, 0.0, 1.0));
    } else if (Name == TEXT("Sphere")) {
        Builder.Sphere(Half, Segments);
    } else if (Name == TEXT("Cylinder")) {
        Builder.Band(Half, -Half, Half, Half, Segments);
        Builder.Disc(0.0, Half, Half, 1.0, Segments);
        Builder.Disc(0.0, Half, -Half, -1.0, Segments);
    } else if (Name == TEXT("Cone")) {
        Builder.Band(Half, -Half, 0.0, Half, Segments);
        Builder.Disc(0.0, Half, -Half, -1.0, Segments);
    } else if (Name == TEXT("Arrow")) {
        Builder.Disc(0.0, 2.0, 0.0, -1.0, Segments / 2);
        Builder.Band(2.0, 0.0, 2.0, 80.0, Segments / 2);
        Builder.Disc(2.0, 5.0, 80.0, -1.0, Segments / 2);
        Builder.Band(5.0, 80.0, 0.0, 100.0, Segments / 2);
        Builder.TurnUpToForward();
    } else {
        return false;
    }
    OutGeometry = Builder.Finish();
    return true;
}

UMaterial* MakeMaterial(UPackage* Package, const FString& Name) {
    UMaterial* Material = NewObject<UMaterial>(Package, FName(*Name), RF_Public | RF_Standalone);
    Material->AddToRoot();
    return Material;
}

UObject* LoadMaterial(const FString& PackageName, const FString& AssetName) {
    FLinearColor Color;
    if (AssetName == TEXT("DefaultMaterial") || AssetName == TEXT("Surface")) {
        UMaterial* Material = MakeMaterial(CreatePackage(*PackageName), AssetName);
        if (AssetName == TEXT("DefaultMaterial")) {
            Material->SetVectorParameterDefault(TEXT("BaseColor"), FLinearColor(0.5f, 0.5f, 0.5f, 1.0f));
        }
        return Material;
    }
    if (AssetName == TEXT("AxisX")) {
        Color = FLinearColor(0.8f, 0.03f, 0.03f);
    } else if (AssetName == TEXT("AxisY")) {
        Color = FLinearColor(0.04f, 0.6f, 0.06f);
    } else if (AssetName == TEXT("AxisZ")) {
        Color = FLinearColor(0.04f, 0.12f, 0.9f);
    } else {
        return nullptr;
    }
    // Axes shine a little by themselves, so that they can be told apart in the dark too.
    UMaterial* Material = MakeMaterial(CreatePackage(*PackageName), AssetName);
    Material->SetVectorParameterDefault(TEXT("BaseColor"), Color);
    Material->SetVectorParameterDefault(TEXT("EmissiveColor"), Color * 0.35f);
    Material->SetScalarParameterDefault(TEXT("Roughness"), 0.35f);
    return Material;
}

UObject* LoadEngineContent(UClass* Class, const FString& PackageName, const FString& AssetName) {
    UObject* Result = nullptr;
    if (PackageName == TEXT("/Engine/BasicShapes/") + AssetName) {
        FStaticMeshGeometry Geometry;
        if (!BuildShape(AssetName, Geometry)) {
            return nullptr;
        }
        UStaticMesh* Mesh =
            NewObject<UStaticMesh>(CreatePackage(*PackageName), FName(*AssetName), RF_Public | RF_Standalone);
        Mesh->AddToRoot();
        UMaterialInterface* Material =
            LoadObject<UMaterialInterface>(nullptr, TEXT("/Engine/EngineMaterials/DefaultMaterial.DefaultMaterial"));
        Mesh->SetStaticMaterials({FStaticMaterial(Material, TEXT("DefaultMaterial"))});
        FString Error;
        verifyf(Mesh->SetGeometry(MoveTemp(Geometry), Error), TEXT("%s"), *Error);
        Result = Mesh;
    } else if (PackageName == TEXT("/Engine/EngineMaterials/") + AssetName) {
        Result = LoadMaterial(PackageName, AssetName);
    }
    return Result != nullptr && (Class == nullptr || Result->IsA(Class)) ? Result : nullptr;
}

/** Class defaults load engine content before any module starts, so this registers with the library itself. */
struct FRegisterEngineContent {
    FRegisterEngineContent() { FContentLoaderRegistry::Register(TEXT("EngineContent"), &LoadEngineContent); }
};

const FRegisterEngineContent RegisterEngineContent;

} // namespace
