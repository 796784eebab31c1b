// SPDX-License-Identifier: MIT
// printf for TCHAR: numbers are left to snprintf, strings and characters are handled here.
#include <cstdio>

#include "Containers/UnrealString.h"

namespace UE::Core::Private {
uint32 DecodeOne(const UTF8CHAR*& Cursor, const UTF8CHAR* End) {
    const uint32 First = static_cast<uint8>(*Cursor++);
    if (First < 0x80) {
        return First;
    }
    const int32 Extra = First >= 0xF0 && First < 0xF5 ? 3 : (First >= 0xE0 ? 2 : 1);
    if (First < 0xC2 || First >= 0xF5 || End - Cursor < Extra) {
        return BadCodepoint;
    }
    uint32 Codepoint = First & (0x3Fu >> Extra);
    for (int32 Index = 0; Index < Extra; ++Index) {
        const uint32 Next = static_cast<uint8>(Cursor[Index]);
        if ((Next & 0xC0) != 0x80) {
            return BadCodepoint;
        }
        Codepoint = (Codepoint << 6) | (Next & 0x3F);
    }
    // Overlong forms, surrogates and what lies beyond Unicode are errors; only the first byte is consumed.
    const bool bTooShort = (Extra == 2 && Codepoint < 0x800) || (Extra == 3 && Codepoint < 0x10000);
    if (bTooShort || (Codepoint >= 0xD800 && Codepoint < 0xE000) || Codepoint > 0x10FFFF) {
        return BadCodepoint;
    }
    Cursor += Extra;
    return Codepoint;
}

namespace {
/** Writes into a buffer and counts what would have been needed. */
struct FSink {
    TCHAR* Dest;
    SIZE_T Size;
    SIZE_T Length = 0;
    void Put(TCHAR Char) {
        if (Length < Size) {
            Dest[Length] = Char;
        }
        ++Length;
    }
    void Pad(int32 Count, TCHAR Char) {
        for (; Count > 0; --Count) {
            Put(Char);
        }
    }
    template <typename CharType>
    void PutText(const CharType* Text, int32 TextLength, int32 Width, bool bLeft) {
        if (!bLeft) {
            Pad(Width - TextLength, TCHAR(' '));
        }
        for (int32 Index = 0; Index < TextLength; ++Index) {
            if constexpr (sizeof(CharType) == 1) {
                Put(static_cast<uint8>(Text[Index]));
            } else {
                Put(static_cast<TCHAR>(Text[Index]));
            }
        }
        if (bLeft) {
            Pad(Width - TextLength, TCHAR(' '));
        }
    }
};

struct FSpec {
    char Text[48];
    int32 TextLength = 0;
    int32 Width = 0;
    int32 Precision = -1;
    bool bLeft = false;
    void Add(char Char) {
        if (TextLength < static_cast<int32>(sizeof(Text)) - 8) {
            Text[TextLength++] = Char;
        }
    }
};

template <typename CharType>
void PutString(FSink& Sink, const FSpec& Spec, const CharType* Text) {
    if (!Text) {
        Sink.PutText("(null)", 6, Spec.Width, Spec.bLeft);
        return;
    }
    const int32 Length = Spec.Precision >= 0 ? TCString<CharType>::Strnlen(Text, static_cast<SIZE_T>(Spec.Precision))
                                             : TCString<CharType>::Strlen(Text);
    Sink.PutText(Text, Length, Spec.Width, Spec.bLeft);
}

template <typename T>
void PutNumber(FSink& Sink, FSpec& Spec, const char* Length, char Conversion, T Value) {
    for (; *Length; ++Length) {
        Spec.Add(*Length);
    }
    Spec.Add(Conversion);
    Spec.Text[Spec.TextLength] = 0;
    // The longest plain double has 309 digits before the point; precision and width come on top.
    char Small[512];
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    const int Needed = std::snprintf(Small, sizeof(Small), Spec.Text, Value);
    if (Needed < static_cast<int>(sizeof(Small))) {
        Sink.PutText(Small, Needed, 0, false);
    } else {
        TArray<char> Large;
        Large.SetNumUninitialized(Needed + 1);
        std::snprintf(Large.GetData(), static_cast<SIZE_T>(Needed) + 1, Spec.Text, Value);
        Sink.PutText(Large.GetData(), Needed, 0, false);
    }
#pragma GCC diagnostic pop
}
} // namespace

int32 FormatVa(TCHAR* Dest, SIZE_T DestSize, const TCHAR* Format, va_list InArgs) {
    FSink Sink{Dest, DestSize > 0 ? DestSize - 1 : 0};
    va_list Args;
    va_copy(Args, InArgs);
    while (*Format) {
        if (*Format != TCHAR('%')) {
            Sink.Put(*Format++);
            continue;
        }
        ++Format;
        if (*Format == TCHAR('%')) {
            Sink.Put(*Format++);
            continue;
        }
        FSpec Spec;
        Spec.Add('%');
        for (; *Format && FCStringAnsi::Strchr("-+ #0", static_cast<char>(*Format < 0x80 ? *Format : 1)) && *Format;
            ++Format) {
            Spec.bLeft |= *Format == TCHAR('-');
            Spec.Add(static_cast<char>(*Format));
        }
        const auto ReadCount = [&]() {
            int32 Count = 0;
            if (*Format == TCHAR('*')) {
                ++Format;
                Count = va_arg(Args, int);
            } else {
                for (; FChar::IsDigit(*Format); ++Format) {
                    Count = Count < 100000 ? Count * 10 + (*Format - TCHAR('0')) : Count;
                }
            }
            return Count;
        };
        Spec.Width = ReadCount();
        if (Spec.Width < 0) {
            Spec.bLeft = true;
            Spec.Add('-');
            Spec.Width = -Spec.Width;
        }
        char Digits[16];
        if (Spec.Width) {
            std::snprintf(Digits, sizeof(Digits), "%d", Spec.Width);
            for (const char* Digit = Digits; *Digit; ++Digit) {
                Spec.Add(*Digit);
            }
        }
        if (*Format == TCHAR('.')) {
            ++Format;
            Spec.Precision = ReadCount();
            if (Spec.Precision >= 0) {
                std::snprintf(Digits, sizeof(Digits), ".%d", Spec.Precision);
                for (const char* Digit = Digits; *Digit; ++Digit) {
                    Spec.Add(*Digit);
                }
            }
        }
        // Length: 0 int, 1 long, 2 long long, -1 short, -2 char; h also marks narrow strings.
        int32 Length = 0;
        for (;; ++Format) {
            if (*Format == TCHAR('l')) {
                ++Length;
            } else if (*Format == TCHAR('h')) {
                --Length;
            } else if (*Format == TCHAR('z') || *Format == TCHAR('t') || *Format == TCHAR('j')) {
                Length = 2;
            } else if (*Format == TCHAR('I') && Format[1] == TCHAR('6') && Format[2] == TCHAR('4')) {
                Length = 2;
                Format += 2;
            } else {
                break;
            }
        }
        const char Conversion = *Format < 0x80 ? static_cast<char>(*Format) : 0;
        if (Conversion) {
            ++Format;
        }
        switch (Conversion) {
        case 'd':
        case 'i':
            if (Length >= 2) {
                PutNumber(Sink, Spec, "ll", 'd', va_arg(Args, long long));
            } else if (Length == 1) {
                PutNumber(Sink, Spec, "l", 'd', va_arg(Args, long));
            } else {
                PutNumber(Sink, Spec, Length == -1 ? "h" : (Length <= -2 ? "hh" : ""), 'd', va_arg(Args, int));
            }
            break;
        case 'u':
        case 'o':
        case 'x':
        case 'X':
            if (Length >= 2) {
                PutNumber(Sink, Spec, "ll", Conversion, va_arg(Args, unsigned long long));
            } else if (Length == 1) {
                PutNumber(Sink, Spec, "l", Conversion, va_arg(Args, unsigned long));
            } else {
                PutNumber(Sink, Spec, Length == -1 ? "h" : (Length <= -2 ? "hh" : ""), Conversion,
                    va_arg(Args, unsigned int));
            }
            break;
        case 'f':
        case 'F':
        case 'e':
        case 'E':
        case 'g':
        case 'G':
        case 'a':
        case 'A':
            PutNumber(Sink, Spec, "", Conversion, va_arg(Args, double));
            break;
        case 'p':
            PutNumber(Sink, Spec, "", 'p', va_arg(Args, void*));
            break;
        case 'c': {
            const TCHAR Char = static_cast<TCHAR>(va_arg(Args, int));
            Sink.PutText(&Char, 1, Spec.Width, Spec.bLeft);
            break;
        }
        case 's':
            if (Length < 0) {
                PutString(Sink, Spec, va_arg(Args, const ANSICHAR*));
            } else {
                PutString(Sink, Spec, va_arg(Args, const TCHAR*));
            }
            break;
        case 'S':
            PutString(Sink, Spec, va_arg(Args, const ANSICHAR*));
            break;
        default:
            checkf(false, TEXT("Unknown conversion '%%%c' in a format string"), Conversion ? Conversion : '?');
        }
    }
    va_end(Args);
    if (DestSize > 0) {
        Dest[Sink.Length < DestSize ? Sink.Length : DestSize - 1] = 0;
    }
    return Sink.Length < DestSize ? static_cast<int32>(Sink.Length) : -1 - static_cast<int32>(Sink.Length);
}
} // namespace UE::Core::Private

FString FString::PrintfVa(const TCHAR* Fmt, va_list Args) {
    TCHAR Small[512];
    int32 Length = UE::Core::Private::FormatVa(Small, UE_ARRAY_COUNT(Small), Fmt, Args);
    if (Length >= 0) {
        return FString(FStringView(Small, Length));
    }
    Length = -1 - Length;
    TArray<TCHAR> Large;
    Large.SetNumUninitialized(Length + 1);
    UE::Core::Private::FormatVa(Large.GetData(), static_cast<SIZE_T>(Length) + 1, Fmt, Args);
    FString Result;
    Result.GetCharArray() = MoveTemp(Large);
    return Result;
}

FString FString::PrintfImpl(const TCHAR* Fmt, ...) {
    va_list Args;
    va_start(Args, Fmt);
    FString Result = PrintfVa(Fmt, Args);
    va_end(Args);
    return Result;
}
