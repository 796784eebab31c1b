// SPDX-License-Identifier: MIT
// From a header's bytes to its declarations.
#pragma once

#include "ast.h"
#include "model.h"
#include "report.h"

#include <string>
#include <string_view>

namespace spear::header_tool {

// False for text in which no word of reflection occurs (UTF-16 text counts as true: it has to be decoded first).
bool mentions_reflection(std::string_view bytes);

// Fills `header` from its bytes; module and paths are already there. What cannot be understood is reported.
// `header.source` stays null for what is no header at all.
void read_header(Header& header, std::string bytes, const Defines& defines, Report& report);

} // namespace spear::header_tool
