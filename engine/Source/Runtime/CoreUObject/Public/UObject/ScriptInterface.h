// SPDX-License-Identifier: MIT
// FScriptInterface and TScriptInterface: an object with the address of one of its interfaces. Mirrors
// "UObject/ScriptInterface.h".
#pragma once

#include "Templates/Casts.h"

/** Untyped pair of object and interface address; the value of an FInterfaceProperty. */
class FScriptInterface {
public:
    FScriptInterface(UObject* InObjectPointer = nullptr, void* InInterfacePointer = nullptr)
        : ObjectPointer(InObjectPointer), InterfacePointer(InInterfacePointer) {}
    UObject* GetObject() const { return ObjectPointer; }
    UObject*& GetObjectRef() { return reinterpret_cast<UObject*&>(ObjectPointer); }
    void* GetInterface() const { return ObjectPointer ? InterfacePointer : nullptr; }
    void SetObject(UObject* InObjectPointer) {
        ObjectPointer = InObjectPointer;
        if (!InObjectPointer) {
            InterfacePointer = nullptr;
        }
    }
    void SetInterface(void* InInterfacePointer) { InterfacePointer = InInterfacePointer; }
    bool operator==(const FScriptInterface& Other) const {
        return GetInterface() == Other.GetInterface() && ObjectPointer == Other.ObjectPointer;
    }
    bool operator==(const UObject* Other) const { return ObjectPointer.Get() == Other; }
    friend uint32 GetTypeHash(const FScriptInterface& Instance) {
        return HashCombine(PointerHash(Instance.InterfacePointer), PointerHash(Instance.ObjectPointer.Get()));
    }

private:
    TObjectPtr<UObject> ObjectPointer;
    void* InterfacePointer;
};

/** Typed form; what UPROPERTYs and parameters hold. */
template <typename InInterfaceType>
class TScriptInterface : public FScriptInterface {
public:
    using InterfaceType = InInterfaceType;

    TScriptInterface() = default;
    TScriptInterface(TYPE_OF_NULLPTR) {}
    TScriptInterface(const TScriptInterface&) = default;
    TScriptInterface& operator=(const TScriptInterface&) = default;
    /** From an object that may implement the interface, or from an interface pointer. */
    template <typename U>
        requires(std::is_convertible_v<U*, const UObject*> || std::is_convertible_v<U*, InInterfaceType*>)
    TScriptInterface(U* Source) {
        Assign(Source);
    }
    template <typename U>
        requires(std::is_convertible_v<U*, const UObject*>)
    TScriptInterface(const TObjectPtr<U>& Source) {
        Assign(Source.Get());
    }
    template <typename U>
    TScriptInterface& operator=(U* Source) {
        Assign(Source);
        return *this;
    }
    template <typename U>
    TScriptInterface& operator=(const TObjectPtr<U>& Source) {
        Assign(Source.Get());
        return *this;
    }
    TScriptInterface& operator=(TYPE_OF_NULLPTR) {
        SetObject(nullptr);
        return *this;
    }
    InInterfaceType* GetInterface() const { return static_cast<InInterfaceType*>(FScriptInterface::GetInterface()); }
    InInterfaceType* operator->() const { return GetInterface(); }
    InInterfaceType& operator*() const { return *GetInterface(); }
    explicit operator bool() const { return GetInterface() != nullptr; }
    void SetInterface(InInterfaceType* InInterfacePointer) { FScriptInterface::SetInterface(InInterfacePointer); }
    bool operator==(const TScriptInterface& Other) const { return FScriptInterface::operator==(Other); }
    bool operator==(const InInterfaceType* Other) const { return GetInterface() == Other; }
    bool operator==(TYPE_OF_NULLPTR) const { return GetInterface() == nullptr; }

private:
    template <typename U>
    void Assign(U* Source) {
        if constexpr (std::is_convertible_v<U*, const UObject*>) {
            UObject* Object = const_cast<UObject*>(static_cast<const UObject*>(Source));
            InInterfaceType* Interface = UE::CoreUObject::Private::CastObject<InInterfaceType>(Object);
            // An object that does not implement the interface is not held, as in UE.
            SetObject(Interface ? Object : nullptr);
            SetInterface(Interface);
        } else {
            SetObject(Source ? Source->_getUObject() : nullptr);
            SetInterface(Source);
        }
    }
};
