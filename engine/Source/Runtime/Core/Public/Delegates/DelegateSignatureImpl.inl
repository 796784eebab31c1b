// SPDX-License-Identifier: MIT
// TDelegate and TMulticastDelegate. Included by Delegates/Delegate.h.
#pragma once

template <typename DelegateSignature, typename UserPolicy = FDefaultDelegateUserPolicy>
class TDelegate;
template <typename DelegateSignature, typename UserPolicy = FDefaultDelegateUserPolicy>
class TMulticastDelegate;

/** A delegate with at most one binding. See Epic's "Delegates and Lambda Functions". */
template <typename Ret, typename... Params, typename UserPolicy>
class TDelegate<Ret(Params...), UserPolicy> {
    template <typename, typename>
    friend class TMulticastDelegate;
    using FInstance = UE::Core::Private::Delegates::TInstance<Ret, Params...>;
    using FInstanceRef = UE::Core::Private::Delegates::TInstanceRef<FInstance>;

    template <bool bPassObject, typename Guard, typename Callable, typename... VarTypes>
    static TDelegate Make(Guard InGuard, Callable&& InCallable, VarTypes&&... Vars) {
        using FBound = UE::Core::Private::Delegates::TBoundInstance<bPassObject, Guard, std::decay_t<Callable>,
                                                                    std::tuple<std::decay_t<VarTypes>...>, Ret, Params...>;
        TDelegate Result;
        Result.Instance = FInstanceRef(new FBound(MoveTemp(InGuard), Forward<Callable>(InCallable), Forward<VarTypes>(Vars)...));
        return Result;
    }
    template <typename UserClass, typename... VarTypes>
    using TMethod = Ret (std::type_identity_t<UserClass>::*)(Params..., std::decay_t<VarTypes>...);
    template <typename UserClass, typename... VarTypes>
    using TConstMethod = Ret (std::type_identity_t<UserClass>::*)(Params..., std::decay_t<VarTypes>...) const;

public:
    using RetValType = Ret;
    typedef Ret TFuncType(Params...);
    template <typename... VarTypes>
    using TFuncPtr = Ret (*)(Params..., std::decay_t<VarTypes>...);

    TDelegate() = default;
    TDelegate(TYPE_OF_NULLPTR) {}
    TDelegate(const TDelegate& Other) { *this = Other; }
    TDelegate(TDelegate&&) noexcept = default;
    TDelegate& operator=(TDelegate&&) noexcept = default;
    TDelegate& operator=(const TDelegate& Other) {
        if (this != &Other) {
            Instance = Other.Instance ? FInstanceRef(Other.Instance->CreateCopy()) : FInstanceRef();
        }
        return *this;
    }

    // ----- making; further arguments are passed to the function after the delegate's own

    template <typename... VarTypes>
    [[nodiscard]] static TDelegate CreateStatic(std::type_identity_t<TFuncPtr<VarTypes...>> InFunc, VarTypes&&... Vars) {
        return Make<false>(UE::Core::Private::Delegates::FNoObject{}, InFunc, Forward<VarTypes>(Vars)...);
    }
    template <typename FunctorType, typename... VarTypes>
    [[nodiscard]] static TDelegate CreateLambda(FunctorType&& InFunctor, VarTypes&&... Vars) {
        return Make<false>(UE::Core::Private::Delegates::FNoObject{}, Forward<FunctorType>(InFunctor), Forward<VarTypes>(Vars)...);
    }
    /** The caller must unbind before the object dies. */
    template <typename UserClass, typename... VarTypes>
    [[nodiscard]] static TDelegate CreateRaw(UserClass* InUserObject, TMethod<UserClass, VarTypes...> InFunc, VarTypes&&... Vars) {
        return Make<true>(UE::Core::Private::Delegates::TRawObject<UserClass>{InUserObject}, InFunc, Forward<VarTypes>(Vars)...);
    }
    template <typename UserClass, typename... VarTypes>
    [[nodiscard]] static TDelegate CreateRaw(const UserClass* InUserObject, TConstMethod<UserClass, VarTypes...> InFunc,
                                             VarTypes&&... Vars) {
        return Make<true>(UE::Core::Private::Delegates::TRawObject<const UserClass>{InUserObject}, InFunc, Forward<VarTypes>(Vars)...);
    }
    template <typename UserClass, ESPMode Mode, typename... VarTypes>
    [[nodiscard]] static TDelegate CreateSP(const TSharedRef<UserClass, Mode>& InUserObject, TMethod<UserClass, VarTypes...> InFunc,
                                            VarTypes&&... Vars) {
        return Make<true>(UE::Core::Private::Delegates::TSharedObject<UserClass, Mode>{InUserObject, &InUserObject.Get()}, InFunc,
                          Forward<VarTypes>(Vars)...);
    }
    template <typename UserClass, ESPMode Mode, typename... VarTypes>
    [[nodiscard]] static TDelegate CreateSP(const TSharedRef<UserClass, Mode>& InUserObject,
                                            TConstMethod<UserClass, VarTypes...> InFunc, VarTypes&&... Vars) {
        return Make<true>(UE::Core::Private::Delegates::TSharedObject<UserClass, Mode>{InUserObject, &InUserObject.Get()}, InFunc,
                          Forward<VarTypes>(Vars)...);
    }
    template <typename UserClass, typename... VarTypes>
    [[nodiscard]] static TDelegate CreateSP(UserClass* InUserObject, TMethod<UserClass, VarTypes...> InFunc, VarTypes&&... Vars) {
        return CreateSP(SharedOf(InUserObject), InFunc, Forward<VarTypes>(Vars)...);
    }
    template <typename UserClass, typename... VarTypes>
    [[nodiscard]] static TDelegate CreateSP(UserClass* InUserObject, TConstMethod<UserClass, VarTypes...> InFunc, VarTypes&&... Vars) {
        return CreateSP(SharedOf(InUserObject), InFunc, Forward<VarTypes>(Vars)...);
    }
    template <typename UserClass, typename FunctorType, typename... VarTypes>
    [[nodiscard]] static TDelegate CreateSPLambda(UserClass* InUserObject, FunctorType&& InFunctor, VarTypes&&... Vars) {
        auto Shared = SharedOf(InUserObject);
        return Make<false>(UE::Core::Private::Delegates::TSharedObject<UserClass, decltype(Shared)::Mode>{Shared, InUserObject},
                           Forward<FunctorType>(InFunctor), Forward<VarTypes>(Vars)...);
    }
    /** Called only while the UObject lives. */
    template <typename UserClass, typename... VarTypes>
    [[nodiscard]] static TDelegate CreateUObject(UserClass* InUserObject, TMethod<UserClass, VarTypes...> InFunc, VarTypes&&... Vars) {
        return Make<true>(UE::Core::Private::Delegates::TUObjectObject<UserClass>{InUserObject, InUserObject}, InFunc,
                          Forward<VarTypes>(Vars)...);
    }
    template <typename UserClass, typename... VarTypes>
    [[nodiscard]] static TDelegate CreateUObject(const UserClass* InUserObject, TConstMethod<UserClass, VarTypes...> InFunc,
                                                 VarTypes&&... Vars) {
        return Make<true>(
            UE::Core::Private::Delegates::TUObjectObject<UserClass>{const_cast<UserClass*>(InUserObject), InUserObject}, InFunc,
            Forward<VarTypes>(Vars)...);
    }
    template <typename UserClass, typename FunctorType, typename... VarTypes>
    [[nodiscard]] static TDelegate CreateWeakLambda(const UserClass* InUserObject, FunctorType&& InFunctor, VarTypes&&... Vars) {
        return Make<false>(
            UE::Core::Private::Delegates::TUObjectObject<UserClass>{const_cast<UserClass*>(InUserObject), InUserObject},
            Forward<FunctorType>(InFunctor), Forward<VarTypes>(Vars)...);
    }

    // ----- binding

#define UE_DELEGATE_BIND(Kind)                                                                                         \
    template <typename... ArgTypes>                                                                                    \
    void Bind##Kind(ArgTypes&&... Args) {                                                                              \
        *this = Create##Kind(Forward<ArgTypes>(Args)...);                                                              \
    }
    UE_DELEGATE_BIND(Lambda)
    UE_DELEGATE_BIND(SPLambda)
    UE_DELEGATE_BIND(WeakLambda)
#undef UE_DELEGATE_BIND
    template <typename... VarTypes>
    void BindStatic(std::type_identity_t<TFuncPtr<VarTypes...>> InFunc, VarTypes&&... Vars) {
        *this = CreateStatic(InFunc, Forward<VarTypes>(Vars)...);
    }
#define UE_DELEGATE_BIND_METHOD(Kind)                                                                                  \
    template <typename UserClass, typename... VarTypes>                                                                \
    void Bind##Kind(UserClass* InUserObject, TMethod<UserClass, VarTypes...> InFunc, VarTypes&&... Vars) {             \
        *this = Create##Kind(InUserObject, InFunc, Forward<VarTypes>(Vars)...);                                        \
    }                                                                                                                  \
    template <typename UserClass, typename... VarTypes>                                                                \
    void Bind##Kind(const UserClass* InUserObject, TConstMethod<UserClass, VarTypes...> InFunc, VarTypes&&... Vars) {  \
        *this = Create##Kind(InUserObject, InFunc, Forward<VarTypes>(Vars)...);                                        \
    }
    UE_DELEGATE_BIND_METHOD(Raw)
    UE_DELEGATE_BIND_METHOD(UObject)
#undef UE_DELEGATE_BIND_METHOD
    template <typename UserClass, typename... VarTypes>
    void BindSP(UserClass* InUserObject, TMethod<UserClass, VarTypes...> InFunc, VarTypes&&... Vars) {
        *this = CreateSP(InUserObject, InFunc, Forward<VarTypes>(Vars)...);
    }
    template <typename UserClass, ESPMode Mode, typename... VarTypes>
    void BindSP(const TSharedRef<UserClass, Mode>& InUserObject, TMethod<UserClass, VarTypes...> InFunc, VarTypes&&... Vars) {
        *this = CreateSP(InUserObject, InFunc, Forward<VarTypes>(Vars)...);
    }

    void Unbind() { Instance = FInstanceRef(); }
    /** Bound, and its object (if it has one) alive. */
    bool IsBound() const { return Instance && Instance->IsSafeToExecute(); }
    bool IsBoundToObject(const void* InUserObject) const { return Instance && Instance->HasSameObject(InUserObject); }
    FDelegateHandle GetHandle() const { return Instance ? Instance->Handle : FDelegateHandle(); }
    const UObject* GetUObject() const { return Instance ? Instance->GetUObject() : nullptr; }
    /** Must be bound. */
    Ret Execute(Params... Args) const {
        FInstanceRef KeepAlive(Instance);
        checkf(KeepAlive, TEXT("Execute called on an unbound delegate"));
        return KeepAlive->Execute(Forward<Params>(Args)...);
    }
    /** Calls it if it is bound; says whether it did. */
    bool ExecuteIfBound(Params... Args) const
        requires std::is_void_v<Ret>
    {
        FInstanceRef KeepAlive(Instance);
        if (KeepAlive && KeepAlive->IsSafeToExecute()) {
            KeepAlive->Execute(Forward<Params>(Args)...);
            return true;
        }
        return false;
    }

private:
    template <typename UserClass>
    static auto SharedOf(UserClass* InUserObject) {
        auto Shared = InUserObject->AsShared();
        return TSharedRef<UserClass, decltype(Shared)::Mode>(Shared, InUserObject);
    }
    FInstanceRef Instance;
};

/**
 * A delegate with any number of bindings. Broadcast goes from the last added to the first, as in UE, though no order is
 * promised. Bindings may be added and removed while it runs: removed ones are not called any more, added ones only next time.
 */
template <typename... Params, typename UserPolicy>
class TMulticastDelegate<void(Params...), UserPolicy> {
public:
    using FDelegate = TDelegate<void(Params...), UserPolicy>;

    TMulticastDelegate() = default;
    TMulticastDelegate(const TMulticastDelegate& Other) : InvocationList(Other.InvocationList) {}
    TMulticastDelegate(TMulticastDelegate&& Other) : InvocationList(MoveTemp(Other.InvocationList)) {}
    TMulticastDelegate& operator=(const TMulticastDelegate& Other) {
        if (this != &Other) {
            TArray<FDelegate> Copy(Other.InvocationList);
            Clear();
            for (FDelegate& Delegate : Copy) {
                InvocationList.Add(MoveTemp(Delegate));
            }
        }
        return *this;
    }

    FDelegateHandle Add(const FDelegate& InNewDelegate) { return Add(FDelegate(InNewDelegate)); }
    FDelegateHandle Add(FDelegate&& InNewDelegate) {
        if (!InNewDelegate.Instance) {
            return FDelegateHandle();
        }
        if (LockCount == 0) {
            Compact();
        }
        const FDelegateHandle Handle = InNewDelegate.GetHandle();
        InvocationList.Add(MoveTemp(InNewDelegate));
        return Handle;
    }
    template <typename... VarTypes>
    FDelegateHandle AddStatic(std::type_identity_t<typename FDelegate::template TFuncPtr<VarTypes...>> InFunc, VarTypes&&... Vars) {
        return Add(FDelegate::CreateStatic(InFunc, Forward<VarTypes>(Vars)...));
    }
    template <typename FunctorType, typename... VarTypes>
    FDelegateHandle AddLambda(FunctorType&& InFunctor, VarTypes&&... Vars) {
        return Add(FDelegate::CreateLambda(Forward<FunctorType>(InFunctor), Forward<VarTypes>(Vars)...));
    }
    template <typename UserClass, typename FunctorType, typename... VarTypes>
    FDelegateHandle AddWeakLambda(const UserClass* InUserObject, FunctorType&& InFunctor, VarTypes&&... Vars) {
        return Add(FDelegate::CreateWeakLambda(InUserObject, Forward<FunctorType>(InFunctor), Forward<VarTypes>(Vars)...));
    }
    template <typename UserClass, typename FunctorType, typename... VarTypes>
    FDelegateHandle AddSPLambda(UserClass* InUserObject, FunctorType&& InFunctor, VarTypes&&... Vars) {
        return Add(FDelegate::CreateSPLambda(InUserObject, Forward<FunctorType>(InFunctor), Forward<VarTypes>(Vars)...));
    }
#define UE_DELEGATE_ADD_METHOD(Kind)                                                                                   \
    template <typename UserClass, typename... VarTypes>                                                                \
    FDelegateHandle Add##Kind(UserClass* InUserObject,                                                                 \
                              void (std::type_identity_t<UserClass>::*InFunc)(Params..., std::decay_t<VarTypes>...),   \
                              VarTypes&&... Vars) {                                                                    \
        return Add(FDelegate::Create##Kind(InUserObject, InFunc, Forward<VarTypes>(Vars)...));                         \
    }                                                                                                                  \
    template <typename UserClass, typename... VarTypes>                                                                \
    FDelegateHandle Add##Kind(const UserClass* InUserObject,                                                           \
                              void (std::type_identity_t<UserClass>::*InFunc)(Params..., std::decay_t<VarTypes>...)    \
                                  const,                                                                               \
                              VarTypes&&... Vars) {                                                                    \
        return Add(FDelegate::Create##Kind(InUserObject, InFunc, Forward<VarTypes>(Vars)...));                         \
    }
    UE_DELEGATE_ADD_METHOD(Raw)
    UE_DELEGATE_ADD_METHOD(UObject)
#undef UE_DELEGATE_ADD_METHOD
    template <typename UserClass, typename... VarTypes>
    FDelegateHandle AddSP(UserClass* InUserObject,
                          void (std::type_identity_t<UserClass>::*InFunc)(Params..., std::decay_t<VarTypes>...),
                          VarTypes&&... Vars) {
        return Add(FDelegate::CreateSP(InUserObject, InFunc, Forward<VarTypes>(Vars)...));
    }
    template <typename UserClass, ESPMode Mode, typename... VarTypes>
    FDelegateHandle AddSP(const TSharedRef<UserClass, Mode>& InUserObject,
                          void (std::type_identity_t<UserClass>::*InFunc)(Params..., std::decay_t<VarTypes>...),
                          VarTypes&&... Vars) {
        return Add(FDelegate::CreateSP(InUserObject, InFunc, Forward<VarTypes>(Vars)...));
    }

    /** Removes one binding; false if there is none of that handle. */
    bool Remove(FDelegateHandle InHandle) {
        if (!InHandle.IsValid()) {
            return false;
        }
        for (FDelegate& Delegate : InvocationList) {
            if (Delegate.GetHandle() == InHandle) {
                Delegate.Unbind();
                CompactIfUnlocked();
                return true;
            }
        }
        return false;
    }
    /** Removes the bindings of an object; returns how many. Lambdas without an object are not found this way. */
    int32 RemoveAll(const void* InUserObject) {
        int32 NumRemoved = 0;
        for (FDelegate& Delegate : InvocationList) {
            if (Delegate.IsBoundToObject(InUserObject)) {
                Delegate.Unbind();
                ++NumRemoved;
            }
        }
        CompactIfUnlocked();
        return NumRemoved;
    }
    void Clear() {
        for (FDelegate& Delegate : InvocationList) {
            Delegate.Unbind();
        }
        CompactIfUnlocked();
    }
    /** Is any function bound whose object is alive? */
    bool IsBound() const {
        for (const FDelegate& Delegate : InvocationList) {
            if (Delegate.IsBound()) {
                return true;
            }
        }
        return false;
    }
    bool IsBoundToObject(const void* InUserObject) const {
        for (const FDelegate& Delegate : InvocationList) {
            if (Delegate.IsBoundToObject(InUserObject)) {
                return true;
            }
        }
        return false;
    }
    void Broadcast(Params... Args) const {
        ++LockCount;
        bool bNeedsCompaction = false;
        for (int32 Index = InvocationList.Num() - 1; Index >= 0; --Index) {
            // Held for the call, since the function may remove its own binding.
            const typename FDelegate::FInstanceRef Instance = InvocationList[Index].Instance;
            if (Instance && Instance->IsSafeToExecute()) {
                Instance->Execute(Args...);
            } else {
                bNeedsCompaction = true;
            }
        }
        --LockCount;
        if (bNeedsCompaction) {
            const_cast<TMulticastDelegate*>(this)->CompactIfUnlocked();
        }
    }

private:
    void CompactIfUnlocked() {
        if (LockCount == 0) {
            Compact();
        }
    }
    void Compact() {
        InvocationList.RemoveAll([](const FDelegate& Delegate) { return !Delegate.Instance || Delegate.Instance->IsCompactable(); });
    }

    TArray<FDelegate> InvocationList;
    mutable int32 LockCount = 0;
};
