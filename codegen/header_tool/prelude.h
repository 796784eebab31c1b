// SPDX-License-Identifier: MIT
// The declarations that stand in for everything a header would include.
#pragma once

#include "model.h"
#include "registry.h"

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace spear::header_tool {

// Names that the header's reflected declarations use and does not define itself.
std::set<std::string> used_names(const Header& header);

// Integer constants of other headers: scope ("" for none), name, value.
using PreludeConstants = std::map<std::string, std::map<std::string, long long>>;

// True for macros that the prelude itself defines (INDEX_NONE).
bool prelude_knows(const std::string& name);

// In the AST a dynamic delegate is a struct with a function of this name.
inline constexpr std::string_view delegate_function = "spear_signature";

// C++ text: UE's basic types and templates, then one declaration for each name. `macros`: names to be defined as empty
// macros, with "(...)" at the end for function-like ones.
std::string prelude(const Header& header, const Registry& registry, const std::set<std::string>& names,
    const std::set<std::string>& macros, const PreludeConstants& constants);

} // namespace spear::header_tool
