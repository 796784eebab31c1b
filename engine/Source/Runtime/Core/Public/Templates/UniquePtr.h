// SPDX-License-Identifier: MIT
/** TUniquePtr: sole ownership. */
#pragma once

#include "Templates/TypeHash.h"
#include "Templates/UnrealTemplate.h"

template <typename T>
struct TDefaultDelete {
    TDefaultDelete() = default;
    template <typename U>
        requires std::is_convertible_v<U*, T*>
    TDefaultDelete(const TDefaultDelete<U>&) {}
    void operator()(T* Ptr) const {
        static_assert(sizeof(T) > 0, "TUniquePtr cannot delete an incomplete type");
        delete Ptr;
    }
};
template <typename T>
struct TDefaultDelete<T[]> {
    template <typename U>
    void operator()(U* Ptr) const {
        delete[] Ptr;
    }
};

template <typename T, typename Deleter = TDefaultDelete<T>>
class TUniquePtr : private Deleter {
    template <typename OtherT, typename OtherDeleter>
    friend class TUniquePtr;

public:
    using ElementType = T;

    TUniquePtr() : Ptr(nullptr) {}
    TUniquePtr(TYPE_OF_NULLPTR) : Ptr(nullptr) {}
    template <typename U>
        requires std::is_convertible_v<U*, T*>
    explicit TUniquePtr(U* InPtr) : Ptr(InPtr) {}
    template <typename U>
        requires std::is_convertible_v<U*, T*>
    TUniquePtr(U* InPtr, const Deleter& InDeleter) : Deleter(InDeleter), Ptr(InPtr) {}
    TUniquePtr(TUniquePtr&& Other) : Deleter(MoveTemp(Other.GetDeleter())), Ptr(Other.Release()) {}
    template <typename OtherT, typename OtherDeleter>
        requires(std::is_convertible_v<OtherT*, T*> && !std::is_array_v<OtherT>)
    TUniquePtr(TUniquePtr<OtherT, OtherDeleter>&& Other)
        : Deleter(MoveTemp(Other.GetDeleter())), Ptr(Other.Release()) {}
    TUniquePtr(const TUniquePtr&) = delete;
    TUniquePtr& operator=(const TUniquePtr&) = delete;

    TUniquePtr& operator=(TUniquePtr&& Other) {
        if (this != &Other) {
            Reset(Other.Release());
            GetDeleter() = MoveTemp(Other.GetDeleter());
        }
        return *this;
    }
    template <typename OtherT, typename OtherDeleter>
        requires std::is_convertible_v<OtherT*, T*>
    TUniquePtr& operator=(TUniquePtr<OtherT, OtherDeleter>&& Other) {
        Reset(Other.Release());
        GetDeleter() = MoveTemp(Other.GetDeleter());
        return *this;
    }
    TUniquePtr& operator=(TYPE_OF_NULLPTR) {
        Reset();
        return *this;
    }
    ~TUniquePtr() {
        if (Ptr) {
            GetDeleter()(Ptr);
        }
    }

    bool IsValid() const { return Ptr != nullptr; }
    explicit operator bool() const { return IsValid(); }
    T* operator->() const { return Ptr; }
    T& operator*() const { return *Ptr; }
    T* Get() const { return Ptr; }
    /** Gives the object up without deleting it. */
    [[nodiscard]] T* Release() {
        T* Result = Ptr;
        Ptr = nullptr;
        return Result;
    }
    void Reset(T* InPtr = nullptr) {
        if (Ptr != InPtr) {
            T* Old = Ptr;
            Ptr = InPtr;
            if (Old) {
                GetDeleter()(Old);
            }
        }
    }
    Deleter& GetDeleter() { return static_cast<Deleter&>(*this); }
    const Deleter& GetDeleter() const { return static_cast<const Deleter&>(*this); }

    friend uint32 GetTypeHash(const TUniquePtr& Value) { return PointerHash(static_cast<const void*>(Value.Ptr)); }
    template <typename OtherT, typename OtherDeleter>
    bool operator==(const TUniquePtr<OtherT, OtherDeleter>& Other) const {
        return Ptr == Other.Ptr;
    }
    bool operator==(TYPE_OF_NULLPTR) const { return Ptr == nullptr; }

private:
    T* Ptr;
};

template <typename T, typename Deleter>
class TUniquePtr<T[], Deleter> : private Deleter {
public:
    using ElementType = T;

    TUniquePtr() : Ptr(nullptr) {}
    TUniquePtr(TYPE_OF_NULLPTR) : Ptr(nullptr) {}
    explicit TUniquePtr(T* InPtr) : Ptr(InPtr) {}
    TUniquePtr(TUniquePtr&& Other) : Ptr(Other.Release()) {}
    TUniquePtr(const TUniquePtr&) = delete;
    TUniquePtr& operator=(const TUniquePtr&) = delete;
    TUniquePtr& operator=(TUniquePtr&& Other) {
        if (this != &Other) {
            Reset(Other.Release());
        }
        return *this;
    }
    ~TUniquePtr() { Reset(); }

    bool IsValid() const { return Ptr != nullptr; }
    explicit operator bool() const { return IsValid(); }
    T& operator[](SIZE_T Index) const { return Ptr[Index]; }
    T* Get() const { return Ptr; }
    [[nodiscard]] T* Release() {
        T* Result = Ptr;
        Ptr = nullptr;
        return Result;
    }
    void Reset(T* InPtr = nullptr) {
        T* Old = Ptr;
        Ptr = InPtr;
        if (Old) {
            static_cast<Deleter&>(*this)(Old);
        }
    }

private:
    T* Ptr;
};

template <typename T, typename... TArgs>
    requires(!std::is_array_v<T>)
[[nodiscard]] TUniquePtr<T> MakeUnique(TArgs&&... Args) {
    return TUniquePtr<T>(new T(Forward<TArgs>(Args)...));
}
template <typename T>
    requires std::is_unbounded_array_v<T>
[[nodiscard]] TUniquePtr<T> MakeUnique(SIZE_T Size) {
    return TUniquePtr<T>(new std::remove_extent_t<T>[Size]());
}
