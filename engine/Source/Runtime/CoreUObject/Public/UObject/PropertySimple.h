// SPDX-License-Identifier: MIT
// Properties of bools, enums, strings, names and texts. Part of "UObject/UnrealType.h".
#pragma once

#include "UObject/PropertyNumeric.h"

#define UE_DECLARE_PROPERTY_TEXT                                                                                       \
    COREUOBJECT_API virtual void ExportText_Internal(FString& ValueStr, const void* PropertyValueOrContainer,          \
        EPropertyPointerType PropertyPointerType, const void* DefaultValue, UObject* Parent, int32 PortFlags,          \
        UObject* ExportRootScope) const override;                                                                      \
    COREUOBJECT_API virtual const TCHAR* ImportText_Internal(const TCHAR* Buffer, void* ContainerOrPropertyPtr,        \
        EPropertyPointerType PropertyPointerType, UObject* OwnerObject, int32 PortFlags, FOutputDevice* ErrorText)     \
        const override;

/** A bool, or one bit of an integer. */
class FBoolProperty : public FProperty {
    DECLARE_FIELD(FBoolProperty, FProperty, CASTCLASS_FBoolProperty)

    typedef bool TCppType;

    /** Sets the layout: size of the bool or of the integer that holds the bit, and the bit within it. */
    COREUOBJECT_API void SetBoolSize(const uint32 InSize, const bool bIsNativeBool = false, const uint32 InBitMask = 0);
    /** True for `bool`, false for a bit-field. */
    bool IsNativeBool() const { return FieldMask == 0xff; }
    uint8 GetFieldMask() const { return FieldMask; }
    uint8 GetByteMask() const { return ByteMask; }
    uint8 GetByteOffset() const { return ByteOffset; }
    uint32 GetBoolSize() const { return FieldSize; }
    int32 GetMinAlignment() const override { return IsNativeBool() ? 1 : FieldSize; }

    bool GetPropertyValue(void const* A) const { return (static_cast<const uint8*>(A)[ByteOffset] & FieldMask) != 0; }
    bool GetPropertyValue_InContainer(void const* A, int32 ArrayIndex = 0) const {
        return GetPropertyValue(ContainerPtrToValuePtr<void>(A, ArrayIndex));
    }
    void SetPropertyValue(void* A, bool Value) const {
        uint8* const Byte = static_cast<uint8*>(A) + ByteOffset;
        *Byte = static_cast<uint8>((*Byte & ~FieldMask) | (Value ? ByteMask : 0));
    }
    void SetPropertyValue_InContainer(void* A, bool Value, int32 ArrayIndex = 0) const {
        SetPropertyValue(ContainerPtrToValuePtr<void>(A, ArrayIndex), Value);
    }
    static bool GetDefaultPropertyValue() { return false; }
    bool GetOptionalPropertyValue(void const* B) const { return B && GetPropertyValue(B); }

    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;
    virtual bool Identical(const void* A, const void* B, uint32 PortFlags) const override {
        return GetPropertyValue(A) == GetOptionalPropertyValue(B);
    }
    virtual void CopySingleValueToScriptVM(void* Dest, void const* Src) const override {
        *static_cast<uint8*>(Dest) = GetPropertyValue(Src) ? 1 : 0;
    }
    virtual void CopyCompleteValueToScriptVM(void* Dest, void const* Src) const override {
        CopySingleValueToScriptVM(Dest, Src);
    }
    virtual void CopySingleValueFromScriptVM(void* Dest, void const* Src) const override {
        SetPropertyValue(Dest, *static_cast<const uint8*>(Src) != 0);
    }
    virtual void CopyCompleteValueFromScriptVM(void* Dest, void const* Src) const override {
        CopySingleValueFromScriptVM(Dest, Src);
    }
    virtual bool SameType(const FProperty* Other) const override {
        return Super::SameType(Other) && IsNativeBool() == static_cast<const FBoolProperty*>(Other)->IsNativeBool();
    }

protected:
    virtual void LinkInternal() override;
    virtual void CopyValuesInternal(void* Dest, void const* Src, int32 Count) const override;
    virtual void ClearValueInternal(void* Data) const override { SetPropertyValue(Data, false); }
    virtual void InitializeValueInternal(void* Dest) const override;
    virtual void DestroyValueInternal(void* Dest) const override {}
    virtual uint32 GetValueTypeHashInternal(const void* Src) const override { return GetPropertyValue(Src) ? 1 : 0; }
    UE_DECLARE_PROPERTY_TEXT

private:
    uint8 FieldSize = 1;
    uint8 ByteOffset = 0;
    uint8 ByteMask = 1;
    uint8 FieldMask = 0xff;
};

/** An enum class, with the integer property that stores it. */
class FEnumProperty : public FProperty {
    DECLARE_FIELD(FEnumProperty, FProperty, CASTCLASS_FEnumProperty)
public:
    COREUOBJECT_API virtual ~FEnumProperty() override;

    UEnum* GetEnum() const { return Enum; }
    void SetEnum(UEnum* InEnum) { Enum = InEnum; }
    FNumericProperty* GetUnderlyingProperty() const { return UnderlyingProp; }
    /** Takes over the integer property. */
    void SetUnderlyingProperty(FNumericProperty* Property) { UnderlyingProp = Property; }

    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;
    virtual int32 GetMinAlignment() const override { return UnderlyingProp->GetMinAlignment(); }
    virtual bool Identical(const void* A, const void* B, uint32 PortFlags) const override {
        return UnderlyingProp->Identical(A, B, PortFlags);
    }
    virtual bool SameType(const FProperty* Other) const override {
        return Super::SameType(Other) && Enum == static_cast<const FEnumProperty*>(Other)->Enum &&
               UnderlyingProp->SameType(static_cast<const FEnumProperty*>(Other)->UnderlyingProp);
    }
    virtual void GetInnerFields(TArray<FField*>& OutFields) override { OutFields.Add(UnderlyingProp); }

protected:
    virtual void LinkInternal() override;
    virtual void CopyValuesInternal(void* Dest, void const* Src, int32 Count) const override {
        FMemory::Memcpy(Dest, Src, static_cast<SIZE_T>(ElementSize * Count));
    }
    virtual void ClearValueInternal(void* Data) const override {
        FMemory::Memzero(Data, static_cast<SIZE_T>(ElementSize));
    }
    virtual uint32 GetValueTypeHashInternal(const void* Src) const override {
        return UnderlyingProp->GetValueTypeHash(Src);
    }
    UE_DECLARE_PROPERTY_TEXT

private:
    FNumericProperty* UnderlyingProp = nullptr;
    TObjectPtr<UEnum> Enum;
};

#define UE_DECLARE_VALUE_PROPERTY(TClass, CppType, CastFlag, bByRef)                                                   \
    class TClass : public TProperty_WithEquality<CppType, FProperty> {                                                 \
        typedef TProperty_WithEquality<CppType, FProperty> FBase;                                                      \
        DECLARE_FIELD(TClass, FBase, CastFlag)                                                                         \
        virtual FString GetCPPType(FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override {    \
            return FString(TEXT(#CppType));                                                                            \
        }                                                                                                              \
        virtual bool PassCPPArgsByRef() const override { return bByRef; }                                              \
        virtual bool Identical(const void* A, const void* B, uint32 PortFlags) const override;                         \
                                                                                                                       \
    protected:                                                                                                         \
        virtual void LinkInternal() override;                                                                          \
        virtual uint32 GetValueTypeHashInternal(const void* Src) const override;                                       \
        UE_DECLARE_PROPERTY_TEXT                                                                                       \
    };

/** Strings compare with case, as UE's FStrProperty does. */
UE_DECLARE_VALUE_PROPERTY(FStrProperty, FString, CASTCLASS_FStrProperty, true)
/** Names compare without case. */
UE_DECLARE_VALUE_PROPERTY(FNameProperty, FName, CASTCLASS_FNameProperty, false)
UE_DECLARE_VALUE_PROPERTY(FTextProperty, FText, CASTCLASS_FTextProperty, true)
