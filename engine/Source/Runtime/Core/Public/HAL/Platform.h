// SPDX-License-Identifier: MIT
/** Compiler and platform layer: sized types, TCHAR, TEXT() and the attribute macros that UE code uses. */
#pragma once

#include <cstddef>
#include <cstdint>

#ifndef PLATFORM_LINUX
#define PLATFORM_LINUX 1
#endif
#ifndef PLATFORM_WINDOWS
#define PLATFORM_WINDOWS 0
#endif
#ifndef PLATFORM_MAC
#define PLATFORM_MAC 0
#endif
#ifndef PLATFORM_ANDROID
#define PLATFORM_ANDROID 0
#endif
#ifndef PLATFORM_IOS
#define PLATFORM_IOS 0
#endif
#define PLATFORM_UNIX 1
#define PLATFORM_APPLE 0
#define PLATFORM_MICROSOFT 0
#define PLATFORM_DESKTOP 1
#define PLATFORM_64BITS 1
#define PLATFORM_LITTLE_ENDIAN 1
#define PLATFORM_CACHE_LINE_SIZE 64
#define PLATFORM_MAX_FILEPATH_LENGTH_DEPRECATED 1024
#define PLATFORM_TCHAR_IS_CHAR16 1
#define PLATFORM_TCHAR_IS_4_BYTES 0
#define PLATFORM_COMPILER_HAS_IF_CONSTEXPR 1

typedef unsigned char uint8;
typedef unsigned short int uint16;
typedef unsigned int uint32;
typedef unsigned long long uint64;
typedef signed char int8;
typedef signed short int int16;
typedef signed int int32;
typedef signed long long int64;
typedef __UINTPTR_TYPE__ UPTRINT;
typedef __INTPTR_TYPE__ PTRINT;
typedef __SIZE_TYPE__ SIZE_T;
typedef __PTRDIFF_TYPE__ SSIZE_T;
typedef decltype(nullptr) TYPE_OF_NULLPTR;

typedef char ANSICHAR;
typedef wchar_t WIDECHAR;
typedef char8_t UTF8CHAR;
typedef char16_t UTF16CHAR;
typedef char32_t UTF32CHAR;
typedef uint8 CHAR8;
typedef uint16 CHAR16;
typedef uint32 CHAR32;
/** The engine's character: one UTF-16 code unit, as UE on Linux. */
typedef char16_t TCHAR;

static_assert(sizeof(void*) == 8, "The engine supports 64-bit platforms only.");
static_assert(sizeof(TCHAR) == 2 && sizeof(int64) == 8 && sizeof(SIZE_T) == 8);

#define TEXT_PASTE(x) u##x
/** Makes a TCHAR literal of a plain one. */
#define TEXT(x) TEXT_PASTE(x)
#define UTF8TEXT_PASTE(x) u8##x
#define UTF8TEXT(x) UTF8TEXT_PASTE(x)
#define UTF16TEXT_PASTE(x) u##x
#define UTF16TEXT(x) UTF16TEXT_PASTE(x)

#define DLLEXPORT __attribute__((visibility("default")))
#define DLLIMPORT __attribute__((visibility("default")))
#ifndef CORE_API
#define CORE_API DLLEXPORT
#endif

#define VARARGS
#define CDECL
#define STDCALL
#if defined(__OPTIMIZE__)
#define FORCEINLINE inline __attribute__((always_inline))
#else
#define FORCEINLINE inline
#endif
#define FORCEINLINE_DEBUGGABLE inline
#define FORCENOINLINE __attribute__((noinline))
#define RESTRICT __restrict
#define LIKELY(x) __builtin_expect(!!(x), 1)
#define UNLIKELY(x) __builtin_expect(!!(x), 0)
#define UE_ASSUME(x)                                                                                                   \
    do {                                                                                                               \
        if (!(x)) {                                                                                                    \
            __builtin_unreachable();                                                                                   \
        }                                                                                                              \
    } while (0)
#define ASSUME(x) UE_ASSUME(x)
#define UE_NODISCARD [[nodiscard]]
#define UE_NODISCARD_CTOR [[nodiscard]]
#define UE_NORETURN [[noreturn]]
#define MS_ALIGN(n)
#define GCC_ALIGN(n) __attribute__((aligned(n)))
#define GCC_PACK(n) __attribute__((packed, aligned(n)))
#define LINE_TERMINATOR TEXT("\n")
#define LINE_TERMINATOR_ANSI "\n"
#define UE_LIFETIMEBOUND
#define UE_CONSTEVAL consteval
#define PLATFORM_BREAK() __builtin_trap()
#define UE_DEBUG_BREAK() ((void)0)
#define PREPROCESSOR_TO_STRING_INNER(x) #x
#define PREPROCESSOR_TO_STRING(x) PREPROCESSOR_TO_STRING_INNER(x)
#define PREPROCESSOR_JOIN_INNER(a, b) a##b
#define PREPROCESSOR_JOIN(a, b) PREPROCESSOR_JOIN_INNER(a, b)
#define UE_JOIN(a, b) PREPROCESSOR_JOIN(a, b)
#define UE_STRINGIZE(x) PREPROCESSOR_TO_STRING(x)
#define ANONYMOUS_VARIABLE(Name) PREPROCESSOR_JOIN(Name, __LINE__)

#define PRAGMA_DISABLE_DEPRECATION_WARNINGS                                                                            \
    _Pragma("GCC diagnostic push") _Pragma("GCC diagnostic ignored \"-Wdeprecated-declarations\"")
#define PRAGMA_ENABLE_DEPRECATION_WARNINGS _Pragma("GCC diagnostic pop")
