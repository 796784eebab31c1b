// SPDX-License-Identifier: MIT
// TStrongObjectPtr: keeps an object alive from outside the object system. Mirrors Epic's "UObject/StrongObjectPtr.h".
#pragma once

#include "UObject/WeakObjectPtrTemplates.h"

namespace UE::CoreUObject::Private {
COREUOBJECT_API void AddStrongReference(const UObject* Object);
COREUOBJECT_API void ReleaseStrongReference(const UObject* Object);
} // namespace UE::CoreUObject::Private

/** Owning pointer for code that is not reflected; counted in the object table. */
template <typename T>
class TStrongObjectPtr {
public:
    using ElementType = T;

    TStrongObjectPtr() = default;
    TStrongObjectPtr(TYPE_OF_NULLPTR) {}
    explicit TStrongObjectPtr(T* InObject) { Set(InObject); }
    template <typename U>
        requires std::is_convertible_v<U*, T*>
    explicit TStrongObjectPtr(const TObjectPtr<U>& InObject) {
        Set(InObject.Get());
    }
    TStrongObjectPtr(const TStrongObjectPtr& Other) { Set(Other.Object); }
    TStrongObjectPtr(TStrongObjectPtr&& Other) : Object(Other.Object) { Other.Object = nullptr; }
    template <typename U>
        requires std::is_convertible_v<U*, T*>
    TStrongObjectPtr(const TStrongObjectPtr<U>& Other) {
        Set(Other.Get());
    }
    ~TStrongObjectPtr() { Reset(); }
    TStrongObjectPtr& operator=(const TStrongObjectPtr& Other) {
        Reset(Other.Object);
        return *this;
    }
    TStrongObjectPtr& operator=(TStrongObjectPtr&& Other) {
        if (this != &Other) {
            Reset();
            Object = Other.Object;
            Other.Object = nullptr;
        }
        return *this;
    }
    void Reset() { Reset(nullptr); }
    void Reset(T* NewObject) {
        T* const Old = Object;
        Set(NewObject);
        if (Old) {
            UE::CoreUObject::Private::ReleaseStrongReference((const UObject*)Old);
        }
    }
    T* Get() const { return Object; }
    T& operator*() const { return *Object; }
    T* operator->() const { return Object; }
    explicit operator bool() const { return Object != nullptr; }
    bool IsValid() const { return Object != nullptr; }
    template <typename U>
    bool operator==(const TStrongObjectPtr<U>& Other) const {
        return Object == Other.Get();
    }
    bool operator==(const T* Other) const { return Object == Other; }
    bool operator==(TYPE_OF_NULLPTR) const { return Object == nullptr; }
    friend uint32 GetTypeHash(const TStrongObjectPtr& Ptr) { return PointerHash(Ptr.Object); }

private:
    void Set(T* NewObject) {
        Object = NewObject;
        if (Object) {
            UE::CoreUObject::Private::AddStrongReference((const UObject*)Object);
        }
    }
    T* Object = nullptr;
};
