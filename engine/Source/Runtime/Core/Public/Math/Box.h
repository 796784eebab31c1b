// SPDX-License-Identifier: MIT
/** FBox: an axis-aligned box. */
#pragma once

#include "Math/Sphere.h"

namespace UE::Math {
template <typename T>
struct TBox {
    static_assert(std::is_floating_point_v<T>);
    using FReal = T;

    TVector<T> Min;
    TVector<T> Max;
    uint8 IsValid;

    constexpr TBox() : IsValid(0) {}
    explicit constexpr TBox(EForceInit) : TBox() {}
    constexpr TBox(const TVector<T>& InMin, const TVector<T>& InMax) : Min(InMin), Max(InMax), IsValid(1) {}
    TBox(const TVector<T>* Points, int32 Count) : TBox() {
        for (int32 Index = 0; Index < Count; ++Index) {
            *this += Points[Index];
        }
    }
    explicit TBox(const TArray<TVector<T>>& Points) : TBox(Points.GetData(), Points.Num()) {}
    template <typename A>
        requires(!std::is_same_v<A, T>)
    explicit TBox(const TBox<A>& From) : Min(From.Min), Max(From.Max), IsValid(From.IsValid) {}
    static TBox BuildAABB(const TVector<T>& Origin, const TVector<T>& Extent) {
        return TBox(Origin - Extent, Origin + Extent);
    }

    void Init() { *this = TBox(); }
    bool operator==(const TBox& Other) const {
        return (!IsValid && !Other.IsValid) || (IsValid && Other.IsValid && Min == Other.Min && Max == Other.Max);
    }
    bool Equals(const TBox& Other, T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return IsValid == Other.IsValid && Min.Equals(Other.Min, Tolerance) && Max.Equals(Other.Max, Tolerance);
    }
    TBox& operator+=(const TVector<T>& Point) {
        if (IsValid) {
            Min = Min.ComponentMin(Point);
            Max = Max.ComponentMax(Point);
        } else {
            Min = Max = Point;
            IsValid = 1;
        }
        return *this;
    }
    TBox& operator+=(const TBox& Other) {
        if (IsValid && Other.IsValid) {
            Min = Min.ComponentMin(Other.Min);
            Max = Max.ComponentMax(Other.Max);
        } else if (Other.IsValid) {
            *this = Other;
        }
        return *this;
    }
    TBox operator+(const TVector<T>& Point) const { return TBox(*this) += Point; }
    TBox operator+(const TBox& Other) const { return TBox(*this) += Other; }
    TVector<T>& operator[](int32 Index) {
        check(Index == 0 || Index == 1);
        return Index == 0 ? Min : Max;
    }
    T ComputeSquaredDistanceToPoint(const TVector<T>& Point) const {
        return (Point - GetClosestPointTo(Point)).SizeSquared();
    }
    TBox ExpandBy(T W) const { return TBox(Min - TVector<T>(W), Max + TVector<T>(W)); }
    TBox ExpandBy(const TVector<T>& V) const { return TBox(Min - V, Max + V); }
    TBox ShiftBy(const TVector<T>& Offset) const { return TBox(Min + Offset, Max + Offset); }
    TBox MoveTo(const TVector<T>& Destination) const { return ShiftBy(Destination - GetCenter()); }
    TVector<T> GetCenter() const { return (Min + Max) * T(0.5); }
    /** Half the size. */
    TVector<T> GetExtent() const { return (Max - Min) * T(0.5); }
    TVector<T> GetSize() const { return Max - Min; }
    void GetCenterAndExtents(TVector<T>& Center, TVector<T>& Extents) const {
        Extents = GetExtent();
        Center = Min + Extents;
    }
    T GetVolume() const { return (Max.X - Min.X) * (Max.Y - Min.Y) * (Max.Z - Min.Z); }
    TVector<T> GetClosestPointTo(const TVector<T>& Point) const { return Point.BoundToBox(Min, Max); }
    void GetVertices(TVector<T> (&Vertices)[8]) const {
        for (int32 Index = 0; Index < 8; ++Index) {
            Vertices[Index] =
                TVector<T>(Index & 1 ? Max.X : Min.X, Index & 2 ? Max.Y : Min.Y, Index & 4 ? Max.Z : Min.Z);
        }
    }
    bool Intersect(const TBox& O) const {
        return !(Min.X > O.Max.X || O.Min.X > Max.X || Min.Y > O.Max.Y || O.Min.Y > Max.Y || Min.Z > O.Max.Z ||
                 O.Min.Z > Max.Z);
    }
    bool IntersectXY(const TBox& O) const {
        return !(Min.X > O.Max.X || O.Min.X > Max.X || Min.Y > O.Max.Y || O.Min.Y > Max.Y);
    }
    TBox Overlap(const TBox& O) const {
        return Intersect(O) ? TBox(Min.ComponentMax(O.Min), Max.ComponentMin(O.Max)) : TBox();
    }
    /** Strictly inside. */
    bool IsInside(const TVector<T>& P) const {
        return P.X > Min.X && P.X < Max.X && P.Y > Min.Y && P.Y < Max.Y && P.Z > Min.Z && P.Z < Max.Z;
    }
    bool IsInsideOrOn(const TVector<T>& P) const {
        return P.X >= Min.X && P.X <= Max.X && P.Y >= Min.Y && P.Y <= Max.Y && P.Z >= Min.Z && P.Z <= Max.Z;
    }
    bool IsInside(const TBox& Other) const { return IsInside(Other.Min) && IsInside(Other.Max); }
    bool IsInsideXY(const TVector<T>& P) const { return P.X > Min.X && P.X < Max.X && P.Y > Min.Y && P.Y < Max.Y; }
    TBox TransformBy(const TTransform<T>& M) const {
        return Transformed([&](const TVector<T>& P) { return M.TransformPosition(P); });
    }
    TBox TransformBy(const TMatrix<T>& M) const {
        return Transformed([&](const TVector<T>& P) { return TVector<T>(M.TransformPosition(P)); });
    }
    TBox InverseTransformBy(const TTransform<T>& M) const {
        return Transformed([&](const TVector<T>& P) { return M.InverseTransformPosition(P); });
    }
    FString ToString() const {
        return FString::Printf(TEXT("IsValid=%s, Min=(%s), Max=(%s)"), IsValid ? TEXT("true") : TEXT("false"),
            *Min.ToString(), *Max.ToString());
    }
    friend uint32 GetTypeHash(const TBox& Box) { return HashCombine(GetTypeHash(Box.Min), GetTypeHash(Box.Max)); }

private:
    template <typename F>
    TBox Transformed(const F& Function) const {
        if (!IsValid) {
            return TBox();
        }
        TVector<T> Vertices[8];
        GetVertices(Vertices);
        TBox Result;
        for (const TVector<T>& Vertex : Vertices) {
            Result += Function(Vertex);
        }
        return Result;
    }
};
} // namespace UE::Math
