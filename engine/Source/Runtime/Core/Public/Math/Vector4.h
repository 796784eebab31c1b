// SPDX-License-Identifier: MIT
/** FVector4. */
#pragma once

#include "Math/Vector.h"

namespace UE::Math {
template <typename T>
struct alignas(16) TVector4 {
    static_assert(std::is_floating_point_v<T>);
    using FReal = T;

    T X;
    T Y;
    T Z;
    T W;

    static constexpr TVector4 Zero() { return TVector4(0, 0, 0, 0); }
    static constexpr TVector4 One() { return TVector4(1, 1, 1, 1); }

    constexpr TVector4() : X(0), Y(0), Z(0), W(1) {}
    constexpr TVector4(const TVector<T>& V) : X(V.X), Y(V.Y), Z(V.Z), W(1) {}
    constexpr TVector4(const TVector<T>& V, T InW) : X(V.X), Y(V.Y), Z(V.Z), W(InW) {}
    explicit constexpr TVector4(T InX, T InY = 0, T InZ = 0, T InW = 1) : X(InX), Y(InY), Z(InZ), W(InW) {}
    explicit constexpr TVector4(const TVector2<T>& XY, const TVector2<T>& ZW) : X(XY.X), Y(XY.Y), Z(ZW.X), W(ZW.Y) {}
    explicit constexpr TVector4(const FLinearColor& InColor);
    explicit constexpr TVector4(EForceInit) : X(0), Y(0), Z(0), W(0) {}
    template <typename A>
        requires(!std::is_same_v<A, T>)
    explicit constexpr TVector4(const TVector4<A>& V)
        : X(static_cast<T>(V.X)), Y(static_cast<T>(V.Y)), Z(static_cast<T>(V.Z)), W(static_cast<T>(V.W)) {}

    constexpr TVector4 operator+(const TVector4& V) const { return TVector4(X + V.X, Y + V.Y, Z + V.Z, W + V.W); }
    constexpr TVector4 operator-(const TVector4& V) const { return TVector4(X - V.X, Y - V.Y, Z - V.Z, W - V.W); }
    constexpr TVector4 operator*(const TVector4& V) const { return TVector4(X * V.X, Y * V.Y, Z * V.Z, W * V.W); }
    constexpr TVector4 operator/(const TVector4& V) const { return TVector4(X / V.X, Y / V.Y, Z / V.Z, W / V.W); }
    constexpr TVector4 operator-() const { return TVector4(-X, -Y, -Z, -W); }
    template <typename A>
        requires std::is_arithmetic_v<A>
    constexpr TVector4 operator*(A S) const {
        return TVector4(X * T(S), Y * T(S), Z * T(S), W * T(S));
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    constexpr TVector4 operator/(A S) const {
        return TVector4(X / T(S), Y / T(S), Z / T(S), W / T(S));
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    friend constexpr TVector4 operator*(A S, const TVector4& V) {
        return V * S;
    }
    TVector4& operator+=(const TVector4& V) { return *this = *this + V; }
    TVector4& operator-=(const TVector4& V) { return *this = *this - V; }
    TVector4& operator*=(T S) { return *this = *this * S; }
    constexpr bool operator==(const TVector4& V) const { return X == V.X && Y == V.Y && Z == V.Z && W == V.W; }
    T& operator[](int32 Index) {
        check(Index >= 0 && Index < 4);
        return Index == 0 ? X : (Index == 1 ? Y : (Index == 2 ? Z : W));
    }
    T operator[](int32 Index) const { return const_cast<TVector4&>(*this)[Index]; }
    T& Component(int32 Index) { return (*this)[Index]; }
    bool Equals(const TVector4& V, T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return FMath::Abs(X - V.X) <= Tolerance && FMath::Abs(Y - V.Y) <= Tolerance &&
               FMath::Abs(Z - V.Z) <= Tolerance && FMath::Abs(W - V.W) <= Tolerance;
    }
    void Set(T InX, T InY, T InZ, T InW) { *this = TVector4(InX, InY, InZ, InW); }
    /** Of X, Y and Z. */
    T Size3() const { return FMath::Sqrt(SizeSquared3()); }
    constexpr T SizeSquared3() const { return X * X + Y * Y + Z * Z; }
    T Size() const { return FMath::Sqrt(SizeSquared()); }
    constexpr T SizeSquared() const { return SizeSquared3() + W * W; }
    friend constexpr T Dot3(const TVector4& A, const TVector4& B) { return A.X * B.X + A.Y * B.Y + A.Z * B.Z; }
    friend constexpr T Dot4(const TVector4& A, const TVector4& B) { return Dot3(A, B) + A.W * B.W; }
    TVector4 GetSafeNormal(T Tolerance = UE_SMALL_NUMBER) const {
        const T Square = SizeSquared3();
        if (Square <= Tolerance) {
            return TVector4(0, 0, 0, 0);
        }
        const T Scale = FMath::InvSqrt(Square);
        return TVector4(X * Scale, Y * Scale, Z * Scale, 0);
    }
    bool ContainsNaN() const {
        return !FMath::IsFinite(X) || !FMath::IsFinite(Y) || !FMath::IsFinite(Z) || !FMath::IsFinite(W);
    }
    FString ToString() const {
        return FString::Printf(TEXT("X=%3.3f Y=%3.3f Z=%3.3f W=%3.3f"), static_cast<double>(X), static_cast<double>(Y),
            static_cast<double>(Z), static_cast<double>(W));
    }
    bool InitFromString(const FString& S) {
        X = Y = Z = 0;
        W = 1;
        const bool bOk = Private::ParseComponent(S, TEXT("X="), X) && Private::ParseComponent(S, TEXT("Y="), Y) &&
                         Private::ParseComponent(S, TEXT("Z="), Z);
        Private::ParseComponent(S, TEXT("W="), W);
        return bOk;
    }
    friend uint32 GetTypeHash(const TVector4& V) {
        return HashCombine(
            HashCombine(GetTypeHash(V.X), GetTypeHash(V.Y)), HashCombine(GetTypeHash(V.Z), GetTypeHash(V.W)));
    }
};
template <typename T>
constexpr TVector<T>::TVector(const TVector4<T>& V) : X(V.X), Y(V.Y), Z(V.Z) {}
} // namespace UE::Math
