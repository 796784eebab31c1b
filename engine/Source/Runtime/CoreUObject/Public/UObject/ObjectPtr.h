// SPDX-License-Identifier: MIT
// TObjectPtr: the pointer type of reflected object members. Mirrors Epic's "UObject/ObjectPtr.h".
#pragma once

#include "CoreMinimal.h"

class UClass;
class UObject;

/**
 * A pointer to an object, for UPROPERTY members. Same size and bits as a raw pointer, so that properties see both
 * alike. T may be incomplete until the object is used.
 */
template <typename T>
struct TObjectPtr {
    using ElementType = T;

    TObjectPtr() = default;
    TObjectPtr(TYPE_OF_NULLPTR) : Pointer(nullptr) {}
    explicit TObjectPtr(ENoInit) {}
    TObjectPtr(const TObjectPtr&) = default;
    TObjectPtr& operator=(const TObjectPtr&) = default;
    template <typename U>
        requires std::is_convertible_v<U*, T*>
    TObjectPtr(U* Object) : Pointer(Object) {}
    template <typename U>
        requires(!std::is_same_v<U, T> && std::is_convertible_v<U*, T*>)
    TObjectPtr(const TObjectPtr<U>& Other) : Pointer(Other.Get()) {}
    TObjectPtr& operator=(TYPE_OF_NULLPTR) {
        Pointer = nullptr;
        return *this;
    }
    template <typename U>
        requires std::is_convertible_v<U*, T*>
    TObjectPtr& operator=(U* Object) {
        Pointer = Object;
        return *this;
    }

    FORCEINLINE T* Get() const { return Pointer; }
    FORCEINLINE operator T*() const { return Pointer; }
    /** Explicit conversion, for static_cast to other object types. */
    template <typename U>
        requires(!std::is_same_v<U, T> && std::is_base_of_v<T, U>)
    explicit operator U*() const {
        return static_cast<U*>(Pointer);
    }
    explicit operator UPTRINT() const { return reinterpret_cast<UPTRINT>(Pointer); }
    explicit operator bool() const { return Pointer != nullptr; }
    FORCEINLINE T* operator->() const { return Pointer; }
    FORCEINLINE T& operator*() const { return *Pointer; }
    bool IsNull() const { return Pointer == nullptr; }
    /** Objects are always in memory here. */
    bool IsResolved() const { return true; }

private:
    T* Pointer = nullptr;
};
static_assert(sizeof(TObjectPtr<UObject>) == sizeof(void*));

/** The untyped form. */
using FObjectPtr = TObjectPtr<UObject>;

template <typename T, typename U>
    requires requires(T* A, U* B) { A == B; }
bool operator==(const TObjectPtr<T>& A, const TObjectPtr<U>& B) {
    return A.Get() == B.Get();
}
template <typename T, typename U>
    requires requires(T* A, U* B) { A == B; }
bool operator==(const TObjectPtr<T>& A, U* B) {
    return A.Get() == B;
}
template <typename T>
bool operator==(const TObjectPtr<T>& A, TYPE_OF_NULLPTR) {
    return A.Get() == nullptr;
}
template <typename T>
uint32 GetTypeHash(const TObjectPtr<T>& Object) {
    return PointerHash(Object.Get());
}

template <typename T>
struct TIsTObjectPtr {
    static constexpr bool Value = false;
};
template <typename T>
struct TIsTObjectPtr<TObjectPtr<T>> {
    static constexpr bool Value = true;
};
template <typename T>
struct TIsTObjectPtr<const TObjectPtr<T>> {
    static constexpr bool Value = true;
};
template <typename T>
inline constexpr bool TIsTObjectPtr_V = TIsTObjectPtr<T>::Value;

/** The raw pointer of either form. */
template <typename T>
T* ToRawPtr(const TObjectPtr<T>& Ptr) {
    return Ptr.Get();
}
template <typename T>
T* ToRawPtr(T* Ptr) {
    return Ptr;
}
/** An array of TObjectPtr seen as one of raw pointers. */
template <typename T, typename Allocator>
const TArray<T*, Allocator>& ObjectPtrDecay(const TArray<TObjectPtr<T>, Allocator>& Array) {
    return reinterpret_cast<const TArray<T*, Allocator>&>(Array);
}
template <typename T>
T* ObjectPtrDecay(const TObjectPtr<T>& Ptr) {
    return Ptr.Get();
}
template <typename T, typename Allocator>
TArray<TObjectPtr<T>, Allocator>& ObjectPtrWrap(TArray<T*, Allocator>& Array) {
    return reinterpret_cast<TArray<TObjectPtr<T>, Allocator>&>(Array);
}
template <typename T>
TObjectPtr<T>& ObjectPtrWrap(T*& Object) {
    return reinterpret_cast<TObjectPtr<T>&>(Object);
}
template <typename T, typename Allocator>
TArray<T*, Allocator>& MutableView(TArray<TObjectPtr<T>, Allocator>& Array) {
    return reinterpret_cast<TArray<T*, Allocator>&>(Array);
}
