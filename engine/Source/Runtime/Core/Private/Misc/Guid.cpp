// SPDX-License-Identifier: MIT
#include "Misc/Guid.h"

#include <sys/random.h>

#include "CoreMinimal.h"

namespace {

/** Where hyphens stand: after 8, 12, 16, 20 digits. */
FString WithHyphens(const FString& Digits) {
    return Digits.Mid(0, 8) + TEXT("-") + Digits.Mid(8, 4) + TEXT("-") + Digits.Mid(12, 4) + TEXT("-") +
           Digits.Mid(16, 4) + TEXT("-") + Digits.Mid(20, 12);
}

bool FromDigits(const FString& Digits, FGuid& OutGuid) {
    if (Digits.Len() != 32) {
        return false;
    }
    FGuid Read;
    for (int32 Index = 0; Index < 32; ++Index) {
        if (!FChar::IsHexDigit(Digits[Index])) {
            return false;
        }
        uint32& Part = Read[Index / 8];
        Part = (Part << 4) | static_cast<uint32>(FChar::HexValue(Digits[Index]));
    }
    OutGuid = Read;
    return true;
}

} // namespace

FString FGuid::ToString(EGuidFormats Format) const {
    const FString Digits = FString::Printf(TEXT("%08X%08X%08X%08X"), A, B, C, D);
    switch (Format) {
    case EGuidFormats::DigitsLower:
        return Digits.ToLower();
    case EGuidFormats::DigitsWithHyphens:
        return WithHyphens(Digits);
    case EGuidFormats::DigitsWithHyphensLower:
        return WithHyphens(Digits).ToLower();
    case EGuidFormats::DigitsWithHyphensInBraces:
        return TEXT("{") + WithHyphens(Digits) + TEXT("}");
    case EGuidFormats::DigitsWithHyphensInParentheses:
        return TEXT("(") + WithHyphens(Digits) + TEXT(")");
    case EGuidFormats::HexValuesInBraces:
        return FString::Printf(TEXT("{0x%08X,0x%04X,0x%04X,{0x%02X,0x%02X,0x%02X,0x%02X,0x%02X,0x%02X,0x%02X,0x%02X}}"),
            A, B >> 16, B & 0xFFFF, C >> 24, (C >> 16) & 0xFF, (C >> 8) & 0xFF, C & 0xFF, D >> 24, (D >> 16) & 0xFF,
            (D >> 8) & 0xFF, D & 0xFF);
    case EGuidFormats::UniqueObjectGuid:
        return FString::Printf(TEXT("%08X-%08X-%08X-%08X"), A, B, C, D);
    default:
        return Digits;
    }
}

FGuid FGuid::NewGuid() {
    uint32 Parts[4] = {};
    if (getrandom(Parts, sizeof(Parts), 0) != static_cast<ssize_t>(sizeof(Parts))) {
        const uint64 Time = static_cast<uint64>(FDateTime::UtcNow().GetTicks());
        Parts[0] ^= static_cast<uint32>(Time);
        Parts[1] ^= static_cast<uint32>(Time >> 32);
    }
    Parts[1] = (Parts[1] & 0xFFFF0FFFu) | 0x00004000u; // version 4
    Parts[2] = (Parts[2] & 0x3FFFFFFFu) | 0x80000000u; // variant 1
    return FGuid(Parts[0], Parts[1], Parts[2], Parts[3]);
}

FGuid FGuid::NewDeterministicGuid(FStringView ObjectPath, uint64 Seed) {
    const int32 Bytes = ObjectPath.Len() * static_cast<int32>(sizeof(TCHAR));
    uint32 Parts[4];
    for (uint32 Index = 0; Index < 4; ++Index) {
        Parts[Index] = FCrc::MemCrc32(ObjectPath.GetData(), Bytes,
            static_cast<uint32>(Seed) ^ static_cast<uint32>(Seed >> 32) ^ (Index * 0x9E3779B9u));
    }
    return FGuid(Parts[0], (Parts[1] & 0xFFFF0FFFu) | 0x00005000u, (Parts[2] & 0x3FFFFFFFu) | 0x80000000u, Parts[3]);
}

bool FGuid::Parse(const FString& GuidString, FGuid& OutGuid) {
    if (GuidString.Contains(TEXT("x"))) {
        return ParseExact(GuidString, EGuidFormats::HexValuesInBraces, OutGuid);
    }
    FString Digits;
    for (const TCHAR Char : GuidString) {
        if (Char && !FCString::Strchr(TEXT("-{}()"), Char)) {
            Digits.AppendChar(Char);
        }
    }
    return FromDigits(Digits, OutGuid);
}

bool FGuid::ParseExact(const FString& GuidString, EGuidFormats Format, FGuid& OutGuid) {
    FString Digits;
    if (Format == EGuidFormats::HexValuesInBraces) {
        for (int32 Index = 0; Index < GuidString.Len(); ++Index) {
            if (GuidString[Index] == TEXT('0') && Index + 1 < GuidString.Len() &&
                FChar::ToLower(GuidString[Index + 1]) == TEXT('x')) {
                ++Index;
            } else if (FChar::IsHexDigit(GuidString[Index])) {
                Digits.AppendChar(GuidString[Index]);
            }
        }
    } else {
        Digits = GuidString;
        Digits.ReplaceInline(TEXT("-"), TEXT(""));
        for (const TCHAR* Mark : {TEXT("{"), TEXT("}"), TEXT("("), TEXT(")")}) {
            Digits.ReplaceInline(Mark, TEXT(""));
        }
    }
    FGuid Read;
    if (!FromDigits(Digits, Read) || !Read.ToString(Format).Equals(GuidString, ESearchCase::IgnoreCase)) {
        return false;
    }
    OutGuid = Read;
    return true;
}
