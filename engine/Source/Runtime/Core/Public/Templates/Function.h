// SPDX-License-Identifier: MIT
/**
 * TFunctionRef (borrows), TFunction (owns, copyable), TUniqueFunction (owns, movable only).
 * Calling an unset function is a failed check. As in UE, `operator()` is const for all three.
 */
#pragma once

#include "Templates/Invoke.h"
#include "Templates/TypeHash.h"
#include "Templates/UnrealTemplate.h"

template <typename FuncType>
class TFunctionRef;
template <typename FuncType>
class TFunction;
template <typename FuncType>
class TUniqueFunction;

namespace UE::Core::Private {
template <typename T>
struct TIsUEFunction : TBoolTrait<false> {};
template <typename F>
struct TIsUEFunction<TFunction<F>> : TBoolTrait<true> {};
template <typename F>
struct TIsUEFunction<TUniqueFunction<F>> : TBoolTrait<true> {};
template <typename F>
struct TIsUEFunction<TFunctionRef<F>> : TBoolTrait<true> {};

/** Can the callable be "null" (function pointers, member pointers, other function objects)? Then null means unset. */
template <typename T>
bool IsBoundCallable(const T& Callable) {
    if constexpr (std::is_pointer_v<T> || std::is_member_pointer_v<T>) {
        return Callable != nullptr;
    } else if constexpr (TIsUEFunction<T>::Value) {
        return static_cast<bool>(Callable);
    } else {
        return true;
    }
}

template <typename Ret, typename... Params>
struct TFunctionOps {
    Ret (*Call)(void* Object, Params&&... Args);
    void (*Move)(void* Dest, void* Src); // constructs Dest and destroys Src
    void (*Copy)(void* Dest, const void* Src);
    void (*Destroy)(void* Object);
};

/** Storage shared by TFunction and TUniqueFunction: callables up to 32 bytes live inline, others on the heap. */
template <bool bUnique, typename Ret, typename... Params>
class TFunctionStorage {
    static constexpr SIZE_T InlineSize = 32;
    using FOps = TFunctionOps<Ret, Params...>;

    template <typename F>
    static constexpr bool bInline = sizeof(F) <= InlineSize && alignof(F) <= 16;

    template <typename F>
    static F& Resolve(void* Storage) {
        if constexpr (bInline<F>) {
            return *static_cast<F*>(Storage);
        } else {
            return **static_cast<F**>(Storage);
        }
    }
    template <typename F>
    static Ret CallImpl(void* Storage, Params&&... Args) {
        if constexpr (std::is_void_v<Ret>) {
            ::Invoke(Resolve<F>(Storage), static_cast<Params&&>(Args)...);
        } else {
            return ::Invoke(Resolve<F>(Storage), static_cast<Params&&>(Args)...);
        }
    }
    template <typename F>
    static void MoveImpl(void* Dest, void* Src) {
        if constexpr (bInline<F>) {
            F& Source = *static_cast<F*>(Src);
            ::new (Dest) F(static_cast<F&&>(Source));
            Source.~F();
        } else {
            *static_cast<F**>(Dest) = *static_cast<F**>(Src);
        }
    }
    template <typename F>
    static void CopyImpl(void* Dest, const void* Src) {
        if constexpr (bInline<F>) {
            ::new (Dest) F(*static_cast<const F*>(Src));
        } else {
            *static_cast<F**>(Dest) = new F(**static_cast<F* const*>(Src));
        }
    }
    template <typename F>
    static void DestroyImpl(void* Storage) {
        if constexpr (bInline<F>) {
            static_cast<F*>(Storage)->~F();
        } else {
            delete *static_cast<F**>(Storage);
        }
    }
    template <typename F>
    static const FOps* GetOps() {
        if constexpr (bUnique) {
            static constexpr FOps Ops = {&CallImpl<F>, &MoveImpl<F>, nullptr, &DestroyImpl<F>};
            return &Ops;
        } else {
            static constexpr FOps Ops = {&CallImpl<F>, &MoveImpl<F>, &CopyImpl<F>, &DestroyImpl<F>};
            return &Ops;
        }
    }

public:
    TFunctionStorage() = default;
    TFunctionStorage(TFunctionStorage&& Other) noexcept { MoveFrom(Other); }
    TFunctionStorage(const TFunctionStorage& Other)
        requires(!bUnique)
    {
        CopyFrom(Other);
    }
    TFunctionStorage& operator=(TFunctionStorage&& Other) noexcept {
        if (this != &Other) {
            Unset();
            MoveFrom(Other);
        }
        return *this;
    }
    TFunctionStorage& operator=(const TFunctionStorage& Other)
        requires(!bUnique)
    {
        if (this != &Other) {
            Unset();
            CopyFrom(Other);
        }
        return *this;
    }
    ~TFunctionStorage() { Unset(); }

    template <typename FuncType>
    void Bind(FuncType&& Func) {
        using F = std::decay_t<FuncType>;
        if (!IsBoundCallable<F>(Func)) {
            return;
        }
        if constexpr (bInline<F>) {
            ::new (static_cast<void*>(Bytes)) F(static_cast<FuncType&&>(Func));
        } else {
            *reinterpret_cast<F**>(Bytes) = new F(static_cast<FuncType&&>(Func));
        }
        Operations = GetOps<F>();
    }
    void Unset() {
        if (Operations) {
            const FOps* Old = Operations;
            Operations = nullptr;
            Old->Destroy(Bytes);
        }
    }
    bool IsSet() const { return Operations != nullptr; }
    Ret Call(Params&&... Args) const {
        checkf(Operations != nullptr, TEXT("Attempting to call an unbound TFunction!"));
        return Operations->Call(const_cast<uint8*>(Bytes), static_cast<Params&&>(Args)...);
    }

private:
    void MoveFrom(TFunctionStorage& Other) {
        Operations = Other.Operations;
        if (Operations) {
            Operations->Move(Bytes, Other.Bytes);
            Other.Operations = nullptr;
        }
    }
    void CopyFrom(const TFunctionStorage& Other) {
        if (Other.Operations) {
            Other.Operations->Copy(Bytes, Other.Bytes);
            Operations = Other.Operations;
        }
    }
    alignas(16) uint8 Bytes[InlineSize];
    const FOps* Operations = nullptr;
};

template <typename F, typename Ret, typename... Params>
concept CCallableAs = std::is_invocable_r_v<Ret, std::decay_t<F>&, Params...>;
} // namespace UE::Core::Private

/** Borrowed callable, for parameters: valid only while the callable it was made of lives. */
template <typename Ret, typename... Params>
class TFunctionRef<Ret(Params...)> {
public:
    template <typename FuncType>
        requires(!std::is_same_v<std::remove_cvref_t<FuncType>, TFunctionRef> &&
                 std::is_invocable_r_v<Ret, FuncType&, Params...>)
    TFunctionRef(FuncType&& InFunc) {
        using F = std::remove_reference_t<FuncType>;
        if constexpr (std::is_function_v<F>) {
            Ptr = reinterpret_cast<void*>(&InFunc);
            Callable = [](void* Object, Params&&... Args) -> Ret {
                return reinterpret_cast<F*>(Object)(static_cast<Params&&>(Args)...);
            };
        } else {
            checkf(UE::Core::Private::IsBoundCallable(InFunc),
                TEXT("Cannot bind a null/unbound callable to a TFunctionRef"));
            Ptr = const_cast<void*>(static_cast<const void*>(std::addressof(InFunc)));
            Callable = [](void* Object, Params&&... Args) -> Ret {
                if constexpr (std::is_void_v<Ret>) {
                    ::Invoke(*static_cast<F*>(Object), static_cast<Params&&>(Args)...);
                } else {
                    return ::Invoke(*static_cast<F*>(Object), static_cast<Params&&>(Args)...);
                }
            };
        }
    }
    TFunctionRef(const TFunctionRef&) = default;
    TFunctionRef& operator=(const TFunctionRef&) = delete;
    Ret operator()(Params... Args) const { return Callable(Ptr, static_cast<Params&&>(Args)...); }

private:
    Ret (*Callable)(void*, Params&&...);
    void* Ptr;
};

template <typename Ret, typename... Params>
class TFunction<Ret(Params...)> {
public:
    TFunction(TYPE_OF_NULLPTR = nullptr) {}
    template <typename FuncType>
        requires(!std::is_same_v<std::remove_cvref_t<FuncType>, TFunction> &&
                 UE::Core::Private::CCallableAs<FuncType, Ret, Params...>)
    TFunction(FuncType&& InFunc) {
        Storage.Bind(static_cast<FuncType&&>(InFunc));
    }
    TFunction(const TFunction&) = default;
    TFunction(TFunction&&) = default;
    TFunction& operator=(const TFunction&) = default;
    TFunction& operator=(TFunction&&) = default;
    TFunction& operator=(TYPE_OF_NULLPTR) {
        Storage.Unset();
        return *this;
    }
    void Reset() { Storage.Unset(); }
    bool IsSet() const { return Storage.IsSet(); }
    explicit operator bool() const { return IsSet(); }
    bool operator==(TYPE_OF_NULLPTR) const { return !IsSet(); }
    Ret operator()(Params... Args) const { return Storage.Call(static_cast<Params&&>(Args)...); }

private:
    UE::Core::Private::TFunctionStorage<false, Ret, Params...> Storage;
};

template <typename Ret, typename... Params>
class TUniqueFunction<Ret(Params...)> {
public:
    TUniqueFunction(TYPE_OF_NULLPTR = nullptr) {}
    template <typename FuncType>
        requires(!std::is_same_v<std::remove_cvref_t<FuncType>, TUniqueFunction> &&
                 UE::Core::Private::CCallableAs<FuncType, Ret, Params...>)
    TUniqueFunction(FuncType&& InFunc) {
        Storage.Bind(static_cast<FuncType&&>(InFunc));
    }
    TUniqueFunction(TUniqueFunction&&) = default;
    TUniqueFunction& operator=(TUniqueFunction&&) = default;
    TUniqueFunction(const TUniqueFunction&) = delete;
    TUniqueFunction& operator=(const TUniqueFunction&) = delete;
    TUniqueFunction& operator=(TYPE_OF_NULLPTR) {
        Storage.Unset();
        return *this;
    }
    void Reset() { Storage.Unset(); }
    bool IsSet() const { return Storage.IsSet(); }
    explicit operator bool() const { return IsSet(); }
    bool operator==(TYPE_OF_NULLPTR) const { return !IsSet(); }
    Ret operator()(Params... Args) const { return Storage.Call(static_cast<Params&&>(Args)...); }

private:
    UE::Core::Private::TFunctionStorage<true, Ret, Params...> Storage;
};
