// SPDX-License-Identifier: MIT
// From specifiers and C++ to reflection flags, as codegen/SCHEMA.md sections 3 to 7 lay down.
#pragma once

#include "model.h"
#include "registry.h"

#include <set>
#include <string>

namespace spear::header_tool {

using Flags = std::set<std::string>;

// Own flags of a class by its specifiers; removals (NonTransient, Placeable...) are in `removed`.
Flags own_class_flags(const Class& c, Flags& removed);
// Flags that a class hands down to its children.
const Flags& inherited_class_flags();
Flags own_struct_flags(const Struct& s);

struct FunctionContext {
    const Registry& registry;
    std::string owner; // class name, "" for global delegates
    bool in_interface = false;
    bool const_class = false;
    bool is_delegate = false;
};

bool is_rpc(const Function& f);
Flags parameter_flags(
    const TypeSyntax& type, const TypeNode& node, const Specifiers& specifiers, bool is_return, bool rpc);
// `parameters` and `returns`: the flags and resolved nodes of the parameters, in order.
Flags function_flags(const Function& f, const FunctionContext& context,
    const std::vector<std::pair<Flags, TypeNode>>& parameters, const std::pair<Flags, TypeNode>* returns);
Flags delegate_flags(const Delegate& d, const Registry& registry,
    const std::vector<std::pair<Flags, TypeNode>>& parameters, const std::pair<Flags, TypeNode>* returns);
Flags property_flags(const Property& p, const TypeNode& node);

// True for structs whose default value UHT wants in the parameter block (FUNC_HasDefaults).
bool struct_has_defaults(const Registry& registry, const std::string& name);

// A specifier that no table knows, for the report.
bool known_property_specifier(std::string_view key);
bool known_function_specifier(std::string_view key);
bool known_class_specifier(std::string_view key);
bool known_struct_specifier(std::string_view key);
bool known_enum_specifier(std::string_view key);

} // namespace spear::header_tool
