// SPDX-License-Identifier: MIT
// Pointers by GUID. Mirrors Epic's "UObject/LazyObjectPtr.h".
#pragma once

#include "Misc/Guid.h"
#include "Templates/Casts.h"
#include "UObject/PersistentObjectPtr.h"

/** The GUID of an object; given out on first use and remembered while the object lives. */
struct FUniqueObjectGuid {
    FUniqueObjectGuid() = default;
    FUniqueObjectGuid(const FGuid& InGuid) : Guid(InGuid) {}
    COREUOBJECT_API explicit FUniqueObjectGuid(const UObject* InObject);
    COREUOBJECT_API UObject* ResolveObject() const;
    COREUOBJECT_API FString ToString() const;
    COREUOBJECT_API bool FromString(const FString& From);
    bool IsValid() const { return Guid.IsValid(); }
    void Reset() { Guid.Invalidate(); }
    const FGuid& GetGuid() const { return Guid; }
    bool operator==(const FUniqueObjectGuid& Other) const { return Guid == Other.Guid; }
    friend uint32 GetTypeHash(const FUniqueObjectGuid& ObjectGuid) { return GetTypeHash(ObjectGuid.Guid); }
    COREUOBJECT_API static FUniqueObjectGuid GetOrCreateIDForObject(const UObject* Object);

private:
    FGuid Guid;
};

/** Untyped lazy pointer; the value of an FLazyObjectProperty. */
struct FLazyObjectPtr : public TPersistentObjectPtr<FUniqueObjectGuid> {
    FLazyObjectPtr() = default;
    explicit FLazyObjectPtr(const UObject* Object) { TPersistentObjectPtr::operator=(Object); }
    using TPersistentObjectPtr<FUniqueObjectGuid>::operator=;
};

/** Typed lazy pointer. */
template <class T = UObject>
struct TLazyObjectPtr : private FLazyObjectPtr {
    using ElementType = T;

    TLazyObjectPtr() = default;
    TLazyObjectPtr(TYPE_OF_NULLPTR) {}
    template <class U>
        requires std::is_convertible_v<U*, T*>
    TLazyObjectPtr(U* Object) : FLazyObjectPtr((const UObject*)Object) {}
    template <class U>
        requires std::is_convertible_v<U*, T*>
    TLazyObjectPtr& operator=(U* Object) {
        FLazyObjectPtr::operator=((const UObject*)Object);
        return *this;
    }
    template <class U>
        requires std::is_convertible_v<U*, T*>
    TLazyObjectPtr& operator=(const TObjectPtr<U>& Object) {
        return *this = Object.Get();
    }
    TLazyObjectPtr& operator=(TYPE_OF_NULLPTR) {
        Reset();
        return *this;
    }
    TLazyObjectPtr& operator=(const FUniqueObjectGuid& InGuid) {
        FLazyObjectPtr::operator=(InGuid);
        return *this;
    }
    T* Get() const { return Cast<T>(FLazyObjectPtr::Get()); }
    T& operator*() const { return *Get(); }
    T* operator->() const { return Get(); }
    bool IsValid() const { return Get() != nullptr; }
    explicit operator bool() const { return IsValid(); }
    using FLazyObjectPtr::GetUniqueID;
    using FLazyObjectPtr::IsNull;
    using FLazyObjectPtr::IsPending;
    using FLazyObjectPtr::IsStale;
    using FLazyObjectPtr::Reset;
    const FLazyObjectPtr& ToBase() const { return *this; }
    bool operator==(const TLazyObjectPtr& Other) const { return GetUniqueID() == Other.GetUniqueID(); }
    bool operator==(TYPE_OF_NULLPTR) const { return !IsValid(); }
    friend uint32 GetTypeHash(const TLazyObjectPtr& Ptr) { return GetTypeHash(Ptr.GetUniqueID()); }
};
