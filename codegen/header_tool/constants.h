// SPDX-License-Identifier: MIT
// Integer constants as C++ writes them: finding their definitions in a header's tokens, and computing expressions
// (values of enumerators, dimensions of C arrays) whose parts stand in other headers.
#pragma once

#include "facts.h"
#include "text.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace spear::header_tool {

// Definitions at any scope that could be integer constants. A name in a class, namespace or enum class is listed as
// "Scope::NAME" (the innermost scope).
std::vector<ConstantFacts> find_constants(const LexResult& lexed);

// The value of a qualified or plain name, nullopt if it is none.
using NameValue = std::function<std::optional<long long>(const std::string& name)>;

// C++'s integer arithmetic on 64 bits, with casts to builtin types; nullopt when the text is no such expression or a
// name has no value.
std::optional<long long> evaluate(const std::string& expression, const NameValue& names);

// The names an expression uses ("EFoo::Bar", "MAX_ITEMS"), casts' types left out where they are builtin.
std::vector<std::string> names_in(const std::string& expression);

} // namespace spear::header_tool
