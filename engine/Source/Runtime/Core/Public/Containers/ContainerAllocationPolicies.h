// SPDX-License-Identifier: MIT
/**
 * Allocation policies of the containers.
 * A policy has `ForElementType<T>` (typed) and, for type-erased containers, `ForAnyElementType`; both with
 * GetAllocation, ResizeAllocation, MoveToEmpty, CalculateSlack*, HasAllocation and GetInitialCapacity.
 */
#pragma once

#include "Containers/ContainersFwd.h"
#include "HAL/UnrealMemory.h"
#include "Templates/TypeCompatibleBytes.h"
#include "Templates/UnrealTemplate.h"

/** Whether a removal may give memory back. */
enum class EAllowShrinking : uint8 { No, Yes, Default = Yes };

template <int IndexSize>
struct TBitsToSizeType;
template <>
struct TBitsToSizeType<8> {
    using Type = int8;
};
template <>
struct TBitsToSizeType<16> {
    using Type = int16;
};
template <>
struct TBitsToSizeType<32> {
    using Type = int32;
};
template <>
struct TBitsToSizeType<64> {
    using Type = int64;
};

/** Stands for "any type" in type-erased containers. */
struct FScriptContainerElement {};

template <typename SizeType>
SizeType DefaultCalculateSlackReserve(SizeType NewMax, SIZE_T, bool, uint32 = DEFAULT_ALIGNMENT) {
    return NewMax;
}
/** Growth by three eighths plus a constant keeps appending linear; the first allocation is small. */
template <typename SizeType>
SizeType DefaultCalculateSlackGrow(SizeType NewMax, SizeType CurrentMax, SIZE_T, bool, uint32 = DEFAULT_ALIGNMENT) {
    const uint64 Wanted = static_cast<uint64>(NewMax);
    uint64 Result = 4;
    if (CurrentMax > 0 || Wanted > Result) {
        Result = Wanted + 3 * Wanted / 8 + 16;
    }
    const uint64 Limit = static_cast<uint64>(TNumericLimits<SizeType>::Max());
    return static_cast<SizeType>(Result > Limit ? Limit : Result);
}
/** Memory is given back only when much of it is unused. */
template <typename SizeType>
SizeType DefaultCalculateSlackShrink(
    SizeType NewMax, SizeType CurrentMax, SIZE_T BytesPerElement, bool, uint32 = DEFAULT_ALIGNMENT) {
    const SizeType SlackElements = CurrentMax - NewMax;
    const bool bTooManyBytes = static_cast<SIZE_T>(SlackElements) * BytesPerElement >= 16384;
    const bool bTooManyElements = 3 * static_cast<int64>(NewMax) < 2 * static_cast<int64>(CurrentMax);
    return ((bTooManyBytes || bTooManyElements) && (SlackElements > 64 || NewMax == 0)) ? NewMax : CurrentMax;
}

/** Elements on the heap. */
template <int IndexSize>
class TSizedHeapAllocator {
public:
    using SizeType = typename TBitsToSizeType<IndexSize>::Type;
    enum { NeedsElementType = false };
    enum { RequireRangeCheck = true };

    class ForAnyElementType {
    public:
        ForAnyElementType() : Data(nullptr) {}
        UE_NONCOPYABLE(ForAnyElementType)
        ~ForAnyElementType() {
            if (Data) {
                FMemory::Free(Data);
            }
        }
        void MoveToEmpty(ForAnyElementType& Other) {
            if (Data) {
                FMemory::Free(Data);
            }
            Data = Other.Data;
            Other.Data = nullptr;
        }
        FScriptContainerElement* GetAllocation() const { return static_cast<FScriptContainerElement*>(Data); }
        void ResizeAllocation(
            SizeType /*CurrentNum*/, SizeType NewMax, SIZE_T NumBytesPerElement, uint32 Alignment = DEFAULT_ALIGNMENT) {
            if (Data || NewMax) {
                Data = FMemory::Realloc(Data, static_cast<SIZE_T>(NewMax) * NumBytesPerElement, Alignment);
            }
        }
        SizeType CalculateSlackReserve(SizeType NewMax, SIZE_T Bytes, uint32 Alignment = DEFAULT_ALIGNMENT) const {
            return DefaultCalculateSlackReserve(NewMax, Bytes, true, Alignment);
        }
        SizeType CalculateSlackShrink(
            SizeType NewMax, SizeType CurrentMax, SIZE_T Bytes, uint32 Alignment = DEFAULT_ALIGNMENT) const {
            return DefaultCalculateSlackShrink(NewMax, CurrentMax, Bytes, true, Alignment);
        }
        SizeType CalculateSlackGrow(
            SizeType NewMax, SizeType CurrentMax, SIZE_T Bytes, uint32 Alignment = DEFAULT_ALIGNMENT) const {
            return DefaultCalculateSlackGrow(NewMax, CurrentMax, Bytes, true, Alignment);
        }
        SIZE_T GetAllocatedSize(SizeType CurrentMax, SIZE_T NumBytesPerElement) const {
            return static_cast<SIZE_T>(CurrentMax) * NumBytesPerElement;
        }
        bool HasAllocation() const { return Data != nullptr; }
        SizeType GetInitialCapacity() const { return 0; }

    private:
        void* Data;
    };

    template <typename ElementType>
    class ForElementType : public ForAnyElementType {
    public:
        ElementType* GetAllocation() const {
            return reinterpret_cast<ElementType*>(ForAnyElementType::GetAllocation());
        }
        void ResizeAllocation(SizeType CurrentNum, SizeType NewMax, SIZE_T NumBytesPerElement) {
            ForAnyElementType::ResizeAllocation(CurrentNum, NewMax, NumBytesPerElement, alignof(ElementType));
        }
    };
};
using FHeapAllocator = TSizedHeapAllocator<32>;

template <int IndexSize>
class TSizedDefaultAllocator : public TSizedHeapAllocator<IndexSize> {
public:
    using Typedef = TSizedHeapAllocator<IndexSize>;
};

/** The first NumInlineElements elements inside the container, more of them in the secondary allocator. */
template <uint32 NumInlineElements, int IndexSize = 32, typename SecondaryAllocator = TSizedDefaultAllocator<IndexSize>>
class TSizedInlineAllocator {
public:
    using SizeType = typename TBitsToSizeType<IndexSize>::Type;
    enum { NeedsElementType = true };
    enum { RequireRangeCheck = true };

    template <typename ElementType>
    class ForElementType {
    public:
        ForElementType() = default;
        UE_NONCOPYABLE(ForElementType)
        void MoveToEmpty(ForElementType& Other) {
            if (!Other.SecondaryData.HasAllocation()) {
                FMemory::Memcpy(
                    static_cast<void*>(InlineData), static_cast<const void*>(Other.InlineData), sizeof(InlineData));
            }
            SecondaryData.MoveToEmpty(Other.SecondaryData);
        }
        ElementType* GetAllocation() const {
            if (ElementType* Heap = SecondaryData.GetAllocation()) {
                return Heap;
            }
            return const_cast<ElementType*>(reinterpret_cast<const ElementType*>(InlineData));
        }
        void ResizeAllocation(SizeType CurrentNum, SizeType NewMax, SIZE_T NumBytesPerElement) {
            if (NewMax <= static_cast<SizeType>(NumInlineElements)) {
                if (SecondaryData.HasAllocation()) {
                    FMemory::Memcpy(static_cast<void*>(InlineData),
                        static_cast<const void*>(SecondaryData.GetAllocation()),
                        static_cast<SIZE_T>(CurrentNum) * NumBytesPerElement);
                    SecondaryData.ResizeAllocation(0, 0, NumBytesPerElement);
                }
            } else if (!SecondaryData.HasAllocation()) {
                SecondaryData.ResizeAllocation(0, NewMax, NumBytesPerElement);
                FMemory::Memcpy(static_cast<void*>(SecondaryData.GetAllocation()), static_cast<const void*>(InlineData),
                    static_cast<SIZE_T>(CurrentNum) * NumBytesPerElement);
            } else {
                SecondaryData.ResizeAllocation(CurrentNum, NewMax, NumBytesPerElement);
            }
        }
        SizeType CalculateSlackReserve(SizeType NewMax, SIZE_T Bytes) const {
            return NewMax <= static_cast<SizeType>(NumInlineElements)
                       ? static_cast<SizeType>(NumInlineElements)
                       : SecondaryData.CalculateSlackReserve(NewMax, Bytes);
        }
        SizeType CalculateSlackShrink(SizeType NewMax, SizeType CurrentMax, SIZE_T Bytes) const {
            return NewMax <= static_cast<SizeType>(NumInlineElements)
                       ? static_cast<SizeType>(NumInlineElements)
                       : SecondaryData.CalculateSlackShrink(NewMax, CurrentMax, Bytes);
        }
        SizeType CalculateSlackGrow(SizeType NewMax, SizeType CurrentMax, SIZE_T Bytes) const {
            return NewMax <= static_cast<SizeType>(NumInlineElements)
                       ? static_cast<SizeType>(NumInlineElements)
                       : SecondaryData.CalculateSlackGrow(NewMax, CurrentMax, Bytes);
        }
        SIZE_T GetAllocatedSize(SizeType CurrentMax, SIZE_T Bytes) const {
            return CurrentMax > static_cast<SizeType>(NumInlineElements)
                       ? SecondaryData.GetAllocatedSize(CurrentMax, Bytes)
                       : 0;
        }
        bool HasAllocation() const { return SecondaryData.HasAllocation(); }
        SizeType GetInitialCapacity() const { return static_cast<SizeType>(NumInlineElements); }

    private:
        TTypeCompatibleBytes<ElementType> InlineData[NumInlineElements];
        typename SecondaryAllocator::template ForElementType<ElementType> SecondaryData;
    };
    typedef void ForAnyElementType;
};
template <uint32 NumInlineElements, typename SecondaryAllocator = FDefaultAllocator>
using TInlineAllocator = TSizedInlineAllocator<NumInlineElements, 32, SecondaryAllocator>;

/** Room for NumInlineElements elements and no more. */
template <uint32 NumInlineElements>
class TFixedAllocator {
public:
    using SizeType = int32;
    enum { NeedsElementType = true };
    enum { RequireRangeCheck = true };

    template <typename ElementType>
    class ForElementType {
    public:
        ForElementType() = default;
        UE_NONCOPYABLE(ForElementType)
        void MoveToEmpty(ForElementType& Other) {
            FMemory::Memcpy(
                static_cast<void*>(InlineData), static_cast<const void*>(Other.InlineData), sizeof(InlineData));
        }
        ElementType* GetAllocation() const {
            return const_cast<ElementType*>(reinterpret_cast<const ElementType*>(InlineData));
        }
        void ResizeAllocation(SizeType, SizeType NewMax, SIZE_T) {
            checkf(NewMax <= static_cast<SizeType>(NumInlineElements),
                TEXT("A container of fixed capacity %u cannot hold %d elements"), NumInlineElements, NewMax);
        }
        SizeType CalculateSlackReserve(SizeType NewMax, SIZE_T) const { return Capacity(NewMax); }
        SizeType CalculateSlackShrink(SizeType NewMax, SizeType, SIZE_T) const { return Capacity(NewMax); }
        SizeType CalculateSlackGrow(SizeType NewMax, SizeType, SIZE_T) const { return Capacity(NewMax); }
        SIZE_T GetAllocatedSize(SizeType, SIZE_T) const { return 0; }
        bool HasAllocation() const { return false; }
        SizeType GetInitialCapacity() const { return static_cast<SizeType>(NumInlineElements); }

    private:
        static SizeType Capacity(SizeType NewMax) {
            return NewMax > static_cast<SizeType>(NumInlineElements) ? NewMax
                                                                     : static_cast<SizeType>(NumInlineElements);
        }
        TTypeCompatibleBytes<ElementType> InlineData[NumInlineElements];
    };
    typedef void ForAnyElementType;
};

template <typename InElementAllocator, typename InBitArrayAllocator>
class TSparseArrayAllocator {
public:
    typedef InElementAllocator ElementAllocator;
    typedef InBitArrayAllocator BitArrayAllocator;
};

#define DEFAULT_NUMBER_OF_ELEMENTS_PER_HASH_BUCKET 2
#define DEFAULT_BASE_NUMBER_OF_HASH_BUCKETS 8
#define DEFAULT_MIN_NUMBER_OF_HASHED_ELEMENTS 4

template <typename InSparseArrayAllocator, typename InHashAllocator, uint32 AverageNumberOfElementsPerHashBucket,
    uint32 BaseNumberOfHashBuckets, uint32 MinNumberOfHashedElements>
class TSetAllocator {
public:
    typedef InSparseArrayAllocator SparseArrayAllocator;
    typedef InHashAllocator HashAllocator;
    /** Hash buckets for that many elements: a power of two, 1 for very few. */
    static uint32 GetNumberOfHashBuckets(uint32 NumHashedElements) {
        if (NumHashedElements >= MinNumberOfHashedElements) {
            const uint32 Wanted = NumHashedElements / AverageNumberOfElementsPerHashBucket + BaseNumberOfHashBuckets;
            uint32 Result = 1;
            while (Result < Wanted) {
                Result <<= 1;
            }
            return Result;
        }
        return 1;
    }
};
template <uint32 NumInlineElements, typename SecondaryAllocator = FDefaultAllocator>
using TInlineSparseArrayAllocator = TSparseArrayAllocator<TInlineAllocator<NumInlineElements, SecondaryAllocator>,
    TInlineAllocator<(NumInlineElements + 31) / 32, SecondaryAllocator>>;
template <uint32 NumInlineElements>
using TInlineSetAllocator = TSetAllocator<TInlineSparseArrayAllocator<NumInlineElements>, TInlineAllocator<16>,
    DEFAULT_NUMBER_OF_ELEMENTS_PER_HASH_BUCKET, DEFAULT_BASE_NUMBER_OF_HASH_BUCKETS,
    DEFAULT_MIN_NUMBER_OF_HASHED_ELEMENTS>;

class FDefaultBitArrayAllocator : public TInlineAllocator<4> {};
class FDefaultSparseArrayAllocator : public TSparseArrayAllocator<FDefaultAllocator, FDefaultBitArrayAllocator> {};
class FDefaultSetAllocator : public TSetAllocator<FDefaultSparseArrayAllocator, TInlineAllocator<1>,
                                 DEFAULT_NUMBER_OF_ELEMENTS_PER_HASH_BUCKET, DEFAULT_BASE_NUMBER_OF_HASH_BUCKETS,
                                 DEFAULT_MIN_NUMBER_OF_HASHED_ELEMENTS> {};
