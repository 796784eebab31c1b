// SPDX-License-Identifier: MIT
// What a header tells other headers: everything the registry needs of it. Small, plain data, kept in the cache, so that
// a header that did not change need not be read again to know its types.
#pragma once

#include "model.h"

#include <set>
#include <string>
#include <vector>

namespace spear::header_tool {

// Of a class or struct.
struct RecordFacts {
    std::string name;
    unsigned line = 0;
    std::vector<std::string> bases;     // names, as written
    std::set<std::string> flags;        // own, by specifiers
    std::set<std::string> removed;      // taken out by specifiers (NonTransient, Placeable...), classes
    std::vector<std::string> functions; // names of UFUNCTIONs, classes
    std::vector<TypeSyntax> holds;      // property types that may hold objects; builtin types are left out
    bool instanced = false;             // a property has the specifier Instanced
    bool config_property = false;
    // Classes
    bool interface = false;
    std::string within, config, hide_categories, show_categories, collapse_categories, dont_collapse_categories;
    // Structs
    bool has_defaults = false;
};

struct EnumEntryFacts {
    std::string name, value_text;
};

struct EnumFacts {
    std::string name, form, cpp_type;
    std::string underlying; // as written, "" if not
    unsigned line = 0;
    std::vector<EnumEntryFacts> entries;
};

struct DelegateFacts {
    std::string name, owner, kind;
    unsigned line = 0;
};

// `#define NAME text`, `constexpr int NAME = text;` (in a class or namespace also as "Scope::NAME"), an entry of an
// enum that is not reflected.
struct ConstantFacts {
    std::string name, text;
};

struct HeaderFacts {
    bool reflected = false;
    std::string generated; // "Foo.generated.h", or ""
    std::vector<std::string> type_names;
    std::vector<RecordFacts> classes, structs;
    std::vector<EnumFacts> enums;
    std::vector<DelegateFacts> delegates;
    std::vector<ConstantFacts> constants;
    std::vector<std::string> asked; // names in expressions of this header (values of enumerators, array dimensions)
};

// From a scanned header.
HeaderFacts collect_facts(const Header& header);

} // namespace spear::header_tool
