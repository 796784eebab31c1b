// SPDX-License-Identifier: MIT
/** FSphere. */
#pragma once

#include "Math/Transform.h"

namespace UE::Math {
template <typename T>
struct TSphere {
    using FReal = T;
    TVector<T> Center;
    T W;

    constexpr TSphere() : W(0) {}
    explicit constexpr TSphere(EForceInit) : TSphere() {}
    explicit constexpr TSphere(T) : TSphere() {}
    constexpr TSphere(const TVector<T>& InCenter, T InRadius) : Center(InCenter), W(InRadius) {}

    bool Equals(const TSphere& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return Center.Equals(Other.Center, Tolerance) && FMath::Abs(W - Other.W) <= Tolerance;
    }
    bool operator==(const TSphere& Other) const { return Center == Other.Center && W == Other.W; }
    bool IsInside(const TVector<T>& Point, T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return (Center - Point).SizeSquared() <= FMath::Square(W + Tolerance);
    }
    /** Is this sphere inside the other? */
    bool IsInside(const TSphere& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return W <= Other.W + Tolerance &&
               (Center - Other.Center).SizeSquared() <= FMath::Square(Other.W + Tolerance - W);
    }
    bool Intersects(const TSphere& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return (Center - Other.Center).SizeSquared() <= FMath::Square(FMath::Max(T(0), Other.W + W + Tolerance));
    }
    TSphere TransformBy(const TTransform<T>& M) const {
        return TSphere(M.TransformPosition(Center), M.GetMaximumAxisScale() * W);
    }
    T GetVolume() const { return T(4.0 / 3.0 * UE_DOUBLE_PI) * W * W * W; }
};
} // namespace UE::Math
