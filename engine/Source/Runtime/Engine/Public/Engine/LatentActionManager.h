// SPDX-License-Identifier: MIT
/** @file Manager of pending latent actions. Mirrors UE's Engine/LatentActionManager.h. */
#pragma once

#include "CoreMinimal.h"
#include "Templates/UniquePtr.h"
#include "UObject/Class.h"
#include "UObject/WeakObjectPtr.h"
#include "UObject/WeakObjectPtrTemplates.h"

#include "LatentActionManager.generated.h"

class FPendingLatentAction;
class UWorld;

/** Tells what to call when a latent action completes: CallbackTarget->ExecutionFunction(Linkage). */
USTRUCT(BlueprintInternalUseOnly)
struct FLatentActionInfo {
    GENERATED_BODY()

    /** The resume point within the function to execute. INDEX_NONE: nothing to call. */
    UPROPERTY(meta = (NeedsLatentFixup = true))
    int32 Linkage;

    /** The UUID for this action: one pending action of an object per UUID. */
    UPROPERTY()
    int32 UUID;

    /** The function to execute; takes one int32, the Linkage. */
    UPROPERTY()
    FName ExecutionFunction;

    /** Object to execute the function on. */
    UPROPERTY(meta = (LatentCallbackTarget = true))
    TObjectPtr<UObject> CallbackTarget;

    FLatentActionInfo()
        : Linkage(INDEX_NONE), UUID(INDEX_NONE), ExecutionFunction(NAME_None), CallbackTarget(nullptr) {}

    FLatentActionInfo(int32 InLinkage, int32 InUUID, const TCHAR* InFunctionName, UObject* InCallbackTarget)
        : Linkage(InLinkage), UUID(InUUID), ExecutionFunction(InFunctionName), CallbackTarget(InCallbackTarget) {}
};

/** Told when an object's latent actions changed. */
enum class ELatentActionChangeType : uint8 {
    ActionsAdded,
    ActionsRemoved,
};

/** Called when latent actions of an object have been added or removed. */
DECLARE_MULTICAST_DELEGATE_TwoParams(FOnLatentActionsChanged, UObject*, ELatentActionChangeType);

/**
 * The latent action manager handles all pending latent actions for a single world.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/Engine/FLatentActionManager
 */
USTRUCT()
struct FLatentActionManager {
    GENERATED_BODY()

    /** A delegate that is called when latent actions of an object change. */
    static ENGINE_API FOnLatentActionsChanged& OnLatentActionsChanged();

    FLatentActionManager() = default;
    /** Deletes all pending actions. */
    ENGINE_API ~FLatentActionManager();
    FLatentActionManager(const FLatentActionManager&) = delete;
    FLatentActionManager& operator=(const FLatentActionManager&) = delete;

    /**
     * Advance pending latent actions by DeltaTime.
     * @param InObject specific object to update pending latent actions on, or null to update all objects that did not
     * update in this frame.
     * @param DeltaTime seconds.
     */
    ENGINE_API void ProcessLatentActions(UObject* InObject, float DeltaTime);

    /**
     * Finds the action instance for the supplied UUID, or null if it does not already exist, and only if its type is T
     * (checked by the caller: one type per UUID).
     * @param InActionObject object to check for pending latent actions.
     * @param UUID UUID of the action we are looking for.
     */
    template <typename ActionType>
    ActionType* FindExistingAction(UObject* InActionObject, int32 UUID) {
        return static_cast<ActionType*>(FindExistingActionWithKey(InActionObject, UUID));
    }

    /** Removes all latent actions of an object, telling each NotifyActionAborted. */
    ENGINE_API void RemoveActionsForObject(TWeakObjectPtr<UObject> InObject);

    /**
     * Adds a new action to the action list under a given UUID; the manager owns it from now on.
     */
    ENGINE_API void AddNewAction(UObject* InActionObject, int32 UUID, FPendingLatentAction* NewAction);

    /** Resets the list of objects processed in this frame. Called by the world. */
    ENGINE_API void BeginFrame();

    /** Number of pending actions of an object, 0 if there are none. */
    ENGINE_API int32 GetNumActionsForObject(TWeakObjectPtr<UObject> InObject);

private:
    struct FActionEntry {
        int32 UUID = 0;
        FPendingLatentAction* Action = nullptr;
    };

    /** The pending actions of one object, in the order they were added. */
    struct FObjectActions {
        TWeakObjectPtr<UObject> Object;
        TArray<FActionEntry> Actions;
        bool bProcessedThisFrame = false;
        bool bBeingProcessed = false;
        /** Removal was asked for while the actions were being processed: done right after. */
        bool bRemoveAll = false;
    };

    ENGINE_API FPendingLatentAction* FindExistingActionWithKey(UObject* InActionObject, int32 UUID);
    FObjectActions* FindObjectActions(const UObject* InObject);
    void AbortAll(FObjectActions& ObjectActions);
    void TickLatentActionForObject(FObjectActions& ObjectActions, float DeltaTime);

    /** In order of the first action of each object: deterministic. Heap-allocated since callbacks add objects while one
     * is processed. */
    TArray<TUniquePtr<FObjectActions>> ObjectActionList;
};

template <>
struct TStructOpsTypeTraits<FLatentActionManager> : public TStructOpsTypeTraitsBase2<FLatentActionManager> {
    enum { WithCopy = false };
};
