// SPDX-License-Identifier: MIT
#include "metadata.h"

#include "specifiers.h"

#include <algorithm>

namespace spear::header_tool {

namespace {

void add_documentation(Meta& meta, const std::string& comment) {
    if (comment.empty())
        return;
    std::string tip = tool_tip(comment);
    meta.emplace("Comment", comment);
    if (!tip.empty())
        meta.emplace("ToolTip", tip);
}

void add_pairs(Meta& meta, const Specifiers& specifiers) {
    for (const auto& [key, value] : specifiers.meta)
        meta[key] = value;
}

// Specifiers that are metadata on any declaration.
void add_keywords(Meta& meta, const Specifiers& specifiers) {
    auto set = [&](const char* specifier, const char* key, const char* value) {
        if (specifiers.has(specifier))
            meta[key] = value;
    };
    if (specifiers.has("Blueprintable"))
        meta["BlueprintType"] = meta["IsBlueprintBase"] = "true";
    set("NotBlueprintable", "IsBlueprintBase", "false");
    set("BlueprintType", "BlueprintType", "true");
    set("NotBlueprintType", "NotBlueprintType", "true");
    set("BlueprintInternalUseOnly", "BlueprintInternalUseOnly", "true");
    set("CallInEditor", "CallInEditor", "true");
    set("Experimental", "DevelopmentStatus", "Experimental");
    set("EarlyAccessPreview", "DevelopmentStatus", "EarlyAccess");
    for (const char* key : {"Category", "DisplayName", "FriendlyName", "ToolTip", "Keywords", "DocumentationPolicy"})
        if (const Specifier* item = specifiers.find(key); item && item->value)
            meta[key] = *item->value;
}

// key=value specifiers that are plain metadata.
void add_value(Meta& meta, const Specifiers& specifiers, const char* key) {
    if (const Specifier* item = specifiers.find(key); item && item->value)
        meta[key] = *item->value;
}

void add_mark(Meta& meta, const Specifiers& specifiers, const char* key, const char* value = "true") {
    if (specifiers.has(key))
        meta[key] = value;
}

std::string joined(const Specifiers& specifiers, const char* key) {
    const Specifier* item = specifiers.find(key);
    return item && item->value ? *item->value : std::string();
}

bool has_alnum(const std::string& text) {
    return std::any_of(text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) || c >= 0x80; });
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines(1);
    for (char c : text) {
        if (c == '\n')
            lines.emplace_back();
        else if (c == '\t')
            lines.back() += "    ";
        else if (c != '\r')
            lines.back() += c;
    }
    return lines;
}

} // namespace

std::string tool_tip(const std::string& comment) {
    bool block = comment.starts_with("/*");
    std::string text = comment;
    if (block) {
        text.erase(0, 2);
        while (!text.empty() && (text.front() == '*' || text.front() == '!'))
            text.erase(0, 1);
        if (text.starts_with("<"))
            text.erase(0, 1);
        if (text.ends_with("*/"))
            text.erase(text.size() - 2);
        while (!text.empty() && text.back() == '*')
            text.pop_back();
    }
    std::vector<std::string> lines = lines_of(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::string& line = lines[i];
        std::size_t start = line.find_first_not_of(' ');
        if (start == std::string::npos) {
            line.clear();
            continue;
        }
        if (!block && line.compare(start, 2, "//") == 0) {
            start += 2;
            while (start < line.size() && (line[start] == '/' || line[start] == '!'))
                ++start;
            if (start < line.size() && line[start] == '<')
                ++start;
            line.erase(0, start);
        } else if (block && i > 0 && line[start] == '*') {
            line.erase(0, start + 1);
        }
        while (!line.empty() && line.back() == ' ')
            line.pop_back();
        if (!has_alnum(line) && line.size() > 3)
            line.clear(); // rows of ---- or ====
    }
    while (!lines.empty() && trim(lines.back()).empty())
        lines.pop_back();
    while (!lines.empty() && trim(lines.front()).empty())
        lines.erase(lines.begin());
    std::size_t indent = std::string::npos;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::size_t start = lines[i].find_first_not_of(' ');
        if (start != std::string::npos && (i > 0 || !block))
            indent = std::min(indent, start);
    }
    std::string out;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::string line = lines[i];
        if (i == 0 && block)
            line = std::string(trim(line));
        else if (indent != std::string::npos)
            line.erase(0, std::min(indent, line.find_first_not_of(' ') == std::string::npos ? line.size() : indent));
        if (i > 0)
            out += '\n';
        out += line;
    }
    return has_alnum(out) ? out : std::string();
}

Meta class_meta(const Class& c, const TypeInfo& info, const Header& header) {
    Meta meta;
    const Specifiers& s = c.specifiers;
    add_keywords(meta, s);
    add_mark(meta, s, "AdvancedClassDisplay");
    if (s.has("ConversionRoot"))
        meta["IsConversionRoot"] = "true";
    if (s.has("ComponentWrapperClass"))
        meta["IgnoreCategoryKeywordsInSubclasses"] = "true";
    for (const char* key :
        {"ShowCategories", "HideFunctions", "ShowFunctions", "AutoExpandCategories", "PrioritizeCategories"})
        if (std::string value = joined(s, key); !value.empty() && std::string_view(key) != "ShowCategories")
            meta[key] = value;
    if (!info.hide_categories.empty())
        meta["HideCategories"] = info.hide_categories;
    if (!info.auto_collapse_categories.empty())
        meta["AutoCollapseCategories"] = info.auto_collapse_categories;
    if (std::string group = joined(s, "ClassGroup"); !group.empty())
        meta["ClassGroupNames"] = group;
    for (const char* key : {"SparseClassDataType", "SparseClassDataTypes"})
        if (std::string value = joined(s, key); !value.empty())
            meta["SparseClassDataTypes"] = value;
    for (const Constructor& constructor : c.constructors)
        if (constructor.kind == "object_initializer")
            meta["ObjectInitializerConstructorDeclared"] = "";
    meta["ModuleRelativePath"] = header.relative;
    if (!c.interface)
        meta["IncludePath"] = header.include;
    add_pairs(meta, s);
    add_documentation(meta, c.comment);
    return meta;
}

Meta struct_meta(const Struct& s, const Header& header) {
    Meta meta;
    add_keywords(meta, s.specifiers);
    add_mark(meta, s.specifiers, "BlueprintInternalUseOnlyHierarchical");
    if (meta.contains("BlueprintInternalUseOnly") || meta.contains("BlueprintInternalUseOnlyHierarchical"))
        meta["BlueprintType"] = "true";
    meta["ModuleRelativePath"] = header.relative;
    add_pairs(meta, s.specifiers);
    add_documentation(meta, s.comment);
    return meta;
}

Meta enum_meta(const Enum& e, const Header& header) {
    Meta meta;
    add_keywords(meta, e.specifiers);
    meta["ModuleRelativePath"] = header.relative;
    add_pairs(meta, e.specifiers);
    add_documentation(meta, e.comment);
    return meta;
}

Meta enum_entry_meta(const Enum& e, const EnumEntry& entry) {
    Meta meta;
    meta["Name"] = e.form == "regular" ? entry.name : e.name + "::" + entry.name;
    for (const Specifier& item : entry.specifiers.items)
        meta[canonical_meta_key(item.key)] = item.value.value_or("");
    add_pairs(meta, entry.specifiers);
    add_documentation(meta, entry.comment);
    return meta;
}

Meta function_meta(const Function& f, const Header& header) {
    Meta meta;
    const Specifiers& s = f.specifiers;
    add_keywords(meta, s);
    for (const char* key : {"CustomThunk", "FieldNotify", "Variadic"})
        add_mark(meta, s, key);
    add_mark(meta, s, "BlueprintGetter", "");
    add_mark(meta, s, "BlueprintSetter", "");
    meta["ModuleRelativePath"] = header.relative;
    add_pairs(meta, s);
    add_documentation(meta, f.comment);
    return meta;
}

namespace {

void add_const_marks(Meta& meta, const TypeSyntax& type, const TypeNode& node) {
    if (type.is_const)
        meta.emplace("NativeConst", "");
    if (node.const_argument)
        meta.emplace("NativeConstTemplateArg", "");
    if (!node.base_struct.empty())
        meta.emplace("BaseStruct", node.base_struct);
}

bool holds_instanced_object(const TypeNode& node) {
    return node.instanced || std::any_of(node.children.begin(), node.children.end(), holds_instanced_object);
}

} // namespace

Meta property_meta(const Property& p, const TypeNode& node, const Registry& registry, const Header& header) {
    Meta meta;
    const Specifiers& s = p.specifiers;
    add_mark(meta, s, "FieldNotify");
    add_mark(meta, s, "Localized");
    if (s.has("Instanced") || s.has("EditInline") || holds_instanced_object(node))
        meta["EditInline"] = "true";
    for (const char* key : {"BlueprintGetter", "BlueprintSetter"})
        if (const Specifier* item = s.find(key))
            meta[key] = item->value.value_or("");
    add_keywords(meta, s);
    add_value(meta, s, "Units");
    meta["ModuleRelativePath"] = header.relative;
    add_const_marks(meta, p.type, node);
    if (!p.array_text.empty()) {
        // int32 X[EFoo::Count], X[(uint8)EFoo::Count], X[EFoo_MAX]
        std::string text;
        for (char c : p.array_text)
            if (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == ':')
                text += c;
            else
                text.clear();
        std::size_t colon = text.rfind("::");
        std::string scope = colon == std::string::npos ? "" : text.substr(0, colon);
        std::string entry = colon == std::string::npos ? text : text.substr(colon + 2);
        for (const std::string& name : registry.enums_with_entry(entry)) {
            const TypeInfo* info = registry.find(name);
            if (info && (scope.empty() ? info->form == "regular" : scope == name || scope == info->cpp_type))
                meta["ArraySizeEnum"] = "/Script/" + info->module + "." + name;
        }
    }
    add_pairs(meta, s);
    add_documentation(meta, p.comment);
    return meta;
}

Meta parameter_meta(const TypeSyntax& type, const TypeNode& node, const Specifiers& specifiers) {
    Meta meta;
    add_const_marks(meta, type, node);
    if (holds_instanced_object(node))
        meta["EditInline"] = "true";
    add_value(meta, specifiers, "DisplayName");
    add_pairs(meta, specifiers);
    return meta;
}

} // namespace spear::header_tool
