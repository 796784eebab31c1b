// SPDX-License-Identifier: MIT
/** FIntVector and its two- and four-component relatives. */
#pragma once

#include "Containers/UnrealString.h"
#include "Math/UnrealMathUtility.h"

namespace UE::Math {
template <typename T>
struct TIntVector3 {
    static_assert(std::is_integral_v<T>);
    using IntType = T;

    T X;
    T Y;
    T Z;

    static const TIntVector3 ZeroValue;
    static const TIntVector3 NoneValue;

    constexpr TIntVector3() : X(0), Y(0), Z(0) {}
    constexpr TIntVector3(T InX, T InY, T InZ) : X(InX), Y(InY), Z(InZ) {}
    explicit constexpr TIntVector3(T InValue) : X(InValue), Y(InValue), Z(InValue) {}
    explicit constexpr TIntVector3(EForceInit) : TIntVector3() {}
    template <typename A>
        requires(!std::is_same_v<A, T>)
    explicit constexpr TIntVector3(const TIntVector3<A>& From)
        : X(static_cast<T>(From.X)), Y(static_cast<T>(From.Y)), Z(static_cast<T>(From.Z)) {}

    T Size() const { return static_cast<T>(FMath::Sqrt(static_cast<double>(X * X + Y * Y + Z * Z))); }

    constexpr TIntVector3 operator+(const TIntVector3& V) const { return TIntVector3(X + V.X, Y + V.Y, Z + V.Z); }
    constexpr TIntVector3 operator-(const TIntVector3& V) const { return TIntVector3(X - V.X, Y - V.Y, Z - V.Z); }
    constexpr TIntVector3 operator*(const TIntVector3& V) const { return TIntVector3(X * V.X, Y * V.Y, Z * V.Z); }
    constexpr TIntVector3 operator/(const TIntVector3& V) const { return TIntVector3(X / V.X, Y / V.Y, Z / V.Z); }
    constexpr TIntVector3 operator*(T Scale) const { return TIntVector3(X * Scale, Y * Scale, Z * Scale); }
    constexpr TIntVector3 operator/(T Divisor) const { return TIntVector3(X / Divisor, Y / Divisor, Z / Divisor); }
    TIntVector3& operator+=(const TIntVector3& V) { return *this = *this + V; }
    TIntVector3& operator-=(const TIntVector3& V) { return *this = *this - V; }
    TIntVector3& operator*=(T Scale) { return *this = *this * Scale; }
    TIntVector3& operator/=(T Divisor) { return *this = *this / Divisor; }
    constexpr bool operator==(const TIntVector3& V) const { return X == V.X && Y == V.Y && Z == V.Z; }
    T& operator[](int32 Index) {
        check(Index >= 0 && Index < 3);
        return Index == 0 ? X : (Index == 1 ? Y : Z);
    }
    T operator[](int32 Index) const { return const_cast<TIntVector3&>(*this)[Index]; }
    T GetMax() const { return FMath::Max(X, FMath::Max(Y, Z)); }
    T GetMin() const { return FMath::Min(X, FMath::Min(Y, Z)); }
    bool IsZero() const { return *this == TIntVector3(); }
    FString ToString() const {
        return FString::Printf(TEXT("X=%lld Y=%lld Z=%lld"), static_cast<long long>(X), static_cast<long long>(Y),
            static_cast<long long>(Z));
    }
    friend uint32 GetTypeHash(const TIntVector3& V) {
        uint32 Hash = GetTypeHash(V.X);
        Hash = HashCombine(Hash, GetTypeHash(V.Y));
        Hash = HashCombine(Hash, GetTypeHash(V.Z));
        return Hash;
    }
};
template <typename T>
inline constexpr TIntVector3<T> TIntVector3<T>::ZeroValue(0, 0, 0);
template <typename T>
inline constexpr TIntVector3<T> TIntVector3<T>::NoneValue(
    static_cast<T>(INDEX_NONE), static_cast<T>(INDEX_NONE), static_cast<T>(INDEX_NONE));

template <typename T>
struct TIntVector2 {
    static_assert(std::is_integral_v<T>);
    using IntType = T;

    T X;
    T Y;

    static const TIntVector2 ZeroValue;
    static const TIntVector2 NoneValue;

    constexpr TIntVector2() : X(0), Y(0) {}
    constexpr TIntVector2(T InX, T InY) : X(InX), Y(InY) {}
    explicit constexpr TIntVector2(T InValue) : X(InValue), Y(InValue) {}
    explicit constexpr TIntVector2(EForceInit) : TIntVector2() {}
    template <typename A>
        requires(!std::is_same_v<A, T>)
    explicit constexpr TIntVector2(const TIntVector2<A>& From) : X(static_cast<T>(From.X)), Y(static_cast<T>(From.Y)) {}

    constexpr TIntVector2 operator+(const TIntVector2& V) const { return TIntVector2(X + V.X, Y + V.Y); }
    constexpr TIntVector2 operator-(const TIntVector2& V) const { return TIntVector2(X - V.X, Y - V.Y); }
    constexpr TIntVector2 operator*(const TIntVector2& V) const { return TIntVector2(X * V.X, Y * V.Y); }
    constexpr TIntVector2 operator/(const TIntVector2& V) const { return TIntVector2(X / V.X, Y / V.Y); }
    constexpr TIntVector2 operator*(T Scale) const { return TIntVector2(X * Scale, Y * Scale); }
    constexpr TIntVector2 operator/(T Divisor) const { return TIntVector2(X / Divisor, Y / Divisor); }
    TIntVector2& operator+=(const TIntVector2& V) { return *this = *this + V; }
    TIntVector2& operator-=(const TIntVector2& V) { return *this = *this - V; }
    TIntVector2& operator*=(T Scale) { return *this = *this * Scale; }
    TIntVector2& operator/=(T Divisor) { return *this = *this / Divisor; }
    constexpr bool operator==(const TIntVector2& V) const { return X == V.X && Y == V.Y; }
    T& operator[](int32 Index) {
        check(Index >= 0 && Index < 2);
        return Index == 0 ? X : Y;
    }
    T operator[](int32 Index) const { return const_cast<TIntVector2&>(*this)[Index]; }
    T GetMax() const { return FMath::Max(X, Y); }
    T GetMin() const { return FMath::Min(X, Y); }
    bool IsZero() const { return *this == TIntVector2(); }
    FString ToString() const {
        return FString::Printf(TEXT("X=%lld Y=%lld"), static_cast<long long>(X), static_cast<long long>(Y));
    }
    friend uint32 GetTypeHash(const TIntVector2& V) {
        uint32 Hash = GetTypeHash(V.X);
        Hash = HashCombine(Hash, GetTypeHash(V.Y));
        return Hash;
    }
};
template <typename T>
inline constexpr TIntVector2<T> TIntVector2<T>::ZeroValue(0, 0);
template <typename T>
inline constexpr TIntVector2<T> TIntVector2<T>::NoneValue(static_cast<T>(INDEX_NONE), static_cast<T>(INDEX_NONE));

template <typename T>
struct TIntVector4 {
    static_assert(std::is_integral_v<T>);
    using IntType = T;

    T X;
    T Y;
    T Z;
    T W;

    static const TIntVector4 ZeroValue;
    static const TIntVector4 NoneValue;

    constexpr TIntVector4() : X(0), Y(0), Z(0), W(0) {}
    constexpr TIntVector4(T InX, T InY, T InZ, T InW) : X(InX), Y(InY), Z(InZ), W(InW) {}
    explicit constexpr TIntVector4(T InValue) : X(InValue), Y(InValue), Z(InValue), W(InValue) {}
    explicit constexpr TIntVector4(EForceInit) : TIntVector4() {}
    template <typename A>
        requires(!std::is_same_v<A, T>)
    explicit constexpr TIntVector4(const TIntVector4<A>& From)
        : X(static_cast<T>(From.X)), Y(static_cast<T>(From.Y)), Z(static_cast<T>(From.Z)), W(static_cast<T>(From.W)) {}

    constexpr TIntVector4 operator+(const TIntVector4& V) const {
        return TIntVector4(X + V.X, Y + V.Y, Z + V.Z, W + V.W);
    }
    constexpr TIntVector4 operator-(const TIntVector4& V) const {
        return TIntVector4(X - V.X, Y - V.Y, Z - V.Z, W - V.W);
    }
    constexpr TIntVector4 operator*(const TIntVector4& V) const {
        return TIntVector4(X * V.X, Y * V.Y, Z * V.Z, W * V.W);
    }
    constexpr TIntVector4 operator/(const TIntVector4& V) const {
        return TIntVector4(X / V.X, Y / V.Y, Z / V.Z, W / V.W);
    }
    constexpr TIntVector4 operator*(T Scale) const { return TIntVector4(X * Scale, Y * Scale, Z * Scale, W * Scale); }
    constexpr TIntVector4 operator/(T Divisor) const {
        return TIntVector4(X / Divisor, Y / Divisor, Z / Divisor, W / Divisor);
    }
    TIntVector4& operator+=(const TIntVector4& V) { return *this = *this + V; }
    TIntVector4& operator-=(const TIntVector4& V) { return *this = *this - V; }
    TIntVector4& operator*=(T Scale) { return *this = *this * Scale; }
    TIntVector4& operator/=(T Divisor) { return *this = *this / Divisor; }
    constexpr bool operator==(const TIntVector4& V) const { return X == V.X && Y == V.Y && Z == V.Z && W == V.W; }
    T& operator[](int32 Index) {
        check(Index >= 0 && Index < 4);
        return Index == 0 ? X : (Index == 1 ? Y : (Index == 2 ? Z : W));
    }
    T operator[](int32 Index) const { return const_cast<TIntVector4&>(*this)[Index]; }
    T GetMax() const { return FMath::Max(X, FMath::Max(Y, FMath::Max(Z, W))); }
    T GetMin() const { return FMath::Min(X, FMath::Min(Y, FMath::Min(Z, W))); }
    bool IsZero() const { return *this == TIntVector4(); }
    FString ToString() const {
        return FString::Printf(TEXT("X=%lld Y=%lld Z=%lld W=%lld"), static_cast<long long>(X),
            static_cast<long long>(Y), static_cast<long long>(Z), static_cast<long long>(W));
    }
    friend uint32 GetTypeHash(const TIntVector4& V) {
        uint32 Hash = GetTypeHash(V.X);
        Hash = HashCombine(Hash, GetTypeHash(V.Y));
        Hash = HashCombine(Hash, GetTypeHash(V.Z));
        Hash = HashCombine(Hash, GetTypeHash(V.W));
        return Hash;
    }
};
template <typename T>
inline constexpr TIntVector4<T> TIntVector4<T>::ZeroValue(0, 0, 0, 0);
template <typename T>
inline constexpr TIntVector4<T> TIntVector4<T>::NoneValue(
    static_cast<T>(INDEX_NONE), static_cast<T>(INDEX_NONE), static_cast<T>(INDEX_NONE), static_cast<T>(INDEX_NONE));
} // namespace UE::Math
