// SPDX-License-Identifier: MIT
#include "strict.h"

#include "flags.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace spear::header_tool {

namespace {

// Kinds that Blueprints have no pin for.
bool blueprint_kind(const TypeNode& node) {
    static const std::set<std::string> unsupported{
        "int8", "int16", "uint16", "uint32", "uint64", "lazy_object", "optional"};
    return !unsupported.contains(node.kind) && std::all_of(node.children.begin(), node.children.end(), blueprint_kind);
}

bool has_nested_container(const TypeNode& node) {
    return std::any_of(node.children.begin(), node.children.end(),
        [](const TypeNode& child) { return child.is_container() || has_nested_container(child); });
}

// An allocator that UHT does not take, as written; "" if there is none.
std::string foreign_allocator(const TypeSyntax& type) {
    std::size_t place = type.name == "TMap" ? 2 : type.name == "TArray" || type.name == "TSet" ? 1 : type.args.size();
    if (place >= type.args.size() || type.args[place].name == "FDefaultAllocator" ||
        type.args[place].name.find("MemoryImage") != std::string::npos)
        return {};
    return type.args[place].text();
}

class Rules {
public:
    Rules(const Header& header, const Registry& registry, Report& report)
        : header_(header), registry_(registry), report_(report) {}

    void run() {
        include_order();
        for (const Class& c : header_.classes)
            class_rules(c);
        for (const Struct& s : header_.structs)
            struct_rules(s);
        for (const Enum& e : header_.enums)
            enum_rules(e);
        for (const Delegate& d : header_.delegates)
            delegate_rules(d);
    }

private:
    void fail(const char* rule, unsigned line, const std::string& subject, const std::string& message) const {
        report_.rule(rule, header_.path, line, subject, message);
    }

    unsigned line_of(std::size_t offset) const { return header_.source->line(offset); }

    void include_order() const {
        bool types = !header_.type_names.empty();
        const Directive* generated = nullptr;
        for (const Directive& d : header_.lexed.directives) {
            if (d.name != "include")
                continue;
            if (d.rest.find(".generated.h") != std::string::npos)
                generated = &d;
            else if (generated && d.rest.find(".inl") == std::string::npos && !is_after_types(d.begin))
                fail("generated-include-last", line_of(d.begin), d.rest,
                    "is included after " + generated->rest + ", which has to be the last include");
        }
        if (types && !generated && needs_generated())
            fail("no-generated-include", 1, header_.relative, "declares reflected types but includes no *.generated.h");
        if (generated) {
            std::string stem = header_.relative.substr(header_.relative.rfind('/') + 1);
            stem.erase(stem.rfind('.'));
            if (header_.generated != stem + ".generated.h")
                fail("generated-include-last", line_of(generated->begin), header_.generated,
                    "the include has to be \"" + stem + ".generated.h\"");
        }
    }

    // Includes below the types (of inline code) are allowed.
    bool is_after_types(std::size_t offset) const {
        for (const Class& c : header_.classes)
            if (c.body.begin < offset)
                return true;
        for (const Struct& s : header_.structs)
            if (s.body.begin < offset)
                return true;
        return false;
    }

    bool needs_generated() const {
        bool bodies = std::any_of(header_.classes.begin(), header_.classes.end(),
                          [](const Class& c) { return !c.specifiers.has("NoExport"); }) ||
                      std::any_of(header_.structs.begin(), header_.structs.end(),
                          [](const Struct& s) { return !s.specifiers.has("NoExport"); });
        return bodies || (header_.classes.empty() && header_.structs.empty());
    }

    void conditions(const Declared& d, const std::string& subject) const {
        if (!d.conditions.arbitrary.empty())
            fail("arbitrary-condition", line_of(d.macro_offset), subject,
                "stands under '#if " + d.conditions.arbitrary.back() +
                    "'; UHT knows only WITH_EDITOR, WITH_EDITORONLY_DATA and !CPP");
    }

    template <class Known>
    void specifiers(const Declared& d, const std::string& subject, Known known) const {
        for (const Specifier& item : d.specifiers.items)
            if (!known(item.key))
                fail("unknown-specifier", line_of(d.macro_offset), subject, "unknown specifier '" + item.key + "'");
    }

    void record_body(const Record& r, bool exported) const {
        if (exported && !r.generated_body)
            fail("missing-generated-body", r.line, r.name, "has no GENERATED_BODY()");
    }

    void class_rules(const Class& c) const {
        conditions(c, c.name);
        specifiers(c, c.name, known_class_specifier);
        record_body(c, !c.specifiers.has("NoExport") && !c.specifiers.has("Intrinsic"));
        if (c.name[0] != 'U' && c.name[0] != 'A')
            fail("prefix", c.line, c.name, "a class name starts with U or, for actors, A");
        else if (!c.interface && registry_.find("AActor") &&
                 registry_.is_child_of(c.name, "AActor") != (c.name[0] == 'A'))
            fail("prefix", c.line, c.name,
                c.name[0] == 'A' ? "starts with A but is no actor" : "is an actor and has to start with A");
        if (c.bases.empty() && c.name != "UObject")
            fail("missing-body", c.line, c.name, "has no super class; a reflected class derives from UObject");
        if (c.interface && !c.native)
            fail("missing-body", c.line, c.name,
                "the interface class I" + c.name.substr(1) + " with GENERATED_BODY() is missing in this header");
        if (c.interface && !c.properties.empty())
            fail("interface-property", c.properties.front().line, c.name, "an interface cannot have properties");
        if (c.native && !c.native->properties.empty())
            fail("interface-property", c.native->properties.front().line, c.native->name,
                "an interface cannot have properties");
        const Record& body = c.native ? *c.native : static_cast<const Record&>(c);
        if (c.native && !c.functions.empty())
            fail("orphan-macro", c.functions.front().line, c.name,
                "functions of an interface stand in I" + c.name.substr(1) + "; this one is skipped");
        if (c.native)
            record_body(*c.native, true);
        std::set<std::string> names;
        for (const Function& f : body.functions) {
            if (!names.insert(lower(f.name)).second)
                fail("overloaded-function", f.line, c.name + "::" + f.name,
                    "a UFUNCTION of this name is already declared; overloads cannot be reflected (the first is kept)");
            function_rules(f, c, body);
        }
        std::set<std::string> property_names;
        const TypeInfo* info = registry_.find(c.name);
        for (const Property& p : c.properties) {
            if (!property_names.insert(lower(p.cpp_name)).second)
                fail("duplicate-name", p.line, c.name + "::" + p.cpp_name,
                    "a property of this name is already declared");
            if (names.contains(lower(p.cpp_name)))
                fail("duplicate-name", p.line, c.name + "::" + p.cpp_name,
                    "a function of this name is already declared");
            property_rules(p, c, c.name);
            if ((p.specifiers.has("Config") || p.specifiers.has("GlobalConfig")) && info && info->config.empty() &&
                !info->super_unresolved)
                fail("config-without-class-config", p.line, c.name + "::" + p.cpp_name,
                    "is Config, but no class of the chain names a config file (UCLASS(Config=...))");
            if (const Specifier* notify = p.specifiers.find("ReplicatedUsing");
                notify && !function_known(c, notify->value.value_or("")))
                fail("missing-rep-notify", p.line, c.name + "::" + p.cpp_name,
                    "ReplicatedUsing names '" + notify->value.value_or("") + "', which is no UFUNCTION of the class");
            for (const char* which : {"BlueprintGetter", "BlueprintSetter"})
                if (const Specifier* item = p.specifiers.find(which);
                    item && !function_known(c, item->value.value_or("")))
                    fail("missing-accessor", p.line, c.name + "::" + p.cpp_name,
                        fmt::format(
                            "{} names '{}', which is no UFUNCTION of the class", which, item->value.value_or("")));
        }
    }

    // True also when a super class is unknown: it may have it.
    bool function_known(const Class& c, const std::string& name) const {
        const TypeInfo* info = registry_.find(c.name);
        for (int depth = 0; info && depth < 256; ++depth) {
            if (!info->record || info->super_unresolved || registry_.class_has_function(info->name, name))
                return true;
            info = info->super.empty() ? nullptr : registry_.find(info->super);
        }
        return false;
    }

    bool blueprint_visible(const Function& f) const {
        for (const char* key :
            {"BlueprintCallable", "BlueprintPure", "BlueprintImplementableEvent", "BlueprintNativeEvent"})
            if (f.specifiers.has(key))
                return true;
        return false;
    }

    void type_rules(const TypeSyntax& type, bool blueprint, const std::string& owner, unsigned line,
        const std::string& subject, bool custom) const {
        TypeNode node = registry_.resolve(type, {owner, false, false});
        if (node.kind.empty())
            return; // reported when it is written
        if (has_nested_container(node))
            fail("nested-container", line, subject,
                node.cpp + ": a container inside a container cannot be reflected (wrap it in a USTRUCT)");
        if (std::string allocator = foreign_allocator(type); !allocator.empty())
            fail("container-allocator", line, subject,
                "'" + allocator + "': a reflected container has the default allocator");
        if (blueprint && !custom && !blueprint_kind(node))
            fail("unsupported-blueprint-type", line, subject, "type " + node.cpp + " is not supported by Blueprints");
    }

    void function_rules(const Function& f, const Class& c, const Record&) const {
        std::string subject = c.name + "::" + f.name;
        conditions(f, subject);
        specifiers(f, subject, known_function_specifier);
        bool blueprint = blueprint_visible(f);
        bool custom = f.specifiers.has("CustomThunk");
        for (const Parameter& p : f.parameters) {
            type_rules(p.type, blueprint, c.name, f.line, subject + "(" + p.name + ")", custom);
            if (!p.array_text.empty())
                fail("unsupported-type", f.line, subject + "(" + p.name + ")", "a C array cannot be a parameter");
            if (p.type.reference == Reference::rvalue)
                fail("unsupported-type", f.line, subject + "(" + p.name + ")",
                    "an rvalue reference cannot be a parameter");
        }
        std::set<std::string> names;
        for (const Parameter& p : f.parameters)
            if (!p.name.empty() && !names.insert(lower(p.name)).second)
                fail("duplicate-name", f.line, subject, "two parameters are named '" + p.name + "'");
        if (f.return_type.name != "void")
            type_rules(f.return_type, blueprint, c.name, f.line, subject, custom);
        bool event = f.specifiers.has("BlueprintNativeEvent") || f.specifiers.has("BlueprintImplementableEvent");
        if (event && f.access == Access::private_ && !c.interface && !is_true(f, "AllowPrivateAccess"))
            fail("private-blueprint-property", f.line, subject, "a Blueprint event cannot be private");
        if (event && f.is_virtual && !c.interface)
            fail("function-name", f.line, subject,
                "a Blueprint event is virtual by itself; 'virtual' belongs to its _Implementation");
        if (f.specifiers.has("BlueprintImplementableEvent") && f.is_inline)
            fail("function-name", f.line, subject, "a BlueprintImplementableEvent cannot have a body");
    }

    static bool is_true(const Declared& d, const std::string& key) {
        auto it = d.specifiers.meta.find(key);
        return it != d.specifiers.meta.end() && !equals_no_case(it->second, "false");
    }

    void property_rules(const Property& p, const Record& r, const std::string& owner) const {
        std::string subject = r.name + "::" + p.cpp_name;
        conditions(p, subject);
        specifiers(p, subject, known_property_specifier);
        bool blueprint = p.specifiers.has("BlueprintReadWrite") || p.specifiers.has("BlueprintReadOnly");
        if (p.bits)
            blueprint = false; // a bit-field is a bool
        type_rules(p.type, blueprint, owner, p.line, subject, false);
        if (blueprint && p.access == Access::private_ && !is_true(p, "AllowPrivateAccess"))
            fail("private-blueprint-property", p.line, subject,
                "is private and visible to Blueprints; that needs meta=(AllowPrivateAccess=\"true\")");
        if (blueprint && !p.array_text.empty())
            fail("unsupported-blueprint-type", p.line, subject, "a C array is not supported by Blueprints");
        if (p.type.is_const && p.type.pointers == 0)
            fail("const-property", p.line, subject, "a property cannot be const");
        TypeNode node = registry_.resolve(p.type, {owner, p.specifiers.has("BlueprintAssignable"), p.bits.has_value()});
        if (node.kind == "byte_enum" && p.type.name != "TEnumAsByte" && !p.bits)
            fail("raw-enum-member", p.line, subject,
                "a regular or namespaced enum as a member has to be written TEnumAsByte<" + p.type.name + ">");
        if (p.specifiers.has("BlueprintAssignable") && node.kind != "multicast_delegate" &&
            node.kind != "sparse_delegate" && !node.kind.empty())
            fail("unsupported-blueprint-type", p.line, subject,
                "BlueprintAssignable is for multicast delegates, not " + node.cpp);
    }

    void struct_rules(const Struct& s) const {
        conditions(s, s.name);
        specifiers(s, s.name, known_struct_specifier);
        record_body(s, !s.specifiers.has("NoExport"));
        if (s.name[0] != 'F')
            fail("prefix", s.line, s.name, "a struct name starts with F");
        std::set<std::string> names;
        for (const Property& p : s.properties) {
            if (!names.insert(lower(p.cpp_name)).second)
                fail("duplicate-name", p.line, s.name + "::" + p.cpp_name,
                    "a property of this name is already declared");
            property_rules(p, s, "");
        }
    }

    void enum_rules(const Enum& e) const {
        conditions(e, e.name);
        specifiers(e, e.name, known_enum_specifier);
        bool blueprint = e.specifiers.has("BlueprintType");
        if (blueprint && e.form == "class" && e.underlying != "uint8")
            fail("enum-underlying", e.line, e.name,
                "a BlueprintType enum has to be uint8, it is " +
                    (e.underlying.empty() ? std::string("int32") : e.underlying));
        std::set<std::string> names;
        for (const EnumEntry& entry : e.entries)
            if (!names.insert(lower(entry.name)).second)
                fail("duplicate-name", entry.line, e.name + "::" + entry.name,
                    "an enumerator of this name (without case) is already declared");
    }

    void delegate_rules(const Delegate& d) const {
        conditions(d, d.name);
        if (d.declared_parameters != static_cast<int>(d.parameters.size()))
            fail("delegate-parameter-count", d.line, d.name,
                fmt::format(
                    "{} promises {} parameters, {} are given", d.macro, d.declared_parameters, d.parameters.size()));
        if (d.name[0] != 'F')
            fail("prefix", d.line, d.name, "a delegate name starts with F");
        if (d.kind != "single" && d.return_type.name != "void")
            fail("unsupported-type", d.line, d.name, "a multicast delegate cannot return a value");
        for (const Parameter& p : d.parameters)
            type_rules(p.type, false, d.owner, d.line, d.name + "(" + p.name + ")", false);
    }

    const Header& header_;
    const Registry& registry_;
    Report& report_;
};

} // namespace

void check_rules(const Header& header, const Registry& registry, Report& report) {
    Rules(header, registry, report).run();
}

} // namespace spear::header_tool
