// SPDX-License-Identifier: MIT
#include "Components/InterpToMovementComponent.h"

#include <cmath>

UInterpToMovementComponent::UInterpToMovementComponent(const FObjectInitializer& ObjectInitializer)
    : Super(ObjectInitializer) {
    Duration = 1.0f;
    BehaviourType = EInterpToBehaviourType::OneShot;
    StartLocation = FVector(0.0, 0.0, 0.0);
    CurrentTime = 0.0f;
    CurrentDirection = 1.0f;
    bStopped = false;
}

void UInterpToMovementComponent::BeginPlay() {
    Super::BeginPlay();
    if (UpdatedComponent) {
        StartLocation = UpdatedComponent->GetComponentLocation();
    }
    FinaliseControlPoints();
    RestartMovement(1.0f);
}

void UInterpToMovementComponent::RestartMovement(float InitialDirection) {
    CurrentDirection = InitialDirection < 0.0f ? -1.0f : 1.0f;
    CurrentTime = CurrentDirection > 0.0f ? 0.0f : 1.0f;
    bStopped = false;
}

void UInterpToMovementComponent::AddControlPointPosition(FVector Pos, bool bPositionIsRelative) {
    ControlPoints.Add(FInterpControlPoint(Pos, bPositionIsRelative));
}

void UInterpToMovementComponent::ResetControlPoints() { ControlPoints.Empty(); }

FVector UInterpToMovementComponent::PointAt(int32 Index) const {
    const FInterpControlPoint& Point = ControlPoints[Index];
    return Point.bPositionIsRelative ? StartLocation + Point.PositionControlPoint : Point.PositionControlPoint;
}

void UInterpToMovementComponent::FinaliseControlPoints() {
    double Total = 0.0;
    TArray<double> Lengths;
    for (int32 Index = 0; Index + 1 < ControlPoints.Num(); ++Index) {
        Lengths.Add((PointAt(Index + 1) - PointAt(Index)).Size());
        Total += Lengths[Index];
    }
    double Sum = 0.0;
    for (int32 Index = 0; Index < ControlPoints.Num(); ++Index) {
        const double Length = Index < Lengths.Num() ? Lengths[Index] : 0.0;
        ControlPoints[Index].Percentage = Total > 0.0 ? static_cast<float>(Sum / Total) : 0.0f;
        ControlPoints[Index].DistanceToNext = Total > 0.0 ? static_cast<float>(Length / Total) : 0.0f;
        Sum += Length;
    }
}

FVector UInterpToMovementComponent::PositionAt(float Time) const {
    const int32 Last = ControlPoints.Num() - 1;
    if (Time >= 1.0f) {
        return PointAt(Last);
    }
    int32 Index = Last - 1;
    while (Index > 0 && Time < ControlPoints[Index].Percentage) {
        --Index;
    }
    const FInterpControlPoint& Point = ControlPoints[Index];
    const double Alpha =
        Point.DistanceToNext > 0.0f ? static_cast<double>(Time - Point.Percentage) / Point.DistanceToNext : 0.0;
    return PointAt(Index) + (PointAt(Index + 1) - PointAt(Index)) * FMath::Clamp(Alpha, 0.0, 1.0);
}

void UInterpToMovementComponent::Advance(float DeltaTime) {
    CurrentTime += CurrentDirection * (Duration > 0.0f ? DeltaTime / Duration : 1.0f);
    const bool bPastEnd = CurrentTime >= 1.0f && CurrentDirection > 0.0f;
    const bool bPastStart = CurrentTime <= 0.0f && CurrentDirection < 0.0f;
    if (!bPastEnd && !bPastStart) {
        return;
    }
    const FHitResult NoHit(1.0f);
    const float End = bPastEnd ? 1.0f : 0.0f;
    // What the step went too far counts in the next leg; legs shorter than a step are cut to one.
    const float Excess = FMath::Min(std::fabs(CurrentTime - End), 1.0f);
    const bool bTurns = BehaviourType == EInterpToBehaviourType::PingPong ||
                        (BehaviourType == EInterpToBehaviourType::OneShot_Reverse && bPastEnd);
    if (bTurns) {
        CurrentDirection = -CurrentDirection;
        CurrentTime = End + CurrentDirection * Excess;
        OnInterpToReverse.Broadcast(NoHit, End);
    } else if (BehaviourType == EInterpToBehaviourType::Loop_Reset) {
        CurrentTime = 1.0f - End + CurrentDirection * Excess;
        OnInterpToReset.Broadcast(NoHit, End);
    } else {
        CurrentTime = End;
        bStopped = true;
    }
}

void UInterpToMovementComponent::TickComponent(
    float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction) {
    Super::TickComponent(DeltaTime, TickType, ThisTickFunction);
    if (ShouldSkipUpdate(DeltaTime) || bStopped || ControlPoints.Num() < 2 || DeltaTime <= 0.0f) {
        return;
    }
    Advance(DeltaTime);
    const FVector Way = PositionAt(FMath::Clamp(CurrentTime, 0.0f, 1.0f)) - UpdatedComponent->GetComponentLocation();
    MoveUpdatedComponent(Way, UpdatedComponent->GetComponentQuat(), false);
    Velocity = bStopped ? FVector(0.0, 0.0, 0.0) : Way / static_cast<double>(DeltaTime);
    UpdateComponentVelocity();
    if (bStopped) {
        OnInterpToStop.Broadcast(FHitResult(1.0f), CurrentTime);
    }
}
