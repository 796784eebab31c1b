// SPDX-License-Identifier: MIT
// FField, the base of properties: fields that are no objects. Mirrors Epic's "UObject/Field.h".
#pragma once

#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"
#include "UObject/UObjectGlobals.h"
#include "Templates/Casts.h"

class FField;
class FFieldClass;
class FFieldVariant;
class FReferenceCollector;
class UField;
class UStruct;

/** The class of a field: name, super class, cast bits. */
class FFieldClass {
public:
    typedef FField* (*ConstructFn)(const FFieldVariant& InOwner, const FName& InName, EObjectFlags InObjectFlags);

    COREUOBJECT_API FFieldClass(
        const TCHAR* InCPPName, uint64 InId, uint64 InCastFlags, FFieldClass* InSuperClass, ConstructFn InConstruct);

    /** Name without the prefix F ("IntProperty"). */
    FString GetName() const { return Name.ToString(); }
    FName GetFName() const { return Name; }
    uint64 GetId() const { return Id; }
    uint64 GetCastFlags() const { return CastFlags; }
    bool HasAnyCastFlags(const uint64 InCastFlags) const { return (CastFlags & InCastFlags) != 0; }
    bool HasAllCastFlags(const uint64 InCastFlags) const { return (CastFlags & InCastFlags) == InCastFlags; }
    bool IsChildOf(const FFieldClass* InClass) const {
        for (const FFieldClass* Class = this; Class; Class = Class->SuperClass) {
            if (Class == InClass) {
                return true;
            }
        }
        return false;
    }
    FFieldClass* GetSuperClass() const { return SuperClass; }
    FField* Construct(const FFieldVariant& InOwner, const FName& InName, EObjectFlags InFlags = RF_NoFlags) const {
        return ConstructFunction ? ConstructFunction(InOwner, InName, InFlags) : nullptr;
    }
    FText GetDisplayNameText() const { return FText::FromString(GetName()); }
    /** All field classes of the process. */
    static COREUOBJECT_API TArray<FFieldClass*>& GetAllFieldClasses();
    /** Field class by name without prefix, or null. */
    static COREUOBJECT_API FFieldClass* FindFieldClass(FName InName);

private:
    FName Name;
    uint64 Id;
    uint64 CastFlags;
    FFieldClass* SuperClass;
    ConstructFn ConstructFunction;
};

/** A pointer to either a field or an object. */
class FFieldVariant {
public:
    FFieldVariant() = default;
    FFieldVariant(TYPE_OF_NULLPTR) {}
    FFieldVariant(const FField* InField) : Pointer(const_cast<FField*>(InField)), bIsUObject(false) {}
    template <typename T>
        requires std::is_convertible_v<T*, const UObject*>
    FFieldVariant(T* InObject)
        : Pointer(const_cast<UObject*>(static_cast<const UObject*>(InObject))), bIsUObject(InObject != nullptr) {}
    bool IsUObject() const { return bIsUObject; }
    bool IsValid() const { return Pointer != nullptr; }
    explicit operator bool() const { return IsValid(); }
    FField* ToField() const { return bIsUObject ? nullptr : static_cast<FField*>(Pointer); }
    UObject* ToUObject() const { return bIsUObject ? static_cast<UObject*>(Pointer) : nullptr; }
    FField* ToFieldUnsafe() const { return static_cast<FField*>(Pointer); }
    UObject* ToUObjectUnsafe() const { return static_cast<UObject*>(Pointer); }
    void* GetRawPointer() const { return Pointer; }
    template <typename T>
    bool IsA() const;
    template <typename T>
    T* Get() const;
    COREUOBJECT_API FFieldVariant GetOwnerVariant() const;
    COREUOBJECT_API FString GetName() const;
    COREUOBJECT_API FName GetFName() const;
    COREUOBJECT_API FString GetPathName() const;
    COREUOBJECT_API FString GetFullName() const;
    bool operator==(const FFieldVariant& Other) const { return Pointer == Other.Pointer; }

private:
    void* Pointer = nullptr;
    bool bIsUObject = false;
};

#define DECLARE_FIELD_API(TClass, TSuperClass, TStaticFlags, TRequiredAPI)                                             \
private:                                                                                                               \
    TClass& operator=(TClass&&) = delete;                                                                              \
    TClass& operator=(const TClass&) = delete;                                                                         \
                                                                                                                       \
public:                                                                                                                \
    typedef TSuperClass Super;                                                                                         \
    typedef TClass ThisClass;                                                                                          \
    TClass(FFieldVariant InOwner, const FName& InName, EObjectFlags InObjectFlags)                                     \
        : Super(InOwner, InName, InObjectFlags) {                                                                      \
        SetFieldClass(StaticClass());                                                                                  \
    }                                                                                                                  \
    TRequiredAPI static FFieldClass* StaticClass();                                                                    \
    TRequiredAPI static FField* Construct(                                                                             \
        const FFieldVariant& InOwner, const FName& InName, EObjectFlags InObjectFlags);                                \
    inline static constexpr uint64 StaticClassCastFlagsPrivate() { return uint64(TStaticFlags); }                      \
    inline static constexpr uint64 StaticClassCastFlags() {                                                            \
        return uint64(TStaticFlags) | uint64(Super::StaticClassCastFlags());                                           \
    }
#define DECLARE_FIELD(TClass, TSuperClass, TStaticFlags)                                                               \
    DECLARE_FIELD_API(TClass, TSuperClass, TStaticFlags, COREUOBJECT_API)

#define IMPLEMENT_FIELD(TClass)                                                                                        \
    FField* TClass::Construct(const FFieldVariant& InOwner, const FName& InName, EObjectFlags InFlags) {               \
        return new TClass(InOwner, InName, InFlags);                                                                   \
    }                                                                                                                  \
    FFieldClass* TClass::StaticClass() {                                                                               \
        static FFieldClass StaticFieldClass(&TEXT(#TClass)[1], TClass::StaticClassCastFlagsPrivate(),                  \
            TClass::StaticClassCastFlags(), TClass::Super::StaticClass(), &TClass::Construct);                         \
        return &StaticFieldClass;                                                                                      \
    }
#define IMPLEMENT_ABSTRACT_FIELD(TClass)                                                                               \
    FField* TClass::Construct(const FFieldVariant&, const FName&, EObjectFlags) { return nullptr; }                    \
    FFieldClass* TClass::StaticClass() {                                                                               \
        static FFieldClass StaticFieldClass(&TEXT(#TClass)[1], TClass::StaticClassCastFlagsPrivate(),                  \
            TClass::StaticClassCastFlags(), TClass::Super::StaticClass(), nullptr);                                    \
        return &StaticFieldClass;                                                                                      \
    }

/** Base class of properties. Owned by a UStruct or by another field. */
class FField {
public:
    typedef FField Super;
    typedef FField ThisClass;

    COREUOBJECT_API FField(FFieldVariant InOwner, const FName& InName, EObjectFlags InObjectFlags);
    COREUOBJECT_API virtual ~FField();
    FField(const FField&) = delete;
    FField& operator=(const FField&) = delete;

    static COREUOBJECT_API FFieldClass* StaticClass();
    static constexpr uint64 StaticClassCastFlagsPrivate() { return uint64(CASTCLASS_None); }
    static constexpr uint64 StaticClassCastFlags() { return uint64(CASTCLASS_None); }

    /** Next field of the same owner. */
    FField* Next = nullptr;
    FFieldVariant Owner;
    FName NamePrivate;
    EObjectFlags FlagsPrivate = RF_NoFlags;

    FFieldClass* GetClass() const { return ClassPrivate; }
    uint64 GetCastFlags() const { return ClassPrivate->GetCastFlags(); }
    bool IsA(const FFieldClass* FieldType) const { return ClassPrivate->IsChildOf(FieldType); }
    template <typename T>
    bool IsA() const {
        if constexpr (T::StaticClassCastFlagsPrivate() != uint64(CASTCLASS_None)) {
            return ClassPrivate->HasAnyCastFlags(T::StaticClassCastFlagsPrivate());
        } else {
            return IsA(T::StaticClass());
        }
    }
    bool HasAnyCastFlags(const uint64 InCastFlags) const { return ClassPrivate->HasAnyCastFlags(InCastFlags); }

    FFieldVariant GetOwnerVariant() const { return Owner; }
    /** The struct or class that holds the field, seen through enclosing fields. */
    COREUOBJECT_API UStruct* GetOwnerStruct() const;
    COREUOBJECT_API UClass* GetOwnerClass() const;
    COREUOBJECT_API UObject* GetOwnerUObject() const;
    COREUOBJECT_API UField* GetOwnerUField() const;
    COREUOBJECT_API UPackage* GetOutermost() const;
    template <typename T>
    T* GetOwner() const {
        if constexpr (std::is_base_of_v<UObject, T>) {
            return Cast<T>(Owner.ToUObject());
        } else {
            return Owner.IsUObject() || !Owner.IsValid() || !Owner.ToField()->IsA<T>()
                       ? nullptr
                       : static_cast<T*>(Owner.ToField());
        }
    }
    template <typename T>
    T* GetOwnerChecked() const {
        T* Result = GetOwner<T>();
        check(Result);
        return Result;
    }
    bool IsIn(const UObject* InOwner) const { return GetOwnerUObject() == InOwner; }

    FName GetFName() const { return NamePrivate; }
    FString GetName() const { return NamePrivate.ToString(); }
    void GetName(FString& OutName) const { NamePrivate.ToString(OutName); }
    /** "Owner path:Name" */
    COREUOBJECT_API FString GetPathName(const UObject* StopOuter = nullptr) const;
    COREUOBJECT_API FString GetFullName() const;
    /** As written in C++: properties with a _DEPRECATED suffix lost it, this keeps the plain name. */
    FString GetAuthoredName() const { return GetName(); }
    EObjectFlags GetFlags() const { return FlagsPrivate; }
    bool HasAnyFlags(EObjectFlags FlagsToCheck) const { return (FlagsPrivate & FlagsToCheck) != 0; }
    bool HasAllFlags(EObjectFlags FlagsToCheck) const { return (FlagsPrivate & FlagsToCheck) == FlagsToCheck; }
    void SetFlags(EObjectFlags NewFlags) { FlagsPrivate |= NewFlags; }
    void ClearFlags(EObjectFlags NewFlags) { FlagsPrivate &= ~NewFlags; }
    bool IsNative() const { return true; }

    virtual void PostDuplicate(const FField& InField) {}
    virtual void GetInnerFields(TArray<FField*>& OutFields) {}
    virtual FField* GetInnerFieldByName(const FName& InName) { return nullptr; }
    virtual void AddReferencedObjects(FReferenceCollector& Collector) {}

#if WITH_METADATA
    COREUOBJECT_API const FString* FindMetaData(const TCHAR* Key) const;
    COREUOBJECT_API const FString* FindMetaData(const FName& Key) const;
    bool HasMetaData(const TCHAR* Key) const { return FindMetaData(Key) != nullptr; }
    bool HasMetaData(const FName& Key) const { return FindMetaData(Key) != nullptr; }
    /** The value, or an empty string. */
    COREUOBJECT_API const FString& GetMetaData(const TCHAR* Key) const;
    COREUOBJECT_API const FString& GetMetaData(const FName& Key) const;
    COREUOBJECT_API bool GetBoolMetaData(const FName& Key) const;
    bool GetBoolMetaData(const TCHAR* Key) const { return GetBoolMetaData(FName(Key)); }
    COREUOBJECT_API int32 GetIntMetaData(const FName& Key) const;
    COREUOBJECT_API float GetFloatMetaData(const FName& Key) const;
    COREUOBJECT_API void SetMetaData(const FName& Key, const FString& InValue);
    void SetMetaData(const TCHAR* Key, const FString& InValue) { SetMetaData(FName(Key), InValue); }
    COREUOBJECT_API void RemoveMetaData(const FName& Key);
    /** All metadata, or null if there is none. */
    const TMap<FName, FString>* GetMetaDataMap() const { return MetaDataMap; }
    COREUOBJECT_API FText GetDisplayNameText() const;
    COREUOBJECT_API FText GetToolTipText(bool bShortTooltip = false) const;
#endif

private:
    FFieldClass* ClassPrivate = nullptr;
#if WITH_METADATA
    TMap<FName, FString>* MetaDataMap = nullptr;
#endif
    friend class FProperty;

protected:
    void SetFieldClass(FFieldClass* InClass) { ClassPrivate = InClass; }
};

/** Src as T, or null. */
template <typename T>
FORCEINLINE T* CastField(FField* Src) {
    return Src && Src->IsA<T>() ? static_cast<T*>(Src) : nullptr;
}
template <typename T>
FORCEINLINE const T* CastField(const FField* Src) {
    return Src && Src->IsA<T>() ? static_cast<const T*>(Src) : nullptr;
}
template <typename T>
FORCEINLINE T* CastFieldChecked(FField* Src) {
    T* Result = CastField<T>(Src);
    checkf(!Src || Result, TEXT("CastFieldChecked: field '%s' is a %s"), *Src->GetName(), *Src->GetClass()->GetName());
    return Result;
}
template <typename T>
FORCEINLINE const T* CastFieldChecked(const FField* Src) {
    return CastFieldChecked<T>(const_cast<FField*>(Src));
}
/** Src as T if its class is exactly T. */
template <typename T>
FORCEINLINE T* ExactCastField(FField* Src) {
    return Src && Src->GetClass() == T::StaticClass() ? static_cast<T*>(Src) : nullptr;
}
template <typename T>
FORCEINLINE const T* ExactCastField(const FField* Src) {
    return ExactCastField<T>(const_cast<FField*>(Src));
}

template <typename T>
bool FFieldVariant::IsA() const {
    if (!Pointer) {
        return false;
    }
    if constexpr (std::is_base_of_v<UObject, T>) {
        return bIsUObject && ToUObject()->IsA<T>();
    } else {
        return !bIsUObject && ToField()->template IsA<T>();
    }
}
template <typename T>
T* FFieldVariant::Get() const {
    return IsA<T>() ? static_cast<T*>(Pointer) : nullptr;
}
COREUOBJECT_API FString GetFullNameSafe(const FField* InField);
COREUOBJECT_API FString GetPathNameSafe(const FField* InField);
