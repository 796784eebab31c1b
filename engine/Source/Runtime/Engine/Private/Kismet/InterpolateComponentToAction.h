// SPDX-License-Identifier: MIT
#pragma once

#include "Components/SceneComponent.h"
#include "CoreMinimal.h"
#include "Engine/LatentActionManager.h"
#include "LatentActions.h"
#include "UObject/WeakObjectPtr.h"

/** Moves a component to a relative location and rotation over a time: UKismetSystemLibrary::MoveComponentTo. */
class FInterpolateComponentToAction : public FPendingLatentAction {
public:
    FInterpolateComponentToAction(USceneComponent* Component, float Duration, bool bInEaseOut, bool bInEaseIn,
        bool bForceShortestPath, FVector InTargetLocation, FRotator InTargetRotation,
        const FLatentActionInfo& LatentInfo);

    /** Starts again from where the component is now. */
    void Restart(float Duration, bool bInEaseOut, bool bInEaseIn, bool bForceShortestPath, FVector InTargetLocation,
        FRotator InTargetRotation);
    /** Leaves the component where it is and completes. */
    void Stop() { bInterpolating = false; }
    /** Goes back to where it came from, in the time it took to get here. */
    void Return();

    virtual void UpdateOperation(FLatentResponse& Response) override;

private:
    void Place(double Alpha) const;

    TWeakObjectPtr<USceneComponent> TargetComponent;
    FName ExecutionFunction;
    int32 OutputLink;
    FWeakObjectPtr CallbackTarget;
    FVector InitialLocation;
    FVector TargetLocation;
    FRotator InitialRotation;
    FRotator TargetRotation;
    float TotalTime = 0.0f;
    float TimeElapsed = 0.0f;
    bool bEaseOut = false;
    bool bEaseIn = false;
    bool bShortestPath = false;
    bool bInterpolating = true;
};
