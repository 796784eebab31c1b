// SPDX-License-Identifier: MIT
/** GetTypeHash for built-in types and the functions that combine hashes. */
#pragma once

#include "CoreTypes.h"
#include "Templates/UnrealTypeTraits.h"

/** Mixes two hashes; the order matters. */
inline constexpr uint32 HashCombine(uint32 A, uint32 C) {
    uint32 B = 0x9e3779b9;
    A += B;
    A -= B;
    A -= C;
    A ^= (C >> 13);
    B -= C;
    B -= A;
    B ^= (A << 8);
    C -= A;
    C -= B;
    C ^= (B >> 13);
    A -= B;
    A -= C;
    A ^= (C >> 12);
    B -= C;
    B -= A;
    B ^= (A << 16);
    C -= A;
    C -= B;
    C ^= (B >> 5);
    return C;
}
/** A cheaper mix, not to be stored. */
inline constexpr uint32 HashCombineFast(uint32 A, uint32 B) { return A ^ (B + 0x9e3779b9 + (A << 6) + (A >> 2)); }
inline uint32 PointerHash(const void* Key) {
    const uint64 Bits = static_cast<uint64>(reinterpret_cast<UPTRINT>(Key)) >> 4;
    return static_cast<uint32>(Bits ^ (Bits >> 32)) * 0x9e3779b1u;
}
inline uint32 PointerHash(const void* Key, uint32 C) { return HashCombine(PointerHash(Key), C); }

template <typename T>
    requires(std::is_integral_v<T>)
constexpr uint32 GetTypeHash(const T Value) {
    if constexpr (sizeof(T) <= 4) {
        return static_cast<uint32>(Value);
    } else {
        const uint64 Bits = static_cast<uint64>(Value);
        return static_cast<uint32>(Bits) + (static_cast<uint32>(Bits >> 32) * 23);
    }
}
inline uint32 GetTypeHash(float Value) {
    uint32 Bits;
    if (Value == 0.0f) {
        Value = 0.0f; // -0 and 0 are equal
    }
    __builtin_memcpy(&Bits, &Value, sizeof(Bits));
    return Bits;
}
inline uint32 GetTypeHash(double Value) {
    uint64 Bits;
    if (Value == 0.0) {
        Value = 0.0;
    }
    __builtin_memcpy(&Bits, &Value, sizeof(Bits));
    return GetTypeHash(Bits);
}
template <typename T>
    requires(std::is_enum_v<T>)
constexpr uint32 GetTypeHash(const T Value) {
    return GetTypeHash(static_cast<std::underlying_type_t<T>>(Value));
}
template <typename T>
    requires(!std::is_function_v<T>)
uint32 GetTypeHash(T* Value) {
    return PointerHash(static_cast<const void*>(Value));
}
inline uint32 GetTypeHash(decltype(nullptr)) { return 0; }

/** Calls GetTypeHash; exists so that classes with a member of that name can reach the function. */
template <typename T>
uint32 GetTypeHashHelper(const T& Value) {
    return GetTypeHash(Value);
}
