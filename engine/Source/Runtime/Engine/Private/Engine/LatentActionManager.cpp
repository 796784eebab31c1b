// SPDX-License-Identifier: MIT
#include "Engine/LatentActionManager.h"

#include "LatentActions.h"
#include "UObject/Class.h"
#include "UObject/Object.h"

FOnLatentActionsChanged& FLatentActionManager::OnLatentActionsChanged() {
    static FOnLatentActionsChanged Delegate;
    return Delegate;
}

FLatentActionManager::~FLatentActionManager() {
    for (const TUniquePtr<FObjectActions>& ObjectActions : ObjectActionList) {
        for (const FActionEntry& Entry : ObjectActions->Actions) {
            delete Entry.Action;
        }
    }
}

FLatentActionManager::FObjectActions* FLatentActionManager::FindObjectActions(const UObject* InObject) {
    for (const TUniquePtr<FObjectActions>& ObjectActions : ObjectActionList) {
        if (ObjectActions->Object.Get() == InObject) {
            return ObjectActions.Get();
        }
    }
    return nullptr;
}

FPendingLatentAction* FLatentActionManager::FindExistingActionWithKey(UObject* InActionObject, int32 UUID) {
    if (const FObjectActions* ObjectActions = InActionObject ? FindObjectActions(InActionObject) : nullptr) {
        for (const FActionEntry& Entry : ObjectActions->Actions) {
            if (Entry.UUID == UUID && !ObjectActions->bRemoveAll) {
                return Entry.Action;
            }
        }
    }
    return nullptr;
}

void FLatentActionManager::AddNewAction(UObject* InActionObject, int32 UUID, FPendingLatentAction* NewAction) {
    FObjectActions* ObjectActions = FindObjectActions(InActionObject);
    if (!ObjectActions) {
        ObjectActionList.Add(MakeUnique<FObjectActions>());
        ObjectActions = ObjectActionList.Last().Get();
        ObjectActions->Object = InActionObject;
    }
    ObjectActions->Actions.Add(FActionEntry{UUID, NewAction});
    OnLatentActionsChanged().Broadcast(InActionObject, ELatentActionChangeType::ActionsAdded);
}

void FLatentActionManager::RemoveActionsForObject(TWeakObjectPtr<UObject> InObject) {
    // Found also while the object is being destroyed: that is when this is called mostly.
    for (const TUniquePtr<FObjectActions>& ObjectActions : ObjectActionList) {
        if (!ObjectActions->Object.HasSameIndexAndSerialNumber(InObject) || ObjectActions->Actions.Num() == 0) {
            continue;
        }
        if (ObjectActions->bBeingProcessed) {
            ObjectActions->bRemoveAll = true;
            return;
        }
        AbortAll(*ObjectActions);
        return;
    }
}

void FLatentActionManager::AbortAll(FObjectActions& ObjectActions) {
    const TArray<FActionEntry> Entries = MoveTemp(ObjectActions.Actions);
    ObjectActions.Actions.Reset();
    ObjectActions.bRemoveAll = false;
    for (const FActionEntry& Entry : Entries) {
        Entry.Action->NotifyActionAborted();
        delete Entry.Action;
    }
    OnLatentActionsChanged().Broadcast(ObjectActions.Object.Get(true), ELatentActionChangeType::ActionsRemoved);
}

int32 FLatentActionManager::GetNumActionsForObject(TWeakObjectPtr<UObject> InObject) {
    const FObjectActions* ObjectActions = InObject.IsValid() ? FindObjectActions(InObject.Get()) : nullptr;
    return ObjectActions ? ObjectActions->Actions.Num() : 0;
}

void FLatentActionManager::BeginFrame() {
    for (int32 Index = ObjectActionList.Num() - 1; Index >= 0; --Index) {
        FObjectActions& ObjectActions = *ObjectActionList[Index];
        ObjectActions.bProcessedThisFrame = false;
        if (ObjectActions.Actions.Num() == 0 && !ObjectActions.bBeingProcessed) {
            ObjectActionList.RemoveAt(Index);
        }
    }
}

void FLatentActionManager::ProcessLatentActions(UObject* InObject, float DeltaTime) {
    if (InObject) {
        FObjectActions* ObjectActions = FindObjectActions(InObject);
        if (ObjectActions && !ObjectActions->bProcessedThisFrame && !ObjectActions->bBeingProcessed) {
            TickLatentActionForObject(*ObjectActions, DeltaTime);
        }
        return;
    }
    // By index and only what is there now: callbacks add objects, whose actions start with the next frame.
    const int32 Count = ObjectActionList.Num();
    for (int32 Index = 0; Index < Count; ++Index) {
        FObjectActions& ObjectActions = *ObjectActionList[Index];
        if (ObjectActions.bProcessedThisFrame || ObjectActions.bBeingProcessed) {
            continue;
        }
        if (ObjectActions.Object.IsValid()) {
            TickLatentActionForObject(ObjectActions, DeltaTime);
            continue;
        }
        const TArray<FActionEntry> Entries = MoveTemp(ObjectActions.Actions);
        ObjectActions.Actions.Reset();
        for (const FActionEntry& Entry : Entries) {
            Entry.Action->NotifyObjectDestroyed();
            delete Entry.Action;
        }
    }
}

void FLatentActionManager::TickLatentActionForObject(FObjectActions& ObjectActions, float DeltaTime) {
    ObjectActions.bProcessedThisFrame = true;
    ObjectActions.bBeingProcessed = true;
    UObject* const Object = ObjectActions.Object.Get();

    FLatentResponse Response(DeltaTime);
    bool bRemovedAny = false;
    const int32 Count = ObjectActions.Actions.Num();
    TArray<FPendingLatentAction*> Finished;
    for (int32 Index = 0; Index < Count && !ObjectActions.bRemoveAll; ++Index) {
        Response.bRemoveAction = false;
        FPendingLatentAction* Action = ObjectActions.Actions[Index].Action;
        Action->UpdateOperation(Response);
        if (Response.bRemoveAction) {
            Finished.Add(Action);
        }
    }
    for (FPendingLatentAction* Action : Finished) {
        ObjectActions.Actions.RemoveAll([Action](const FActionEntry& Entry) { return Entry.Action == Action; });
        delete Action;
        bRemovedAny = true;
    }
    ObjectActions.bBeingProcessed = false;
    if (ObjectActions.bRemoveAll) {
        AbortAll(ObjectActions);
    } else if (bRemovedAny) {
        OnLatentActionsChanged().Broadcast(Object, ELatentActionChangeType::ActionsRemoved);
    }

    for (const FLatentResponse::FExecutionInfo& Link : Response.LinksToExecute) {
        UObject* Target = Link.CallbackTarget.Get();
        if (!Target || Link.LinkID == INDEX_NONE) {
            continue;
        }
        if (UFunction* Function = Target->FindFunction(Link.ExecutionFunction)) {
            int32 LinkID = Link.LinkID;
            Target->ProcessEvent(Function, &LinkID);
        } else {
            UE_LOG(LogTemp, Warning,
                TEXT("FLatentActionManager: %s has no function '%s' to call when a latent action completes"),
                *GetNameSafe(Target), *Link.ExecutionFunction.ToString());
        }
    }
}
