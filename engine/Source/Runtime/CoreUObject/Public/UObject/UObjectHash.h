// SPDX-License-Identifier: MIT
// Look-ups by class and outer. Mirrors Epic's "UObject/UObjectHash.h".
#pragma once

#include "Templates/Function.h"
#include "UObject/Class.h"
#include "UObject/ObjectMacros.h"

/** Objects of a class (and its children, unless told otherwise). The default excludes class default objects, as UE's.
 */
COREUOBJECT_API void GetObjectsOfClass(const UClass* ClassToLookFor, TArray<UObject*>& Results,
    bool bIncludeDerivedClasses = true, EObjectFlags ExcludeFlags = RF_ClassDefaultObject,
    EInternalObjectFlags ExclusionInternalFlags = EInternalObjectFlags::None);
COREUOBJECT_API void ForEachObjectOfClass(const UClass* ClassToLookFor, TFunctionRef<void(UObject*)> Operation,
    bool bIncludeDerivedClasses = true, EObjectFlags ExcludeFlags = RF_ClassDefaultObject,
    EInternalObjectFlags ExclusionInternalFlags = EInternalObjectFlags::None);
/** Objects whose outer is Outer, or that are anywhere below it. */
COREUOBJECT_API void GetObjectsWithOuter(const UObject* Outer, TArray<UObject*>& Results,
    bool bIncludeNestedObjects = true, EObjectFlags ExclusionFlags = RF_NoFlags,
    EInternalObjectFlags ExclusionInternalFlags = EInternalObjectFlags::None);
COREUOBJECT_API void ForEachObjectWithOuter(const UObject* Outer, TFunctionRef<void(UObject*)> Operation,
    bool bIncludeNestedObjects = true, EObjectFlags ExclusionFlags = RF_NoFlags,
    EInternalObjectFlags ExclusionInternalFlags = EInternalObjectFlags::None);
COREUOBJECT_API void GetObjectsWithPackage(const UPackage* Package, TArray<UObject*>& Results,
    bool bIncludeNestedObjects = true, EObjectFlags ExclusionFlags = RF_NoFlags,
    EInternalObjectFlags ExclusionInternalFlags = EInternalObjectFlags::None);
/** Object of that name whose outer is Outer, of class ClassToLookFor (or any for null). */
COREUOBJECT_API UObject* FindObjectWithOuter(
    const UObject* Outer, const UClass* ClassToLookFor = nullptr, FName NameToLookFor = NAME_None);
