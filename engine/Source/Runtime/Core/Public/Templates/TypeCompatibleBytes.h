// SPDX-License-Identifier: MIT
/** Raw storage with the size and alignment of a type. */
#pragma once

#include "CoreTypes.h"

template <int32 Size, uint32 Alignment>
struct alignas(Alignment) TAlignedBytes {
    uint8 Pad[Size];
};

template <typename ElementType>
struct TTypeCompatibleBytes {
    using ElementTypeAlias = ElementType;
    ElementType* GetTypedPtr() { return reinterpret_cast<ElementType*>(Pad); }
    const ElementType* GetTypedPtr() const { return reinterpret_cast<const ElementType*>(Pad); }
    alignas(ElementType) uint8 Pad[sizeof(ElementType)];
};
