// SPDX-License-Identifier: MIT
// The root of all objects: identity (class, name, outer, flags, index). Mirrors Epic's "UObject/UObjectBase.h".
#pragma once

#include "CoreMinimal.h"
#include "UObject/ObjectMacros.h"

/** Low level implementation of UObject; not for direct use in game code. */
class UObjectBase {
public:
    COREUOBJECT_API virtual ~UObjectBase();

    /** True if the memory still looks like a live object: it is in GUObjectArray under its own index. */
    COREUOBJECT_API bool IsValidLowLevel() const;
    /** As IsValidLowLevel, with less trust in the pointer (alignment, class). bRecursive checks the class too. */
    COREUOBJECT_API bool IsValidLowLevelFast(bool bRecursive = true) const;
    /** Index into GUObjectArray. */
    FORCEINLINE uint32 GetUniqueID() const { return static_cast<uint32>(InternalIndex); }
    FORCEINLINE UClass* GetClass() const { return ClassPrivate; }
    FORCEINLINE UObject* GetOuter() const { return OuterPrivate; }
    FORCEINLINE FName GetFName() const { return NamePrivate; }
    FORCEINLINE EObjectFlags GetFlags() const { return ObjectFlags; }
    /** Sets flags without any of the bookkeeping that SetFlags users expect; for the object system. */
    FORCEINLINE void AtomicallySetFlags(EObjectFlags FlagsToAdd) { ObjectFlags |= FlagsToAdd; }
    FORCEINLINE void AtomicallyClearFlags(EObjectFlags FlagsToClear) { ObjectFlags &= ~FlagsToClear; }
    /** The package that holds the object when it is not the outermost outer (one file per actor); null here. */
    UPackage* GetExternalPackage() const { return nullptr; }

    /** Marks an object pointer as referenced by the collector of the current thread; no-op without incremental GC. */
    void MarkAsReachable() const {}

protected:
    /** Takes class, name, outer and flags from the construction that is under way on this thread. */
    COREUOBJECT_API UObjectBase();

    /** Moves the object in the name tables. Outer null keeps the outer. */
    COREUOBJECT_API void LowLevelRename(FName NewName, UObject* NewOuter = nullptr);
    FORCEINLINE void SetFlagsTo(EObjectFlags NewFlags) { ObjectFlags = NewFlags; }
    COREUOBJECT_API void SetClass(UClass* NewClass);

private:
    EObjectFlags ObjectFlags;
    int32 InternalIndex;
    UClass* ClassPrivate;
    FName NamePrivate;
    UObject* OuterPrivate;

    friend class FUObjectArray;
    friend struct FObjectSystem;
    UObjectBase(const UObjectBase&) = delete;
    UObjectBase& operator=(const UObjectBase&) = delete;
};

/** True once the object system works (the metaclasses exist). */
COREUOBJECT_API bool UObjectInitialized();

/** Creates what newly loaded modules registered: packages, enums, structs, classes, then class default objects. */
COREUOBJECT_API void ProcessNewlyLoadedUObjects(FName Package = NAME_None, bool bCanProcessNewlyLoadedObjects = true);
