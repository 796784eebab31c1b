// SPDX-License-Identifier: MIT
/** FMath and its constants. Angles are radians unless a name says degrees. */
#pragma once

#include <algorithm>
#include <cmath>

#include "HAL/PlatformMath.h"
#include "Math/MathFwd.h"
#include "Templates/UnrealTemplate.h"

#define UE_PI (3.1415926535897932f)
#define UE_SMALL_NUMBER (1.e-8f)
#define UE_KINDA_SMALL_NUMBER (1.e-4f)
#define UE_BIG_NUMBER (3.4e+38f)
#define UE_EULERS_NUMBER (2.71828182845904523536f)
#define UE_GOLDEN_RATIO (1.6180339887498948482045868343656381f)
#define UE_FLOAT_NON_FRACTIONAL (8388608.f)
#define UE_DOUBLE_PI (3.141592653589793238462643383279502884197169399)
#define UE_DOUBLE_SMALL_NUMBER (1.e-8)
#define UE_DOUBLE_KINDA_SMALL_NUMBER (1.e-4)
#define UE_DOUBLE_BIG_NUMBER (3.4e+38)
#define UE_DOUBLE_GOLDEN_RATIO (1.6180339887498948482045868343656381)
#define UE_INV_PI (0.31830988618f)
#define UE_HALF_PI (1.57079632679f)
#define UE_TWO_PI (6.28318530717f)
#define UE_PI_SQUARED (9.86960440108f)
#define UE_DOUBLE_INV_PI (0.31830988618379067154)
#define UE_DOUBLE_HALF_PI (1.57079632679489661923)
#define UE_DOUBLE_TWO_PI (6.28318530717958647692)
#define UE_SQRT_2 (1.4142135623730950488016887242097f)
#define UE_SQRT_3 (1.7320508075688772935274463415059f)
#define UE_INV_SQRT_2 (0.70710678118654752440084436210485f)
#define UE_DOUBLE_SQRT_2 (1.4142135623730950488016887242097)
#define UE_DOUBLE_INV_SQRT_2 (0.70710678118654752440084436210485)
#define UE_DELTA (0.00001f)
#define UE_DOUBLE_DELTA (0.00001)
#define UE_THRESH_POINT_ON_PLANE (0.10f)
#define UE_THRESH_NORMALS_ARE_PARALLEL (0.999845f)
#define UE_THRESH_NORMALS_ARE_ORTHOGONAL (0.017455f)
#define UE_THRESH_VECTOR_NORMALIZED (0.01f)
#define UE_THRESH_QUAT_NORMALIZED (0.01f)
#define UE_DOUBLE_THRESH_NORMALS_ARE_ORTHOGONAL (0.017455)
// The short names that code older than UE 5.1 uses.
#define PI UE_PI
#define SMALL_NUMBER UE_SMALL_NUMBER
#define KINDA_SMALL_NUMBER UE_KINDA_SMALL_NUMBER
#define BIG_NUMBER UE_BIG_NUMBER
#define INV_PI UE_INV_PI
#define HALF_PI UE_HALF_PI
#define TWO_PI UE_TWO_PI
#define DELTA UE_DELTA
#define DOUBLE_PI UE_DOUBLE_PI

struct FMath : public FPlatformMath {
    using FPlatformMath::CeilToInt32;

    // ----- random numbers; one global sequence, the same in every run until RandInit

    /** Integer in [0, A). */
    static int32 RandHelper(int32 A) { return A > 0 ? Min(TruncToInt32(FRand() * static_cast<float>(A)), A - 1) : 0; }
    static int64 RandHelper64(int64 A) {
        return A > 0 ? Min(static_cast<int64>(static_cast<double>(FRand()) * static_cast<double>(A)), A - 1) : 0;
    }
    /** Integer in [Min, Max]. */
    static int32 RandRange(int32 InMin, int32 InMax) { return InMin + RandHelper(InMax - InMin + 1); }
    static int64 RandRange(int64 InMin, int64 InMax) { return InMin + RandHelper64(InMax - InMin + 1); }
    static float RandRange(float InMin, float InMax) { return FRandRange(InMin, InMax); }
    static double RandRange(double InMin, double InMax) { return FRandRange(InMin, InMax); }
    static float FRandRange(float InMin, float InMax) { return InMin + (InMax - InMin) * FRand(); }
    static double FRandRange(double InMin, double InMax) {
        return InMin + (InMax - InMin) * static_cast<double>(FRand());
    }
    static bool RandBool() { return RandRange(0, 1) == 1; }
    /** Unit vector, uniform on the sphere. */
    static CORE_API FVector VRand();
    static CORE_API FVector VRandCone(const FVector& Dir, float ConeHalfAngleRad);
    static CORE_API FVector2D RandPointInCircle(float CircleRadius);
    static CORE_API FVector RandPointInBox(const FBox& Box);

    // ----- comparing

    template <typename A, typename B>
    static constexpr bool IsWithin(A TestValue, B MinValue, B MaxValue) {
        return TestValue >= MinValue && TestValue < MaxValue;
    }
    template <typename A, typename B>
    static constexpr bool IsWithinInclusive(A TestValue, B MinValue, B MaxValue) {
        return TestValue >= MinValue && TestValue <= MaxValue;
    }
    static bool IsNearlyEqual(float A, float B, float ErrorTolerance = UE_SMALL_NUMBER) {
        return Abs(A - B) <= ErrorTolerance;
    }
    static bool IsNearlyEqual(double A, double B, double ErrorTolerance = UE_DOUBLE_SMALL_NUMBER) {
        return Abs(A - B) <= ErrorTolerance;
    }
    template <typename A, typename B>
        requires(std::is_arithmetic_v<A> && std::is_arithmetic_v<B> && !std::is_same_v<A, B>)
    static bool IsNearlyEqual(A InA, B InB, double ErrorTolerance = UE_DOUBLE_SMALL_NUMBER) {
        return Abs(static_cast<double>(InA) - static_cast<double>(InB)) <= ErrorTolerance;
    }
    static bool IsNearlyZero(float Value, float ErrorTolerance = UE_SMALL_NUMBER) {
        return Abs(Value) <= ErrorTolerance;
    }
    static bool IsNearlyZero(double Value, double ErrorTolerance = UE_DOUBLE_SMALL_NUMBER) {
        return Abs(Value) <= ErrorTolerance;
    }
    template <typename T>
    static constexpr bool IsPowerOfTwo(T Value) {
        return (Value & (Value - 1)) == T(0);
    }

    template <typename T>
    static constexpr T Square(const T A) {
        return A * A;
    }
    template <typename T>
    static constexpr T Cube(const T A) {
        return A * A * A;
    }
    template <typename T>
    static constexpr T Clamp(const T X, const T InMin, const T InMax) {
        return X < InMin ? InMin : (X < InMax ? X : InMax);
    }
    template <typename X, typename A, typename B>
        requires(std::is_arithmetic_v<X> && std::is_arithmetic_v<A> && std::is_arithmetic_v<B> &&
                 !(std::is_same_v<X, A> && std::is_same_v<A, B>))
    static constexpr auto Clamp(X Value, A InMin, B InMax) {
        using R = std::common_type_t<X, A, B>;
        return Clamp<R>(static_cast<R>(Value), static_cast<R>(InMin), static_cast<R>(InMax));
    }
    template <typename T>
    static constexpr T Wrap(const T X, const T InMin, const T InMax) {
        const T Size = InMax - InMin;
        if (Size == T(0)) {
            return InMax;
        }
        T Result = X;
        while (Result < InMin) {
            Result += Size;
        }
        while (Result > InMax) {
            Result -= Size;
        }
        return Result;
    }
    template <typename T>
    static constexpr T GridSnap(T Location, T Grid) {
        return Grid == T(0) ? Location : static_cast<T>(std::floor((Location + Grid / T(2)) / Grid) * Grid);
    }
    template <typename T>
    static constexpr T DivideAndRoundUp(T Dividend, T Divisor) {
        return (Dividend + Divisor - 1) / Divisor;
    }
    template <typename T>
    static constexpr T DivideAndRoundDown(T Dividend, T Divisor) {
        return Dividend / Divisor;
    }
    template <typename T>
    static constexpr T DivideAndRoundNearest(T Dividend, T Divisor) {
        return Dividend >= 0 ? (Dividend + Divisor / 2) / Divisor : (Dividend - Divisor / 2 + 1) / Divisor;
    }
    static float Log2(float Value) { return std::log2(Value); }
    static double Log2(double Value) { return std::log2(Value); }

    // ----- angles

    template <typename T>
        requires std::is_floating_point_v<T>
    static void SinCos(T* ScalarSin, T* ScalarCos, std::type_identity_t<T> Value) {
        *ScalarSin = std::sin(Value);
        *ScalarCos = std::cos(Value);
    }
    static float FastAsin(float Value) { return std::asin(Clamp(Value, -1.f, 1.f)); }
    template <typename T>
    static constexpr auto RadiansToDegrees(const T& RadVal) {
        if constexpr (std::is_same_v<T, float>) {
            return RadVal * (180.f / UE_PI);
        } else if constexpr (std::is_arithmetic_v<T>) {
            return static_cast<double>(RadVal) * (180.0 / UE_DOUBLE_PI);
        } else {
            return RadVal * (180.0 / UE_DOUBLE_PI);
        }
    }
    template <typename T>
    static constexpr auto DegreesToRadians(const T& DegVal) {
        if constexpr (std::is_same_v<T, float>) {
            return DegVal * (UE_PI / 180.f);
        } else if constexpr (std::is_arithmetic_v<T>) {
            return static_cast<double>(DegVal) * (UE_DOUBLE_PI / 180.0);
        } else {
            return DegVal * (UE_DOUBLE_PI / 180.0);
        }
    }
    /** The angle in [-180, 180]. */
    template <typename T>
        requires std::is_floating_point_v<T>
    static T UnwindDegrees(T A) {
        while (A > T(180)) {
            A -= T(360);
        }
        while (A < T(-180)) {
            A += T(360);
        }
        return A;
    }
    /** The angle in [-pi, pi]. */
    template <typename T>
        requires std::is_floating_point_v<T>
    static T UnwindRadians(T A) {
        while (A > T(UE_DOUBLE_PI)) {
            A -= T(UE_DOUBLE_TWO_PI);
        }
        while (A < T(-UE_DOUBLE_PI)) {
            A += T(UE_DOUBLE_TWO_PI);
        }
        return A;
    }
    /** The shortest turn from A1 to A2. */
    template <typename T, typename U>
    static auto FindDeltaAngleDegrees(T A1, U A2) {
        using R = std::conditional_t<std::is_same_v<T, float> && std::is_same_v<U, float>, float, double>;
        return UnwindDegrees(static_cast<R>(A2) - static_cast<R>(A1));
    }
    template <typename T, typename U>
    static auto FindDeltaAngleRadians(T A1, U A2) {
        using R = std::conditional_t<std::is_same_v<T, float> && std::is_same_v<U, float>, float, double>;
        return UnwindRadians(static_cast<R>(A2) - static_cast<R>(A1));
    }
    static CORE_API float ClampAngle(float AngleDegrees, float MinAngleDegrees, float MaxAngleDegrees);
    static CORE_API double ClampAngle(double AngleDegrees, double MinAngleDegrees, double MaxAngleDegrees);
    /** Moves one angle by whole turns next to the other. */
    template <typename T>
    static void WindRelativeAnglesDegrees(T InAngle0, T& InOutAngle1) {
        InOutAngle1 = InAngle0 + FindDeltaAngleDegrees(InAngle0, InOutAngle1);
    }
    static void CartesianToPolar(double X, double Y, double& OutRad, double& OutAng) {
        OutRad = Sqrt(X * X + Y * Y);
        OutAng = Atan2(Y, X);
    }
    static void PolarToCartesian(double Rad, double Ang, double& OutX, double& OutY) {
        OutX = Rad * Cos(Ang);
        OutY = Rad * Sin(Ang);
    }

    // ----- interpolation

    template <typename T, typename U>
        requires(!std::is_arithmetic_v<T>)
    static constexpr T Lerp(const T& A, const T& B, const U& Alpha) {
        return static_cast<T>(A + Alpha * (B - A));
    }
    template <typename T1, typename T2, typename U>
        requires(std::is_arithmetic_v<T1> && std::is_arithmetic_v<T2>)
    static constexpr auto Lerp(T1 A, T2 B, const U& Alpha) {
        using R = std::conditional_t<std::is_same_v<T1, T2>, T1, std::common_type_t<T1, T2>>;
        return static_cast<R>(static_cast<R>(A) + Alpha * (static_cast<R>(B) - static_cast<R>(A)));
    }
    template <typename T>
    static constexpr T LerpStable(const T& A, const T& B, double Alpha) {
        return static_cast<T>((A * (1.0 - Alpha)) + (B * Alpha));
    }
    template <typename T, typename U>
    static constexpr T BiLerp(const T& P00, const T& P10, const T& P01, const T& P11, const U& FracX, const U& FracY) {
        return Lerp(Lerp(P00, P10, FracX), Lerp(P01, P11, FracX), FracY);
    }
    template <typename T, typename U>
    static constexpr T CubicInterp(const T& P0, const T& T0, const T& P1, const T& T1, const U& A) {
        const U A2 = A * A;
        const U A3 = A2 * A;
        return static_cast<T>(
            P0 * (2 * A3 - 3 * A2 + 1) + T0 * (A3 - 2 * A2 + A) + T1 * (A3 - A2) + P1 * (-2 * A3 + 3 * A2));
    }
    template <typename T>
    static T InterpEaseIn(const T& A, const T& B, float Alpha, float Exp) {
        return Lerp(A, B, Pow(Alpha, Exp));
    }
    template <typename T>
    static T InterpEaseOut(const T& A, const T& B, float Alpha, float Exp) {
        return Lerp(A, B, 1.f - Pow(1.f - Alpha, Exp));
    }
    template <typename T>
    static T InterpEaseInOut(const T& A, const T& B, float Alpha, float Exp) {
        return Lerp(A, B,
            Alpha < 0.5f ? InterpEaseIn(0.f, 1.f, Alpha * 2.f, Exp) * 0.5f
                         : InterpEaseOut(0.f, 1.f, Alpha * 2.f - 1.f, Exp) * 0.5f + 0.5f);
    }
    template <typename T>
    static T InterpSinInOut(const T& A, const T& B, float Alpha) {
        return Lerp(A, B, (1.f - Cos(Alpha * UE_PI)) * 0.5f);
    }
    template <typename T>
    static constexpr T SmoothStep(T A, T B, T X) {
        if (X < A) {
            return T(0);
        }
        if (X >= B) {
            return T(1);
        }
        const T Fraction = (X - A) / (B - A);
        return Fraction * Fraction * (T(3) - T(2) * Fraction);
    }
    /** Where Value lies between A (0) and B (1). */
    template <typename T>
    static constexpr T GetRangePct(T MinValue, T MaxValue, T Value) {
        const T Divisor = MaxValue - MinValue;
        return IsNearlyZero(Divisor) ? (Value >= MaxValue ? T(1) : T(0)) : (Value - MinValue) / Divisor;
    }
    static CORE_API double GetRangePct(const FVector2D& Range, double Value);
    static CORE_API double GetRangeValue(const FVector2D& Range, double Pct);
    static CORE_API double GetMappedRangeValueClamped(
        const FVector2D& InputRange, const FVector2D& OutputRange, double Value);
    static CORE_API double GetMappedRangeValueUnclamped(
        const FVector2D& InputRange, const FVector2D& OutputRange, double Value);

    /** Towards the target by a fraction of the distance: fast first. Speed 0 or less jumps there. */
    template <typename T1, typename T2, typename T3, typename T4>
    static auto FInterpTo(T1 Current, T2 Target, T3 DeltaTime, T4 InterpSpeed) {
        using R = std::conditional_t<(std::is_same_v<T1, float> && std::is_same_v<T2, float>), float, double>;
        if (InterpSpeed <= T4(0)) {
            return static_cast<R>(Target);
        }
        const R Dist = static_cast<R>(Target) - static_cast<R>(Current);
        if (Dist * Dist < R(UE_SMALL_NUMBER)) {
            return static_cast<R>(Target);
        }
        return static_cast<R>(
            static_cast<R>(Current) + Dist * Clamp<R>(static_cast<R>(DeltaTime * InterpSpeed), R(0), R(1)));
    }
    /** Towards the target at constant speed. */
    template <typename T1, typename T2, typename T3, typename T4>
    static auto FInterpConstantTo(T1 Current, T2 Target, T3 DeltaTime, T4 InterpSpeed) {
        using R = std::conditional_t<(std::is_same_v<T1, float> && std::is_same_v<T2, float>), float, double>;
        const R Dist = static_cast<R>(Target) - static_cast<R>(Current);
        if (Dist * Dist < R(UE_SMALL_NUMBER)) {
            return static_cast<R>(Target);
        }
        const R Step = static_cast<R>(InterpSpeed * DeltaTime);
        return static_cast<R>(static_cast<R>(Current) + Clamp<R>(Dist, -Step, Step));
    }
    static CORE_API FVector VInterpTo(
        const FVector& Current, const FVector& Target, float DeltaTime, float InterpSpeed);
    static CORE_API FVector VInterpConstantTo(
        const FVector& Current, const FVector& Target, float DeltaTime, float InterpSpeed);
    static CORE_API FVector VInterpNormalRotationTo(
        const FVector& Current, const FVector& Target, float DeltaTime, float RotationSpeedDegrees);
    static CORE_API FVector2D Vector2DInterpTo(
        const FVector2D& Current, const FVector2D& Target, float DeltaTime, float InterpSpeed);
    static CORE_API FVector2D Vector2DInterpConstantTo(
        const FVector2D& Current, const FVector2D& Target, float DeltaTime, float InterpSpeed);
    static CORE_API FRotator RInterpTo(
        const FRotator& Current, const FRotator& Target, float DeltaTime, float InterpSpeed);
    static CORE_API FRotator RInterpConstantTo(
        const FRotator& Current, const FRotator& Target, float DeltaTime, float InterpSpeed);
    static CORE_API FQuat QInterpTo(const FQuat& Current, const FQuat& Target, float DeltaTime, float InterpSpeed);
    static CORE_API FQuat QInterpConstantTo(
        const FQuat& Current, const FQuat& Target, float DeltaTime, float InterpSpeed);
    static CORE_API FLinearColor CInterpTo(
        const FLinearColor& Current, const FLinearColor& Target, float DeltaTime, float InterpSpeed);

    // ----- geometry

    static CORE_API FVector LinePlaneIntersection(
        const FVector& Point1, const FVector& Point2, const FVector& PlaneOrigin, const FVector& PlaneNormal);
    static CORE_API FVector LinePlaneIntersection(const FVector& Point1, const FVector& Point2, const FPlane& Plane);
    static CORE_API FVector RayPlaneIntersection(
        const FVector& RayOrigin, const FVector& RayDirection, const FPlane& Plane);
    static CORE_API bool SegmentPlaneIntersection(
        const FVector& StartPoint, const FVector& EndPoint, const FPlane& Plane, FVector& OutIntersectionPoint);
    static CORE_API bool LineBoxIntersection(
        const FBox& Box, const FVector& Start, const FVector& End, const FVector& Direction);
    static CORE_API bool LineSphereIntersection(
        const FVector& Start, const FVector& Dir, double Length, const FVector& Origin, double Radius);
    static CORE_API bool SphereAABBIntersection(const FVector& SphereCenter, double RadiusSquared, const FBox& AABB);
    static CORE_API bool PointBoxIntersection(const FVector& Point, const FBox& Box);
    static CORE_API FVector ClosestPointOnLine(const FVector& LineStart, const FVector& LineEnd, const FVector& Point);
    static CORE_API FVector ClosestPointOnInfiniteLine(
        const FVector& LineStart, const FVector& LineEnd, const FVector& Point);
    static CORE_API FVector ClosestPointOnSegment(
        const FVector& Point, const FVector& StartPoint, const FVector& EndPoint);
    static CORE_API double PointDistToLine(const FVector& Point, const FVector& Direction, const FVector& Origin);
    static CORE_API double PointDistToSegment(const FVector& Point, const FVector& StartPoint, const FVector& EndPoint);
    static CORE_API double PointDistToSegmentSquared(
        const FVector& Point, const FVector& StartPoint, const FVector& EndPoint);
    static CORE_API void SegmentDistToSegment(
        FVector A1, FVector B1, FVector A2, FVector B2, FVector& OutP1, FVector& OutP2);
    static CORE_API FVector GetReflectionVector(const FVector& Direction, const FVector& SurfaceNormal);
    static CORE_API double GetTForSegmentPlaneIntersect(
        const FVector& StartPoint, const FVector& EndPoint, const FPlane& Plane);

    /** Smooth noise in [-1, 1]. */
    static CORE_API float PerlinNoise1D(float Value);
    static CORE_API float PerlinNoise2D(const FVector2D& Location);
    static CORE_API float PerlinNoise3D(const FVector& Location);
};
