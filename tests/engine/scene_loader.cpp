// SPDX-License-Identifier: MIT
// Small scenes written by the tests: axes, hierarchy, lights, the sidecar, and every kind of malformed file.

// Before the engine: its macro `check` breaks standard headers.
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include "engine_fixture.h"

#include "Camera/CameraActor.h"
#include "Camera/CameraComponent.h"
#include "Components/DirectionalLightComponent.h"
#include "Components/PointLightComponent.h"
#include "Components/SpotLightComponent.h"
#include "Components/StaticMeshComponent.h"
#include "Engine/DirectionalLight.h"
#include "Engine/PointLight.h"
#include "Engine/SceneLoader.h"
#include "Engine/SpotLight.h"
#include "Engine/StaticMesh.h"
#include "Engine/StaticMeshActor.h"
#include "Engine/TargetPoint.h"
#include "Materials/MaterialInterface.h"

namespace {

// A folder of its own that is removed at the end.
struct TemporaryFolder {
    std::filesystem::path Path;

    TemporaryFolder() {
        static int number = 0;
        Path = std::filesystem::temp_directory_path() /
               ("spear_scene_test_" + std::to_string(::getpid()) + "_" + std::to_string(number++));
        std::filesystem::create_directories(Path);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(Path, ignored);
    }
    FString Write(const std::string& name, const std::string& text) const {
        std::ofstream(Path / name, std::ios::binary) << text;
        return FString(UTF8_TO_TCHAR((Path / name).c_str()));
    }
};

// One triangle with corners (0,0,0), (1,0,0), (0,2,0) metres, counter-clockwise seen from +Z, normal (0,0,1); uv = (x,
// 1-y).
std::string TriangleBuffer() {
    const float values[] = {
        0, 0, 0, 1, 0, 0, 0, 2, 0, /* normals */ 0, 0, 1, 0, 0, 1, 0, 0, 1, /* uv */ 0, 1, 1, 1, 0, -1};
    const std::uint16_t indices[] = {0, 1, 2};
    std::string bytes(sizeof(values) + sizeof(indices), '\0');
    std::memcpy(bytes.data(), values, sizeof(values));
    std::memcpy(bytes.data() + sizeof(values), indices, sizeof(indices));
    return bytes;
}

std::string Gltf(const std::string& nodes, const std::string& roots, const std::string& extra = "") {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + roots + R"(]}],"nodes":[)" + nodes + R"(],
        "buffers":[{"uri":"small.bin","byteLength":102}],
        "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":36},
                       {"buffer":0,"byteOffset":72,"byteLength":24},{"buffer":0,"byteOffset":96,"byteLength":6}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,2,0]},
                     {"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":2,"componentType":5126,"count":3,"type":"VEC2"},
                     {"bufferView":3,"componentType":5123,"count":3,"type":"SCALAR"}],
        "materials":[{"name":"red","pbrMetallicRoughness":{"baseColorFactor":[1,0,0,0.5],"metallicFactor":0.25,"roughnessFactor":0.75},
                      "alphaMode":"BLEND","doubleSided":true,"emissiveFactor":[1,0.5,0],
                      "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":4}}}],
        "meshes":[{"name":"Triangle","primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2},"indices":3,"material":0}]}])" +
           extra + "}";
}

const char* const PlainNode = R"({"name":"Thing_1","mesh":0,"translation":[1,2,3]})";

AActor* Find(UWorld* world, const TCHAR* name) {
    for (TActorIterator<AActor> it(world); it; ++it) {
        if (it->GetFName() == FName(name)) {
            return *it;
        }
    }
    return nullptr;
}

int32 CountActors(UWorld* world) {
    int32 count = 0;
    for (TActorIterator<AActor> it(world); it; ++it) {
        ++count;
    }
    return count;
}

// Loads a scene that must fail, checks that the world is as before, and returns the message.
std::string Failure(EngineFixture& fixture, const FString& path) {
    const int32 before = CountActors(fixture.World);
    FString error;
    CHECK_FALSE(FSceneLoader::LoadScene(fixture.World, path, error));
    CHECK(CountActors(fixture.World) == before);
    return TCHAR_TO_UTF8(*error);
}

bool Has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("glTF's metres, Y up and right-handed become UE's centimetres, Z up and left-handed") {
    EngineFixture fixture;
    TemporaryFolder folder;
    folder.Write("small.bin", TriangleBuffer());
    // A quarter turn about glTF's Y, counter-clockwise from above, takes +X to -Z; and a scale that differs by axis.
    const FString path = folder.Write("small.gltf",
        Gltf(
            R"({"name":"Thing_1","mesh":0,"translation":[1,2,3],"rotation":[0,0.70710678118,0,0.70710678118],"scale":[1,2,3]})",
            "0"));
    FString error;
    REQUIRE_MESSAGE(FSceneLoader::LoadScene(fixture.World, path, error), toString(error));
    AStaticMeshActor* actor = Cast<AStaticMeshActor>(Find(fixture.World, TEXT("Thing_1")));
    REQUIRE(actor != nullptr);
    CHECK(actor->GetActorLocation().Equals(FVector(100.0, 300.0, 200.0), 1e-4));
    CHECK(actor->GetActorRotation().Equals(FRotator(0.0, -90.0, 0.0), 1e-4));
    CHECK(actor->GetActorScale3D().Equals(FVector(1.0, 3.0, 2.0), 1e-6));
    // The corner (1, 0, 0) goes to (1, 2, 3) + R (1, 0, 0) = (1, 2, 2) in glTF.
    CHECK(actor->GetActorTransform()
            .TransformPosition(FVector(100.0, 0.0, 0.0))
            .Equals(FVector(100.0, 200.0, 200.0), 1e-3));

    UStaticMesh* mesh = actor->GetStaticMeshComponent()->GetStaticMesh();
    REQUIRE(mesh != nullptr);
    CHECK(toString(mesh->GetPathName()) == "/Game/Scenes/small/Meshes/Triangle.Triangle");
    CHECK(mesh->GetNumTriangles(0) == 1);
    const FStaticMeshGeometry& geometry = mesh->GetGeometry();
    CHECK(FVector(geometry.Positions[2]).Equals(FVector(0.0, 0.0, 200.0), 1e-4));
    CHECK(FVector(geometry.Normals[0]).Equals(FVector(0.0, 1.0, 0.0), 1e-6));
    CHECK(FVector(geometry.Tangents[0].X, geometry.Tangents[0].Y, geometry.Tangents[0].Z)
            .Equals(FVector(1.0, 0.0, 0.0), 1e-6));
    // Up in the image is glTF's +Y here, UE's +Z: W * (Normal x Tangent).
    const FVector up = FVector::CrossProduct(FVector(0.0, 1.0, 0.0), FVector(1.0, 0.0, 0.0)) * geometry.Tangents[0].W;
    CHECK(up.Equals(FVector(0.0, 0.0, 1.0), 1e-6));
    const FVector a(geometry.Positions[0]), b(geometry.Positions[1]), c(geometry.Positions[2]);
    CHECK(FVector::CrossProduct(c - a, b - a).GetSafeNormal().Equals(FVector(0.0, 1.0, 0.0), 1e-6));

    UMaterialInterface* material = mesh->GetMaterial(0);
    REQUIRE(material != nullptr);
    CHECK(toString(material->GetPathName()) == "/Game/Scenes/small/Materials/red.red");
    CHECK(mesh->GetMaterialIndex(TEXT("red")) == 0);
    const FSurfaceParameters surface = material->GetSurfaceParameters();
    CHECK(surface.BaseColor.Equals(FLinearColor(1.0f, 0.0f, 0.0f, 0.5f)));
    CHECK(surface.EmissiveColor.Equals(FLinearColor(4.0f, 2.0f, 0.0f)));
    CHECK(surface.Metallic == doctest::Approx(0.25));
    CHECK(surface.Roughness == doctest::Approx(0.75));
    CHECK(surface.BlendMode == BLEND_Translucent);
    CHECK(surface.bTwoSided);
}

TEST_CASE("groups become folders, nested actors are attached, matrices are decomposed") {
    EngineFixture fixture;
    TemporaryFolder folder;
    folder.Write("small.bin", TriangleBuffer());
    const FString path = folder.Write("small.gltf", Gltf(
                                                        R"({"name":"Room","translation":[10,0,0],"children":[1]},
           {"name":"Table","mesh":0,"translation":[1,0,0],"children":[2]},
           {"name":"Plate","mesh":0,"matrix":[0,0,-2,0, 0,2,0,0, 2,0,0,0, 0,1,0,1]})",
                                                        "0"));
    FString error;
    REQUIRE_MESSAGE(FSceneLoader::LoadScene(fixture.World, path, error), toString(error));
    AActor* table = Find(fixture.World, TEXT("Table"));
    AActor* plate = Find(fixture.World, TEXT("Plate"));
    REQUIRE(table != nullptr);
    REQUIRE(plate != nullptr);
    CHECK(Find(fixture.World, TEXT("Room")) == nullptr);
    CHECK(table->GetActorLocation().Equals(FVector(1100.0, 0.0, 0.0), 1e-3));
    CHECK(plate->GetAttachParentActor() == table);
    CHECK(plate->GetActorLocation().Equals(FVector(1100.0, 0.0, 100.0), 1e-3));
    CHECK(plate->GetActorRotation().Equals(FRotator(0.0, -90.0, 0.0), 1e-3));
    CHECK(plate->GetActorScale3D().Equals(FVector(2.0, 2.0, 2.0), 1e-5));
    CHECK(toString(FSceneLoader::GetFolderPath(table)) == "Room");
    CHECK(FSceneLoader::GetFolderPath(nullptr).IsEmpty());
}

TEST_CASE("punctual lights and cameras look along UE's +X with UE's units") {
    EngineFixture fixture;
    TemporaryFolder folder;
    folder.Write("small.bin", TriangleBuffer());
    const std::string lights =
        R"(,"extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":{"lights":[
        {"type":"directional","intensity":10,"color":[1,0.5,0.25]},
        {"type":"spot","intensity":25,"range":4,"spot":{"innerConeAngle":0.2617993878,"outerConeAngle":0.5235987756}},
        {"type":"point","intensity":7}]}},
        "cameras":[{"type":"perspective","perspective":{"yfov":1.0,"aspectRatio":2.0,"znear":0.1}}])";
    const FString path = folder.Write("small.gltf",
        Gltf(
            R"({"name":"Sun","extensions":{"KHR_lights_punctual":{"light":0}},"rotation":[-0.70710678118,0,0,0.70710678118]},
           {"name":"Spot","extensions":{"KHR_lights_punctual":{"light":1}}},
           {"name":"Bulb","extensions":{"KHR_lights_punctual":{"light":2}}},
           {"name":"Eye","camera":0,"rotation":[0,-0.70710678118,0,0.70710678118]})",
            "0,1,2,3", lights));
    FString error;
    REQUIRE_MESSAGE(FSceneLoader::LoadScene(fixture.World, path, error), toString(error));
    ADirectionalLight* sun = Cast<ADirectionalLight>(Find(fixture.World, TEXT("Sun")));
    REQUIRE(sun != nullptr);
    // Turned by -90 degrees about X, glTF's -Z becomes -Y: down.
    CHECK(sun->GetActorForwardVector().Equals(FVector(0.0, 0.0, -1.0), 1e-4));
    ULightComponent* sunlight = sun->FindComponentByClass<ULightComponent>();
    CHECK(sunlight->Intensity == doctest::Approx(10.0));
    CHECK(sunlight->GetLightColor().Equals(FLinearColor(1.0f, 0.5f, 0.25f), 0.01f));
    ASpotLight* spot = Cast<ASpotLight>(Find(fixture.World, TEXT("Spot")));
    REQUIRE(spot != nullptr);
    CHECK(spot->GetActorForwardVector().Equals(FVector(0.0, -1.0, 0.0), 1e-6));
    USpotLightComponent* cone = spot->FindComponentByClass<USpotLightComponent>();
    CHECK(cone->IntensityUnits == ELightUnits::Candelas);
    CHECK(cone->Intensity == doctest::Approx(25.0));
    CHECK(cone->AttenuationRadius == doctest::Approx(400.0));
    CHECK(cone->InnerConeAngle == doctest::Approx(15.0));
    CHECK(cone->OuterConeAngle == doctest::Approx(30.0));
    CHECK(Cast<APointLight>(Find(fixture.World, TEXT("Bulb"))) != nullptr);
    ACameraActor* eye = Cast<ACameraActor>(Find(fixture.World, TEXT("Eye")));
    REQUIRE(eye != nullptr);
    // -Z turned by -90 degrees about Y is +X.
    CHECK(eye->GetActorForwardVector().Equals(FVector(1.0, 0.0, 0.0), 1e-4));
    CHECK(eye->GetActorUpVector().Equals(FVector(0.0, 0.0, 1.0), 1e-4));
    const double horizontal = FMath::RadiansToDegrees(2.0 * std::atan(std::tan(0.5) * 2.0));
    CHECK(eye->GetCameraComponent()->FieldOfView == doctest::Approx(horizontal));
}

TEST_CASE("the sidecar gives classes, tags, properties and actors of its own") {
    EngineFixture fixture;
    TemporaryFolder folder;
    folder.Write("small.bin", TriangleBuffer());
    folder.Write("small.gltf", Gltf(std::string(PlainNode) + R"(,{"name":"Mark","translation":[0,1,0]})", "0,1"));
    const FString path =
        folder.Write("small.scene.json", R"json({"format":"spear-scene","version":1,"name":"tiny","gltf":"small.gltf",
        "game_mode":"AGameModeBase","world_settings":{"KillZ":-123},
        "actors":[{"name":"Target_1","class":"ATargetPoint","location":[1,2,3],"rotation":[10,20,30],"tags":["goal"]}],
        "nodes":{"Thing_1":{"tags":["furniture","table"],"component_tags":["part"],"mobility":"Movable","folder":"Room/Furniture",
                            "properties":{"bHidden":true,"StaticMeshComponent.RelativeScale3D":"(X=2,Y=2,Z=2)","InitialLifeSpan":7.5}},
                 "Mark":{"class":"/Script/Engine.TargetPoint"}}})json");
    FSceneLoader::FSettings settings;
    FString error;
    REQUIRE_MESSAGE(
        FSceneLoader::ReadSceneSettings(FString(UTF8_TO_TCHAR(folder.Path.c_str())), settings, error), toString(error));
    CHECK(toString(settings.Name) == "tiny");
    CHECK(toString(settings.GameMode) == "AGameModeBase");
    REQUIRE_MESSAGE(FSceneLoader::LoadScene(fixture.World, path, error), toString(error));
    AActor* thing = Find(fixture.World, TEXT("Thing_1"));
    REQUIRE(thing != nullptr);
    CHECK(thing->ActorHasTag(TEXT("table")));
    CHECK(thing->ActorHasTag(TEXT("Furniture")));
    CHECK(thing->GetRootComponent()->ComponentHasTag(TEXT("part")));
    CHECK(thing->GetRootComponent()->Mobility == EComponentMobility::Movable);
    CHECK(thing->IsHidden());
    CHECK(thing->InitialLifeSpan == doctest::Approx(7.5));
    CHECK(toString(FSceneLoader::GetFolderPath(thing)) == "Room/Furniture");
    AActor* target = Find(fixture.World, TEXT("Target_1"));
    REQUIRE(Cast<ATargetPoint>(target) != nullptr);
    CHECK(target->GetActorLocation().Equals(FVector(1.0, 2.0, 3.0), 1e-6));
    CHECK(target->GetActorRotation().Equals(FRotator(10.0, 20.0, 30.0), 1e-4));
    CHECK(Cast<ATargetPoint>(Find(fixture.World, TEXT("Mark"))) != nullptr);
    CHECK(fixture.World->GetWorldSettings()->KillZ == doctest::Approx(-123.0));
    CHECK(Has(Failure(fixture, path), "has an object of this name already"));
}

TEST_CASE("the assets of a scene live as long as something uses them") {
    EngineFixture fixture;
    TemporaryFolder folder;
    folder.Write("small.bin", TriangleBuffer());
    const FString path = folder.Write("small.gltf", Gltf(PlainNode, "0"));
    FString error;
    REQUIRE_MESSAGE(FSceneLoader::LoadScene(fixture.World, path, error), toString(error));
    AStaticMeshActor* thing = Cast<AStaticMeshActor>(Find(fixture.World, TEXT("Thing_1")));
    REQUIRE(thing != nullptr);
    const TWeakObjectPtr<UStaticMesh> mesh = thing->GetStaticMeshComponent()->GetStaticMesh();
    const TWeakObjectPtr<UMaterialInterface> material = mesh->GetMaterial(0);
    CollectGarbage(GARBAGE_COLLECTION_KEEPFLAGS, true);
    REQUIRE(mesh.IsValid());
    CHECK(material.IsValid());
    const TCHAR* const name = TEXT("/Game/Scenes/small/Meshes/Triangle.Triangle");
    CHECK(LoadObject<UStaticMesh>(nullptr, name) == mesh.Get());
    fixture.World->DestroyActor(thing);
    CollectGarbage(GARBAGE_COLLECTION_KEEPFLAGS, true);
    CHECK_FALSE(mesh.IsValid());
    CHECK_FALSE(material.IsValid());
    CHECK(LoadObject<UStaticMesh>(nullptr, name) == nullptr);
    // The name is free again.
    CHECK(FSceneLoader::LoadScene(fixture.World, path, error));
}

TEST_CASE("malformed scenes are refused with the file, the place and the reason, and leave the world alone") {
    EngineFixture fixture;
    TemporaryFolder folder;
    folder.Write("small.bin", TriangleBuffer());
    const auto gltf = [&](const std::string& text) { return Failure(fixture, folder.Write("bad.gltf", text)); };
    const auto replaced = [](std::string text, const std::string& from, const std::string& to) {
        const std::size_t place = text.find(from);
        REQUIRE(place != std::string::npos);
        return text.replace(place, from.size(), to);
    };
    const std::string good = Gltf(PlainNode, "0");

    FString error;
    CHECK_FALSE(FSceneLoader::LoadScene(nullptr, TEXT("apartment"), error));
    CHECK(Has(Failure(fixture, TEXT("")), "empty"));
    const std::string unknown = Failure(fixture, TEXT("no_such_scene"));
    CHECK(Has(unknown, "no_such_scene"));
    CHECK(Has(Failure(fixture, folder.Write("notes.txt", "hello")), "expected a .gltf"));
    CHECK(Has(gltf(""), "bad.gltf"));
    CHECK(Has(gltf("{ not json"), "bad.gltf"));
    CHECK(Has(gltf("[]"), "bad.gltf"));
    CHECK(Has(gltf(R"({"asset":{"version":"1.0"}})"), "bad.gltf"));
    CHECK(Has(Failure(fixture, folder.Write("bad.glb", "glTFxxxx")), "bad.glb"));
    CHECK(Has(gltf(replaced(good, "small.bin", "missing.bin")), "missing.bin"));
    CHECK(Has(gltf(replaced(good, "\"byteLength\":102", "\"byteLength\":1020")), "bad.gltf"));
    CHECK(Has(gltf(replaced(good, "\"count\":3,\"type\":\"VEC3\",\"min\"", "\"count\":4,\"type\":\"VEC3\",\"min\"")),
        "beyond the end"));
    CHECK(Has(
        gltf(replaced(good, "\"count\":3,\"type\":\"VEC3\",\"min\"", "\"count\":4000000000,\"type\":\"VEC3\",\"min\"")),
        "bad.gltf"));
    CHECK(
        Has(gltf(replaced(good, "\"byteOffset\":72", "\"byteOffset\":90")), "mesh 'Triangle' primitive 0 TEXCOORD_0"));
    CHECK(Has(gltf(replaced(good, "\"POSITION\":0", "\"POSITION\":77")), "accessor 77"));
    CHECK(Has(gltf(replaced(good, "\"indices\":3", "\"indices\":2")), "indices"));
    CHECK(Has(gltf(replaced(good, "\"mesh\":0", "\"mesh\":5")), "node 'Thing_1'"));
    CHECK(Has(gltf(replaced(good, "\"material\":0", "\"material\":9")), "material 9"));
    CHECK(Has(gltf(replaced(good, "\"translation\":[1,2,3]", "\"rotation\":[0,0,0,0]")), "length 0"));
    CHECK(Has(gltf(replaced(good, "\"nodes\":[0]", "\"nodes\":[3]")), "node 3"));
    CHECK(Has(gltf(Gltf(R"({"name":"A","children":[1]},{"name":"B","children":[0]})", "0")), "own ancestor"));
    CHECK(Has(gltf(Gltf(R"({"name":"Same","mesh":0},{"name":"same","mesh":0})", "0,1")), "unique names"));
    CHECK(Has(gltf(Gltf(PlainNode, "0", R"(,"extensionsRequired":["EXT_secret"])")), "EXT_secret"));
    folder.Write("broken.png", "this is no image");
    CHECK(
        Has(gltf(Gltf(PlainNode, "0", R"(,"images":[{"uri":"broken.png"}],"textures":[{"source":0}])")), "broken.png"));

    folder.Write("small.gltf", good);
    const auto sidecar = [&](const std::string& rest) {
        return Failure(fixture, folder.Write("small.scene.json",
                                    R"({"format":"spear-scene","version":1,"gltf":"small.gltf")" + rest + "}"));
    };
    CHECK(Has(Failure(fixture, folder.Write("small.scene.json", "{")), "small.scene.json"));
    CHECK(Has(Failure(fixture, folder.Write("small.scene.json", R"({"format":"other"})")), "spear-scene"));
    CHECK(
        Has(Failure(fixture, folder.Write("small.scene.json", R"({"format":"spear-scene","version":2})")), "version"));
    CHECK(Has(Failure(fixture, folder.Write("small.scene.json", R"({"format":"spear-scene","version":1})")), "gltf"));
    CHECK(Has(sidecar(R"(,"colour":1)"), "unknown key 'colour'"));
    CHECK(Has(sidecar(R"(,"nodes":{"Nobody":{}})"), "'Nobody'"));
    CHECK(Has(sidecar(R"(,"nodes":{"Thing_1":{"tags":"x"}})"), "node 'Thing_1': 'tags'"));
    CHECK(Has(sidecar(R"(,"nodes":{"Thing_1":{"mobility":"Fast"}})"), "Fast"));
    CHECK(Has(sidecar(R"(,"nodes":{"Thing_1":{"class":"ANothing"}})"), "no class 'ANothing'"));
    CHECK(Has(sidecar(R"(,"nodes":{"Thing_1":{"class":"UStaticMesh"}})"), "UStaticMesh"));
    CHECK(Has(sidecar(R"(,"nodes":{"Thing_1":{"class":"ATargetPoint"}})"), "no static mesh component"));
    CHECK(Has(sidecar(R"(,"nodes":{"Thing_1":{"properties":{"NoSuch":1}}})"), "'NoSuch'"));
    CHECK(Has(sidecar(R"(,"nodes":{"Thing_1":{"properties":{"bHidden":"perhaps"}}})"), "bHidden"));
    CHECK(Has(sidecar(R"(,"nodes":{"Thing_1":{"properties":{"bHidden":[1]}}})"), "bHidden"));
    CHECK(Has(sidecar(R"(,"nodes":{"Thing_1":{"properties":{"bHidden.x":"1"}}})"), "no members"));
    CHECK(Has(sidecar(R"(,"actors":[{"name":"Thing_1","class":"ATargetPoint"}])"), "already"));
    CHECK(Has(sidecar(R"(,"actors":[{"class":"ATargetPoint"}])"), "'name'"));
    CHECK(Has(sidecar(R"(,"actors":[{"name":"A","class":"ATargetPoint","location":[1,2]}])"), "location"));
    CHECK(Has(sidecar(R"(,"world_settings":{"NoSuch":1})"), "world_settings"));
}
