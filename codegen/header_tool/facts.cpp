// SPDX-License-Identifier: MIT
#include "facts.h"

#include "constants.h"
#include "flags.h"

#include <algorithm>
#include <array>

namespace spear::header_tool {

namespace {

std::string value_of(const Specifiers& s, std::string_view key) {
    const Specifier* item = s.find(key);
    return item && item->value ? *item->value : std::string();
}

bool plain_type(const TypeSyntax& type) {
    static constexpr std::array<std::string_view, 20> names{"bool", "int8", "int16", "int32", "int64", "uint8",
        "uint16", "uint32", "uint64", "float", "double", "int", "FString", "FName", "FText", "FVector", "FRotator",
        "FTransform", "FLinearColor", "FVector2D"};
    return type.pointers == 0 && std::all_of(type.args.begin(), type.args.end(), plain_type) &&
           (!type.args.empty() || std::find(names.begin(), names.end(), type.name) != names.end());
}

RecordFacts record_facts(const Record& r) {
    RecordFacts out;
    out.name = r.name;
    out.line = r.line;
    for (const Base& base : r.bases)
        out.bases.push_back(base.name);
    std::set<std::string> seen;
    for (const Property& p : r.properties) {
        out.instanced |= p.specifiers.has("Instanced");
        out.config_property |= p.specifiers.has("Config") || p.specifiers.has("GlobalConfig");
        if (!p.bits && !plain_type(p.type) && seen.insert(p.type.text()).second)
            out.holds.push_back(p.type);
    }
    return out;
}

} // namespace

HeaderFacts collect_facts(const Header& header) {
    HeaderFacts out;
    out.reflected = header.reflected;
    out.generated = header.generated;
    out.type_names = header.type_names;
    for (const Class& c : header.classes) {
        RecordFacts r = record_facts(c);
        r.flags = own_class_flags(c, r.removed);
        r.interface = c.interface;
        for (const Function& f : c.functions)
            r.functions.push_back(f.name);
        r.within = value_of(c.specifiers, "Within");
        r.config = value_of(c.specifiers, "Config");
        r.hide_categories = value_of(c.specifiers, "HideCategories");
        r.show_categories = value_of(c.specifiers, "ShowCategories");
        r.collapse_categories = value_of(c.specifiers, "AutoCollapseCategories");
        r.dont_collapse_categories = value_of(c.specifiers, "DontAutoCollapseCategories");
        out.classes.push_back(std::move(r));
    }
    for (const Struct& s : header.structs) {
        RecordFacts r = record_facts(s);
        r.flags = own_struct_flags(s);
        r.has_defaults = s.specifiers.has("HasDefaults");
        out.structs.push_back(std::move(r));
    }
    for (const Enum& e : header.enums) {
        EnumFacts f{e.name, e.form, e.cpp_type, e.underlying, e.line, {}};
        for (const EnumEntry& entry : e.entries)
            f.entries.push_back({entry.name, entry.value_text});
        out.enums.push_back(std::move(f));
    }
    for (const Delegate& d : header.delegates)
        out.delegates.push_back({d.name, d.owner, d.kind, d.line});
    out.constants = find_constants(header.lexed);
    std::set<std::string> asked;
    auto ask = [&](const std::string& expression) {
        for (std::string& name : names_in(expression))
            asked.insert(std::move(name));
    };
    for (const Enum& e : header.enums)
        for (const EnumEntry& entry : e.entries)
            ask(entry.value_text);
    auto ask_record = [&](const Record& r) {
        for (const Property& p : r.properties)
            ask(p.array_text);
    };
    std::for_each(header.classes.begin(), header.classes.end(), ask_record);
    std::for_each(header.structs.begin(), header.structs.end(), ask_record);
    out.asked.assign(asked.begin(), asked.end());
    return out;
}

} // namespace spear::header_tool
