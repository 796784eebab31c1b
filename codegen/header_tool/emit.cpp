// SPDX-License-Identifier: MIT
#include "emit.h"

#include "flags.h"
#include "metadata.h"
#include "strict.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <ostream>
#include <tuple>

namespace spear::header_tool {

using nlohmann::json;

json type_json(const TypeNode& node) {
    json out = {{"kind", node.kind}, {"cpp", node.cpp}};
    if (!node.name.empty())
        out["name"] = node.name;
    if (node.kind == "enum")
        out["underlying"] = node.underlying;
    if (!node.owner.empty())
        out["owner"] = node.owner;
    if (node.bitfield)
        out["bitfield"] = true;
    if (node.kind == "map") {
        out["key"] = type_json(node.children[0]);
        out["value"] = type_json(node.children[1]);
    } else if (node.is_container()) {
        out["inner"] = type_json(node.children[0]);
    }
    return out;
}

namespace {

// The name without its prefix: "AActor" -> "Actor", "UDEPRECATED_Foo" -> "Foo".
std::string reflected(const std::string& name) {
    std::string out = name.size() > 1 ? name.substr(1) : name;
    return out.starts_with("DEPRECATED_") ? out.substr(11) : out;
}

// JSON text whose lines after the first start `depth` blanks deeper.
std::string indented(const json& value, std::size_t depth) {
    std::string flat = value.dump(2, ' ', false, json::error_handler_t::replace), out;
    out.reserve(flat.size() * 2);
    for (char c : flat) {
        out += c;
        if (c == '\n')
            out.append(depth, ' ');
    }
    return out;
}

std::string script_path(const std::string& module, const std::string& name) { return "/Script/" + module + "." + name; }

class Emitter {
public:
    Emitter(const Header& header, const Registry& registry, Report& report)
        : header_(header), registry_(registry), report_(report) {}

    std::vector<Fragment> run() {
        for (const Class& c : header_.classes)
            if (mine(c))
                add(Fragment::Kind::class_, class_json(c));
        for (const Struct& s : header_.structs)
            if (mine(s))
                add(Fragment::Kind::struct_, struct_json(s));
        for (const Enum& e : header_.enums)
            if (mine(e))
                add(Fragment::Kind::enum_, enum_json(e));
        for (const Delegate& d : header_.delegates)
            add(Fragment::Kind::delegate, delegate_json(d));
        return std::move(fragments_);
    }

private:
    void add(Fragment::Kind kind, const json& entity) {
        if (entity.is_null())
            return;
        // An entity is an element of an array that is a member of the document: two levels deep.
        fragments_.push_back({kind, entity.at("name"), entity.at("path"), indented(entity, 4)});
    }

    // False for a second declaration of a name (already reported).
    template <class Type>
    bool mine(const Type& declaration) const {
        return registry_.is_kept(declaration.name, header_.path, declaration.line);
    }

    json source_of(const Declared& d) const {
        return {{"line", d.line}, {"comment", d.comment}, {"specifiers", d.specifiers.raw},
            {"editor_only", d.conditions.editor_only}};
    }

    static json body_json(const std::optional<GeneratedBody>& body) {
        return body ? json{{"macro", body->macro}, {"access", body->access}, {"line", body->line}} : json(nullptr);
    }

    static json bases_json(const std::vector<Base>& bases) {
        json out = json::array();
        for (const Base& b : bases)
            out.push_back({{"name", b.name}, {"access", b.access}, {"text", b.text}});
        return out;
    }

    void note_type(const TypeNode& node, unsigned line, const std::string& subject) const {
        if (node.assumed.empty())
            return;
        if (registry_.closed() && report_.strict())
            report_.rule("unresolved-type", header_.path, line, subject,
                "unknown type: it is declared neither here nor in an imported schema (" + node.assumed + ")");
        else
            report_.note("assumed-type", header_.path, line, subject, node.assumed);
    }

    void note_super(unsigned line, const std::string& name, const std::string& super) const {
        std::string text = "super type '" + super + "' is in no schema of this run; what it hands down is unknown";
        if (registry_.closed() && report_.strict())
            report_.rule("unresolved-super", header_.path, line, name, text);
        else
            report_.note("unresolved-super", header_.path, line, name, text);
    }

    // Of a parameter (strict mode refuses C arrays there).
    int array_dim(const std::string& text, const std::string& owner) const {
        long long size = text.empty() ? 1 : registry_.evaluate(text, owner).value_or(1);
        return size > 0 && size <= std::numeric_limits<int>::max() ? static_cast<int>(size) : 1;
    }

    struct Signature {
        json parameters = json::array();
        json returns = nullptr;
        std::vector<std::pair<Flags, TypeNode>> nodes;
        std::optional<std::pair<Flags, TypeNode>> returned;
        std::map<std::string, std::string> defaults;
        bool good = true;
    };

    Signature signature(const Function& f, const std::string& owner, const std::string& subject) const {
        Signature out;
        bool rpc = is_rpc(f);
        Registry::Use use{owner, false, false};
        for (std::size_t i = 0; i < f.parameters.size(); ++i) {
            const Parameter& p = f.parameters[i];
            TypeNode node = registry_.resolve(p.type, use);
            if (node.kind.empty() || p.name.empty()) {
                std::string why = p.name.empty() ? "parameter " + std::to_string(i + 1) + " has no name"
                                                 : "parameter '" + p.name + "': " + node.problem;
                report_.rule(p.name.empty() ? "unnamed-parameter" : "unsupported-type", header_.path, f.line, subject,
                    why + "; the function is skipped");
                out.good = false;
                return out;
            }
            note_type(node, f.line, subject);
            Flags flags = parameter_flags(p.type, node, p.specifiers, false, rpc);
            json editor = {{"meta", parameter_meta(p.type, node, p.specifiers)}};
            json source = {{"type_text", p.type_text}, {"specifiers", p.specifiers.raw}};
            if (p.default_text) {
                source["default"] = *p.default_text;
                if (auto text = normalised_default(*p.default_text, node)) {
                    editor["default"] = *text;
                    out.defaults["CPP_Default_" + p.name] = *text;
                } else {
                    report_.rule("default-argument", header_.path, f.line, subject,
                        fmt::format("default argument '{}' of '{}' has no reflected form for {}; reflected callers "
                                    "must pass it",
                            *p.default_text, p.name, node.cpp));
                }
            }
            out.parameters.push_back({{"name", p.name}, {"type", type_json(node)}, {"flags", flags},
                {"array_dim", array_dim(p.array_text, owner)}, {"editor", editor}, {"source", source}});
            out.nodes.emplace_back(flags, node);
        }
        if (!(f.return_type.name == "void" && f.return_type.pointers == 0)) {
            TypeNode node = registry_.resolve(f.return_type, use);
            if (node.kind.empty()) {
                report_.rule("unsupported-type", header_.path, f.line, subject,
                    "return type: " + node.problem + "; the function is skipped");
                out.good = false;
                return out;
            }
            note_type(node, f.line, subject);
            Flags flags = parameter_flags(f.return_type, node, f.return_specifiers, true, rpc);
            out.returns = {{"type", type_json(node)}, {"flags", flags},
                {"editor", {{"meta", parameter_meta(f.return_type, node, f.return_specifiers)}}},
                {"source", {{"type_text", f.return_text}}}};
            out.returned = {flags, node};
        }
        return out;
    }

    json function_json(const Function& f, const Class& c, const Record& body) const {
        std::string subject = c.name + "::" + f.name;
        Signature s = signature(f, c.name, subject);
        if (!s.good)
            return nullptr;
        const TypeInfo* info = registry_.find(c.name);
        FunctionContext context{registry_, c.name, c.interface, info && info->flags.contains("Const"), false};
        Flags flags = function_flags(f, context, s.nodes, s.returned ? &*s.returned : nullptr);
        Meta meta = function_meta(f, header_);
        meta.insert(s.defaults.begin(), s.defaults.end());
        bool event_body = f.specifiers.has("BlueprintNativeEvent") || is_rpc(f);
        std::string implementation = event_body ? f.name + "_Implementation" : "";
        std::string validation = f.specifiers.has("WithValidation") ? f.name + "_Validate" : "";
        json source = source_of(f);
        source.update({{"access", to_string(f.access)}, {"virtual", f.is_virtual}, {"static", f.is_static},
            {"const", f.is_const}, {"override", f.is_override}, {"final", f.is_final}, {"inline", f.is_inline},
            {"api", f.api}, {"custom_thunk", f.specifiers.has("CustomThunk")}, {"implementation", implementation},
            {"implementation_declared", !implementation.empty() && body.declares.contains(implementation)},
            {"validation", validation},
            {"validation_declared", !validation.empty() && body.declares.contains(validation)}, {"pure", f.is_pure},
            {"deprecated", f.deprecated}});
        return {{"name", f.name}, {"flags", flags}, {"parameters", s.parameters}, {"returns", s.returns},
            {"editor", {{"meta", meta}}}, {"source", source}};
    }

    json property_json(const Property& p, const Record& r, const std::string& owner) const {
        std::string subject = r.name + "::" + p.cpp_name;
        TypeNode node = registry_.resolve(p.type, {owner, p.specifiers.has("BlueprintAssignable"), p.bits.has_value()});
        if (p.type.reference != Reference::none) {
            node.kind.clear();
            node.problem = "a reference member cannot be reflected";
        }
        if (node.kind.empty()) {
            report_.rule("unsupported-type", header_.path, p.line, subject, node.problem + "; the property is skipped");
            return nullptr;
        }
        note_type(node, p.line, subject);
        std::string name = p.cpp_name;
        if (name.ends_with("_DEPRECATED"))
            name.erase(name.size() - 11);
        json source = source_of(p);
        source["type_text"] = p.type_text;
        source["cpp_name"] = p.cpp_name;
        source["access"] = to_string(p.access);
        if (p.default_text)
            source["default"] = *p.default_text;
        if (p.bits)
            source["bits"] = std::atoi(p.bits->c_str());
        if (p.is_mutable)
            source["mutable"] = true;
        if (!p.array_text.empty())
            source["array_text"] = p.array_text;
        if (node.kind == "object" || node.kind == "class")
            source["pointer"] = node.object_ptr ? "TObjectPtr" : "raw";
        json out = {{"name", name}, {"type", type_json(node)}, {"flags", property_flags(p, node)},
            {"array_dim", p.array_size.value_or(1)},
            {"editor", {{"meta", property_meta(p, node, registry_, header_)}}}};
        if (const Specifier* notify = p.specifiers.find("ReplicatedUsing"))
            out["rep_notify"] = notify->value.value_or("");
        std::string plain = node.kind == "bool" && name.size() > 1 && name[0] == 'b' &&
                                    std::isupper(static_cast<unsigned char>(name[1]))
                                ? name.substr(1)
                                : name;
        for (const char* which : {"Getter", "Setter"}) {
            const Specifier* item = p.specifiers.find(which);
            if (!item)
                continue;
            bool get = which[0] == 'G';
            std::string fallback = get ? (node.kind == "bool" ? "Is" : "Get") + plain : "Set" + plain;
            if (get && node.kind == "bool") {
                bool is = !owner.empty() && r.declares.contains("Is" + plain);
                fallback = (is ? "Is" : "Get") + plain;
            }
            std::string accessor = item->value.value_or("");
            if (equals_no_case(accessor, "None"))
                continue;
            source[get ? "getter" : "setter"] = accessor.empty() ? fallback : accessor;
            out[get ? "native_getter" : "native_setter"] = true;
        }
        out["source"] = source;
        return out;
    }

    json properties_json(const Record& r, const std::string& owner) const {
        json out = json::array();
        for (const Property& p : r.properties)
            if (json property = property_json(p, r, owner); !property.is_null())
                out.push_back(property);
        return out;
    }

    json record_source(const Record& r) const {
        json source = source_of(r);
        source.update({{"header", header_.relative}, {"api", r.api}, {"bases", bases_json(r.bases)},
            {"final", r.is_final}, {"generated_body", body_json(r.generated_body)}});
        return source;
    }

    json class_json(const Class& c) const {
        const TypeInfo& info = *registry_.find(c.name);
        json interfaces = json::array();
        if (!c.interface)
            for (const Base& b : c.bases)
                if (b.name[0] == 'I' && is_reflected_interface(b.name, c))
                    interfaces.push_back(b.name);
        const Record& functions_of = c.interface && c.native ? *c.native : static_cast<const Record&>(c);
        std::vector<json> functions;
        for (const Function& f : functions_of.functions)
            if (json function = function_json(f, c, functions_of); !function.is_null())
                functions.push_back(function);
        std::sort(functions.begin(), functions.end(), [](const json& a, const json& b) {
            return std::tie(a.at("name"), a.at("source").at("line")) <
                   std::tie(b.at("name"), b.at("source").at("line"));
        });
        auto last = std::unique(functions.begin(), functions.end(),
            [](const json& a, const json& b) { return a.at("name") == b.at("name"); });
        functions.erase(last, functions.end()); // overloads were reported
        json source = record_source(c);
        json constructors = json::array();
        for (const Constructor& k : c.constructors)
            constructors.push_back({{"kind", k.kind}, {"access", k.access}, {"line", k.line}, {"deleted", k.deleted},
                {"defaulted", k.defaulted}});
        source.update({{"constructors", constructors}, {"destructor", c.destructor}, {"declares", c.declares}});
        if (info.super_unresolved) {
            source["super_unresolved"] = true;
            note_super(c.line, c.name, info.super);
        }
        if (c.native) {
            const Record& n = *c.native;
            source["interface"] = {{"name", n.name}, {"line", n.line}, {"api", n.api}, {"comment", n.comment},
                {"generated_body", body_json(n.generated_body)}, {"bases", bases_json(n.bases)},
                {"declares", n.declares}};
        }
        return {{"name", c.name}, {"reflected_name", reflected(c.name)},
            {"path", script_path(header_.module, reflected(c.name))}, {"module", header_.module},
            {"super", info.super.empty() ? json(nullptr) : json(info.super)}, {"interfaces", interfaces},
            {"flags", info.flags}, {"within", info.within}, {"config", info.config}, {"functions", functions},
            {"properties", properties_json(c, c.name)}, {"editor", {{"meta", class_meta(c, info, header_)}}},
            {"source", source}};
    }

    // An I base counts as an interface when a UINTERFACE is known for it; otherwise only if the module or engine could
    // have one.
    bool is_reflected_interface(const std::string& name, const Class& c) const {
        if (!registry_.interface_class(name).empty())
            return true;
        if (name.size() < 2 || !std::isupper(static_cast<unsigned char>(name[1])))
            return false;
        report_.note("assumed-type", header_.path, c.line, c.name,
            "base " + name + " is in no schema of this run; it is not listed as a reflected interface");
        return false;
    }

    json struct_json(const Struct& s) const {
        const TypeInfo& info = *registry_.find(s.name);
        json source = record_source(s);
        source["has_defaults"] = s.specifiers.has("HasDefaults");
        if (info.super_unresolved) {
            source["super_unresolved"] = true;
            note_super(s.line, s.name, info.super);
        }
        for (const Function& f : s.functions)
            report_.rule("orphan-macro", header_.path, f.line, s.name + "::" + f.name,
                "a struct cannot have UFUNCTIONs; it is skipped");
        return {{"name", s.name}, {"reflected_name", s.name.substr(1)},
            {"path", script_path(header_.module, s.name.substr(1))}, {"module", header_.module},
            {"super", info.super.empty() ? json(nullptr) : json(info.super)}, {"flags", info.flags},
            {"properties", properties_json(s, "")}, {"editor", {{"meta", struct_meta(s, header_)}}},
            {"source", source}};
    }

    json enum_json(const Enum& e) const {
        json entries = json::array();
        for (const EnumEntry& entry : e.entries)
            entries.push_back({{"name", e.form == "regular" ? entry.name : e.name + "::" + entry.name},
                {"value", entry.value.value_or(0)}, {"editor", {{"meta", enum_entry_meta(e, entry)}}},
                {"source", {{"line", entry.line}, {"comment", entry.comment}, {"value_text", entry.value_text}}}});
        json source = source_of(e);
        source["header"] = header_.relative;
        source["underlying"] = registry_.find(e.name)->underlying;
        json flags = json::array();
        if (e.specifiers.has("Flags"))
            flags.push_back("Flags");
        return {{"name", e.name}, {"reflected_name", e.name}, {"path", script_path(header_.module, e.name)},
            {"module", header_.module}, {"form", e.form}, {"cpp_type", e.cpp_type}, {"flags", flags},
            {"entries", entries}, {"editor", {{"meta", enum_meta(e, header_)}}}, {"source", source}};
    }

    json delegate_json(const Delegate& d) const {
        Signature s = signature(d, d.owner, d.name);
        if (!s.good)
            return nullptr;
        std::string name = (d.name.starts_with("F") ? d.name.substr(1) : d.name) + "__DelegateSignature";
        std::string outer = d.owner.empty() ? script_path(header_.module, name)
                                            : script_path(header_.module, reflected(d.owner)) + ":" + name;
        json source = source_of(d);
        source["header"] = header_.relative;
        source["macro"] = d.macro;
        if (d.kind == "sparse")
            source["sparse"] = {{"owner", d.sparse_owner}, {"property", d.sparse_property}};
        return {{"name", d.name}, {"reflected_name", name}, {"path", outer}, {"module", header_.module},
            {"owner", d.owner.empty() ? json(nullptr) : json(d.owner)}, {"kind", d.kind},
            {"flags", delegate_flags(d, registry_, s.nodes, s.returned ? &*s.returned : nullptr)},
            {"parameters", s.parameters}, {"returns", s.returns}, {"editor", {{"meta", function_meta(d, header_)}}},
            {"source", source}};
    }

    const Header& header_;
    const Registry& registry_;
    Report& report_;
    std::vector<Fragment> fragments_;
};

} // namespace

std::vector<Fragment> emit_header(const Header& header, const Registry& registry, Report& report) {
    return Emitter(header, registry, report).run();
}

void emit_document(std::ostream& out, const std::vector<ModuleInfo>& modules, const std::vector<HeaderEntry>& headers,
    const std::vector<const Fragment*>& fragments) {
    std::map<std::string, json> files; // module -> headers
    for (const HeaderEntry& h : headers)
        files[h.module].push_back(
            {{"path", h.path}, {"include", h.include}, {"generated", h.generated}, {"types", h.types}});
    json list = json::array();
    for (const ModuleInfo& m : modules) {
        if (!m.written)
            continue;
        json own = files.contains(m.name) ? std::move(files[m.name]) : json::array();
        std::sort(own.begin(), own.end(), [](const json& a, const json& b) { return a.at("path") < b.at("path"); });
        json source = {{"path", m.path}, {"headers", std::move(own)}};
        if (!m.build_cs.empty())
            source["build_cs"] = m.build_cs;
        list.push_back({{"name", m.name}, {"source", std::move(source)}});
    }
    std::vector<std::pair<const Fragment*, std::size_t>> sorted; // with its place, which decides between equals
    for (const Fragment* f : fragments)
        sorted.emplace_back(f, sorted.size());
    std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
        return std::tie(a.first->kind, a.first->name, a.first->path, a.second) <
               std::tie(b.first->kind, b.first->name, b.first->path, b.second);
    });
    auto entities = [&](const char* key, Fragment::Kind kind) {
        out << "  \"" << key << "\": [";
        const char* separator = "\n    ";
        for (const auto& [f, place] : sorted)
            if (f->kind == kind) {
                out << separator << f->text;
                separator = ",\n    ";
            }
        out << (*separator == ',' ? "\n  ],\n" : "],\n");
    };
    out << "{\n";
    entities("classes", Fragment::Kind::class_);
    entities("delegates", Fragment::Kind::delegate);
    entities("enums", Fragment::Kind::enum_);
    out << "  \"format\": \"spear-schema\",\n  \"modules\": " << indented(list, 2) << ",\n";
    out << "  \"origin\": \"offline\",\n";
    entities("structs", Fragment::Kind::struct_);
    out << "  \"version\": 1\n}\n";
}

} // namespace spear::header_tool
