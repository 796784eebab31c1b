// SPDX-License-Identifier: MIT
#include "Containers/Map.h"

int32 FScriptSparseArray::AddUninitialized(const FScriptSparseArrayLayout& Layout) {
    int32 Index;
    if (NumFreeIndices) {
        Index = FirstFreeIndex;
        FirstFreeIndex = GetFreeListLink(Index, Layout)->NextFreeIndex;
        --NumFreeIndices;
        if (NumFreeIndices) {
            GetFreeListLink(FirstFreeIndex, Layout)->PrevFreeIndex = INDEX_NONE;
        }
        AllocationFlags[Index] = true;
    } else {
        Index = Data.Add(1, static_cast<SIZE_T>(Layout.Size), static_cast<uint32>(Layout.Alignment));
        AllocationFlags.Add(true);
    }
    return Index;
}

void FScriptSparseArray::RemoveAtUninitialized(const FScriptSparseArrayLayout& Layout, int32 Index, int32 Count) {
    for (; Count > 0; --Count, ++Index) {
        check(IsValidIndex(Index));
        if (NumFreeIndices) {
            GetFreeListLink(FirstFreeIndex, Layout)->PrevFreeIndex = Index;
        }
        FFreeListLink* Link = GetFreeListLink(Index, Layout);
        Link->PrevFreeIndex = INDEX_NONE;
        Link->NextFreeIndex = NumFreeIndices > 0 ? FirstFreeIndex : INDEX_NONE;
        FirstFreeIndex = Index;
        ++NumFreeIndices;
        AllocationFlags[Index] = false;
    }
}

FScriptSetLayout FScriptSet::GetScriptLayout(int32 ElementSize, int32 ElementAlignment) {
    // TSetElement<T> is { T Value; int32 HashNextId; int32 HashIndex; }.
    FScriptSetLayout Result;
    const int32 Alignment = ElementAlignment > 4 ? ElementAlignment : 4;
    Result.HashNextIdOffset = Align(ElementSize, 4);
    Result.HashIndexOffset = Result.HashNextIdOffset + 4;
    Result.Size = Align(Result.HashIndexOffset + 4, static_cast<uint64>(Alignment));
    Result.SparseArrayLayout = FScriptSparseArray::GetScriptLayout(Result.Size, Alignment);
    return Result;
}

FSetElementId& FScriptSet::GetHashNextIdRef(int32 Index, const FScriptSetLayout& Layout) const {
    void* Slot = const_cast<FScriptSet*>(this)->GetData(Index, Layout);
    return *reinterpret_cast<FSetElementId*>(static_cast<uint8*>(Slot) + Layout.HashNextIdOffset);
}

int32& FScriptSet::GetHashIndexRef(int32 Index, const FScriptSetLayout& Layout) const {
    void* Slot = const_cast<FScriptSet*>(this)->GetData(Index, Layout);
    return *reinterpret_cast<int32*>(static_cast<uint8*>(Slot) + Layout.HashIndexOffset);
}

void FScriptSet::LinkElement(int32 Index, const FScriptSetLayout& Layout, uint32 KeyHash) {
    const uint32 HashIndex = KeyHash & (static_cast<uint32>(HashSize) - 1);
    GetHashIndexRef(Index, Layout) = static_cast<int32>(HashIndex);
    GetHashNextIdRef(Index, Layout) = Bucket(HashIndex);
    Bucket(HashIndex) = FSetElementId::FromInteger(Index);
}

void FScriptSet::MoveAssign(FScriptSet& Other, const FScriptSetLayout& Layout) {
    if (this != &Other) {
        Elements.MoveAssign(Other.Elements, Layout.SparseArrayLayout);
        Hash.MoveToEmpty(Other.Hash);
        HashSize = Other.HashSize;
        Other.HashSize = 0;
    }
}

void FScriptSet::Empty(int32 Slack, const FScriptSetLayout& Layout) {
    Elements.Empty(Slack, Layout.SparseArrayLayout);
    const int32 Desired = static_cast<int32>(FDefaultSetAllocator::GetNumberOfHashBuckets(static_cast<uint32>(Slack)));
    if (Slack != 0 && HashSize != Desired) {
        HashSize = Desired;
        Hash.ResizeAllocation(0, HashSize, sizeof(FSetElementId));
    }
    for (int32 Index = 0; Index < HashSize; ++Index) {
        Hash.GetAllocation()[Index] = FSetElementId();
    }
}

void FScriptSet::RemoveAt(int32 Index, const FScriptSetLayout& Layout) {
    check(IsValidIndex(Index));
    if (HashSize) {
        for (FSetElementId* Next = &Bucket(static_cast<uint32>(GetHashIndexRef(Index, Layout))); Next->IsValidId();
            Next = &GetHashNextIdRef(Next->AsInteger(), Layout)) {
            if (Next->AsInteger() == Index) {
                *Next = GetHashNextIdRef(Index, Layout);
                break;
            }
        }
    }
    Elements.RemoveAtUninitialized(Layout.SparseArrayLayout, Index);
}

int32 FScriptSet::AddUninitialized(const FScriptSetLayout& Layout) {
    const int32 Index = Elements.AddUninitialized(Layout.SparseArrayLayout);
    // An index no chain has, until Rehash gives it its place.
    GetHashNextIdRef(Index, Layout) = FSetElementId();
    GetHashIndexRef(Index, Layout) = 0;
    return Index;
}

void FScriptSet::Rehash(const FScriptSetLayout& Layout, TFunctionRef<uint32(const void*)> GetKeyHash) {
    HashSize = static_cast<int32>(FDefaultSetAllocator::GetNumberOfHashBuckets(static_cast<uint32>(Elements.Num())));
    Hash.ResizeAllocation(0, HashSize, sizeof(FSetElementId));
    for (int32 Index = 0; Index < HashSize; ++Index) {
        Hash.GetAllocation()[Index] = FSetElementId();
    }
    for (int32 Index = 0; Index < Elements.GetMaxIndex(); ++Index) {
        if (Elements.IsValidIndex(Index)) {
            LinkElement(Index, Layout, GetKeyHash(GetData(Index, Layout)));
        }
    }
}

int32 FScriptSet::FindIndexByHash(const void* Element, const FScriptSetLayout& Layout, uint32 KeyHash,
    TFunctionRef<bool(const void*, const void*)> EqualityFn) const {
    if (Elements.Num() && HashSize) {
        for (FSetElementId Id = Bucket(KeyHash); Id.IsValidId(); Id = GetHashNextIdRef(Id.AsInteger(), Layout)) {
            if (EqualityFn(Element, GetData(Id.AsInteger(), Layout))) {
                return Id.AsInteger();
            }
        }
    }
    return INDEX_NONE;
}

int32 FScriptSet::FindIndex(const void* Element, const FScriptSetLayout& Layout,
    TFunctionRef<uint32(const void*)> GetKeyHash, TFunctionRef<bool(const void*, const void*)> EqualityFn) const {
    return Elements.Num() ? FindIndexByHash(Element, Layout, GetKeyHash(Element), EqualityFn) : INDEX_NONE;
}

int32 FScriptSet::AddNewElement(const FScriptSetLayout& Layout, TFunctionRef<uint32(const void*)> GetKeyHash,
    uint32 KeyHash, TFunctionRef<void(void*)> ConstructFn) {
    const int32 Index = Elements.AddUninitialized(Layout.SparseArrayLayout);
    ConstructFn(GetData(Index, Layout));
    const int32 Desired =
        static_cast<int32>(FDefaultSetAllocator::GetNumberOfHashBuckets(static_cast<uint32>(Elements.Num())));
    if (!HashSize || HashSize < Desired) {
        Rehash(Layout, GetKeyHash);
    } else {
        LinkElement(Index, Layout, KeyHash);
    }
    return Index;
}

int32 FScriptSet::FindOrAdd(const void* Element, const FScriptSetLayout& Layout,
    TFunctionRef<uint32(const void*)> GetKeyHash, TFunctionRef<bool(const void*, const void*)> EqualityFn,
    TFunctionRef<void(void*)> ConstructFn) {
    const uint32 KeyHash = GetKeyHash(Element);
    const int32 Found = FindIndexByHash(Element, Layout, KeyHash, EqualityFn);
    return Found != INDEX_NONE ? Found : AddNewElement(Layout, GetKeyHash, KeyHash, ConstructFn);
}

void FScriptSet::Add(const void* Element, const FScriptSetLayout& Layout, TFunctionRef<uint32(const void*)> GetKeyHash,
    TFunctionRef<bool(const void*, const void*)> EqualityFn, TFunctionRef<void(void*)> ConstructFn,
    TFunctionRef<void(void*)> DestructFn) {
    const uint32 KeyHash = GetKeyHash(Element);
    const int32 Found = FindIndexByHash(Element, Layout, KeyHash, EqualityFn);
    if (Found == INDEX_NONE) {
        AddNewElement(Layout, GetKeyHash, KeyHash, ConstructFn);
        return;
    }
    void* Slot = GetData(Found, Layout);
    DestructFn(Slot);
    ConstructFn(Slot);
}

FScriptMapLayout FScriptMap::GetScriptLayout(int32 KeySize, int32 KeyAlignment, int32 ValueSize, int32 ValueAlignment) {
    // TPair<K, V> is { K Key; V Value; }.
    FScriptMapLayout Result;
    const int32 PairAlignment = KeyAlignment > ValueAlignment ? KeyAlignment : ValueAlignment;
    Result.ValueOffset = Align(KeySize, static_cast<uint64>(ValueAlignment));
    const int32 PairSize = Align(Result.ValueOffset + ValueSize, static_cast<uint64>(PairAlignment));
    Result.SetLayout = FScriptSet::GetScriptLayout(PairSize, PairAlignment);
    return Result;
}

int32 FScriptMap::FindPairIndex(const void* Key, const FScriptMapLayout& MapLayout,
    TFunctionRef<uint32(const void*)> GetKeyHash, TFunctionRef<bool(const void*, const void*)> KeyEqualityFn) const {
    // A pair begins with its key, so the set's functions may take a key for a pair.
    return Pairs.FindIndex(Key, MapLayout.SetLayout, GetKeyHash, KeyEqualityFn);
}

uint8* FScriptMap::FindValue(const void* Key, const FScriptMapLayout& MapLayout,
    TFunctionRef<uint32(const void*)> GetKeyHash, TFunctionRef<bool(const void*, const void*)> KeyEqualityFn) {
    const int32 Index = FindPairIndex(Key, MapLayout, GetKeyHash, KeyEqualityFn);
    return Index == INDEX_NONE ? nullptr
                               : static_cast<uint8*>(Pairs.GetData(Index, MapLayout.SetLayout)) + MapLayout.ValueOffset;
}

void FScriptMap::Add(const void* Key, const void* Value, const FScriptMapLayout& MapLayout,
    TFunctionRef<uint32(const void*)> GetKeyHash, TFunctionRef<bool(const void*, const void*)> KeyEqualityFn,
    TFunctionRef<void(void*)> KeyConstructAndAssignFn, TFunctionRef<void(void*)> ValueConstructAndAssignFn,
    TFunctionRef<void(void*)> ValueAssignFn, TFunctionRef<void(void*)> DestructKeyFn,
    TFunctionRef<void(void*)> DestructValueFn) {
    (void)Value;
    const int32 ValueOffset = MapLayout.ValueOffset;
    bool bExisting = false;
    Pairs.Add(
        Key, MapLayout.SetLayout, GetKeyHash, KeyEqualityFn,
        [&](void* Pair) {
            KeyConstructAndAssignFn(Pair);
            void* ValuePtr = static_cast<uint8*>(Pair) + ValueOffset;
            if (bExisting) {
                ValueAssignFn(ValuePtr);
            } else {
                ValueConstructAndAssignFn(ValuePtr);
            }
        },
        [&](void* Pair) {
            // The key is replaced, the value assigned: it is not destroyed.
            DestructKeyFn(Pair);
            (void)DestructValueFn;
            bExisting = true;
        });
}

int32 FScriptMap::FindOrAdd(const void* Key, const FScriptMapLayout& MapLayout,
    TFunctionRef<uint32(const void*)> GetKeyHash, TFunctionRef<bool(const void*, const void*)> KeyEqualityFn,
    TFunctionRef<void(void*, void*)> ConstructPairFn) {
    return Pairs.FindOrAdd(Key, MapLayout.SetLayout, GetKeyHash, KeyEqualityFn,
        [&](void* Pair) { ConstructPairFn(Pair, static_cast<uint8*>(Pair) + MapLayout.ValueOffset); });
}
