// SPDX-License-Identifier: MIT
// Meshes, materials and textures as objects, and the content that the engine makes itself.

#include "engine_fixture.h"

#include "Components/SceneComponent.h"
#include "Components/StaticMeshComponent.h"
#include "Engine/CoordinateAxes.h"
#include "Engine/StaticMesh.h"
#include "Engine/Texture2D.h"
#include "Materials/Material.h"
#include "Materials/MaterialInstanceDynamic.h"

namespace {

UStaticMesh* LoadMesh(const TCHAR* Path) { return LoadObject<UStaticMesh>(nullptr, Path); }

// Checks that the geometry is consistent: unit normals and tangents at right angles, triangles whose front agrees with
// their normals.
void CheckGeometry(const UStaticMesh& Mesh) {
    const FStaticMeshGeometry& Geometry = Mesh.GetGeometry();
    REQUIRE(Geometry.Normals.Num() == Geometry.NumVertices());
    REQUIRE(Geometry.Tangents.Num() == Geometry.NumVertices());
    int32 BadVertices = 0;
    for (int32 Index = 0; Index < Geometry.NumVertices(); ++Index) {
        const FVector Normal(Geometry.Normals[Index]);
        const FVector4f& T = Geometry.Tangents[Index];
        const FVector Tangent(T.X, T.Y, T.Z);
        const bool bGood = FMath::Abs(Normal.Size() - 1.0) < 1e-4 && FMath::Abs(Tangent.Size() - 1.0) < 1e-4 &&
                           FMath::Abs(FVector::DotProduct(Normal, Tangent)) < 1e-3 &&
                           FMath::Abs(FMath::Abs(T.W) - 1.0f) < 1e-6f;
        BadVertices += bGood ? 0 : 1;
    }
    CHECK(BadVertices == 0);
    int32 BadTriangles = 0;
    for (int32 Corner = 0; Corner < Geometry.Indices.Num(); Corner += 3) {
        const auto Position = [&](int32 K) {
            return FVector(Geometry.Positions[static_cast<int32>(Geometry.Indices[Corner + K])]);
        };
        const auto Normal = [&](int32 K) {
            return FVector(Geometry.Normals[static_cast<int32>(Geometry.Indices[Corner + K])]);
        };
        const FVector Front = FVector::CrossProduct(Position(2) - Position(0), Position(1) - Position(0));
        BadTriangles += FVector::DotProduct(Front, Normal(0) + Normal(1) + Normal(2)) < -1e-6 ? 1 : 0;
    }
    CHECK(BadTriangles == 0);
}

} // namespace

TEST_CASE("basic shapes load by path with UE's sizes") {
    EngineFixture fixture;
    struct FExpected {
        const TCHAR* Path;
        FVector Extent;
    };
    const FExpected shapes[] = {
        {TEXT("/Engine/BasicShapes/Cube.Cube"), FVector(50.0, 50.0, 50.0)},
        {TEXT("/Engine/BasicShapes/Sphere.Sphere"), FVector(50.0, 50.0, 50.0)},
        {TEXT("/Engine/BasicShapes/Cylinder.Cylinder"), FVector(50.0, 50.0, 50.0)},
        {TEXT("/Engine/BasicShapes/Cone.Cone"), FVector(50.0, 50.0, 50.0)},
        {TEXT("/Engine/BasicShapes/Plane.Plane"), FVector(50.0, 50.0, 0.0)},
        {TEXT("/Engine/BasicShapes/Arrow.Arrow"), FVector(50.0, 5.0, 5.0)},
    };
    for (const FExpected& shape : shapes) {
        UStaticMesh* mesh = LoadMesh(shape.Path);
        CAPTURE(toString(FString(shape.Path)));
        REQUIRE(mesh != nullptr);
        CHECK(toString(mesh->GetPathName()) == toString(FString(shape.Path)));
        CHECK(mesh->GetBounds().BoxExtent.Equals(shape.Extent, 0.01));
        CHECK(mesh->GetBoundingBox().GetExtent().Equals(shape.Extent, 0.01));
        CHECK(mesh->GetNumLODs() == 1);
        CHECK(mesh->GetNumTriangles(0) >= 2);
        CHECK(mesh->GetNumTriangles(1) == 0);
        CHECK(mesh->GetNumVertices(0) == mesh->GetGeometry().NumVertices());
        CHECK(mesh->GetMaterial(0) != nullptr);
        CHECK(mesh->GetMaterial(1) == nullptr);
        CheckGeometry(*mesh);
        CHECK_MESSAGE(LoadMesh(shape.Path) == mesh, "a second load must find the same object");
    }
    CHECK(LoadMesh(TEXT("/Engine/BasicShapes/Teapot.Teapot")) == nullptr);
    CHECK(LoadObject<UMaterial>(nullptr, TEXT("/Engine/BasicShapes/Cube.Cube")) == nullptr);
    CHECK(LoadMesh(TEXT("/Engine/BasicShapes/Cube.Cube"))->GetNumTriangles(0) == 12);
}

TEST_CASE("a static mesh keeps its slots and refuses inconsistent geometry") {
    EngineFixture fixture;
    UStaticMesh* mesh = NewObject<UStaticMesh>(GetTransientPackage());
    CHECK(mesh->GetNumLODs() == 0);
    UMaterialInterface* material =
        LoadObject<UMaterialInterface>(nullptr, TEXT("/Engine/EngineMaterials/DefaultMaterial.DefaultMaterial"));
    REQUIRE(material != nullptr);
    const FName first = mesh->AddMaterial(material);
    const FName second = mesh->AddMaterial(nullptr);
    CHECK(first != second);
    CHECK(mesh->GetMaterialIndex(first) == 0);
    CHECK(mesh->GetMaterialIndex(second) == 1);
    CHECK(mesh->GetMaterialIndex(TEXT("Nothing")) == INDEX_NONE);
    mesh->SetMaterial(1, material);
    CHECK(mesh->GetMaterial(1) == material);
    mesh->SetMaterial(7, material);
    CHECK(mesh->GetStaticMaterials().Num() == 2);

    FString error;
    FStaticMeshGeometry geometry;
    geometry.Positions.Add(FVector3f(0.0f, 0.0f, 0.0f));
    CHECK_FALSE(mesh->SetGeometry(MoveTemp(geometry), error));
    CHECK(error.Contains(TEXT("1 positions")));

    FStaticMeshGeometry copy = LoadMesh(TEXT("/Engine/BasicShapes/Cube.Cube"))->GetGeometry();
    copy.Indices[4] = 999;
    CHECK_FALSE(mesh->SetGeometry(MoveTemp(copy), error));
    CHECK(error.Contains(TEXT("vertex 999")));

    copy = LoadMesh(TEXT("/Engine/BasicShapes/Cube.Cube"))->GetGeometry();
    copy.Sections[0].NumTriangles = 5;
    CHECK_FALSE(mesh->SetGeometry(MoveTemp(copy), error));
    CHECK(error.Contains(TEXT("sections")));
    CHECK(mesh->GetNumTriangles(0) == 0);
    CHECK(mesh->GetGeometryRevision() == 0);

    copy = LoadMesh(TEXT("/Engine/BasicShapes/Cube.Cube"))->GetGeometry();
    CHECK(mesh->SetGeometry(MoveTemp(copy), error));
    CHECK(mesh->GetGeometryRevision() == 1);
    CHECK(FMath::Abs(mesh->GetBounds().SphereRadius - 50.0 * FMath::Sqrt(3.0)) < 0.01);
}

TEST_CASE("material instances override parameters through a chain") {
    EngineFixture fixture;
    UMaterial* surface = LoadObject<UMaterial>(nullptr, TEXT("/Engine/EngineMaterials/Surface.Surface"));
    REQUIRE(surface != nullptr);
    UMaterialInstanceDynamic* lower = UMaterialInstanceDynamic::Create(surface, nullptr);
    UMaterialInstanceDynamic* upper = UMaterialInstanceDynamic::Create(lower, nullptr, TEXT("Upper"));
    CHECK(UMaterialInstanceDynamic::Create(nullptr, nullptr) == nullptr);
    CHECK(upper->GetFName() == FName(TEXT("Upper")));
    CHECK(upper->GetBaseMaterial() == surface);
    CHECK(upper->Parent.Get() == lower);

    CHECK(upper->K2_GetScalarParameterValue(TEXT("Roughness")) == doctest::Approx(0.5));
    const uint32 revision = upper->GetParametersRevision();
    lower->SetScalarParameterValue(TEXT("roughness"), 0.25f);
    CHECK_MESSAGE(upper->K2_GetScalarParameterValue(TEXT("Roughness")) == doctest::Approx(0.25),
        "names have no case, and parents count");
    CHECK(upper->GetParametersRevision() != revision);
    upper->SetScalarParameterValue(TEXT("Roughness"), 0.75f);
    CHECK(lower->K2_GetScalarParameterValue(TEXT("Roughness")) == doctest::Approx(0.25));
    CHECK(upper->K2_GetScalarParameterValue(TEXT("Roughness")) == doctest::Approx(0.75));
    CHECK(upper->K2_GetScalarParameterValue(TEXT("NoSuchParameter")) == 0.0f);

    float value = -1.0f;
    CHECK_FALSE(surface->GetScalarParameterValue(TEXT("Roughness"), value, true));
    CHECK(upper->GetScalarParameterValue(FMaterialParameterInfo(TEXT("Roughness")), value, true));
    CHECK(value == doctest::Approx(0.75));

    upper->SetVectorParameterValue(TEXT("EmissiveColor"), FLinearColor(1.0f, 2.0f, 3.0f));
    CHECK(upper->K2_GetVectorParameterValue(TEXT("EmissiveColor")).Equals(FLinearColor(1.0f, 2.0f, 3.0f)));
    UTexture2D* texture = UTexture2D::CreateTransient(4, 2);
    REQUIRE(texture != nullptr);
    upper->SetTextureParameterValue(TEXT("BaseColorTexture"), texture);
    CHECK(upper->K2_GetTextureParameterValue(TEXT("BaseColorTexture")) == texture);

    const FSurfaceParameters resolved = upper->GetSurfaceParameters();
    CHECK(resolved.Roughness == doctest::Approx(0.75));
    CHECK(resolved.EmissiveColor.B == doctest::Approx(3.0));
    CHECK(resolved.BaseColorTexture == texture);
    CHECK(resolved.NormalTexture == nullptr);
    CHECK(resolved.BlendMode == BLEND_Opaque);

    UMaterialInstanceDynamic* blend = UMaterialInstanceDynamic::Create(surface, nullptr);
    blend->K2_InterpolateMaterialInstanceParams(lower, upper, 0.5f);
    CHECK(blend->K2_GetScalarParameterValue(TEXT("Roughness")) == doctest::Approx(0.5));
    upper->ClearParameterValues();
    CHECK(upper->K2_GetScalarParameterValue(TEXT("Roughness")) == doctest::Approx(0.25));
}

TEST_CASE("textures keep their pixels and refuse what does not fit") {
    EngineFixture fixture;
    UTexture2D* texture = UTexture2D::CreateTransient(4, 2, PF_G8);
    REQUIRE(texture != nullptr);
    CHECK(texture->GetSizeX() == 4);
    CHECK(texture->Blueprint_GetSizeY() == 2);
    CHECK(texture->GetPixelFormat() == PF_G8);
    CHECK(texture->GetPixels().Num() == 8);
    CHECK(UTexture2D::CreateTransient(0, 2) == nullptr);
    CHECK(UTexture2D::CreateTransient(4, 100000) == nullptr);
    CHECK(UTexture2D::CreateTransient(4, 4, PF_FloatRGBA) == nullptr);

    FString error;
    TArray<uint8> bytes;
    bytes.SetNumZeroed(15);
    CHECK_FALSE(texture->SetPixels(2, 2, PF_B8G8R8A8, MoveTemp(bytes), error));
    CHECK(error.Contains(TEXT("15 bytes")));
    CHECK(texture->GetSizeX() == 4);
}

TEST_CASE("coordinate axes spawn by class with three coloured arrows") {
    EngineFixture fixture;
    fixture.BeginPlay();
    UClass* type = FindFirstObject<UClass>(TEXT("CoordinateAxes"));
    REQUIRE(type == ACoordinateAxes::StaticClass());
    const FVector location(-10.0, 280.0, 50.0);
    const FRotator rotation(0.0, 90.0, 0.0);
    ACoordinateAxes* axes = Cast<ACoordinateAxes>(fixture.World->SpawnActor(type, &location, &rotation));
    REQUIRE(axes != nullptr);
    CHECK(axes->GetActorLocation().Equals(location, 1e-6));
    CHECK(axes->GetRootComponent() == axes->AxesRoot.Get());
    CHECK(axes->XAxis->GetStaticMesh() == LoadMesh(TEXT("/Engine/BasicShapes/Arrow.Arrow")));
    axes->SetActorScale3D(FVector(4.0, 4.0, 4.0));
    // The tip of each arrow, 100 cm along the mesh's +X.
    const FVector tip(100.0, 0.0, 0.0);
    CHECK(
        axes->XAxis->GetComponentTransform().TransformPosition(tip).Equals(location + FVector(0.0, 400.0, 0.0), 1e-3));
    CHECK(
        axes->YAxis->GetComponentTransform().TransformPosition(tip).Equals(location + FVector(-400.0, 0.0, 0.0), 1e-3));
    CHECK(
        axes->ZAxis->GetComponentTransform().TransformPosition(tip).Equals(location + FVector(0.0, 0.0, 400.0), 1e-3));
    const auto colour = [](const UStaticMeshComponent* axis) {
        return axis->GetMaterial(0)->GetSurfaceParameters().BaseColor;
    };
    CHECK(colour(axes->XAxis).R > 4.0f * colour(axes->XAxis).G);
    CHECK(colour(axes->YAxis).G > 4.0f * colour(axes->YAxis).R);
    CHECK(colour(axes->ZAxis).B > 4.0f * colour(axes->ZAxis).R);
}
