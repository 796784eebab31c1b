// SPDX-License-Identifier: MIT
/** TMap and TMultiMap: sets of pairs, hashed by key. See Epic's "Map Containers". */
#pragma once

#include "Containers/Set.h"
#include "Templates/Tuple.h"

template <typename KeyType, typename ValueType, bool bInAllowDuplicateKeys>
struct TDefaultMapHashableKeyFuncs : BaseKeyFuncs<TPair<KeyType, ValueType>, KeyType, bInAllowDuplicateKeys> {
    typedef typename TTypeTraits<KeyType>::ConstInitType KeyInitType;
    typedef const TPair<KeyType, ValueType>& ElementInitType;
    static KeyInitType GetSetKey(ElementInitType Element) { return Element.Key; }
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
template <typename KeyType, typename ValueType, bool bInAllowDuplicateKeys>
using TDefaultMapKeyFuncs = TDefaultMapHashableKeyFuncs<KeyType, ValueType, bInAllowDuplicateKeys>;

/** What TMap and TMultiMap share. */
template <typename InKeyType, typename InValueType, typename SetAllocator, typename KeyFuncs>
class TMapBase {
public:
    using KeyType = InKeyType;
    using ValueType = InValueType;
    typedef typename TTypeTraits<KeyType>::ConstPointerType KeyConstPointerType;
    typedef typename TTypeTraits<KeyType>::ConstInitType KeyInitType;
    typedef TPair<KeyType, ValueType> ElementType;
    using ElementSetType = TSet<ElementType, KeyFuncs, SetAllocator>;

    void Empty(int32 ExpectedNumElements = 0) { Pairs.Empty(ExpectedNumElements); }
    void Reset() { Pairs.Reset(); }
    void Shrink() { Pairs.Shrink(); }
    void Compact() { Pairs.Compact(); }
    void CompactStable() { Pairs.CompactStable(); }
    void Reserve(int32 Number) { Pairs.Reserve(Number); }
    bool IsEmpty() const { return Pairs.IsEmpty(); }
    int32 Num() const { return Pairs.Num(); }
    int32 GetMaxIndex() const { return Pairs.GetMaxIndex(); }
    bool IsValidId(FSetElementId Id) const { return Pairs.IsValidId(Id); }
    ElementType& Get(FSetElementId Id) { return Pairs[Id]; }
    const ElementType& Get(FSetElementId Id) const { return Pairs[Id]; }
    SIZE_T GetAllocatedSize() const { return Pairs.GetAllocatedSize(); }

    /** The unique keys, in order; returns how many. */
    template <typename Allocator>
    int32 GetKeys(TArray<KeyType, Allocator>& OutKeys) const {
        OutKeys.Reset();
        TSet<KeyType> Seen;
        for (const ElementType& Pair : Pairs) {
            if constexpr (KeyFuncs::bAllowDuplicateKeys) {
                bool bSeen = false;
                Seen.Add(Pair.Key, &bSeen);
                if (bSeen) {
                    continue;
                }
            }
            OutKeys.Add(Pair.Key);
        }
        return static_cast<int32>(OutKeys.Num());
    }
    template <typename Allocator>
    int32 GetKeys(TSet<KeyType, Allocator>& OutKeys) const {
        OutKeys.Reset();
        for (const ElementType& Pair : Pairs) {
            OutKeys.Add(Pair.Key);
        }
        return OutKeys.Num();
    }
    template <typename Allocator>
    void GenerateKeyArray(TArray<KeyType, Allocator>& OutArray) const {
        OutArray.Empty(Num());
        for (const ElementType& Pair : Pairs) {
            OutArray.Add(Pair.Key);
        }
    }
    template <typename Allocator>
    void GenerateValueArray(TArray<ValueType, Allocator>& OutArray) const {
        OutArray.Empty(Num());
        for (const ElementType& Pair : Pairs) {
            OutArray.Add(Pair.Value);
        }
    }

    ValueType& Add(const KeyType& InKey, const ValueType& InValue) { return Emplace(InKey, InValue); }
    ValueType& Add(const KeyType& InKey, ValueType&& InValue) { return Emplace(InKey, MoveTempIfPossible(InValue)); }
    ValueType& Add(KeyType&& InKey, const ValueType& InValue) { return Emplace(MoveTempIfPossible(InKey), InValue); }
    ValueType& Add(KeyType&& InKey, ValueType&& InValue) {
        return Emplace(MoveTempIfPossible(InKey), MoveTempIfPossible(InValue));
    }
    ValueType& Add(const KeyType& InKey) { return Emplace(InKey, ValueType()); }
    ValueType& Add(KeyType&& InKey) { return Emplace(MoveTempIfPossible(InKey), ValueType()); }
    FSetElementId Add(const ElementType& InPair) { return Pairs.Add(InPair); }
    FSetElementId Add(ElementType&& InPair) { return Pairs.Add(MoveTemp(InPair)); }
    template <typename InitKeyType = KeyType, typename InitValueType = ValueType>
    ValueType& AddByHash(uint32 KeyHash, InitKeyType&& InKey, InitValueType&& InValue) {
        const FSetElementId Id =
            Pairs.AddByHash(KeyHash, ElementType(Forward<InitKeyType>(InKey), Forward<InitValueType>(InValue)));
        return Pairs[Id].Value;
    }
    template <typename InitKeyType, typename InitValueType>
    ValueType& Emplace(InitKeyType&& InKey, InitValueType&& InValue) {
        const FSetElementId Id = Pairs.Add(ElementType(Forward<InitKeyType>(InKey), Forward<InitValueType>(InValue)));
        return Pairs[Id].Value;
    }
    template <typename InitKeyType>
    ValueType& Emplace(InitKeyType&& InKey) {
        return Emplace(Forward<InitKeyType>(InKey), ValueType());
    }
    int32 Remove(KeyInitType InKey) { return Pairs.Remove(InKey); }
    template <typename ComparableKey>
    int32 RemoveByHash(uint32 KeyHash, const ComparableKey& Key) {
        return Pairs.RemoveByHash(KeyHash, Key);
    }
    /** A key with that value, or null. Looks at every pair. */
    const KeyType* FindKey(const ValueType& Value) const {
        for (const ElementType& Pair : Pairs) {
            if (Pair.Value == Value) {
                return &Pair.Key;
            }
        }
        return nullptr;
    }
    template <typename Allocator, typename Predicate>
    void FilterInto(TMap<KeyType, ValueType, Allocator, KeyFuncs>& Result, const Predicate& Pred) const {
        for (const ElementType& Pair : Pairs) {
            if (Pred(Pair)) {
                Result.Add(Pair);
            }
        }
    }
    ValueType* Find(KeyInitType Key) {
        ElementType* Pair = Pairs.Find(Key);
        return Pair ? &Pair->Value : nullptr;
    }
    const ValueType* Find(KeyInitType Key) const { return const_cast<TMapBase*>(this)->Find(Key); }
    template <typename ComparableKey>
    ValueType* FindByHash(uint32 KeyHash, const ComparableKey& Key) {
        ElementType* Pair = Pairs.FindByHash(KeyHash, Key);
        return Pair ? &Pair->Value : nullptr;
    }
    template <typename ComparableKey>
    const ValueType* FindByHash(uint32 KeyHash, const ComparableKey& Key) const {
        return const_cast<TMapBase*>(this)->FindByHash(KeyHash, Key);
    }
    /** A copy of the value, or a default-made one. */
    ValueType FindRef(KeyInitType Key) const {
        const ElementType* Pair = Pairs.Find(Key);
        return Pair ? Pair->Value : ValueType();
    }
    ValueType FindRef(KeyInitType Key, const ValueType& DefaultValue) const {
        const ElementType* Pair = Pairs.Find(Key);
        return Pair ? Pair->Value : DefaultValue;
    }
    ValueType& FindOrAdd(const KeyType& Key) {
        ElementType* Pair = Pairs.Find(Key);
        return Pair ? Pair->Value : Add(Key);
    }
    ValueType& FindOrAdd(KeyType&& Key) {
        ElementType* Pair = Pairs.Find(Key);
        return Pair ? Pair->Value : Add(MoveTempIfPossible(Key));
    }
    template <typename InitValueType>
    ValueType& FindOrAdd(const KeyType& Key, InitValueType&& Value) {
        ElementType* Pair = Pairs.Find(Key);
        return Pair ? Pair->Value : Emplace(Key, Forward<InitValueType>(Value));
    }
    const ElementType* FindArbitraryElement() const { return Pairs.FindArbitraryElement(); }
    bool Contains(KeyInitType Key) const { return Pairs.Contains(Key); }
    template <typename ComparableKey>
    bool ContainsByHash(uint32 KeyHash, const ComparableKey& Key) const {
        return Pairs.ContainsByHash(KeyHash, Key);
    }
    template <typename PredicateType>
    void KeySort(const PredicateType& Predicate) {
        Pairs.Sort([&Predicate](const ElementType& A, const ElementType& B) {
            return UE::Core::Private::TDereferencePredicate<KeyType, PredicateType>{Predicate}(A.Key, B.Key);
        });
    }
    template <typename PredicateType>
    void ValueSort(const PredicateType& Predicate) {
        Pairs.Sort([&Predicate](const ElementType& A, const ElementType& B) {
            return UE::Core::Private::TDereferencePredicate<ValueType, PredicateType>{Predicate}(A.Value, B.Value);
        });
    }
    /** Same keys with equal values, in whatever order. */
    bool OrderIndependentCompareEqual(const TMapBase& Other) const {
        if (Num() != Other.Num()) {
            return false;
        }
        for (const ElementType& Pair : Pairs) {
            const ValueType* Value = Other.Find(Pair.Key);
            if (!Value || !(*Value == Pair.Value)) {
                return false;
            }
        }
        return true;
    }

    template <bool bConst>
    class TBaseIterator {
        using SetIterator =
            std::conditional_t<bConst, typename ElementSetType::TConstIterator, typename ElementSetType::TIterator>;
        using ItElementType = std::conditional_t<bConst, const ElementType, ElementType>;
        using ItValueType = std::conditional_t<bConst, const ValueType, ValueType>;
        using MapType = std::conditional_t<bConst, const TMapBase, TMapBase>;

    public:
        explicit TBaseIterator(MapType& Map, int32 Start = 0) : It(Map.Pairs, Start) {}
        TBaseIterator& operator++() {
            ++It;
            return *this;
        }
        explicit operator bool() const { return static_cast<bool>(It); }
        bool operator==(const TBaseIterator& Other) const { return It == Other.It; }
        FSetElementId GetId() const { return It.GetId(); }
        const KeyType& Key() const { return It->Key; }
        ItValueType& Value() const { return It->Value; }
        ItElementType& operator*() const { return *It; }
        ItElementType* operator->() const { return &*It; }
        void RemoveCurrent() { It.RemoveCurrent(); }

    private:
        SetIterator It;
    };
    using TIterator = TBaseIterator<false>;
    using TConstIterator = TBaseIterator<true>;
    TIterator CreateIterator() { return TIterator(*this); }
    TConstIterator CreateConstIterator() const { return TConstIterator(*this); }
    TIterator begin() { return TIterator(*this); }
    TConstIterator begin() const { return TConstIterator(*this); }
    TIterator end() { return TIterator(*this, GetMaxIndex()); }
    TConstIterator end() const { return TConstIterator(*this, GetMaxIndex()); }

    /** Visits the pairs with one key. */
    class TConstKeyIterator {
    public:
        TConstKeyIterator(const TMapBase& InMap, KeyInitType InKey) : Map(InMap), Key(InKey), It(InMap) { Skip(); }
        TConstKeyIterator& operator++() {
            ++It;
            Skip();
            return *this;
        }
        explicit operator bool() const { return static_cast<bool>(It); }
        const ValueType& Value() const { return It.Value(); }

    private:
        void Skip() {
            while (It && !KeyFuncs::Matches(It.Key(), Key)) {
                ++It;
            }
        }
        const TMapBase& Map;
        KeyType Key;
        TConstIterator It;
    };
    TConstKeyIterator CreateConstKeyIterator(KeyInitType InKey) const { return TConstKeyIterator(*this, InKey); }

protected:
    TMapBase() = default;
    ElementSetType Pairs;
};

template <typename KeyType, typename ValueType, typename SetAllocator, typename KeyFuncs>
class TMap : public TMapBase<KeyType, ValueType, SetAllocator, KeyFuncs> {
    using Super = TMapBase<KeyType, ValueType, SetAllocator, KeyFuncs>;
    static_assert(!KeyFuncs::bAllowDuplicateKeys, "TMap cannot be used with key functions that allow duplicates");

public:
    typedef typename Super::KeyInitType KeyInitType;
    typedef typename Super::ElementType ElementType;

    TMap() = default;
    TMap(std::initializer_list<TPair<KeyType, ValueType>> InitList) {
        this->Reserve(static_cast<int32>(InitList.size()));
        for (const ElementType& Pair : InitList) {
            this->Add(Pair);
        }
    }
    template <typename OtherAllocator>
    void Append(const TMap<KeyType, ValueType, OtherAllocator, KeyFuncs>& OtherMap) {
        this->Reserve(this->Num() + OtherMap.Num());
        for (const auto& Pair : OtherMap) {
            this->Add(Pair);
        }
    }
    template <typename Predicate>
    TMap FilterByPredicate(Predicate Pred) const {
        TMap Result;
        this->FilterInto(Result, Pred);
        return Result;
    }
    bool RemoveAndCopyValue(KeyInitType Key, ValueType& OutRemovedValue) {
        const FSetElementId Id = this->Pairs.FindId(Key);
        if (!Id.IsValidId()) {
            return false;
        }
        OutRemovedValue = MoveTempIfPossible(this->Pairs[Id].Value);
        this->Pairs.Remove(Id);
        return true;
    }
    ValueType FindAndRemoveChecked(KeyInitType Key) {
        const FSetElementId Id = this->Pairs.FindId(Key);
        checkf(Id.IsValidId(), TEXT("FindAndRemoveChecked: the key is not in the map"));
        ValueType Result = MoveTempIfPossible(this->Pairs[Id].Value);
        this->Pairs.Remove(Id);
        return Result;
    }
    ValueType& FindChecked(KeyInitType Key) {
        ElementType* Pair = this->Pairs.Find(Key);
        checkf(Pair != nullptr, TEXT("FindChecked: the key is not in the map"));
        return Pair->Value;
    }
    const ValueType& FindChecked(KeyInitType Key) const { return const_cast<TMap*>(this)->FindChecked(Key); }
    ValueType& operator[](KeyInitType Key) { return FindChecked(Key); }
    const ValueType& operator[](KeyInitType Key) const { return FindChecked(Key); }
};

template <typename KeyType, typename ValueType, typename SetAllocator, typename KeyFuncs>
class TMultiMap : public TMapBase<KeyType, ValueType, SetAllocator, KeyFuncs> {
    using Super = TMapBase<KeyType, ValueType, SetAllocator, KeyFuncs>;
    static_assert(KeyFuncs::bAllowDuplicateKeys, "TMultiMap needs key functions that allow duplicates");

public:
    typedef typename Super::KeyInitType KeyInitType;
    typedef typename Super::ElementType ElementType;

    TMultiMap() = default;
    TMultiMap(std::initializer_list<TPair<KeyType, ValueType>> InitList) {
        for (const ElementType& Pair : InitList) {
            this->Add(Pair);
        }
    }
    /** All values of a key; the latest first unless order is asked for. */
    template <typename Allocator>
    void MultiFind(KeyInitType Key, TArray<ValueType, Allocator>& OutValues, bool bMaintainOrder = false) const {
        for (auto It = this->CreateConstKeyIterator(Key); It; ++It) {
            OutValues.Add(It.Value());
        }
        if (!bMaintainOrder) {
            std::reverse(OutValues.begin(), OutValues.end());
        }
    }
    ValueType* FindPair(KeyInitType Key, const ValueType& Value) {
        for (ElementType& Pair : this->Pairs) {
            if (KeyFuncs::Matches(Pair.Key, Key) && Pair.Value == Value) {
                return &Pair.Value;
            }
        }
        return nullptr;
    }
    ValueType& AddUnique(const KeyType& InKey, const ValueType& InValue) {
        ValueType* Found = FindPair(InKey, InValue);
        return Found ? *Found : this->Add(InKey, InValue);
    }
    using Super::Remove;
    int32 Remove(KeyInitType InKey, const ValueType& InValue) {
        int32 NumRemoved = 0;
        for (auto It = this->CreateIterator(); It; ++It) {
            if (KeyFuncs::Matches(It.Key(), InKey) && It.Value() == InValue) {
                It.RemoveCurrent();
                ++NumRemoved;
            }
        }
        return NumRemoved;
    }
    int32 RemoveSingle(KeyInitType InKey, const ValueType& InValue) {
        for (auto It = this->CreateIterator(); It; ++It) {
            if (KeyFuncs::Matches(It.Key(), InKey) && It.Value() == InValue) {
                It.RemoveCurrent();
                return 1;
            }
        }
        return 0;
    }
    int32 Num(KeyInitType Key) const {
        int32 Count = 0;
        for (auto It = this->CreateConstKeyIterator(Key); It; ++It) {
            ++Count;
        }
        return Count;
    }
    using Super::Num;
};
template <typename K, typename V, typename A, typename F>
struct TIsTMap<TMap<K, V, A, F>> : UE::Core::Private::TBoolTrait<true> {};

/** Where the value is in a pair, and the set's layout. */
struct FScriptMapLayout {
    int32 ValueOffset;
    FScriptSetLayout SetLayout;
};

/** A map whose types are known only at run time, with the same bytes as any TMap. Pair pointers point to the key. */
class FScriptMap {
public:
    static CORE_API FScriptMapLayout GetScriptLayout(
        int32 KeySize, int32 KeyAlignment, int32 ValueSize, int32 ValueAlignment);

    FScriptMap() = default;
    UE_NONCOPYABLE(FScriptMap)

    bool IsValidIndex(int32 Index) const { return Pairs.IsValidIndex(Index); }
    bool IsEmpty() const { return Pairs.IsEmpty(); }
    int32 Num() const { return Pairs.Num(); }
    int32 NumUnchecked() const { return Pairs.Num(); }
    int32 GetMaxIndex() const { return Pairs.GetMaxIndex(); }
    void* GetData(int32 Index, const FScriptMapLayout& Layout) { return Pairs.GetData(Index, Layout.SetLayout); }
    const void* GetData(int32 Index, const FScriptMapLayout& Layout) const {
        return Pairs.GetData(Index, Layout.SetLayout);
    }
    void MoveAssign(FScriptMap& Other, const FScriptMapLayout& Layout) {
        Pairs.MoveAssign(Other.Pairs, Layout.SetLayout);
    }
    void Empty(int32 Slack, const FScriptMapLayout& Layout) { Pairs.Empty(Slack, Layout.SetLayout); }
    void RemoveAt(int32 Index, const FScriptMapLayout& Layout) { Pairs.RemoveAt(Index, Layout.SetLayout); }
    /** Adds a slot that is in no chain: construct key and value, then Rehash. */
    int32 AddUninitialized(const FScriptMapLayout& Layout) { return Pairs.AddUninitialized(Layout.SetLayout); }
    void Rehash(const FScriptMapLayout& Layout, TFunctionRef<uint32(const void*)> GetKeyHash) {
        Pairs.Rehash(Layout.SetLayout, GetKeyHash);
    }
    CORE_API int32 FindPairIndex(const void* Key, const FScriptMapLayout& MapLayout,
        TFunctionRef<uint32(const void*)> GetKeyHash, TFunctionRef<bool(const void*, const void*)> KeyEqualityFn) const;
    CORE_API uint8* FindValue(const void* Key, const FScriptMapLayout& MapLayout,
        TFunctionRef<uint32(const void*)> GetKeyHash, TFunctionRef<bool(const void*, const void*)> KeyEqualityFn);
    /** Adds a pair, or replaces the key and assigns the value of the pair that is there. */
    CORE_API void Add(const void* Key, const void* Value, const FScriptMapLayout& MapLayout,
        TFunctionRef<uint32(const void*)> GetKeyHash, TFunctionRef<bool(const void*, const void*)> KeyEqualityFn,
        TFunctionRef<void(void*)> KeyConstructAndAssignFn, TFunctionRef<void(void*)> ValueConstructAndAssignFn,
        TFunctionRef<void(void*)> ValueAssignFn, TFunctionRef<void(void*)> DestructKeyFn,
        TFunctionRef<void(void*)> DestructValueFn);
    /** Index of the pair with that key, or of a new one that ConstructPairFn(key, value) has constructed. */
    CORE_API int32 FindOrAdd(const void* Key, const FScriptMapLayout& MapLayout,
        TFunctionRef<uint32(const void*)> GetKeyHash, TFunctionRef<bool(const void*, const void*)> KeyEqualityFn,
        TFunctionRef<void(void*, void*)> ConstructPairFn);

private:
    FScriptSet Pairs;
};
static_assert(sizeof(FScriptMap) == sizeof(TMap<int32, int32>), "FScriptMap must have TMap's layout");
