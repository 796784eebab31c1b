// SPDX-License-Identifier: MIT
#pragma once

// A value or an error. Unreal code has no exceptions: whatever can fail returns one of these.

#include "CoreMinimal.h"

#include "spear/error_code.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace SpearServer {

using spear::ErrorCode;
using spear::ErrorInfo;

/// An error. The operation's name is filled in by whoever runs the operation, where it is empty.
inline ErrorInfo MakeError(ErrorCode Code, std::string Message, std::string Argument = {}, std::string Expected = {}) {
    return {Code, std::move(Message), {}, std::move(Argument), std::move(Expected)};
}

template <typename T>
class [[nodiscard]] TSpearResult {
public:
    TSpearResult(T InValue) : Value(std::move(InValue)) {} // NOLINT: implicit by purpose
    TSpearResult(ErrorInfo InError)
        : Error(std::make_unique<ErrorInfo>(std::move(InError))) {} // NOLINT: implicit by purpose

    bool IsOk() const { return Value.has_value(); }
    T& GetValue() { return *Value; }
    const T& GetValue() const { return *Value; }
    ErrorInfo& GetError() { return *Error; }

private:
    std::optional<T> Value;
    std::unique_ptr<ErrorInfo> Error;
};

template <>
class [[nodiscard]] TSpearResult<void> {
public:
    TSpearResult() = default;
    TSpearResult(ErrorInfo InError)
        : Error(std::make_unique<ErrorInfo>(std::move(InError))) {} // NOLINT: implicit by purpose

    bool IsOk() const { return Error == nullptr; }
    ErrorInfo& GetError() { return *Error; }

private:
    std::unique_ptr<ErrorInfo> Error;
};

using FStatus = TSpearResult<void>;

} // namespace SpearServer
