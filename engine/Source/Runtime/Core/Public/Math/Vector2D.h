// SPDX-License-Identifier: MIT
/** FVector2D. */
#pragma once

#include "Containers/UnrealString.h"
#include "Math/IntPoint.h"
#include "Math/UnrealMathUtility.h"

namespace UE::Math {
namespace Private {
/** Reads the number after a tag like "X=". */
template <typename T>
bool ParseComponent(const FString& Text, const TCHAR* Tag, T& Out) {
    const int32 Place = Text.Find(Tag);
    if (Place == INDEX_NONE) {
        return false;
    }
    Out = static_cast<T>(FCString::Atod(*Text + Place + FCString::Strlen(Tag)));
    return true;
}
} // namespace Private

template <typename T>
struct TVector2 {
    static_assert(std::is_floating_point_v<T>);
    using FReal = T;

    T X;
    T Y;

    static const TVector2 ZeroVector;
    static const TVector2 UnitVector;
    static const TVector2 Unit45Deg;
    static constexpr TVector2 Zero() { return TVector2(0, 0); }
    static constexpr TVector2 One() { return TVector2(1, 1); }
    static constexpr TVector2 UnitX() { return TVector2(1, 0); }
    static constexpr TVector2 UnitY() { return TVector2(0, 1); }

    constexpr TVector2() : X(0), Y(0) {}
    explicit constexpr TVector2(T InF) : X(InF), Y(InF) {}
    constexpr TVector2(T InX, T InY) : X(InX), Y(InY) {}
    constexpr TVector2(FIntPoint P) : X(static_cast<T>(P.X)), Y(static_cast<T>(P.Y)) {}
    explicit constexpr TVector2(EForceInit) : X(0), Y(0) {}
    explicit TVector2(const TVector<T>& V);
    template <typename A>
        requires(!std::is_same_v<A, T>)
    explicit constexpr TVector2(const TVector2<A>& From) : X(static_cast<T>(From.X)), Y(static_cast<T>(From.Y)) {}

    constexpr TVector2 operator+(const TVector2& V) const { return TVector2(X + V.X, Y + V.Y); }
    constexpr TVector2 operator-(const TVector2& V) const { return TVector2(X - V.X, Y - V.Y); }
    constexpr TVector2 operator*(const TVector2& V) const { return TVector2(X * V.X, Y * V.Y); }
    constexpr TVector2 operator/(const TVector2& V) const { return TVector2(X / V.X, Y / V.Y); }
    template <typename A>
        requires std::is_arithmetic_v<A>
    constexpr TVector2 operator+(A Bias) const {
        return TVector2(X + T(Bias), Y + T(Bias));
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    constexpr TVector2 operator-(A Bias) const {
        return TVector2(X - T(Bias), Y - T(Bias));
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    constexpr TVector2 operator*(A Scale) const {
        return TVector2(X * T(Scale), Y * T(Scale));
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    constexpr TVector2 operator/(A Scale) const {
        return TVector2(X / T(Scale), Y / T(Scale));
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    friend constexpr TVector2 operator*(A Scale, const TVector2& V) {
        return V * Scale;
    }
    constexpr TVector2 operator-() const { return TVector2(-X, -Y); }
    TVector2& operator+=(const TVector2& V) { return *this = *this + V; }
    TVector2& operator-=(const TVector2& V) { return *this = *this - V; }
    TVector2& operator*=(const TVector2& V) { return *this = *this * V; }
    TVector2& operator/=(const TVector2& V) { return *this = *this / V; }
    template <typename A>
        requires std::is_arithmetic_v<A>
    TVector2& operator*=(A Scale) {
        return *this = *this * Scale;
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    TVector2& operator/=(A Scale) {
        return *this = *this / Scale;
    }
    constexpr T operator|(const TVector2& V) const { return X * V.X + Y * V.Y; }
    constexpr T operator^(const TVector2& V) const { return X * V.Y - Y * V.X; }
    constexpr bool operator==(const TVector2& V) const { return X == V.X && Y == V.Y; }
    constexpr bool operator<(const TVector2& O) const { return X < O.X && Y < O.Y; }
    constexpr bool operator>(const TVector2& O) const { return X > O.X && Y > O.Y; }
    constexpr bool operator<=(const TVector2& O) const { return X <= O.X && Y <= O.Y; }
    constexpr bool operator>=(const TVector2& O) const { return X >= O.X && Y >= O.Y; }
    T& operator[](int32 Index) {
        check(Index >= 0 && Index < 2);
        return Index == 0 ? X : Y;
    }
    T operator[](int32 Index) const { return const_cast<TVector2&>(*this)[Index]; }
    T& Component(int32 Index) { return (*this)[Index]; }

    static constexpr T DotProduct(const TVector2& A, const TVector2& B) { return A | B; }
    constexpr T Dot(const TVector2& V) const { return *this | V; }
    static constexpr T CrossProduct(const TVector2& A, const TVector2& B) { return A ^ B; }
    static T DistSquared(const TVector2& A, const TVector2& B) { return (A - B).SizeSquared(); }
    static T Distance(const TVector2& A, const TVector2& B) { return (A - B).Size(); }
    static TVector2 Min(const TVector2& A, const TVector2& B) {
        return TVector2(FMath::Min(A.X, B.X), FMath::Min(A.Y, B.Y));
    }
    static TVector2 Max(const TVector2& A, const TVector2& B) {
        return TVector2(FMath::Max(A.X, B.X), FMath::Max(A.Y, B.Y));
    }
    bool Equals(const TVector2& V, T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return FMath::Abs(X - V.X) <= Tolerance && FMath::Abs(Y - V.Y) <= Tolerance;
    }
    void Set(T InX, T InY) { *this = TVector2(InX, InY); }
    T GetMax() const { return FMath::Max(X, Y); }
    T GetMin() const { return FMath::Min(X, Y); }
    T GetAbsMax() const { return FMath::Max(FMath::Abs(X), FMath::Abs(Y)); }
    T Size() const { return FMath::Sqrt(SizeSquared()); }
    T Length() const { return Size(); }
    constexpr T SizeSquared() const { return X * X + Y * Y; }
    constexpr T SquaredLength() const { return SizeSquared(); }
    TVector2 GetRotated(T AngleDeg) const {
        T S, C;
        FMath::SinCos(&S, &C, FMath::DegreesToRadians(AngleDeg));
        return TVector2(C * X - S * Y, S * X + C * Y);
    }
    TVector2 GetSafeNormal(T Tolerance = UE_SMALL_NUMBER, const TVector2& ResultIfZero = ZeroVector) const {
        const T SquareSum = SizeSquared();
        return SquareSum > Tolerance ? *this * FMath::InvSqrt(SquareSum) : ResultIfZero;
    }
    void Normalize(T Tolerance = UE_SMALL_NUMBER) { *this = GetSafeNormal(Tolerance); }
    void ToDirectionAndLength(TVector2& OutDir, double& OutLength) const {
        OutLength = static_cast<double>(Size());
        OutDir = OutLength > UE_SMALL_NUMBER ? *this / OutLength : ZeroVector;
    }
    bool IsNearlyZero(T Tolerance = UE_KINDA_SMALL_NUMBER) const { return GetAbsMax() <= Tolerance; }
    bool IsZero() const { return X == 0 && Y == 0; }
    FIntPoint IntPoint() const { return FIntPoint(FMath::RoundToInt32(X), FMath::RoundToInt32(Y)); }
    TVector2 RoundToVector() const {
        return TVector2(T(FMath::RoundToDouble(double(X))), T(FMath::RoundToDouble(double(Y))));
    }
    TVector2 ClampAxes(T MinAxisVal, T MaxAxisVal) const {
        return TVector2(FMath::Clamp(X, MinAxisVal, MaxAxisVal), FMath::Clamp(Y, MinAxisVal, MaxAxisVal));
    }
    TVector2 GetSignVector() const { return TVector2(X >= 0 ? 1 : -1, Y >= 0 ? 1 : -1); }
    TVector2 GetAbs() const { return TVector2(FMath::Abs(X), FMath::Abs(Y)); }
    bool ContainsNaN() const { return !FMath::IsFinite(X) || !FMath::IsFinite(Y); }
    FString ToString() const {
        return FString::Printf(TEXT("X=%3.3f Y=%3.3f"), static_cast<double>(X), static_cast<double>(Y));
    }
    bool InitFromString(const FString& InSourceString) {
        return Private::ParseComponent(InSourceString, TEXT("X="), X) &&
               Private::ParseComponent(InSourceString, TEXT("Y="), Y);
    }
    friend uint32 GetTypeHash(const TVector2& V) { return HashCombine(GetTypeHash(V.X), GetTypeHash(V.Y)); }
};
template <typename T>
inline constexpr TVector2<T> TVector2<T>::ZeroVector(0, 0);
template <typename T>
inline constexpr TVector2<T> TVector2<T>::UnitVector(1, 1);
template <typename T>
inline constexpr TVector2<T> TVector2<T>::Unit45Deg(T(UE_DOUBLE_INV_SQRT_2), T(UE_DOUBLE_INV_SQRT_2));
} // namespace UE::Math
