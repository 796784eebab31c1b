// SPDX-License-Identifier: MIT
#include "InterpolateComponentToAction.h"
#include "Kismet/KismetMathLibrary.h"

FInterpolateComponentToAction::FInterpolateComponentToAction(USceneComponent* Component, float Duration,
    bool bInEaseOut, bool bInEaseIn, bool bForceShortestPath, FVector InTargetLocation, FRotator InTargetRotation,
    const FLatentActionInfo& LatentInfo)
    : TargetComponent(Component), ExecutionFunction(LatentInfo.ExecutionFunction), OutputLink(LatentInfo.Linkage),
      CallbackTarget(LatentInfo.CallbackTarget.Get()) {
    Restart(Duration, bInEaseOut, bInEaseIn, bForceShortestPath, InTargetLocation, InTargetRotation);
}

void FInterpolateComponentToAction::Restart(float Duration, bool bInEaseOut, bool bInEaseIn, bool bForceShortestPath,
    FVector InTargetLocation, FRotator InTargetRotation) {
    if (const USceneComponent* const Component = TargetComponent.Get()) {
        InitialLocation = Component->GetRelativeLocation();
        InitialRotation = Component->GetRelativeRotation();
    }
    TargetLocation = InTargetLocation;
    TargetRotation = InTargetRotation;
    TotalTime = Duration;
    TimeElapsed = 0.0f;
    bEaseOut = bInEaseOut;
    bEaseIn = bInEaseIn;
    bShortestPath = bForceShortestPath;
    bInterpolating = true;
}

void FInterpolateComponentToAction::Return() {
    const FVector BackTo = InitialLocation;
    const FRotator BackToRotation = InitialRotation;
    Restart(TimeElapsed, bEaseOut, bEaseIn, bShortestPath, BackTo, BackToRotation);
}

void FInterpolateComponentToAction::UpdateOperation(FLatentResponse& Response) {
    TimeElapsed += Response.ElapsedTime();
    bool bComplete = !bInterpolating || !TargetComponent.IsValid();
    if (!bComplete) {
        bComplete = TimeElapsed >= TotalTime;
        Place(bComplete ? 1.0 : static_cast<double>(TimeElapsed) / TotalTime);
    }
    Response.FinishAndTriggerIf(bComplete, ExecutionFunction, OutputLink, CallbackTarget);
}

void FInterpolateComponentToAction::Place(double Alpha) const {
    USceneComponent* const Component = TargetComponent.Get();
    if (Alpha >= 1.0) {
        Component->SetRelativeLocationAndRotation(TargetLocation, TargetRotation, false);
        return;
    }
    TEnumAsByte<EEasingFunc::Type> Easing = EEasingFunc::Linear;
    if (bEaseIn) {
        Easing = bEaseOut ? EEasingFunc::EaseInOut : EEasingFunc::EaseIn;
    } else if (bEaseOut) {
        Easing = EEasingFunc::EaseOut;
    }
    const double Eased = UKismetMathLibrary::Ease(0.0, 1.0, Alpha, Easing);
    const FVector Location = InitialLocation + (TargetLocation - InitialLocation) * Eased;
    const FRotator Rotation =
        UKismetMathLibrary::RLerp(InitialRotation, TargetRotation, static_cast<float>(Eased), bShortestPath);
    Component->SetRelativeLocationAndRotation(Location, Rotation, false);
}
