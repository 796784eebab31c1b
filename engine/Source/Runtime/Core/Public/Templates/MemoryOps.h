// SPDX-License-Identifier: MIT
/** Construct, copy, move and destroy runs of elements: what containers are built from. */
#pragma once

#include "Templates/UnrealTemplate.h"

template <typename ElementType, typename SizeType>
void DefaultConstructItems(void* Address, SizeType Count) {
    if constexpr (TIsZeroConstructType<ElementType>::Value) {
        FMemory::Memset(Address, 0, sizeof(ElementType) * static_cast<SIZE_T>(Count));
    } else {
        ElementType* Element = static_cast<ElementType*>(Address);
        for (; Count > 0; --Count, ++Element) {
            ::new (static_cast<void*>(Element)) ElementType;
        }
    }
}

template <typename ElementType>
void DestructItem(ElementType* Element) {
    if constexpr (!std::is_trivially_destructible_v<ElementType>) {
        typedef ElementType DestructItemsElementTypeTypedef;
        Element->DestructItemsElementTypeTypedef::~DestructItemsElementTypeTypedef();
    }
}

template <typename ElementType, typename SizeType>
void DestructItems(ElementType* Element, SizeType Count) {
    if constexpr (!std::is_trivially_destructible_v<ElementType>) {
        for (; Count > 0; --Count, ++Element) {
            DestructItem(Element);
        }
    }
}

template <typename DestinationElementType, typename SourceElementType, typename SizeType>
void ConstructItems(void* Dest, const SourceElementType* Source, SizeType Count) {
    if constexpr (TIsBitwiseConstructible<DestinationElementType, SourceElementType>::Value) {
        FMemory::Memcpy(Dest, static_cast<const void*>(Source), sizeof(SourceElementType) * static_cast<SIZE_T>(Count));
    } else {
        DestinationElementType* Target = static_cast<DestinationElementType*>(Dest);
        for (; Count > 0; --Count, ++Target, ++Source) {
            ::new (static_cast<void*>(Target)) DestinationElementType(*Source);
        }
    }
}

template <typename ElementType, typename SizeType>
void CopyAssignItems(ElementType* Dest, const ElementType* Source, SizeType Count) {
    for (; Count > 0; --Count, ++Dest, ++Source) {
        *Dest = *Source;
    }
}

/**
 * Moves elements to another place and ends their life in the old one. As in UE, every type held in a container must
 * survive being moved as bytes (no pointers into itself).
 */
template <typename DestinationElementType, typename SourceElementType, typename SizeType>
void RelocateConstructItems(void* Dest, SourceElementType* Source, SizeType Count) {
    static_assert(std::is_same_v<DestinationElementType, SourceElementType>);
    FMemory::Memmove(Dest, static_cast<const void*>(Source), sizeof(SourceElementType) * static_cast<SIZE_T>(Count));
}

template <typename ElementType, typename SizeType>
void MoveConstructItems(void* Dest, ElementType* Source, SizeType Count) {
    ElementType* Target = static_cast<ElementType*>(Dest);
    for (; Count > 0; --Count, ++Target, ++Source) {
        ::new (static_cast<void*>(Target)) ElementType(MoveTempIfPossible(*Source));
    }
}

template <typename ElementType, typename SizeType>
bool CompareItems(const ElementType* A, const ElementType* B, SizeType Count) {
    for (; Count > 0; --Count, ++A, ++B) {
        if (!(*A == *B)) {
            return false;
        }
    }
    return true;
}
