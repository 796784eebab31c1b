// SPDX-License-Identifier: MIT
/** FLinearColor (linear floats) and FColor (8 bits a channel, sRGB, in the memory order B, G, R, A). */
#pragma once

#include "Math/Vector4.h"

struct FLinearColor {
    float R;
    float G;
    float B;
    float A;

    constexpr FLinearColor() : R(0), G(0), B(0), A(0) {}
    explicit constexpr FLinearColor(EForceInit) : FLinearColor() {}
    constexpr FLinearColor(float InR, float InG, float InB, float InA = 1.0f) : R(InR), G(InG), B(InB), A(InA) {}
    /** Undoes the sRGB encoding. */
    CORE_API FLinearColor(const FColor& Color);
    template <typename T>
    explicit constexpr FLinearColor(const UE::Math::TVector<T>& V)
        : R(float(V.X)), G(float(V.Y)), B(float(V.Z)), A(1) {}
    template <typename T>
    explicit constexpr FLinearColor(const UE::Math::TVector4<T>& V)
        : R(float(V.X)), G(float(V.Y)), B(float(V.Z)), A(float(V.W)) {}

    constexpr FLinearColor operator+(const FLinearColor& O) const {
        return FLinearColor(R + O.R, G + O.G, B + O.B, A + O.A);
    }
    constexpr FLinearColor operator-(const FLinearColor& O) const {
        return FLinearColor(R - O.R, G - O.G, B - O.B, A - O.A);
    }
    constexpr FLinearColor operator*(const FLinearColor& O) const {
        return FLinearColor(R * O.R, G * O.G, B * O.B, A * O.A);
    }
    constexpr FLinearColor operator*(float S) const { return FLinearColor(R * S, G * S, B * S, A * S); }
    constexpr FLinearColor operator/(float S) const { return *this * (1.0f / S); }
    friend constexpr FLinearColor operator*(float S, const FLinearColor& C) { return C * S; }
    FLinearColor& operator+=(const FLinearColor& O) { return *this = *this + O; }
    FLinearColor& operator-=(const FLinearColor& O) { return *this = *this - O; }
    FLinearColor& operator*=(const FLinearColor& O) { return *this = *this * O; }
    FLinearColor& operator*=(float S) { return *this = *this * S; }
    FLinearColor& operator/=(float S) { return *this = *this / S; }
    constexpr bool operator==(const FLinearColor& O) const { return R == O.R && G == O.G && B == O.B && A == O.A; }
    bool Equals(const FLinearColor& O, float Tolerance = UE_KINDA_SMALL_NUMBER) const {
        return FMath::Abs(R - O.R) <= Tolerance && FMath::Abs(G - O.G) <= Tolerance &&
               FMath::Abs(B - O.B) <= Tolerance && FMath::Abs(A - O.A) <= Tolerance;
    }
    FLinearColor GetClamped(float InMin = 0.0f, float InMax = 1.0f) const {
        return FLinearColor(FMath::Clamp(R, InMin, InMax), FMath::Clamp(G, InMin, InMax), FMath::Clamp(B, InMin, InMax),
            FMath::Clamp(A, InMin, InMax));
    }
    float& Component(int32 Index) {
        check(Index >= 0 && Index < 4);
        return Index == 0 ? R : (Index == 1 ? G : (Index == 2 ? B : A));
    }
    float Component(int32 Index) const { return const_cast<FLinearColor&>(*this).Component(Index); }
    FLinearColor CopyWithNewOpacity(float NewOpacity) const { return FLinearColor(R, G, B, NewOpacity); }

    /** The same as the constructor from FColor. */
    static FLinearColor FromSRGBColor(const FColor& Color) { return FLinearColor(Color); }
    static CORE_API FLinearColor FromPow22Color(const FColor& Color);
    /** Channels / 255, with no sRGB decoding. */
    static CORE_API FLinearColor FromReinterpretedFColor(const FColor& Color);
    /** Rounded to 8 bits, sRGB encoded if asked. */
    CORE_API FColor ToFColor(const bool bSRGB) const;
    FColor ToFColorSRGB() const;
    /** Channels * 255, with no sRGB encoding. */
    CORE_API FColor QuantizeRound() const;
    FColor Quantize() const;
    /** (hue in degrees, saturation, value, A) to RGB, and back. */
    CORE_API FLinearColor HSVToLinearRGB() const;
    CORE_API FLinearColor LinearRGBToHSV() const;
    static CORE_API FLinearColor MakeFromHSV8(uint8 H, uint8 S, uint8 V);
    static CORE_API FLinearColor LerpUsingHSV(const FLinearColor& From, const FLinearColor& To, const float Progress);
    static CORE_API FLinearColor MakeRandomColor();
    /** Colour of a black body of that temperature in kelvin. */
    static CORE_API FLinearColor MakeFromColorTemperature(float Temp);
    CORE_API FLinearColor Desaturate(float Desaturation) const;
    float GetMax() const { return FMath::Max(FMath::Max3(R, G, B), A); }
    float GetMin() const { return FMath::Min(FMath::Min3(R, G, B), A); }
    float GetLuminance() const { return R * 0.3f + G * 0.59f + B * 0.11f; }
    static float Dist(const FLinearColor& V1, const FLinearColor& V2) {
        const FLinearColor D = V1 - V2;
        return FMath::Sqrt(D.R * D.R + D.G * D.G + D.B * D.B + D.A * D.A);
    }
    bool IsAlmostBlack() const {
        return FMath::Square(R) < UE_DELTA && FMath::Square(G) < UE_DELTA && FMath::Square(B) < UE_DELTA;
    }
    FString ToString() const {
        return FString::Printf(TEXT("(R=%f,G=%f,B=%f,A=%f)"), static_cast<double>(R), static_cast<double>(G),
            static_cast<double>(B), static_cast<double>(A));
    }
    CORE_API bool InitFromString(const FString& InSourceString);
    friend uint32 GetTypeHash(const FLinearColor& C) {
        return HashCombine(
            HashCombine(GetTypeHash(C.R), GetTypeHash(C.G)), HashCombine(GetTypeHash(C.B), GetTypeHash(C.A)));
    }

    static CORE_API const FLinearColor White;
    static CORE_API const FLinearColor Gray;
    static CORE_API const FLinearColor Black;
    static CORE_API const FLinearColor Transparent;
    static CORE_API const FLinearColor Red;
    static CORE_API const FLinearColor Green;
    static CORE_API const FLinearColor Blue;
    static CORE_API const FLinearColor Yellow;
};

struct alignas(4) FColor {
    uint8 B;
    uint8 G;
    uint8 R;
    uint8 A;

    constexpr FColor() : B(0), G(0), R(0), A(0) {}
    explicit constexpr FColor(EForceInit) : FColor() {}
    constexpr FColor(uint8 InR, uint8 InG, uint8 InB, uint8 InA = 255) : B(InB), G(InG), R(InR), A(InA) {}
    /** 0xAARRGGBB. */
    explicit constexpr FColor(uint32 InColor)
        : B(uint8(InColor)), G(uint8(InColor >> 8)), R(uint8(InColor >> 16)), A(uint8(InColor >> 24)) {}

    uint32& DWColor() { return *reinterpret_cast<uint32*>(this); }
    const uint32& DWColor() const { return *reinterpret_cast<const uint32*>(this); }
    constexpr bool operator==(const FColor& C) const { return R == C.R && G == C.G && B == C.B && A == C.A; }
    /** "RRGGBB", "RRGGBBAA", with or without '#'. */
    static CORE_API FColor FromHex(const FString& HexString);
    CORE_API FString ToHex() const;
    static FColor MakeRandomColor() { return FLinearColor::MakeRandomColor().ToFColor(true); }
    static FColor MakeFromColorTemperature(float Temp) {
        return FLinearColor::MakeFromColorTemperature(Temp).ToFColor(true);
    }
    FLinearColor ReinterpretAsLinear() const { return FLinearColor::FromReinterpretedFColor(*this); }
    FColor WithAlpha(uint8 Alpha) const { return FColor(R, G, B, Alpha); }
    constexpr uint32 ToPackedARGB() const {
        return (uint32(A) << 24) | (uint32(R) << 16) | (uint32(G) << 8) | uint32(B);
    }
    constexpr uint32 ToPackedRGBA() const {
        return (uint32(R) << 24) | (uint32(G) << 16) | (uint32(B) << 8) | uint32(A);
    }
    constexpr uint32 ToPackedBGRA() const {
        return (uint32(B) << 24) | (uint32(G) << 16) | (uint32(R) << 8) | uint32(A);
    }
    constexpr uint32 ToPackedABGR() const {
        return (uint32(A) << 24) | (uint32(B) << 16) | (uint32(G) << 8) | uint32(R);
    }
    FString ToString() const {
        return FString::Printf(TEXT("(R=%d,G=%d,B=%d,A=%d)"), int32(R), int32(G), int32(B), int32(A));
    }
    CORE_API bool InitFromString(const FString& InSourceString);
    friend uint32 GetTypeHash(const FColor& C) { return C.ToPackedARGB(); }

    static CORE_API const FColor White;
    static CORE_API const FColor Black;
    static CORE_API const FColor Transparent;
    static CORE_API const FColor Red;
    static CORE_API const FColor Green;
    static CORE_API const FColor Blue;
    static CORE_API const FColor Yellow;
    static CORE_API const FColor Cyan;
    static CORE_API const FColor Magenta;
    static CORE_API const FColor Orange;
    static CORE_API const FColor Purple;
    static CORE_API const FColor Turquoise;
    static CORE_API const FColor Silver;
    static CORE_API const FColor Emerald;
};
inline FColor FLinearColor::ToFColorSRGB() const { return ToFColor(true); }
inline FColor FLinearColor::Quantize() const { return QuantizeRound(); }

namespace UE::Math {
template <typename T>
constexpr TVector<T>::TVector(const FLinearColor& C) : X(T(C.R)), Y(T(C.G)), Z(T(C.B)) {}
template <typename T>
constexpr TVector4<T>::TVector4(const FLinearColor& C) : X(T(C.R)), Y(T(C.G)), Z(T(C.B)), W(T(C.A)) {}
} // namespace UE::Math
