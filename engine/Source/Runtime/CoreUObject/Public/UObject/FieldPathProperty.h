// SPDX-License-Identifier: MIT
// TFieldPath and its property. Mirrors Epic's "UObject/FieldPath.h" and "UObject/FieldPathProperty.h".
#pragma once

#include "UObject/PropertySimple.h"

/** A property by path ("/Script/Module.Class:Property"), resolved on demand. */
struct FFieldPath {
    FFieldPath() = default;
    explicit FFieldPath(FField* InField) : Path(InField ? InField->GetPathName() : FString()) {}
    explicit FFieldPath(const TCHAR* InPath) : Path(InPath) {}

    /** The field, or null if it does not exist (or is none of class Type). */
    COREUOBJECT_API FField* GetTyped(FFieldClass* Type) const;
    FField* Get() const { return GetTyped(FField::StaticClass()); }
    FString ToString() const { return Path; }
    void Reset() { Path.Reset(); }
    bool IsPathToFieldEmpty() const { return Path.IsEmpty(); }
    bool operator==(const FFieldPath& Other) const { return Path == Other.Path; }
    friend uint32 GetTypeHash(const FFieldPath& FieldPath) { return GetTypeHash(FieldPath.Path); }

private:
    FString Path;
};

/** Typed field path. */
template <class PropertyType>
struct TFieldPath : public FFieldPath {
    TFieldPath() = default;
    TFieldPath(PropertyType* InField) : FFieldPath(InField) {}
    explicit TFieldPath(const TCHAR* InPath) : FFieldPath(InPath) {}
    PropertyType* Get() const { return static_cast<PropertyType*>(GetTyped(PropertyType::StaticClass())); }
    PropertyType* operator->() const { return Get(); }
};

/** The value of a TFieldPath member. */
class FFieldPathProperty : public TProperty_WithEquality<FFieldPath, FProperty> {
    typedef TProperty_WithEquality<FFieldPath, FProperty> FBase;
    DECLARE_FIELD(FFieldPathProperty, FBase, CASTCLASS_FFieldPathProperty)

    /** Class of the fields it may name. */
    FFieldClass* PropertyClass = nullptr;

    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;

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
