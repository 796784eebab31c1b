// SPDX-License-Identifier: MIT
// Soft object and class pointers. Mirrors Epic's "UObject/SoftObjectPtr.h".
#pragma once

#include "Templates/Casts.h"
#include "Templates/SubclassOf.h"
#include "UObject/PersistentObjectPtr.h"
#include "UObject/SoftObjectPath.h"

/** Untyped soft pointer; the value of an FSoftObjectProperty. */
struct FSoftObjectPtr : public TPersistentObjectPtr<FSoftObjectPath> {
    FSoftObjectPtr() = default;
    FSoftObjectPtr(TYPE_OF_NULLPTR) {}
    explicit FSoftObjectPtr(const FSoftObjectPath& ObjectPath) { *this = ObjectPath; }
    explicit FSoftObjectPtr(const UObject* Object) { TPersistentObjectPtr::operator=(Object); }
    using TPersistentObjectPtr<FSoftObjectPath>::operator=;

    /** Finds or loads the object. */
    UObject* LoadSynchronous() const {
        UObject* Object = Get();
        if (!Object && IsPending()) {
            Object = ToSoftObjectPath().TryLoad();
            WeakPtr = Object;
        }
        return Object;
    }
    const FSoftObjectPath& ToSoftObjectPath() const { return GetUniqueID(); }
    FString ToString() const { return ToSoftObjectPath().ToString(); }
    FString GetLongPackageName() const { return ToSoftObjectPath().GetLongPackageName(); }
    FString GetAssetName() const { return ToSoftObjectPath().GetAssetName(); }
};

/** Typed soft pointer; what UPROPERTYs hold. */
template <class T = UObject>
struct TSoftObjectPtr {
    using ElementType = T;

    TSoftObjectPtr() = default;
    TSoftObjectPtr(TYPE_OF_NULLPTR) {}
    TSoftObjectPtr(const TSoftObjectPtr&) = default;
    TSoftObjectPtr& operator=(const TSoftObjectPtr&) = default;
    template <class U>
        requires(!std::is_same_v<U, T> && std::is_convertible_v<U*, T*>)
    TSoftObjectPtr(const TSoftObjectPtr<U>& Other) : SoftObjectPtr(Other.GetSoftPtr()) {}
    template <class U>
        requires std::is_convertible_v<U*, const T*>
    TSoftObjectPtr(U* Object) : SoftObjectPtr((const UObject*)Object) {}
    template <class U>
        requires std::is_convertible_v<U*, const T*>
    TSoftObjectPtr(const TObjectPtr<U>& Object) : SoftObjectPtr((const UObject*)Object.Get()) {}
    explicit TSoftObjectPtr(const FSoftObjectPath& ObjectPath) : SoftObjectPtr(ObjectPath) {}
    explicit TSoftObjectPtr(const FSoftObjectPtr& Other) : SoftObjectPtr(Other) {}

    template <class U>
        requires std::is_convertible_v<U*, const T*>
    TSoftObjectPtr& operator=(U* Object) {
        SoftObjectPtr = (const UObject*)Object;
        return *this;
    }
    TSoftObjectPtr& operator=(TYPE_OF_NULLPTR) {
        SoftObjectPtr.Reset();
        return *this;
    }
    TSoftObjectPtr& operator=(const FSoftObjectPath& ObjectPath) {
        SoftObjectPtr = ObjectPath;
        return *this;
    }

    void Reset() { SoftObjectPtr.Reset(); }
    void ResetWeakPtr() { SoftObjectPtr.ResetWeakPtr(); }
    T* Get() const { return Cast<T>(SoftObjectPtr.Get()); }
    T& operator*() const { return *Get(); }
    T* operator->() const { return Get(); }
    T* LoadSynchronous() const { return Cast<T>(SoftObjectPtr.LoadSynchronous()); }
    bool IsPending() const { return SoftObjectPtr.IsPending(); }
    bool IsValid() const { return Get() != nullptr; }
    explicit operator bool() const { return IsValid(); }
    bool IsStale() const { return SoftObjectPtr.IsStale(); }
    bool IsNull() const { return SoftObjectPtr.IsNull(); }
    const FSoftObjectPath& GetUniqueID() const { return SoftObjectPtr.GetUniqueID(); }
    const FSoftObjectPath& ToSoftObjectPath() const { return SoftObjectPtr.ToSoftObjectPath(); }
    FString ToString() const { return SoftObjectPtr.ToString(); }
    FString GetLongPackageName() const { return SoftObjectPtr.GetLongPackageName(); }
    FString GetAssetName() const { return SoftObjectPtr.GetAssetName(); }
    const FSoftObjectPtr& GetSoftPtr() const { return SoftObjectPtr; }

    friend uint32 GetTypeHash(const TSoftObjectPtr& Ptr) {
        return GetTypeHash(static_cast<const TPersistentObjectPtr<FSoftObjectPath>&>(Ptr.SoftObjectPtr));
    }
    template <class U>
    bool operator==(const TSoftObjectPtr<U>& Other) const {
        return SoftObjectPtr == Other.GetSoftPtr();
    }
    bool operator==(TYPE_OF_NULLPTR) const { return !IsValid(); }

private:
    FSoftObjectPtr SoftObjectPtr;
};

/** Typed soft pointer to a class. */
template <class TClass = UObject>
class TSoftClassPtr {
public:
    using ElementType = TClass;

    TSoftClassPtr() = default;
    TSoftClassPtr(TYPE_OF_NULLPTR) {}
    TSoftClassPtr(const TSoftClassPtr&) = default;
    TSoftClassPtr& operator=(const TSoftClassPtr&) = default;
    template <class U>
        requires(!std::is_same_v<U, TClass> && std::is_convertible_v<U*, TClass*>)
    TSoftClassPtr(const TSoftClassPtr<U>& Other) : SoftObjectPtr(Other.GetSoftPtr()) {}
    TSoftClassPtr(const UClass* From) : SoftObjectPtr((const UObject*)From) {}
    explicit TSoftClassPtr(const FSoftObjectPath& ObjectPath) : SoftObjectPtr(ObjectPath) {}
    explicit TSoftClassPtr(const FSoftObjectPtr& Other) : SoftObjectPtr(Other) {}
    TSoftClassPtr& operator=(const UClass* From) {
        SoftObjectPtr = (const UObject*)From;
        return *this;
    }
    TSoftClassPtr& operator=(const FSoftObjectPath& ObjectPath) {
        SoftObjectPtr = ObjectPath;
        return *this;
    }
    TSoftClassPtr& operator=(TYPE_OF_NULLPTR) {
        SoftObjectPtr.Reset();
        return *this;
    }

    void Reset() { SoftObjectPtr.Reset(); }
    UClass* Get() const { return Check(SoftObjectPtr.Get()); }
    UClass* operator*() const { return Get(); }
    UClass* operator->() const { return Get(); }
    UClass* LoadSynchronous() const { return Check(SoftObjectPtr.LoadSynchronous()); }
    bool IsPending() const { return SoftObjectPtr.IsPending(); }
    bool IsValid() const { return Get() != nullptr; }
    explicit operator bool() const { return IsValid(); }
    bool IsStale() const { return SoftObjectPtr.IsStale(); }
    bool IsNull() const { return SoftObjectPtr.IsNull(); }
    const FSoftObjectPath& GetUniqueID() const { return SoftObjectPtr.GetUniqueID(); }
    const FSoftObjectPath& ToSoftObjectPath() const { return SoftObjectPtr.ToSoftObjectPath(); }
    FString ToString() const { return SoftObjectPtr.ToString(); }
    FString GetLongPackageName() const { return SoftObjectPtr.GetLongPackageName(); }
    FString GetAssetName() const { return SoftObjectPtr.GetAssetName(); }
    const FSoftObjectPtr& GetSoftPtr() const { return SoftObjectPtr; }
    friend uint32 GetTypeHash(const TSoftClassPtr& Ptr) {
        return GetTypeHash(static_cast<const TPersistentObjectPtr<FSoftObjectPath>&>(Ptr.SoftObjectPtr));
    }
    template <class U>
    bool operator==(const TSoftClassPtr<U>& Other) const {
        return SoftObjectPtr == Other.GetSoftPtr();
    }

private:
    static UClass* Check(UObject* Object) {
        return UE::CoreUObject::Private::AsChildClass(Object, std::remove_const_t<TClass>::StaticClass());
    }
    FSoftObjectPtr SoftObjectPtr;
};

template <class T>
struct TIsSoftObjectPointerType {
    static constexpr bool Value = false;
};
template <class T>
struct TIsSoftObjectPointerType<TSoftObjectPtr<T>> {
    static constexpr bool Value = true;
};
