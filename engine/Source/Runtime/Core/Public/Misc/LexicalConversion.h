// SPDX-License-Identifier: MIT
/** LexToString, LexFromString, LexTryParseString for built-in types. */
#pragma once

#include "Containers/UnrealStringClass.h"

template <typename T>
    requires(std::is_arithmetic_v<T>)
FString LexToString(const T& Value) {
    if constexpr (std::is_same_v<T, bool>) {
        return FString(Value ? TEXT("true") : TEXT("false"));
    } else if constexpr (std::is_floating_point_v<T>) {
        return FString::Printf(TEXT("%f"), static_cast<double>(Value));
    } else if constexpr (TIsCharType_V<T> && sizeof(T) > 1) {
        return FString::Chr(static_cast<TCHAR>(Value));
    } else if constexpr (std::is_signed_v<T>) {
        return FString::Printf(TEXT("%lld"), static_cast<long long>(Value));
    } else {
        return FString::Printf(TEXT("%llu"), static_cast<unsigned long long>(Value));
    }
}
inline FString LexToString(const FString& Value) { return Value; }
inline FString LexToString(FString&& Value) { return MoveTemp(Value); }
inline FString LexToString(const TCHAR* Value) { return FString(Value); }
template <typename T>
    requires(std::is_enum_v<T>)
FString LexToString(const T& Value) {
    return LexToString(static_cast<std::underlying_type_t<T>>(Value));
}
template <typename T>
    requires(std::is_arithmetic_v<T>)
FString LexToSanitizedString(const T& Value) {
    if constexpr (std::is_floating_point_v<T>) {
        return FString::SanitizeFloat(static_cast<double>(Value));
    } else {
        return LexToString(Value);
    }
}

template <typename T>
    requires(std::is_arithmetic_v<T>)
void LexFromString(T& OutValue, const TCHAR* Buffer) {
    if constexpr (std::is_same_v<T, bool>) {
        OutValue = FCString::ToBool(Buffer);
    } else if constexpr (std::is_floating_point_v<T>) {
        OutValue = static_cast<T>(FCString::Atod(Buffer));
    } else if constexpr (std::is_signed_v<T>) {
        OutValue = static_cast<T>(FCString::Strtoi64(Buffer, nullptr, 10));
    } else {
        OutValue = static_cast<T>(FCString::Strtoui64(Buffer, nullptr, 10));
    }
}
inline void LexFromString(FString& OutValue, const TCHAR* Buffer) { OutValue = Buffer; }
/** Converts if the text is a number (or, for bool and FString, whatever it is). */
template <typename T>
bool LexTryParseString(T& OutValue, const TCHAR* Buffer) {
    LexFromString(OutValue, Buffer);
    if constexpr (std::is_same_v<T, FString> || std::is_same_v<T, bool>) {
        return true;
    } else {
        return FCString::IsNumeric(Buffer) || FCString::Atod(Buffer) != 0.0;
    }
}

/** LexToString for templates that name a type. */
template <typename T>
struct TTypeToString {
    static FString ToString(const T& Value) { return LexToString(Value); }
    static FString ToSanitizedString(const T& Value) { return LexToSanitizedString(Value); }
};
template <typename T>
struct TTypeFromString {
    static void FromString(T& Value, const TCHAR* Buffer) { LexFromString(Value, Buffer); }
};
