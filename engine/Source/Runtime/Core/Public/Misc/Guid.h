// SPDX-License-Identifier: MIT
/** FGuid. */
#pragma once

#include "Containers/UnrealString.h"

enum class EGuidFormats {
    Digits,
    DigitsLower,
    DigitsWithHyphens,
    DigitsWithHyphensLower,
    DigitsWithHyphensInBraces,
    DigitsWithHyphensInParentheses,
    HexValuesInBraces,
    UniqueObjectGuid,
};

struct FGuid {
    uint32 A;
    uint32 B;
    uint32 C;
    uint32 D;

    constexpr FGuid() : A(0), B(0), C(0), D(0) {}
    constexpr FGuid(uint32 InA, uint32 InB, uint32 InC, uint32 InD) : A(InA), B(InB), C(InC), D(InD) {}
    explicit FGuid(const FString& InGuidStr) : FGuid() { Parse(InGuidStr, *this); }

    constexpr bool operator==(const FGuid& O) const { return A == O.A && B == O.B && C == O.C && D == O.D; }
    constexpr bool operator<(const FGuid& O) const {
        return A != O.A ? A < O.A : (B != O.B ? B < O.B : (C != O.C ? C < O.C : D < O.D));
    }
    uint32& operator[](int32 Index) {
        check(Index >= 0 && Index < 4);
        return Index == 0 ? A : (Index == 1 ? B : (Index == 2 ? C : D));
    }
    void Invalidate() { *this = FGuid(); }
    constexpr bool IsValid() const { return (A | B | C | D) != 0; }
    FString ToString() const { return ToString(EGuidFormats::Digits); }
    CORE_API FString ToString(EGuidFormats Format) const;
    /** Random, version 4. */
    static CORE_API FGuid NewGuid();
    /** The same GUID for the same path. */
    static CORE_API FGuid NewDeterministicGuid(FStringView ObjectPath, uint64 Seed = 0);
    /** Text form for reflection: 32 hexadecimal digits. */
    bool ExportTextItem(FString& ValueStr, const FGuid& DefaultValue, class UObject* Parent, int32 PortFlags,
        class UObject* ExportRootScope) const {
        ValueStr += ToString();
        return true;
    }
    /** Reads 32 hexadecimal digits and moves Buffer behind them; false for anything else. */
    bool ImportTextItem(const TCHAR*& Buffer, int32 PortFlags, class UObject* Parent, class FOutputDevice* ErrorText) {
        const bool bQuoted = *Buffer == TCHAR('"');
        const TCHAR* Digits = Buffer + (bQuoted ? 1 : 0);
        FString Text;
        while (Text.Len() < 32 && FChar::IsHexDigit(*Digits)) {
            Text.AppendChar(*Digits++);
        }
        if (Text.Len() != 32 || !Parse(Text, *this)) {
            return false;
        }
        Buffer = Digits + (bQuoted && *Digits == TCHAR('"') ? 1 : 0);
        return true;
    }
    /** Any of the formats. */
    static CORE_API bool Parse(const FString& GuidString, FGuid& OutGuid);
    static CORE_API bool ParseExact(const FString& GuidString, EGuidFormats Format, FGuid& OutGuid);
    friend uint32 GetTypeHash(const FGuid& Guid) { return FCrc::MemCrc32(&Guid, sizeof(Guid)); }
};
inline FString LexToString(const FGuid& Value) { return Value.ToString(); }
inline void LexFromString(FGuid& Result, const TCHAR* String) { FGuid::Parse(String, Result); }
