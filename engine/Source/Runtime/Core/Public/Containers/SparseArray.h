// SPDX-License-Identifier: MIT
/** TSparseArray: an array with holes, whose indices stay valid when others are removed; FScriptSparseArray. */
#pragma once

#include "Containers/Array.h"
#include "Containers/BitArray.h"

/** Where an element was put, and its index. */
struct FSparseArrayAllocationInfo {
    int32 Index;
    void* Pointer;
};
/** `new (SparseArray.AddUninitialized()) T(...)` as UE allows it. */
inline void* operator new(size_t, const FSparseArrayAllocationInfo& Allocation) { return Allocation.Pointer; }
inline void operator delete(void*, const FSparseArrayAllocationInfo&) {}

/** An element, or a link in the list of holes. */
template <typename ElementType>
union TSparseArrayElementOrFreeListLink {
    alignas(ElementType) uint8 ElementData[sizeof(ElementType)];
    struct {
        int32 PrevFreeIndex;
        int32 NextFreeIndex;
    } Link;
};

template <typename InElementType, typename Allocator>
class TSparseArray {
    using FElementOrFreeListLink = TSparseArrayElementOrFreeListLink<InElementType>;

public:
    using ElementType = InElementType;

    TSparseArray() = default;
    TSparseArray(const TSparseArray& Other) { *this = Other; }
    TSparseArray(TSparseArray&& Other) { MoveFrom(Other); }
    ~TSparseArray() { DestructAll(); }
    TSparseArray& operator=(TSparseArray&& Other) {
        if (this != &Other) {
            DestructAll();
            MoveFrom(Other);
        }
        return *this;
    }
    /** Copies keep indices and holes. */
    TSparseArray& operator=(const TSparseArray& Other) {
        if (this != &Other) {
            Empty(Other.GetMaxIndex());
            Data.AddUninitialized(Other.Data.Num());
            AllocationFlags = Other.AllocationFlags;
            FirstFreeIndex = Other.FirstFreeIndex;
            NumFreeIndices = Other.NumFreeIndices;
            for (int32 Index = 0; Index < Data.Num(); ++Index) {
                if (AllocationFlags[Index]) {
                    ::new (static_cast<void*>(GetData(Index).ElementData)) ElementType(Other[Index]);
                } else {
                    GetData(Index).Link = Other.GetData(Index).Link;
                }
            }
        }
        return *this;
    }

    FSparseArrayAllocationInfo AddUninitialized() {
        int32 Index;
        if (NumFreeIndices > 0) {
            Index = FirstFreeIndex;
            FirstFreeIndex = GetData(Index).Link.NextFreeIndex;
            --NumFreeIndices;
            if (NumFreeIndices) {
                GetData(FirstFreeIndex).Link.PrevFreeIndex = INDEX_NONE;
            }
            AllocationFlags[Index] = true;
        } else {
            Index = Data.AddUninitialized(1);
            AllocationFlags.Add(true);
        }
        return {Index, static_cast<void*>(GetData(Index).ElementData)};
    }
    int32 Add(const ElementType& Element) { return Emplace(Element); }
    int32 Add(ElementType&& Element) { return Emplace(MoveTempIfPossible(Element)); }
    template <typename... ArgsType>
    int32 Emplace(ArgsType&&... Args) {
        const FSparseArrayAllocationInfo Allocation = AddUninitialized();
        ::new (Allocation.Pointer) ElementType(Forward<ArgsType>(Args)...);
        return Allocation.Index;
    }
    /** Puts an element at a free index of the caller's choice. */
    FSparseArrayAllocationInfo InsertUninitialized(int32 Index) {
        check(!IsAllocated(Index));
        while (Index >= Data.Num()) {
            const int32 NewIndex = Data.AddUninitialized(1);
            AllocationFlags.Add(false);
            LinkFree(NewIndex);
        }
        Unlink(Index);
        AllocationFlags[Index] = true;
        return {Index, static_cast<void*>(GetData(Index).ElementData)};
    }
    void Insert(int32 Index, const ElementType& Element) {
        ::new (InsertUninitialized(Index).Pointer) ElementType(Element);
    }

    void RemoveAt(int32 Index, int32 Count = 1) {
        for (int32 It = Index; It < Index + Count; ++It) {
            check(IsAllocated(It));
            DestructItem(&(*this)[It]);
        }
        RemoveAtUninitialized(Index, Count);
    }
    void RemoveAtUninitialized(int32 Index, int32 Count = 1) {
        for (; Count > 0; --Count, ++Index) {
            check(IsAllocated(Index));
            LinkFree(Index);
            AllocationFlags[Index] = false;
        }
    }
    void Empty(int32 ExpectedNumElements = 0) {
        DestructAll();
        Data.Empty(ExpectedNumElements);
        FirstFreeIndex = INDEX_NONE;
        NumFreeIndices = 0;
        AllocationFlags.Empty(ExpectedNumElements);
    }
    void Reset() {
        DestructAll();
        Data.Reset();
        FirstFreeIndex = INDEX_NONE;
        NumFreeIndices = 0;
        AllocationFlags.Reset();
    }
    /** Room for that many elements altogether. */
    void Reserve(int32 ExpectedNumElements) {
        Data.Reserve(ExpectedNumElements);
        AllocationFlags.Reserve(ExpectedNumElements);
    }
    /** Drops the holes at the end. */
    void Shrink() {
        const int32 Last = AllocationFlags.FindLast(true);
        for (int32 Index = Data.Num() - 1; Index > Last; --Index) {
            Unlink(Index);
        }
        if (Last + 1 < Data.Num()) {
            Data.SetNumUninitialized(Last + 1);
            AllocationFlags.RemoveAt(Last + 1, AllocationFlags.Num() - Last - 1);
        }
        Data.Shrink();
    }
    /** Closes the holes by moving elements from the end; returns whether anything moved. */
    bool Compact() {
        bool bMoved = false;
        for (int32 Hole = AllocationFlags.Find(false); Hole != INDEX_NONE;
            Hole = AllocationFlags.FindFrom(false, Hole)) {
            const int32 Last = AllocationFlags.FindLast(true);
            if (Last < Hole) {
                break;
            }
            FMemory::Memcpy(static_cast<void*>(GetData(Hole).ElementData),
                static_cast<const void*>(GetData(Last).ElementData), sizeof(FElementOrFreeListLink));
            AllocationFlags[Hole] = true;
            AllocationFlags[Last] = false;
            bMoved = true;
        }
        return FinishCompact() || bMoved;
    }
    /** Closes the holes and keeps the order. */
    bool CompactStable() {
        bool bMoved = false;
        int32 Write = 0;
        for (int32 Read = AllocationFlags.Find(true); Read != INDEX_NONE;
            Read = AllocationFlags.FindFrom(true, Read + 1)) {
            if (Write != Read) {
                FMemory::Memcpy(static_cast<void*>(GetData(Write).ElementData),
                    static_cast<const void*>(GetData(Read).ElementData), sizeof(FElementOrFreeListLink));
                AllocationFlags[Write] = true;
                AllocationFlags[Read] = false;
                bMoved = true;
            }
            ++Write;
        }
        return FinishCompact() || bMoved;
    }
    template <typename PredicateClass>
    void Sort(const PredicateClass& Predicate) {
        CompactStable();
        ElementType* Begin = reinterpret_cast<ElementType*>(Data.GetData());
        static_assert(sizeof(FElementOrFreeListLink) >= sizeof(ElementType));
        if constexpr (sizeof(FElementOrFreeListLink) == sizeof(ElementType)) {
            std::sort(
                Begin, Begin + Num(), UE::Core::Private::TDereferencePredicate<ElementType, PredicateClass>{Predicate});
        } else {
            TArray<ElementType> Sorted;
            for (ElementType& Element : *this) {
                Sorted.Add(MoveTempIfPossible(Element));
            }
            Sorted.Sort(Predicate);
            Empty(Sorted.Num());
            for (ElementType& Element : Sorted) {
                Add(MoveTempIfPossible(Element));
            }
        }
    }

    ElementType& operator[](int32 Index) {
        check(IsAllocated(Index));
        return *reinterpret_cast<ElementType*>(GetData(Index).ElementData);
    }
    const ElementType& operator[](int32 Index) const {
        check(IsAllocated(Index));
        return *reinterpret_cast<const ElementType*>(GetData(Index).ElementData);
    }
    bool IsValidIndex(int32 Index) const { return IsAllocated(Index); }
    bool IsAllocated(int32 Index) const { return AllocationFlags.IsValidIndex(Index) && AllocationFlags[Index]; }
    int32 GetMaxIndex() const { return Data.Num(); }
    bool IsEmpty() const { return Num() == 0; }
    int32 Num() const { return Data.Num() - NumFreeIndices; }
    int32 Max() const { return Data.Max(); }
    bool IsCompact() const { return NumFreeIndices == 0; }
    SIZE_T GetAllocatedSize() const { return Data.GetAllocatedSize() + AllocationFlags.GetAllocatedSize(); }
    int32 FindNextAllocated(int32 From) const { return AllocationFlags.FindFrom(true, From); }

    template <bool bConst>
    class TBaseIterator {
        using ArrayType = std::conditional_t<bConst, const TSparseArray, TSparseArray>;
        using ItElementType = std::conditional_t<bConst, const InElementType, InElementType>;

    public:
        explicit TBaseIterator(ArrayType& InArray, int32 Start = 0)
            : Array(&InArray), Index(InArray.FindNextAllocated(Start)) {}
        TBaseIterator& operator++() {
            Index = Array->FindNextAllocated(Index + 1);
            return *this;
        }
        int32 GetIndex() const { return Index; }
        explicit operator bool() const { return Index != INDEX_NONE; }
        ItElementType& operator*() const { return (*Array)[Index]; }
        ItElementType* operator->() const { return &(*Array)[Index]; }
        bool operator==(const TBaseIterator& Other) const { return Index == Other.Index; }
        void RemoveCurrent() { Array->RemoveAt(Index); }

    private:
        ArrayType* Array;
        int32 Index;
    };
    using TIterator = TBaseIterator<false>;
    using TConstIterator = TBaseIterator<true>;
    TIterator CreateIterator() { return TIterator(*this); }
    TConstIterator CreateConstIterator() const { return TConstIterator(*this); }
    TIterator begin() { return TIterator(*this); }
    TConstIterator begin() const { return TConstIterator(*this); }
    TIterator end() { return TIterator(*this, GetMaxIndex()); }
    TConstIterator end() const { return TConstIterator(*this, GetMaxIndex()); }

private:
    FElementOrFreeListLink& GetData(int32 Index) { return Data.GetData()[Index]; }
    const FElementOrFreeListLink& GetData(int32 Index) const { return Data.GetData()[Index]; }
    void DestructAll() {
        if constexpr (!std::is_trivially_destructible_v<ElementType>) {
            for (int32 Index = FindNextAllocated(0); Index != INDEX_NONE; Index = FindNextAllocated(Index + 1)) {
                DestructItem(&(*this)[Index]);
            }
        }
    }
    void MoveFrom(TSparseArray& Other) {
        // The elements are bytes to `Data`, so its own destructor does nothing to them.
        Data = MoveTemp(Other.Data);
        AllocationFlags = MoveTemp(Other.AllocationFlags);
        FirstFreeIndex = Other.FirstFreeIndex;
        NumFreeIndices = Other.NumFreeIndices;
        Other.FirstFreeIndex = INDEX_NONE;
        Other.NumFreeIndices = 0;
    }
    void LinkFree(int32 Index) {
        if (NumFreeIndices) {
            GetData(FirstFreeIndex).Link.PrevFreeIndex = Index;
        }
        GetData(Index).Link.PrevFreeIndex = INDEX_NONE;
        GetData(Index).Link.NextFreeIndex = NumFreeIndices > 0 ? FirstFreeIndex : INDEX_NONE;
        FirstFreeIndex = Index;
        ++NumFreeIndices;
    }
    void Unlink(int32 Index) {
        const auto Link = GetData(Index).Link;
        --NumFreeIndices;
        if (Link.PrevFreeIndex != INDEX_NONE) {
            GetData(Link.PrevFreeIndex).Link.NextFreeIndex = Link.NextFreeIndex;
        } else {
            FirstFreeIndex = Link.NextFreeIndex;
        }
        if (Link.NextFreeIndex != INDEX_NONE) {
            GetData(Link.NextFreeIndex).Link.PrevFreeIndex = Link.PrevFreeIndex;
        }
    }
    bool FinishCompact() {
        const int32 Count = Num();
        const bool bChanged = NumFreeIndices > 0;
        Data.SetNumUninitialized(Count);
        AllocationFlags.SetNumUninitialized(Count);
        FirstFreeIndex = INDEX_NONE;
        NumFreeIndices = 0;
        return bChanged;
    }

    TArray<FElementOrFreeListLink, typename Allocator::ElementAllocator> Data;
    TBitArray<typename Allocator::BitArrayAllocator> AllocationFlags;
    int32 FirstFreeIndex = INDEX_NONE;
    int32 NumFreeIndices = 0;
};

/** Size of one slot of a sparse array. */
struct FScriptSparseArrayLayout {
    int32 Alignment;
    int32 Size;
};

/** A sparse array whose element type is known only at run time, with the same bytes as any TSparseArray. */
class FScriptSparseArray {
public:
    /** The layout of a TSparseArray of such elements. */
    static FScriptSparseArrayLayout GetScriptLayout(int32 ElementSize, int32 ElementAlignment) {
        FScriptSparseArrayLayout Result;
        Result.Alignment = ElementAlignment > 4 ? ElementAlignment : 4;
        Result.Size = Align(ElementSize > 8 ? ElementSize : 8, static_cast<uint64>(Result.Alignment));
        return Result;
    }

    FScriptSparseArray() = default;
    UE_NONCOPYABLE(FScriptSparseArray)

    bool IsValidIndex(int32 Index) const { return AllocationFlags.IsValidIndex(Index) && AllocationFlags[Index]; }
    bool IsEmpty() const { return Num() == 0; }
    int32 Num() const { return Data.Num() - NumFreeIndices; }
    int32 GetMaxIndex() const { return Data.Num(); }
    void* GetData(int32 Index, const FScriptSparseArrayLayout& Layout) {
        return static_cast<uint8*>(Data.GetData()) + static_cast<SIZE_T>(Layout.Size) * static_cast<SIZE_T>(Index);
    }
    const void* GetData(int32 Index, const FScriptSparseArrayLayout& Layout) const {
        return const_cast<FScriptSparseArray*>(this)->GetData(Index, Layout);
    }
    /** Takes the other's elements; this array's own must have been destroyed before. */
    void MoveAssign(FScriptSparseArray& Other, const FScriptSparseArrayLayout& Layout) {
        if (this != &Other) {
            Data.MoveAssign(Other.Data, static_cast<SIZE_T>(Layout.Size), static_cast<uint32>(Layout.Alignment));
            AllocationFlags = MoveTemp(Other.AllocationFlags);
            FirstFreeIndex = Other.FirstFreeIndex;
            NumFreeIndices = Other.NumFreeIndices;
            Other.FirstFreeIndex = INDEX_NONE;
            Other.NumFreeIndices = 0;
        }
    }
    void Empty(int32 Slack, const FScriptSparseArrayLayout& Layout) {
        Data.Empty(Slack, static_cast<SIZE_T>(Layout.Size), static_cast<uint32>(Layout.Alignment));
        FirstFreeIndex = INDEX_NONE;
        NumFreeIndices = 0;
        AllocationFlags.Empty(Slack);
    }
    CORE_API int32 AddUninitialized(const FScriptSparseArrayLayout& Layout);
    CORE_API void RemoveAtUninitialized(const FScriptSparseArrayLayout& Layout, int32 Index, int32 Count = 1);

private:
    struct FFreeListLink {
        int32 PrevFreeIndex;
        int32 NextFreeIndex;
    };
    FFreeListLink* GetFreeListLink(int32 Index, const FScriptSparseArrayLayout& Layout) {
        return static_cast<FFreeListLink*>(GetData(Index, Layout));
    }

    FScriptArray Data;
    FScriptBitArray AllocationFlags;
    int32 FirstFreeIndex = INDEX_NONE;
    int32 NumFreeIndices = 0;
};
static_assert(
    sizeof(FScriptSparseArray) == sizeof(TSparseArray<int32>), "FScriptSparseArray must have TSparseArray's layout");
