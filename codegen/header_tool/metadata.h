// SPDX-License-Identifier: MIT
// Editor metadata as UHT writes it (codegen/SCHEMA.md sections 8 and 9).
#pragma once

#include "model.h"
#include "registry.h"

#include <map>
#include <optional>
#include <string>

namespace spear::header_tool {

using Meta = std::map<std::string, std::string>;

// A comment without its marks, as a tool tip; "" when nothing is left.
std::string tool_tip(const std::string& comment);

Meta class_meta(const Class& c, const TypeInfo& info, const Header& header);
Meta struct_meta(const Struct& s, const Header& header);
Meta enum_meta(const Enum& e, const Header& header);
Meta enum_entry_meta(const Enum& e, const EnumEntry& entry);
Meta function_meta(const Function& f, const Header& header);
Meta property_meta(const Property& p, const TypeNode& node, const Registry& registry, const Header& header);
// Parameters and return values.
Meta parameter_meta(const TypeSyntax& type, const TypeNode& node, const Specifiers& specifiers);

// The text UHT stores for a default argument; nullopt when the C++ text has no reflected form.
std::optional<std::string> normalised_default(const std::string& text, const TypeNode& node);

} // namespace spear::header_tool
