// SPDX-License-Identifier: MIT
// The declarations that stand in for everything a header would include.
#pragma once

#include "model.h"
#include "registry.h"

#include <set>
#include <string>

namespace spear::header_tool {

// Names that the header's reflected declarations use and does not define itself.
std::set<std::string> used_names(const Header& header);

// C++ text: UE's basic types and templates, then one declaration for each name. `macros`: names to be defined as empty
// macros, with
// "(...)" at the end for function-like ones.
std::string prelude(const Header& header, const Registry& registry, const std::set<std::string>& names,
    const std::set<std::string>& macros);

} // namespace spear::header_tool
