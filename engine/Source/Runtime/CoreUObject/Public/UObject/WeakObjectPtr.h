// SPDX-License-Identifier: MIT
// Weak pointers: an index into the object table and a serial number. Mirrors Epic's "UObject/WeakObjectPtr.h".
#pragma once

#include "UObject/ObjectPtr.h"
#include "UObject/UObjectArray.h"
#include "UObject/UObjectBase.h"
#include "UObject/WeakObjectPtrTemplatesFwd.h"

/** A pointer that turns null when its object becomes garbage, unreachable, or dies. Does not keep the object alive. */
struct FWeakObjectPtr {
    FWeakObjectPtr() = default;
    FWeakObjectPtr(TYPE_OF_NULLPTR) {}
    template <typename U>
        requires std::is_convertible_v<U, const UObject*>
    FWeakObjectPtr(U Object) {
        *this = static_cast<const UObject*>(Object);
    }
    FWeakObjectPtr(const FWeakObjectPtr&) = default;
    FWeakObjectPtr& operator=(const FWeakObjectPtr&) = default;
    COREUOBJECT_API void operator=(const UObject* Object);
    template <typename U>
    void operator=(const TObjectPtr<U>& Object) {
        *this = static_cast<const UObject*>(Object.Get());
    }

    /** The object, or null. Garbage objects count as null unless bEvenIfGarbage. */
    COREUOBJECT_API UObject* Get(bool bEvenIfGarbage) const;
    UObject* Get() const { return Get(false); }
    /** The object as long as its memory is there, also between a collection's mark and destruction. */
    COREUOBJECT_API UObject* GetEvenIfUnreachable() const;
    COREUOBJECT_API bool IsValid(bool bEvenIfGarbage, bool bThreadsafeTest = false) const;
    bool IsValid() const { return IsValid(false); }
    /** True if it pointed to an object that is gone. */
    COREUOBJECT_API bool IsStale(bool bIncludingGarbage = true, bool bThreadsafeTest = false) const;
    /** True if it was never set or was set to null. */
    bool IsExplicitlyNull() const { return ObjectIndex == INDEX_NONE || ObjectSerialNumber == 0; }
    void Reset() {
        ObjectIndex = INDEX_NONE;
        ObjectSerialNumber = 0;
    }
    bool HasSameIndexAndSerialNumber(const FWeakObjectPtr& Other) const {
        return ObjectIndex == Other.ObjectIndex && ObjectSerialNumber == Other.ObjectSerialNumber;
    }
    /** Equal if both point to the same live object or both to none. */
    bool operator==(const FWeakObjectPtr& Other) const {
        return HasSameIndexAndSerialNumber(Other) || (!IsValid() && !Other.IsValid());
    }
    uint32 GetTypeHash() const { return static_cast<uint32>(ObjectIndex ^ ObjectSerialNumber); }
    friend uint32 GetTypeHash(const FWeakObjectPtr& Ptr) { return Ptr.GetTypeHash(); }

    int32 GetObjectIndex() const { return ObjectIndex; }
    int32 GetObjectSerialNumber() const { return ObjectSerialNumber; }

private:
    FUObjectItem* FindItem() const;

    int32 ObjectIndex = INDEX_NONE;
    int32 ObjectSerialNumber = 0;
};
