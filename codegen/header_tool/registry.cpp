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

std::string specifier_value(const Specifiers& s, std::string_view key) {
    const Specifier* item = s.find(key);
    return item && item->value ? *item->value : std::string();
}

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
            info.entries.insert(name.substr(name.rfind(':') + 1));
            info.values.emplace_back(name.substr(name.rfind(':') + 1), entry.at("value").get<long long>());
        }
        types_[info.name] = info;
    }
    for (const json& d : schema.at("delegates")) {
        std::string owner = d.at("owner").is_null() ? "" : d.at("owner").get<std::string>();
        delegates_.emplace(d.at("name"), DelegateInfo{d.at("name"), owner, d.at("kind")});
    }
}

void Registry::add(const Header& header, Report& report) {
    auto insert = [&](TypeInfo info, unsigned line) {
        info.module = header.module;
        info.header = &header;
        auto [it, fresh] = types_.emplace(info.name, info);
        if (fresh)
            return;
        std::string where =
            it->second.header ? it->second.header->path : "an imported schema (module " + it->second.module + ")";
        report.rule(
            "duplicate-name", header.path, line, info.name, "is also declared in " + where + "; the first one is kept");
    };
    for (const Class& c : header.classes) {
        TypeInfo info;
        info.kind = TypeKind::class_;
        info.name = c.name;
        info.interface = c.interface;
        info.class_decl = &c;
        insert(info, c.line);
        if (c.interface)
            interfaces_["I" + c.name.substr(1)] = c.name;
    }
    for (const Struct& s : header.structs) {
        TypeInfo info;
        info.kind = TypeKind::struct_;
        info.name = s.name;
        info.struct_decl = &s;
        info.has_defaults = s.specifiers.has("HasDefaults");
        insert(info, s.line);
    }
    for (const Enum& e : header.enums) {
        TypeInfo info;
        info.kind = TypeKind::enum_;
        info.name = e.name;
        info.form = e.form;
        info.cpp_type = e.cpp_type;
        // A regular or namespaced enum without one is reflected as a byte.
        info.underlying = e.underlying.empty() ? (e.form == "class" ? "int32" : "uint8") : e.underlying;
        for (const EnumEntry& entry : e.entries)
            info.entries.insert(entry.name);
        info.enum_decl = &e;
        insert(info, e.line);
    }
    for (const Delegate& d : header.delegates) {
        for (auto [it, end] = delegates_.equal_range(d.name); it != end; ++it)
            if (it->second.owner == d.owner)
                report.rule("duplicate-name", header.path, d.line, d.name,
                    "a delegate of this name is declared twice in the same scope");
        delegates_.emplace(d.name, DelegateInfo{d.name, d.owner, d.kind});
    }
}

const TypeInfo* Registry::find(const std::string& name) const {
    auto it = types_.find(name);
    return it == types_.end() ? nullptr : &it->second;
}

std::string Registry::interface_class(const std::string& native) const {
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

bool Registry::property_is_instanced(const Property& p, const std::string& owner) const {
    if (p.specifiers.has("Instanced"))
        return true;
    TypeNode node = resolve(p.type, {owner, false, p.bits.has_value()});
    return node.instanced || node.contains_instanced;
}

bool Registry::compute_struct_instanced(const std::string& name, std::set<std::string>& open) {
    auto it = types_.find(name);
    if (it == types_.end() || it->second.kind != TypeKind::struct_ || !it->second.struct_decl ||
        !open.insert(name).second)
        return it != types_.end() && it->second.flags.contains("HasInstancedReference");
    const Struct& s = *it->second.struct_decl;
    bool result = it->second.flags.contains("HasInstancedReference");
    if (!it->second.super.empty())
        result |= compute_struct_instanced(it->second.super, open);
    for (const Property& p : s.properties) {
        std::vector<const TypeSyntax*> pending{&p.type};
        while (!pending.empty()) {
            const TypeSyntax* t = pending.back();
            pending.pop_back();
            if (t->pointers == 0 && t->args.empty())
                result |= compute_struct_instanced(t->name, open);
            for (const TypeSyntax& arg : t->args)
                pending.push_back(&arg);
        }
        result |= property_is_instanced(p, "");
    }
    if (result)
        it->second.flags.insert("HasInstancedReference");
    return result;
}

void Registry::finish_class(TypeInfo& info, std::set<std::string>& open, Report& report) {
    if (!info.class_decl || !open.insert(info.name).second)
        return;
    const Class& c = *info.class_decl;
    for (const Base& base : c.bases)
        if (base.name.size() > 1 && (base.name[0] == 'U' || base.name[0] == 'A') && info.super.empty())
            info.super = base.name;
    // A first base that is no I name is the super even with an unusual prefix.
    if (info.super.empty() && !c.bases.empty() && find(c.bases.front().name))
        info.super = c.bases.front().name;
    Flags removed;
    info.flags = own_class_flags(c, removed);
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
            if (inherited_class_flags().contains(flag) && !removed.contains(flag))
                info.flags.insert(flag);
    }
    std::string within = specifier_value(c.specifiers, "Within");
    if (!within.empty())
        info.within = find("A" + within) ? "A" + within : find(within) ? within : "U" + within;
    else
        info.within = super ? super->within : "UObject";
    std::string config = specifier_value(c.specifiers, "Config");
    info.config = !config.empty() ? config : super ? super->config : "";
    info.hide_categories = merge_words(super ? super->hide_categories : "",
        specifier_value(c.specifiers, "HideCategories"), specifier_value(c.specifiers, "ShowCategories"));
    info.auto_collapse_categories = merge_words(super ? super->auto_collapse_categories : "",
        specifier_value(c.specifiers, "AutoCollapseCategories"),
        specifier_value(c.specifiers, "DontAutoCollapseCategories"));
}

void Registry::finish(Report& report) {
    std::set<std::string> open;
    for (auto& [name, info] : types_)
        if (info.kind == TypeKind::class_)
            finish_class(info, open, report);
    // DefaultToInstanced is now known everywhere; structs next, they may contain such objects and each other.
    for (auto& [name, info] : types_) {
        if (!info.struct_decl)
            continue;
        info.flags = own_struct_flags(*info.struct_decl);
        for (const Base& base : info.struct_decl->bases)
            if (info.super.empty() && (find(base.name) || base.name.starts_with("F")))
                info.super = base.name;
    }
    for (auto& [name, info] : types_) {
        if (!info.struct_decl)
            continue;
        info.super_unresolved = !info.super.empty() && !find(info.super);
        const TypeInfo* at = info.super.empty() ? nullptr : find(info.super);
        for (int depth = 0; at && depth < 256; ++depth) {
            if (at->flags.contains("Atomic") || at->flags.contains("Immutable"))
                info.flags.insert("Atomic");
            at = at->super.empty() ? nullptr : find(at->super);
        }
    }
    // Recursion through `open` may meet a struct that is still being computed; two passes settle such cycles.
    for (int pass = 0; pass < 2; ++pass) {
        std::set<std::string> computing;
        for (auto& [name, info] : types_)
            if (info.struct_decl)
                compute_struct_instanced(name, computing);
    }
    for (auto& [name, info] : types_) {
        if (!info.class_decl)
            continue;
        for (const Property& p : info.class_decl->properties) {
            if (property_is_instanced(p, name))
                info.flags.insert("HasInstancedReference");
            if (p.specifiers.has("Config") || p.specifiers.has("GlobalConfig"))
                info.flags.insert("Config");
        }
    }
    for (auto& [name, info] : types_) {
        const TypeInfo* at = info.kind == TypeKind::class_ && info.class_decl ? find(info.super) : nullptr;
        for (int depth = 0; at && depth < 256; ++depth) {
            for (const char* flag : {"HasInstancedReference", "Config"})
                if (at->flags.contains(flag))
                    info.flags.insert(flag);
            at = find(at->super);
        }
    }
}

} // namespace spear::header_tool
