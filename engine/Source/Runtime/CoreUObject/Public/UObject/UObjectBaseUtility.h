// SPDX-License-Identifier: MIT
// Flags, names, paths and type tests of objects. Mirrors Epic's "UObject/UObjectBaseUtility.h".
#pragma once

#include "UObject/UObjectArray.h"
#include "UObject/UObjectBase.h"

/** Separates a subobject from its top-level object in a path. */
#define SUBOBJECT_DELIMITER_ANSI ":"
#define SUBOBJECT_DELIMITER TEXT(":")
#define SUBOBJECT_DELIMITER_CHAR ':'

class UObjectBaseUtility : public UObjectBase {
public:
    // ---- flags

    FORCEINLINE void SetFlags(EObjectFlags NewFlags) { AtomicallySetFlags(NewFlags); }
    FORCEINLINE void ClearFlags(EObjectFlags FlagsToClear) { AtomicallyClearFlags(FlagsToClear); }
    FORCEINLINE bool HasAnyFlags(EObjectFlags FlagsToCheck) const { return (GetFlags() & FlagsToCheck) != 0; }
    FORCEINLINE bool HasAllFlags(EObjectFlags FlagsToCheck) const {
        return (GetFlags() & FlagsToCheck) == FlagsToCheck;
    }
    FORCEINLINE EObjectFlags GetMaskedFlags(EObjectFlags Mask = RF_AllFlags) const { return GetFlags() & Mask; }

    COREUOBJECT_API EInternalObjectFlags GetInternalFlags() const;
    COREUOBJECT_API bool HasAnyInternalFlags(EInternalObjectFlags FlagsToCheck) const;
    COREUOBJECT_API void SetInternalFlags(EInternalObjectFlags FlagsToSet) const;
    COREUOBJECT_API void ClearInternalFlags(EInternalObjectFlags FlagsToClear) const;
    COREUOBJECT_API bool AtomicallySetInternalFlags(EInternalObjectFlags FlagsToSet) const;
    COREUOBJECT_API bool AtomicallyClearInternalFlags(EInternalObjectFlags FlagsToClear) const;

    /** Marks the object for elimination: IsValid() turns false now, references are nulled by the next collection. */
    COREUOBJECT_API void MarkAsGarbage();
    COREUOBJECT_API void ClearGarbage();
    /** True between a collection's mark phase and the object's destruction. */
    FORCEINLINE bool IsUnreachable() const { return HasAnyInternalFlags(EInternalObjectFlags::Unreachable); }
    /** Keeps the object alive whatever refers to it. */
    COREUOBJECT_API void AddToRoot();
    COREUOBJECT_API void RemoveFromRoot();
    COREUOBJECT_API bool IsRooted() const;
    FORCEINLINE bool IsNative() const { return HasAnyInternalFlags(EInternalObjectFlags::Native); }

    // ---- names and paths

    COREUOBJECT_API FString GetName() const;
    COREUOBJECT_API void GetName(FString& ResultString) const;
    /** "Class /Package.Object:Sub": class name and path; with FullPackageName flag off the whole path is used anyway.
     */
    COREUOBJECT_API FString GetFullName(const UObject* StopOuter = nullptr) const;
    COREUOBJECT_API void GetFullName(FString& ResultString, const UObject* StopOuter = nullptr) const;
    /** "/Package.Object:Sub.SubSub", relative to StopOuter when given. */
    COREUOBJECT_API FString GetPathName(const UObject* StopOuter = nullptr) const;
    COREUOBJECT_API void GetPathName(const UObject* StopOuter, FString& ResultString) const;
    /** Name of the outermost package, class default objects included. */
    COREUOBJECT_API UPackage* GetOutermost() const;
    COREUOBJECT_API UPackage* GetPackage() const;
    COREUOBJECT_API UObject* GetOutermostObject() const;
    COREUOBJECT_API bool MarkPackageDirty() const;
    COREUOBJECT_API bool IsPackageExternal() const;

    // ---- outers

    /** Nearest outer of class Target. */
    COREUOBJECT_API UObject* GetTypedOuter(UClass* Target) const;
    template <typename T>
    T* GetTypedOuter() const {
        return static_cast<T*>(GetTypedOuter(T::StaticClass()));
    }
    /** True if SomeOuter is one of the outers. */
    COREUOBJECT_API bool IsIn(const UObject* SomeOuter) const;
    COREUOBJECT_API bool IsInOuter(const UObject* SomeOuter) const;
    COREUOBJECT_API bool IsInPackage(const UPackage* SomePackage) const;
    COREUOBJECT_API bool IsInA(const UClass* SomeBaseClass) const;
    /** True if the object's outermost object is in a memory package of its own; used by levels. */
    COREUOBJECT_API bool RootPackageHasAnyFlags(uint32 CheckFlagMask) const;

    // ---- type tests

    COREUOBJECT_API bool IsA(const UClass* SomeBase) const;
    template <class T>
    bool IsA() const {
        return IsA(T::StaticClass());
    }
    template <typename OtherClassType>
    bool IsA(OtherClassType SomeBase) const {
        return IsA(static_cast<const UClass*>(SomeBase));
    }
    /** Nearest class that both objects share. */
    COREUOBJECT_API UClass* FindNearestCommonBaseClass(UClass* TestClass) const;
    /** Address of the interface subobject of class InterfaceClass, or null. */
    COREUOBJECT_API void* GetInterfaceAddress(UClass* InterfaceClass);
    /** As GetInterfaceAddress, only for interfaces implemented in C++. */
    COREUOBJECT_API void* GetNativeInterfaceAddress(UClass* InterfaceClass);
    const void* GetNativeInterfaceAddress(UClass* InterfaceClass) const {
        return const_cast<UObjectBaseUtility*>(this)->GetNativeInterfaceAddress(InterfaceClass);
    }
    /** A default subobject of a class default object or archetype, or an instance of one. */
    COREUOBJECT_API bool IsDefaultSubobject() const;
    COREUOBJECT_API bool IsTemplate(EObjectFlags TemplateTypes = RF_ArchetypeObject | RF_ClassDefaultObject) const;

    // ---- linker compatibility: nothing is linked from files here

    int32 GetLinkerIndex() const { return INDEX_NONE; }

protected:
    UObjectBaseUtility() = default;
};

/** True for an object that is not null and not garbage. */
COREUOBJECT_API bool IsValid(const UObject* Test);
/** IsValid, and not going to be destroyed by a collection that is under way. */
FORCEINLINE UObject* GetValid(UObject* Test) { return IsValid(Test) ? Test : nullptr; }
COREUOBJECT_API bool IsValidChecked(const UObject* Test);

/** The name, also for null ("None"). */
COREUOBJECT_API FString GetNameSafe(const UObjectBaseUtility* Object);
COREUOBJECT_API FString GetPathNameSafe(const UObjectBaseUtility* Object);
COREUOBJECT_API FString GetFullNameSafe(const UObjectBaseUtility* Object);
