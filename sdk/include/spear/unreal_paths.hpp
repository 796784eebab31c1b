// SPDX-License-Identifier: MIT
#pragma once

// Members of the structs of unreal_types.hpp as property paths: `actor.RootComponent().RelativeLocation().X()`.

#include <cstdint>

#include "spear/typed_property.hpp"
#include "spear/unreal_types.hpp"

namespace spear {
namespace unreal {

template <typename Base>
class FVector_Path : public Base {
public:
    using Base::Base;
    PropertyOf<Base, double> X() const { return typed_property<double>(*this, "X"); }
    PropertyOf<Base, double> Y() const { return typed_property<double>(*this, "Y"); }
    PropertyOf<Base, double> Z() const { return typed_property<double>(*this, "Z"); }
};

template <typename Base>
class FVector2D_Path : public Base {
public:
    using Base::Base;
    PropertyOf<Base, double> X() const { return typed_property<double>(*this, "X"); }
    PropertyOf<Base, double> Y() const { return typed_property<double>(*this, "Y"); }
};

template <typename Base>
class FVector4_Path : public Base {
public:
    using Base::Base;
    PropertyOf<Base, double> X() const { return typed_property<double>(*this, "X"); }
    PropertyOf<Base, double> Y() const { return typed_property<double>(*this, "Y"); }
    PropertyOf<Base, double> Z() const { return typed_property<double>(*this, "Z"); }
    PropertyOf<Base, double> W() const { return typed_property<double>(*this, "W"); }
};

template <typename Base>
class FRotator_Path : public Base {
public:
    using Base::Base;
    PropertyOf<Base, double> Pitch() const { return typed_property<double>(*this, "Pitch"); }
    PropertyOf<Base, double> Yaw() const { return typed_property<double>(*this, "Yaw"); }
    PropertyOf<Base, double> Roll() const { return typed_property<double>(*this, "Roll"); }
};

template <typename Base>
class FQuat_Path : public Base {
public:
    using Base::Base;
    PropertyOf<Base, double> X() const { return typed_property<double>(*this, "X"); }
    PropertyOf<Base, double> Y() const { return typed_property<double>(*this, "Y"); }
    PropertyOf<Base, double> Z() const { return typed_property<double>(*this, "Z"); }
    PropertyOf<Base, double> W() const { return typed_property<double>(*this, "W"); }
};

template <typename Base>
class FTransform_Path : public Base {
public:
    using Base::Base;
    PropertyOf<Base, FQuat> Rotation() const { return typed_property<FQuat>(*this, "Rotation"); }
    PropertyOf<Base, FVector> Translation() const { return typed_property<FVector>(*this, "Translation"); }
    PropertyOf<Base, FVector> Scale3D() const { return typed_property<FVector>(*this, "Scale3D"); }
};

template <typename Base>
class FLinearColor_Path : public Base {
public:
    using Base::Base;
    PropertyOf<Base, float> R() const { return typed_property<float>(*this, "R"); }
    PropertyOf<Base, float> G() const { return typed_property<float>(*this, "G"); }
    PropertyOf<Base, float> B() const { return typed_property<float>(*this, "B"); }
    PropertyOf<Base, float> A() const { return typed_property<float>(*this, "A"); }
};

template <typename Base>
class FColor_Path : public Base {
public:
    using Base::Base;
    PropertyOf<Base, std::uint8_t> B() const { return typed_property<std::uint8_t>(*this, "B"); }
    PropertyOf<Base, std::uint8_t> G() const { return typed_property<std::uint8_t>(*this, "G"); }
    PropertyOf<Base, std::uint8_t> R() const { return typed_property<std::uint8_t>(*this, "R"); }
    PropertyOf<Base, std::uint8_t> A() const { return typed_property<std::uint8_t>(*this, "A"); }
};

template <typename Base>
class FIntPoint_Path : public Base {
public:
    using Base::Base;
    PropertyOf<Base, std::int32_t> X() const { return typed_property<std::int32_t>(*this, "X"); }
    PropertyOf<Base, std::int32_t> Y() const { return typed_property<std::int32_t>(*this, "Y"); }
};

template <typename Base>
class FIntVector_Path : public Base {
public:
    using Base::Base;
    PropertyOf<Base, std::int32_t> X() const { return typed_property<std::int32_t>(*this, "X"); }
    PropertyOf<Base, std::int32_t> Y() const { return typed_property<std::int32_t>(*this, "Y"); }
    PropertyOf<Base, std::int32_t> Z() const { return typed_property<std::int32_t>(*this, "Z"); }
};

} // namespace unreal

namespace detail {

template <typename Base>
struct PathLayersOf<unreal::FVector, Base> {
    using type = unreal::FVector_Path<Base>;
};
template <typename Base>
struct PathLayersOf<unreal::FVector2D, Base> {
    using type = unreal::FVector2D_Path<Base>;
};
template <typename Base>
struct PathLayersOf<unreal::FVector4, Base> {
    using type = unreal::FVector4_Path<Base>;
};
template <typename Base>
struct PathLayersOf<unreal::FRotator, Base> {
    using type = unreal::FRotator_Path<Base>;
};
template <typename Base>
struct PathLayersOf<unreal::FQuat, Base> {
    using type = unreal::FQuat_Path<Base>;
};
template <typename Base>
struct PathLayersOf<unreal::FTransform, Base> {
    using type = unreal::FTransform_Path<Base>;
};
template <typename Base>
struct PathLayersOf<unreal::FLinearColor, Base> {
    using type = unreal::FLinearColor_Path<Base>;
};
template <typename Base>
struct PathLayersOf<unreal::FColor, Base> {
    using type = unreal::FColor_Path<Base>;
};
template <typename Base>
struct PathLayersOf<unreal::FIntPoint, Base> {
    using type = unreal::FIntPoint_Path<Base>;
};
template <typename Base>
struct PathLayersOf<unreal::FIntVector, Base> {
    using type = unreal::FIntVector_Path<Base>;
};

} // namespace detail
} // namespace spear
