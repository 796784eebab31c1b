// SPDX-License-Identifier: MIT
// Part of class TArray (included inside Array.h): removal, capacity, sorting, heaps and iteration.

private:
void RemoveAtImpl(SizeType Index, SizeType Count, EAllowShrinking AllowShrinking) {
    check(Count >= 0 && Index >= 0 && Index + Count <= ArrayNum);
    if (Count == 0) {
        return;
    }
    DestructItems(GetData() + Index, Count);
    const SizeType NumToMove = ArrayNum - Index - Count;
    FMemory::Memmove(static_cast<void*>(GetData() + Index), static_cast<const void*>(GetData() + Index + Count),
                     static_cast<SIZE_T>(NumToMove) * sizeof(ElementType));
    ArrayNum -= Count;
    if (AllowShrinking == EAllowShrinking::Yes) {
        ShrinkToSlack();
    }
}
void ShrinkToSlack() {
    const SizeType NewMax = AllocatorInstance.CalculateSlackShrink(ArrayNum, ArrayMax, sizeof(ElementType));
    if (NewMax != ArrayMax) {
        ArrayMax = NewMax;
        AllocatorInstance.ResizeAllocation(ArrayNum, ArrayMax, sizeof(ElementType));
    }
}
void MoveFrom(TArray& Other) {
    AllocatorInstance.MoveToEmpty(Other.AllocatorInstance);
    ArrayNum = Other.ArrayNum;
    ArrayMax = Other.ArrayMax;
    Other.ArrayNum = 0;
    Other.ArrayMax = Other.AllocatorInstance.GetInitialCapacity();
}
template <typename OtherElementType>
void CopyToEmpty(const OtherElementType* Source, SizeType Count) {
    if (Count > ArrayMax) {
        ArrayMax = AllocatorInstance.CalculateSlackReserve(Count, sizeof(ElementType));
        AllocatorInstance.ResizeAllocation(0, ArrayMax, sizeof(ElementType));
    }
    ConstructItems<ElementType>(static_cast<void*>(GetData()), Source, Count);
    ArrayNum = Count;
}

public:
void RemoveAt(SizeType Index, EAllowShrinking AllowShrinking = EAllowShrinking::Default) {
    RangeCheck(Index);
    RemoveAtImpl(Index, 1, AllowShrinking);
}
template <typename CountType>
    requires std::is_integral_v<CountType>
void RemoveAt(SizeType Index, CountType Count, EAllowShrinking AllowShrinking = EAllowShrinking::Default) {
    static_assert(!std::is_same_v<CountType, bool>, "RemoveAt takes a count, not a bool");
    RemoveAtImpl(Index, static_cast<SizeType>(Count), AllowShrinking);
}
/** Fills the gap from the end: order is lost, the cost does not depend on the length. */
void RemoveAtSwap(SizeType Index, EAllowShrinking AllowShrinking = EAllowShrinking::Default) {
    RemoveAtSwap(Index, 1, AllowShrinking);
}
template <typename CountType>
    requires std::is_integral_v<CountType>
void RemoveAtSwap(SizeType Index, CountType InCount, EAllowShrinking AllowShrinking = EAllowShrinking::Default) {
    static_assert(!std::is_same_v<CountType, bool>, "RemoveAtSwap takes a count, not a bool");
    const SizeType Count = static_cast<SizeType>(InCount);
    check(Count >= 0 && Index >= 0 && Index + Count <= ArrayNum);
    DestructItems(GetData() + Index, Count);
    const SizeType NumAfterHole = ArrayNum - Index - Count;
    const SizeType NumToMove = Count < NumAfterHole ? Count : NumAfterHole;
    FMemory::Memcpy(static_cast<void*>(GetData() + Index), static_cast<const void*>(GetData() + ArrayNum - NumToMove),
                    static_cast<SIZE_T>(NumToMove) * sizeof(ElementType));
    ArrayNum -= Count;
    if (AllowShrinking == EAllowShrinking::Yes) {
        ShrinkToSlack();
    }
}
/** Removes every element equal to Item; returns how many. */
SizeType Remove(const ElementType& Item) {
    // Item may live in this array, and would be destroyed on the way: compare with a copy.
    if (ArrayNum == 0) {
        return 0;
    }
    const bool bInside = std::addressof(Item) >= GetData() && std::addressof(Item) < GetData() + ArrayNum;
    if constexpr (std::is_copy_constructible_v<ElementType>) {
        if (bInside) {
            const ElementType Copy(Item);
            return RemoveAll([&Copy](const ElementType& Element) { return Element == Copy; });
        }
    } else {
        check(!bInside);
    }
    return RemoveAll([&Item](const ElementType& Element) { return Element == Item; });
}
template <typename Predicate>
SizeType RemoveAll(const Predicate& Pred) {
    const SizeType OldNum = ArrayNum;
    SizeType Write = 0;
    ElementType* Data = GetData();
    for (SizeType Read = 0; Read < OldNum; ++Read) {
        if (::Invoke(Pred, Data[Read])) {
            DestructItem(Data + Read);
        } else {
            if (Write != Read) {
                FMemory::Memcpy(static_cast<void*>(Data + Write), static_cast<const void*>(Data + Read), sizeof(ElementType));
            }
            ++Write;
        }
    }
    ArrayNum = Write;
    return OldNum - Write;
}
template <typename Predicate>
SizeType RemoveAllSwap(const Predicate& Pred, EAllowShrinking AllowShrinking = EAllowShrinking::Default) {
    const SizeType OldNum = ArrayNum;
    for (SizeType Index = 0; Index < ArrayNum;) {
        if (::Invoke(Pred, GetData()[Index])) {
            RemoveAtSwap(Index, 1, EAllowShrinking::No);
        } else {
            ++Index;
        }
    }
    if (AllowShrinking == EAllowShrinking::Yes) {
        ShrinkToSlack();
    }
    return OldNum - ArrayNum;
}
SizeType RemoveSingle(const ElementType& Item) {
    const SizeType Index = Find(Item);
    if (Index == INDEX_NONE) {
        return 0;
    }
    RemoveAtImpl(Index, 1, EAllowShrinking::No);
    return 1;
}
SizeType RemoveSwap(const ElementType& Item, EAllowShrinking AllowShrinking = EAllowShrinking::Default) {
    const ElementType Copy(Item);
    return RemoveAllSwap([&Copy](const ElementType& Element) { return Element == Copy; }, AllowShrinking);
}
SizeType RemoveSingleSwap(const ElementType& Item, EAllowShrinking AllowShrinking = EAllowShrinking::Default) {
    const SizeType Index = Find(Item);
    if (Index == INDEX_NONE) {
        return 0;
    }
    RemoveAtSwap(Index, 1, AllowShrinking);
    return 1;
}

/** Removes all; keeps room for Slack elements. */
void Empty(SizeType Slack = 0) {
    DestructItems(GetData(), ArrayNum);
    ArrayNum = 0;
    const SizeType NewMax = Slack > 0 ? AllocatorInstance.CalculateSlackReserve(Slack, sizeof(ElementType))
                                      : AllocatorInstance.GetInitialCapacity();
    if (ArrayMax != NewMax) {
        AllocatorInstance.ResizeAllocation(0, NewMax, sizeof(ElementType));
        ArrayMax = NewMax;
    }
}
/** Removes all and keeps the memory, if it is enough for NewSize. */
void Reset(SizeType NewSize = 0) {
    if (NewSize <= ArrayMax) {
        DestructItems(GetData(), ArrayNum);
        ArrayNum = 0;
    } else {
        Empty(NewSize);
    }
}
void Reserve(SizeType Number) {
    check(Number >= 0);
    if (Number > ArrayMax) {
        ArrayMax = AllocatorInstance.CalculateSlackReserve(Number, sizeof(ElementType));
        AllocatorInstance.ResizeAllocation(ArrayNum, ArrayMax, sizeof(ElementType));
    }
}
void Shrink() {
    if (ArrayMax != ArrayNum && ArrayMax > AllocatorInstance.GetInitialCapacity()) {
        const SizeType Initial = AllocatorInstance.GetInitialCapacity();
        const SizeType NewMax = ArrayNum > Initial ? ArrayNum : Initial;
        AllocatorInstance.ResizeAllocation(ArrayNum, NewMax, sizeof(ElementType));
        ArrayMax = NewMax;
    }
}
void SetNum(SizeType NewNum, EAllowShrinking AllowShrinking = EAllowShrinking::Default) {
    if (NewNum > ArrayNum) {
        AddDefaulted(NewNum - ArrayNum);
    } else if (NewNum < ArrayNum) {
        RemoveAtImpl(NewNum, ArrayNum - NewNum, AllowShrinking);
    }
}
void SetNumZeroed(SizeType NewNum, EAllowShrinking AllowShrinking = EAllowShrinking::Default) {
    if (NewNum > ArrayNum) {
        AddZeroed(NewNum - ArrayNum);
    } else if (NewNum < ArrayNum) {
        RemoveAtImpl(NewNum, ArrayNum - NewNum, AllowShrinking);
    }
}
void SetNumUninitialized(SizeType NewNum, EAllowShrinking AllowShrinking = EAllowShrinking::Default) {
    if (NewNum > ArrayNum) {
        AddUninitialized(NewNum - ArrayNum);
    } else if (NewNum < ArrayNum) {
        RemoveAtImpl(NewNum, ArrayNum - NewNum, AllowShrinking);
    }
}
/** Changes the count alone: only downwards, and the elements above are not destroyed. */
void SetNumUnsafeInternal(SizeType NewNum) {
    check(NewNum <= ArrayNum && NewNum >= 0);
    ArrayNum = NewNum;
}
void SwapMemory(SizeType A, SizeType B) { FMemory::Memswap(&(*this)[A], &(*this)[B], sizeof(ElementType)); }
void Swap(SizeType A, SizeType B) {
    check(IsValidIndex(A) && IsValidIndex(B));
    if (A != B) {
        SwapMemory(A, B);
    }
}

// ----- sorting; arrays of pointers are compared by what they point to

void Sort() { Sort(TLess<>()); }
template <typename PredicateClass>
void Sort(const PredicateClass& Predicate) {
    std::sort(GetData(), GetData() + ArrayNum,
              UE::Core::Private::TDereferencePredicate<ElementType, PredicateClass>{Predicate});
}
void StableSort() { StableSort(TLess<>()); }
template <typename PredicateClass>
void StableSort(const PredicateClass& Predicate) {
    std::stable_sort(GetData(), GetData() + ArrayNum,
                     UE::Core::Private::TDereferencePredicate<ElementType, PredicateClass>{Predicate});
}

// ----- heaps; the least element by the predicate is at the top

template <typename PredicateClass = TLess<>>
void Heapify(const PredicateClass& Predicate = PredicateClass()) {
    std::make_heap(GetData(), GetData() + ArrayNum, Inverted(Predicate));
}
template <typename PredicateClass = TLess<>>
SizeType HeapPush(const ElementType& Item, const PredicateClass& Predicate = PredicateClass()) {
    Add(Item);
    std::push_heap(GetData(), GetData() + ArrayNum, Inverted(Predicate));
    return IndexOfByPredicate([&](const ElementType& Element) { return !Predicate(Element, Item) && !Predicate(Item, Element); });
}
template <typename PredicateClass = TLess<>>
void HeapPop(ElementType& OutItem, const PredicateClass& Predicate,
             EAllowShrinking AllowShrinking = EAllowShrinking::Default) {
    RangeCheck(0);
    std::pop_heap(GetData(), GetData() + ArrayNum, Inverted(Predicate));
    OutItem = Pop(AllowShrinking);
}
void HeapPop(ElementType& OutItem, EAllowShrinking AllowShrinking = EAllowShrinking::Default) {
    HeapPop(OutItem, TLess<>(), AllowShrinking);
}
const ElementType& HeapTop() const { return (*this)[0]; }
ElementType& HeapTop() { return (*this)[0]; }
void HeapSort() { Sort(); }

TIterator CreateIterator() { return TIterator(*this); }
TConstIterator CreateConstIterator() const { return TConstIterator(*this); }
ElementType* begin() { return GetData(); }
const ElementType* begin() const { return GetData(); }
ElementType* end() { return GetData() + ArrayNum; }
const ElementType* end() const { return GetData() + ArrayNum; }

private:
template <typename PredicateClass>
static auto Inverted(const PredicateClass& Predicate) {
    return [&Predicate](const ElementType& A, const ElementType& B) {
        return UE::Core::Private::TDereferencePredicate<ElementType, PredicateClass>{Predicate}(B, A);
    };
}

typename InAllocatorType::template ForElementType<ElementType> AllocatorInstance;
SizeType ArrayNum;
SizeType ArrayMax;
