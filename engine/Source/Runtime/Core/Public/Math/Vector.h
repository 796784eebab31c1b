// SPDX-License-Identifier: MIT
/** FVector: a point or direction in a left-handed space with X forward, Y right, Z up; centimetres. */
#pragma once

#include "Containers/UnrealString.h"
#include "Internationalization/Text.h"
#include "Math/Axis.h"
#include "Math/IntVector.h"
#include "Math/UnrealMathUtility.h"
#include "Math/Vector2D.h"

namespace UE::Math {
template <typename T>
struct TVector {
    static_assert(std::is_floating_point_v<T>);
    using FReal = T;

    T X;
    T Y;
    T Z;

    static const TVector ZeroVector;
    static const TVector OneVector;
    static const TVector UpVector;
    static const TVector DownVector;
    static const TVector ForwardVector;
    static const TVector BackwardVector;
    static const TVector RightVector;
    static const TVector LeftVector;
    static const TVector XAxisVector;
    static const TVector YAxisVector;
    static const TVector ZAxisVector;
    static constexpr TVector Zero() { return TVector(0, 0, 0); }
    static constexpr TVector One() { return TVector(1, 1, 1); }
    static constexpr TVector UnitX() { return TVector(1, 0, 0); }
    static constexpr TVector UnitY() { return TVector(0, 1, 0); }
    static constexpr TVector UnitZ() { return TVector(0, 0, 1); }

    constexpr TVector() : X(0), Y(0), Z(0) {}
    explicit constexpr TVector(T InF) : X(InF), Y(InF), Z(InF) {}
    constexpr TVector(T InX, T InY, T InZ) : X(InX), Y(InY), Z(InZ) {}
    template <typename A>
    explicit constexpr TVector(const TVector2<A>& V, T InZ = 0)
        : X(static_cast<T>(V.X)), Y(static_cast<T>(V.Y)), Z(InZ) {}
    constexpr TVector(const TVector4<T>& V);
    explicit constexpr TVector(const FLinearColor& InColor);
    explicit constexpr TVector(FIntVector InVector) : X(T(InVector.X)), Y(T(InVector.Y)), Z(T(InVector.Z)) {}
    explicit constexpr TVector(FIntPoint A) : X(T(A.X)), Y(T(A.Y)), Z(0) {}
    explicit constexpr TVector(EForceInit) : TVector() {}
    template <typename A>
        requires(!std::is_same_v<A, T>)
    explicit constexpr TVector(const TVector<A>& From)
        : X(static_cast<T>(From.X)), Y(static_cast<T>(From.Y)), Z(static_cast<T>(From.Z)) {}

    // ----- operators: | is the dot product, ^ the cross product

    TVector operator^(const TVector& V) const { return Cross(V); }
    constexpr TVector Cross(const TVector& V) const {
        return TVector(Y * V.Z - Z * V.Y, Z * V.X - X * V.Z, X * V.Y - Y * V.X);
    }
    static constexpr TVector CrossProduct(const TVector& A, const TVector& B) { return A.Cross(B); }
    constexpr T operator|(const TVector& V) const { return X * V.X + Y * V.Y + Z * V.Z; }
    constexpr T Dot(const TVector& V) const { return *this | V; }
    static constexpr T DotProduct(const TVector& A, const TVector& B) { return A | B; }
    constexpr TVector operator+(const TVector& V) const { return TVector(X + V.X, Y + V.Y, Z + V.Z); }
    constexpr TVector operator-(const TVector& V) const { return TVector(X - V.X, Y - V.Y, Z - V.Z); }
    template <typename A>
        requires std::is_arithmetic_v<A>
    constexpr TVector operator+(A Bias) const {
        return TVector(X + T(Bias), Y + T(Bias), Z + T(Bias));
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    constexpr TVector operator-(A Bias) const {
        return TVector(X - T(Bias), Y - T(Bias), Z - T(Bias));
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    constexpr TVector operator*(A Scale) const {
        return TVector(X * T(Scale), Y * T(Scale), Z * T(Scale));
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    constexpr TVector operator/(A Scale) const {
        const T Inverse = T(1) / T(Scale);
        return TVector(X * Inverse, Y * Inverse, Z * Inverse);
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    friend constexpr TVector operator*(A Scale, const TVector& V) {
        return V * Scale;
    }
    constexpr TVector operator*(const TVector& V) const { return TVector(X * V.X, Y * V.Y, Z * V.Z); }
    constexpr TVector operator/(const TVector& V) const { return TVector(X / V.X, Y / V.Y, Z / V.Z); }
    constexpr bool operator==(const TVector& V) const { return X == V.X && Y == V.Y && Z == V.Z; }
    constexpr TVector operator-() const { return TVector(-X, -Y, -Z); }
    TVector& operator+=(const TVector& V) { return *this = *this + V; }
    TVector& operator-=(const TVector& V) { return *this = *this - V; }
    TVector& operator*=(const TVector& V) { return *this = *this * V; }
    TVector& operator/=(const TVector& V) { return *this = *this / V; }
    template <typename A>
        requires std::is_arithmetic_v<A>
    TVector& operator*=(A Scale) {
        return *this = *this * Scale;
    }
    template <typename A>
        requires std::is_arithmetic_v<A>
    TVector& operator/=(A Scale) {
        return *this = *this / Scale;
    }
    T& operator[](int32 Index) {
        check(Index >= 0 && Index < 3);
        return Index == 0 ? X : (Index == 1 ? Y : Z);
    }
    T operator[](int32 Index) const { return const_cast<TVector&>(*this)[Index]; }
    T& Component(int32 Index) { return (*this)[Index]; }
    T Component(int32 Index) const { return (*this)[Index]; }
    T GetComponentForAxis(EAxis::Type Axis) const {
        return Axis == EAxis::X ? X : (Axis == EAxis::Y ? Y : (Axis == EAxis::Z ? Z : T(0)));
    }
    void SetComponentForAxis(EAxis::Type Axis, T Component) { (*this)[static_cast<int32>(Axis) - 1] = Component; }
    void Set(T InX, T InY, T InZ) { *this = TVector(InX, InY, InZ); }

    // ----- comparing and measuring

    bool Equals(const TVector& V, T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return FMath::Abs(X - V.X) <= Tolerance && FMath::Abs(Y - V.Y) <= Tolerance && FMath::Abs(Z - V.Z) <= Tolerance;
    }
    bool AllComponentsEqual(T Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return FMath::Abs(X - Y) <= Tolerance && FMath::Abs(X - Z) <= Tolerance && FMath::Abs(Y - Z) <= Tolerance;
    }
    bool IsUniform(T Tolerance = UE_KINDA_SMALL_NUMBER) const { return AllComponentsEqual(Tolerance); }
    T GetMax() const { return FMath::Max3(X, Y, Z); }
    T GetMin() const { return FMath::Min3(X, Y, Z); }
    T GetAbsMax() const { return GetAbs().GetMax(); }
    T GetAbsMin() const { return GetAbs().GetMin(); }
    TVector GetAbs() const { return TVector(FMath::Abs(X), FMath::Abs(Y), FMath::Abs(Z)); }
    TVector ComponentMin(const TVector& O) const {
        return TVector(FMath::Min(X, O.X), FMath::Min(Y, O.Y), FMath::Min(Z, O.Z));
    }
    TVector ComponentMax(const TVector& O) const {
        return TVector(FMath::Max(X, O.X), FMath::Max(Y, O.Y), FMath::Max(Z, O.Z));
    }
    static TVector Min(const TVector& A, const TVector& B) { return A.ComponentMin(B); }
    static TVector Max(const TVector& A, const TVector& B) { return A.ComponentMax(B); }
    T Size() const { return FMath::Sqrt(SizeSquared()); }
    T Length() const { return Size(); }
    constexpr T SizeSquared() const { return X * X + Y * Y + Z * Z; }
    constexpr T SquaredLength() const { return SizeSquared(); }
    T Size2D() const { return FMath::Sqrt(SizeSquared2D()); }
    constexpr T SizeSquared2D() const { return X * X + Y * Y; }
    bool IsNearlyZero(T Tolerance = UE_KINDA_SMALL_NUMBER) const { return GetAbsMax() <= Tolerance; }
    bool IsZero() const { return X == 0 && Y == 0 && Z == 0; }
    bool IsUnit(T LengthSquaredTolerance = UE_KINDA_SMALL_NUMBER) const {
        return FMath::Abs(T(1) - SizeSquared()) < LengthSquaredTolerance;
    }
    bool IsNormalized() const { return FMath::Abs(T(1) - SizeSquared()) < UE_THRESH_VECTOR_NORMALIZED; }
    bool ContainsNaN() const { return !FMath::IsFinite(X) || !FMath::IsFinite(Y) || !FMath::IsFinite(Z); }
    static T Dist(const TVector& A, const TVector& B) { return (A - B).Size(); }
    static T Distance(const TVector& A, const TVector& B) { return Dist(A, B); }
    static T DistXY(const TVector& A, const TVector& B) { return (A - B).Size2D(); }
    static T Dist2D(const TVector& A, const TVector& B) { return DistXY(A, B); }
    static T DistSquared(const TVector& A, const TVector& B) { return (A - B).SizeSquared(); }
    static T DistSquaredXY(const TVector& A, const TVector& B) { return (A - B).SizeSquared2D(); }
    static T DistSquared2D(const TVector& A, const TVector& B) { return DistSquaredXY(A, B); }
    static T PointPlaneDist(const TVector& Point, const TVector& PlaneBase, const TVector& PlaneNormal) {
        return (Point - PlaneBase) | PlaneNormal;
    }
    static bool PointsAreSame(const TVector& P, const TVector& Q) { return P.Equals(Q, T(0.00002)); }
    static bool PointsAreNear(const TVector& P, const TVector& Q, T Dist) { return P.Equals(Q, Dist); }
    static bool Parallel(const TVector& A, const TVector& B, T Threshold = UE_THRESH_NORMALS_ARE_PARALLEL) {
        return FMath::Abs(A | B) >= Threshold;
    }
    static bool Coincident(const TVector& A, const TVector& B, T Threshold = UE_THRESH_NORMALS_ARE_PARALLEL) {
        return (A | B) >= Threshold;
    }
    static bool Orthogonal(const TVector& A, const TVector& B, T Threshold = UE_THRESH_NORMALS_ARE_ORTHOGONAL) {
        return FMath::Abs(A | B) <= Threshold;
    }
    static T Triple(const TVector& A, const TVector& B, const TVector& C) { return A | (B ^ C); }

    // ----- normalising

    /** Scales to length 1; false (and unchanged) if it is too short. */
    bool Normalize(T Tolerance = UE_SMALL_NUMBER) {
        const T SquareSum = SizeSquared();
        if (SquareSum > Tolerance) {
            *this *= FMath::InvSqrt(SquareSum);
            return true;
        }
        return false;
    }
    TVector GetUnsafeNormal() const { return *this * FMath::InvSqrt(SizeSquared()); }
    TVector GetSafeNormal(T Tolerance = UE_SMALL_NUMBER, const TVector& ResultIfZero = ZeroVector) const {
        const T SquareSum = SizeSquared();
        if (SquareSum == T(1)) {
            return *this;
        }
        return SquareSum < Tolerance ? ResultIfZero : *this * FMath::InvSqrt(SquareSum);
    }
    TVector GetSafeNormal2D(T Tolerance = UE_SMALL_NUMBER, const TVector& ResultIfZero = ZeroVector) const {
        const T SquareSum = SizeSquared2D();
        if (SquareSum < Tolerance) {
            return ResultIfZero;
        }
        const T Scale = FMath::InvSqrt(SquareSum);
        return TVector(X * Scale, Y * Scale, 0);
    }
    void ToDirectionAndLength(TVector& OutDir, double& OutLength) const {
        OutLength = static_cast<double>(Size());
        OutDir = OutLength > UE_SMALL_NUMBER ? *this / OutLength : ZeroVector;
    }
    TVector GetSignVector() const { return TVector(X >= 0 ? 1 : -1, Y >= 0 ? 1 : -1, Z >= 0 ? 1 : -1); }
    TVector Projection() const { return TVector(X / Z, Y / Z, 1); }
    TVector Reciprocal() const {
        return TVector(X != 0 ? T(1) / X : T(UE_BIG_NUMBER), Y != 0 ? T(1) / Y : T(UE_BIG_NUMBER),
            Z != 0 ? T(1) / Z : T(UE_BIG_NUMBER));
    }
    TVector GridSnap(const T& GridSz) const {
        return TVector(FMath::GridSnap(X, GridSz), FMath::GridSnap(Y, GridSz), FMath::GridSnap(Z, GridSz));
    }
    TVector BoundToCube(T Radius) const {
        return TVector(
            FMath::Clamp(X, -Radius, Radius), FMath::Clamp(Y, -Radius, Radius), FMath::Clamp(Z, -Radius, Radius));
    }
    TVector BoundToBox(const TVector& InMin, const TVector& InMax) const {
        return ComponentMax(InMin).ComponentMin(InMax);
    }
    TVector GetClampedToSize(T InMin, T InMax) const {
        const T Length_ = Size();
        const TVector Dir = Length_ > T(UE_SMALL_NUMBER) ? *this / Length_ : ZeroVector;
        return Dir * FMath::Clamp(Length_, InMin, InMax);
    }
    TVector GetClampedToMaxSize(T MaxSize) const {
        if (MaxSize < T(UE_KINDA_SMALL_NUMBER)) {
            return ZeroVector;
        }
        const T Square = SizeSquared();
        return Square > MaxSize * MaxSize ? *this * (MaxSize * FMath::InvSqrt(Square)) : *this;
    }
    TVector GetClampedToMaxSize2D(T MaxSize) const {
        if (MaxSize < T(UE_KINDA_SMALL_NUMBER)) {
            return TVector(0, 0, Z);
        }
        const T Square = SizeSquared2D();
        if (Square > MaxSize * MaxSize) {
            const T Scale = MaxSize * FMath::InvSqrt(Square);
            return TVector(X * Scale, Y * Scale, Z);
        }
        return *this;
    }

    // ----- directions

    TVector MirrorByVector(const TVector& MirrorNormal) const {
        return *this - MirrorNormal * (T(2) * (*this | MirrorNormal));
    }
    TVector MirrorByPlane(const TPlane<T>& Plane) const;
    /** Turns about an axis, which must be of length 1. */
    TVector RotateAngleAxis(T AngleDeg, const TVector& Axis) const {
        return RotateAngleAxisRad(FMath::DegreesToRadians(AngleDeg), Axis);
    }
    TVector RotateAngleAxisRad(T AngleRad, const TVector& Axis) const {
        T S, C;
        FMath::SinCos(&S, &C, AngleRad);
        const T OMC = T(1) - C;
        const TVector& A = Axis;
        return TVector((OMC * A.X * A.X + C) * X + (OMC * A.X * A.Y - A.Z * S) * Y + (OMC * A.Z * A.X + A.Y * S) * Z,
            (OMC * A.X * A.Y + A.Z * S) * X + (OMC * A.Y * A.Y + C) * Y + (OMC * A.Y * A.Z - A.X * S) * Z,
            (OMC * A.Z * A.X - A.Y * S) * X + (OMC * A.Y * A.Z + A.X * S) * Y + (OMC * A.Z * A.Z + C) * Z);
    }
    T CosineAngle2D(TVector B) const {
        TVector A(*this);
        A.Z = 0;
        B.Z = 0;
        A.Normalize();
        B.Normalize();
        return A | B;
    }
    TVector ProjectOnTo(const TVector& A) const { return A * ((*this | A) / (A | A)); }
    TVector ProjectOnToNormal(const TVector& Normal) const { return Normal * (*this | Normal); }
    static TVector PointPlaneProject(const TVector& Point, const TVector& PlaneBase, const TVector& PlaneNorm) {
        return Point - PlaneNorm * PointPlaneDist(Point, PlaneBase, PlaneNorm);
    }
    static TVector PointPlaneProject(const TVector& Point, const TPlane<T>& Plane);
    static TVector VectorPlaneProject(const TVector& V, const TVector& PlaneNormal) {
        return V - V.ProjectOnToNormal(PlaneNormal);
    }
    /** Pitch and yaw of the direction; no roll. */
    TRotator<T> ToOrientationRotator() const;
    TQuat<T> ToOrientationQuat() const;
    TRotator<T> Rotation() const { return ToOrientationRotator(); }
    /** Two axes at right angles to this one and each other. */
    void FindBestAxisVectors(TVector& Axis1, TVector& Axis2) const {
        const T NX = FMath::Abs(X);
        const T NY = FMath::Abs(Y);
        const T NZ = FMath::Abs(Z);
        Axis1 = NZ > NX && NZ > NY ? TVector(1, 0, 0) : TVector(0, 0, 1);
        Axis1 = (Axis1 - *this * (Axis1 | *this)).GetSafeNormal();
        Axis2 = Axis1 ^ *this;
    }
    /** Angle of the X and Y part, in radians. */
    T HeadingAngle() const {
        const TVector Plane = GetSafeNormal2D();
        const T Angle = FMath::Acos(Plane.X);
        return Plane.Y < 0 ? -Angle : Angle;
    }
    void UnwindEuler() {
        X = FMath::UnwindDegrees(X);
        Y = FMath::UnwindDegrees(Y);
        Z = FMath::UnwindDegrees(Z);
    }
    /** (inclination, azimuth) of a unit vector. */
    TVector2<T> UnitCartesianToSpherical() const { return TVector2<T>(FMath::Acos(Z / Size()), FMath::Atan2(Y, X)); }
    static TVector RadiansToDegrees(const TVector& V) { return V * T(180.0 / UE_DOUBLE_PI); }
    static TVector DegreesToRadians(const TVector& V) { return V * T(UE_DOUBLE_PI / 180.0); }
    static TVector SlerpVectorToDirection(const TVector& V, const TVector& Direction, T Alpha);

    // ----- text

    FString ToString() const {
        return FString::Printf(
            TEXT("X=%3.3f Y=%3.3f Z=%3.3f"), static_cast<double>(X), static_cast<double>(Y), static_cast<double>(Z));
    }
    FText ToText() const { return FText::FromString(ToString()); }
    FString ToCompactString() const {
        return FString::Printf(
            TEXT("V(X=%.2f, Y=%.2f, Z=%.2f)"), static_cast<double>(X), static_cast<double>(Y), static_cast<double>(Z));
    }
    /** Reads "X=1 Y=2 Z=3". */
    bool InitFromString(const FString& InSourceString) {
        return Private::ParseComponent(InSourceString, TEXT("X="), X) &&
               Private::ParseComponent(InSourceString, TEXT("Y="), Y) &&
               Private::ParseComponent(InSourceString, TEXT("Z="), Z);
    }
    friend uint32 GetTypeHash(const TVector& V) {
        return HashCombine(HashCombine(GetTypeHash(V.X), GetTypeHash(V.Y)), GetTypeHash(V.Z));
    }
};
template <typename T>
inline constexpr TVector<T> TVector<T>::ZeroVector(0, 0, 0);
template <typename T>
inline constexpr TVector<T> TVector<T>::OneVector(1, 1, 1);
template <typename T>
inline constexpr TVector<T> TVector<T>::UpVector(0, 0, 1);
template <typename T>
inline constexpr TVector<T> TVector<T>::DownVector(0, 0, -1);
template <typename T>
inline constexpr TVector<T> TVector<T>::ForwardVector(1, 0, 0);
template <typename T>
inline constexpr TVector<T> TVector<T>::BackwardVector(-1, 0, 0);
template <typename T>
inline constexpr TVector<T> TVector<T>::RightVector(0, 1, 0);
template <typename T>
inline constexpr TVector<T> TVector<T>::LeftVector(0, -1, 0);
template <typename T>
inline constexpr TVector<T> TVector<T>::XAxisVector(1, 0, 0);
template <typename T>
inline constexpr TVector<T> TVector<T>::YAxisVector(0, 1, 0);
template <typename T>
inline constexpr TVector<T> TVector<T>::ZAxisVector(0, 0, 1);

template <typename T>
TVector2<T>::TVector2(const TVector<T>& V) : X(V.X), Y(V.Y) {}
} // namespace UE::Math

template <typename T>
inline FString LexToString(const UE::Math::TVector<T>& V) {
    return V.ToString();
}
