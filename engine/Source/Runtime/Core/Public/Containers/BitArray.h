// SPDX-License-Identifier: MIT
/** TBitArray: a dynamic array of bits; FScriptBitArray: the same bytes, for type-erased containers. */
#pragma once

#include "Containers/ContainerAllocationPolicies.h"

#define NumBitsPerDWORD ((int32)32)

/** A writable bit. */
class FBitReference {
public:
    FBitReference(uint32& InData, uint32 InMask) : Data(InData), Mask(InMask) {}
    operator bool() const { return (Data & Mask) != 0; }
    void operator=(const bool NewValue) {
        if (NewValue) {
            Data |= Mask;
        } else {
            Data &= ~Mask;
        }
    }
    void operator=(const FBitReference& Other) { *this = static_cast<bool>(Other); }
    void operator|=(bool Value) {
        if (Value) {
            Data |= Mask;
        }
    }
    void operator&=(bool Value) {
        if (!Value) {
            Data &= ~Mask;
        }
    }

private:
    uint32& Data;
    uint32 Mask;
};

template <typename Allocator>
class TBitArray {
public:
    TBitArray() : NumBits(0), MaxBits(AllocatorInstance.GetInitialCapacity() * NumBitsPerDWORD) {
        ZeroWords(0, MaxBits / 32);
    }
    explicit TBitArray(bool bValue, int32 InNumBits) : TBitArray() { Add(bValue, InNumBits); }
    TBitArray(const TBitArray& Copy) : TBitArray() { *this = Copy; }
    TBitArray(TBitArray&& Other) : TBitArray() { *this = MoveTemp(Other); }
    TBitArray& operator=(const TBitArray& Copy) {
        if (this != &Copy) {
            Empty(Copy.Num());
            NumBits = Copy.NumBits;
            if (NumBits) {
                FMemory::Memcpy(GetData(), Copy.GetData(), sizeof(uint32) * static_cast<SIZE_T>(NumWords()));
            }
        }
        return *this;
    }
    TBitArray& operator=(TBitArray&& Other) {
        if (this != &Other) {
            AllocatorInstance.MoveToEmpty(Other.AllocatorInstance);
            NumBits = Other.NumBits;
            MaxBits = Other.MaxBits;
            Other.NumBits = 0;
            Other.MaxBits = Other.AllocatorInstance.GetInitialCapacity() * NumBitsPerDWORD;
            Other.ZeroWords(0, Other.MaxBits / 32);
        }
        return *this;
    }

    int32 Add(const bool Value) {
        const int32 Index = AddUninitialized(1);
        (*this)[Index] = Value;
        return Index;
    }
    int32 Add(const bool Value, int32 NumBitsToAdd) {
        const int32 Index = AddUninitialized(NumBitsToAdd);
        SetRange(Index, NumBitsToAdd, Value);
        return Index;
    }
    void Empty(int32 ExpectedNumBits = 0) {
        NumBits = 0;
        const int32 Words = AllocatorInstance.CalculateSlackReserve((ExpectedNumBits + 31) / 32, sizeof(uint32));
        AllocatorInstance.ResizeAllocation(0, Words, sizeof(uint32));
        MaxBits = Words * NumBitsPerDWORD;
        ZeroWords(0, Words);
    }
    void Reset() {
        ZeroWords(0, NumWords());
        NumBits = 0;
    }
    void Init(bool bValue, int32 InNumBits) {
        Empty(InNumBits);
        Add(bValue, InNumBits);
    }
    void SetNumUninitialized(int32 InNumBits) {
        if (InNumBits > NumBits) {
            AddUninitialized(InNumBits - NumBits);
        } else {
            NumBits = InNumBits;
        }
    }
    void SetNum(int32 InNumBits, bool bValue) {
        const int32 Old = NumBits;
        SetNumUninitialized(InNumBits);
        if (InNumBits > Old) {
            SetRange(Old, InNumBits - Old, bValue);
        }
    }
    void Reserve(int32 Number) {
        if (Number > MaxBits) {
            Grow(Number);
        }
    }
    void SetRange(int32 Index, int32 Count, bool Value) {
        check(Index >= 0 && Count >= 0 && Index + Count <= NumBits);
        for (int32 Bit = Index; Bit < Index + Count; ++Bit) {
            (*this)[Bit] = Value;
        }
    }
    void Insert(bool Value, int32 Index) {
        check(Index >= 0 && Index <= NumBits);
        AddUninitialized(1);
        for (int32 Bit = NumBits - 1; Bit > Index; --Bit) {
            (*this)[Bit] = static_cast<bool>((*this)[Bit - 1]);
        }
        (*this)[Index] = Value;
    }
    void RemoveAt(int32 BaseIndex, int32 NumBitsToRemove = 1) {
        check(BaseIndex >= 0 && NumBitsToRemove >= 0 && BaseIndex + NumBitsToRemove <= NumBits);
        for (int32 Bit = BaseIndex; Bit + NumBitsToRemove < NumBits; ++Bit) {
            (*this)[Bit] = static_cast<bool>((*this)[Bit + NumBitsToRemove]);
        }
        NumBits -= NumBitsToRemove;
    }
    bool IsValidIndex(int32 Index) const { return Index >= 0 && Index < NumBits; }
    bool IsEmpty() const { return NumBits == 0; }
    int32 Num() const { return NumBits; }
    int32 Max() const { return MaxBits; }
    SIZE_T GetAllocatedSize() const { return AllocatorInstance.GetAllocatedSize(MaxBits / 32, sizeof(uint32)); }
    FBitReference operator[](int32 Index) {
        check(IsValidIndex(Index));
        return FBitReference(GetData()[Index / 32], 1u << (Index & 31));
    }
    bool operator[](int32 Index) const {
        check(IsValidIndex(Index));
        return (GetData()[Index / 32] >> (Index & 31)) & 1u;
    }
    /** Index of the first bit with that value, or INDEX_NONE. */
    int32 Find(bool bValue) const { return FindFrom(bValue, 0); }
    bool Contains(bool bValue) const { return Find(bValue) != INDEX_NONE; }
    int32 FindFrom(bool bValue, int32 StartIndex) const {
        for (int32 Bit = StartIndex; Bit < NumBits;) {
            const uint32 Word = bValue ? GetData()[Bit / 32] : ~GetData()[Bit / 32];
            const uint32 Rest = Word >> (Bit & 31);
            if (Rest) {
                Bit += __builtin_ctz(Rest);
                return Bit < NumBits ? Bit : INDEX_NONE;
            }
            Bit = (Bit / 32 + 1) * 32;
        }
        return INDEX_NONE;
    }
    int32 FindLast(bool bValue) const {
        for (int32 Bit = NumBits; Bit-- > 0;) {
            if ((*this)[Bit] == bValue) {
                return Bit;
            }
        }
        return INDEX_NONE;
    }
    int32 FindAndSetFirstZeroBit(int32 StartIndex = 0) {
        const int32 Index = FindFrom(false, StartIndex);
        if (Index != INDEX_NONE) {
            (*this)[Index] = true;
        }
        return Index;
    }
    int32 CountSetBits(int32 FromIndex = 0, int32 ToIndex = INDEX_NONE) const {
        int32 Count = 0;
        const int32 End = ToIndex == INDEX_NONE ? NumBits : ToIndex;
        for (int32 Bit = FromIndex; Bit < End; ++Bit) {
            Count += (*this)[Bit] ? 1 : 0;
        }
        return Count;
    }
    bool operator==(const TBitArray& Other) const {
        if (NumBits != Other.NumBits) {
            return false;
        }
        for (int32 Bit = 0; Bit < NumBits; ++Bit) {
            if ((*this)[Bit] != Other[Bit]) {
                return false;
            }
        }
        return true;
    }
    uint32* GetData() { return AllocatorInstance.GetAllocation(); }
    const uint32* GetData() const { return AllocatorInstance.GetAllocation(); }

private:
    int32 NumWords() const { return (NumBits + 31) / 32; }
    int32 AddUninitialized(int32 Count) {
        check(Count >= 0);
        const int32 Index = NumBits;
        if (NumBits + Count > MaxBits) {
            Grow(NumBits + Count);
        }
        NumBits += Count;
        return Index;
    }
    void Grow(int32 Wanted) {
        const int32 OldWords = MaxBits / 32;
        const int32 Words = AllocatorInstance.CalculateSlackGrow((Wanted + 31) / 32, OldWords, sizeof(uint32));
        AllocatorInstance.ResizeAllocation(NumWords(), Words, sizeof(uint32));
        MaxBits = Words * NumBitsPerDWORD;
        ZeroWords(NumWords(), Words);
    }
    void ZeroWords(int32 From, int32 To) {
        if (To > From) {
            FMemory::Memzero(GetData() + From, sizeof(uint32) * static_cast<SIZE_T>(To - From));
        }
    }

    typename Allocator::template ForElementType<uint32> AllocatorInstance;
    int32 NumBits;
    int32 MaxBits;
};

/** The bit array of type-erased containers: the same class, so the same bytes. */
class FScriptBitArray : public TBitArray<FDefaultBitArrayAllocator> {
public:
    using TBitArray<FDefaultBitArrayAllocator>::TBitArray;
    FScriptBitArray() = default;
};

/** Visits the indices of the bits that are set. */
template <typename Allocator = FDefaultBitArrayAllocator>
class TConstSetBitIterator {
public:
    explicit TConstSetBitIterator(const TBitArray<Allocator>& InArray, int32 StartIndex = 0)
        : Array(InArray), Index(InArray.FindFrom(true, StartIndex)) {}
    TConstSetBitIterator& operator++() {
        Index = Array.FindFrom(true, Index + 1);
        return *this;
    }
    explicit operator bool() const { return Index != INDEX_NONE; }
    int32 GetIndex() const { return Index; }

private:
    const TBitArray<Allocator>& Array;
    int32 Index;
};
