// SPDX-License-Identifier: MIT
/** FBox2D. */
#pragma once

#include "Math/Vector2D.h"

namespace UE::Math {
template <typename T>
struct TBox2 {
    using FReal = T;
    TVector2<T> Min;
    TVector2<T> Max;
    bool bIsValid;

    constexpr TBox2() : bIsValid(false) {}
    explicit constexpr TBox2(EForceInit) : TBox2() {}
    constexpr TBox2(const TVector2<T>& InMin, const TVector2<T>& InMax) : Min(InMin), Max(InMax), bIsValid(true) {}

    void Init() { *this = TBox2(); }
    bool operator==(const TBox2& O) const { return bIsValid == O.bIsValid && Min == O.Min && Max == O.Max; }
    TBox2& operator+=(const TVector2<T>& Point) {
        Min = bIsValid ? TVector2<T>::Min(Min, Point) : Point;
        Max = bIsValid ? TVector2<T>::Max(Max, Point) : Point;
        bIsValid = true;
        return *this;
    }
    TBox2& operator+=(const TBox2& Other) {
        if (Other.bIsValid) {
            *this += Other.Min;
            *this += Other.Max;
        }
        return *this;
    }
    TBox2 operator+(const TVector2<T>& Point) const { return TBox2(*this) += Point; }
    TBox2 operator+(const TBox2& Other) const { return TBox2(*this) += Other; }
    TBox2 ExpandBy(T W) const { return TBox2(Min - W, Max + W); }
    T GetArea() const { return (Max.X - Min.X) * (Max.Y - Min.Y); }
    TVector2<T> GetCenter() const { return (Min + Max) * T(0.5); }
    TVector2<T> GetExtent() const { return (Max - Min) * T(0.5); }
    TVector2<T> GetSize() const { return Max - Min; }
    bool Intersect(const TBox2& O) const {
        return !(Min.X > O.Max.X || O.Min.X > Max.X || Min.Y > O.Max.Y || O.Min.Y > Max.Y);
    }
    bool IsInside(const TVector2<T>& P) const { return P.X > Min.X && P.X < Max.X && P.Y > Min.Y && P.Y < Max.Y; }
    FString ToString() const {
        return FString::Printf(TEXT("bIsValid=%s, Min=(%s), Max=(%s)"), bIsValid ? TEXT("true") : TEXT("false"),
            *Min.ToString(), *Max.ToString());
    }
};
} // namespace UE::Math
