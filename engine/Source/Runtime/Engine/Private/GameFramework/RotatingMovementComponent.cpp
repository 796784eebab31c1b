// SPDX-License-Identifier: MIT
#include "GameFramework/RotatingMovementComponent.h"

URotatingMovementComponent::URotatingMovementComponent(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer) {
    RotationRate = FRotator(0.0, 180.0, 0.0);
    PivotTranslation = FVector(0.0, 0.0, 0.0);
    bRotationInLocalSpace = true;
}

void URotatingMovementComponent::TickComponent(
    float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction) {
    Super::TickComponent(DeltaTime, TickType, ThisTickFunction);
    if (ShouldSkipUpdate(DeltaTime)) {
        return;
    }
    const FQuat Old = UpdatedComponent->GetComponentQuat();
    const FQuat Delta =
        FRotator(RotationRate.Pitch * DeltaTime, RotationRate.Yaw * DeltaTime, RotationRate.Roll * DeltaTime)
            .Quaternion();
    const FQuat New = (bRotationInLocalSpace ? Old * Delta : Delta * Old).GetNormalized();
    // The pivot stays where it is while we turn.
    const FVector Way = PivotTranslation.IsZero()
                            ? FVector(0.0, 0.0, 0.0)
                            : Old.RotateVector(PivotTranslation) - New.RotateVector(PivotTranslation);
    MoveUpdatedComponent(Way, New, false);
}
