// SPDX-License-Identifier: MIT
#pragma once

#include "CoreGlobals.h"
#include "CoreMinimal.h"
#include "Engine/LatentActionManager.h"
#include "LatentActions.h"

/** Completes a latent call after a time of the world, in seconds. Epic page: FDelayAction. */
class FDelayAction : public FPendingLatentAction {
public:
    /** Seconds that remain. */
    float TimeRemaining;
    /** The function to call. */
    FName ExecutionFunction;
    /** What to pass to it. */
    int32 OutputLink;
    /** The object to call it on. */
    FWeakObjectPtr CallbackTarget;

    FDelayAction(float Duration, const FLatentActionInfo& LatentInfo)
        : TimeRemaining(Duration), ExecutionFunction(LatentInfo.ExecutionFunction), OutputLink(LatentInfo.Linkage),
          CallbackTarget(LatentInfo.CallbackTarget) {}

    virtual void UpdateOperation(FLatentResponse& Response) override {
        TimeRemaining -= Response.ElapsedTime();
        Response.FinishAndTriggerIf(TimeRemaining <= 0.0f, ExecutionFunction, OutputLink, CallbackTarget);
    }
};

/** Completes a latent call in the next frame. Epic page: FDelayUntilNextTickAction. */
class FDelayUntilNextTickAction : public FPendingLatentAction {
public:
    /** The function to call. */
    FName ExecutionFunction;
    /** What to pass to it. */
    int32 OutputLink;
    /** The object to call it on. */
    FWeakObjectPtr CallbackTarget;

    explicit FDelayUntilNextTickAction(const FLatentActionInfo& LatentInfo)
        : ExecutionFunction(LatentInfo.ExecutionFunction), OutputLink(LatentInfo.Linkage),
          CallbackTarget(LatentInfo.CallbackTarget), FrameOfCall(GFrameCounter) {}

    virtual void UpdateOperation(FLatentResponse& Response) override {
        Response.FinishAndTriggerIf(GFrameCounter != FrameOfCall, ExecutionFunction, OutputLink, CallbackTarget);
    }

private:
    uint64 FrameOfCall;
};
