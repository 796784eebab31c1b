// SPDX-License-Identifier: MIT
// Delegate properties. Part of "UObject/UnrealType.h".
#pragma once

#include "UObject/PropertyContainers.h"
#include "UObject/ScriptDelegates.h"
#include "UObject/SparseDelegate.h"

/** A dynamic delegate. */
class FDelegateProperty : public TProperty_WithEquality<FScriptDelegate, FProperty> {
    typedef TProperty_WithEquality<FScriptDelegate, FProperty> FBase;
    DECLARE_FIELD(FDelegateProperty, FBase, CASTCLASS_FDelegateProperty)

    /** Describes parameters and return value. */
    TObjectPtr<UFunction> SignatureFunction;

    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;
    virtual bool SameType(const FProperty* Other) const override {
        return Super::SameType(Other) &&
               SignatureFunction == static_cast<const FDelegateProperty*>(Other)->SignatureFunction;
    }
    virtual bool ContainsObjectReference(TArray<const FStructProperty*>& EncounteredStructProps,
        EPropertyObjectReferenceType InReferenceType) const override {
        return EnumHasAnyFlags(InReferenceType, EPropertyObjectReferenceType::Weak);
    }

protected:
    virtual void LinkInternal() override {
        FBase::LinkInternal();
        PropertyFlags |= CPF_HasGetValueTypeHash;
    }
    virtual uint32 GetValueTypeHashInternal(const void* Src) const override {
        return GetTypeHash(GetPropertyValue(Src));
    }
    UE_DECLARE_PROPERTY_TEXT
};

/** Base of both kinds of multicast delegate property. */
class FMulticastDelegateProperty : public FProperty {
    DECLARE_FIELD(FMulticastDelegateProperty, FProperty, CASTCLASS_FMulticastDelegateProperty)

    TObjectPtr<UFunction> SignatureFunction;

    /** The list behind a value; null for a sparse delegate with nothing bound. */
    virtual const FMulticastScriptDelegate* GetMulticastDelegate(const void* PropertyValue) const = 0;
    /** Replaces the list. */
    virtual void SetMulticastDelegate(void* PropertyValue, FMulticastScriptDelegate ScriptDelegate) const = 0;
    /** Adds a delegate; either PropertyValue or Parent (whose member the property is) says where. */
    virtual void AddDelegate(
        FScriptDelegate ScriptDelegate, UObject* Parent = nullptr, void* PropertyValue = nullptr) const = 0;
    virtual void RemoveDelegate(
        const FScriptDelegate& ScriptDelegate, UObject* Parent = nullptr, void* PropertyValue = nullptr) const = 0;
    virtual void ClearDelegate(UObject* Parent = nullptr, void* PropertyValue = nullptr) const = 0;

    virtual bool SameType(const FProperty* Other) const override {
        return Super::SameType(Other) &&
               SignatureFunction == static_cast<const FMulticastDelegateProperty*>(Other)->SignatureFunction;
    }
    virtual bool ContainsObjectReference(TArray<const FStructProperty*>& EncounteredStructProps,
        EPropertyObjectReferenceType InReferenceType) const override {
        return EnumHasAnyFlags(InReferenceType, EPropertyObjectReferenceType::Weak);
    }
    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;
    virtual bool Identical(const void* A, const void* B, uint32 PortFlags) const override;

protected:
    UE_DECLARE_PROPERTY_TEXT
    void* ResolveValue(UObject* Parent, void* PropertyValue) const {
        return PropertyValue ? PropertyValue : ContainerPtrToValuePtr<void>(Parent);
    }
};

/** A multicast delegate stored in place. */
class FMulticastInlineDelegateProperty : public FMulticastDelegateProperty {
    DECLARE_FIELD(
        FMulticastInlineDelegateProperty, FMulticastDelegateProperty, CASTCLASS_FMulticastInlineDelegateProperty)

    typedef FMulticastScriptDelegate TCppType;

    virtual int32 GetMinAlignment() const override { return alignof(FMulticastScriptDelegate); }
    virtual const FMulticastScriptDelegate* GetMulticastDelegate(const void* PropertyValue) const override {
        return static_cast<const FMulticastScriptDelegate*>(PropertyValue);
    }
    COREUOBJECT_API virtual void SetMulticastDelegate(
        void* PropertyValue, FMulticastScriptDelegate ScriptDelegate) const override;
    COREUOBJECT_API virtual void AddDelegate(
        FScriptDelegate ScriptDelegate, UObject* Parent, void* PropertyValue) const override;
    COREUOBJECT_API virtual void RemoveDelegate(
        const FScriptDelegate& ScriptDelegate, UObject* Parent, void* PropertyValue) const override;
    COREUOBJECT_API virtual void ClearDelegate(UObject* Parent, void* PropertyValue) const override;
    static FMulticastScriptDelegate GetDefaultPropertyValue() { return FMulticastScriptDelegate(); }

protected:
    virtual void LinkInternal() override;
    virtual void CopyValuesInternal(void* Dest, void const* Src, int32 Count) const override;
    virtual void ClearValueInternal(void* Data) const override;
    virtual void InitializeValueInternal(void* Dest) const override;
    virtual void DestroyValueInternal(void* Dest) const override;
};

/** A multicast delegate whose list is in FSparseDelegateStorage. */
class FMulticastSparseDelegateProperty : public FMulticastDelegateProperty {
    DECLARE_FIELD(
        FMulticastSparseDelegateProperty, FMulticastDelegateProperty, CASTCLASS_FMulticastSparseDelegateProperty)

    typedef FSparseDelegate TCppType;

    virtual int32 GetMinAlignment() const override { return alignof(FSparseDelegate); }
    COREUOBJECT_API virtual const FMulticastScriptDelegate* GetMulticastDelegate(
        const void* PropertyValue) const override;
    COREUOBJECT_API virtual void SetMulticastDelegate(
        void* PropertyValue, FMulticastScriptDelegate ScriptDelegate) const override;
    COREUOBJECT_API virtual void AddDelegate(
        FScriptDelegate ScriptDelegate, UObject* Parent, void* PropertyValue) const override;
    COREUOBJECT_API virtual void RemoveDelegate(
        const FScriptDelegate& ScriptDelegate, UObject* Parent, void* PropertyValue) const override;
    COREUOBJECT_API virtual void ClearDelegate(UObject* Parent, void* PropertyValue) const override;

protected:
    virtual void LinkInternal() override;
    /** Lists belong to their owner and are not copied with other properties. */
    virtual void CopyValuesInternal(void* Dest, void const* Src, int32 Count) const override {}
    virtual void ClearValueInternal(void* Data) const override;
    virtual void InitializeValueInternal(void* Dest) const override;
    virtual void DestroyValueInternal(void* Dest) const override {}

private:
    /** The object whose member a value is. */
    UObject* OwnerOf(const void* PropertyValue) const {
        return reinterpret_cast<UObject*>(
            static_cast<uint8*>(const_cast<void*>(PropertyValue)) - GetOffset_ForInternal());
    }
};
