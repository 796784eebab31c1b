// SPDX-License-Identifier: MIT
#include "GameFramework/FloatingPawnMovement.h"

#include "Components/SceneComponent.h"
#include "GameFramework/Pawn.h"

UFloatingPawnMovement::UFloatingPawnMovement(const FObjectInitializer& ObjectInitializer) : Super(ObjectInitializer) {
    PrimaryComponentTick.bCanEverTick = true;
    MaxSpeed = 1200.f;
    Acceleration = 4000.f;
    Deceleration = 8000.f;
    TurningBoost = 8.f;
}

void UFloatingPawnMovement::TickComponent(
    float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction) {
    if (ShouldSkipUpdate(DeltaTime)) {
        return;
    }
    Super::TickComponent(DeltaTime, TickType, ThisTickFunction);
    if (!PawnOwner || !UpdatedComponent) {
        return;
    }
    if (!PawnOwner->CheckStillInWorld()) {
        return;
    }
    ApplyControlInputToVelocity(DeltaTime);
    const FVector Delta = Velocity * DeltaTime;
    if (!Delta.IsNearlyZero(1.0e-6)) {
        FHitResult Hit(1.f);
        MoveUpdatedComponent(Delta, UpdatedComponent->GetComponentQuat(), true, &Hit);
    }
    UpdateComponentVelocity();
}

void UFloatingPawnMovement::ApplyControlInputToVelocity(float DeltaTime) {
    const FVector Input = ConsumeInputVector().GetClampedToMaxSize(1.0);
    const double OldSpeed = Velocity.Size();
    const double BrakedSpeed = FMath::Max(0.0, OldSpeed - static_cast<double>(Deceleration) * DeltaTime);
    if (Input.IsNearlyZero()) {
        Velocity = Velocity.GetSafeNormal() * BrakedSpeed;
        return;
    }
    // What is across the new direction fades, the faster the larger the boost; what is along it stays.
    const FVector Direction = Input.GetSafeNormal();
    const FVector Along = Direction * FVector::DotProduct(Velocity, Direction);
    const FVector Across = Velocity - Along;
    Velocity = Along + Across * FMath::Exp(-static_cast<double>(TurningBoost) * DeltaTime) +
               Input * (static_cast<double>(Acceleration) * DeltaTime);
    // Half the input is half the speed. What is faster than that already slows down at the rate of braking.
    const double SpeedLimit = FMath::Max(static_cast<double>(GetMaxSpeed()) * Input.Size(), BrakedSpeed);
    Velocity = Velocity.GetClampedToMaxSize(SpeedLimit);
}
