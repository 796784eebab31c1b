// SPDX-License-Identifier: MIT
// From checked declarations to the JSON of codegen/SCHEMA.md.
#pragma once

#include "model.h"
#include "registry.h"
#include "report.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace spear::header_tool {

// The entities one header declares.
struct HeaderJson {
    std::vector<nlohmann::json> classes, structs, enums, delegates;
};

HeaderJson emit_header(const Header& header, const Registry& registry, Report& report);

struct ModuleInfo {
    std::string name;
    std::string path;     // as given
    std::string build_cs; // "" if none was found
};

// The whole document; headers in any order.
nlohmann::json emit_document(const std::vector<ModuleInfo>& modules,
    const std::vector<std::unique_ptr<Header>>& headers, std::vector<HeaderJson>& parts);

nlohmann::json type_json(const TypeNode& node);

} // namespace spear::header_tool
