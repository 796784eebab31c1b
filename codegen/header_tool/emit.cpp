// SPDX-License-Identifier: MIT
#include "emit.h"

#include "flags.h"
#include "metadata.h"
#include "strict.h"

#include <fmt/format.h>

#include <algorithm>
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

std::string script_path(const std::string& module, const std::string& name) { return "/Script/" + module + "." + name; }

class Emitter {
public:
    Emitter(const Header& header, const Registry& registry, Report& report)
        : header_(header), registry_(registry), report_(report) {}

    HeaderJson run() {
        HeaderJson out;
        for (const Class& c : header_.classes)
            if (mine(c.name, &c))
                out.classes.push_back(class_json(c));
        for (const Struct& s : header_.structs)
            if (mine(s.name, &s))
                out.structs.push_back(struct_json(s));
        for (const Enum& e : header_.enums)
            if (mine(e.name, &e))
                out.enums.push_back(enum_json(e));
        for (const Delegate& d : header_.delegates)
            out.delegates.push_back(delegate_json(d));
        return out;
    }

private:
    // False for a second declaration of a name (already reported).
    bool mine(const std::string& name, const void* declaration) const {
        const TypeInfo* info = registry_.find(name);
        return info &&
               (info->class_decl == declaration || info->struct_decl == declaration || info->enum_decl == declaration);
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

    // 1 without a C array; the dimension's value if it is a number or a known enumerator.
    int array_dim(const std::string& text, unsigned line, const std::string& subject) const {
        if (text.empty())
            return 1;
        char* stop = nullptr;
        long value = std::strtol(text.c_str(), &stop, 0);
        if (*stop == '\0' && value > 0)
            return static_cast<int>(value);
        std::string word;
        for (char c : text) {
            if (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == ':')
                word += c;
            else
                word.clear();
        }
        std::string entry = word.substr(word.rfind(':') + 1);
        std::string scope = word.find("::") == std::string::npos ? "" : word.substr(0, word.find("::"));
        for (const auto& [name, info] : registry_.types())
            if (info.enum_decl && (scope.empty() || scope == name) && info.entries.contains(entry))
                for (const EnumEntry& e : info.enum_decl->entries)
                    if (e.name == entry && e.value.value_or(0) > 0)
                        return static_cast<int>(*e.value);
        report_.warning("unresolved-type", header_.path, line, subject,
            fmt::format("array dimension '{}' is unknown here; 1 is written", text));
        return 1;
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
                {"array_dim", array_dim(p.array_text, f.line, subject)}, {"editor", editor}, {"source", source}});
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

    json property_json(const Property& p, const std::string& owner, const std::string& type_name) const {
        std::string subject = type_name + "::" + p.cpp_name;
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
            {"array_dim", p.array_size ? *p.array_size : array_dim(p.array_text, p.line, subject)},
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
                const TypeInfo* info = registry_.find(owner);
                bool is = info && info->class_decl && info->class_decl->declares.contains("Is" + plain);
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
            if (json property = property_json(p, owner, r.name); !property.is_null())
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
};

} // namespace

HeaderJson emit_header(const Header& header, const Registry& registry, Report& report) {
    return Emitter(header, registry, report).run();
}

json emit_document(const std::vector<ModuleInfo>& modules, const std::vector<std::unique_ptr<Header>>& headers,
    std::vector<HeaderJson>& parts) {
    json list = json::array();
    for (const ModuleInfo& m : modules) {
        json files = json::array();
        for (const auto& h : headers)
            if (h->module == m.name && h->reflected)
                files.push_back({{"path", h->relative}, {"include", h->include}, {"generated", h->generated},
                    {"types", h->type_names}});
        std::sort(files.begin(), files.end(), [](const json& a, const json& b) { return a.at("path") < b.at("path"); });
        json source = {{"path", m.path}, {"headers", files}};
        if (!m.build_cs.empty())
            source["build_cs"] = m.build_cs;
        list.push_back({{"name", m.name}, {"source", source}});
    }
    auto sorted = [](std::vector<json>& items) {
        std::erase_if(items, [](const json& item) { return item.is_null(); });
        std::sort(items.begin(), items.end(), [](const json& a, const json& b) {
            return std::tie(a.at("name").get_ref<const std::string&>(), a.at("path").get_ref<const std::string&>()) <
                   std::tie(b.at("name").get_ref<const std::string&>(), b.at("path").get_ref<const std::string&>());
        });
        return json(std::move(items));
    };
    std::vector<json> classes, structs, enums, delegates;
    auto move_all = [](std::vector<json>& from, std::vector<json>& to) {
        std::move(from.begin(), from.end(), std::back_inserter(to));
    };
    for (HeaderJson& part : parts) {
        move_all(part.classes, classes);
        move_all(part.structs, structs);
        move_all(part.enums, enums);
        move_all(part.delegates, delegates);
    }
    return {{"format", "spear-schema"}, {"version", 1}, {"origin", "offline"}, {"modules", list},
        {"classes", sorted(classes)}, {"structs", sorted(structs)}, {"enums", sorted(enums)},
        {"delegates", sorted(delegates)}};
}

} // namespace spear::header_tool
