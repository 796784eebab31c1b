// SPDX-License-Identifier: MIT
#pragma once

// Unreal's core math types as plain C++ structs, with Unreal's names, members and units. They convert to and from the
// values of any property or parameter of that type; structs of your own do too, once their members are named
// (codec.hpp, Members). (Epic: "FVector", "FRotator", "FTransform", ... in the API reference of module Core.)

#include <cstdint>
#include <tuple>

#include "spear/codec.hpp"

namespace spear::unreal {

/// A location or direction: centimetres, left-handed, X forward, Y right, Z up.
struct FVector {
    double X = 0, Y = 0, Z = 0;
    friend bool operator==(const FVector&, const FVector&) = default;
};

struct FVector2D {
    double X = 0, Y = 0;
    friend bool operator==(const FVector2D&, const FVector2D&) = default;
};

struct FVector4 {
    double X = 0, Y = 0, Z = 0, W = 1;
    friend bool operator==(const FVector4&, const FVector4&) = default;
};

/// Degrees. Applied roll first, then pitch, then yaw.
struct FRotator {
    double Pitch = 0, Yaw = 0, Roll = 0;
    friend bool operator==(const FRotator&, const FRotator&) = default;
};

struct FQuat {
    double X = 0, Y = 0, Z = 0, W = 1;
    friend bool operator==(const FQuat&, const FQuat&) = default;
};

struct FTransform {
    FQuat Rotation{};
    FVector Translation{};
    FVector Scale3D{1, 1, 1};
    friend bool operator==(const FTransform&, const FTransform&) = default;
};

/// Linear light, 1 is white.
struct FLinearColor {
    float R = 0, G = 0, B = 0, A = 1;
    friend bool operator==(const FLinearColor&, const FLinearColor&) = default;
};

/// Eight bits per channel, sRGB; the members stand in Unreal's memory order.
struct FColor {
    std::uint8_t B = 0, G = 0, R = 0, A = 255;
    friend bool operator==(const FColor&, const FColor&) = default;
};

struct FIntPoint {
    std::int32_t X = 0, Y = 0;
    friend bool operator==(const FIntPoint&, const FIntPoint&) = default;
};

struct FIntVector {
    std::int32_t X = 0, Y = 0, Z = 0;
    friend bool operator==(const FIntVector&, const FIntVector&) = default;
};

} // namespace spear::unreal

/// Names the members of a struct in Unreal's namespace; used at namespace scope.
#define SPEAR_UNREAL_MEMBERS(Type, ...)                                                                                \
    template <>                                                                                                        \
    struct spear::Members<spear::unreal::Type> {                                                                       \
        using Self = spear::unreal::Type;                                                                              \
        static constexpr std::string_view name = #Type;                                                                \
        static constexpr auto list = std::tuple{__VA_ARGS__};                                                          \
    }

SPEAR_UNREAL_MEMBERS(FVector, Member{"X", &Self::X}, Member{"Y", &Self::Y}, Member{"Z", &Self::Z});
SPEAR_UNREAL_MEMBERS(FVector2D, Member{"X", &Self::X}, Member{"Y", &Self::Y});
SPEAR_UNREAL_MEMBERS(
    FVector4, Member{"X", &Self::X}, Member{"Y", &Self::Y}, Member{"Z", &Self::Z}, Member{"W", &Self::W});
SPEAR_UNREAL_MEMBERS(FRotator, Member{"Pitch", &Self::Pitch}, Member{"Yaw", &Self::Yaw}, Member{"Roll", &Self::Roll});
SPEAR_UNREAL_MEMBERS(FQuat, Member{"X", &Self::X}, Member{"Y", &Self::Y}, Member{"Z", &Self::Z}, Member{"W", &Self::W});
SPEAR_UNREAL_MEMBERS(FTransform, Member{"Rotation", &Self::Rotation}, Member{"Translation", &Self::Translation},
    Member{"Scale3D", &Self::Scale3D});
SPEAR_UNREAL_MEMBERS(
    FLinearColor, Member{"R", &Self::R}, Member{"G", &Self::G}, Member{"B", &Self::B}, Member{"A", &Self::A});
SPEAR_UNREAL_MEMBERS(
    FColor, Member{"B", &Self::B}, Member{"G", &Self::G}, Member{"R", &Self::R}, Member{"A", &Self::A});
SPEAR_UNREAL_MEMBERS(FIntPoint, Member{"X", &Self::X}, Member{"Y", &Self::Y});
SPEAR_UNREAL_MEMBERS(FIntVector, Member{"X", &Self::X}, Member{"Y", &Self::Y}, Member{"Z", &Self::Z});
