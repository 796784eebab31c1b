// SPDX-License-Identifier: MIT
/** @file Base class of latent actions. Mirrors UE's LatentActions.h. */
#pragma once

#include "CoreMinimal.h"
#include "Engine/LatentActionManager.h"
#include "UObject/WeakObjectPtr.h"

/** The response to updating a latent action. */
struct FLatentResponse {
protected:
    struct FExecutionInfo {
        FName ExecutionFunction;
        int32 LinkID;
        FWeakObjectPtr CallbackTarget;

        FExecutionInfo(FName InExecutionFunction, int32 InLinkID, FWeakObjectPtr InCallbackTarget)
            : ExecutionFunction(InExecutionFunction), LinkID(InLinkID), CallbackTarget(InCallbackTarget) {}
    };

    TArray<FExecutionInfo> LinksToExecute;
    bool bRemoveAction;
    float DeltaTime;

    friend struct FLatentActionManager;

public:
    explicit FLatentResponse(float InDeltaTime) : bRemoveAction(false), DeltaTime(InDeltaTime) {}

    /** The action is finished if Condition holds. */
    FLatentResponse& DoneIf(bool Condition) {
        bRemoveAction = Condition;
        return *this;
    }

    /** Calls the function when the update is over. */
    FLatentResponse& TriggerLink(FName ExecutionFunction, int32 LinkID, FWeakObjectPtr InCallbackTarget) {
        LinksToExecute.Add(FExecutionInfo(ExecutionFunction, LinkID, InCallbackTarget));
        return *this;
    }

    /** If Condition holds, the action is finished and its function called. */
    FLatentResponse& FinishAndTriggerIf(
        bool Condition, FName ExecutionFunction, int32 LinkID, FWeakObjectPtr InCallbackTarget) {
        bRemoveAction = Condition;
        if (bRemoveAction) {
            TriggerLink(ExecutionFunction, LinkID, InCallbackTarget);
        }
        return *this;
    }

    /** Seconds since the last update. */
    float ElapsedTime() const { return DeltaTime; }
};

/**
 * A pending latent action: updated each frame by the manager until it says that it is done.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/FPendingLatentAction
 */
class FPendingLatentAction {
public:
    FPendingLatentAction() = default;
    virtual ~FPendingLatentAction() = default;

    /** Returns whether the action is finished: through Response. Called once per frame. */
    virtual void UpdateOperation(FLatentResponse& Response) { Response.DoneIf(true); }

    /** Lets the latent action know that the object which originated it has been garbage collected and the action is
     * going to be destroyed. */
    virtual void NotifyObjectDestroyed() {}

    /** Lets the latent action know that it has been explicitly aborted. */
    virtual void NotifyActionAborted() {}
};
