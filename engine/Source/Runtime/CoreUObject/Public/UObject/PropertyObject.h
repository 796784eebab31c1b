// SPDX-License-Identifier: MIT
// Properties that refer to objects and classes. Part of "UObject/UnrealType.h".
#pragma once

#include "UObject/LazyObjectPtr.h"
#include "UObject/PropertySimple.h"
#include "UObject/ScriptInterface.h"
#include "UObject/SoftObjectPtr.h"

/** Base of all properties that refer to one object. */
class FObjectPropertyBase : public FProperty {
    DECLARE_FIELD(FObjectPropertyBase, FProperty, CASTCLASS_FObjectPropertyBase)

    /** Class of the objects it may hold. */
    TObjectPtr<UClass> PropertyClass;

    void SetPropertyClass(UClass* NewPropertyClass) { PropertyClass = NewPropertyClass; }

    /** The object a value refers to, or null (also if it is not in memory). */
    virtual UObject* GetObjectPropertyValue(const void* PropertyValueAddress) const { return nullptr; }
    virtual void SetObjectPropertyValue(void* PropertyValueAddress, UObject* Value) const { check(false); }
    UObject* GetObjectPropertyValue_InContainer(const void* ContainerAddress, int32 ArrayIndex = 0) const {
        return GetObjectPropertyValue(ContainerPtrToValuePtr<void>(ContainerAddress, ArrayIndex));
    }
    void SetObjectPropertyValue_InContainer(void* ContainerAddress, UObject* Value, int32 ArrayIndex = 0) const {
        SetObjectPropertyValue(ContainerPtrToValuePtr<void>(ContainerAddress, ArrayIndex), Value);
    }
    TObjectPtr<UObject> GetObjectPtrPropertyValue(const void* PropertyValueAddress) const {
        return GetObjectPropertyValue(PropertyValueAddress);
    }
    /** As GetObjectPropertyValue, loading soft references. */
    virtual UObject* LoadObjectPropertyValue(const void* PropertyValueAddress) const {
        return GetObjectPropertyValue(PropertyValueAddress);
    }
    /** "/Script/Module.Class'/Path.Name'". */
    COREUOBJECT_API static FString GetExportPath(const UObject* Object, const UObject* Parent = nullptr,
        const UObject* ExportRootScope = nullptr, const uint32 PortFlags = PPF_None);
    /** Reads "None", a path, or "Class'Path'"; false for an object that does not exist or is of a wrong class. */
    COREUOBJECT_API static bool ParseObjectPropertyValue(const FProperty* Property, UObject* OwnerObject,
        UClass* RequiredMetaClass, uint32 PortFlags, const TCHAR*& Buffer, TObjectPtr<UObject>& OutResolvedValue);
    virtual bool AllowCrossLevel() const { return false; }
    virtual bool SameType(const FProperty* Other) const override {
        return Super::SameType(Other) && PropertyClass == static_cast<const FObjectPropertyBase*>(Other)->PropertyClass;
    }
    virtual bool Identical(const void* A, const void* B, uint32 PortFlags) const override;
    virtual void AddReferencedObjects(FReferenceCollector& Collector) override {
        Collector.AddReferencedObject(PropertyClass);
    }
    /** False if the object may not be stored here. */
    COREUOBJECT_API bool IsObjectAllowed(const UObject* Value) const;

protected:
    /** C++ type for the inner class name. */
    FString GetCPPTypeOf(const TCHAR* Template, FString* ExtendedTypeText, UClass* Inner) const;
    virtual UClass* GetRequiredMetaClass() const { return nullptr; }
    UE_DECLARE_PROPERTY_TEXT
};

/** Object properties by the C++ type that stores the reference. */
template <typename InTCppType>
class TFObjectPropertyBase : public TProperty<InTCppType, FObjectPropertyBase> {
public:
    typedef TProperty<InTCppType, FObjectPropertyBase> Super;
    typedef InTCppType TCppType;
    using typename Super::TTypeFundamentals;
    TFObjectPropertyBase(FFieldVariant InOwner, const FName& InName, EObjectFlags InObjectFlags)
        : Super(InOwner, InName, InObjectFlags) {}

protected:
    virtual void LinkInternal() override {
        Super::LinkInternal();
        this->PropertyFlags |= CPF_HasGetValueTypeHash;
    }
    virtual uint32 GetValueTypeHashInternal(const void* Src) const override {
        return GetTypeHash(TTypeFundamentals::GetPropertyValue(Src));
    }
};

/** A strong object reference: `T*` or `TObjectPtr<T>`. */
class FObjectProperty : public TFObjectPropertyBase<TObjectPtr<UObject>> {
    DECLARE_FIELD(FObjectProperty, TFObjectPropertyBase<TObjectPtr<UObject>>, CASTCLASS_FObjectProperty)

    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;
    virtual UObject* GetObjectPropertyValue(const void* PropertyValueAddress) const override {
        return GetPropertyValue(PropertyValueAddress);
    }
    virtual void SetObjectPropertyValue(void* PropertyValueAddress, UObject* Value) const override {
        SetPropertyValue(PropertyValueAddress, Value);
    }
    virtual bool ContainsObjectReference(TArray<const FStructProperty*>& EncounteredStructProps,
        EPropertyObjectReferenceType InReferenceType) const override {
        return EnumHasAnyFlags(InReferenceType, EPropertyObjectReferenceType::Strong);
    }
    COREUOBJECT_API virtual void CollectReferences(
        void* Value, FReferenceCollector& Collector, const UObject* Referencer) const override;
    COREUOBJECT_API virtual void InstanceSubobjects(
        void* Data, void const* DefaultData, UObject* InOwner, FObjectInstancingGraph* InstanceGraph) override;

protected:
    virtual void LinkInternal() override {
        Super::LinkInternal();
        PropertyFlags |= CPF_ZeroConstructor;
    }
};

/** A weak object reference: `TWeakObjectPtr<T>`. */
class FWeakObjectProperty : public TFObjectPropertyBase<FWeakObjectPtr> {
    DECLARE_FIELD(FWeakObjectProperty, TFObjectPropertyBase<FWeakObjectPtr>, CASTCLASS_FWeakObjectProperty)

    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;
    virtual UObject* GetObjectPropertyValue(const void* PropertyValueAddress) const override {
        return GetPropertyValue(PropertyValueAddress).Get();
    }
    virtual void SetObjectPropertyValue(void* PropertyValueAddress, UObject* Value) const override {
        SetPropertyValue(PropertyValueAddress, FWeakObjectPtr(Value));
    }
    virtual bool ContainsObjectReference(TArray<const FStructProperty*>& EncounteredStructProps,
        EPropertyObjectReferenceType InReferenceType) const override {
        return EnumHasAnyFlags(InReferenceType, EPropertyObjectReferenceType::Weak);
    }
};

/** A reference by GUID: `TLazyObjectPtr<T>`. */
class FLazyObjectProperty : public TFObjectPropertyBase<FLazyObjectPtr> {
    DECLARE_FIELD(FLazyObjectProperty, TFObjectPropertyBase<FLazyObjectPtr>, CASTCLASS_FLazyObjectProperty)

    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;
    virtual UObject* GetObjectPropertyValue(const void* PropertyValueAddress) const override {
        return GetPropertyValue(PropertyValueAddress).Get();
    }
    virtual void SetObjectPropertyValue(void* PropertyValueAddress, UObject* Value) const override {
        SetPropertyValue(PropertyValueAddress, FLazyObjectPtr(Value));
    }
    virtual bool AllowCrossLevel() const override { return true; }
    virtual bool Identical(const void* A, const void* B, uint32 PortFlags) const override {
        return GetPropertyValue(A) == GetOptionalPropertyValue(B);
    }

protected:
    UE_DECLARE_PROPERTY_TEXT
};

/** A reference by path: `TSoftObjectPtr<T>`. */
class FSoftObjectProperty : public TFObjectPropertyBase<FSoftObjectPtr> {
    DECLARE_FIELD(FSoftObjectProperty, TFObjectPropertyBase<FSoftObjectPtr>, CASTCLASS_FSoftObjectProperty)

    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;
    virtual UObject* GetObjectPropertyValue(const void* PropertyValueAddress) const override {
        return GetPropertyValue(PropertyValueAddress).Get();
    }
    virtual void SetObjectPropertyValue(void* PropertyValueAddress, UObject* Value) const override {
        SetPropertyValue(PropertyValueAddress, FSoftObjectPtr(Value));
    }
    virtual UObject* LoadObjectPropertyValue(const void* PropertyValueAddress) const override {
        return GetPropertyValue(PropertyValueAddress).LoadSynchronous();
    }
    virtual bool AllowCrossLevel() const override { return true; }
    virtual bool ContainsObjectReference(TArray<const FStructProperty*>& EncounteredStructProps,
        EPropertyObjectReferenceType InReferenceType) const override {
        return EnumHasAnyFlags(InReferenceType, EPropertyObjectReferenceType::Soft);
    }
    virtual bool Identical(const void* A, const void* B, uint32 PortFlags) const override {
        return GetPropertyValue(A) == GetOptionalPropertyValue(B);
    }

protected:
    UE_DECLARE_PROPERTY_TEXT
};

/** A class reference: `TSubclassOf<T>`, `UClass*`. */
class FClassProperty : public FObjectProperty {
    DECLARE_FIELD(FClassProperty, FObjectProperty, CASTCLASS_FClassProperty)

    /** Classes must be this one or a child of it. */
    TObjectPtr<UClass> MetaClass;

    void SetMetaClass(UClass* NewMetaClass) { MetaClass = NewMetaClass; }
    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;
    virtual bool SameType(const FProperty* Other) const override {
        return Super::SameType(Other) && MetaClass == static_cast<const FClassProperty*>(Other)->MetaClass;
    }
    virtual void AddReferencedObjects(FReferenceCollector& Collector) override {
        Super::AddReferencedObjects(Collector);
        Collector.AddReferencedObject(MetaClass);
    }

protected:
    virtual UClass* GetRequiredMetaClass() const override { return MetaClass; }
};

/** A class reference by path: `TSoftClassPtr<T>`. */
class FSoftClassProperty : public FSoftObjectProperty {
    DECLARE_FIELD(FSoftClassProperty, FSoftObjectProperty, CASTCLASS_FSoftClassProperty)

    TObjectPtr<UClass> MetaClass;

    void SetMetaClass(UClass* NewMetaClass) { MetaClass = NewMetaClass; }
    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;
    virtual bool SameType(const FProperty* Other) const override {
        return Super::SameType(Other) && MetaClass == static_cast<const FSoftClassProperty*>(Other)->MetaClass;
    }

protected:
    virtual UClass* GetRequiredMetaClass() const override { return MetaClass; }
};

/** An interface reference: `TScriptInterface<I>`. */
class FInterfaceProperty : public TProperty_WithEquality<FScriptInterface, FProperty> {
    typedef TProperty_WithEquality<FScriptInterface, FProperty> FBase;
    DECLARE_FIELD(FInterfaceProperty, FBase, CASTCLASS_FInterfaceProperty)

    /** The U-class of the interface. */
    TObjectPtr<UClass> InterfaceClass;

    void SetInterfaceClass(UClass* NewInterfaceClass) { InterfaceClass = NewInterfaceClass; }
    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;
    virtual bool ContainsObjectReference(TArray<const FStructProperty*>& EncounteredStructProps,
        EPropertyObjectReferenceType InReferenceType) const override {
        return EnumHasAnyFlags(InReferenceType, EPropertyObjectReferenceType::Strong);
    }
    COREUOBJECT_API virtual void CollectReferences(
        void* Value, FReferenceCollector& Collector, const UObject* Referencer) const override;
    virtual bool SameType(const FProperty* Other) const override {
        return Super::SameType(Other) &&
               InterfaceClass == static_cast<const FInterfaceProperty*>(Other)->InterfaceClass;
    }

protected:
    virtual void LinkInternal() override {
        FBase::LinkInternal();
        PropertyFlags |= CPF_ZeroConstructor | CPF_HasGetValueTypeHash;
    }
    virtual uint32 GetValueTypeHashInternal(const void* Src) const override {
        return GetTypeHash(GetPropertyValue(Src));
    }
    UE_DECLARE_PROPERTY_TEXT
};
