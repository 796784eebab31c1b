// SPDX-License-Identifier: MIT
/** FScriptArray: a TArray whose element type is known only at run time, with the same bytes as any TArray. */
#pragma once

#include "Containers/ContainerAllocationPolicies.h"

template <typename AllocatorType>
class TScriptArray : protected AllocatorType::ForAnyElementType {
    using Super = typename AllocatorType::ForAnyElementType;

public:
    TScriptArray() : ArrayNum(0), ArrayMax(0) {}
    UE_NONCOPYABLE(TScriptArray)

    void* GetData() { return this->GetAllocation(); }
    const void* GetData() const { return this->GetAllocation(); }
    bool IsValidIndex(int32 Index) const { return Index >= 0 && Index < ArrayNum; }
    bool IsEmpty() const { return ArrayNum == 0; }
    int32 Num() const { return ArrayNum; }
    int32 Max() const { return ArrayMax; }
    int32 GetSlack() const { return ArrayMax - ArrayNum; }
    SIZE_T GetAllocatedSize(SIZE_T NumBytesPerElement) const {
        return Super::GetAllocatedSize(ArrayMax, NumBytesPerElement);
    }

    void InsertZeroed(int32 Index, int32 Count, SIZE_T NumBytesPerElement, uint32 AlignmentOfElement) {
        Insert(Index, Count, NumBytesPerElement, AlignmentOfElement);
        FMemory::Memzero(At(Index, NumBytesPerElement), static_cast<SIZE_T>(Count) * NumBytesPerElement);
    }
    /** Makes room for Count uninitialised elements at Index. */
    void Insert(int32 Index, int32 Count, SIZE_T NumBytesPerElement, uint32 AlignmentOfElement) {
        check(Count >= 0 && Index >= 0 && Index <= ArrayNum);
        const int32 OldNum = ArrayNum;
        Add(Count, NumBytesPerElement, AlignmentOfElement);
        FMemory::Memmove(At(Index + Count, NumBytesPerElement), At(Index, NumBytesPerElement),
            static_cast<SIZE_T>(OldNum - Index) * NumBytesPerElement);
    }
    /** Adds Count uninitialised elements; returns the index of the first. */
    int32 Add(int32 Count, SIZE_T NumBytesPerElement, uint32 AlignmentOfElement) {
        check(Count >= 0);
        const int32 OldNum = ArrayNum;
        ArrayNum += Count;
        if (ArrayNum > ArrayMax) {
            ArrayMax = this->CalculateSlackGrow(ArrayNum, ArrayMax, NumBytesPerElement, AlignmentOfElement);
            this->ResizeAllocation(OldNum, ArrayMax, NumBytesPerElement, AlignmentOfElement);
        }
        return OldNum;
    }
    int32 AddZeroed(int32 Count, SIZE_T NumBytesPerElement, uint32 AlignmentOfElement) {
        const int32 Index = Add(Count, NumBytesPerElement, AlignmentOfElement);
        FMemory::Memzero(At(Index, NumBytesPerElement), static_cast<SIZE_T>(Count) * NumBytesPerElement);
        return Index;
    }
    void Reserve(int32 Number, SIZE_T NumBytesPerElement, uint32 AlignmentOfElement) {
        if (Number > ArrayMax) {
            ArrayMax = Number;
            this->ResizeAllocation(ArrayNum, ArrayMax, NumBytesPerElement, AlignmentOfElement);
        }
    }
    void Shrink(SIZE_T NumBytesPerElement, uint32 AlignmentOfElement) {
        if (ArrayNum != ArrayMax) {
            ArrayMax = ArrayNum;
            this->ResizeAllocation(ArrayNum, ArrayMax, NumBytesPerElement, AlignmentOfElement);
        }
    }
    void SetNumUninitialized(int32 NewNum, SIZE_T NumBytesPerElement, uint32 AlignmentOfElement,
        EAllowShrinking AllowShrinking = EAllowShrinking::Default) {
        if (NewNum > ArrayNum) {
            Add(NewNum - ArrayNum, NumBytesPerElement, AlignmentOfElement);
        } else if (NewNum < ArrayNum) {
            Remove(NewNum, ArrayNum - NewNum, NumBytesPerElement, AlignmentOfElement, AllowShrinking);
        }
    }
    /** Takes the other array's elements; this array's own elements must have been destroyed before. */
    void MoveAssign(TScriptArray& Other, SIZE_T, uint32) {
        if (this != &Other) {
            Super::MoveToEmpty(Other);
            ArrayNum = Other.ArrayNum;
            ArrayMax = Other.ArrayMax;
            Other.ArrayNum = 0;
            Other.ArrayMax = 0;
        }
    }
    void Empty(int32 Slack, SIZE_T NumBytesPerElement, uint32 AlignmentOfElement) {
        check(Slack >= 0);
        ArrayNum = 0;
        if (Slack != ArrayMax) {
            ArrayMax = Slack;
            this->ResizeAllocation(0, ArrayMax, NumBytesPerElement, AlignmentOfElement);
        }
    }
    void SwapMemory(int32 A, int32 B, SIZE_T NumBytesPerElement) {
        FMemory::Memswap(At(A, NumBytesPerElement), At(B, NumBytesPerElement), NumBytesPerElement);
    }
    /** Closes the gap; the removed elements must have been destroyed before. */
    void Remove(int32 Index, int32 Count, SIZE_T NumBytesPerElement, uint32 AlignmentOfElement,
        EAllowShrinking AllowShrinking = EAllowShrinking::Default) {
        check(Count >= 0 && Index >= 0 && Index + Count <= ArrayNum);
        if (Count == 0) {
            return;
        }
        FMemory::Memmove(At(Index, NumBytesPerElement), At(Index + Count, NumBytesPerElement),
            static_cast<SIZE_T>(ArrayNum - Index - Count) * NumBytesPerElement);
        ArrayNum -= Count;
        if (AllowShrinking == EAllowShrinking::Yes) {
            const int32 NewMax = this->CalculateSlackShrink(ArrayNum, ArrayMax, NumBytesPerElement, AlignmentOfElement);
            if (NewMax != ArrayMax) {
                ArrayMax = NewMax;
                this->ResizeAllocation(ArrayNum, ArrayMax, NumBytesPerElement, AlignmentOfElement);
            }
        }
    }

private:
    uint8* At(int32 Index, SIZE_T NumBytesPerElement) {
        return reinterpret_cast<uint8*>(this->GetAllocation()) + static_cast<SIZE_T>(Index) * NumBytesPerElement;
    }
    int32 ArrayNum;
    int32 ArrayMax;
};

class FScriptArray : public TScriptArray<FHeapAllocator> {
public:
    using TScriptArray<FHeapAllocator>::TScriptArray;
    FScriptArray() = default;
};
