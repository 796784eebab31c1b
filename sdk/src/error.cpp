// SPDX-License-Identifier: MIT
#include "spear/error.hpp"

namespace spear {

void throw_error(ErrorInfo info, std::shared_ptr<const ErrorInfo> original) {
    switch (info.code) {
#define SPEAR_THROW(name, parent, meaning)                                                                             \
    case ErrorCode::name:                                                                                              \
        throw name(std::move(info), std::move(original));
        SPEAR_ERRORS(SPEAR_THROW)
#undef SPEAR_THROW
    }
    throw Error(std::move(info), std::move(original)); // a number of a newer version
}

void throw_error(
    ErrorCode code, std::string message, std::string operation, std::string argument, std::string expected) {
    throw_error(ErrorInfo{code, std::move(message), std::move(operation), std::move(argument), std::move(expected)});
}

} // namespace spear
