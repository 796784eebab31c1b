// SPDX-License-Identifier: MIT
// The apartment that the build makes: what is in it, and where known objects stand.

#include "engine_fixture.h"

#include "Components/LightComponent.h"
#include "Components/StaticMeshComponent.h"
#include "Engine/Light.h"
#include "Engine/SceneLoader.h"
#include "Engine/StaticMesh.h"
#include "Engine/StaticMeshActor.h"
#include "Engine/Texture2D.h"
#include "GameFramework/PlayerStart.h"
#include "Materials/MaterialInterface.h"

TEST_CASE("the apartment has its rooms, objects, triangles and lights") {
    EngineFixture fixture;
    FString error;
    REQUIRE_MESSAGE(FSceneLoader::LoadScene(fixture.World, TEXT("apartment"), error), toString(error));
    TSet<FName> rooms;
    int32 objects = 0, lights = 0, directional = 0, untagged = 0, triangles = 0, without_material = 0, starts = 0;
    TSet<const UTexture2D*> textures;
    for (TActorIterator<AActor> it(fixture.World); it; ++it) {
        AActor* actor = *it;
        if (const AStaticMeshActor* object = Cast<AStaticMeshActor>(actor)) {
            ++objects;
            untagged += actor->Tags.IsEmpty() ? 1 : 0;
            if (actor->ActorHasTag(TEXT("room"))) {
                for (const TCHAR* room : {TEXT("living_room"), TEXT("kitchen"), TEXT("hall"), TEXT("bedroom"),
                         TEXT("bathroom"), TEXT("study")}) {
                    if (actor->ActorHasTag(room)) {
                        rooms.Add(room);
                    }
                }
            }
            const UStaticMesh* mesh = object->GetStaticMeshComponent()->GetStaticMesh();
            REQUIRE_MESSAGE(mesh != nullptr, toString(actor->GetName()));
            triangles += mesh->GetNumTriangles(0);
            for (const FStaticMaterial& slot : mesh->GetStaticMaterials()) {
                without_material += slot.MaterialInterface ? 0 : 1;
                if (slot.MaterialInterface) {
                    const FSurfaceParameters surface = slot.MaterialInterface->GetSurfaceParameters();
                    for (const UTexture2D* texture :
                        {surface.BaseColorTexture, surface.NormalTexture, surface.OcclusionRoughnessMetallicTexture}) {
                        if (texture) {
                            textures.Add(texture);
                            CHECK(texture->GetPixels().Num() == 4 * texture->GetSizeX() * texture->GetSizeY());
                        }
                    }
                    if (surface.BaseColorTexture) {
                        CHECK(bool(surface.BaseColorTexture->SRGB));
                    }
                    if (surface.NormalTexture) {
                        CHECK_FALSE(bool(surface.NormalTexture->SRGB));
                    }
                }
            }
        } else if (Cast<ALight>(actor)) {
            ++lights;
            directional += actor->ActorHasTag(TEXT("directional_light")) ? 1 : 0;
        } else if (Cast<APlayerStart>(actor)) {
            ++starts;
        }
    }
    CHECK(rooms.Num() == 6);
    CHECK(objects >= 300);
    CHECK(untagged == 0);
    CHECK(triangles >= 500000);
    CHECK(lights >= 16);
    CHECK(directional == 1);
    CHECK(without_material == 0);
    CHECK(textures.Num() >= 40);
    CHECK(starts == 1);
}

TEST_CASE("known objects of the apartment stand where the plan says, in UE's units") {
    EngineFixture fixture;
    FString error;
    REQUIRE_MESSAGE(FSceneLoader::LoadScene(fixture.World, TEXT("apartment"), error), toString(error));
    const auto find = [&](const TCHAR* name) -> AActor* {
        for (TActorIterator<AActor> it(fixture.World); it; ++it) {
            if (it->GetFName() == FName(name)) {
                return *it;
            }
        }
        return nullptr;
    };
    // The coffee table is 80 x 120 x 42 cm and stands at plan (-0.1, 2.8) metres.
    AActor* table = find(TEXT("Table_1"));
    REQUIRE(table != nullptr);
    CHECK(table->ActorHasTag(TEXT("coffee_table")));
    CHECK(table->ActorHasTag(TEXT("living_room")));
    CHECK(table->GetActorLocation().Equals(FVector(-10.0, 280.0, 0.0), 1e-3));
    FVector origin, extent;
    table->GetActorBounds(false, origin, extent);
    CHECK(origin.Equals(FVector(-10.0, 280.0, 21.0), 0.5));
    CHECK(extent.Equals(FVector(40.0, 60.0, 21.0), 0.5));
    CHECK(table->GetRootComponent()->Mobility == EComponentMobility::Movable);
    CHECK(toString(FSceneLoader::GetFolderPath(table)) == "LivingRoom/Furniture");
    // The sofa looks to glTF's +X, a yaw of +90 degrees there: UE's -90.
    AActor* sofa = find(TEXT("Sofa_1"));
    REQUIRE(sofa != nullptr);
    CHECK(sofa->GetActorLocation().Equals(FVector(-162.0, 280.0, 0.0), 1e-3));
    CHECK(sofa->GetActorRotation().Equals(FRotator(0.0, -90.0, 0.0), 1e-3));
    // Rooms have their extent: the floor of the living room reaches from wall to wall.
    AActor* floor = find(TEXT("Floor_1"));
    REQUIRE(floor != nullptr);
    floor->GetActorBounds(false, origin, extent);
    CHECK(origin.X == doctest::Approx(-20.0).epsilon(0.01));
    CHECK(extent.X == doctest::Approx(326.0).epsilon(0.01));
    CHECK(origin.Z + extent.Z == doctest::Approx(0.0));
    // The sun shines down.
    AActor* sun = find(TEXT("DirectionalLight_1"));
    REQUIRE(sun != nullptr);
    CHECK(sun->GetActorForwardVector().Equals(FVector(-0.50, -0.60, -0.62).GetSafeNormal(), 1e-3));
}
