// SPDX-License-Identifier: MIT
/** Bit operations for enum classes. */
#pragma once

#include <type_traits>

#define ENUM_CLASS_FLAGS(Enum)                                                                                         \
    [[maybe_unused]] inline constexpr Enum& operator|=(Enum& Lhs, Enum Rhs) {                                          \
        return Lhs = (Enum)((std::underlying_type_t<Enum>)Lhs | (std::underlying_type_t<Enum>)Rhs);                    \
    }                                                                                                                  \
    [[maybe_unused]] inline constexpr Enum& operator&=(Enum& Lhs, Enum Rhs) {                                          \
        return Lhs = (Enum)((std::underlying_type_t<Enum>)Lhs & (std::underlying_type_t<Enum>)Rhs);                    \
    }                                                                                                                  \
    [[maybe_unused]] inline constexpr Enum& operator^=(Enum& Lhs, Enum Rhs) {                                          \
        return Lhs = (Enum)((std::underlying_type_t<Enum>)Lhs ^ (std::underlying_type_t<Enum>)Rhs);                    \
    }                                                                                                                  \
    [[maybe_unused]] inline constexpr Enum operator|(Enum Lhs, Enum Rhs) {                                             \
        return (Enum)((std::underlying_type_t<Enum>)Lhs | (std::underlying_type_t<Enum>)Rhs);                          \
    }                                                                                                                  \
    [[maybe_unused]] inline constexpr Enum operator&(Enum Lhs, Enum Rhs) {                                             \
        return (Enum)((std::underlying_type_t<Enum>)Lhs & (std::underlying_type_t<Enum>)Rhs);                          \
    }                                                                                                                  \
    [[maybe_unused]] inline constexpr Enum operator^(Enum Lhs, Enum Rhs) {                                             \
        return (Enum)((std::underlying_type_t<Enum>)Lhs ^ (std::underlying_type_t<Enum>)Rhs);                          \
    }                                                                                                                  \
    [[maybe_unused]] inline constexpr bool operator!(Enum E) { return !(std::underlying_type_t<Enum>)E; }              \
    [[maybe_unused]] inline constexpr Enum operator~(Enum E) { return (Enum) ~(std::underlying_type_t<Enum>)E; }

#define FRIEND_ENUM_CLASS_FLAGS(Enum)                                                                                  \
    friend constexpr Enum& operator|=(Enum& Lhs, Enum Rhs);                                                            \
    friend constexpr Enum& operator&=(Enum& Lhs, Enum Rhs);                                                            \
    friend constexpr Enum& operator^=(Enum& Lhs, Enum Rhs);                                                            \
    friend constexpr Enum operator|(Enum Lhs, Enum Rhs);                                                               \
    friend constexpr Enum operator&(Enum Lhs, Enum Rhs);                                                               \
    friend constexpr Enum operator^(Enum Lhs, Enum Rhs);                                                               \
    friend constexpr bool operator!(Enum E);                                                                           \
    friend constexpr Enum operator~(Enum E);

/** True if all bits of Contains are set. */
template <typename Enum>
constexpr bool EnumHasAllFlags(Enum Flags, Enum Contains) {
    using U = std::underlying_type_t<Enum>;
    return ((U)Flags & (U)Contains) == (U)Contains;
}
/** True if any bit of Contains is set. */
template <typename Enum>
constexpr bool EnumHasAnyFlags(Enum Flags, Enum Contains) {
    using U = std::underlying_type_t<Enum>;
    return ((U)Flags & (U)Contains) != 0;
}
template <typename Enum>
constexpr bool EnumHasOneFlag(Enum Flags, Enum Contains) {
    using U = std::underlying_type_t<Enum>;
    const U Found = (U)Flags & (U)Contains;
    return Found != 0 && (Found & (Found - 1)) == 0;
}
template <typename Enum>
constexpr bool EnumOnlyContainsFlags(Enum Flags, Enum Contains) {
    using U = std::underlying_type_t<Enum>;
    return ((U)Flags & ~(U)Contains) == 0;
}
template <typename Enum>
constexpr void EnumAddFlags(Enum& Flags, Enum FlagsToAdd) {
    using U = std::underlying_type_t<Enum>;
    Flags = (Enum)((U)Flags | (U)FlagsToAdd);
}
template <typename Enum>
constexpr void EnumRemoveFlags(Enum& Flags, Enum FlagsToRemove) {
    using U = std::underlying_type_t<Enum>;
    Flags = (Enum)((U)Flags & ~(U)FlagsToRemove);
}
/** Reads as the lowest flag that is set. */
template <typename Enum>
constexpr Enum EnumLowestSetFlag(Enum Flags) {
    using U = std::underlying_type_t<Enum>;
    return (Enum)((U)Flags & (U)(~(U)Flags + 1));
}
