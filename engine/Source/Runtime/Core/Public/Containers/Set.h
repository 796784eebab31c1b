// SPDX-License-Identifier: MIT
/** TSet: a hash set over a sparse array. Iteration is in order of insertion while nothing is removed. */
#pragma once

#include "Containers/ArrayView.h"
#include "Containers/SparseArray.h"
#include "Templates/TypeHash.h"

/** What key functions have in common. */
template <typename ElementType, typename InKeyType, bool bInAllowDuplicateKeys = false>
struct BaseKeyFuncs {
    typedef InKeyType KeyType;
    typedef typename TCallTraits<InKeyType>::ParamType KeyInitType;
    typedef typename TCallTraits<ElementType>::ParamType ElementInitType;
    enum { bAllowDuplicateKeys = bInAllowDuplicateKeys };
};
/** The element is its own key; == and GetTypeHash decide. */
template <typename ElementType, bool bInAllowDuplicateKeys>
struct DefaultKeyFuncs : BaseKeyFuncs<ElementType, ElementType, bInAllowDuplicateKeys> {
    typedef typename TCallTraits<ElementType>::ParamType KeyInitType;
    typedef typename TCallTraits<ElementType>::ParamType ElementInitType;
    static KeyInitType GetSetKey(ElementInitType Element) { return Element; }
    static bool Matches(KeyInitType A, KeyInitType B) { return A == B; }
    template <typename ComparableKey>
    static bool Matches(KeyInitType A, const ComparableKey& B) {
        return A == B;
    }
    static uint32 GetKeyHash(KeyInitType Key) { return GetTypeHash(Key); }
    template <typename ComparableKey>
    static uint32 GetKeyHash(const ComparableKey& Key) {
        return GetTypeHash(Key);
    }
};

/** Index of an element of a set. */
class FSetElementId {
public:
    FSetElementId() : Index(INDEX_NONE) {}
    bool IsValidId() const { return Index != INDEX_NONE; }
    bool operator==(const FSetElementId& Other) const { return Index == Other.Index; }
    int32 AsInteger() const { return Index; }
    static FSetElementId FromInteger(int32 Integer) { return FSetElementId(Integer); }

private:
    explicit FSetElementId(int32 InIndex) : Index(InIndex) {}
    int32 Index;
};

/** An element with its place in the hash chain. */
template <typename InElementType>
class TSetElement {
public:
    typedef InElementType ElementType;
    InElementType Value;
    mutable FSetElementId HashNextId;
    mutable int32 HashIndex = 0;

    TSetElement() = default;
    template <typename... ArgTypes>
    explicit TSetElement(EInPlace, ArgTypes&&... Args) : Value(Forward<ArgTypes>(Args)...) {}
    TSetElement(const TSetElement&) = default;
    TSetElement(TSetElement&&) = default;
    TSetElement& operator=(const TSetElement&) = default;
    TSetElement& operator=(TSetElement&&) = default;
};

template <typename InElementType, typename KeyFuncs, typename Allocator>
class TSet {
    template <typename, typename, typename>
    friend class TSet;
    template <typename, typename, typename, typename>
    friend class TMapBase;
    using SetElementType = TSetElement<InElementType>;
    using ElementArrayType = TSparseArray<SetElementType, typename Allocator::SparseArrayAllocator>;
    using HashType = typename Allocator::HashAllocator::template ForElementType<FSetElementId>;

public:
    using ElementType = InElementType;
    using KeyFuncsType = KeyFuncs;
    using KeyType = typename KeyFuncs::KeyType;
    using KeyInitType = typename KeyFuncs::KeyInitType;
    using ElementInitType = typename KeyFuncs::ElementInitType;

    TSet() = default;
    TSet(const TSet& Copy) { *this = Copy; }
    TSet(TSet&& Other) { *this = MoveTemp(Other); }
    TSet(std::initializer_list<ElementType> InitList) { Append(InitList); }
    explicit TSet(const TArray<ElementType>& InArray) { Append(InArray); }
    explicit TSet(TArrayView<const ElementType> InArray) {
        for (const ElementType& Element : InArray) {
            Add(Element);
        }
    }
    ~TSet() { HashSize = 0; }
    TSet& operator=(const TSet& Copy) {
        if (this != &Copy) {
            Elements = Copy.Elements;
            HashSize = 0;
            RehashAll();
        }
        return *this;
    }
    TSet& operator=(TSet&& Other) {
        if (this != &Other) {
            Elements = MoveTemp(Other.Elements);
            Hash.MoveToEmpty(Other.Hash);
            HashSize = Other.HashSize;
            Other.HashSize = 0;
        }
        return *this;
    }
    TSet& operator=(std::initializer_list<ElementType> InitList) {
        Reset();
        Append(InitList);
        return *this;
    }

    void Empty(int32 ExpectedNumElements = 0) {
        Elements.Empty(ExpectedNumElements);
        const int32 Desired =
            static_cast<int32>(Allocator::GetNumberOfHashBuckets(static_cast<uint32>(ExpectedNumElements)));
        if (ExpectedNumElements != 0 && (HashSize == 0 || HashSize != Desired)) {
            HashSize = Desired;
            RehashAll();
        } else {
            ClearHash();
        }
    }
    void Reset() {
        Elements.Reset();
        ClearHash();
    }
    void Shrink() {
        Elements.Shrink();
        Relax();
    }
    void Compact() {
        if (Elements.Compact()) {
            RehashAll();
        }
    }
    void CompactStable() {
        if (Elements.CompactStable()) {
            RehashAll();
        }
    }
    void Reserve(int32 Number) {
        if (Number > Elements.Num()) {
            Elements.Reserve(Number);
            const int32 NewHashSize =
                static_cast<int32>(Allocator::GetNumberOfHashBuckets(static_cast<uint32>(Number)));
            if (!HashSize || HashSize < NewHashSize) {
                HashSize = NewHashSize;
                RehashAll();
            }
        }
    }
    void Relax() { ConditionalRehash(Elements.Num(), EAllowShrinking::Yes); }
    SIZE_T GetAllocatedSize() const {
        return Elements.GetAllocatedSize() + Hash.GetAllocatedSize(HashSize, sizeof(FSetElementId));
    }
    bool IsEmpty() const { return Elements.IsEmpty(); }
    int32 Num() const { return Elements.Num(); }
    int32 GetMaxIndex() const { return Elements.GetMaxIndex(); }
    bool IsValidId(FSetElementId Id) const { return Id.IsValidId() && Elements.IsAllocated(Id.AsInteger()); }
    ElementType& operator[](FSetElementId Id) { return Elements[Id.AsInteger()].Value; }
    const ElementType& operator[](FSetElementId Id) const { return Elements[Id.AsInteger()].Value; }
    ElementType& Get(FSetElementId Id) { return (*this)[Id]; }
    const ElementType& Get(FSetElementId Id) const { return (*this)[Id]; }

    /** Adds, or replaces the element with an equal key. */
    FSetElementId Add(const ElementType& InElement, bool* bIsAlreadyInSetPtr = nullptr) {
        return Emplace(InElement, bIsAlreadyInSetPtr);
    }
    FSetElementId Add(ElementType&& InElement, bool* bIsAlreadyInSetPtr = nullptr) {
        return Emplace(MoveTempIfPossible(InElement), bIsAlreadyInSetPtr);
    }
    FSetElementId AddByHash(uint32 KeyHash, const ElementType& InElement, bool* bIsAlreadyInSetPtr = nullptr) {
        return EmplaceByHash(KeyHash, InElement, bIsAlreadyInSetPtr);
    }
    FSetElementId AddByHash(uint32 KeyHash, ElementType&& InElement, bool* bIsAlreadyInSetPtr = nullptr) {
        return EmplaceByHash(KeyHash, MoveTempIfPossible(InElement), bIsAlreadyInSetPtr);
    }
    template <typename ArgsType>
    FSetElementId Emplace(ArgsType&& Args, bool* bIsAlreadyInSetPtr = nullptr) {
        const FSparseArrayAllocationInfo Allocation = Elements.AddUninitialized();
        SetElementType* Element = ::new (Allocation.Pointer) SetElementType(InPlace, Forward<ArgsType>(Args));
        return Place(
            Allocation.Index, *Element, KeyFuncs::GetKeyHash(KeyFuncs::GetSetKey(Element->Value)), bIsAlreadyInSetPtr);
    }
    template <typename ArgsType>
    FSetElementId EmplaceByHash(uint32 KeyHash, ArgsType&& Args, bool* bIsAlreadyInSetPtr = nullptr) {
        const FSparseArrayAllocationInfo Allocation = Elements.AddUninitialized();
        SetElementType* Element = ::new (Allocation.Pointer) SetElementType(InPlace, Forward<ArgsType>(Args));
        return Place(Allocation.Index, *Element, KeyHash, bIsAlreadyInSetPtr);
    }
    /** Like Add, but keeps an element that is there already. */
    ElementType& FindOrAdd(const ElementType& InElement, bool* bIsAlreadyInSetPtr = nullptr) {
        const FSetElementId Found = FindId(KeyFuncs::GetSetKey(InElement));
        if (bIsAlreadyInSetPtr) {
            *bIsAlreadyInSetPtr = Found.IsValidId();
        }
        return Found.IsValidId() ? (*this)[Found] : (*this)[Add(InElement)];
    }
    template <typename ArrayAllocator>
    void Append(const TArray<ElementType, ArrayAllocator>& InElements) {
        Reserve(Elements.Num() + static_cast<int32>(InElements.Num()));
        for (const ElementType& Element : InElements) {
            Add(Element);
        }
    }
    template <typename OtherAllocator>
    void Append(const TSet<ElementType, KeyFuncs, OtherAllocator>& OtherSet) {
        for (const ElementType& Element : OtherSet) {
            Add(Element);
        }
    }
    void Append(std::initializer_list<ElementType> InitList) {
        for (const ElementType& Element : InitList) {
            Add(Element);
        }
    }

    void Remove(FSetElementId Id) {
        check(IsValidId(Id));
        Unlink(Id.AsInteger());
        Elements.RemoveAt(Id.AsInteger());
    }
    /** Removes all elements with that key; returns how many. */
    int32 Remove(KeyInitType Key) { return HashSize ? RemoveImpl(KeyFuncs::GetKeyHash(Key), Key) : 0; }
    template <typename ComparableKey>
    int32 RemoveByHash(uint32 KeyHash, const ComparableKey& Key) {
        return HashSize ? RemoveImpl(KeyHash, Key) : 0;
    }

    FSetElementId FindId(KeyInitType Key) const {
        return HashSize ? FindIdByHash(KeyFuncs::GetKeyHash(Key), Key) : FSetElementId();
    }
    template <typename ComparableKey>
    FSetElementId FindIdByHash(uint32 KeyHash, const ComparableKey& Key) const {
        if (HashSize) {
            for (FSetElementId Id = Bucket(KeyHash); Id.IsValidId(); Id = Elements[Id.AsInteger()].HashNextId) {
                if (KeyFuncs::Matches(KeyFuncs::GetSetKey(Elements[Id.AsInteger()].Value), Key)) {
                    return Id;
                }
            }
        }
        return FSetElementId();
    }
    ElementType* Find(KeyInitType Key) {
        const FSetElementId Id = FindId(Key);
        return Id.IsValidId() ? &(*this)[Id] : nullptr;
    }
    const ElementType* Find(KeyInitType Key) const { return const_cast<TSet*>(this)->Find(Key); }
    template <typename ComparableKey>
    ElementType* FindByHash(uint32 KeyHash, const ComparableKey& Key) {
        const FSetElementId Id = FindIdByHash(KeyHash, Key);
        return Id.IsValidId() ? &(*this)[Id] : nullptr;
    }
    template <typename ComparableKey>
    const ElementType* FindByHash(uint32 KeyHash, const ComparableKey& Key) const {
        return const_cast<TSet*>(this)->FindByHash(KeyHash, Key);
    }
    ElementType* FindArbitraryElement() {
        const int32 Index = Elements.FindNextAllocated(0);
        return Index == INDEX_NONE ? nullptr : &Elements[Index].Value;
    }
    const ElementType* FindArbitraryElement() const { return const_cast<TSet*>(this)->FindArbitraryElement(); }
    bool Contains(KeyInitType Key) const { return FindId(Key).IsValidId(); }
    template <typename ComparableKey>
    bool ContainsByHash(uint32 KeyHash, const ComparableKey& Key) const {
        return FindIdByHash(KeyHash, Key).IsValidId();
    }

    TSet Intersect(const TSet& OtherSet) const {
        return Filter([&](const ElementType& Element) { return OtherSet.Contains(KeyFuncs::GetSetKey(Element)); });
    }
    TSet Union(const TSet& OtherSet) const {
        TSet Result(*this);
        Result.Append(OtherSet);
        return Result;
    }
    /** Elements of this set that the other does not have. */
    TSet Difference(const TSet& OtherSet) const {
        return Filter([&](const ElementType& Element) { return !OtherSet.Contains(KeyFuncs::GetSetKey(Element)); });
    }
    bool Includes(const TSet& OtherSet) const {
        for (const ElementType& Element : OtherSet) {
            if (!Contains(KeyFuncs::GetSetKey(Element))) {
                return false;
            }
        }
        return true;
    }
    TArray<ElementType> Array() const {
        TArray<ElementType> Result;
        Result.Reserve(Num());
        for (const ElementType& Element : *this) {
            Result.Add(Element);
        }
        return Result;
    }
    template <typename PredicateClass>
    void Sort(const PredicateClass& Predicate) {
        Elements.Sort([&Predicate](const SetElementType& A, const SetElementType& B) {
            return UE::Core::Private::TDereferencePredicate<ElementType, PredicateClass>{Predicate}(A.Value, B.Value);
        });
        RehashAll();
    }
    friend bool LegacyCompareEqual(const TSet& A, const TSet& B) { return A.Num() == B.Num() && A.Includes(B); }

    template <bool bConst>
    class TBaseIterator {
        using SetType = std::conditional_t<bConst, const TSet, TSet>;
        using ItElementType = std::conditional_t<bConst, const InElementType, InElementType>;

    public:
        explicit TBaseIterator(SetType& InSet, int32 Start = 0)
            : Set(&InSet), Index(InSet.Elements.FindNextAllocated(Start)) {}
        TBaseIterator& operator++() {
            Index = Set->Elements.FindNextAllocated(Index + 1);
            return *this;
        }
        FSetElementId GetId() const { return FSetElementId::FromInteger(Index); }
        explicit operator bool() const { return Index != INDEX_NONE; }
        ItElementType& operator*() const { return Set->Elements[Index].Value; }
        ItElementType* operator->() const { return &Set->Elements[Index].Value; }
        bool operator==(const TBaseIterator& Other) const { return Index == Other.Index; }
        void RemoveCurrent() { Set->Remove(GetId()); }

    private:
        SetType* Set;
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
    FSetElementId& Bucket(uint32 KeyHash) const {
        return Hash.GetAllocation()[KeyHash & (static_cast<uint32>(HashSize) - 1)];
    }
    template <typename Predicate>
    TSet Filter(const Predicate& Pred) const {
        TSet Result;
        for (const ElementType& Element : *this) {
            if (Pred(Element)) {
                Result.Add(Element);
            }
        }
        return Result;
    }
    /** Puts a newly made element in its chain, or into the place of one with the same key. */
    FSetElementId Place(int32 Index, SetElementType& Element, uint32 KeyHash, bool* bIsAlreadyInSetPtr) {
        bool bReplaced = false;
        FSetElementId Id = FSetElementId::FromInteger(Index);
        if constexpr (!KeyFuncs::bAllowDuplicateKeys) {
            if (Elements.Num() != 1) {
                const FSetElementId Existing = FindIdByHash(KeyHash, KeyFuncs::GetSetKey(Element.Value));
                if (Existing.IsValidId()) {
                    bReplaced = true;
                    ElementType& Target = Elements[Existing.AsInteger()].Value;
                    DestructItem(&Target);
                    RelocateConstructItems<ElementType>(static_cast<void*>(&Target), &Element.Value, 1);
                    Elements.RemoveAtUninitialized(Index);
                    Id = Existing;
                }
            }
        }
        if (!bReplaced && !ConditionalRehash(Elements.Num(), EAllowShrinking::No)) {
            LinkElement(Index, Element, KeyHash);
        }
        if (bIsAlreadyInSetPtr) {
            *bIsAlreadyInSetPtr = bReplaced;
        }
        return Id;
    }
    void LinkElement(int32 Index, const SetElementType& Element, uint32 KeyHash) const {
        Element.HashIndex = static_cast<int32>(KeyHash & (static_cast<uint32>(HashSize) - 1));
        FSetElementId& First = Bucket(static_cast<uint32>(Element.HashIndex));
        Element.HashNextId = First;
        First = FSetElementId::FromInteger(Index);
    }
    void Unlink(int32 Index) {
        if (!HashSize) {
            return;
        }
        const SetElementType& Element = Elements[Index];
        for (FSetElementId* Next = &Bucket(static_cast<uint32>(Element.HashIndex)); Next->IsValidId();
            Next = &Elements[Next->AsInteger()].HashNextId) {
            if (Next->AsInteger() == Index) {
                *Next = Element.HashNextId;
                break;
            }
        }
    }
    template <typename ComparableKey>
    int32 RemoveImpl(uint32 KeyHash, const ComparableKey& Key) {
        int32 NumRemoved = 0;
        FSetElementId* Next = &Bucket(KeyHash);
        while (Next->IsValidId()) {
            const int32 Index = Next->AsInteger();
            SetElementType& Element = Elements[Index];
            if (KeyFuncs::Matches(KeyFuncs::GetSetKey(Element.Value), Key)) {
                *Next = Element.HashNextId;
                Elements.RemoveAt(Index);
                ++NumRemoved;
                if constexpr (!KeyFuncs::bAllowDuplicateKeys) {
                    break;
                }
            } else {
                Next = &Element.HashNextId;
            }
        }
        return NumRemoved;
    }
    bool ConditionalRehash(int32 NumHashedElements, EAllowShrinking AllowShrinking) {
        const int32 Desired =
            static_cast<int32>(Allocator::GetNumberOfHashBuckets(static_cast<uint32>(NumHashedElements)));
        const bool bNeeded =
            NumHashedElements > 0 &&
            (!HashSize || HashSize < Desired || (HashSize > Desired && AllowShrinking == EAllowShrinking::Yes));
        if (bNeeded) {
            HashSize = Desired;
            RehashAll();
        }
        return bNeeded;
    }
    void RehashAll() {
        if (!HashSize && Elements.Num()) {
            HashSize = static_cast<int32>(Allocator::GetNumberOfHashBuckets(static_cast<uint32>(Elements.Num())));
        }
        if (!HashSize) {
            return;
        }
        Hash.ResizeAllocation(0, HashSize, sizeof(FSetElementId));
        ClearHash();
        for (auto It = Elements.CreateConstIterator(); It; ++It) {
            LinkElement(It.GetIndex(), *It, KeyFuncs::GetKeyHash(KeyFuncs::GetSetKey(It->Value)));
        }
    }
    void ClearHash() {
        for (int32 Index = 0; Index < HashSize; ++Index) {
            Hash.GetAllocation()[Index] = FSetElementId();
        }
    }

    ElementArrayType Elements;
    HashType Hash;
    int32 HashSize = 0;
};
template <typename E, typename K, typename A>
struct TIsTSet<TSet<E, K, A>> : UE::Core::Private::TBoolTrait<true> {};

#include "Containers/ScriptSet.h"
