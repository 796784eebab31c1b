// SPDX-License-Identifier: MIT
// FLinearColor and FColor. Mirrors Epic's API pages of these names.
#include "CoreMinimal.h"
#include "Misc/Parse.h"

namespace {

double DecodeSRGB(double Encoded) {
    return Encoded <= 0.04045 ? Encoded / 12.92 : FMath::Pow((Encoded + 0.055) / 1.055, 2.4);
}
double EncodeSRGB(double Linear) {
    return Linear <= 0.0031308 ? Linear * 12.92 : 1.055 * FMath::Pow(Linear, 1.0 / 2.4) - 0.055;
}
uint8 ToByte(double Share) {
    return static_cast<uint8>(FMath::FloorToInt32(FMath::Clamp(Share, 0.0, 1.0) * 255.0 + 0.5));
}

/** The decoded value of each byte. */
struct FDecodeTable {
    float Values[256];
    FDecodeTable() {
        for (int32 Index = 0; Index < 256; ++Index) {
            Values[Index] = static_cast<float>(DecodeSRGB(Index / 255.0));
        }
    }
};
float DecodeByte(uint8 Encoded) {
    static const FDecodeTable Table;
    return Table.Values[Encoded];
}

} // namespace

const FLinearColor FLinearColor::White(1.0f, 1.0f, 1.0f);
const FLinearColor FLinearColor::Gray(0.5f, 0.5f, 0.5f);
const FLinearColor FLinearColor::Black(0.0f, 0.0f, 0.0f);
const FLinearColor FLinearColor::Transparent(0.0f, 0.0f, 0.0f, 0.0f);
const FLinearColor FLinearColor::Red(1.0f, 0.0f, 0.0f);
const FLinearColor FLinearColor::Green(0.0f, 1.0f, 0.0f);
const FLinearColor FLinearColor::Blue(0.0f, 0.0f, 1.0f);
const FLinearColor FLinearColor::Yellow(1.0f, 1.0f, 0.0f);

const FColor FColor::White(255, 255, 255);
const FColor FColor::Black(0, 0, 0);
const FColor FColor::Transparent(0, 0, 0, 0);
const FColor FColor::Red(255, 0, 0);
const FColor FColor::Green(0, 255, 0);
const FColor FColor::Blue(0, 0, 255);
const FColor FColor::Yellow(255, 255, 0);
const FColor FColor::Cyan(0, 255, 255);
const FColor FColor::Magenta(255, 0, 255);
const FColor FColor::Orange(243, 156, 18);
const FColor FColor::Purple(169, 7, 228);
const FColor FColor::Turquoise(26, 188, 156);
const FColor FColor::Silver(189, 195, 199);
const FColor FColor::Emerald(46, 204, 113);

FLinearColor::FLinearColor(const FColor& Color)
    : R(DecodeByte(Color.R)), G(DecodeByte(Color.G)), B(DecodeByte(Color.B)), A(static_cast<float>(Color.A) / 255.0f) {}

FLinearColor FLinearColor::FromPow22Color(const FColor& Color) {
    const auto Decode = [](uint8 Value) { return static_cast<float>(FMath::Pow(Value / 255.0, 2.2)); };
    return FLinearColor(Decode(Color.R), Decode(Color.G), Decode(Color.B), static_cast<float>(Color.A) / 255.0f);
}
FLinearColor FLinearColor::FromReinterpretedFColor(const FColor& Color) {
    return FLinearColor(static_cast<float>(Color.R) / 255.0f, static_cast<float>(Color.G) / 255.0f,
        static_cast<float>(Color.B) / 255.0f, static_cast<float>(Color.A) / 255.0f);
}
FColor FLinearColor::ToFColor(const bool bSRGB) const {
    const auto Encode = [bSRGB](float Value) {
        const double Clamped = FMath::Clamp(static_cast<double>(Value), 0.0, 1.0);
        return ToByte(bSRGB ? EncodeSRGB(Clamped) : Clamped);
    };
    return FColor(Encode(R), Encode(G), Encode(B), ToByte(static_cast<double>(A)));
}
FColor FLinearColor::QuantizeRound() const {
    return FColor(ToByte(static_cast<double>(R)), ToByte(static_cast<double>(G)), ToByte(static_cast<double>(B)),
        ToByte(static_cast<double>(A)));
}

FLinearColor FLinearColor::HSVToLinearRGB() const {
    // R is the hue in degrees, G the saturation, B the value.
    const float Sector = FMath::Fmod(FMath::Fmod(R, 360.0f) + 360.0f, 360.0f) / 60.0f;
    const float Share = Sector - FMath::FloorToFloat(Sector);
    const float V = B, P = B * (1.0f - G), Q = B * (1.0f - Share * G), T = B * (1.0f - (1.0f - Share) * G);
    switch (FMath::FloorToInt32(Sector)) {
    case 0:
        return FLinearColor(V, T, P, A);
    case 1:
        return FLinearColor(Q, V, P, A);
    case 2:
        return FLinearColor(P, V, T, A);
    case 3:
        return FLinearColor(P, Q, V, A);
    case 4:
        return FLinearColor(T, P, V, A);
    default:
        return FLinearColor(V, P, Q, A);
    }
}

FLinearColor FLinearColor::LinearRGBToHSV() const {
    const float Largest = FMath::Max3(R, G, B), Smallest = FMath::Min3(R, G, B), Range = Largest - Smallest;
    float Hue = 0.0f;
    if (Range != 0.0f) {
        if (Largest == R) {
            Hue = FMath::Fmod((G - B) / Range * 60.0f + 360.0f, 360.0f);
        } else if (Largest == G) {
            Hue = (B - R) / Range * 60.0f + 120.0f;
        } else {
            Hue = (R - G) / Range * 60.0f + 240.0f;
        }
    }
    return FLinearColor(Hue, Largest == 0.0f ? 0.0f : Range / Largest, Largest, A);
}

FLinearColor FLinearColor::MakeFromHSV8(uint8 H, uint8 S, uint8 V) {
    return FLinearColor(
        static_cast<float>(H) * (360.0f / 255.0f), static_cast<float>(S) / 255.0f, static_cast<float>(V) / 255.0f)
        .HSVToLinearRGB();
}

FLinearColor FLinearColor::LerpUsingHSV(const FLinearColor& From, const FLinearColor& To, const float Progress) {
    const FLinearColor FromHSV = From.LinearRGBToHSV(), ToHSV = To.LinearRGBToHSV();
    // The shorter way around the circle of hues.
    float HueWay = ToHSV.R - FromHSV.R;
    HueWay += HueWay > 180.0f ? -360.0f : HueWay < -180.0f ? 360.0f : 0.0f;
    const float Hue = FMath::Fmod(FromHSV.R + HueWay * Progress + 360.0f, 360.0f);
    return FLinearColor(Hue, FMath::Lerp(FromHSV.G, ToHSV.G, Progress), FMath::Lerp(FromHSV.B, ToHSV.B, Progress),
        FMath::Lerp(From.A, To.A, Progress))
        .HSVToLinearRGB();
}

FLinearColor FLinearColor::MakeRandomColor() {
    return MakeFromHSV8(static_cast<uint8>(FMath::RandHelper(256)), 255, 255);
}

FLinearColor FLinearColor::MakeFromColorTemperature(float Temp) {
    // The Planckian locus in CIE 1960 (Krystek's approximation), then to linear sRGB.
    const double T = FMath::Clamp(static_cast<double>(Temp), 1000.0, 15000.0);
    const double U =
        (0.860117757 + 1.54118254e-4 * T + 1.28641212e-7 * T * T) / (1.0 + 8.42420235e-4 * T + 7.08145163e-7 * T * T);
    const double V =
        (0.317398726 + 4.22806245e-5 * T + 4.20481691e-8 * T * T) / (1.0 - 2.89741816e-5 * T + 1.61456053e-7 * T * T);
    const double X = 3.0 * U / (2.0 * U - 8.0 * V + 4.0), Y = 2.0 * V / (2.0 * U - 8.0 * V + 4.0), Z = 1.0 - X - Y;
    const double XX = X / Y, ZZ = Z / Y;
    return FLinearColor(static_cast<float>(3.2404542 * XX - 1.5371385 - 0.4985314 * ZZ),
        static_cast<float>(-0.9692660 * XX + 1.8760108 + 0.0415560 * ZZ),
        static_cast<float>(0.0556434 * XX - 0.2040259 + 1.0572252 * ZZ));
}

FLinearColor FLinearColor::Desaturate(float Desaturation) const {
    const float Luminance = GetLuminance();
    return FLinearColor(FMath::Lerp(R, Luminance, Desaturation), FMath::Lerp(G, Luminance, Desaturation),
        FMath::Lerp(B, Luminance, Desaturation), A);
}

bool FLinearColor::InitFromString(const FString& InSourceString) {
    FLinearColor Read(0.0f, 0.0f, 0.0f, 1.0f);
    if (!FParse::Value(*InSourceString, TEXT("R="), Read.R) || !FParse::Value(*InSourceString, TEXT("G="), Read.G) ||
        !FParse::Value(*InSourceString, TEXT("B="), Read.B)) {
        return false;
    }
    FParse::Value(*InSourceString, TEXT("A="), Read.A);
    *this = Read;
    return true;
}

bool FColor::InitFromString(const FString& InSourceString) {
    FColor Read(0, 0, 0, 255);
    if (!FParse::Value(*InSourceString, TEXT("R="), Read.R) || !FParse::Value(*InSourceString, TEXT("G="), Read.G) ||
        !FParse::Value(*InSourceString, TEXT("B="), Read.B)) {
        return false;
    }
    FParse::Value(*InSourceString, TEXT("A="), Read.A);
    *this = Read;
    return true;
}

FColor FColor::FromHex(const FString& HexString) {
    const FString Digits = HexString.StartsWith(TEXT("#")) ? HexString.RightChop(1) : HexString;
    const uint32 Number = FParse::HexNumber(*Digits);
    switch (Digits.Len()) {
    case 3: {
        const auto Twice = [](uint32 Digit) { return static_cast<uint8>((Digit & 15u) * 17u); };
        return FColor(Twice(Number >> 8), Twice(Number >> 4), Twice(Number));
    }
    case 6:
        return FColor(static_cast<uint8>(Number >> 16), static_cast<uint8>(Number >> 8), static_cast<uint8>(Number));
    case 8:
        return FColor(static_cast<uint8>(Number >> 24), static_cast<uint8>(Number >> 16),
            static_cast<uint8>(Number >> 8), static_cast<uint8>(Number));
    default:
        return FColor(0, 0, 0, 0);
    }
}

FString FColor::ToHex() const {
    return FString::Printf(TEXT("%02X%02X%02X%02X"), int32(R), int32(G), int32(B), int32(A));
}
