// SPDX-License-Identifier: MIT
/**
 * TSharedRef (never null), TSharedPtr, TWeakPtr, TSharedFromThis, MakeShared, MakeShareable.
 * See Epic's "Unreal Smart Pointer Library".
 */
#pragma once

#include "Templates/SharedPointerInternals.h"

#define UE_SHARED_CONVERTIBLE(From, To) requires std::is_convertible_v<From*, To*>

template <class ObjectType, ESPMode InMode>
class TSharedRef {
    template <class, ESPMode>
    friend class TSharedRef;
    template <class, ESPMode>
    friend class TSharedPtr;
    template <class, ESPMode>
    friend class TWeakPtr;
    template <class, ESPMode>
    friend class TSharedFromThis;

public:
    using ElementType = ObjectType;
    static constexpr ESPMode Mode = InMode;

    /** Takes ownership of an object made with new. */
    template <class OtherType>
    explicit TSharedRef(OtherType* InObject) UE_SHARED_CONVERTIBLE(OtherType, ObjectType)
        : Object(InObject), Referencer(new SharedPointerInternals::TReferenceControllerWithDeleter<OtherType,
                                SharedPointerInternals::TDefaultDeleter<OtherType>, Mode>(InObject, {})) {
        Init(InObject);
    }
    template <class OtherType, typename DeleterType>
    TSharedRef(OtherType* InObject, DeleterType&& InDeleter) UE_SHARED_CONVERTIBLE(OtherType, ObjectType)
        : Object(InObject), Referencer(MakeReferencer(InObject, Forward<DeleterType>(InDeleter))) {
        Init(InObject);
    }
    template <class OtherType>
    TSharedRef(const SharedPointerInternals::TRawPtrProxy<OtherType>& Proxy)
        UE_SHARED_CONVERTIBLE(OtherType, ObjectType)
        : TSharedRef(Proxy.Object) {}
    template <class OtherType, typename DeleterType>
    TSharedRef(const SharedPointerInternals::TRawPtrProxyWithDeleter<OtherType, DeleterType>& Proxy)
        UE_SHARED_CONVERTIBLE(OtherType, ObjectType)
        : TSharedRef(Proxy.Object, DeleterType(Proxy.Deleter)) {}
    TSharedRef(const TSharedRef&) = default;
    TSharedRef(TSharedRef&& Other) : Object(Other.Object), Referencer(Other.Referencer) {}
    template <class OtherType>
    TSharedRef(const TSharedRef<OtherType, Mode>& Other) UE_SHARED_CONVERTIBLE(OtherType, ObjectType)
        : Object(Other.Object), Referencer(Other.Referencer) {}
    /** Shares ownership with Other while pointing to another (part of the same) object. */
    template <class OtherType>
    TSharedRef(const TSharedRef<OtherType, Mode>& Other, ObjectType* InObject)
        : Object(InObject), Referencer(Other.Referencer) {
        check(InObject != nullptr);
    }
    TSharedRef& operator=(const TSharedRef&) = default;
    TSharedRef& operator=(TSharedRef&& Other) { return *this = static_cast<const TSharedRef&>(Other); }

    ObjectType& Get() const { return *Object; }
    ObjectType& operator*() const { return *Object; }
    ObjectType* operator->() const { return Object; }
    int32 GetSharedReferenceCount() const { return Referencer.GetSharedReferenceCount(); }
    bool IsUnique() const { return Referencer.IsUnique(); }
    TSharedPtr<ObjectType, Mode> ToSharedPtr() const { return TSharedPtr<ObjectType, Mode>(*this); }
    TWeakPtr<ObjectType, Mode> ToWeakPtr() const { return TWeakPtr<ObjectType, Mode>(*this); }

    template <class U>
    bool operator==(const TSharedRef<U, Mode>& Other) const {
        return static_cast<const void*>(Object) == static_cast<const void*>(Other.Object);
    }
    friend uint32 GetTypeHash(const TSharedRef& Ref) { return PointerHash(static_cast<const void*>(Ref.Object)); }

    /** For MakeShared: adopts a controller that already holds one strong reference. */
    static TSharedRef AdoptInternal(
        ObjectType* InObject, SharedPointerInternals::TReferenceControllerBase<InMode>* Controller) {
        TSharedRef Result(InObject, SharedPointerInternals::FSharedReferencer<InMode>(Controller),
            SharedPointerInternals::FNullTag());
        Result.Init(InObject);
        return Result;
    }

private:
    using FReferencer = SharedPointerInternals::FSharedReferencer<InMode>;
    TSharedRef(ObjectType* InObject, FReferencer InReferencer, SharedPointerInternals::FNullTag)
        : Object(InObject), Referencer(MoveTemp(InReferencer)) {}
    template <class OtherType, typename DeleterType>
    static FReferencer MakeReferencer(OtherType* InObject, DeleterType&& InDeleter) {
        using FDeleter = std::decay_t<DeleterType>;
        return FReferencer(new SharedPointerInternals::TReferenceControllerWithDeleter<OtherType, FDeleter, InMode>(
            InObject, FDeleter(Forward<DeleterType>(InDeleter))));
    }
    template <class OtherType>
    void Init(OtherType* InObject) {
        checkf(InObject != nullptr, TEXT("TSharedRef cannot be made from a null pointer"));
        using SharedPointerInternals::EnableSharedFromThis;
        EnableSharedFromThis(this, InObject);
    }

    ObjectType* Object;
    FReferencer Referencer;
};

template <class ObjectType, ESPMode InMode>
class TSharedPtr {
    template <class, ESPMode>
    friend class TSharedPtr;
    template <class, ESPMode>
    friend class TWeakPtr;

public:
    using ElementType = ObjectType;
    static constexpr ESPMode Mode = InMode;

    TSharedPtr(SharedPointerInternals::FNullTag* = nullptr) : Object(nullptr) {}
    template <class OtherType>
    explicit TSharedPtr(OtherType* InObject) UE_SHARED_CONVERTIBLE(OtherType, ObjectType) : Object(nullptr) {
        if (InObject) {
            *this = TSharedRef<OtherType, Mode>(InObject);
        }
    }
    template <class OtherType, typename DeleterType>
    TSharedPtr(OtherType* InObject, DeleterType&& InDeleter) UE_SHARED_CONVERTIBLE(OtherType, ObjectType)
        : Object(nullptr) {
        if (InObject) {
            *this = TSharedRef<OtherType, Mode>(InObject, Forward<DeleterType>(InDeleter));
        }
    }
    template <class OtherType>
    TSharedPtr(const SharedPointerInternals::TRawPtrProxy<OtherType>& Proxy)
        UE_SHARED_CONVERTIBLE(OtherType, ObjectType)
        : TSharedPtr(Proxy.Object) {}
    template <class OtherType, typename DeleterType>
    TSharedPtr(const SharedPointerInternals::TRawPtrProxyWithDeleter<OtherType, DeleterType>& Proxy)
        UE_SHARED_CONVERTIBLE(OtherType, ObjectType)
        : TSharedPtr(Proxy.Object, DeleterType(Proxy.Deleter)) {}
    TSharedPtr(const TSharedPtr&) = default;
    TSharedPtr(TSharedPtr&& Other) noexcept : Object(Other.Object), Referencer(MoveTemp(Other.Referencer)) {
        Other.Object = nullptr;
    }
    template <class OtherType>
    TSharedPtr(const TSharedPtr<OtherType, Mode>& Other) UE_SHARED_CONVERTIBLE(OtherType, ObjectType)
        : Object(Other.Object), Referencer(Other.Referencer) {}
    template <class OtherType>
    TSharedPtr(TSharedPtr<OtherType, Mode>&& Other) UE_SHARED_CONVERTIBLE(OtherType, ObjectType)
        : Object(Other.Object), Referencer(MoveTemp(Other.Referencer)) {
        Other.Object = nullptr;
    }
    template <class OtherType>
    TSharedPtr(const TSharedRef<OtherType, Mode>& Other) UE_SHARED_CONVERTIBLE(OtherType, ObjectType)
        : Object(Other.Object), Referencer(Other.Referencer) {}
    /** Shares ownership with Other while pointing to another (part of the same) object. */
    template <class OtherType>
    TSharedPtr(const TSharedPtr<OtherType, Mode>& Other, ObjectType* InObject)
        : Object(InObject), Referencer(Other.Referencer) {}
    TSharedPtr& operator=(const TSharedPtr&) = default;
    TSharedPtr& operator=(TSharedPtr&& Other) noexcept {
        if (this != &Other) {
            Object = Other.Object;
            Other.Object = nullptr;
            Referencer = MoveTemp(Other.Referencer);
        }
        return *this;
    }
    TSharedPtr& operator=(SharedPointerInternals::FNullTag*) {
        Reset();
        return *this;
    }

    /** The never-null reference; checks that there is an object. */
    TSharedRef<ObjectType, Mode> ToSharedRef() const {
        checkf(IsValid(), TEXT("ToSharedRef called on a null TSharedPtr"));
        return TSharedRef<ObjectType, Mode>(Object, Referencer, SharedPointerInternals::FNullTag());
    }
    TWeakPtr<ObjectType, Mode> ToWeakPtr() const { return TWeakPtr<ObjectType, Mode>(*this); }
    ObjectType* Get() const { return Object; }
    explicit operator bool() const { return Object != nullptr; }
    bool IsValid() const { return Object != nullptr; }
    template <typename T = ObjectType>
    T& operator*() const {
        check(IsValid());
        return *Object;
    }
    ObjectType* operator->() const {
        check(IsValid());
        return Object;
    }
    void Reset() { *this = TSharedPtr(); }
    int32 GetSharedReferenceCount() const { return Referencer.GetSharedReferenceCount(); }
    bool IsUnique() const { return Referencer.IsUnique(); }

    template <class U>
    bool operator==(const TSharedPtr<U, Mode>& Other) const {
        return static_cast<const void*>(Object) == static_cast<const void*>(Other.Get());
    }
    template <class U>
    bool operator==(const TSharedRef<U, Mode>& Other) const {
        return static_cast<const void*>(Object) == static_cast<const void*>(&Other.Get());
    }
    bool operator==(TYPE_OF_NULLPTR) const { return Object == nullptr; }
    friend uint32 GetTypeHash(const TSharedPtr& Ptr) { return PointerHash(static_cast<const void*>(Ptr.Object)); }

private:
    TSharedPtr(ObjectType* InObject, SharedPointerInternals::FSharedReferencer<InMode> InReferencer,
        SharedPointerInternals::FNullTag)
        : Object(InObject), Referencer(MoveTemp(InReferencer)) {}

    ObjectType* Object;
    SharedPointerInternals::FSharedReferencer<InMode> Referencer;
};

template <class ObjectType, ESPMode InMode>
class TWeakPtr {
    template <class, ESPMode>
    friend class TWeakPtr;

public:
    using ElementType = ObjectType;
    static constexpr ESPMode Mode = InMode;

    TWeakPtr(SharedPointerInternals::FNullTag* = nullptr) : Object(nullptr) {}
    template <class OtherType>
    TWeakPtr(const TSharedRef<OtherType, Mode>& Other) UE_SHARED_CONVERTIBLE(OtherType, ObjectType)
        : Object(Other.Object), Referencer(Other.Referencer) {}
    template <class OtherType>
    TWeakPtr(const TSharedPtr<OtherType, Mode>& Other) UE_SHARED_CONVERTIBLE(OtherType, ObjectType)
        : Object(Other.Object), Referencer(Other.Referencer) {}
    template <class OtherType>
    TWeakPtr(const TWeakPtr<OtherType, Mode>& Other) UE_SHARED_CONVERTIBLE(OtherType, ObjectType)
        : Object(Other.Object), Referencer(Other.Referencer) {}
    TWeakPtr(const TWeakPtr&) = default;
    TWeakPtr(TWeakPtr&&) = default;
    TWeakPtr& operator=(const TWeakPtr&) = default;
    TWeakPtr& operator=(TWeakPtr&&) = default;

    /** A strong pointer, null if the object is gone. */
    TSharedPtr<ObjectType, Mode> Pin() const {
        SharedPointerInternals::FSharedReferencer<Mode> Strong = Referencer.Pin();
        ObjectType* Found = Strong.IsValid() ? Object : nullptr;
        return TSharedPtr<ObjectType, Mode>(Found, MoveTemp(Strong), SharedPointerInternals::FNullTag());
    }
    bool IsValid() const { return Object != nullptr && Referencer.IsValid(); }
    void Reset() { *this = TWeakPtr(); }
    bool HasSameObject(const void* InOther) const { return Pin().Get() == InOther; }

    template <class U>
    bool operator==(const TWeakPtr<U, Mode>& Other) const {
        return Pin() == Other.Pin();
    }
    bool operator==(TYPE_OF_NULLPTR) const { return !IsValid(); }
    /** Hash of the address, which does not change when the object goes. */
    friend uint32 GetTypeHash(const TWeakPtr& Ptr) { return PointerHash(static_cast<const void*>(Ptr.Object)); }

private:
    ObjectType* Object;
    SharedPointerInternals::FWeakReferencer<InMode> Referencer;
};

/** Base of classes whose objects can make shared pointers to themselves. */
template <class ObjectType, ESPMode InMode>
class TSharedFromThis {
public:
    static constexpr ESPMode Mode = InMode;

    TSharedRef<ObjectType, Mode> AsShared() {
        TSharedPtr<ObjectType, Mode> Shared = WeakThis.Pin();
        checkf(Shared.IsValid(), TEXT("AsShared needs an object that is owned by a shared pointer"));
        return Shared.ToSharedRef();
    }
    TSharedRef<const ObjectType, Mode> AsShared() const {
        TSharedPtr<ObjectType, Mode> Shared = WeakThis.Pin();
        checkf(Shared.IsValid(), TEXT("AsShared needs an object that is owned by a shared pointer"));
        return Shared.ToSharedRef();
    }
    TWeakPtr<ObjectType, Mode> AsWeak() { return WeakThis; }
    TWeakPtr<const ObjectType, Mode> AsWeak() const { return WeakThis; }
    bool DoesSharedInstanceExist() const { return WeakThis.IsValid(); }

    template <class SharedType>
    void UpdateWeakReferenceInternal(const TSharedRef<SharedType, Mode>& Ref) const {
        if (!WeakThis.IsValid()) {
            using FMutable = std::remove_const_t<SharedType>;
            TSharedRef<FMutable, Mode> Mutable(TSharedRef<SharedType, Mode>(Ref), const_cast<FMutable*>(&Ref.Get()));
            WeakThis = TSharedRef<ObjectType, Mode>(Mutable, static_cast<ObjectType*>(&Mutable.Get()));
        }
    }

protected:
    /** Shared reference to a derived class's `this`. */
    template <class OtherType>
    static TSharedRef<OtherType, Mode> SharedThis(OtherType* ThisPtr) {
        return TSharedRef<OtherType, Mode>(ThisPtr->AsShared(), ThisPtr);
    }
    template <class OtherType>
    static TSharedRef<const OtherType, Mode> SharedThis(const OtherType* ThisPtr) {
        return TSharedRef<const OtherType, Mode>(ThisPtr->AsShared(), ThisPtr);
    }
    TSharedFromThis() = default;
    TSharedFromThis(const TSharedFromThis&) {}
    TSharedFromThis& operator=(const TSharedFromThis&) { return *this; }
    ~TSharedFromThis() = default;

private:
    mutable TWeakPtr<ObjectType, Mode> WeakThis;
};

/** Object and reference counts in one allocation. */
template <typename InObjectType, ESPMode InMode = ESPMode::ThreadSafe, typename... InArgTypes>
[[nodiscard]] TSharedRef<InObjectType, InMode> MakeShared(InArgTypes&&... Args) {
    auto* Controller =
        new SharedPointerInternals::TIntrusiveReferenceController<std::remove_const_t<InObjectType>, InMode>(
            Forward<InArgTypes>(Args)...);
    return TSharedRef<InObjectType, InMode>::AdoptInternal(Controller->GetObjectPtr(), Controller);
}
/** Wraps a raw pointer so that it converts to a shared one, whatever its mode. */
template <class ObjectType>
[[nodiscard]] SharedPointerInternals::TRawPtrProxy<ObjectType> MakeShareable(ObjectType* InObject) {
    return SharedPointerInternals::TRawPtrProxy<ObjectType>(InObject);
}
template <class ObjectType, class DeleterType>
[[nodiscard]] SharedPointerInternals::TRawPtrProxyWithDeleter<ObjectType, std::decay_t<DeleterType>> MakeShareable(
    ObjectType* InObject, DeleterType&& InDeleter) {
    return {InObject, Forward<DeleterType>(InDeleter)};
}

template <class CastToType, class CastFromType, ESPMode Mode>
TSharedRef<CastToType, Mode> StaticCastSharedRef(const TSharedRef<CastFromType, Mode>& Ref) {
    return TSharedRef<CastToType, Mode>(Ref, static_cast<CastToType*>(&Ref.Get()));
}
template <class CastToType, class CastFromType, ESPMode Mode>
TSharedPtr<CastToType, Mode> StaticCastSharedPtr(const TSharedPtr<CastFromType, Mode>& Ptr) {
    return TSharedPtr<CastToType, Mode>(Ptr, static_cast<CastToType*>(Ptr.Get()));
}
template <class CastToType, class CastFromType, ESPMode Mode>
TWeakPtr<CastToType, Mode> StaticCastWeakPtr(const TWeakPtr<CastFromType, Mode>& Ptr) {
    return StaticCastSharedPtr<CastToType>(Ptr.Pin());
}
template <class CastToType, class CastFromType, ESPMode Mode>
TSharedRef<CastToType, Mode> ConstCastSharedRef(const TSharedRef<CastFromType, Mode>& Ref) {
    return TSharedRef<CastToType, Mode>(Ref, const_cast<CastToType*>(&Ref.Get()));
}
template <class CastToType, class CastFromType, ESPMode Mode>
TSharedPtr<CastToType, Mode> ConstCastSharedPtr(const TSharedPtr<CastFromType, Mode>& Ptr) {
    return TSharedPtr<CastToType, Mode>(Ptr, const_cast<CastToType*>(Ptr.Get()));
}

template <class T, ESPMode M>
struct TIsTSharedPtr<TSharedPtr<T, M>> : UE::Core::Private::TBoolTrait<true> {};
template <class T, ESPMode M>
struct TIsTSharedRef<TSharedRef<T, M>> : UE::Core::Private::TBoolTrait<true> {};
template <class T, ESPMode M>
struct TIsWeakPointerType<TWeakPtr<T, M>> : UE::Core::Private::TBoolTrait<true> {};
