// SPDX-License-Identifier: MIT
/**
 * Conversions between encodings: StringCast<To>(String), TCHAR_TO_UTF8 and its family.
 * ANSICHAR text is ASCII: other characters become '?' on the way to it, and bytes above 127 are taken as Latin-1.
 * The macros' results live until the end of the full expression.
 */
#pragma once

#include "Containers/Array.h"
#include "Misc/CString.h"

namespace UE::Core::Private {
inline constexpr uint32 BadCodepoint = 0xFFFD;

inline uint32 DecodeOne(const ANSICHAR*& Cursor, const ANSICHAR*) { return static_cast<uint8>(*Cursor++); }
CORE_API uint32 DecodeOne(const UTF8CHAR*& Cursor, const UTF8CHAR* End);
inline uint32 DecodeOne(const UTF16CHAR*& Cursor, const UTF16CHAR* End) {
    const uint32 First = *Cursor++;
    if (First >= 0xD800 && First < 0xDC00 && Cursor != End && *Cursor >= 0xDC00 && *Cursor < 0xE000) {
        return 0x10000 + ((First - 0xD800) << 10) + (static_cast<uint32>(*Cursor++) - 0xDC00);
    }
    return First >= 0xD800 && First < 0xE000 ? BadCodepoint : First;
}
inline uint32 DecodeOne(const UTF32CHAR*& Cursor, const UTF32CHAR*) { return static_cast<uint32>(*Cursor++); }
inline uint32 DecodeOne(const WIDECHAR*& Cursor, const WIDECHAR*) { return static_cast<uint32>(*Cursor++); }

template <typename ArrayType>
void EncodeOne(ANSICHAR, uint32 Codepoint, ArrayType& Out) {
    Out.Add(Codepoint < 0x80 ? static_cast<ANSICHAR>(Codepoint) : '?');
}
template <typename ArrayType>
void EncodeOne(UTF8CHAR, uint32 C, ArrayType& Out) {
    if (C < 0x80) {
        Out.Add(static_cast<UTF8CHAR>(C));
    } else if (C < 0x800) {
        Out.Add(static_cast<UTF8CHAR>(0xC0 | (C >> 6)));
        Out.Add(static_cast<UTF8CHAR>(0x80 | (C & 0x3F)));
    } else if (C < 0x10000) {
        Out.Add(static_cast<UTF8CHAR>(0xE0 | (C >> 12)));
        Out.Add(static_cast<UTF8CHAR>(0x80 | ((C >> 6) & 0x3F)));
        Out.Add(static_cast<UTF8CHAR>(0x80 | (C & 0x3F)));
    } else {
        Out.Add(static_cast<UTF8CHAR>(0xF0 | (C >> 18)));
        Out.Add(static_cast<UTF8CHAR>(0x80 | ((C >> 12) & 0x3F)));
        Out.Add(static_cast<UTF8CHAR>(0x80 | ((C >> 6) & 0x3F)));
        Out.Add(static_cast<UTF8CHAR>(0x80 | (C & 0x3F)));
    }
}
template <typename ArrayType>
void EncodeOne(UTF16CHAR, uint32 C, ArrayType& Out) {
    if (C < 0x10000) {
        Out.Add(static_cast<UTF16CHAR>(C));
    } else {
        Out.Add(static_cast<UTF16CHAR>(0xD800 + ((C - 0x10000) >> 10)));
        Out.Add(static_cast<UTF16CHAR>(0xDC00 + ((C - 0x10000) & 0x3FF)));
    }
}
template <typename ArrayType>
void EncodeOne(UTF32CHAR, uint32 C, ArrayType& Out) {
    Out.Add(static_cast<UTF32CHAR>(C));
}
template <typename ArrayType>
void EncodeOne(WIDECHAR, uint32 C, ArrayType& Out) {
    Out.Add(static_cast<WIDECHAR>(C));
}

/** Appends the converted characters, without a terminator. */
template <typename To, typename From, typename ArrayType>
void ConvertString(const From* Source, int32 SourceLength, ArrayType& Out) {
    if constexpr (std::is_same_v<To, From>) {
        Out.Append(Source, SourceLength);
    } else {
        const From* End = Source + SourceLength;
        while (Source != End) {
            EncodeOne(To(), DecodeOne(Source, End), Out);
        }
    }
}
} // namespace UE::Core::Private

/** A converted string, owned. */
template <typename From, typename To, typename Exposed = To>
class TStringConversion {
public:
    template <typename SourceType>
    explicit TStringConversion(const SourceType* Source)
        : TStringConversion(Source, Source ? TCString<SourceType>::Strlen(Source) : 0) {
        bIsNull = Source == nullptr;
    }
    template <typename SourceType>
    TStringConversion(const SourceType* Source, int32 SourceLen) {
        static_assert(sizeof(SourceType) == sizeof(From));
        UE::Core::Private::ConvertString<To>(reinterpret_cast<const From*>(Source), SourceLen, Buffer);
        Buffer.Add(To(0));
    }
    /** Of anything with characters and a count: views, builders. */
    template <typename RangeType>
        requires(!std::is_pointer_v<std::decay_t<RangeType>> &&
                 requires(const RangeType& Range) {
                     Range.GetData();
                     Range.Len();
                 })
    explicit TStringConversion(const RangeType& Range) : TStringConversion(Range.GetData(), Range.Len()) {}
    TStringConversion(TStringConversion&&) = default;

    const Exposed* Get() const { return bIsNull ? nullptr : reinterpret_cast<const Exposed*>(Buffer.GetData()); }
    operator const Exposed*() const { return Get(); }
    /** Count of code units, terminator not included. */
    int32 Length() const { return Buffer.Num() - 1; }

private:
    TArray<To, TInlineAllocator<128>> Buffer;
    bool bIsNull = false;
};

typedef TStringConversion<TCHAR, UTF8CHAR, ANSICHAR> FTCHARToUTF8;
typedef TStringConversion<UTF8CHAR, TCHAR> FUTF8ToTCHAR;
typedef TStringConversion<TCHAR, ANSICHAR> FTCHARToANSI;
typedef TStringConversion<ANSICHAR, TCHAR> FANSIToTCHAR;
typedef TStringConversion<TCHAR, WIDECHAR> FTCHARToWChar;
typedef TStringConversion<WIDECHAR, TCHAR> FWCharToTCHAR;
typedef TStringConversion<TCHAR, UTF32CHAR> FTCHARToUTF32;
typedef TStringConversion<UTF32CHAR, TCHAR> FUTF32ToTCHAR;

/** Converts for the length of an expression or, kept in an `auto`, of a scope. */
template <typename To, typename From>
TStringConversion<From, To> StringCast(const From* Str) {
    return TStringConversion<From, To>(Str);
}
template <typename To, typename From>
TStringConversion<From, To> StringCast(const From* Str, int32 Len) {
    return TStringConversion<From, To>(Str, Len);
}

#define TCHAR_TO_ANSI(str) (ANSICHAR*)FTCHARToANSI((const TCHAR*)(str)).Get()
#define ANSI_TO_TCHAR(str) (TCHAR*)FANSIToTCHAR((const ANSICHAR*)(str)).Get()
#define TCHAR_TO_UTF8(str) (ANSICHAR*)FTCHARToUTF8((const TCHAR*)(str)).Get()
#define UTF8_TO_TCHAR(str) (TCHAR*)FUTF8ToTCHAR((const ANSICHAR*)(str)).Get()
#define TCHAR_TO_WCHAR(str) (WIDECHAR*)FTCHARToWChar((const TCHAR*)(str)).Get()
#define WCHAR_TO_TCHAR(str) (TCHAR*)FWCharToTCHAR((const WIDECHAR*)(str)).Get()
#define TCHAR_TO_UTF16(str) (UTF16CHAR*)(str)
#define UTF16_TO_TCHAR(str) (TCHAR*)(str)
