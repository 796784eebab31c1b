// SPDX-License-Identifier: MIT
/** TIndirectArray: owns elements by pointer, so that their addresses do not change. */
#pragma once

#include "Containers/Array.h"

template <typename T, typename Allocator = FDefaultAllocator>
class TIndirectArray {
public:
    using ElementType = T;
    TIndirectArray() = default;
    TIndirectArray(TIndirectArray&&) = default;
    TIndirectArray(const TIndirectArray& Other) {
        for (const T& Item : Other) {
            Add(new T(Item));
        }
    }
    TIndirectArray& operator=(TIndirectArray Other) {
        ::Swap(Array, Other.Array);
        return *this;
    }
    ~TIndirectArray() { Empty(); }

    int32 Num() const { return Array.Num(); }
    bool IsEmpty() const { return Array.IsEmpty(); }
    bool IsValidIndex(int32 Index) const { return Array.IsValidIndex(Index); }
    T& operator[](int32 Index) { return *Array[Index]; }
    const T& operator[](int32 Index) const { return *Array[Index]; }
    T& Last(int32 IndexFromTheEnd = 0) { return *Array.Last(IndexFromTheEnd); }
    /** Takes ownership of an object made with new. */
    int32 Add(T* Item) { return Array.Add(Item); }
    void Insert(T* Item, int32 Index) { Array.Insert(Item, Index); }
    void RemoveAt(int32 Index, int32 Count = 1) {
        for (int32 It = Index; It < Index + Count; ++It) {
            delete Array[It];
        }
        Array.RemoveAt(Index, Count);
    }
    void Swap(int32 A, int32 B) { Array.Swap(A, B); }
    void Reset() { Empty(); }
    void Reserve(int32 Number) { Array.Reserve(Number); }
    void Empty(int32 Slack = 0) {
        for (T* Item : Array) {
            delete Item;
        }
        Array.Empty(Slack);
    }

    template <bool bConst>
    class TBaseIterator {
        using PointerType = T* const*;

    public:
        explicit TBaseIterator(PointerType InAt) : At(InAt) {}
        TBaseIterator& operator++() {
            ++At;
            return *this;
        }
        std::conditional_t<bConst, const T, T>& operator*() const { return **At; }
        bool operator==(const TBaseIterator& Other) const { return At == Other.At; }

    private:
        PointerType At;
    };
    TBaseIterator<false> begin() { return TBaseIterator<false>(Array.GetData()); }
    TBaseIterator<true> begin() const { return TBaseIterator<true>(Array.GetData()); }
    TBaseIterator<false> end() { return TBaseIterator<false>(Array.GetData() + Array.Num()); }
    TBaseIterator<true> end() const { return TBaseIterator<true>(Array.GetData() + Array.Num()); }

private:
    TArray<T*, Allocator> Array;
};
