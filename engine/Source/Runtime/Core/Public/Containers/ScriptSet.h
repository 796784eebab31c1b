// SPDX-License-Identifier: MIT
/** FScriptSet: a set whose element type is known only at run time, with the same bytes as any TSet. */
#pragma once

#include "Containers/Set.h"
#include "Templates/Function.h"

/** Where things are in a set's slots. */
struct FScriptSetLayout {
    int32 HashNextIdOffset;
    int32 HashIndexOffset;
    int32 Size;
    FScriptSparseArrayLayout SparseArrayLayout;
};

class FScriptSet {
public:
    /** The layout of a TSet of such elements. */
    static CORE_API FScriptSetLayout GetScriptLayout(int32 ElementSize, int32 ElementAlignment);

    FScriptSet() = default;
    UE_NONCOPYABLE(FScriptSet)

    bool IsValidIndex(int32 Index) const { return Elements.IsValidIndex(Index); }
    bool IsEmpty() const { return Elements.IsEmpty(); }
    int32 Num() const { return Elements.Num(); }
    int32 NumUnchecked() const { return Elements.Num(); }
    int32 GetMaxIndex() const { return Elements.GetMaxIndex(); }
    void* GetData(int32 Index, const FScriptSetLayout& Layout) {
        return Elements.GetData(Index, Layout.SparseArrayLayout);
    }
    const void* GetData(int32 Index, const FScriptSetLayout& Layout) const {
        return Elements.GetData(Index, Layout.SparseArrayLayout);
    }
    /** Takes the other's elements; this set's own must have been destroyed before. */
    CORE_API void MoveAssign(FScriptSet& Other, const FScriptSetLayout& Layout);
    /** Forgets all slots; the elements must have been destroyed before. */
    CORE_API void Empty(int32 Slack, const FScriptSetLayout& Layout);
    /** Takes an element out of its chain and frees its slot; it must have been destroyed after its hash index was last
     * needed. */
    CORE_API void RemoveAt(int32 Index, const FScriptSetLayout& Layout);
    /** Adds a slot that is in no chain: construct the element, then Rehash. */
    CORE_API int32 AddUninitialized(const FScriptSetLayout& Layout);
    CORE_API void Rehash(const FScriptSetLayout& Layout, TFunctionRef<uint32(const void*)> GetKeyHash);
    /** Index of the equal element, or INDEX_NONE. */
    CORE_API int32 FindIndex(const void* Element, const FScriptSetLayout& Layout,
        TFunctionRef<uint32(const void*)> GetKeyHash, TFunctionRef<bool(const void*, const void*)> EqualityFn) const;
    CORE_API int32 FindIndexByHash(const void* Element, const FScriptSetLayout& Layout, uint32 KeyHash,
        TFunctionRef<bool(const void*, const void*)> EqualityFn) const;
    /** Index of the equal element, or of a new slot that ConstructFn has constructed. */
    CORE_API int32 FindOrAdd(const void* Element, const FScriptSetLayout& Layout,
        TFunctionRef<uint32(const void*)> GetKeyHash, TFunctionRef<bool(const void*, const void*)> EqualityFn,
        TFunctionRef<void(void*)> ConstructFn);
    /** Adds, or replaces the equal element (DestructFn, then ConstructFn at its place). */
    CORE_API void Add(const void* Element, const FScriptSetLayout& Layout, TFunctionRef<uint32(const void*)> GetKeyHash,
        TFunctionRef<bool(const void*, const void*)> EqualityFn, TFunctionRef<void(void*)> ConstructFn,
        TFunctionRef<void(void*)> DestructFn);

private:
    int32 AddNewElement(const FScriptSetLayout& Layout, TFunctionRef<uint32(const void*)> GetKeyHash, uint32 KeyHash,
        TFunctionRef<void(void*)> ConstructFn);
    FSetElementId& GetHashNextIdRef(int32 Index, const FScriptSetLayout& Layout) const;
    int32& GetHashIndexRef(int32 Index, const FScriptSetLayout& Layout) const;
    FSetElementId& Bucket(uint32 KeyHash) const {
        return Hash.GetAllocation()[KeyHash & (static_cast<uint32>(HashSize) - 1)];
    }
    void LinkElement(int32 Index, const FScriptSetLayout& Layout, uint32 KeyHash);

    FScriptSparseArray Elements;
    FDefaultSetAllocator::HashAllocator::ForElementType<FSetElementId> Hash;
    int32 HashSize = 0;
};
static_assert(sizeof(FScriptSet) == sizeof(TSet<int32>), "FScriptSet must have TSet's layout");
