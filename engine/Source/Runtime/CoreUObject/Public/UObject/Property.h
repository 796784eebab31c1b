// SPDX-License-Identifier: MIT
// FProperty and the template its simple children share. Part of "UObject/UnrealType.h".
#pragma once

#include "CoreMinimal.h"
#include "Templates/Function.h"
#include "UObject/Class.h"
#include "UObject/Field.h"
#include "UObject/PropertyPortFlags.h"

class FOutputDevice;
class FStructProperty;
struct FObjectInstancingGraph;

/** Kinds of references ContainsObjectReference looks for. */
enum class EPropertyObjectReferenceType : uint32 {
    None = 0,
    Strong = 1 << 0,
    Weak = 1 << 1,
    Soft = 1 << 2,
    Any = 0xFFFFFFFF,
};
ENUM_CLASS_FLAGS(EPropertyObjectReferenceType)

/** What text export does with C++ type names. */
enum EPropertyExportCPPFlags {
    CPPF_None = 0x00000000,
    CPPF_OptionalValue = 0x00000001,
    CPPF_ArgumentOrReturnValue = 0x00000002,
    CPPF_Implementation = 0x00000004,
    CPPF_CustomTypeName = 0x00000008,
    CPPF_NoConst = 0x00000010,
    CPPF_NoRef = 0x00000020,
    CPPF_NoStaticArray = 0x00000040,
    CPPF_BlueprintCppBackend = 0x00000080,
    CPPF_NoTObjectPtr = 0x00000100,
};

/** Native accessors of a property: container, value. */
typedef void (*FPropertySetterPtr)(void* InContainer, const void* InValue);
typedef void (*FPropertyGetterPtr)(const void* InContainer, void* OutValue);

/**
 * Describes one variable of a class, struct or function: type, place, flags, and how to initialise, copy, compare,
 * print and parse its values.
 *
 * "Value" pointers address the variable itself, "Container" pointers the object or struct that holds it. "Complete" and
 * unmarked functions work on all ArrayDim elements of a C array, "Single" ones on one element.
 */
class FProperty : public FField {
    DECLARE_FIELD(FProperty, FField, CASTCLASS_FProperty)

    /** Number of elements of a C array, else 1. */
    int32 ArrayDim = 1;
    EPropertyFlags PropertyFlags = CPF_None;
    uint16 RepIndex = 0;
    /** Function called on a client when the property was replicated. */
    FName RepNotifyFunc;

    /** Next property of the struct and its supers, most derived first (UStruct::PropertyLink). */
    FProperty* PropertyLinkNext = nullptr;
    /** Next property that holds strong references (UStruct::RefLink). */
    FProperty* NextRef = nullptr;
    /** Next property that needs destruction (UStruct::DestructorLink). */
    FProperty* DestructorLinkNext = nullptr;
    /** Next property that is filled after construction (UStruct::PostConstructLink). */
    FProperty* PostConstructLinkNext = nullptr;

    // ---- flags

    EPropertyFlags GetPropertyFlags() const { return PropertyFlags; }
    void SetPropertyFlags(EPropertyFlags NewFlags) { PropertyFlags |= NewFlags; }
    void ClearPropertyFlags(EPropertyFlags NewFlags) { PropertyFlags &= ~NewFlags; }
    bool HasAnyPropertyFlags(uint64 FlagsToCheck) const {
        return (PropertyFlags & FlagsToCheck) != 0 || FlagsToCheck == CPF_AllFlags;
    }
    bool HasAllPropertyFlags(uint64 FlagsToCheck) const { return (PropertyFlags & FlagsToCheck) == FlagsToCheck; }
    bool IsEditorOnlyProperty() const { return HasAnyPropertyFlags(CPF_EditorOnly); }

    // ---- place

    int32 GetSize() const { return ArrayDim * ElementSize; }
    int32 GetElementSize() const { return ElementSize; }
    void SetElementSize(int32 NewSize) { ElementSize = NewSize; }
    int32 GetOffset_ForDebug() const { return Offset_Internal; }
    int32 GetOffset_ForInternal() const { return Offset_Internal; }
    int32 GetOffset_ForUFunction() const { return Offset_Internal; }
    int32 GetOffset_ForGC() const { return Offset_Internal; }
    int32 GetOffset_ReplaceWith_ContainerPtrToValuePtr() const { return Offset_Internal; }
    void SetOffset_Internal(int32 NewOffset) { Offset_Internal = NewOffset; }
    bool IsOffset(int32 InOffset) const { return Offset_Internal == InOffset; }
    bool IsInContainer(int32 ContainerSize) const { return Offset_Internal + GetSize() <= ContainerSize; }
    bool IsInContainer(const UStruct* ContainerClass) const {
        return IsInContainer(ContainerClass ? ContainerClass->GetPropertiesSize() : INT32_MAX);
    }

    /** Address of the value (or of one element of a C array) inside a container. */
    template <typename ValueType>
    ValueType* ContainerPtrToValuePtr(UObject* ContainerPtr, int32 ArrayIndex = 0) const {
        return static_cast<ValueType*>(
            ContainerVoidPtrToValuePtrInternal(static_cast<void*>(ContainerPtr), ArrayIndex));
    }
    template <typename ValueType>
    ValueType* ContainerPtrToValuePtr(void* ContainerPtr, int32 ArrayIndex = 0) const {
        return static_cast<ValueType*>(ContainerVoidPtrToValuePtrInternal(ContainerPtr, ArrayIndex));
    }
    template <typename ValueType>
    const ValueType* ContainerPtrToValuePtr(const UObject* ContainerPtr, int32 ArrayIndex = 0) const {
        return ContainerPtrToValuePtr<ValueType>(const_cast<UObject*>(ContainerPtr), ArrayIndex);
    }
    template <typename ValueType>
    const ValueType* ContainerPtrToValuePtr(const void* ContainerPtr, int32 ArrayIndex = 0) const {
        return ContainerPtrToValuePtr<ValueType>(const_cast<void*>(ContainerPtr), ArrayIndex);
    }
    /** As ContainerPtrToValuePtr for a default container of class ContainerClass, which may be too small; null then. */
    template <typename ValueType>
    ValueType* ContainerPtrToValuePtrForDefaults(
        const UStruct* ContainerClass, void* ContainerPtr, int32 ArrayIndex = 0) const {
        return ContainerPtr && IsInContainer(ContainerClass)
                   ? ContainerPtrToValuePtr<ValueType>(ContainerPtr, ArrayIndex)
                   : nullptr;
    }
    template <typename ValueType>
    const ValueType* ContainerPtrToValuePtrForDefaults(
        const UStruct* ContainerClass, const void* ContainerPtr, int32 ArrayIndex = 0) const {
        return ContainerPtrToValuePtrForDefaults<ValueType>(
            ContainerClass, const_cast<void*>(ContainerPtr), ArrayIndex);
    }
    virtual int32 GetMinAlignment() const { return 1; }
    /** Computes size and flags from the type. Called once, when the owner is linked. */
    COREUOBJECT_API void Link();
    /** Gives the property the next free, aligned offset and returns the end of its storage. */
    COREUOBJECT_API int32 SetupOffset(int32 CurrentSize);

    // ---- C++ type text

    /**
     * The C++ type. For templates the result is the template's name and the arguments ("<int32>") go to
     * ExtendedTypeText.
     */
    virtual FString GetCPPType(FString* ExtendedTypeText = nullptr, uint32 CPPExportFlags = 0) const {
        return FString();
    }
    virtual FString GetCPPMacroType(FString& ExtendedTypeText) const { return GetCPPType(&ExtendedTypeText); }
    virtual FString GetCPPTypeForwardDeclaration() const { return FString(); }
    virtual bool PassCPPArgsByRef() const { return false; }
    FName GetID() const { return GetClass()->GetFName(); }

    // ---- values

    /** True if two values (all elements) are equal. B null compares with the default value. */
    COREUOBJECT_API bool IdenticalAll(const void* A, const void* B, uint32 PortFlags = 0) const;
    /** True if two single values are equal. B null compares with the default value. */
    virtual bool Identical(const void* A, const void* B, uint32 PortFlags = 0) const = 0;
    bool Identical_InContainer(const void* A, const void* B, int32 ArrayIndex = 0, uint32 PortFlags = 0) const {
        return Identical(ContainerPtrToValuePtr<void>(A, ArrayIndex),
            B ? ContainerPtrToValuePtr<void>(B, ArrayIndex) : nullptr, PortFlags);
    }

    void CopySingleValue(void* Dest, void const* Src) const {
        if (Dest != Src) {
            if (PropertyFlags & CPF_IsPlainOldData) {
                FMemory::Memcpy(Dest, Src, static_cast<SIZE_T>(ElementSize));
            } else {
                CopyValuesInternal(Dest, Src, 1);
            }
        }
    }
    void CopyCompleteValue(void* Dest, void const* Src) const {
        if (Dest != Src) {
            if (PropertyFlags & CPF_IsPlainOldData) {
                FMemory::Memcpy(Dest, Src, static_cast<SIZE_T>(ElementSize) * static_cast<SIZE_T>(ArrayDim));
            } else {
                CopyValuesInternal(Dest, Src, ArrayDim);
            }
        }
    }
    void CopyCompleteValue_InContainer(void* DestContainer, void const* SrcContainer) const {
        CopyCompleteValue(ContainerPtrToValuePtr<void>(DestContainer), ContainerPtrToValuePtr<void>(SrcContainer));
    }
    /** Copies into a local of the calling convention: bools become one byte. */
    virtual void CopySingleValueToScriptVM(void* Dest, void const* Src) const { CopySingleValue(Dest, Src); }
    virtual void CopyCompleteValueToScriptVM(void* Dest, void const* Src) const { CopyCompleteValue(Dest, Src); }
    virtual void CopySingleValueFromScriptVM(void* Dest, void const* Src) const { CopySingleValue(Dest, Src); }
    virtual void CopyCompleteValueFromScriptVM(void* Dest, void const* Src) const { CopyCompleteValue(Dest, Src); }

    void InitializeValue(void* Dest) const {
        if (PropertyFlags & CPF_ZeroConstructor) {
            FMemory::Memzero(Dest, static_cast<SIZE_T>(GetSize()));
        } else {
            InitializeValueInternal(Dest);
        }
    }
    void InitializeValue_InContainer(void* Dest) const { InitializeValue(ContainerPtrToValuePtr<void>(Dest)); }
    void DestroyValue(void* Dest) const {
        if (!(PropertyFlags & CPF_NoDestructor)) {
            DestroyValueInternal(Dest);
        }
    }
    void DestroyValue_InContainer(void* Dest) const { DestroyValue(ContainerPtrToValuePtr<void>(Dest)); }
    /** Sets all elements to the value of a fresh one. */
    void ClearValue(void* Data) const {
        for (int32 Index = 0; Index < ArrayDim; ++Index) {
            ClearSingleValue(static_cast<uint8*>(Data) + Index * ElementSize);
        }
    }
    void ClearValue_InContainer(void* Data, int32 ArrayIndex = 0) const {
        ClearSingleValue(ContainerPtrToValuePtr<void>(Data, ArrayIndex));
    }
    void ClearSingleValue(void* Data) const {
        if (HasAllPropertyFlags(CPF_NoDestructor | CPF_ZeroConstructor)) {
            FMemory::Memzero(Data, static_cast<SIZE_T>(ElementSize));
        } else {
            ClearValueInternal(Data);
        }
    }
    /** Heap memory with an initialised value; to be released by DestroyAndFreeValue. */
    COREUOBJECT_API void* AllocateAndInitializeValue() const;
    COREUOBJECT_API void DestroyAndFreeValue(void* InMemory) const;
    /** Hash of a value; the property must have CPF_HasGetValueTypeHash. */
    COREUOBJECT_API uint32 GetValueTypeHash(const void* Src) const;

    // ---- values through native accessors

    bool HasSetter() const { return SetterFunction != nullptr; }
    bool HasGetter() const { return GetterFunction != nullptr; }
    bool HasSetterOrGetter() const { return SetterFunction || GetterFunction; }
    /** Calls the native setter; the property must have one. */
    COREUOBJECT_API void CallSetter(void* Container, const void* InValue) const;
    COREUOBJECT_API void CallGetter(const void* Container, void* OutValue) const;
    /** Reads the whole value, through the getter if there is one. OutValue must be initialised. */
    COREUOBJECT_API void GetValue_InContainer(void const* InContainer, void* OutValue) const;
    COREUOBJECT_API void SetValue_InContainer(void* OutContainer, void const* InValue) const;
    COREUOBJECT_API void GetSingleValue_InContainer(const void* InContainer, void* OutValue, int32 ArrayIndex) const;
    COREUOBJECT_API void SetSingleValue_InContainer(void* OutContainer, const void* InValue, int32 ArrayIndex) const;
    /** Lets a function change a value in place, then calls the setter if there is one. */
    COREUOBJECT_API void PerformOperationWithSetter(
        void* OutContainer, void* DirectPropertyAddress, TFunctionRef<void(void*)> DirectValueAccessFunc) const;
    COREUOBJECT_API void PerformOperationWithGetter(void* OutContainer, const void* DirectPropertyAddress,
        TFunctionRef<void(const void*)> DirectValueAccessFunc) const;
    void SetNativeAccessors(FPropertySetterPtr InSetter, FPropertyGetterPtr InGetter) {
        SetterFunction = InSetter;
        GetterFunction = InGetter;
    }

    // ---- text

    /** Appends the text of a value. DefaultValue (may be null) lets structs leave out equal members. */
    void ExportTextItem_Direct(FString& ValueStr, const void* PropertyValue, const void* DefaultValue, UObject* Parent,
        int32 PortFlags, UObject* ExportRootScope = nullptr) const {
        ExportText_Internal(
            ValueStr, PropertyValue, EPropertyPointerType::Direct, DefaultValue, Parent, PortFlags, ExportRootScope);
    }
    COREUOBJECT_API void ExportTextItem_InContainer(FString& ValueStr, const void* Container, const void* DefaultValue,
        UObject* Parent, int32 PortFlags, UObject* ExportRootScope = nullptr) const;
    /** Appends one element's text; false if it equals Delta's (then nothing is appended). */
    COREUOBJECT_API bool ExportText_Direct(FString& ValueStr, const void* Data, const void* Delta, UObject* Parent,
        int32 PortFlags, UObject* ExportRootScope = nullptr) const;
    COREUOBJECT_API bool ExportText_InContainer(int32 Index, FString& ValueStr, const void* Data, const void* Delta,
        UObject* Parent, int32 PortFlags, UObject* ExportRootScope = nullptr) const;
    /** Reads a value from text; returns where reading stopped, null on error (reported to ErrorText, may be null). */
    const TCHAR* ImportText_Direct(const TCHAR* Buffer, void* PropertyPtr, UObject* OwnerObject, int32 PortFlags,
        FOutputDevice* ErrorText = nullptr) const {
        return ValidateImportFlags(PortFlags, ErrorText)
                   ? ImportText_Internal(
                         Buffer, PropertyPtr, EPropertyPointerType::Direct, OwnerObject, PortFlags, ErrorText)
                   : nullptr;
    }
    /** As ImportText_Direct into a container, through the native setter if there is one. */
    COREUOBJECT_API const TCHAR* ImportText_InContainer(const TCHAR* Buffer, void* Container, UObject* OwnerObject,
        int32 PortFlags, FOutputDevice* ErrorText = nullptr) const;

    // ---- structure

    /** Address of an element or member of a container value by index, for walks over nested values. */
    virtual void* GetValueAddressAtIndex_Direct(const FProperty* Inner, void* InValueAddress, int32 Index) const {
        return static_cast<uint8*>(InValueAddress) + Index * ElementSize;
    }
    virtual bool ContainsObjectReference(TArray<const FStructProperty*>& EncounteredStructProps,
        EPropertyObjectReferenceType InReferenceType = EPropertyObjectReferenceType::Strong) const {
        return false;
    }
    bool ContainsWeakObjectReference() const {
        TArray<const FStructProperty*> Encountered;
        return ContainsObjectReference(Encountered, EPropertyObjectReferenceType::Weak);
    }
    virtual bool ContainsInstancedObjectProperty() const {
        return HasAnyPropertyFlags(CPF_ContainsInstancedReference | CPF_InstancedReference);
    }
    /** Reports the strong references in one complete value. */
    virtual void CollectReferences(void* Value, FReferenceCollector& Collector, const UObject* Referencer) const {}
    /** Replaces references to a template's subobjects by references to the copy's own. */
    virtual void InstanceSubobjects(
        void* Data, void const* DefaultData, UObject* InOwner, FObjectInstancingGraph* InstanceGraph) {}
    /** True if values of both properties can be copied into each other. */
    virtual bool SameType(const FProperty* Other) const { return Other && GetClass() == Other->GetClass(); }
    COREUOBJECT_API bool ShouldDuplicateValue() const;
    bool ShouldPort(uint32 PortFlags = 0) const {
        return !HasAnyPropertyFlags(CPF_Deprecated) &&
               (!HasAnyPropertyFlags(CPF_Transient) || (PortFlags & PPF_IncludeTransient));
    }
    /** The property that holds this one as element, key or value, or this one. */
    COREUOBJECT_API const FProperty* GetOwnerProperty() const;
    bool IsArrayPropertyInner() const { return Owner.IsValid() && !Owner.IsUObject(); }
    bool IsReadyForFinishDestroy() const { return true; }

protected:
    int32 ElementSize = 0;
    int32 Offset_Internal = 0;
    FPropertySetterPtr SetterFunction = nullptr;
    FPropertyGetterPtr GetterFunction = nullptr;

    virtual void LinkInternal() {}
    virtual void CopyValuesInternal(void* Dest, void const* Src, int32 Count) const { check(false); }
    virtual void ClearValueInternal(void* Data) const { check(false); }
    virtual void DestroyValueInternal(void* Dest) const { check(false); }
    virtual void InitializeValueInternal(void* Dest) const { check(false); }
    virtual uint32 GetValueTypeHashInternal(const void* Src) const {
        check(false);
        return 0;
    }
    virtual void ExportText_Internal(FString& ValueStr, const void* PropertyValueOrContainer,
        EPropertyPointerType PropertyPointerType, const void* DefaultValue, UObject* Parent, int32 PortFlags,
        UObject* ExportRootScope = nullptr) const = 0;
    virtual const TCHAR* ImportText_Internal(const TCHAR* Buffer, void* ContainerOrPropertyPtr,
        EPropertyPointerType PropertyPointerType, UObject* OwnerObject, int32 PortFlags,
        FOutputDevice* ErrorText) const = 0;
    COREUOBJECT_API bool ValidateImportFlags(uint32 PortFlags, FOutputDevice* ErrorText) const;

    /** The value address for either pointer type. */
    const void* PointerToValuePtr(const void* Pointer, EPropertyPointerType Type) const {
        return Type == EPropertyPointerType::Container ? ContainerPtrToValuePtr<void>(Pointer) : Pointer;
    }
    void* PointerToValuePtr(void* Pointer, EPropertyPointerType Type) const {
        return Type == EPropertyPointerType::Container ? ContainerPtrToValuePtr<void>(Pointer) : Pointer;
    }

private:
    void* ContainerVoidPtrToValuePtrInternal(void* ContainerPtr, int32 ArrayIndex) const {
        checkfSlow(ContainerPtr && ArrayIndex >= 0 && ArrayIndex < ArrayDim, TEXT("Bad access to %s"), *GetName());
        return static_cast<uint8*>(ContainerPtr) + Offset_Internal +
               static_cast<SIZE_T>(ElementSize) * static_cast<SIZE_T>(ArrayIndex);
    }
};

/** Value access shared by properties whose value is one C++ type. */
template <typename InTCppType>
class TPropertyTypeFundamentals {
public:
    typedef InTCppType TCppType;
    static constexpr int32 CPPSize = sizeof(TCppType);
    static constexpr int32 CPPAlignment = alignof(TCppType);

    static TCppType* GetPropertyValuePtr(void* A) { return static_cast<TCppType*>(A); }
    static const TCppType* GetPropertyValuePtr(const void* A) { return static_cast<const TCppType*>(A); }
    static const TCppType& GetPropertyValue(void const* A) { return *GetPropertyValuePtr(A); }
    static TCppType GetDefaultPropertyValue() { return TCppType(); }
    static TCppType GetOptionalPropertyValue(void const* B) {
        return B ? GetPropertyValue(B) : GetDefaultPropertyValue();
    }
    static void SetPropertyValue(void* A, const TCppType& Value) { *GetPropertyValuePtr(A) = Value; }
    static TCppType* InitializePropertyValue(void* A) { return new (A) TCppType(); }
    static void DestroyPropertyValue(void* A) { GetPropertyValuePtr(A)->~TCppType(); }

protected:
    /** Flags that follow from the type. */
    static EPropertyFlags GetComputedFlags() {
        return (std::is_trivially_copyable_v<TCppType> && std::is_trivially_destructible_v<TCppType>
                       ? CPF_IsPlainOldData
                       : CPF_None) |
               (std::is_trivially_destructible_v<TCppType> ? CPF_NoDestructor : CPF_None);
    }
};

/** A property whose value is one C++ type with default construction, assignment and destruction. */
template <typename InTCppType, class TInheritsFrom>
class TProperty : public TInheritsFrom, public TPropertyTypeFundamentals<InTCppType> {
public:
    typedef InTCppType TCppType;
    typedef TInheritsFrom Super;
    typedef TPropertyTypeFundamentals<InTCppType> TTypeFundamentals;

    TProperty(FFieldVariant InOwner, const FName& InName, EObjectFlags InObjectFlags)
        : TInheritsFrom(InOwner, InName, InObjectFlags) {}

    virtual int32 GetMinAlignment() const override { return TTypeFundamentals::CPPAlignment; }

    TCppType* GetPropertyValuePtr_InContainer(void* A, int32 ArrayIndex = 0) const {
        return TTypeFundamentals::GetPropertyValuePtr(this->template ContainerPtrToValuePtr<void>(A, ArrayIndex));
    }
    const TCppType& GetPropertyValue_InContainer(void const* A, int32 ArrayIndex = 0) const {
        return TTypeFundamentals::GetPropertyValue(this->template ContainerPtrToValuePtr<void>(A, ArrayIndex));
    }
    const TCppType* GetPropertyValuePtr_InContainer(void const* A, int32 ArrayIndex = 0) const {
        return TTypeFundamentals::GetPropertyValuePtr(this->template ContainerPtrToValuePtr<void>(A, ArrayIndex));
    }
    TCppType GetOptionalPropertyValue_InContainer(void const* B, int32 ArrayIndex = 0) const {
        return B ? GetPropertyValue_InContainer(B, ArrayIndex) : TTypeFundamentals::GetDefaultPropertyValue();
    }
    void SetPropertyValue_InContainer(void* A, const TCppType& Value, int32 ArrayIndex = 0) const {
        TTypeFundamentals::SetPropertyValue(this->template ContainerPtrToValuePtr<void>(A, ArrayIndex), Value);
    }

protected:
    virtual void LinkInternal() override {
        this->ElementSize = TTypeFundamentals::CPPSize;
        this->PropertyFlags |= TTypeFundamentals::GetComputedFlags();
    }
    virtual void CopyValuesInternal(void* Dest, void const* Src, int32 Count) const override {
        for (int32 Index = 0; Index < Count; ++Index) {
            TTypeFundamentals::GetPropertyValuePtr(Dest)[Index] = TTypeFundamentals::GetPropertyValuePtr(Src)[Index];
        }
    }
    virtual void ClearValueInternal(void* Data) const override {
        TTypeFundamentals::SetPropertyValue(Data, TTypeFundamentals::GetDefaultPropertyValue());
    }
    virtual void InitializeValueInternal(void* Dest) const override {
        for (int32 Index = 0; Index < this->ArrayDim; ++Index) {
            TTypeFundamentals::InitializePropertyValue(static_cast<uint8*>(Dest) + Index * this->ElementSize);
        }
    }
    virtual void DestroyValueInternal(void* Dest) const override {
        for (int32 Index = 0; Index < this->ArrayDim; ++Index) {
            TTypeFundamentals::DestroyPropertyValue(static_cast<uint8*>(Dest) + Index * this->ElementSize);
        }
    }
};

/** A TProperty whose type also has operator== and, where HashKind says so, GetTypeHash. */
template <typename InTCppType, class TInheritsFrom>
class TProperty_WithEquality : public TProperty<InTCppType, TInheritsFrom> {
public:
    typedef TProperty<InTCppType, TInheritsFrom> Super;
    typedef InTCppType TCppType;
    using typename Super::TTypeFundamentals;

    TProperty_WithEquality(FFieldVariant InOwner, const FName& InName, EObjectFlags InObjectFlags)
        : Super(InOwner, InName, InObjectFlags) {}
    virtual bool Identical(const void* A, const void* B, uint32 PortFlags) const override {
        if constexpr (requires(const InTCppType& Value) { static_cast<bool>(Value == Value); }) {
            return TTypeFundamentals::GetPropertyValue(A) == TTypeFundamentals::GetOptionalPropertyValue(B);
        } else {
            // Types without operator== (FText) compare in an override.
            check(false);
            return false;
        }
    }
};

/** Finds a property by name in a struct and its supers, or null. */
COREUOBJECT_API FProperty* FindFProperty_Internal(const UStruct* Owner, FName FieldName);
template <typename T>
T* FindFProperty(const UStruct* Owner, FName FieldName) {
    return CastField<T>(FindFProperty_Internal(Owner, FieldName));
}
template <typename T>
T* FindFProperty(const UStruct* Owner, const TCHAR* FieldName) {
    return FindFProperty<T>(Owner, FName(FieldName));
}
/** Finds a nested function, property class etc. by name. */
template <typename T>
T* FindUField(const UStruct* Owner, FName FieldName) {
    for (const UStruct* Struct = Owner; Struct; Struct = Struct->GetSuperStruct()) {
        for (UField* Field = Struct->Children; Field; Field = Field->Next) {
            if (Field->GetFName() == FieldName && Field->IsA<T>()) {
                return static_cast<T*>(Field);
            }
        }
    }
    return nullptr;
}
