// SPDX-License-Identifier: MIT
/** TArray: the dynamic array. Elements may be moved as bytes. See Epic's "Array Containers". */
#pragma once

#include <algorithm>
#include <concepts>

#include "Containers/ContainerAllocationPolicies.h"
#include "Containers/ScriptArray.h"
#include "Templates/Greater.h"
#include "Templates/Invoke.h"
#include "Templates/Less.h"
#include "Templates/MemoryOps.h"
#include "Templates/TypeHash.h"

/** Iterator by index; `if (...) It.RemoveCurrent()` is safe while iterating. */
template <typename ContainerType, typename ElementType, typename SizeType>
class TIndexedContainerIterator {
public:
    explicit TIndexedContainerIterator(ContainerType& InContainer, SizeType StartIndex = 0)
        : Container(InContainer), Index(StartIndex) {}
    TIndexedContainerIterator& operator++() {
        ++Index;
        return *this;
    }
    TIndexedContainerIterator operator++(int) {
        TIndexedContainerIterator Old(*this);
        ++Index;
        return Old;
    }
    TIndexedContainerIterator& operator--() {
        --Index;
        return *this;
    }
    TIndexedContainerIterator& operator+=(SizeType Offset) {
        Index += Offset;
        return *this;
    }
    ElementType& operator*() const { return Container[Index]; }
    ElementType* operator->() const { return &Container[Index]; }
    explicit operator bool() const { return Container.IsValidIndex(Index); }
    SizeType GetIndex() const { return Index; }
    void Reset() { Index = 0; }
    void SetToEnd() { Index = Container.Num(); }
    void RemoveCurrent() {
        Container.RemoveAt(Index);
        --Index;
    }
    void RemoveCurrentSwap() {
        Container.RemoveAtSwap(Index);
        --Index;
    }
    bool operator==(const TIndexedContainerIterator& Other) const {
        return &Container == &Other.Container && Index == Other.Index;
    }

private:
    ContainerType& Container;
    SizeType Index;
};

namespace UE::Core::Private {
/** Sorting arrays of pointers compares what they point to, as UE does. */
template <typename ElementType, typename PredicateType>
struct TDereferencePredicate {
    const PredicateType& Predicate;
    bool operator()(const ElementType& A, const ElementType& B) const {
        if constexpr (std::is_pointer_v<ElementType>) {
            return ::Invoke(Predicate, *A, *B);
        } else {
            return ::Invoke(Predicate, A, B);
        }
    }
};
template <typename RangeType, typename ElementType>
concept CContiguousRangeOf = requires(RangeType& Range) {
    { GetData(Range) } -> std::convertible_to<const ElementType*>;
    { GetNum(Range) } -> std::integral;
};
} // namespace UE::Core::Private

template <typename InElementType, typename InAllocatorType>
class TArray {
    template <typename OtherElement, typename OtherAllocator>
    friend class TArray;

public:
    typedef typename InAllocatorType::SizeType SizeType;
    typedef InElementType ElementType;
    typedef InAllocatorType AllocatorType;
    typedef InAllocatorType Allocator;
    using TIterator = TIndexedContainerIterator<TArray, ElementType, SizeType>;
    using TConstIterator = TIndexedContainerIterator<const TArray, const ElementType, SizeType>;

    TArray() : ArrayNum(0), ArrayMax(AllocatorInstance.GetInitialCapacity()) {}
    TArray(const ElementType* Ptr, SizeType Count) : TArray() {
        check(Ptr != nullptr || Count == 0);
        CopyToEmpty(Ptr, Count);
    }
    TArray(std::initializer_list<InElementType> InitList) : TArray() {
        CopyToEmpty(InitList.begin(), static_cast<SizeType>(InitList.size()));
    }
    TArray(const TArray& Other) : TArray() { CopyToEmpty(Other.GetData(), Other.Num()); }
    template <typename OtherElementType, typename OtherAllocator>
        requires std::is_constructible_v<InElementType, const OtherElementType&>
    explicit TArray(const TArray<OtherElementType, OtherAllocator>& Other) : TArray() {
        CopyToEmpty(Other.GetData(), static_cast<SizeType>(Other.Num()));
    }
    template <typename OtherAllocator>
    TArray(const TArray<InElementType, OtherAllocator>& Other) : TArray() {
        CopyToEmpty(Other.GetData(), static_cast<SizeType>(Other.Num()));
    }
    template <typename OtherElement, typename OtherSize>
        requires std::is_constructible_v<InElementType, const OtherElement&>
    explicit TArray(const TArrayView<OtherElement, OtherSize>& Other) : TArray() {
        CopyToEmpty(Other.GetData(), static_cast<SizeType>(Other.Num()));
    }
    TArray(const TArray& Other, SizeType ExtraSlack) : TArray() {
        Reserve(Other.Num() + ExtraSlack);
        CopyToEmpty(Other.GetData(), Other.Num());
    }
    TArray(TArray&& Other) : TArray() { MoveFrom(Other); }
    ~TArray() { DestructItems(GetData(), ArrayNum); }

    TArray& operator=(std::initializer_list<InElementType> InitList) {
        DestructItems(GetData(), ArrayNum);
        ArrayNum = 0;
        CopyToEmpty(InitList.begin(), static_cast<SizeType>(InitList.size()));
        return *this;
    }
    TArray& operator=(const TArray& Other) {
        if (this != &Other) {
            DestructItems(GetData(), ArrayNum);
            ArrayNum = 0;
            CopyToEmpty(Other.GetData(), Other.Num());
        }
        return *this;
    }
    template <typename OtherAllocator>
    TArray& operator=(const TArray<ElementType, OtherAllocator>& Other) {
        DestructItems(GetData(), ArrayNum);
        ArrayNum = 0;
        CopyToEmpty(Other.GetData(), static_cast<SizeType>(Other.Num()));
        return *this;
    }
    template <typename OtherSize>
    TArray& operator=(const TArrayView<const ElementType, OtherSize>& Other) {
        TArray Copy(Other);
        return *this = MoveTemp(Copy);
    }
    TArray& operator=(TArray&& Other) {
        if (this != &Other) {
            DestructItems(GetData(), ArrayNum);
            ArrayNum = 0;
            MoveFrom(Other);
        }
        return *this;
    }

    ElementType* GetData() { return AllocatorInstance.GetAllocation(); }
    const ElementType* GetData() const { return AllocatorInstance.GetAllocation(); }
    static constexpr uint32 GetTypeSize() { return sizeof(ElementType); }
    SIZE_T GetAllocatedSize() const { return AllocatorInstance.GetAllocatedSize(ArrayMax, sizeof(ElementType)); }
    SizeType GetSlack() const { return ArrayMax - ArrayNum; }
    bool IsValidIndex(SizeType Index) const { return Index >= 0 && Index < ArrayNum; }
    bool IsEmpty() const { return ArrayNum == 0; }
    SizeType Num() const { return ArrayNum; }
    SIZE_T NumBytes() const { return static_cast<SIZE_T>(ArrayNum) * sizeof(ElementType); }
    SizeType Max() const { return ArrayMax; }

    void RangeCheck(SizeType Index) const {
        checkf(Index >= 0 && Index < ArrayNum, TEXT("Array index out of bounds: %lld into an array of size %lld"),
            static_cast<long long>(Index), static_cast<long long>(ArrayNum));
    }
    ElementType& operator[](SizeType Index) {
        RangeCheck(Index);
        return GetData()[Index];
    }
    const ElementType& operator[](SizeType Index) const {
        RangeCheck(Index);
        return GetData()[Index];
    }
    ElementType& Last(SizeType IndexFromTheEnd = 0) { return (*this)[ArrayNum - IndexFromTheEnd - 1]; }
    const ElementType& Last(SizeType IndexFromTheEnd = 0) const { return (*this)[ArrayNum - IndexFromTheEnd - 1]; }
    ElementType& Top() { return Last(); }
    const ElementType& Top() const { return Last(); }
    ElementType Pop(EAllowShrinking AllowShrinking = EAllowShrinking::Default) {
        RangeCheck(0);
        ElementType Result = MoveTempIfPossible(GetData()[ArrayNum - 1]);
        RemoveAtImpl(ArrayNum - 1, 1, AllowShrinking);
        return Result;
    }
    void Push(ElementType&& Item) { Add(MoveTempIfPossible(Item)); }
    void Push(const ElementType& Item) { Add(Item); }

    // ----- searching

    bool Find(const ElementType& Item, SizeType& Index) const {
        Index = Find(Item);
        return Index != INDEX_NONE;
    }
    SizeType Find(const ElementType& Item) const { return IndexOfByKey(Item); }
    bool FindLast(const ElementType& Item, SizeType& Index) const {
        Index = FindLast(Item);
        return Index != INDEX_NONE;
    }
    SizeType FindLast(const ElementType& Item) const {
        return FindLastByPredicate([&Item](const ElementType& Element) { return Element == Item; });
    }
    template <typename Predicate>
    SizeType FindLastByPredicate(Predicate Pred, SizeType Count) const {
        check(Count >= 0 && Count <= ArrayNum);
        for (SizeType Index = Count; Index-- > 0;) {
            if (::Invoke(Pred, GetData()[Index])) {
                return Index;
            }
        }
        return INDEX_NONE;
    }
    template <typename Predicate>
    SizeType FindLastByPredicate(Predicate Pred) const {
        return FindLastByPredicate(Pred, ArrayNum);
    }
    template <typename KeyType>
    SizeType IndexOfByKey(const KeyType& Key) const {
        for (SizeType Index = 0; Index < ArrayNum; ++Index) {
            if (GetData()[Index] == Key) {
                return Index;
            }
        }
        return INDEX_NONE;
    }
    template <typename Predicate>
    SizeType IndexOfByPredicate(Predicate Pred) const {
        for (SizeType Index = 0; Index < ArrayNum; ++Index) {
            if (::Invoke(Pred, GetData()[Index])) {
                return Index;
            }
        }
        return INDEX_NONE;
    }
    template <typename KeyType>
    const ElementType* FindByKey(const KeyType& Key) const {
        return const_cast<TArray*>(this)->FindByKey(Key);
    }
    template <typename KeyType>
    ElementType* FindByKey(const KeyType& Key) {
        const SizeType Index = IndexOfByKey(Key);
        return Index == INDEX_NONE ? nullptr : GetData() + Index;
    }
    template <typename Predicate>
    const ElementType* FindByPredicate(Predicate Pred) const {
        return const_cast<TArray*>(this)->FindByPredicate(Pred);
    }
    template <typename Predicate>
    ElementType* FindByPredicate(Predicate Pred) {
        for (ElementType *Data = GetData(), *End = Data + ArrayNum; Data != End; ++Data) {
            if (::Invoke(Pred, *Data)) {
                return Data;
            }
        }
        return nullptr;
    }
    template <typename Predicate>
    TArray FilterByPredicate(Predicate Pred) const {
        TArray Result;
        for (const ElementType& Element : *this) {
            if (::Invoke(Pred, Element)) {
                Result.Add(Element);
            }
        }
        return Result;
    }
    template <typename ComparisonType>
    bool Contains(const ComparisonType& Item) const {
        return IndexOfByKey(Item) != INDEX_NONE;
    }
    template <typename Predicate>
    bool ContainsByPredicate(Predicate Pred) const {
        return IndexOfByPredicate(Pred) != INDEX_NONE;
    }
    template <typename OtherAllocator>
    bool operator==(const TArray<ElementType, OtherAllocator>& Other) const {
        return static_cast<int64>(Num()) == static_cast<int64>(Other.Num()) &&
               CompareItems(GetData(), Other.GetData(), Num());
    }

    // ----- adding

    /** Adds Count elements without constructing them; returns the index of the first. */
    SizeType AddUninitialized(SizeType Count = 1) {
        check(Count >= 0);
        const SizeType OldNum = ArrayNum;
        ArrayNum += Count;
        if (ArrayNum > ArrayMax) {
            ArrayMax = AllocatorInstance.CalculateSlackGrow(ArrayNum, ArrayMax, sizeof(ElementType));
            AllocatorInstance.ResizeAllocation(OldNum, ArrayMax, sizeof(ElementType));
        }
        return OldNum;
    }
    SizeType AddZeroed(SizeType Count = 1) {
        const SizeType Index = AddUninitialized(Count);
        FMemory::Memzero(static_cast<void*>(GetData() + Index), static_cast<SIZE_T>(Count) * sizeof(ElementType));
        return Index;
    }
    ElementType& AddZeroed_GetRef() {
        const SizeType Index = AddZeroed(1);
        return GetData()[Index];
    }
    SizeType AddDefaulted(SizeType Count = 1) {
        const SizeType Index = AddUninitialized(Count);
        DefaultConstructItems<ElementType>(static_cast<void*>(GetData() + Index), Count);
        return Index;
    }
    ElementType& AddDefaulted_GetRef() {
        const SizeType Index = AddDefaulted(1);
        return GetData()[Index];
    }
    SizeType Add(ElementType&& Item) { return Emplace(MoveTempIfPossible(Item)); }
    SizeType Add(const ElementType& Item) { return Emplace(Item); }
    ElementType& Add_GetRef(ElementType&& Item) {
        const SizeType Index = Emplace(MoveTempIfPossible(Item));
        return GetData()[Index];
    }
    ElementType& Add_GetRef(const ElementType& Item) {
        const SizeType Index = Emplace(Item);
        return GetData()[Index];
    }
    template <typename... ArgsType>
    SizeType Emplace(ArgsType&&... Args) {
        if (ArrayNum == ArrayMax) {
            // The argument may live in this array: build the element before the memory moves.
            alignas(ElementType) uint8 Temp[sizeof(ElementType)];
            ::new (static_cast<void*>(Temp)) ElementType(Forward<ArgsType>(Args)...);
            const SizeType Index = AddUninitialized(1);
            FMemory::Memcpy(static_cast<void*>(GetData() + Index), Temp, sizeof(ElementType));
            return Index;
        }
        const SizeType Index = AddUninitialized(1);
        ::new (static_cast<void*>(GetData() + Index)) ElementType(Forward<ArgsType>(Args)...);
        return Index;
    }
    template <typename... ArgsType>
    ElementType& Emplace_GetRef(ArgsType&&... Args) {
        const SizeType Index = Emplace(Forward<ArgsType>(Args)...);
        return GetData()[Index];
    }
    template <typename... ArgsType>
    void EmplaceAt(SizeType Index, ArgsType&&... Args) {
        ElementType Temp(Forward<ArgsType>(Args)...);
        InsertUninitialized(Index, 1);
        ::new (static_cast<void*>(GetData() + Index)) ElementType(MoveTempIfPossible(Temp));
    }
    template <typename... ArgsType>
    ElementType& EmplaceAt_GetRef(SizeType Index, ArgsType&&... Args) {
        EmplaceAt(Index, Forward<ArgsType>(Args)...);
        return GetData()[Index];
    }
    SizeType AddUnique(ElementType&& Item) {
        const SizeType Index = Find(Item);
        return Index != INDEX_NONE ? Index : Add(MoveTempIfPossible(Item));
    }
    SizeType AddUnique(const ElementType& Item) {
        const SizeType Index = Find(Item);
        return Index != INDEX_NONE ? Index : Add(Item);
    }
    template <typename OtherElementType, typename OtherAllocator>
    void Append(const TArray<OtherElementType, OtherAllocator>& Source) {
        check(static_cast<const void*>(this) != static_cast<const void*>(&Source));
        Append(Source.GetData(), static_cast<SizeType>(Source.Num()));
    }
    template <typename OtherAllocator>
    void Append(TArray<ElementType, OtherAllocator>&& Source) {
        check(static_cast<const void*>(this) != static_cast<const void*>(&Source));
        const SizeType Count = static_cast<SizeType>(Source.Num());
        if (Count > 0) {
            const SizeType Index = AddUninitialized(Count);
            RelocateConstructItems<ElementType>(static_cast<void*>(GetData() + Index), Source.GetData(), Count);
            Source.ArrayNum = 0;
        }
    }
    template <typename OtherElement, typename OtherSize>
    void Append(const TArrayView<OtherElement, OtherSize>& Source) {
        Append(Source.GetData(), static_cast<SizeType>(Source.Num()));
    }
    template <typename OtherElement>
    void Append(const OtherElement* Ptr, SizeType Count) {
        check(Ptr != nullptr || Count == 0);
        const SizeType Index = AddUninitialized(Count);
        ConstructItems<ElementType>(static_cast<void*>(GetData() + Index), Ptr, Count);
    }
    void Append(std::initializer_list<ElementType> InitList) {
        Append(InitList.begin(), static_cast<SizeType>(InitList.size()));
    }
    TArray& operator+=(const TArray& Other) {
        Append(Other);
        return *this;
    }
    TArray& operator+=(TArray&& Other) {
        Append(MoveTemp(Other));
        return *this;
    }
    TArray& operator+=(std::initializer_list<ElementType> InitList) {
        Append(InitList);
        return *this;
    }
    void Init(const ElementType& Element, SizeType Number) {
        Empty(Number);
        for (SizeType Index = 0; Index < Number; ++Index) {
            Add(Element);
        }
    }

    void InsertUninitialized(SizeType Index, SizeType Count = 1) {
        check(Index >= 0 && Index <= ArrayNum && Count >= 0);
        const SizeType OldNum = ArrayNum;
        AddUninitialized(Count);
        ElementType* Data = GetData() + Index;
        FMemory::Memmove(static_cast<void*>(Data + Count), static_cast<const void*>(Data),
            static_cast<SIZE_T>(OldNum - Index) * sizeof(ElementType));
    }
    void InsertZeroed(SizeType Index, SizeType Count = 1) {
        InsertUninitialized(Index, Count);
        FMemory::Memzero(static_cast<void*>(GetData() + Index), static_cast<SIZE_T>(Count) * sizeof(ElementType));
    }
    void InsertDefaulted(SizeType Index, SizeType Count = 1) {
        InsertUninitialized(Index, Count);
        DefaultConstructItems<ElementType>(static_cast<void*>(GetData() + Index), Count);
    }
    SizeType Insert(std::initializer_list<ElementType> InitList, SizeType Index) {
        InsertUninitialized(Index, static_cast<SizeType>(InitList.size()));
        ConstructItems<ElementType>(
            static_cast<void*>(GetData() + Index), InitList.begin(), static_cast<SizeType>(InitList.size()));
        return Index;
    }
    template <typename OtherAllocator>
    SizeType Insert(const TArray<ElementType, OtherAllocator>& Items, SizeType Index) {
        return Insert(Items.GetData(), static_cast<SizeType>(Items.Num()), Index);
    }
    SizeType Insert(const ElementType* Ptr, SizeType Count, SizeType Index) {
        InsertUninitialized(Index, Count);
        ConstructItems<ElementType>(static_cast<void*>(GetData() + Index), Ptr, Count);
        return Index;
    }
    SizeType Insert(ElementType&& Item, SizeType Index) {
        EmplaceAt(Index, MoveTempIfPossible(Item));
        return Index;
    }
    SizeType Insert(const ElementType& Item, SizeType Index) {
        EmplaceAt(Index, Item);
        return Index;
    }
    ElementType& Insert_GetRef(const ElementType& Item, SizeType Index) {
        EmplaceAt(Index, Item);
        return GetData()[Index];
    }

#include "Containers/ArrayRemoval.inl"
};

template <typename T, typename A>
struct TIsTArray<TArray<T, A>> : UE::Core::Private::TBoolTrait<true> {};
template <typename T, typename A>
struct TIsContiguousContainer<TArray<T, A>> : UE::Core::Private::TBoolTrait<true> {};

template <typename InElementType, typename InAllocatorType>
uint32 GetTypeHash(const TArray<InElementType, InAllocatorType>& A) {
    uint32 Hash = 0;
    for (const InElementType& Element : A) {
        Hash = HashCombineFast(Hash, GetTypeHashHelper(Element));
    }
    return Hash;
}
