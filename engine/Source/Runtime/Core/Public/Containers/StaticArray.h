// SPDX-License-Identifier: MIT
/** TStaticArray: an array of fixed length with UE's interface. */
#pragma once

#include "Containers/ContainersFwd.h"
#include "Templates/TypeHash.h"
#include "Templates/UnrealTemplate.h"

template <typename InElementType, uint32 NumElements, uint32 Alignment = alignof(InElementType)>
class alignas(Alignment) TStaticArray {
public:
    using ElementType = InElementType;
    TStaticArray() : Storage() {}
    explicit TStaticArray(const InElementType& DefaultElement) : Storage() {
        for (InElementType& Element : Storage) {
            Element = DefaultElement;
        }
    }
    InElementType& operator[](uint32 Index) {
        check(Index < NumElements);
        return Storage[Index];
    }
    const InElementType& operator[](uint32 Index) const {
        check(Index < NumElements);
        return Storage[Index];
    }
    bool operator==(const TStaticArray& Other) const {
        for (uint32 Index = 0; Index < NumElements; ++Index) {
            if (!(Storage[Index] == Other.Storage[Index])) {
                return false;
            }
        }
        return true;
    }
    static constexpr int32 Num() { return static_cast<int32>(NumElements); }
    InElementType* GetData() { return Storage; }
    const InElementType* GetData() const { return Storage; }
    InElementType* begin() { return Storage; }
    const InElementType* begin() const { return Storage; }
    InElementType* end() { return Storage + NumElements; }
    const InElementType* end() const { return Storage + NumElements; }

private:
    InElementType Storage[NumElements];
};
