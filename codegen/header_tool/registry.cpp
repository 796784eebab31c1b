// SPDX-License-Identifier: MIT
#include "registry.h"

#include "flags.h"

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace spear::header_tool {

using nlohmann::json;

namespace {

// "A B" with the words of `more` added and those of `less` taken out.
std::string merge_words(const std::string& base, const std::string& more, const std::string& less) {
    auto words = [](const std::string& text) {
        std::vector<std::string> out;
        std::string word;
        for (char c : text + " ") {
            if (c != ' ') {
                word += c;
            } else if (!word.empty()) {
                out.push_back(word);
                word.clear();
            }
        }
        return out;
    };
    std::vector<std::string> list = words(base);
    for (const std::string& w : words(more))
        if (std::find(list.begin(), list.end(), w) == list.end())
            list.push_back(w);
    for (const std::string& w : words(less))
        std::erase(list, w);
    std::string out;
    for (const std::string& w : list)
        out += (out.empty() ? "" : " ") + w;
    return out;
}

thread_local Trace* current_trace = nullptr;

} // namespace

void Registry::import_schema(const json& schema, const std::string& file) {
    if (!schema.is_object() || schema.value("format", "") != "spear-schema")
        throw std::runtime_error(
            fmt::format("--import {}: not a spear-schema file (no \"format\": \"spear-schema\")", file));
    if (schema.value("version", 0) != 1)
        throw std::runtime_error(fmt::format(
            "--import {}: schema version {} is not supported (supported: 1)", file, schema.value("version", 0)));
    for (const json& c : schema.at("classes")) {
        TypeInfo info;
        info.kind = TypeKind::class_;
        info.name = c.at("name");
        info.module = c.at("module");
        info.super = c.at("super").is_null() ? "" : c.at("super").get<std::string>();
        info.flags = c.at("flags").get<std::set<std::string>>();
        info.within = c.at("within");
        info.config = c.at("config");
        info.interface = info.flags.contains("Interface");
        if (c.contains("editor")) {
            const json& meta = c.at("editor").at("meta");
            info.hide_categories = meta.value("HideCategories", "");
            info.auto_collapse_categories = meta.value("AutoCollapseCategories", "");
        }
        if (info.interface)
            interfaces_["I" + info.name.substr(1)] = info.name;
        types_[info.name] = info;
    }
    for (const json& s : schema.at("structs")) {
        TypeInfo info;
        info.kind = TypeKind::struct_;
        info.name = s.at("name");
        info.module = s.at("module");
        info.super = s.at("super").is_null() ? "" : s.at("super").get<std::string>();
        info.flags = s.at("flags").get<std::set<std::string>>();
        info.has_defaults = s.contains("source") && s.at("source").value("has_defaults", false);
        types_[info.name] = info;
    }
    for (const json& e : schema.at("enums")) {
        TypeInfo info;
        info.kind = TypeKind::enum_;
        info.name = e.at("name");
        info.module = e.at("module");
        info.form = e.at("form");
        info.cpp_type = e.at("cpp_type");
        info.underlying = e.contains("source") ? e.at("source").value("underlying", "uint8") : "uint8";
        for (const json& entry : e.at("entries")) {
            std::string name = entry.at("name");
            name = name.substr(name.rfind(':') + 1);
            entries_[name].insert(info.name);
            info.values.emplace_back(name, entry.at("value").get<long long>());
        }
        // A schema calls a regular enum without a written type a byte, its values may be wider.
        info.written_underlying = info.form == "class" ? info.underlying : "";
        computed_enums_.insert(info.name);
        types_[info.name] = info;
    }
    for (const json& d : schema.at("delegates")) {
        std::string owner = d.at("owner").is_null() ? "" : d.at("owner").get<std::string>();
        delegates_.emplace(d.at("name"), DelegateInfo{d.at("name"), owner, d.at("kind")});
    }
}

void Registry::add(const HeaderFacts& facts, const std::string& module, const std::string& path, Report& report) {
    auto insert = [&](TypeInfo info, unsigned line) {
        info.module = module;
        info.path = path;
        auto [it, fresh] = types_.emplace(info.name, info);
        if (fresh)
            return true;
        std::string where =
            it->second.path.empty() ? "an imported schema (module " + it->second.module + ")" : it->second.path;
        report.rule(
            "duplicate-name", path, line, info.name, "is also declared in " + where + "; the first one is kept");
        return false;
    };
    for (const RecordFacts& c : facts.classes) {
        TypeInfo info;
        info.kind = TypeKind::class_;
        info.name = c.name;
        info.interface = c.interface;
        info.record = &c;
        insert(info, c.line);
        if (c.interface)
            interfaces_["I" + c.name.substr(1)] = c.name;
    }
    for (const RecordFacts& s : facts.structs) {
        TypeInfo info;
        info.kind = TypeKind::struct_;
        info.name = s.name;
        info.record = &s;
        info.has_defaults = s.has_defaults;
        insert(info, s.line);
    }
    for (const EnumFacts& e : facts.enums) {
        TypeInfo info;
        info.kind = TypeKind::enum_;
        info.name = e.name;
        info.form = e.form;
        info.cpp_type = e.cpp_type;
        // A regular or namespaced enum without one is reflected as a byte.
        info.underlying = e.underlying.empty() ? (e.form == "class" ? "int32" : "uint8") : e.underlying;
        info.written_underlying = e.underlying;
        info.enumeration = &e;
        for (const EnumEntryFacts& entry : e.entries)
            info.values.emplace_back(entry.name, std::nullopt);
        if (insert(info, e.line))
            for (const EnumEntryFacts& entry : e.entries)
                entries_[entry.name].insert(e.name);
    }
    for (const DelegateFacts& d : facts.delegates) {
        for (auto [it, end] = delegates_.equal_range(d.name); it != end; ++it)
            if (it->second.owner == d.owner)
                report.rule("duplicate-name", path, d.line, d.name,
                    "a delegate of this name is declared twice in the same scope");
        delegates_.emplace(d.name, DelegateInfo{d.name, d.owner, d.kind});
    }
    add_constants(facts.constants);
}

void Registry::note(const char* kind, const std::string& name) {
    if (current_trace)
        current_trace->insert(std::string(kind) + " " + name);
}

void Registry::set_trace(Trace* trace) { current_trace = trace; }

const TypeInfo* Registry::peek(const std::string& name) const {
    auto it = types_.find(name);
    return it == types_.end() ? nullptr : &it->second;
}

const TypeInfo* Registry::find(const std::string& name) const {
    note("type", name);
    return peek(name);
}

bool Registry::is_kept(const std::string& name, const std::string& path, unsigned line) const {
    note("kept", name);
    const TypeInfo* info = peek(name);
    if (!info || info->path != path)
        return false;
    return (info->record ? info->record->line : info->enumeration ? info->enumeration->line : 0) == line;
}

bool Registry::class_has_function(const std::string& name, const std::string& function) const {
    note("functions", name);
    const TypeInfo* info = peek(name);
    return info && info->record &&
           std::any_of(info->record->functions.begin(), info->record->functions.end(),
               [&](const std::string& f) { return equals_no_case(f, function); });
}

Hash Registry::fact(const std::string& question) const {
    std::size_t blank = question.find(' ');
    std::string kind = question.substr(0, blank), name = blank == std::string::npos ? "" : question.substr(blank + 1);
    Hasher out;
    auto add_all = [&](const auto& items) {
        out.add(items.size());
        for (const std::string& item : items)
            out.add(item);
    };
    if (kind == "delegates") {
        for (auto [it, end] = delegates_.equal_range(name); it != end; ++it)
            out.add(it->second.owner).add(it->second.kind);
        return out.hash();
    }
    if (kind == "interface")
        return out.add(interface_class(name)).hash();
    if (kind == "entry") {
        add_all(enums_with_entry(name));
        return out.hash();
    }
    if (kind == "value") {
        std::size_t bar = name.find('|');
        auto value = name_value(name.substr(bar + 1), name.substr(0, bar), 0);
        return out.add(value.has_value()).add(static_cast<std::uint64_t>(value.value_or(0))).hash();
    }
    const TypeInfo* info = peek(name);
    if (!info)
        return out.hash();
    if (kind == "kept") {
        out.add(info->path).add(info->record ? info->record->line : info->enumeration ? info->enumeration->line : 0);
    } else if (kind == "functions") {
        if (info->record)
            add_all(info->record->functions);
    } else if (kind == "entries") {
        for (const auto& [entry, value] : info->values)
            out.add(entry).add(value.has_value()).add(static_cast<std::uint64_t>(value.value_or(0)));
    } else {
        out.add(static_cast<std::uint64_t>(info->kind)).add(info->name).add(info->module).add(info->super);
        add_all(info->flags);
        out.add(info->within).add(info->config).add(info->hide_categories).add(info->auto_collapse_categories);
        out.add(info->interface).add(info->super_unresolved).add(info->has_defaults).add(info->form);
        out.add(info->cpp_type).add(info->underlying).add(info->written_underlying).add(info->record != nullptr);
    }
    return out.hash();
}

std::string Registry::interface_class(const std::string& native) const {
    note("interface", native);
    auto it = interfaces_.find(native);
    return it == interfaces_.end() ? std::string() : it->second;
}

bool Registry::is_child_of(const std::string& name, const std::string& ancestor) const {
    const TypeInfo* info = find(name);
    for (int depth = 0; info && depth < 256; ++depth) {
        if (info->name == ancestor)
            return true;
        info = info->super.empty() ? nullptr : find(info->super);
    }
    return false;
}

const DelegateInfo* Registry::find_delegate(const std::string& name, const std::string& owner) const {
    note("delegates", name);
    auto [first, last] = delegates_.equal_range(name);
    if (first == last)
        return nullptr;
    std::string scope = owner;
    for (int depth = 0; !scope.empty() && depth < 256; ++depth) {
        for (auto it = first; it != last; ++it)
            if (it->second.owner == scope)
                return &it->second;
        const TypeInfo* info = find(scope);
        scope = info ? info->super : "";
    }
    for (auto it = first; it != last; ++it)
        if (it->second.owner.empty())
            return &it->second;
    return std::next(first) == last ? &first->second : nullptr;
}

bool Registry::class_is_instanced(const std::string& name, std::string& assumed) const {
    if (const TypeInfo* info = find(name)) {
        if (info->flags.contains("DefaultToInstanced"))
            return true;
        // A chain that leaves the known world can only be judged by its last name.
        const TypeInfo* at = info;
        for (int depth = 0; at && depth < 256; ++depth) {
            if (at->super_unresolved)
                return class_is_instanced(at->super, assumed);
            at = at->super.empty() ? nullptr : find(at->super);
        }
        return false;
    }
    bool component = name.size() > 10 && name.starts_with("U") && name.ends_with("Component");
    if (component)
        assumed = name + " taken for a component (DefaultToInstanced)";
    return component;
}

bool Registry::type_is_instanced(const TypeSyntax& type, const std::string& owner) const {
    TypeNode node = resolve(type, {owner, false, false});
    return node.instanced || node.contains_instanced;
}

bool Registry::compute_struct_instanced(const std::string& name, std::set<std::string>& open) {
    auto it = types_.find(name);
    if (it == types_.end() || it->second.kind != TypeKind::struct_ || !it->second.record || !open.insert(name).second)
        return it != types_.end() && it->second.flags.contains("HasInstancedReference");
    const RecordFacts& s = *it->second.record;
    bool result = it->second.flags.contains("HasInstancedReference") || s.instanced;
    if (!it->second.super.empty())
        result |= compute_struct_instanced(it->second.super, open);
    for (const TypeSyntax& held : s.holds) {
        std::vector<const TypeSyntax*> pending{&held};
        while (!pending.empty()) {
            const TypeSyntax* t = pending.back();
            pending.pop_back();
            if (t->pointers == 0 && t->args.empty())
                result |= compute_struct_instanced(t->name, open);
            for (const TypeSyntax& arg : t->args)
                pending.push_back(&arg);
        }
        result = result || type_is_instanced(held, "");
    }
    if (result)
        it->second.flags.insert("HasInstancedReference");
    return result;
}

void Registry::finish_class(TypeInfo& info, std::set<std::string>& open, Report& report) {
    if (info.kind != TypeKind::class_ || !info.record || !open.insert(info.name).second)
        return;
    const RecordFacts& c = *info.record;
    for (const std::string& base : c.bases)
        if (base.size() > 1 && (base[0] == 'U' || base[0] == 'A') && info.super.empty())
            info.super = base;
    // A first base that is no I name is the super even with an unusual prefix.
    if (info.super.empty() && !c.bases.empty() && peek(c.bases.front()))
        info.super = c.bases.front();
    info.flags = c.flags;
    const TypeInfo* super = nullptr;
    if (!info.super.empty()) {
        auto it = types_.find(info.super);
        if (it != types_.end()) {
            finish_class(it->second, open, report);
            super = &it->second;
        } else {
            info.super_unresolved = !is_intrinsic_class(info.super) || info.super == "UObject";
        }
    }
    if (super) {
        info.super_unresolved = false;
        for (const std::string& flag : super->flags)
            if (inherited_class_flags().contains(flag) && !c.removed.contains(flag))
                info.flags.insert(flag);
    }
    if (!c.within.empty())
        info.within = peek("A" + c.within) ? "A" + c.within : peek(c.within) ? c.within : "U" + c.within;
    else
        info.within = super ? super->within : "UObject";
    info.config = !c.config.empty() ? c.config : super ? super->config : "";
    info.hide_categories = merge_words(super ? super->hide_categories : "", c.hide_categories, c.show_categories);
    info.auto_collapse_categories =
        merge_words(super ? super->auto_collapse_categories : "", c.collapse_categories, c.dont_collapse_categories);
}

void Registry::finish_structs() {
    for (auto& [name, info] : types_) {
        if (info.kind != TypeKind::struct_ || !info.record)
            continue;
        info.flags = info.record->flags;
        for (const std::string& base : info.record->bases)
            if (info.super.empty() && (peek(base) || base.starts_with("F")))
                info.super = base;
    }
    for (auto& [name, info] : types_) {
        if (info.kind != TypeKind::struct_ || !info.record)
            continue;
        info.super_unresolved = !info.super.empty() && !peek(info.super);
        const TypeInfo* at = info.super.empty() ? nullptr : peek(info.super);
        for (int depth = 0; at && depth < 256; ++depth) {
            if (at->flags.contains("Atomic") || at->flags.contains("Immutable"))
                info.flags.insert("Atomic");
            at = at->super.empty() ? nullptr : peek(at->super);
        }
    }
    // Recursion through `open` may meet a struct that is still being computed; two passes settle such cycles.
    for (int pass = 0; pass < 2; ++pass) {
        std::set<std::string> computing;
        for (auto& [name, info] : types_)
            if (info.kind == TypeKind::struct_ && info.record)
                compute_struct_instanced(name, computing);
    }
}

void Registry::finish_classes(Report& report) {
    std::set<std::string> open;
    for (auto& [name, info] : types_)
        finish_class(info, open, report);
}

void Registry::finish(Report& report) {
    finish_classes(report);
    // DefaultToInstanced is now known everywhere; structs next, they may contain such objects and each other.
    finish_structs();
    for (auto& [name, info] : types_) {
        if (info.kind != TypeKind::class_ || !info.record)
            continue;
        const RecordFacts& c = *info.record;
        if (c.instanced || std::any_of(c.holds.begin(), c.holds.end(),
                               [&, owner = name](const TypeSyntax& type) { return type_is_instanced(type, owner); }))
            info.flags.insert("HasInstancedReference");
        if (c.config_property)
            info.flags.insert("Config");
    }
    for (auto& [name, info] : types_) {
        const TypeInfo* at = info.kind == TypeKind::class_ && info.record ? peek(info.super) : nullptr;
        for (int depth = 0; at && depth < 256; ++depth) {
            for (const char* flag : {"HasInstancedReference", "Config"})
                if (at->flags.contains(flag))
                    info.flags.insert(flag);
            at = peek(at->super);
        }
    }
    for (auto& [name, info] : types_)
        compute_enum(info);
}

} // namespace spear::header_tool
