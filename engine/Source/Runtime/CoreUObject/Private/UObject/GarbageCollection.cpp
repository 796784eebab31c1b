// SPDX-License-Identifier: MIT
// Mark-and-sweep garbage collection.
#include "UObject/GarbageCollection.h"

#include "HAL/PlatformProcess.h"
#include "HAL/PlatformTime.h"
#include "ObjectSystem.h"
#include "UObject/Class.h"
#include "UObject/GCObject.h"
#include "UObject/SparseDelegate.h"
#include "UObject/StrongObjectPtr.h"
#include "UObject/UnrealType.h"

DEFINE_LOG_CATEGORY_STATIC(LogGarbage, Log, All);

namespace {
bool GIsCollecting = false;
int32 GCollectionLocks = 0;
/** Objects past BeginDestroy whose memory waits to be freed. */
TArray<UObject*>& PendingPurge() {
    static TArray<UObject*>& Instance = *new TArray<UObject*>;
    return Instance;
}

/** Marks what it visits as reachable and nulls references to garbage. */
class FMarker final : public FReferenceCollector {
public:
    /** Marks an object; its references are walked later, so that long chains do not nest. */
    void Mark(UObject* Object) {
        FUObjectItem* Item = GUObjectArray.ObjectToObjectItem(Object);
        if (Item->IsUnreachable()) {
            Item->Flags &= ~static_cast<int32>(EInternalObjectFlags::Unreachable);
            Work.Add(Object);
        }
    }
    void WalkAll() {
        while (!Work.IsEmpty()) {
            UObject* Object = Work.Pop(EAllowShrinking::No);
            UClass* Class = Object->GetClass();
            Mark(Class);
            if (UObject* Outer = Object->GetOuter()) {
                Mark(Outer);
            }
            AddPropertyReferences(Class, Object, Object);
            if (Class->ClassAddReferencedObjects) {
                Class->ClassAddReferencedObjects(Object, *this);
            }
        }
    }
    virtual void AllowEliminatingReferences(bool bAllow) override { bMayEliminate = bAllow; }

protected:
    virtual void HandleObjectReference(UObject*& InObject, const UObject*, const FProperty*) override {
        if (!InObject) {
            return;
        }
        checkfSlow(GUObjectArray.IsValid(InObject), TEXT("A reference to a destroyed object was reported"));
        const FUObjectItem* Item = GUObjectArray.ObjectToObjectItem(InObject);
        if (bMayEliminate && Item->IsGarbage() && !Item->IsRootSet()) {
            InObject = nullptr;
            return;
        }
        Mark(InObject);
    }

private:
    TArray<UObject*> Work;
    bool bMayEliminate = true;
};

void BeginDestroyAll(const TArray<UObject*>& Objects) {
    FCoreUObjectDelegates::PreGarbageCollectConditionalBeginDestroy.Broadcast();
    for (UObject* Object : Objects) {
        Object->ConditionalBeginDestroy();
    }
    FCoreUObjectDelegates::PostGarbageCollectConditionalBeginDestroy.Broadcast();
}

/** Finishes objects that are ready; returns true when none is left. TimeLimit 0 means no limit. */
bool Purge(double TimeLimit) {
    TArray<UObject*>& Pending = PendingPurge();
    const double End = FPlatformTime::Seconds() + TimeLimit;
    int32 Kept = 0;
    int32 Index = 0;
    for (; Index < Pending.Num(); ++Index) {
        if (TimeLimit > 0 && FPlatformTime::Seconds() > End) {
            break;
        }
        UObject* Object = Pending[Index];
        if (!Object->HasAnyFlags(RF_FinishDestroyed) && !Object->IsReadyForFinishDestroy()) {
            Pending[Kept++] = Object;
            continue;
        }
        Object->ConditionalFinishDestroy();
        FObjectSystem::DestroyAndFree(Object);
    }
    for (; Index < Pending.Num(); ++Index) {
        Pending[Kept++] = Pending[Index];
    }
    Pending.SetNum(Kept);
    return Pending.IsEmpty();
}

/** Purges until all objects agree to be destroyed; gives up on objects that never do. */
void PurgeAll() {
    const double Deadline = FPlatformTime::Seconds() + 10.0;
    while (!Purge(0)) {
        if (FPlatformTime::Seconds() > Deadline) {
            UE_LOG(LogGarbage, Error, TEXT("%d objects are not ready for FinishDestroy after 10 s, for instance a %s"),
                PendingPurge().Num(), *PendingPurge()[0]->GetClass()->GetPathName());
            return;
        }
        FPlatformProcess::Sleep(0.001f);
    }
}
} // namespace

TArray<FGCObject*>& FObjectSystem::GCObjects() {
    static TArray<FGCObject*>& Instance = *new TArray<FGCObject*>;
    return Instance;
}
void FGCObject::RegisterGCObject() { FObjectSystem::GCObjects().AddUnique(this); }
void FGCObject::UnregisterGCObject() { FObjectSystem::GCObjects().Remove(this); }

FGCScopeGuard::FGCScopeGuard() { ++GCollectionLocks; }
FGCScopeGuard::~FGCScopeGuard() { --GCollectionLocks; }

bool IsGarbageCollecting() { return GIsCollecting; }
bool IsIncrementalPurgePending() { return !PendingPurge().IsEmpty(); }
bool IsIncrementalUnhashPending() { return false; }
void IncrementalPurgeGarbage(bool bUseTimeLimit, double TimeLimit) {
    if (bUseTimeLimit) {
        Purge(TimeLimit > 0 ? TimeLimit : 0.002);
    } else {
        PurgeAll();
    }
}

bool TryCollectGarbage(EObjectFlags KeepFlags, bool bPerformFullPurge) {
    if (GIsCollecting || GCollectionLocks > 0 || IsInConstructor()) {
        return false;
    }
    CollectGarbage(KeepFlags, bPerformFullPurge);
    return true;
}

void CollectGarbage(EObjectFlags KeepFlags, bool bPerformFullPurge) {
    checkf(!GIsCollecting, TEXT("CollectGarbage called while garbage is being collected"));
    checkf(!IsInConstructor(), TEXT("CollectGarbage called inside a constructor"));
    if (GCollectionLocks > 0) {
        return;
    }
    FCoreUObjectDelegates::GetPreGarbageCollectDelegate().Broadcast();
    // Objects of the last collection must be gone before their slots are looked at again.
    PurgeAll();
    GIsCollecting = true;

    const int32 NumSlots = GUObjectArray.GetObjectArrayNum();
    FMarker Marker;
    for (int32 Index = 0; Index < NumSlots; ++Index) {
        FUObjectItem* Item = GUObjectArray.IndexToObject(Index);
        if (Item->Object) {
            Item->Flags |= static_cast<int32>(EInternalObjectFlags::Unreachable);
        }
    }
    for (int32 Index = 0; Index < NumSlots; ++Index) {
        FUObjectItem* Item = GUObjectArray.IndexToObject(Index);
        if (!Item->Object) {
            continue;
        }
        UObject* Object = static_cast<UObject*>(Item->Object);
        const bool bKept = KeepFlags != RF_NoFlags && Object->HasAnyFlags(KeepFlags) && !Item->IsGarbage();
        if (Item->HasAnyFlags(EInternalObjectFlags_RootFlags) || Item->RefCount > 0 || bKept) {
            Marker.Mark(Object);
        }
    }
    const TArray<FGCObject*> GCObjects = FObjectSystem::GCObjects();
    for (FGCObject* Holder : GCObjects) {
        Holder->AddReferencedObjects(Marker);
        Marker.AllowEliminatingReferences(true);
    }
    Marker.WalkAll();

    TArray<UObject*> Unreachable;
    for (int32 Index = 0; Index < NumSlots; ++Index) {
        const FUObjectItem* Item = GUObjectArray.IndexToObject(Index);
        if (Item->Object && Item->IsUnreachable()) {
            Unreachable.Add(static_cast<UObject*>(Item->Object));
        }
    }
    FCoreUObjectDelegates::PostReachabilityAnalysis.Broadcast();
    BeginDestroyAll(Unreachable);
    PendingPurge().Append(Unreachable);
    GIsCollecting = false;
    if (bPerformFullPurge) {
        PurgeAll();
    }
    UE_LOG(LogGarbage, Verbose, TEXT("Garbage collection: %d objects destroyed, %d alive"), Unreachable.Num(),
        GUObjectArray.GetObjectArrayNumMinusAvailable());
    FCoreUObjectDelegates::GetPostGarbageCollect().Broadcast();
    FCoreUObjectDelegates::GarbageCollectComplete.Broadcast();
}

// ---------------------------------------------------------------------------------------------------------------------------

void FReferenceCollector::AddReferencedObject(
    FWeakObjectPtr& Object, const UObject* ReferencingObject, const FProperty* ReferencingProperty) {
    UObject* Strong = Object.GetEvenIfUnreachable();
    if (Strong) {
        HandleObjectReference(Strong, ReferencingObject, ReferencingProperty);
        if (!Strong) {
            Object.Reset();
        }
    }
}

void FReferenceCollector::AddPropertyReferences(
    const UStruct* Struct, void* Instance, const UObject* ReferencingObject) {
    for (FProperty* Property = Struct->RefLink; Property; Property = Property->NextRef) {
        Property->CollectReferences(Property->ContainerPtrToValuePtr<void>(Instance), *this, ReferencingObject);
    }
    if (Struct->GetClass()->HasAnyCastFlag(CASTCLASS_UScriptStruct)) {
        const UScriptStruct* ScriptStruct = static_cast<const UScriptStruct*>(Struct);
        if (ScriptStruct->StructFlags & STRUCT_AddStructReferencedObjects) {
            ScriptStruct->GetCppStructOps()->AddStructReferencedObjects(Instance, *this);
        }
    }
}

namespace UE::CoreUObject::Private {
void AddStrongReference(const UObject* Object) { ++GUObjectArray.ObjectToObjectItem(Object)->RefCount; }
void ReleaseStrongReference(const UObject* Object) {
    FUObjectItem* Item = GUObjectArray.ObjectToObjectItem(Object);
    check(Item && Item->RefCount > 0);
    --Item->RefCount;
}
} // namespace UE::CoreUObject::Private
