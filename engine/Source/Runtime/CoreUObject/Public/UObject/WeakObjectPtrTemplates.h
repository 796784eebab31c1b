// SPDX-License-Identifier: MIT
// TWeakObjectPtr. Mirrors Epic's "UObject/WeakObjectPtrTemplates.h".
#pragma once

#include "UObject/ObjectPtr.h"
#include "UObject/WeakObjectPtr.h"

template <typename T>
class TStrongObjectPtr;

/** Typed weak pointer; see FWeakObjectPtr. T may be const. */
template <class T, class TWeakObjectPtrBase>
struct TWeakObjectPtr : private TWeakObjectPtrBase {
    using ElementType = T;

    TWeakObjectPtr() = default;
    TWeakObjectPtr(TYPE_OF_NULLPTR) {}
    TWeakObjectPtr(const TWeakObjectPtr&) = default;
    TWeakObjectPtr& operator=(const TWeakObjectPtr&) = default;
    template <class U>
        requires std::is_convertible_v<U*, T*>
    TWeakObjectPtr(U* Object) {
        Assign(Object);
    }
    template <class U>
        requires std::is_convertible_v<U*, T*>
    TWeakObjectPtr(const TObjectPtr<U>& Object) {
        Assign(Object.Get());
    }
    template <class U>
        requires(!std::is_same_v<U, T> && std::is_convertible_v<U*, T*>)
    TWeakObjectPtr(const TWeakObjectPtr<U, TWeakObjectPtrBase>& Other) : TWeakObjectPtrBase(Other.ToBase()) {}
    template <class U>
        requires std::is_convertible_v<U*, T*>
    TWeakObjectPtr& operator=(U* Object) {
        Assign(Object);
        return *this;
    }
    template <class U>
        requires std::is_convertible_v<U*, T*>
    TWeakObjectPtr& operator=(const TObjectPtr<U>& Object) {
        Assign(Object.Get());
        return *this;
    }
    TWeakObjectPtr& operator=(TYPE_OF_NULLPTR) {
        TWeakObjectPtrBase::Reset();
        return *this;
    }

    T* Get(bool bEvenIfGarbage) const { return (T*)TWeakObjectPtrBase::Get(bEvenIfGarbage); }
    T* Get() const { return (T*)TWeakObjectPtrBase::Get(); }
    T* GetEvenIfUnreachable() const { return (T*)TWeakObjectPtrBase::GetEvenIfUnreachable(); }
    T& operator*() const { return *Get(); }
    T* operator->() const { return Get(); }
    explicit operator bool() const { return IsValid(); }
    /** A pointer that keeps the object alive. */
    TStrongObjectPtr<T> Pin() const { return TStrongObjectPtr<T>(Get()); }

    using TWeakObjectPtrBase::GetTypeHash;
    using TWeakObjectPtrBase::IsExplicitlyNull;
    using TWeakObjectPtrBase::IsStale;
    using TWeakObjectPtrBase::IsValid;
    using TWeakObjectPtrBase::Reset;

    bool HasSameIndexAndSerialNumber(const TWeakObjectPtr& Other) const {
        return TWeakObjectPtrBase::HasSameIndexAndSerialNumber(Other);
    }
    const TWeakObjectPtrBase& ToBase() const { return *this; }

    template <class U>
    bool operator==(const TWeakObjectPtr<U, TWeakObjectPtrBase>& Other) const {
        return ToBase() == Other.ToBase();
    }
    bool operator==(const TWeakObjectPtr& Other) const { return ToBase() == Other.ToBase(); }
    template <class U>
        requires requires(T* A, U* B) { A == B; }
    bool operator==(U* Object) const {
        return Get() == Object;
    }
    template <class U>
    bool operator==(const TObjectPtr<U>& Object) const {
        return Get() == Object.Get();
    }
    bool operator==(TYPE_OF_NULLPTR) const { return !IsValid(); }
    friend uint32 GetTypeHash(const TWeakObjectPtr& Ptr) { return Ptr.TWeakObjectPtrBase::GetTypeHash(); }

private:
    template <class U>
    void Assign(U* Object) {
        // Object types derive from UObject at offset 0; the C cast also serves types that are still incomplete here.
        TWeakObjectPtrBase::operator=((const UObject*)Object);
    }
};

template <class T>
struct TIsWeakPointerType<TWeakObjectPtr<T>> : UE::Core::Private::TBoolTrait<true> {};
/** A weak pointer to Object with its type deduced. */
template <typename T>
TWeakObjectPtr<T> MakeWeakObjectPtr(T* Object) {
    return TWeakObjectPtr<T>(Object);
}
template <typename T>
TWeakObjectPtr<T> MakeWeakObjectPtr(const TObjectPtr<T>& Object) {
    return TWeakObjectPtr<T>(Object);
}
/** A weak pointer that the object system may null (Epic: TAutoWeakObjectPtr). */
template <class T>
struct TAutoWeakObjectPtr : TWeakObjectPtr<T> {
    using TWeakObjectPtr<T>::TWeakObjectPtr;
    operator T*() const { return TWeakObjectPtr<T>::Get(); }
};

/** Copies the objects that are still valid. */
template <typename SourceArrayType, typename TargetArrayType>
void CopyFromWeakArray(TargetArrayType& Target, const SourceArrayType& Source) {
    for (const auto& Ptr : Source) {
        if (auto* Object = Ptr.Get()) {
            Target.Add(Object);
        }
    }
}
