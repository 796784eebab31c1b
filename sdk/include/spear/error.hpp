// SPDX-License-Identifier: MIT
#pragma once

// The exceptions of the SDK: one class per row of SPEAR_ERRORS (error_code.hpp), with the hierarchy of that table.
//
//     try { actor.call("SetActorScale3D", spear::arg("NewScale", 2.0)); }
//     catch (const spear::UnknownArgument& error) { fmt::print("{}: {}\n", error.info().operation, error.what()); }
//     catch (const spear::Error& error) { ... }   // all of them

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "spear/error_code.hpp"

namespace spear {

namespace detail {

/// What every error carries. spear::Error, the root of the table, derives from it.
class ErrorBase : public std::runtime_error {
public:
    explicit ErrorBase(ErrorInfo info, std::shared_ptr<const ErrorInfo> original)
        : std::runtime_error(info.message), info_(std::make_shared<const ErrorInfo>(std::move(info))),
          original_(std::move(original)) {}

    /// Code, message, operation, argument and expected type.
    const ErrorInfo& info() const noexcept { return *info_; }
    ErrorCode code() const noexcept { return info_->code; }
    /// The name of the class, e.g. "StaleObject".
    std::string_view name() const noexcept { return error_name(info_->code); }
    /// DependencyFailed: the error of the operation whose future was an argument. Null for all other errors.
    const ErrorInfo* original() const noexcept { return original_.get(); }

private:
    std::shared_ptr<const ErrorInfo> info_; // shared, because copying an exception must not throw
    std::shared_ptr<const ErrorInfo> original_;
};

template <ErrorCode code, typename Parent>
using ParentOf = std::conditional_t<code == ErrorCode::Error, ErrorBase, Parent>;

} // namespace detail

#define SPEAR_DECLARE_ERROR(name, parent, meaning)                                                                     \
    /** meaning */                                                                                                     \
    class name : public detail::ParentOf<ErrorCode::name, class parent> {                                              \
    public:                                                                                                            \
        explicit name(ErrorInfo info, std::shared_ptr<const ErrorInfo> original = nullptr)                             \
            : detail::ParentOf<ErrorCode::name, class parent>(std::move(info), std::move(original)) {}                 \
    };
SPEAR_ERRORS(SPEAR_DECLARE_ERROR)
#undef SPEAR_DECLARE_ERROR

/// Throws the class that belongs to info.code.
[[noreturn]] void throw_error(ErrorInfo info, std::shared_ptr<const ErrorInfo> original = nullptr);

/// Throws without an ErrorInfo at hand.
[[noreturn]] void throw_error(ErrorCode code, std::string message, std::string operation = {},
    std::string argument = {}, std::string expected = {});

} // namespace spear
