// SPDX-License-Identifier: MIT
// Internals of the object system: creation of bare objects, name tables, native classes. Private to the module.
#pragma once

#include "CoreMinimal.h"
#include "UObject/Class.h"
#include "UObject/Object.h"
#include "UObject/Package.h"
#include "UObject/ReferenceCollector.h"

class FGCObject;

/** What makes the UClass object of a C++ class, before its properties are known. */
struct FNativeClassParams {
    /** Slot that StaticClass() returns; filled at once, so that circular requests end. */
    UClass** Slot;
    /** "/Script/Module" */
    const TCHAR* PackageName;
    /** Name without prefix letter. */
    const TCHAR* Name;
    SIZE_T Size;
    SIZE_T Alignment;
    EClassFlags ClassFlags;
    EClassCastFlags ClassCastFlags;
    const TCHAR* ConfigName;
    UClass::ClassConstructorType Constructor;
    UClass::ClassAddReferencedObjectsType AddReferencedObjects;
    /** Null for UObject. */
    UClass* (*SuperClass)();
    UClass* (*WithinClass)();
    void (*RegisterNatives)();
};

struct FObjectSystem {
    /** Makes the bare UClass of a C++ class with its super classes and package. */
    static void CreateNativeClass(const FNativeClassParams& Params);
    /** The package of that name, created rooted and with PKG_CompiledIn if missing. */
    static UPackage* FindOrCreateNativePackage(FName Name);

    /** Zeroed memory for an object. */
    static void* AllocateObject(SIZE_T Size, SIZE_T Alignment);
    /** Identity for the object whose C++ constructor runs next on this thread. */
    static void SetNextIdentity(
        const UClass* Class, UObject* Outer, FName Name, EObjectFlags Flags, EInternalObjectFlags InternalFlags);
    /** Runs the destructor and gives up slot and memory. */
    static void DestroyAndFree(UObject* Object);
    /** As DestroyAndFree but keeps the memory, for an object that is replaced in place. */
    static void DestroyInPlace(UObject* Object);

    // ---- name tables

    static void Hash(UObjectBase* Object);
    static void Unhash(UObjectBase* Object);
    static UObject* Find(const UClass* Class, const UObject* Outer, FName Name, bool bExactClass,
        EObjectFlags ExclusiveFlags, EInternalObjectFlags ExclusiveInternalFlags);
    /** First object of that name with any outer. */
    static UObject* FindByName(const UClass* Class, FName Name, bool bExactClass, EObjectFlags ExclusiveFlags,
        EInternalObjectFlags ExclusiveInternalFlags, int32& OutNumFound);
    static void CollectInners(const UObject* Outer, TArray<UObject*>& Out);
    static void CollectOfClass(const UClass* Class, TArray<UObject*>& Out);
    static void NoteSuperClass(UClass* Class, UClass* Super);
    static const TArray<UClass*>& DirectSubclasses(const UClass* Class);

    // ---- access to private parts of objects

    static void SetIdentity(UObjectBase* Object, UClass* Class, UObject* Outer) {
        Object->ClassPrivate = Class;
        Object->OuterPrivate = Outer;
    }
    static void SetName(UObjectBase* Object, FName Name, UObject* Outer) {
        Object->NamePrivate = Name;
        Object->OuterPrivate = Outer;
    }
    static UObject*& OuterRef(UObjectBase* Object) { return Object->OuterPrivate; }
    static UObject*& DefaultObjectRef(UClass* Class) { return reinterpret_cast<UObject*&>(Class->ClassDefaultObject); }
    static TMap<FName, UFunction*>& FunctionMap(UClass* Class) { return Class->FuncMap; }

    /** C++ objects that hold references. */
    static TArray<FGCObject*>& GCObjects();
    /** Depth of constructors on this thread. */
    static int32& ConstructorDepth();
    /** Called when an object's memory goes: side tables forget it. */
    static void ForgetObject(const UObject* Object);
    /** True once UClass and UPackage describe themselves. */
    static bool bMetaClassesReady;
};

/** A map key for a name below an outer. */
struct FNameOuterKey {
    const UObjectBase* Outer;
    FName Name;
    bool operator==(const FNameOuterKey& Other) const { return Outer == Other.Outer && Name == Other.Name; }
};
