// SPDX-License-Identifier: MIT
/** FBoxSphereBounds: a box and a sphere about the same origin. */
#pragma once

#include "Math/Box.h"

namespace UE::Math {
template <typename T, typename TExtent>
struct TBoxSphereBounds {
    using FReal = T;
    TVector<T> Origin;
    TVector<TExtent> BoxExtent;
    TExtent SphereRadius;

    constexpr TBoxSphereBounds() : SphereRadius(0) {}
    explicit constexpr TBoxSphereBounds(EForceInit) : TBoxSphereBounds() {}
    TBoxSphereBounds(const TVector<T>& InOrigin, const TVector<TExtent>& InBoxExtent, TExtent InSphereRadius)
        : Origin(InOrigin), BoxExtent(InBoxExtent), SphereRadius(InSphereRadius) {}
    TBoxSphereBounds(const TBox<T>& Box, const TSphere<T>& Sphere) {
        Box.GetCenterAndExtents(Origin, BoxExtent);
        SphereRadius = FMath::Min(BoxExtent.Size(), (Sphere.Center - Origin).Size() + Sphere.W);
    }
    explicit TBoxSphereBounds(const TBox<T>& Box) {
        Box.GetCenterAndExtents(Origin, BoxExtent);
        SphereRadius = BoxExtent.Size();
    }
    explicit TBoxSphereBounds(const TSphere<T>& Sphere)
        : Origin(Sphere.Center), BoxExtent(Sphere.W), SphereRadius(Sphere.W) {}
    TBoxSphereBounds(const TVector<T>* Points, uint32 NumPoints) : TBoxSphereBounds() {
        const TBox<T> Box(Points, static_cast<int32>(NumPoints));
        Box.GetCenterAndExtents(Origin, BoxExtent);
        for (uint32 Index = 0; Index < NumPoints; ++Index) {
            SphereRadius = FMath::Max(SphereRadius, (Points[Index] - Origin).Size());
        }
    }

    /** The bounds of both. */
    TBoxSphereBounds operator+(const TBoxSphereBounds& Other) const {
        TBoxSphereBounds Result(GetBox() + Other.GetBox());
        const T Mine = (Origin - Result.Origin).Size() + SphereRadius;
        const T Theirs = (Other.Origin - Result.Origin).Size() + Other.SphereRadius;
        Result.SphereRadius = FMath::Min(Result.SphereRadius, FMath::Max(Mine, Theirs));
        return Result;
    }
    bool operator==(const TBoxSphereBounds& O) const {
        return Origin == O.Origin && BoxExtent == O.BoxExtent && SphereRadius == O.SphereRadius;
    }
    TBox<T> GetBox() const { return TBox<T>(Origin - BoxExtent, Origin + BoxExtent); }
    TSphere<T> GetSphere() const { return TSphere<T>(Origin, SphereRadius); }
    TVector<T> GetBoxExtrema(uint32 Extrema) const { return Extrema ? Origin + BoxExtent : Origin - BoxExtent; }
    T ComputeSquaredDistanceFromBoxToPoint(const TVector<T>& Point) const {
        return GetBox().ComputeSquaredDistanceToPoint(Point);
    }
    TBoxSphereBounds ExpandBy(T Amount) const {
        return TBoxSphereBounds(Origin, BoxExtent + TVector<T>(Amount), SphereRadius + Amount);
    }
    TBoxSphereBounds TransformBy(const TMatrix<T>& M) const {
        TBoxSphereBounds Result(GetBox().TransformBy(M));
        Result.SphereRadius = FMath::Min(Result.BoxExtent.Size(), SphereRadius * M.GetMaximumAxisScale());
        return Result;
    }
    TBoxSphereBounds TransformBy(const TTransform<T>& M) const {
        TBoxSphereBounds Result(GetBox().TransformBy(M));
        Result.SphereRadius = FMath::Min(Result.BoxExtent.Size(), SphereRadius * M.GetMaximumAxisScale());
        return Result;
    }
    static bool SpheresIntersect(
        const TBoxSphereBounds& A, const TBoxSphereBounds& B, T Tolerance = UE_KINDA_SMALL_NUMBER) {
        return (A.Origin - B.Origin).SizeSquared() <=
               FMath::Square(FMath::Max(T(0), A.SphereRadius + B.SphereRadius + Tolerance));
    }
    static bool BoxesIntersect(const TBoxSphereBounds& A, const TBoxSphereBounds& B) {
        return A.GetBox().Intersect(B.GetBox());
    }
    bool ContainsNaN() const {
        return Origin.ContainsNaN() || BoxExtent.ContainsNaN() || !FMath::IsFinite(SphereRadius);
    }
    FString ToString() const {
        return FString::Printf(TEXT("Origin=%s, BoxExtent=(%s), SphereRadius=(%f)"), *Origin.ToString(),
            *BoxExtent.ToString(), static_cast<double>(SphereRadius));
    }
};
} // namespace UE::Math
