// SPDX-License-Identifier: MIT
/** FRay: an origin and a direction of length 1. */
#pragma once

#include "Math/Vector.h"

namespace UE::Math {
template <typename T>
struct TRay {
    using FReal = T;
    TVector<T> Origin;
    TVector<T> Direction;

    TRay() : Direction(0, 0, 1) {}
    TRay(const TVector<T>& InOrigin, const TVector<T>& InDirection, bool bDirectionIsNormalized = false)
        : Origin(InOrigin), Direction(bDirectionIsNormalized ? InDirection : InDirection.GetSafeNormal()) {}
    bool operator==(const TRay& Other) const { return Origin == Other.Origin && Direction == Other.Direction; }
    TVector<T> PointAt(T Parameter) const { return Origin + Direction * Parameter; }
    T GetParameter(const TVector<T>& Point) const { return (Point - Origin) | Direction; }
    TVector<T> ClosestPoint(const TVector<T>& Point) const { return PointAt(FMath::Max(T(0), GetParameter(Point))); }
    T DistSquared(const TVector<T>& Point) const { return (Point - ClosestPoint(Point)).SizeSquared(); }
    T Dist(const TVector<T>& Point) const { return FMath::Sqrt(DistSquared(Point)); }
};
} // namespace UE::Math
