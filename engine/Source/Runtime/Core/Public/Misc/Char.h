// SPDX-License-Identifier: MIT
/** FChar: character classes and case. Case pairs are known for ASCII, Latin-1, Greek and Cyrillic. */
#pragma once

#include <type_traits>

#include "CoreTypes.h"

template <typename CharType>
struct TChar {
    static constexpr uint32 ToUnsigned(CharType Char) {
        return sizeof(CharType) == 1 ? static_cast<uint8>(Char) : static_cast<uint32>(Char);
    }
    static CharType ToUpper(CharType Char) {
        const uint32 C = ToUnsigned(Char);
        if (C < 0x80) {
            return static_cast<CharType>(C >= 'a' && C <= 'z' ? C - 32 : C);
        }
        if constexpr (sizeof(CharType) > 1) {
            if ((C >= 0xE0 && C <= 0xFE && C != 0xF7) || (C >= 0x3B1 && C <= 0x3C9 && C != 0x3C2) ||
                (C >= 0x430 && C <= 0x44F)) {
                return static_cast<CharType>(C - 32);
            }
        }
        return Char;
    }
    static CharType ToLower(CharType Char) {
        const uint32 C = ToUnsigned(Char);
        if (C < 0x80) {
            return static_cast<CharType>(C >= 'A' && C <= 'Z' ? C + 32 : C);
        }
        if constexpr (sizeof(CharType) > 1) {
            if ((C >= 0xC0 && C <= 0xDE && C != 0xD7) || (C >= 0x391 && C <= 0x3A9 && C != 0x3A2) ||
                (C >= 0x410 && C <= 0x42F)) {
                return static_cast<CharType>(C + 32);
            }
        }
        return Char;
    }
    static bool IsUpper(CharType Char) { return ToLower(Char) != Char; }
    static bool IsLower(CharType Char) { return ToUpper(Char) != Char; }
    static bool IsAlpha(CharType Char) {
        const uint32 C = ToUnsigned(Char);
        return (C >= 'a' && C <= 'z') || (C >= 'A' && C <= 'Z') ||
               (sizeof(CharType) > 1 && C >= 0xC0 && C != 0xD7 && C != 0xF7);
    }
    static bool IsDigit(CharType Char) { return Char >= CharType('0') && Char <= CharType('9'); }
    static bool IsOctDigit(CharType Char) { return Char >= CharType('0') && Char <= CharType('7'); }
    static bool IsHexDigit(CharType Char) {
        return IsDigit(Char) || (Char >= CharType('a') && Char <= CharType('f')) ||
               (Char >= CharType('A') && Char <= CharType('F'));
    }
    static bool IsAlnum(CharType Char) { return IsAlpha(Char) || IsDigit(Char); }
    static bool IsUnderscore(CharType Char) { return Char == CharType('_'); }
    static bool IsIdentifier(CharType Char) { return IsAlnum(Char) || IsUnderscore(Char); }
    static bool IsWhitespace(CharType Char) {
        const uint32 C = ToUnsigned(Char);
        return C == ' ' || (C >= 9 && C <= 13) || (sizeof(CharType) > 1 && (C == 0xA0 || C == 0x85 || C == 0x3000));
    }
    static bool IsLinebreak(CharType Char) {
        const uint32 C = ToUnsigned(Char);
        return (C >= 0x0A && C <= 0x0D) || (sizeof(CharType) > 1 && (C == 0x85 || C == 0x2028 || C == 0x2029));
    }
    static bool IsControl(CharType Char) { return ToUnsigned(Char) < 0x20 || ToUnsigned(Char) == 0x7F; }
    static bool IsPrint(CharType Char) { return !IsControl(Char); }
    static bool IsGraph(CharType Char) { return IsPrint(Char) && !IsWhitespace(Char); }
    static bool IsPunct(CharType Char) { return ToUnsigned(Char) < 0x80 && IsGraph(Char) && !IsAlnum(Char); }
    static int32 ConvertCharDigitToInt(CharType Char) { return static_cast<int32>(Char) - static_cast<int32>('0'); }
    /** Value of a hexadecimal digit. */
    static int32 HexValue(CharType Char) {
        return IsDigit(Char) ? ConvertCharDigitToInt(Char) : static_cast<int32>(ToLower(Char)) - 'a' + 10;
    }
};
typedef TChar<TCHAR> FChar;
typedef TChar<ANSICHAR> FCharAnsi;
typedef TChar<WIDECHAR> FCharWide;
