// SPDX-License-Identifier: MIT
/** FCString: functions on zero-terminated strings. */
#pragma once

#include <cstdarg>
#include <cstdlib>

#include "Misc/Char.h"
#include "Templates/UnrealTypeTraits.h"

namespace ESearchCase {
/** Whether letters of different case are equal. */
enum Type {
    CaseSensitive,
    IgnoreCase,
};
} // namespace ESearchCase
namespace ESearchDir {
enum Type {
    FromStart,
    FromEnd,
};
} // namespace ESearchDir

namespace UE::Core::Private {
/** printf for TCHAR. Returns the length, or -1 - (the length it would have needed) if that did not fit with its
 * terminator. */
CORE_API int32 FormatVa(TCHAR* Dest, SIZE_T DestSize, const TCHAR* Format, va_list Args);
template <typename T>
inline constexpr bool TIsPrintfArgument =
    std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_pointer_v<T> || std::is_same_v<T, decltype(nullptr)>;
} // namespace UE::Core::Private

template <typename T>
struct TCString {
    typedef T CharType;

    static int32 Strlen(const CharType* String) {
        const CharType* End = String;
        while (*End) {
            ++End;
        }
        return static_cast<int32>(End - String);
    }
    static int32 Strnlen(const CharType* String, SIZE_T StringSize) {
        SIZE_T Length = 0;
        while (Length < StringSize && String[Length]) {
            ++Length;
        }
        return static_cast<int32>(Length);
    }
    template <bool bIgnoreCase>
    static int32 CompareN(const CharType* A, const CharType* B, SIZE_T Count) {
        for (; Count > 0; --Count, ++A, ++B) {
            const uint32 CharA = TChar<T>::ToUnsigned(bIgnoreCase ? TChar<T>::ToLower(*A) : *A);
            const uint32 CharB = TChar<T>::ToUnsigned(bIgnoreCase ? TChar<T>::ToLower(*B) : *B);
            if (CharA != CharB) {
                return CharA < CharB ? -1 : 1;
            }
            if (CharA == 0) {
                break;
            }
        }
        return 0;
    }
    static int32 Strcmp(const CharType* A, const CharType* B) { return CompareN<false>(A, B, ~SIZE_T(0)); }
    static int32 Strncmp(const CharType* A, const CharType* B, SIZE_T Count) { return CompareN<false>(A, B, Count); }
    static int32 Stricmp(const CharType* A, const CharType* B) { return CompareN<true>(A, B, ~SIZE_T(0)); }
    static int32 Strnicmp(const CharType* A, const CharType* B, SIZE_T Count) { return CompareN<true>(A, B, Count); }

    /** Copies; Dest must be large enough. */
    static CharType* Strcpy(CharType* Dest, SIZE_T DestCount, const CharType* Src) {
        return Strncpy(Dest, Src, DestCount);
    }
    template <SIZE_T DestCount>
    static CharType* Strcpy(CharType (&Dest)[DestCount], const CharType* Src) {
        return Strncpy(Dest, Src, DestCount);
    }
    /** Copies at most MaxLen - 1 characters and always terminates. */
    static CharType* Strncpy(CharType* Dest, const CharType* Src, SIZE_T MaxLen) {
        check(MaxLen > 0);
        SIZE_T Index = 0;
        for (; Index + 1 < MaxLen && Src[Index]; ++Index) {
            Dest[Index] = Src[Index];
        }
        Dest[Index] = 0;
        return Dest;
    }
    static CharType* Strcat(CharType* Dest, SIZE_T DestCount, const CharType* Src) {
        const SIZE_T Length = static_cast<SIZE_T>(Strlen(Dest));
        Strncpy(Dest + Length, Src, DestCount - Length);
        return Dest;
    }
    template <SIZE_T DestCount>
    static CharType* Strcat(CharType (&Dest)[DestCount], const CharType* Src) {
        return Strcat(Dest, DestCount, Src);
    }
    static const CharType* Strchr(const CharType* String, CharType C) {
        for (;; ++String) {
            if (*String == C) {
                return String;
            }
            if (!*String) {
                return nullptr;
            }
        }
    }
    static const CharType* Strrchr(const CharType* String, CharType C) {
        const CharType* Found = nullptr;
        for (;; ++String) {
            if (*String == C) {
                Found = String;
            }
            if (!*String) {
                return Found;
            }
        }
    }
    static const CharType* Strstr(const CharType* String, const CharType* Find) {
        const SIZE_T Length = static_cast<SIZE_T>(Strlen(Find));
        for (;; ++String) {
            if (CompareN<false>(String, Find, Length) == 0) {
                return String;
            }
            if (!*String) {
                return nullptr;
            }
        }
    }
    static const CharType* Stristr(const CharType* String, const CharType* Find) {
        const SIZE_T Length = static_cast<SIZE_T>(Strlen(Find));
        for (;; ++String) {
            if (CompareN<true>(String, Find, Length) == 0) {
                return String;
            }
            if (!*String) {
                return nullptr;
            }
        }
    }
    static CharType* Strupr(CharType* Dest, SIZE_T DestCount) {
        for (SIZE_T Index = 0; Index < DestCount && Dest[Index]; ++Index) {
            Dest[Index] = TChar<T>::ToUpper(Dest[Index]);
        }
        return Dest;
    }

    static int32 Atoi(const CharType* String) {
        return static_cast<int32>(std::strtol(FNarrow(String).Text, nullptr, 10));
    }
    static int64 Atoi64(const CharType* String) { return std::strtoll(FNarrow(String).Text, nullptr, 10); }
    static float Atof(const CharType* String) { return static_cast<float>(std::strtod(FNarrow(String).Text, nullptr)); }
    static double Atod(const CharType* String) { return std::strtod(FNarrow(String).Text, nullptr); }
    static int32 Strtoi(const CharType* Start, CharType** End, int32 Base) {
        return static_cast<int32>(Strtoi64(Start, End, Base));
    }
    static int64 Strtoi64(const CharType* Start, CharType** End, int32 Base) {
        FNarrow Narrow(Start);
        char* NarrowEnd = nullptr;
        const int64 Result = std::strtoll(Narrow.Text, &NarrowEnd, Base);
        if (End) {
            *End = const_cast<CharType*>(Start) + (NarrowEnd - Narrow.Text);
        }
        return Result;
    }
    static uint64 Strtoui64(const CharType* Start, CharType** End, int32 Base) {
        FNarrow Narrow(Start);
        char* NarrowEnd = nullptr;
        const uint64 Result = std::strtoull(Narrow.Text, &NarrowEnd, Base);
        if (End) {
            *End = const_cast<CharType*>(Start) + (NarrowEnd - Narrow.Text);
        }
        return Result;
    }
    /** "true", "yes", "on" or a number other than 0. */
    static bool ToBool(const CharType* String) {
        const FNarrow Narrow(String);
        return TCString<char>::Stricmp(Narrow.Text, "true") == 0 || TCString<char>::Stricmp(Narrow.Text, "yes") == 0 ||
               TCString<char>::Stricmp(Narrow.Text, "on") == 0 || std::strtol(Narrow.Text, nullptr, 10) != 0;
    }
    /** An optional sign, digits, at most one point. */
    static bool IsNumeric(const CharType* String) {
        if (*String == CharType('-') || *String == CharType('+')) {
            ++String;
        }
        bool bHasDot = false;
        bool bHasDigit = false;
        for (; *String; ++String) {
            if (*String == CharType('.')) {
                if (bHasDot) {
                    return false;
                }
                bHasDot = true;
            } else if (!TChar<T>::IsDigit(*String)) {
                return false;
            } else {
                bHasDigit = true;
            }
        }
        return bHasDigit;
    }
    static bool IsPureAnsi(const CharType* String) {
        for (; *String; ++String) {
            if (TChar<T>::ToUnsigned(*String) > 0x7f) {
                return false;
            }
        }
        return true;
    }

    /** printf into a buffer: returns the length, or -1 if it did not fit. */
    template <typename... Types>
    static int32 Snprintf(CharType* Dest, int32 DestSize, const CharType* Fmt, Types... Args) {
        static_assert((UE::Core::Private::TIsPrintfArgument<Types> && ...), "Invalid argument(s) passed to Snprintf");
        return SnprintfImpl(Dest, DestSize, Fmt, Args...);
    }
    static int32 GetVarArgs(CharType* Dest, SIZE_T DestSize, const CharType* Fmt, va_list Args) {
        const int32 Length = UE::Core::Private::FormatVa(Dest, DestSize, Fmt, Args);
        return Length < 0 ? -1 : Length;
    }

private:
    /** The leading characters of a number as char, for the C library. */
    struct FNarrow {
        explicit FNarrow(const CharType* String) {
            int32 Length = 0;
            for (; Length < 511 && String[Length] && TChar<T>::ToUnsigned(String[Length]) < 0x80; ++Length) {
                Text[Length] = static_cast<char>(String[Length]);
            }
            Text[Length] = 0;
        }
        char Text[512];
    };
    static int32 SnprintfImpl(CharType* Dest, int32 DestSize, const CharType* Fmt, ...) {
        va_list Args;
        va_start(Args, Fmt);
        const int32 Result = GetVarArgs(Dest, static_cast<SIZE_T>(DestSize), Fmt, Args);
        va_end(Args);
        return Result;
    }
};
typedef TCString<TCHAR> FCString;
typedef TCString<ANSICHAR> FCStringAnsi;
typedef TCString<WIDECHAR> FCStringWide;
