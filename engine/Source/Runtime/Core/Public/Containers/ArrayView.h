// SPDX-License-Identifier: MIT
/** TArrayView: a borrowed run of elements. */
#pragma once

#include "Containers/Array.h"

namespace UE::Core::Private {
// Unqualified calls outside any class, so that neither members hide GetData nor qualification stops argument lookup.
template <typename RangeType>
constexpr auto DataOf(RangeType&& Range) -> decltype(GetData(Range)) {
    return GetData(Range);
}
template <typename RangeType>
constexpr auto CountOf(RangeType&& Range) -> decltype(GetNum(Range)) {
    return GetNum(Range);
}
} // namespace UE::Core::Private

template <typename InElementType, typename InSizeType>
class TArrayView {
public:
    using ElementType = InElementType;
    using SizeType = InSizeType;

    constexpr TArrayView() : DataPtr(nullptr), ArrayNum(0) {}
    template <typename OtherElement>
        requires std::is_convertible_v<OtherElement (*)[], ElementType (*)[]>
    constexpr TArrayView(OtherElement* InData, SizeType InCount) : DataPtr(InData), ArrayNum(InCount) {
        check(InCount >= 0);
    }
    template <typename RangeType>
        requires(!std::is_same_v<std::remove_cvref_t<RangeType>, TArrayView> &&
                    requires(RangeType& Range) {
                        { UE::Core::Private::DataOf(Range) } -> std::convertible_to<ElementType*>;
                        UE::Core::Private::CountOf(Range);
                    })
    constexpr TArrayView(RangeType&& Range)
        : DataPtr(UE::Core::Private::DataOf(Range)),
          ArrayNum(static_cast<SizeType>(UE::Core::Private::CountOf(Range))) {}
    constexpr TArrayView(std::initializer_list<std::remove_const_t<ElementType>> List)
        requires std::is_const_v<ElementType>
        : DataPtr(List.begin()), ArrayNum(static_cast<SizeType>(List.size())) {}

    constexpr ElementType* GetData() const { return DataPtr; }
    static constexpr SIZE_T GetTypeSize() { return sizeof(ElementType); }
    constexpr bool IsValidIndex(SizeType Index) const { return Index >= 0 && Index < ArrayNum; }
    constexpr bool IsEmpty() const { return ArrayNum == 0; }
    constexpr SizeType Num() const { return ArrayNum; }
    constexpr SIZE_T NumBytes() const { return static_cast<SIZE_T>(ArrayNum) * sizeof(ElementType); }
    constexpr ElementType& operator[](SizeType Index) const {
        checkf(IsValidIndex(Index), TEXT("Array index out of bounds: %lld into a view of size %lld"),
            static_cast<long long>(Index), static_cast<long long>(ArrayNum));
        return DataPtr[Index];
    }
    ElementType& Last(SizeType IndexFromTheEnd = 0) const { return (*this)[ArrayNum - IndexFromTheEnd - 1]; }
    /** Length elements from Index on, checked. */
    TArrayView Slice(SizeType Index, SizeType InNum) const {
        check(Index >= 0 && InNum >= 0 && Index + InNum <= ArrayNum);
        return TArrayView(DataPtr + Index, InNum);
    }
    TArrayView Left(SizeType Count) const { return TArrayView(DataPtr, Clamped(Count)); }
    TArrayView LeftChop(SizeType Count) const { return TArrayView(DataPtr, Clamped(ArrayNum - Count)); }
    TArrayView Right(SizeType Count) const {
        const SizeType Length = Clamped(Count);
        return TArrayView(DataPtr + ArrayNum - Length, Length);
    }
    TArrayView RightChop(SizeType Count) const { return Right(ArrayNum - Count); }
    TArrayView Mid(SizeType Index, SizeType Count = TNumericLimits<SizeType>::Max()) const {
        const SizeType Start = Clamped(Index);
        const SizeType Rest = ArrayNum - Start;
        return TArrayView(DataPtr + Start, Count < Rest ? (Count < 0 ? 0 : Count) : Rest);
    }
    SizeType Find(const ElementType& Item) const {
        for (SizeType Index = 0; Index < ArrayNum; ++Index) {
            if (DataPtr[Index] == Item) {
                return Index;
            }
        }
        return INDEX_NONE;
    }
    template <typename ComparisonType>
    bool Contains(const ComparisonType& Item) const {
        return FindByKey(Item) != nullptr;
    }
    template <typename KeyType>
    ElementType* FindByKey(const KeyType& Key) const {
        return FindByPredicate([&Key](const auto& Element) { return Element == Key; });
    }
    template <typename Predicate>
    ElementType* FindByPredicate(Predicate Pred) const {
        const SizeType Index = IndexOfByPredicate(Pred);
        return Index == INDEX_NONE ? nullptr : DataPtr + Index;
    }
    template <typename Predicate>
    SizeType IndexOfByPredicate(Predicate Pred) const {
        for (SizeType Index = 0; Index < ArrayNum; ++Index) {
            if (::Invoke(Pred, DataPtr[Index])) {
                return Index;
            }
        }
        return INDEX_NONE;
    }
    template <typename Predicate>
    bool ContainsByPredicate(Predicate Pred) const {
        return IndexOfByPredicate(Pred) != INDEX_NONE;
    }
    void Sort() const { Sort(TLess<>()); }
    template <typename PredicateClass>
    void Sort(const PredicateClass& Predicate) const {
        std::sort(DataPtr, DataPtr + ArrayNum,
            UE::Core::Private::TDereferencePredicate<std::remove_const_t<ElementType>, PredicateClass>{Predicate});
    }
    constexpr ElementType* begin() const { return DataPtr; }
    constexpr ElementType* end() const { return DataPtr + ArrayNum; }

private:
    SizeType Clamped(SizeType Count) const { return Count < 0 ? 0 : (Count > ArrayNum ? ArrayNum : Count); }
    ElementType* DataPtr;
    SizeType ArrayNum;
};
template <typename T, typename S>
struct TIsContiguousContainer<TArrayView<T, S>> : UE::Core::Private::TBoolTrait<true> {};

template <typename RangeType>
auto MakeArrayView(RangeType&& Range) {
    return TArrayView<std::remove_pointer_t<decltype(GetData(Range))>>(Forward<RangeType>(Range));
}
template <typename ElementType>
auto MakeArrayView(ElementType* Pointer, int32 Size) {
    return TArrayView<ElementType>(Pointer, Size);
}
template <typename ElementType>
TArrayView<const ElementType> MakeArrayView(std::initializer_list<ElementType> List) {
    return TArrayView<const ElementType>(List.begin(), static_cast<int32>(List.size()));
}
template <typename RangeType>
auto MakeConstArrayView(RangeType&& Range) {
    return TArrayView<const std::remove_pointer_t<decltype(GetData(Range))>>(Forward<RangeType>(Range));
}
template <typename ElementType>
auto MakeConstArrayView(const ElementType* Pointer, int32 Size) {
    return TArrayView<const ElementType>(Pointer, Size);
}
