// SPDX-License-Identifier: MIT
// libclang's part: which preprocessor branches are active, the values of enumerators, and a second opinion on every
// declaration that the text parser found. No include is ever resolved; a generated prelude declares the names a header
// uses.
#pragma once

#include "model.h"
#include "registry.h"
#include "report.h"
#include "scan.h"

#include <map>
#include <string>
#include <vector>

namespace spear::header_tool {

using Defines = std::map<std::string, std::string>;

// The macros UHT sees, before --define.
Defines default_defines();

// libclang's version text.
std::string clang_version();

// The branches of the conditions that are inactive under `defines`.
std::vector<ByteRange> inactive_branches(const SourceText& source, const std::vector<Directive>& directives,
    const ConditionMap& conditions, const Defines& defines);

struct AstStatistics {
    std::size_t declarations = 0; // that the text parser found
    std::size_t confirmed = 0;    // that the AST has, with the same type
    std::size_t missing = 0;      // that the AST lost
    std::size_t rounds = 0;
};

// Compares the header's declarations with the AST and fills in enumerator values. Differences go to the report.
AstStatistics check_with_ast(Header& header, const Registry& registry, const Defines& defines, Report& report);

} // namespace spear::header_tool
