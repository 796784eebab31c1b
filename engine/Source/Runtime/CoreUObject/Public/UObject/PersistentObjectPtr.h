// SPDX-License-Identifier: MIT
// A weak pointer with an identifier that outlives the object. Mirrors Epic's "UObject/PersistentObjectPtr.h".
#pragma once

#include "UObject/WeakObjectPtr.h"

COREUOBJECT_API bool IsValid(const UObject* Test);

/** Resolves an id (soft path, GUID) to an object and caches it weakly. */
template <class TObjectID>
struct TPersistentObjectPtr {
    using ElementType = TObjectID;

    TPersistentObjectPtr() = default;
    TPersistentObjectPtr(TYPE_OF_NULLPTR) {}

    void Reset() {
        WeakPtr.Reset();
        ObjectID.Reset();
    }
    void ResetWeakPtr() { WeakPtr.Reset(); }
    TPersistentObjectPtr& operator=(const TObjectID& InObjectID) {
        WeakPtr.Reset();
        ObjectID = InObjectID;
        return *this;
    }
    TPersistentObjectPtr& operator=(const FWeakObjectPtr& Other) {
        return *this = static_cast<const UObject*>(Other.Get());
    }
    TPersistentObjectPtr& operator=(const UObject* Object) {
        if (Object) {
            ObjectID = TObjectID::GetOrCreateIDForObject(Object);
            WeakPtr = Object;
        } else {
            Reset();
        }
        return *this;
    }
    const TObjectID& GetUniqueID() const { return ObjectID; }
    TObjectID& GetUniqueID() { return ObjectID; }
    /** The object if it is in memory. */
    UObject* Get() const {
        UObject* Object = WeakPtr.Get();
        if (!Object && ObjectID.IsValid()) {
            Object = ObjectID.ResolveObject();
            WeakPtr = Object;
        }
        return ::IsValid(Object) ? Object : nullptr;
    }
    UObject* Get(bool bEvenIfGarbage) const {
        UObject* Object = WeakPtr.Get(bEvenIfGarbage);
        return Object ? Object : Get();
    }
    UObject& operator*() const { return *Get(); }
    UObject* operator->() const { return Get(); }
    /** Not null, and not in memory. */
    bool IsPending() const { return Get() == nullptr && ObjectID.IsValid(); }
    bool IsValid() const { return Get() != nullptr; }
    bool IsStale() const { return WeakPtr.IsStale(); }
    /** Refers to nothing, loaded or not. */
    bool IsNull() const { return !ObjectID.IsValid(); }
    bool operator==(const TPersistentObjectPtr& Other) const { return ObjectID == Other.ObjectID; }
    friend uint32 GetTypeHash(const TPersistentObjectPtr& Ptr) { return GetTypeHash(Ptr.ObjectID); }

protected:
    mutable FWeakObjectPtr WeakPtr;
    TObjectID ObjectID;
};
