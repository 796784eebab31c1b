// SPDX-License-Identifier: MIT
/** What a delegate holds: a callable, the object it belongs to (held strongly, weakly or not at all) and bound
 * arguments. */
#pragma once

#include <atomic>
#include <tuple>

#include "Delegates/IDelegateInstance.h"
#include "Templates/Function.h"
#include "Templates/SharedPointer.h"
#include "UObject/WeakObjectPtrTemplatesFwd.h"

class UObject;

namespace UE::Core::Private::Delegates {
/** Base of all bindings. Counted, so that one can be removed while it runs. */
template <typename Ret, typename... Params>
class TInstance {
public:
    TInstance() : Handle(FDelegateHandle::GenerateNewHandle) {}
    virtual ~TInstance() = default;
    virtual Ret Execute(Params... Args) const = 0;
    /** May it be called now (is its object alive)? */
    virtual bool IsSafeToExecute() const = 0;
    /** Can it be dropped, because its object will never come back? */
    virtual bool IsCompactable() const { return !IsSafeToExecute(); }
    virtual bool HasSameObject(const void* Object) const = 0;
    virtual const UObject* GetUObject() const { return nullptr; }
    virtual TInstance* CreateCopy() const = 0;

    void AddRef() const { RefCount.fetch_add(1, std::memory_order_relaxed); }
    void Release() const {
        if (RefCount.fetch_sub(1, std::memory_order_acq_rel) == 1) {
            delete this;
        }
    }
    FDelegateHandle Handle;

protected:
    TInstance(const TInstance& Other) : Handle(Other.Handle) {}

private:
    mutable std::atomic<int32> RefCount{1};
};

struct FNoObject {
    struct FPin {
        explicit operator bool() const { return true; }
    };
    FPin Pin() const { return {}; }
    bool IsSafe() const { return true; }
    const void* Raw() const { return nullptr; }
    const UObject* UObjectPtr() const { return nullptr; }
};
template <typename UserClass>
struct TRawObject {
    UserClass* Object;
    UserClass* Pin() const { return Object; }
    bool IsSafe() const { return true; }
    const void* Raw() const { return Object; }
    const UObject* UObjectPtr() const { return nullptr; }
};
template <typename UserClass, ESPMode Mode>
struct TSharedObject {
    TWeakPtr<UserClass, Mode> Object;
    const void* Address;
    TSharedPtr<UserClass, Mode> Pin() const { return Object.Pin(); }
    bool IsSafe() const { return Object.IsValid(); }
    const void* Raw() const { return Address; }
    const UObject* UObjectPtr() const { return nullptr; }
};
/** Resolved only where it is instantiated, which needs the CoreUObject module's headers. */
template <typename UserClass>
struct TUObjectObject {
    using FWeak = TWeakObjectPtr<std::remove_const_t<UserClass>, FWeakObjectPtr>;
    FWeak Object;
    const void* Address;
    UserClass* Pin() const { return Object.Get(); }
    bool IsSafe() const { return Object.Get() != nullptr; }
    const void* Raw() const { return Address; }
    const UObject* UObjectPtr() const { return Object.Get(); }
};

/** bPassObject: the callable is a member function of the object; otherwise the object only guards it. */
template <bool bPassObject, typename Guard, typename Callable, typename PayloadTuple, typename Ret, typename... Params>
class TBoundInstance final : public TInstance<Ret, Params...> {
    using Base = TInstance<Ret, Params...>;

public:
    template <typename... PayloadArgs>
    TBoundInstance(Guard InGuard, Callable InCallable, PayloadArgs&&... InPayload)
        : Object(MoveTemp(InGuard)), Function(MoveTemp(InCallable)), Payload(Forward<PayloadArgs>(InPayload)...) {}
    TBoundInstance(const TBoundInstance&) = default;

    Ret Execute(Params... Args) const override {
        auto Pinned = Object.Pin();
        check(Pinned);
        return std::apply(
            [&](const auto&... Bound) -> Ret {
                if constexpr (bPassObject) {
                    return ((*Pinned).*Function)(Forward<Params>(Args)..., Bound...);
                } else if constexpr (std::is_void_v<Ret>) {
                    ::Invoke(const_cast<Callable&>(Function), Forward<Params>(Args)..., Bound...);
                } else {
                    return ::Invoke(const_cast<Callable&>(Function), Forward<Params>(Args)..., Bound...);
                }
            },
            Payload);
    }
    bool IsSafeToExecute() const override { return Object.IsSafe(); }
    bool HasSameObject(const void* Other) const override { return Other != nullptr && Object.Raw() == Other; }
    const UObject* GetUObject() const override { return Object.UObjectPtr(); }
    Base* CreateCopy() const override { return new TBoundInstance(*this); }

private:
    Guard Object;
    Callable Function;
    PayloadTuple Payload;
};

/** A counted reference to a binding. */
template <typename InstanceType>
class TInstanceRef {
public:
    TInstanceRef() = default;
    explicit TInstanceRef(const InstanceType* InInstance) : Instance(InInstance) {}
    TInstanceRef(const TInstanceRef& Other) : Instance(Other.Instance) {
        if (Instance) {
            Instance->AddRef();
        }
    }
    TInstanceRef(TInstanceRef&& Other) noexcept : Instance(Other.Instance) { Other.Instance = nullptr; }
    TInstanceRef& operator=(TInstanceRef Other) noexcept {
        const InstanceType* Old = Instance;
        Instance = Other.Instance;
        Other.Instance = Old;
        return *this;
    }
    ~TInstanceRef() {
        if (Instance) {
            Instance->Release();
        }
    }
    const InstanceType* Get() const { return Instance; }
    const InstanceType* operator->() const { return Instance; }
    explicit operator bool() const { return Instance != nullptr; }

private:
    const InstanceType* Instance = nullptr;
};
} // namespace UE::Core::Private::Delegates
