// SPDX-License-Identifier: MIT
// From checked declarations to the JSON of codegen/SCHEMA.md.
#pragma once

#include "model.h"
#include "registry.h"
#include "report.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace spear::header_tool {

// One class, struct, enum or delegate of the schema, as JSON text at its place in the document.
struct Fragment {
    enum class Kind : std::uint8_t { class_, struct_, enum_, delegate };
    Kind kind = Kind::class_;
    std::string name, path; // what the document is sorted by
    std::string text;
};

// The entities one header declares.
std::vector<Fragment> emit_header(const Header& header, const Registry& registry, Report& report);

struct ModuleInfo {
    std::string name;
    std::string path;     // as given
    std::string build_cs; // "" if none was found
    bool written = true;  // false: its types are only known, to resolve what the written ones refer to
};

// What a module's list of headers says.
struct HeaderEntry {
    std::string module, path, include, generated;
    std::vector<std::string> types;
};

// Writes the whole document, piece by piece.
void emit_document(std::ostream& out, const std::vector<ModuleInfo>& modules, const std::vector<HeaderEntry>& headers,
    const std::vector<const Fragment*>& fragments);

nlohmann::json type_json(const TypeNode& node);

} // namespace spear::header_tool
