// SPDX-License-Identifier: MIT
/** FPlane: X * x + Y * y + Z * z = W, with (X, Y, Z) the normal. */
#pragma once

#include "Math/Vector4.h"

namespace UE::Math {
template <typename T>
struct alignas(16) TPlane : public TVector<T> {
    using TVector<T>::X;
    using TVector<T>::Y;
    using TVector<T>::Z;
    T W;

    constexpr TPlane() : W(0) {}
    constexpr TPlane(T InX, T InY, T InZ, T InW) : TVector<T>(InX, InY, InZ), W(InW) {}
    TPlane(TVector<T> InNormal, T InW) : TVector<T>(InNormal), W(InW) {}
    TPlane(TVector<T> InBase, const TVector<T>& InNormal) : TVector<T>(InNormal), W(InBase | InNormal) {}
    explicit TPlane(const TVector4<T>& V) : TVector<T>(V.X, V.Y, V.Z), W(V.W) {}
    /** Through three points; the normal is (B - A) ^ (C - A). */
    TPlane(TVector<T> A, TVector<T> B, TVector<T> C) : TVector<T>(((B - A) ^ (C - A)).GetSafeNormal()) {
        W = A | static_cast<const TVector<T>&>(*this);
    }
    explicit constexpr TPlane(EForceInit) : TPlane() {}

    /** Signed distance, positive on the normal's side. */
    T PlaneDot(const TVector<T>& P) const { return X * P.X + Y * P.Y + Z * P.Z - W; }
    TVector<T> GetOrigin() const { return GetNormal() * W; }
    const TVector<T>& GetNormal() const { return *this; }
    bool Normalize(T Tolerance = UE_SMALL_NUMBER) {
        const T Square = X * X + Y * Y + Z * Z;
        if (Square <= Tolerance) {
            return false;
        }
        const T Scale = FMath::InvSqrt(Square);
        *this = TPlane(X * Scale, Y * Scale, Z * Scale, W * Scale);
        return true;
    }
    TPlane Flip() const { return TPlane(-X, -Y, -Z, -W); }
    TPlane TransformBy(const TMatrix<T>& M) const;
    bool operator==(const TPlane& V) const { return X == V.X && Y == V.Y && Z == V.Z && W == V.W; }
    bool Equals(const TPlane& V, T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return GetNormal().Equals(V.GetNormal(), Tolerance) && FMath::Abs(W - V.W) < Tolerance;
    }
    FString ToString() const {
        return FString::Printf(TEXT("X=%3.3f Y=%3.3f Z=%3.3f W=%3.3f"), static_cast<double>(X), static_cast<double>(Y),
            static_cast<double>(Z), static_cast<double>(W));
    }
};
template <typename T>
TVector<T> TVector<T>::MirrorByPlane(const TPlane<T>& Plane) const {
    return *this - Plane.GetNormal() * (T(2) * Plane.PlaneDot(*this));
}
template <typename T>
TVector<T> TVector<T>::PointPlaneProject(const TVector& Point, const TPlane<T>& Plane) {
    return Point - Plane.GetNormal() * Plane.PlaneDot(Point);
}
} // namespace UE::Math
