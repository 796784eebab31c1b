// SPDX-License-Identifier: MIT
// Iteration over all objects. Mirrors Epic's "UObject/UObjectIterator.h".
#pragma once

#include "UObject/Class.h"
#include "UObject/UObjectHash.h"

/** Walks the whole object table, unreachable objects left out. Objects made while it runs may or may not be visited. */
class FThreadSafeObjectIterator {
public:
    explicit FThreadSafeObjectIterator(UClass* InClass = UObject::StaticClass(), bool bOnlyGCedObjects = false,
        EObjectFlags AdditionalExclusionFlags = RF_ClassDefaultObject,
        EInternalObjectFlags InInternalExclusionFlags = EInternalObjectFlags::None)
        : Class(InClass), ExclusionFlags(AdditionalExclusionFlags),
          InternalExclusionFlags(InInternalExclusionFlags | EInternalObjectFlags::Unreachable) {
        Advance();
    }
    void operator++() { Advance(); }
    UObject* operator*() const { return Object; }
    UObject* operator->() const { return Object; }
    explicit operator bool() const { return Object != nullptr; }
    bool operator!() const { return Object == nullptr; }
    bool operator==(const FThreadSafeObjectIterator& Other) const { return Object == Other.Object; }

protected:
    void Advance() {
        Object = nullptr;
        while (++Index < GUObjectArray.GetObjectArrayNum()) {
            FUObjectItem* Item = GUObjectArray.IndexToObject(Index);
            if (Item->Object && !Item->HasAnyFlags(InternalExclusionFlags)) {
                UObject* Candidate = static_cast<UObject*>(Item->Object);
                if (!Candidate->HasAnyFlags(ExclusionFlags) && Candidate->GetClass() && Candidate->IsA(Class)) {
                    Object = Candidate;
                    return;
                }
            }
        }
    }

private:
    UClass* Class;
    EObjectFlags ExclusionFlags;
    EInternalObjectFlags InternalExclusionFlags;
    int32 Index = -1;
    UObject* Object = nullptr;
};
using FUObjectIterator = FThreadSafeObjectIterator;
using FRawObjectIterator = FThreadSafeObjectIterator;

/** All objects of class T (class default objects left out). `TObjectIterator<UClass>` walks all classes. */
template <class T>
class TObjectIterator {
public:
    explicit TObjectIterator(EObjectFlags AdditionalExclusionFlags = RF_ClassDefaultObject,
        bool bIncludeDerivedClasses = true,
        EInternalObjectFlags InInternalExclusionFlags = EInternalObjectFlags::None) {
        GetObjectsOfClass(T::StaticClass(), Objects, bIncludeDerivedClasses, AdditionalExclusionFlags,
            InInternalExclusionFlags | EInternalObjectFlags::Unreachable);
        Weak.Reserve(Objects.Num());
        for (UObject* Object : Objects) {
            Weak.Add(FWeakObjectPtr(Object));
        }
        SkipDead();
    }
    explicit operator bool() const { return Index < Objects.Num(); }
    bool operator!() const { return !static_cast<bool>(*this); }
    void operator++() {
        ++Index;
        SkipDead();
    }
    T* operator*() const { return static_cast<T*>(Objects[Index]); }
    T* operator->() const { return static_cast<T*>(Objects[Index]); }
    bool operator==(const TObjectIterator& Other) const {
        return static_cast<bool>(*this) == static_cast<bool>(Other) && (!*this || **this == *Other);
    }

private:
    /** Objects may be destroyed while the walk is under way. */
    void SkipDead() {
        while (Index < Objects.Num() && !Weak[Index].Get(true)) {
            ++Index;
        }
    }
    TArray<UObject*> Objects;
    TArray<FWeakObjectPtr> Weak;
    int32 Index = 0;
};

/** Range-for over TObjectIterator. */
template <class T>
struct TObjectRange {
    explicit TObjectRange(EObjectFlags AdditionalExclusionFlags = RF_ClassDefaultObject,
        bool bIncludeDerivedClasses = true, EInternalObjectFlags InInternalExclusionFlags = EInternalObjectFlags::None)
        : Iterator(AdditionalExclusionFlags, bIncludeDerivedClasses, InInternalExclusionFlags) {}
    struct FEnd {};
    struct FIterator {
        TObjectIterator<T>& It;
        T* operator*() const { return *It; }
        void operator++() { ++It; }
        bool operator!=(FEnd) const { return static_cast<bool>(It); }
    };
    FIterator begin() { return {Iterator}; }
    FEnd end() { return {}; }

private:
    TObjectIterator<T> Iterator;
};
