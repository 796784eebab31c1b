// SPDX-License-Identifier: MIT
/** The reference counting below TSharedPtr, TSharedRef and TWeakPtr. */
#pragma once

#include <atomic>

#include "Templates/TypeCompatibleBytes.h"
#include "Templates/TypeHash.h"
#include "Templates/UnrealTemplate.h"

/** Whether reference counts are atomic. ThreadSafe is the default, as in UE 5. */
enum class ESPMode : uint8 { NotThreadSafe = 0, ThreadSafe = 1 };

template <class ObjectType, ESPMode Mode = ESPMode::ThreadSafe>
class TSharedPtr;
template <class ObjectType, ESPMode Mode = ESPMode::ThreadSafe>
class TSharedRef;
template <class ObjectType, ESPMode Mode = ESPMode::ThreadSafe>
class TWeakPtr;
template <class ObjectType, ESPMode Mode = ESPMode::ThreadSafe>
class TSharedFromThis;

namespace SharedPointerInternals {
struct FNullTag {};

/** Counts of one shared object. All weak references together with the strong ones hold one more weak count. */
template <ESPMode Mode>
class TReferenceControllerBase {
    using RefCountType = std::conditional_t<Mode == ESPMode::ThreadSafe, std::atomic<int32>, int32>;

public:
    TReferenceControllerBase() = default;
    UE_NONCOPYABLE(TReferenceControllerBase)
    virtual ~TReferenceControllerBase() = default;
    virtual void DestroyObject() = 0;

    int32 GetSharedReferenceCount() const {
        if constexpr (Mode == ESPMode::ThreadSafe) {
            return SharedReferenceCount.load(std::memory_order_relaxed);
        } else {
            return SharedReferenceCount;
        }
    }
    bool IsUnique() const { return GetSharedReferenceCount() == 1; }
    void AddSharedReference() {
        if constexpr (Mode == ESPMode::ThreadSafe) {
            SharedReferenceCount.fetch_add(1, std::memory_order_relaxed);
        } else {
            ++SharedReferenceCount;
        }
    }
    /** Takes a strong reference unless the object is gone: what pinning a weak pointer does. */
    bool ConditionallyAddSharedReference() {
        if constexpr (Mode == ESPMode::ThreadSafe) {
            int32 Count = SharedReferenceCount.load(std::memory_order_acquire);
            while (Count != 0) {
                if (SharedReferenceCount.compare_exchange_weak(Count, Count + 1, std::memory_order_acq_rel)) {
                    return true;
                }
            }
            return false;
        } else {
            if (SharedReferenceCount == 0) {
                return false;
            }
            ++SharedReferenceCount;
            return true;
        }
    }
    void ReleaseSharedReference() {
        if (Decrement(SharedReferenceCount)) {
            DestroyObject();
            ReleaseWeakReference();
        }
    }
    void AddWeakReference() {
        if constexpr (Mode == ESPMode::ThreadSafe) {
            WeakReferenceCount.fetch_add(1, std::memory_order_relaxed);
        } else {
            ++WeakReferenceCount;
        }
    }
    void ReleaseWeakReference() {
        if (Decrement(WeakReferenceCount)) {
            delete this;
        }
    }

private:
    static bool Decrement(RefCountType& Count) {
        if constexpr (Mode == ESPMode::ThreadSafe) {
            return Count.fetch_sub(1, std::memory_order_acq_rel) == 1;
        } else {
            return --Count == 0;
        }
    }

    RefCountType SharedReferenceCount{1};
    RefCountType WeakReferenceCount{1};
};

template <typename Type>
struct TDefaultDeleter {
    void operator()(Type* Object) const { delete Object; }
};

template <typename ObjectType, typename DeleterType, ESPMode Mode>
class TReferenceControllerWithDeleter : public TReferenceControllerBase<Mode> {
public:
    TReferenceControllerWithDeleter(ObjectType* InObject, DeleterType&& InDeleter)
        : Object(InObject), Deleter(MoveTempIfPossible(InDeleter)) {}
    void DestroyObject() override { Deleter(Object); }

private:
    ObjectType* Object;
    DeleterType Deleter;
};

/** Object and counts in one allocation: what MakeShared makes. */
template <typename ObjectType, ESPMode Mode>
class TIntrusiveReferenceController : public TReferenceControllerBase<Mode> {
public:
    template <typename... ArgTypes>
    explicit TIntrusiveReferenceController(ArgTypes&&... Args) {
        ::new (static_cast<void*>(Storage.Pad)) ObjectType(Forward<ArgTypes>(Args)...);
    }
    ObjectType* GetObjectPtr() { return Storage.GetTypedPtr(); }
    void DestroyObject() override { Storage.GetTypedPtr()->~ObjectType(); }

private:
    TTypeCompatibleBytes<ObjectType> Storage;
};

template <typename ObjectType, typename DeleterType>
struct TRawPtrProxyWithDeleter {
    ObjectType* Object;
    DeleterType Deleter;
};
template <typename ObjectType>
struct TRawPtrProxy {
    ObjectType* Object;
    TRawPtrProxy(TYPE_OF_NULLPTR) : Object(nullptr) {}
    explicit TRawPtrProxy(ObjectType* InObject) : Object(InObject) {}
};

/** A counted strong reference. */
template <ESPMode Mode>
class FSharedReferencer {
    template <ESPMode>
    friend class FWeakReferencer;

public:
    using TController = TReferenceControllerBase<Mode>;
    FSharedReferencer() : Controller(nullptr) {}
    explicit FSharedReferencer(TController* InController) : Controller(InController) {}
    FSharedReferencer(const FSharedReferencer& Other) : Controller(Other.Controller) {
        if (Controller) {
            Controller->AddSharedReference();
        }
    }
    FSharedReferencer(FSharedReferencer&& Other) noexcept : Controller(Other.Controller) { Other.Controller = nullptr; }
    ~FSharedReferencer() {
        if (Controller) {
            Controller->ReleaseSharedReference();
        }
    }
    FSharedReferencer& operator=(FSharedReferencer Other) noexcept {
        TController* Old = Controller;
        Controller = Other.Controller;
        Other.Controller = Old;
        return *this;
    }
    bool IsValid() const { return Controller != nullptr; }
    int32 GetSharedReferenceCount() const { return Controller ? Controller->GetSharedReferenceCount() : 0; }
    bool IsUnique() const { return Controller && Controller->IsUnique(); }

private:
    TController* Controller;
};

/** A counted weak reference. */
template <ESPMode Mode>
class FWeakReferencer {
public:
    using TController = TReferenceControllerBase<Mode>;
    FWeakReferencer() : Controller(nullptr) {}
    FWeakReferencer(const FWeakReferencer& Other) : Controller(Other.Controller) { AddRef(); }
    FWeakReferencer(const FSharedReferencer<Mode>& Other) : Controller(Other.Controller) { AddRef(); }
    FWeakReferencer(FWeakReferencer&& Other) noexcept : Controller(Other.Controller) { Other.Controller = nullptr; }
    ~FWeakReferencer() {
        if (Controller) {
            Controller->ReleaseWeakReference();
        }
    }
    FWeakReferencer& operator=(FWeakReferencer Other) noexcept {
        TController* Old = Controller;
        Controller = Other.Controller;
        Other.Controller = Old;
        return *this;
    }
    bool IsValid() const { return Controller && Controller->GetSharedReferenceCount() > 0; }
    /** A strong reference, or an invalid one if the object is gone. */
    FSharedReferencer<Mode> Pin() const {
        return Controller && Controller->ConditionallyAddSharedReference() ? FSharedReferencer<Mode>(Controller)
                                                                           : FSharedReferencer<Mode>();
    }

private:
    void AddRef() {
        if (Controller) {
            Controller->AddWeakReference();
        }
    }
    TController* Controller;
};

template <typename ObjectType, ESPMode Mode, typename Other>
void EnableSharedFromThis(const TSharedRef<ObjectType, Mode>* Ref, const TSharedFromThis<Other, Mode>* Shareable) {
    if (Shareable) {
        Shareable->UpdateWeakReferenceInternal(*Ref);
    }
}
inline void EnableSharedFromThis(...) {}
} // namespace SharedPointerInternals
