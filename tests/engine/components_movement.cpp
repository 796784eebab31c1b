// SPDX-License-Identifier: MIT
// Movers: where they bring a thing after a number of steps, and that two runs agree to the last bit.
#include "engine_fixture.h"

#include "Components/InterpToMovementComponent.h"
#include "Components/SceneComponent.h"
#include "GameFramework/Actor.h"
#include "GameFramework/ProjectileMovementComponent.h"
#include "GameFramework/RotatingMovementComponent.h"

namespace {

struct Movers : EngineFixture {
    Movers() { BeginPlay(); }

    AActor* spawn_actor() {
        AActor* actor = World->SpawnActor<AActor>();
        USceneComponent* root = NewObject<USceneComponent>(actor, FName(TEXT("Root")));
        actor->SetRootComponent(root);
        root->RegisterComponent();
        return actor;
    }
    template <typename MoverType, typename SetupType>
    MoverType* add_mover(AActor* actor, SetupType setup) {
        MoverType* mover = NewObject<MoverType>(actor);
        setup(mover);
        mover->RegisterComponent();
        return mover;
    }
};

} // namespace

TEST_CASE_FIXTURE(Movers, "projectile movement: a throw follows its parabola") {
    AActor* actor = spawn_actor();
    UProjectileMovementComponent* mover = add_mover<UProjectileMovementComponent>(actor, [](auto* projectile) {
        projectile->Velocity = FVector(3, 0, 4);
        projectile->InitialSpeed = 1000.0f; // Velocity is a direction then
        projectile->bRotationFollowsVelocity = true;
    });
    CHECK(mover->Velocity.Equals(FVector(600, 0, 800), 1e-3));
    const double gravity = mover->GetGravityZ();
    CHECK(gravity == doctest::Approx(-980.0));
    const double step = 1.0 / 64.0; // a sum of these is exact
    for (int i = 0; i < 64; ++i) {
        Tick(static_cast<float>(step));
    }
    CHECK(actor->GetActorLocation().X == doctest::Approx(600.0).epsilon(1e-6));
    CHECK(actor->GetActorLocation().Z == doctest::Approx(800.0 + 0.5 * gravity).epsilon(1e-6));
    CHECK(mover->Velocity.Z == doctest::Approx(800.0 + gravity).epsilon(1e-6));
    CHECK(actor->GetVelocity().Equals(mover->Velocity, 1e-6));
    CHECK(actor->GetActorRotation().Pitch < 0.0);
}

TEST_CASE_FIXTURE(Movers, "projectile movement: two runs agree to the last bit; limits, homing and stopping") {
    FVector tracks[2];
    for (FVector& end : tracks) {
        AActor* actor = spawn_actor();
        UProjectileMovementComponent* mover = add_mover<UProjectileMovementComponent>(actor, [](auto* projectile) {
            projectile->Velocity = FVector(123.4, -56.7, 890.1);
            projectile->MaxSpeed = 900.0f;
        });
        for (int i = 0; i < 100; ++i) {
            Tick(1.0f / 60.0f);
        }
        CHECK(mover->Velocity.Size() <= 900.01);
        end = actor->GetActorLocation();
        mover->StopMovementImmediately();
        CHECK(actor->GetVelocity().IsZero());
        actor->Destroy();
    }
    CHECK(tracks[0] == tracks[1]);

    AActor* target = spawn_actor();
    target->SetActorLocation(FVector(0, 1000, 0));
    AActor* hunter = spawn_actor();
    add_mover<UProjectileMovementComponent>(hunter, [target](auto* projectile) {
        projectile->ProjectileGravityScale = 0.0f;
        projectile->Velocity = FVector(0, 0, 0);
        projectile->bIsHomingProjectile = true;
        projectile->HomingAccelerationMagnitude = 200.0f;
        projectile->HomingTargetComponent = target->GetRootComponent();
    });
    for (int i = 0; i < 60; ++i) {
        Tick(1.0f / 60.0f);
    }
    CHECK(hunter->GetActorLocation().Y == doctest::Approx(100.0).epsilon(1e-4)); // half of 200 times one second squared
    CHECK(hunter->GetActorLocation().X == doctest::Approx(0.0));
}

TEST_CASE_FIXTURE(Movers, "rotating movement: rate, pivot and plane") {
    AActor* actor = spawn_actor();
    add_mover<URotatingMovementComponent>(actor, [](auto* rotating) {
        rotating->RotationRate = FRotator(0, 90, 0);
        rotating->PivotTranslation = FVector(100, 0, 0);
    });
    for (int i = 0; i < 60; ++i) {
        Tick(1.0f / 60.0f);
    }
    CHECK(actor->GetActorRotation().Equals(FRotator(0, 90, 0), 1e-3));
    CHECK(actor->GetActorLocation().Equals(FVector(100, -100, 0), 1e-2)); // a quarter round the point (100, 0, 0)

    URotatingMovementComponent* other = add_mover<URotatingMovementComponent>(spawn_actor(), [](auto*) {});
    other->SetPlaneConstraintEnabled(true);
    other->SetPlaneConstraintNormal(FVector(0, 0, 5));
    CHECK(other->ConstrainDirectionToPlane(FVector(1, 2, 3)).Equals(FVector(1, 2, 0)));
    other->SetPlaneConstraintOrigin(FVector(0, 0, 10));
    CHECK(other->ConstrainLocationToPlane(FVector(1, 2, 3)).Equals(FVector(1, 2, 10)));
}

TEST_CASE_FIXTURE(Movers, "interp-to movement: path, turning, stopping") {
    AActor* actor = spawn_actor();
    actor->SetActorLocation(FVector(0, 0, 50));
    UInterpToMovementComponent* mover = add_mover<UInterpToMovementComponent>(actor, [](auto* interp) {
        interp->Duration = 1.0f;
        interp->AddControlPointPosition(FVector(0, 0, 0));
        interp->AddControlPointPosition(FVector(300, 0, 0));
        interp->AddControlPointPosition(FVector(300, 100, 0));
    });
    const float step = 1.0f / 64.0f;
    auto run = [&](int steps) {
        for (int i = 0; i < steps; ++i) {
            Tick(step);
        }
    };
    run(32); // half of 400 centimetres
    CHECK(actor->GetActorLocation().Equals(FVector(200, 0, 50), 1e-2));
    run(24);
    CHECK(actor->GetActorLocation().Equals(FVector(300, 50, 50), 1e-2));
    SUBCASE("one shot") {
        run(64);
        CHECK(actor->GetActorLocation().Equals(FVector(300, 100, 50), 1e-2));
        CHECK(mover->Velocity.IsZero());
    }
    SUBCASE("ping pong") {
        mover->BehaviourType = EInterpToBehaviourType::PingPong;
        run(8 + 32);
        CHECK(actor->GetActorLocation().Equals(FVector(200, 0, 50), 1e-2));
        run(32 + 16);
        CHECK(actor->GetActorLocation().Equals(FVector(100, 0, 50), 1e-2));
    }
    SUBCASE("loop") {
        mover->BehaviourType = EInterpToBehaviourType::Loop_Reset;
        run(8 + 16);
        CHECK(actor->GetActorLocation().Equals(FVector(100, 0, 50), 1e-2));
    }
}
