// SPDX-License-Identifier: MIT
// USceneComponent: attachment and world transforms against values worked out by hand.
#include "engine_fixture.h"

#include "Components/BoxComponent.h"
#include "Components/CapsuleComponent.h"
#include "Components/SceneComponent.h"
#include "Components/SphereComponent.h"
#include "Engine/StaticMeshActor.h"
#include "Components/StaticMeshComponent.h"
#include "GameFramework/Actor.h"
#include "UObject/UnrealType.h"

#include <cmath>

namespace {

bool near(const FVector& a, const FVector& b, double tolerance = 1e-4) { return a.Equals(b, tolerance); }
bool near(const FRotator& a, const FRotator& b, double tolerance = 1e-3) { return a.Equals(b, tolerance); }

template <typename ComponentType = USceneComponent>
ComponentType* add_component(AActor* actor, const TCHAR* name, USceneComponent* parent = nullptr) {
    ComponentType* component = NewObject<ComponentType>(actor, FName(name));
    if (parent) {
        component->SetupAttachment(parent);
    } else {
        actor->SetRootComponent(component);
    }
    component->RegisterComponent();
    return component;
}

// A world with one actor that has a root at (100, 0, 0), turned by 90 degrees about Z, twice the size.
struct Scene : EngineFixture {
    AActor* actor = World->SpawnActor<AActor>();
    USceneComponent* root = add_component(actor, TEXT("Root"));
    Scene() {
        root->SetRelativeLocationAndRotation(FVector(100, 0, 0), FRotator(0, 90, 0));
        root->SetRelativeScale3D(FVector(2, 2, 2));
    }
};

} // namespace

TEST_CASE_FIXTURE(Scene, "scene component: a child's world transform") {
    USceneComponent* child = add_component(actor, TEXT("Child"), root);
    child->SetRelativeLocation(FVector(10, 0, 5));
    CHECK(near(child->GetComponentLocation(), FVector(100, 20, 10)));
    CHECK(near(child->GetComponentRotation(), FRotator(0, 90, 0)));
    CHECK(near(child->GetComponentScale(), FVector(2, 2, 2)));
    CHECK(near(child->GetForwardVector(), FVector(0, 1, 0)));

    root->SetWorldRotation(FRotator(0, 180, 0));
    CHECK(near(child->GetComponentLocation(), FVector(80, 0, 10)));

    child->SetWorldLocation(FVector(0, 0, 0));
    CHECK(near(child->GetComponentLocation(), FVector(0, 0, 0)));
    CHECK(near(child->GetRelativeLocation(), FVector(50, 0, 0)));
    child->SetWorldScale3D(FVector(1, 1, 1));
    CHECK(near(child->GetRelativeScale3D(), FVector(0.5, 0.5, 0.5)));
    CHECK(near(child->GetComponentScale(), FVector(1, 1, 1)));

    const FTransform wanted(FRotator(10, 20, 30), FVector(1, 2, 3), FVector(4, 4, 4));
    child->SetWorldTransform(wanted);
    CHECK(child->GetComponentTransform().Equals(wanted, 1e-4));
}

TEST_CASE_FIXTURE(Scene, "scene component: writing RelativeLocation raw moves nothing until a setter runs") {
    USceneComponent* child = add_component(actor, TEXT("Child"), root);
    FProperty* property = USceneComponent::StaticClass()->FindPropertyByName(FName(TEXT("RelativeLocation")));
    REQUIRE(property);
    CHECK_FALSE(property->HasSetter());
    *property->ContainerPtrToValuePtr<FVector>(root) = FVector(500, 0, 0);
    CHECK(near(root->GetRelativeLocation(), FVector(500, 0, 0)));
    CHECK(near(root->GetComponentLocation(), FVector(100, 0, 0)));
    CHECK(near(child->GetComponentLocation(), FVector(100, 0, 0)));

    SUBCASE("the setter with the same value") { root->SetRelativeLocation(FVector(500, 0, 0)); }
    SUBCASE("a setter of another part") { root->SetRelativeRotation(FRotator(0, 0, 0)); }
    SUBCASE("the update") { root->UpdateComponentToWorld(); }
    CHECK(near(root->GetComponentLocation(), FVector(500, 0, 0)));
    CHECK(near(child->GetComponentLocation(), FVector(500, 0, 0)));
}

TEST_CASE_FIXTURE(Scene, "scene component: angles that were set are read back") {
    root->SetRelativeRotation(FRotator(0, 370, 0));
    CHECK(near(root->GetRelativeRotation(), FRotator(0, 10, 0)));
    CHECK(root->GetRelativeRotation().Yaw == doctest::Approx(10.0));
    root->SetWorldRotation(FRotator(80, 20, 0));
    CHECK(root->GetRelativeRotation().Pitch == doctest::Approx(80.0));
    root->AddLocalRotation(FRotator(20, 0, 0)); // past the pole the same rotation has other angles
    CHECK(near(root->GetForwardVector(), FRotator(100, 20, 0).Vector()));
}

TEST_CASE_FIXTURE(Scene, "scene component: adding offsets in each space") {
    root->AddRelativeLocation(FVector(1, 0, 0));
    CHECK(near(root->GetComponentLocation(), FVector(101, 0, 0)));
    root->AddLocalOffset(FVector(1, 0, 0)); // forward is Y
    CHECK(near(root->GetComponentLocation(), FVector(101, 1, 0)));
    root->AddWorldOffset(FVector(0, 0, 7));
    CHECK(near(root->GetComponentLocation(), FVector(101, 1, 7)));
    root->AddWorldRotation(FRotator(0, 90, 0));
    CHECK(near(root->GetComponentRotation(), FRotator(0, 180, 0)));
    root->AddWorldTransform(FTransform(FRotator(0, 0, 0), FVector(-1, -1, -7)));
    CHECK(near(root->GetComponentScale(), FVector(1, 1, 1))); // Epic: "ignores scale and sets it to (1,1,1)"
    CHECK(near(root->GetComponentLocation(), FVector(100, 0, 0)));
    FHitResult hit;
    root->K2_SetWorldLocation(FVector(1, 2, 3), true, hit, false);
    CHECK_FALSE(bool(hit.bBlockingHit));
    CHECK(hit.Time == 1.0f);
    CHECK(near(root->K2_GetComponentLocation(), FVector(1, 2, 3)));
}

TEST_CASE_FIXTURE(Scene, "scene component: attachment rules") {
    USceneComponent* other = add_component(actor, TEXT("Other"), root);
    other->DetachFromComponent(FDetachmentTransformRules::KeepRelativeTransform);
    other->SetWorldLocationAndRotation(FVector(0, 50, 0), FRotator(0, 0, 0));
    other->SetWorldScale3D(FVector(3, 3, 3));

    SUBCASE("keep relative") {
        CHECK(other->AttachToComponent(root, FAttachmentTransformRules::KeepRelativeTransform));
        CHECK(near(other->GetComponentLocation(),
            FVector(0, 0, 0))); // (0,50,0) turned and doubled: (-100,0,0), from (100,0,0)
        CHECK(near(other->GetComponentScale(), FVector(6, 6, 6)));
    }
    SUBCASE("keep world") {
        CHECK(other->AttachToComponent(root, FAttachmentTransformRules::KeepWorldTransform));
        CHECK(near(other->GetComponentLocation(), FVector(0, 50, 0)));
        CHECK(near(other->GetComponentScale(), FVector(3, 3, 3)));
        CHECK(near(other->GetRelativeLocation(), FVector(25, 50, 0)));
        CHECK(near(other->GetRelativeRotation(), FRotator(0, -90, 0)));
    }
    SUBCASE("snap, with and without scale") {
        CHECK(other->AttachToComponent(root, FAttachmentTransformRules::SnapToTargetNotIncludingScale));
        CHECK(near(other->GetComponentLocation(), FVector(100, 0, 0)));
        CHECK(near(other->GetComponentRotation(), FRotator(0, 90, 0)));
        CHECK(near(other->GetComponentScale(), FVector(3, 3, 3)));
        other->DetachFromComponent(FDetachmentTransformRules::KeepWorldTransform);
        CHECK(near(other->GetComponentLocation(), FVector(100, 0, 0)));
        CHECK(other->AttachToComponent(root, FAttachmentTransformRules::SnapToTargetIncludingScale));
        CHECK(near(other->GetComponentScale(), FVector(2, 2, 2)));
    }
    SUBCASE("no loops") {
        CHECK(other->AttachToComponent(root, FAttachmentTransformRules::KeepWorldTransform));
        CHECK_FALSE(root->AttachToComponent(other, FAttachmentTransformRules::KeepWorldTransform));
        CHECK_FALSE(root->AttachToComponent(root, FAttachmentTransformRules::KeepWorldTransform));
        CHECK_FALSE(root->AttachToComponent(nullptr, FAttachmentTransformRules::KeepWorldTransform));
        CHECK(root->GetAttachParent() == nullptr);
    }
    SUBCASE("static things are not attached to movable ones") {
        BeginPlay();
        other->SetMobility(EComponentMobility::Static);
        CHECK_FALSE(other->AttachToComponent(root, FAttachmentTransformRules::KeepWorldTransform));
    }
}

TEST_CASE_FIXTURE(Scene, "scene component: absolute parts") {
    USceneComponent* child = add_component(actor, TEXT("Child"), root);
    child->SetRelativeLocation(FVector(10, 0, 0));
    child->SetAbsolute(true, false, true);
    CHECK(near(child->GetComponentLocation(), FVector(10, 0, 0)));
    CHECK(near(child->GetComponentRotation(), FRotator(0, 90, 0)));
    CHECK(near(child->GetComponentScale(), FVector(1, 1, 1)));
    root->SetWorldLocation(FVector(0, 0, 999));
    CHECK(near(child->GetComponentLocation(), FVector(10, 0, 0)));
    child->SetWorldLocation(FVector(1, 2, 3));
    CHECK(near(child->GetRelativeLocation(), FVector(1, 2, 3)));
}

TEST_CASE_FIXTURE(Scene, "scene component: the hierarchy") {
    USceneComponent* a = add_component(actor, TEXT("A"), root);
    USceneComponent* b = add_component(actor, TEXT("B"), root);
    USceneComponent* c = add_component(actor, TEXT("C"), a);
    TArray<USceneComponent*> components;
    root->GetChildrenComponents(false, components);
    CHECK(components.Num() == 2);
    root->GetChildrenComponents(true, components);
    REQUIRE(components.Num() == 3);
    CHECK(components[0] == a);
    CHECK(components[1] == b);
    CHECK(components[2] == c);
    c->GetParentComponents(components);
    REQUIRE(components.Num() == 2);
    CHECK(components[1] == root);
    CHECK(root->GetNumChildrenComponents() == 2);
    CHECK(root->GetChildComponent(7) == nullptr);
    CHECK(c->GetAttachmentRoot() == root);
    CHECK(c->IsAttachedTo(root));
    CHECK_FALSE(root->IsAttachedTo(c));

    c->SetWorldLocation(FVector(7, 7, 7));
    a->DestroyComponent(true); // its children move up
    CHECK(c->GetAttachParent() == root);
    CHECK(near(c->GetComponentLocation(), FVector(7, 7, 7)));
    b->DestroyComponent();
    CHECK(root->GetNumChildrenComponents() == 1);
}

TEST_CASE_FIXTURE(Scene, "scene component: visibility") {
    USceneComponent* child = add_component(actor, TEXT("Child"), root);
    CHECK(child->IsVisible());
    root->SetVisibility(false);
    CHECK_FALSE(root->IsVisible());
    CHECK(child->IsVisible());
    root->SetVisibility(false, true);
    CHECK_FALSE(child->IsVisible());
    root->ToggleVisibility(true);
    CHECK(child->IsVisible());
    child->SetHiddenInGame(true);
    CHECK_FALSE(child->ShouldRender());
    CHECK(child->IsVisible());
}

TEST_CASE_FIXTURE(Scene, "scene component: listeners hear of moves, their own and their parent's") {
    USceneComponent* child = add_component(actor, TEXT("Child"), root);
    int moves = 0;
    EUpdateTransformFlags last = EUpdateTransformFlags::None;
    child->TransformUpdated.AddLambda([&](USceneComponent*, EUpdateTransformFlags flags, ETeleportType) {
        ++moves;
        last = flags;
    });
    child->SetRelativeLocation(FVector(1, 0, 0));
    CHECK(moves == 1);
    CHECK(last == EUpdateTransformFlags::None);
    child->SetRelativeLocation(FVector(1, 0, 0));
    CHECK(moves == 1);
    root->SetWorldLocation(FVector(0, 0, 0));
    CHECK(moves == 2);
    CHECK(EnumHasAnyFlags(last, EUpdateTransformFlags::PropagateFromParent));
    child->TransformUpdated.Clear();
}

TEST_CASE_FIXTURE(Scene, "scene component: static mobility") {
    BeginPlay();
    AStaticMeshActor* fixed = World->SpawnActor<AStaticMeshActor>(FVector(10, 20, 30), FRotator(0, 0, 0));
    REQUIRE(fixed);
    USceneComponent* component = fixed->GetRootComponent();
    CHECK(component->Mobility == EComponentMobility::Static);
    CHECK(near(component->GetComponentLocation(), FVector(10, 20, 30)));
    CHECK_FALSE(component->MoveComponent(FVector(1, 0, 0), FRotator(0, 0, 0), false));
    component->SetWorldLocation(FVector(0, 0, 0));
    CHECK(near(component->GetComponentLocation(), FVector(10, 20, 30)));
    fixed->SetMobility(EComponentMobility::Movable);
    component->SetWorldLocation(FVector(0, 0, 0));
    CHECK(near(component->GetComponentLocation(), FVector(0, 0, 0)));
}

TEST_CASE_FIXTURE(Scene, "shape components: sizes and bounds") {
    UBoxComponent* box = add_component<UBoxComponent>(actor, TEXT("Box"), root);
    box->SetBoxExtent(FVector(10, 20, 30));
    CHECK(near(box->GetScaledBoxExtent(), FVector(20, 40, 60)));
    CHECK(near(box->Bounds.Origin, FVector(100, 0, 0)));
    CHECK(near(box->Bounds.BoxExtent, FVector(40, 20, 60))); // turned by 90 degrees
    box->SetBoundsScale(2.0f);
    CHECK(near(box->Bounds.BoxExtent, FVector(80, 40, 120)));
    box->SetRelativeLocation(FVector(0, 0, 1));
    CHECK(near(box->Bounds.Origin, FVector(100, 0, 2)));

    USphereComponent* sphere = add_component<USphereComponent>(actor, TEXT("Sphere"), root);
    sphere->SetSphereRadius(5.0f);
    CHECK(sphere->GetScaledSphereRadius() == doctest::Approx(10.0f));
    sphere->SetRelativeScale3D(FVector(1, 3, 0.5)); // the least scale keeps it round
    CHECK(sphere->GetScaledSphereRadius() == doctest::Approx(5.0f));

    UCapsuleComponent* capsule = add_component<UCapsuleComponent>(actor, TEXT("Capsule"), root);
    capsule->SetCapsuleSize(50.0f, 20.0f); // never flatter than a ball
    CHECK(capsule->GetUnscaledCapsuleHalfHeight() == 50.0f);
    CHECK(near(capsule->Bounds.BoxExtent, FVector(100, 100, 100)));
}

TEST_CASE_FIXTURE(Scene, "primitive component: collision profiles") {
    UBoxComponent* box = add_component<UBoxComponent>(actor, TEXT("Box"), root);
    CHECK(box->GetCollisionProfileName() == FName(TEXT("OverlapAllDynamic")));
    box->SetCollisionProfileName(FName(TEXT("Pawn")));
    CHECK(box->GetCollisionObjectType() == ECC_Pawn);
    CHECK(box->GetCollisionResponseToChannel(ECC_Visibility) == ECR_Ignore);
    CHECK(box->GetCollisionResponseToChannel(ECC_WorldStatic) == ECR_Block);
    CHECK(box->K2_IsPhysicsCollisionEnabled());
    box->SetCollisionResponseToChannel(ECC_Camera, ECR_Overlap);
    CHECK(box->GetCollisionProfileName() == FName(TEXT("Custom")));
    CHECK(box->GetCollisionResponseToChannel(ECC_Camera) == ECR_Overlap);
    box->SetCollisionEnabled(ECollisionEnabled::QueryOnly);
    CHECK(box->K2_IsQueryCollisionEnabled());
    CHECK_FALSE(box->K2_IsPhysicsCollisionEnabled());
    actor->SetActorEnableCollision(false);
    CHECK(box->GetCollisionEnabled() == ECollisionEnabled::NoCollision);
    FCollisionResponseContainer container(ECR_Ignore);
    CHECK(container.SetResponse(ECC_GameTraceChannel18, ECR_Block));
    CHECK_FALSE(container.SetResponse(ECC_GameTraceChannel18, ECR_Block));
    CHECK(container.GetResponse(ECC_GameTraceChannel18) == ECR_Block);
    CHECK(container.GetResponse(static_cast<ECollisionChannel>(200)) == ECR_Ignore);
}
