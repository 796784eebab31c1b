// SPDX-License-Identifier: MIT
/** The part of FMath that a platform could do in its own way: rounding, roots, trigonometry, bits. */
#pragma once

#include <cmath>

#include "CoreTypes.h"
#include "Templates/UnrealTypeTraits.h"

struct FGenericPlatformMath {
    /** Towards zero. */
    static constexpr int32 TruncToInt32(float F) { return static_cast<int32>(F); }
    static constexpr int32 TruncToInt32(double F) { return static_cast<int32>(F); }
    static constexpr int32 TruncToInt(float F) { return static_cast<int32>(F); }
    static constexpr int64 TruncToInt(double F) { return static_cast<int64>(F); }
    static constexpr int64 TruncToInt64(double F) { return static_cast<int64>(F); }
    static float TruncToFloat(float F) { return std::trunc(F); }
    static double TruncToDouble(double F) { return std::trunc(F); }
    static int32 FloorToInt32(float F) { return static_cast<int32>(std::floor(F)); }
    static int32 FloorToInt32(double F) { return static_cast<int32>(std::floor(F)); }
    static int32 FloorToInt(float F) { return static_cast<int32>(std::floor(F)); }
    static int64 FloorToInt(double F) { return static_cast<int64>(std::floor(F)); }
    static int64 FloorToInt64(double F) { return static_cast<int64>(std::floor(F)); }
    static float FloorToFloat(float F) { return std::floor(F); }
    static double FloorToDouble(double F) { return std::floor(F); }
    static int32 CeilToInt32(float F) { return static_cast<int32>(std::ceil(F)); }
    static int32 CeilToInt32(double F) { return static_cast<int32>(std::ceil(F)); }
    static int32 CeilToInt(float F) { return static_cast<int32>(std::ceil(F)); }
    static int64 CeilToInt(double F) { return static_cast<int64>(std::ceil(F)); }
    static int64 CeilToInt64(double F) { return static_cast<int64>(std::ceil(F)); }
    static float CeilToFloat(float F) { return std::ceil(F); }
    static double CeilToDouble(double F) { return std::ceil(F); }
    /** To nearest, halves up. */
    static int32 RoundToInt32(float F) { return FloorToInt32(F + 0.5f); }
    static int32 RoundToInt32(double F) { return FloorToInt32(F + 0.5); }
    static int32 RoundToInt(float F) { return FloorToInt32(F + 0.5f); }
    static int64 RoundToInt(double F) { return FloorToInt64(F + 0.5); }
    static int64 RoundToInt64(double F) { return FloorToInt64(F + 0.5); }
    static float RoundToFloat(float F) { return std::floor(F + 0.5f); }
    static double RoundToDouble(double F) { return std::floor(F + 0.5); }
    static double RoundHalfToEven(double F) { return std::nearbyint(F); }
    /** With the sign of the number. */
    static float Fractional(float Value) { return Value - std::trunc(Value); }
    static double Fractional(double Value) { return Value - std::trunc(Value); }
    /** In [0, 1). */
    static float Frac(float Value) { return Value - std::floor(Value); }
    static double Frac(double Value) { return Value - std::floor(Value); }
    static float Modf(float Value, float* OutIntPart) { return std::modf(Value, OutIntPart); }
    static double Modf(double Value, double* OutIntPart) { return std::modf(Value, OutIntPart); }
    static float Fmod(float X, float Y) { return std::fmod(X, Y); }
    static double Fmod(double X, double Y) { return std::fmod(X, Y); }
    static float Exp(float Value) { return std::exp(Value); }
    static double Exp(double Value) { return std::exp(Value); }
    static float Exp2(float Value) { return std::exp2(Value); }
    static double Exp2(double Value) { return std::exp2(Value); }
    static float Loge(float Value) { return std::log(Value); }
    static double Loge(double Value) { return std::log(Value); }
    static float LogX(float Base, float Value) { return std::log(Value) / std::log(Base); }
    static double LogX(double Base, double Value) { return std::log(Value) / std::log(Base); }

#define UE_MATH_UNARY(Name, Function)                                                                                  \
    static float Name(float Value) { return Function(Value); }                                                         \
    static double Name(double Value) { return Function(Value); }
    UE_MATH_UNARY(Sin, std::sin)
    UE_MATH_UNARY(Cos, std::cos)
    UE_MATH_UNARY(Tan, std::tan)
    UE_MATH_UNARY(Sinh, std::sinh)
    UE_MATH_UNARY(Cosh, std::cosh)
    UE_MATH_UNARY(Tanh, std::tanh)
    UE_MATH_UNARY(Atan, std::atan)
    UE_MATH_UNARY(Sqrt, std::sqrt)
#undef UE_MATH_UNARY
    // The argument is clamped to [-1, 1], so rounding never makes a NaN.
    static float Asin(float Value) { return std::asin(Value < -1.f ? -1.f : (Value < 1.f ? Value : 1.f)); }
    static double Asin(double Value) { return std::asin(Value < -1. ? -1. : (Value < 1. ? Value : 1.)); }
    static float Acos(float Value) { return std::acos(Value < -1.f ? -1.f : (Value < 1.f ? Value : 1.f)); }
    static double Acos(double Value) { return std::acos(Value < -1. ? -1. : (Value < 1. ? Value : 1.)); }
    static float Atan2(float Y, float X) { return std::atan2(Y, X); }
    static double Atan2(double Y, double X) { return std::atan2(Y, X); }
    template <typename A, typename B>
        requires(std::is_arithmetic_v<A> && std::is_arithmetic_v<B> && !std::is_same_v<A, B>)
    static double Atan2(A Y, B X) {
        return std::atan2(static_cast<double>(Y), static_cast<double>(X));
    }
    static float Pow(float A, float B) { return std::pow(A, B); }
    static double Pow(double A, double B) { return std::pow(A, B); }
    template <typename A, typename B>
        requires(std::is_arithmetic_v<A> && std::is_arithmetic_v<B> && !std::is_same_v<A, B>)
    static double Pow(A InA, B InB) {
        return std::pow(static_cast<double>(InA), static_cast<double>(InB));
    }
    static float InvSqrt(float F) { return 1.0f / std::sqrt(F); }
    static double InvSqrt(double F) { return 1.0 / std::sqrt(F); }
    static float InvSqrtEst(float F) { return InvSqrt(F); }
    static bool IsNaN(float A) { return std::isnan(A); }
    static bool IsNaN(double A) { return std::isnan(A); }
    static bool IsFinite(float A) { return std::isfinite(A); }
    static bool IsFinite(double A) { return std::isfinite(A); }
    static bool IsNegative(float A) { return std::signbit(A); }
    static bool IsNegative(double A) { return std::signbit(A); }

    template <typename T>
    static constexpr T Abs(const T A) {
        return A < T(0) ? static_cast<T>(-A) : (A == T(0) ? T(0) : A);
    }
    template <typename T>
    static constexpr T Sign(const T A) {
        return A > T(0) ? T(1) : (A < T(0) ? T(-1) : T(0));
    }
    template <typename T>
    static constexpr T Max(const T A, const T B) {
        return B < A ? A : B;
    }
    template <typename T>
    static constexpr T Min(const T A, const T B) {
        return A < B ? A : B;
    }
    template <typename A, typename B>
        requires(std::is_arithmetic_v<A> && std::is_arithmetic_v<B> && !std::is_same_v<A, B>)
    static constexpr auto Max(A InA, B InB) {
        using R = std::common_type_t<A, B>;
        return Max<R>(static_cast<R>(InA), static_cast<R>(InB));
    }
    template <typename A, typename B>
        requires(std::is_arithmetic_v<A> && std::is_arithmetic_v<B> && !std::is_same_v<A, B>)
    static constexpr auto Min(A InA, B InB) {
        using R = std::common_type_t<A, B>;
        return Min<R>(static_cast<R>(InA), static_cast<R>(InB));
    }
    template <typename T>
    static constexpr T Max3(const T A, const T B, const T C) {
        return Max(Max(A, B), C);
    }
    template <typename T>
    static constexpr T Min3(const T A, const T B, const T C) {
        return Min(Min(A, B), C);
    }

    static uint32 FloorLog2(uint32 Value) { return Value ? 31u - static_cast<uint32>(__builtin_clz(Value)) : 0; }
    static uint64 FloorLog2_64(uint64 Value) { return Value ? 63u - static_cast<uint64>(__builtin_clzll(Value)) : 0; }
    static uint32 CountLeadingZeros(uint32 Value) { return Value ? static_cast<uint32>(__builtin_clz(Value)) : 32; }
    static uint32 CountTrailingZeros(uint32 Value) { return Value ? static_cast<uint32>(__builtin_ctz(Value)) : 32; }
    static int32 CountBits(uint64 Bits) { return __builtin_popcountll(Bits); }
    static uint32 CeilLogTwo(uint32 Arg) { return Arg <= 1 ? 0 : FloorLog2(Arg - 1) + 1; }
    static uint32 RoundUpToPowerOfTwo(uint32 Arg) { return Arg <= 1 ? 1 : 1u << CeilLogTwo(Arg); }

    /** Integer in [0, RAND_MAX]. */
    static CORE_API int32 Rand();
    static CORE_API int32 Rand32();
    static CORE_API void RandInit(int32 Seed);
    /** In [0, 1). */
    static CORE_API float FRand();
    static CORE_API void SRandInit(int32 Seed);
    static CORE_API int32 GetRandSeed();
    /** In [0, 1), from its own sequence. */
    static CORE_API float SRand();

    /** ValueGEZero if the comparand is 0 or more, else the other. */
    static constexpr double FloatSelect(double Comparand, double ValueGEZero, double ValueLTZero) {
        return Comparand >= 0. ? ValueGEZero : ValueLTZero;
    }
    static constexpr float FloatSelect(float Comparand, float ValueGEZero, float ValueLTZero) {
        return Comparand >= 0.f ? ValueGEZero : ValueLTZero;
    }
};
typedef FGenericPlatformMath FPlatformMath;
