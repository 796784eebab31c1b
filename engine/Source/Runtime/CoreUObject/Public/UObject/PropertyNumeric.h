// SPDX-License-Identifier: MIT
// Number properties. Part of "UObject/UnrealType.h".
#pragma once

#include "UObject/Property.h"

class UEnum;

/** Base of all number properties; also byte properties with an enum. */
class FNumericProperty : public FProperty {
    DECLARE_FIELD(FNumericProperty, FProperty, CASTCLASS_FNumericProperty)

    virtual bool IsFloatingPoint() const = 0;
    virtual bool IsInteger() const = 0;
    /** The enum behind a byte property. */
    virtual UEnum* GetIntPropertyEnum() const { return nullptr; }
    bool IsEnum() const { return GetIntPropertyEnum() != nullptr; }
    virtual bool CanHoldValue(int64 InValue) const = 0;
    virtual void SetIntPropertyValue(void* Data, uint64 Value) const = 0;
    virtual void SetIntPropertyValue(void* Data, int64 Value) const = 0;
    virtual void SetFloatingPointPropertyValue(void* Data, double Value) const = 0;
    /** False if the text is no number. */
    COREUOBJECT_API bool SetNumericPropertyValueFromString(void* Data, const TCHAR* Value) const;
    virtual int64 GetSignedIntPropertyValue(void const* Data) const = 0;
    virtual uint64 GetUnsignedIntPropertyValue(void const* Data) const = 0;
    virtual double GetFloatingPointPropertyValue(void const* Data) const = 0;
    /** Integers in decimal, floating point as %f. */
    COREUOBJECT_API FString GetNumericPropertyValueToString(void const* Data) const;
    int64 GetSignedIntPropertyValue_InContainer(void const* Container, int32 ArrayIndex = 0) const {
        return GetSignedIntPropertyValue(ContainerPtrToValuePtr<void>(Container, ArrayIndex));
    }

protected:
    virtual bool IsSigned() const = 0;
    COREUOBJECT_API virtual void ExportText_Internal(FString& ValueStr, const void* PropertyValueOrContainer,
        EPropertyPointerType PropertyPointerType, const void* DefaultValue, UObject* Parent, int32 PortFlags,
        UObject* ExportRootScope) const override;
    COREUOBJECT_API virtual const TCHAR* ImportText_Internal(const TCHAR* Buffer, void* ContainerOrPropertyPtr,
        EPropertyPointerType PropertyPointerType, UObject* OwnerObject, int32 PortFlags,
        FOutputDevice* ErrorText) const override;
};

/** A number of one C++ type. */
template <typename InTCppType>
class TProperty_Numeric : public TProperty_WithEquality<InTCppType, FNumericProperty> {
public:
    typedef TProperty_WithEquality<InTCppType, FNumericProperty> Super;
    typedef InTCppType TCppType;
    using typename Super::TTypeFundamentals;

    TProperty_Numeric(FFieldVariant InOwner, const FName& InName, EObjectFlags InObjectFlags)
        : Super(InOwner, InName, InObjectFlags) {}

    virtual bool IsFloatingPoint() const override { return std::is_floating_point_v<TCppType>; }
    virtual bool IsInteger() const override { return std::is_integral_v<TCppType>; }
    virtual bool CanHoldValue(int64 Value) const override {
        return static_cast<int64>(static_cast<TCppType>(Value)) == Value && (std::is_signed_v<TCppType> || Value >= 0);
    }
    virtual void SetIntPropertyValue(void* Data, uint64 Value) const override {
        TTypeFundamentals::SetPropertyValue(Data, static_cast<TCppType>(Value));
    }
    virtual void SetIntPropertyValue(void* Data, int64 Value) const override {
        TTypeFundamentals::SetPropertyValue(Data, static_cast<TCppType>(Value));
    }
    virtual void SetFloatingPointPropertyValue(void* Data, double Value) const override {
        TTypeFundamentals::SetPropertyValue(Data, static_cast<TCppType>(Value));
    }
    virtual int64 GetSignedIntPropertyValue(void const* Data) const override {
        return static_cast<int64>(TTypeFundamentals::GetPropertyValue(Data));
    }
    virtual uint64 GetUnsignedIntPropertyValue(void const* Data) const override {
        return static_cast<uint64>(TTypeFundamentals::GetPropertyValue(Data));
    }
    virtual double GetFloatingPointPropertyValue(void const* Data) const override {
        return static_cast<double>(TTypeFundamentals::GetPropertyValue(Data));
    }

protected:
    virtual bool IsSigned() const override { return std::is_signed_v<TCppType>; }
    virtual void LinkInternal() override {
        Super::LinkInternal();
        this->PropertyFlags |= CPF_ZeroConstructor | CPF_HasGetValueTypeHash;
    }
    virtual uint32 GetValueTypeHashInternal(const void* Src) const override {
        return GetTypeHash(TTypeFundamentals::GetPropertyValue(Src));
    }
};

#define UE_DECLARE_NUMERIC_PROPERTY(TClass, CppType, CastFlag)                                                         \
    class TClass : public TProperty_Numeric<CppType> {                                                                 \
        DECLARE_FIELD(TClass, TProperty_Numeric<CppType>, CastFlag)                                                    \
        virtual FString GetCPPType(FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override {    \
            return FString(TEXT(#CppType));                                                                            \
        }                                                                                                              \
    };

UE_DECLARE_NUMERIC_PROPERTY(FInt8Property, int8, CASTCLASS_FInt8Property)
UE_DECLARE_NUMERIC_PROPERTY(FInt16Property, int16, CASTCLASS_FInt16Property)
UE_DECLARE_NUMERIC_PROPERTY(FIntProperty, int32, CASTCLASS_FIntProperty)
UE_DECLARE_NUMERIC_PROPERTY(FInt64Property, int64, CASTCLASS_FInt64Property)
UE_DECLARE_NUMERIC_PROPERTY(FUInt16Property, uint16, CASTCLASS_FUInt16Property)
UE_DECLARE_NUMERIC_PROPERTY(FUInt32Property, uint32, CASTCLASS_FUInt32Property)
UE_DECLARE_NUMERIC_PROPERTY(FUInt64Property, uint64, CASTCLASS_FUInt64Property)
UE_DECLARE_NUMERIC_PROPERTY(FFloatProperty, float, CASTCLASS_FFloatProperty)
UE_DECLARE_NUMERIC_PROPERTY(FDoubleProperty, double, CASTCLASS_FDoubleProperty)

/** uint8, or an enum in one byte (TEnumAsByte, regular and namespaced enums). */
class FByteProperty : public TProperty_Numeric<uint8> {
    DECLARE_FIELD(FByteProperty, TProperty_Numeric<uint8>, CASTCLASS_FByteProperty)

    /** The enum, or null for a plain number. */
    TObjectPtr<UEnum> Enum;

    virtual UEnum* GetIntPropertyEnum() const override { return Enum; }
    COREUOBJECT_API virtual FString GetCPPType(
        FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const override;
    virtual bool SameType(const FProperty* Other) const override {
        return Super::SameType(Other) && Enum == static_cast<const FByteProperty*>(Other)->Enum;
    }

protected:
    COREUOBJECT_API virtual void ExportText_Internal(FString& ValueStr, const void* PropertyValueOrContainer,
        EPropertyPointerType PropertyPointerType, const void* DefaultValue, UObject* Parent, int32 PortFlags,
        UObject* ExportRootScope) const override;
    COREUOBJECT_API virtual const TCHAR* ImportText_Internal(const TCHAR* Buffer, void* ContainerOrPropertyPtr,
        EPropertyPointerType PropertyPointerType, UObject* OwnerObject, int32 PortFlags,
        FOutputDevice* ErrorText) const override;
};
