// SPDX-License-Identifier: MIT
#pragma once

// The version of this library; client and server compare theirs at connect. CMake checks that it is the project's.

#include <string_view>

namespace spear {

inline constexpr std::string_view version = "0.1.0";

} // namespace spear
