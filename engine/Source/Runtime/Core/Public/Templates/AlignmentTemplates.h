// SPDX-License-Identifier: MIT
/** Align, AlignDown, IsAligned for integers and pointers. Alignments are powers of two except in AlignArbitrary. */
#pragma once

#include "CoreTypes.h"
#include "Templates/UnrealTypeTraits.h"

template <typename T>
constexpr T Align(T Val, uint64 Alignment) {
    static_assert(std::is_integral_v<T> || std::is_pointer_v<T>, "Align expects an integer or pointer type");
    return (T)(((uint64)Val + Alignment - 1) & ~(Alignment - 1));
}
template <typename T>
constexpr T AlignDown(T Val, uint64 Alignment) {
    static_assert(std::is_integral_v<T> || std::is_pointer_v<T>, "AlignDown expects an integer or pointer type");
    return (T)(((uint64)Val) & ~(Alignment - 1));
}
template <typename T>
constexpr bool IsAligned(T Val, uint64 Alignment) {
    static_assert(std::is_integral_v<T> || std::is_pointer_v<T>, "IsAligned expects an integer or pointer type");
    return !((uint64)Val & (Alignment - 1));
}
template <typename T>
constexpr T AlignArbitrary(T Val, uint64 Alignment) {
    return (T)((((uint64)Val + Alignment - 1) / Alignment) * Alignment);
}
