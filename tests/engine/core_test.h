// SPDX-License-Identifier: MIT
// What the tests of the Core module share.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "CoreMinimal.h"

namespace core_test {
// Text that doctest can print; compares with case, unlike FString.
inline std::string text(const FString& value) {
    const FTCHARToUTF8 utf8(*value, value.Len());
    return std::string(utf8.Get(), static_cast<std::size_t>(utf8.Length()));
}
inline std::string text(const FName& value) { return text(value.ToString()); }
inline std::string text(const FText& value) { return text(value.ToString()); }

inline bool near(double a, double b, double tolerance = 1e-9) { return std::fabs(a - b) <= tolerance; }
inline bool near(const FVector& a, const FVector& b, double tolerance = 1e-9) {
    return near(a.X, b.X, tolerance) && near(a.Y, b.Y, tolerance) && near(a.Z, b.Z, tolerance);
}
inline bool near(const FRotator& a, const FRotator& b, double tolerance = 1e-6) { return a.Equals(b, tolerance); }
} // namespace core_test
