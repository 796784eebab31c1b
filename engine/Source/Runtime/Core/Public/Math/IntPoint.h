// SPDX-License-Identifier: MIT
/** FIntPoint. */
#pragma once

#include "Containers/UnrealString.h"
#include "Math/UnrealMathUtility.h"

namespace UE::Math {
template <typename T>
struct TIntPoint {
    static_assert(std::is_integral_v<T>);
    using IntType = T;

    T X;
    T Y;

    static const TIntPoint ZeroValue;
    static const TIntPoint NoneValue;

    constexpr TIntPoint() : X(0), Y(0) {}
    constexpr TIntPoint(T InX, T InY) : X(InX), Y(InY) {}
    explicit constexpr TIntPoint(T InValue) : X(InValue), Y(InValue) {}
    explicit constexpr TIntPoint(EForceInit) : TIntPoint() {}
    template <typename A>
        requires(!std::is_same_v<A, T>)
    explicit constexpr TIntPoint(const TIntPoint<A>& From) : X(static_cast<T>(From.X)), Y(static_cast<T>(From.Y)) {}

    T Size() const { return static_cast<T>(FMath::Sqrt(static_cast<double>(SizeSquared()))); }
    T SizeSquared() const { return X * X + Y * Y; }
    TIntPoint ComponentMin(const TIntPoint& O) const { return TIntPoint(FMath::Min(X, O.X), FMath::Min(Y, O.Y)); }
    TIntPoint ComponentMax(const TIntPoint& O) const { return TIntPoint(FMath::Max(X, O.X), FMath::Max(Y, O.Y)); }
    static TIntPoint DivideAndRoundUp(TIntPoint Point, T Divisor) {
        return TIntPoint(FMath::DivideAndRoundUp(Point.X, Divisor), FMath::DivideAndRoundUp(Point.Y, Divisor));
    }

    constexpr TIntPoint operator+(const TIntPoint& V) const { return TIntPoint(X + V.X, Y + V.Y); }
    constexpr TIntPoint operator-(const TIntPoint& V) const { return TIntPoint(X - V.X, Y - V.Y); }
    constexpr TIntPoint operator*(const TIntPoint& V) const { return TIntPoint(X * V.X, Y * V.Y); }
    constexpr TIntPoint operator/(const TIntPoint& V) const { return TIntPoint(X / V.X, Y / V.Y); }
    constexpr TIntPoint operator*(T Scale) const { return TIntPoint(X * Scale, Y * Scale); }
    constexpr TIntPoint operator/(T Divisor) const { return TIntPoint(X / Divisor, Y / Divisor); }
    TIntPoint& operator+=(const TIntPoint& V) { return *this = *this + V; }
    TIntPoint& operator-=(const TIntPoint& V) { return *this = *this - V; }
    TIntPoint& operator*=(T Scale) { return *this = *this * Scale; }
    TIntPoint& operator/=(T Divisor) { return *this = *this / Divisor; }
    constexpr bool operator==(const TIntPoint& V) const { return X == V.X && Y == V.Y; }
    T& operator[](int32 Index) {
        check(Index >= 0 && Index < 2);
        return Index == 0 ? X : Y;
    }
    T operator[](int32 Index) const { return const_cast<TIntPoint&>(*this)[Index]; }
    T GetMax() const { return FMath::Max(X, Y); }
    T GetMin() const { return FMath::Min(X, Y); }
    bool IsZero() const { return *this == TIntPoint(); }
    FString ToString() const {
        return FString::Printf(TEXT("X=%lld Y=%lld"), static_cast<long long>(X), static_cast<long long>(Y));
    }
    friend uint32 GetTypeHash(const TIntPoint& V) {
        uint32 Hash = GetTypeHash(V.X);
        Hash = HashCombine(Hash, GetTypeHash(V.Y));
        return Hash;
    }
};
template <typename T>
inline constexpr TIntPoint<T> TIntPoint<T>::ZeroValue(0, 0);
template <typename T>
inline constexpr TIntPoint<T> TIntPoint<T>::NoneValue(static_cast<T>(INDEX_NONE), static_cast<T>(INDEX_NONE));
} // namespace UE::Math
