// SPDX-License-Identifier: MIT
// Name, outer and class tables. Sets are ordered by object index, so that every walk has the same order in every run.
#include "UObject/UObjectHash.h"

#include <set>
#include <unordered_map>

#include "ObjectSystem.h"

namespace {
struct FNameOuterHash {
    SIZE_T operator()(const FNameOuterKey& Key) const {
        return HashCombineFast(GetTypeHash(Key.Name), PointerHash(Key.Outer));
    }
};
struct FNameHash {
    SIZE_T operator()(const FName& Name) const { return GetTypeHash(Name); }
};
using FIndexSet = std::set<int32>;

struct FTables {
    std::unordered_map<FNameOuterKey, FIndexSet, FNameOuterHash> ByNameAndOuter;
    std::unordered_map<FName, FIndexSet, FNameHash> ByName;
    std::unordered_map<const UObjectBase*, FIndexSet> ByOuter;
    std::unordered_map<const UObjectBase*, FIndexSet> ByClass;
    std::unordered_map<const UClass*, TArray<UClass*>> Subclasses;
};
/** Lives until the process ends: objects outlive static destructors. */
FTables& Tables() {
    static FTables* const Instance = new FTables;
    return *Instance;
}

template <typename TMapType, typename TKey>
void EraseFrom(TMapType& Map, const TKey& Key, int32 Index) {
    auto Found = Map.find(Key);
    if (Found != Map.end()) {
        Found->second.erase(Index);
        if (Found->second.empty()) {
            Map.erase(Found);
        }
    }
}

UObject* ObjectAt(int32 Index) { return static_cast<UObject*>(GUObjectArray.IndexToObject(Index)->Object); }

bool Passes(const UObject* Object, const UClass* Class, bool bExactClass, EObjectFlags ExclusiveFlags,
    EInternalObjectFlags ExclusiveInternalFlags) {
    return !Object->HasAnyFlags(ExclusiveFlags) &&
           !Object->HasAnyInternalFlags(ExclusiveInternalFlags | EInternalObjectFlags::Unreachable) &&
           (!Class || (bExactClass ? Object->GetClass() == Class : Object->IsA(Class)));
}
} // namespace

void FObjectSystem::Hash(UObjectBase* Object) {
    FTables& Table = Tables();
    const int32 Index = static_cast<int32>(Object->GetUniqueID());
    Table.ByNameAndOuter[{Object->GetOuter(), Object->GetFName()}].insert(Index);
    Table.ByName[Object->GetFName()].insert(Index);
    if (Object->GetOuter()) {
        Table.ByOuter[Object->GetOuter()].insert(Index);
    }
    Table.ByClass[Object->GetClass()].insert(Index);
}

void FObjectSystem::Unhash(UObjectBase* Object) {
    FTables& Table = Tables();
    const int32 Index = static_cast<int32>(Object->GetUniqueID());
    EraseFrom(Table.ByNameAndOuter, FNameOuterKey{Object->GetOuter(), Object->GetFName()}, Index);
    EraseFrom(Table.ByName, Object->GetFName(), Index);
    EraseFrom(Table.ByOuter, static_cast<const UObjectBase*>(Object->GetOuter()), Index);
    EraseFrom(Table.ByClass, static_cast<const UObjectBase*>(Object->GetClass()), Index);
}

UObject* FObjectSystem::Find(const UClass* Class, const UObject* Outer, FName Name, bool bExactClass,
    EObjectFlags ExclusiveFlags, EInternalObjectFlags ExclusiveInternalFlags) {
    const FTables& Table = Tables();
    const auto Found = Table.ByNameAndOuter.find({Outer, Name});
    if (Found != Table.ByNameAndOuter.end()) {
        for (int32 Index : Found->second) {
            UObject* Object = ObjectAt(Index);
            if (Passes(Object, Class, bExactClass, ExclusiveFlags, ExclusiveInternalFlags)) {
                return Object;
            }
        }
    }
    return nullptr;
}

UObject* FObjectSystem::FindByName(const UClass* Class, FName Name, bool bExactClass, EObjectFlags ExclusiveFlags,
    EInternalObjectFlags ExclusiveInternalFlags, int32& OutNumFound) {
    OutNumFound = 0;
    UObject* First = nullptr;
    const FTables& Table = Tables();
    const auto Found = Table.ByName.find(Name);
    if (Found != Table.ByName.end()) {
        for (int32 Index : Found->second) {
            UObject* Object = ObjectAt(Index);
            if (Passes(Object, Class, bExactClass, ExclusiveFlags, ExclusiveInternalFlags)) {
                First = First ? First : Object;
                ++OutNumFound;
            }
        }
    }
    return First;
}

void FObjectSystem::CollectInners(const UObject* Outer, TArray<UObject*>& Out) {
    const FTables& Table = Tables();
    const auto Found = Table.ByOuter.find(Outer);
    if (Found != Table.ByOuter.end()) {
        for (int32 Index : Found->second) {
            Out.Add(ObjectAt(Index));
        }
    }
}

void FObjectSystem::CollectOfClass(const UClass* Class, TArray<UObject*>& Out) {
    const FTables& Table = Tables();
    const auto Found = Table.ByClass.find(Class);
    if (Found != Table.ByClass.end()) {
        for (int32 Index : Found->second) {
            Out.Add(ObjectAt(Index));
        }
    }
}

void FObjectSystem::NoteSuperClass(UClass* Class, UClass* Super) {
    if (Super) {
        Tables().Subclasses[Super].AddUnique(Class);
    }
}

const TArray<UClass*>& FObjectSystem::DirectSubclasses(const UClass* Class) {
    static const TArray<UClass*> None;
    const FTables& Table = Tables();
    const auto Found = Table.Subclasses.find(Class);
    return Found != Table.Subclasses.end() ? Found->second : None;
}

// ---------------------------------------------------------------------------------------------------------------------------

namespace {
void CollectClasses(const UClass* Class, bool bRecursive, TArray<UClass*>& Out) {
    for (UClass* Subclass : FObjectSystem::DirectSubclasses(Class)) {
        Out.Add(Subclass);
        if (bRecursive) {
            CollectClasses(Subclass, true, Out);
        }
    }
}
void KeepPassing(
    TArray<UObject*>& Objects, int32 First, EObjectFlags ExclusionFlags, EInternalObjectFlags ExclusionInternalFlags) {
    int32 Kept = First;
    for (int32 Index = First; Index < Objects.Num(); ++Index) {
        if (Passes(Objects[Index], nullptr, false, ExclusionFlags, ExclusionInternalFlags)) {
            Objects[Kept++] = Objects[Index];
        }
    }
    Objects.SetNum(Kept);
}
} // namespace

void GetDerivedClasses(const UClass* ClassToLookFor, TArray<UClass*>& Results, bool bRecursive) {
    CollectClasses(ClassToLookFor, bRecursive, Results);
}

void GetObjectsOfClass(const UClass* ClassToLookFor, TArray<UObject*>& Results, bool bIncludeDerivedClasses,
    EObjectFlags ExcludeFlags, EInternalObjectFlags ExclusionInternalFlags) {
    const int32 First = Results.Num();
    FObjectSystem::CollectOfClass(ClassToLookFor, Results);
    if (bIncludeDerivedClasses) {
        TArray<UClass*> Classes;
        CollectClasses(ClassToLookFor, true, Classes);
        for (const UClass* Class : Classes) {
            FObjectSystem::CollectOfClass(Class, Results);
        }
    }
    KeepPassing(Results, First, ExcludeFlags, ExclusionInternalFlags);
}

void ForEachObjectOfClass(const UClass* ClassToLookFor, TFunctionRef<void(UObject*)> Operation,
    bool bIncludeDerivedClasses, EObjectFlags ExcludeFlags, EInternalObjectFlags ExclusionInternalFlags) {
    TArray<UObject*> Objects;
    GetObjectsOfClass(ClassToLookFor, Objects, bIncludeDerivedClasses, ExcludeFlags, ExclusionInternalFlags);
    for (UObject* Object : Objects) {
        Operation(Object);
    }
}

void GetObjectsWithOuter(const UObject* Outer, TArray<UObject*>& Results, bool bIncludeNestedObjects,
    EObjectFlags ExclusionFlags, EInternalObjectFlags ExclusionInternalFlags) {
    checkf(Outer, TEXT("GetObjectsWithOuter needs an outer"));
    const int32 First = Results.Num();
    FObjectSystem::CollectInners(Outer, Results);
    if (bIncludeNestedObjects) {
        for (int32 Index = First; Index < Results.Num(); ++Index) {
            FObjectSystem::CollectInners(Results[Index], Results);
        }
    }
    KeepPassing(Results, First, ExclusionFlags, ExclusionInternalFlags);
}

void ForEachObjectWithOuter(const UObject* Outer, TFunctionRef<void(UObject*)> Operation, bool bIncludeNestedObjects,
    EObjectFlags ExclusionFlags, EInternalObjectFlags ExclusionInternalFlags) {
    TArray<UObject*> Objects;
    GetObjectsWithOuter(Outer, Objects, bIncludeNestedObjects, ExclusionFlags, ExclusionInternalFlags);
    for (UObject* Object : Objects) {
        Operation(Object);
    }
}

void GetObjectsWithPackage(const UPackage* Package, TArray<UObject*>& Results, bool bIncludeNestedObjects,
    EObjectFlags ExclusionFlags, EInternalObjectFlags ExclusionInternalFlags) {
    GetObjectsWithOuter(Package, Results, bIncludeNestedObjects, ExclusionFlags, ExclusionInternalFlags);
}

UObject* FindObjectWithOuter(const UObject* Outer, const UClass* ClassToLookFor, FName NameToLookFor) {
    if (!NameToLookFor.IsNone()) {
        return FObjectSystem::Find(ClassToLookFor, Outer, NameToLookFor, false, RF_NoFlags, EInternalObjectFlags::None);
    }
    TArray<UObject*> Inners;
    FObjectSystem::CollectInners(Outer, Inners);
    for (UObject* Object : Inners) {
        if (Passes(Object, ClassToLookFor, false, RF_NoFlags, EInternalObjectFlags::None)) {
            return Object;
        }
    }
    return nullptr;
}
