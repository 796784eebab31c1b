// SPDX-License-Identifier: MIT
#include "prelude.h"

#include <algorithm>
#include <array>

namespace spear::header_tool {

namespace {

constexpr std::string_view fixed_text = R"(
using int8 = signed char; using int16 = short; using int32 = int; using int64 = long long;
using uint8 = unsigned char; using uint16 = unsigned short; using uint32 = unsigned int; using uint64 = unsigned long long;
using TCHAR = char16_t; using ANSICHAR = char; using SIZE_T = unsigned long; using PTRINT = long; using UPTRINT = unsigned long;
using int8_t = signed char; using int16_t = short; using int32_t = int; using int64_t = long long;
using uint8_t = unsigned char; using uint16_t = unsigned short; using uint32_t = unsigned int; using uint64_t = unsigned long long;
using size_t = unsigned long;
#define TEXT(x) u##x
#define INDEX_NONE (-1)
#define MAX_int32 2147483647
#define MIN_int32 (-2147483647 - 1)
#define MAX_uint8 255
#define MAX_uint16 65535
#define MAX_uint32 4294967295u
#define MAX_FLT 3.402823466e+38F
#define FORCEINLINE inline
#define FORCENOINLINE
#define FORCEINLINE_DEBUGGABLE inline
#define UE_NODISCARD
#define PURE_VIRTUAL(...) = 0;
#define CONSTEXPR constexpr
#define RESTRICT
#define VARARGS
#define CDECL
#define NULL 0
#define DECLARE_FUNCTION(Name) static void Name(void* Context, void* Stack, void* RESULT_PARAM)
#define DECLARE_DELEGATE(Name, ...) struct Name {};
#define DECLARE_MULTICAST_DELEGATE(Name, ...) struct Name {};
)";

constexpr std::array<std::string_view, 22> unary_templates{"TArray", "TSet", "TObjectPtr", "TSubclassOf",
    "TSoftObjectPtr", "TSoftClassPtr", "TWeakObjectPtr", "TAutoWeakObjectPtr", "TLazyObjectPtr", "TScriptInterface",
    "TEnumAsByte", "TOptional", "TNonNullPtr", "TFieldPath", "TInstancedStruct", "TSharedPtr", "TSharedRef", "TWeakPtr",
    "TUniquePtr", "TFunction", "TStrongObjectPtr", "TNonNullSubclassOf"};

void collect(const TypeSyntax& type, std::set<std::string>& names) {
    if (!type.is_raw)
        names.insert(type.name);
    for (const TypeSyntax& arg : type.args)
        collect(arg, names);
}

bool upper(char c) { return c >= 'A' && c <= 'Z'; }

// " : uint8 { A = 1, B }": a reflected enum with its values, so that `= EOther::A` and `X[EOther::Count]` can be
// computed.
std::string enum_body(const TypeInfo& info) {
    // A schema calls a regular enum without a written type a byte, its values may be wider.
    std::string type = info.enum_decl ? info.enum_decl->underlying : info.form == "class" ? info.underlying : "";
    std::string out = (type.empty() ? "" : " : " + type) + " { ";
    for (const auto& [name, value] : info.values)
        out += name + " = " + (type.empty() ? "" : "(" + type + ")") + "(" + std::to_string(value) + "ll), ";
    if (info.enum_decl)
        for (const EnumEntry& entry : info.enum_decl->entries)
            out += entry.name + (entry.value_text.empty() ? "" : " = " + entry.value_text) + ", ";
    return out + "};\n";
}

std::string declaration(const std::string& name, const Registry& registry) {
    std::size_t colon = name.find("::");
    if (colon != std::string::npos) {
        std::string scope = name.substr(0, colon), rest = name.substr(colon + 2);
        if (rest.find("::") != std::string::npos)
            return {};
        const TypeInfo* info = registry.find(scope);
        if (info && info->kind == TypeKind::enum_ && info->form == "namespaced")
            return "namespace " + scope + " { enum " + rest + enum_body(*info) + "}\n";
        if (scope.starts_with("E") || (info && info->kind == TypeKind::enum_))
            return "namespace " + scope + " { enum " + rest + " : int {}; }\n";
        return "class " + scope + " { public: struct " + rest + " {}; virtual ~" + scope + "(); };\n";
    }
    const TypeInfo* info = registry.find(name);
    if (info && info->kind == TypeKind::enum_) {
        if (info->form == "class")
            return "enum class " + name + enum_body(*info);
        if (info->form == "regular")
            return "enum " + name + enum_body(*info);
        return "namespace " + name + " { enum " + info->cpp_type.substr(info->cpp_type.rfind(':') + 1) +
               enum_body(*info) + "}\n";
    }
    if (info && info->kind == TypeKind::struct_)
        return "struct " + name + " { " + name + "(); template <class... A> explicit " + name + "(A&&...); };\n";
    if (info || (name.size() > 1 && upper(name[1]) && (name[0] == 'U' || name[0] == 'A' || name[0] == 'I')))
        return "class " + name + " { public: " + name + "(); virtual ~" + name + "(); };\n";
    if (name.size() > 1 && upper(name[1]) && name[0] == 'E')
        return "enum class " + name + " : unsigned char {};\n";
    if (name.size() > 1 && upper(name[1]) && name[0] == 'T')
        return "template <class... A> class " + name + " {};\n";
    return "struct " + name + " { " + name + "(); template <class... A> explicit " + name + "(A&&...); };\n";
}

} // namespace

std::set<std::string> used_names(const Header& header) {
    std::set<std::string> names;
    auto function = [&](const Function& f) {
        collect(f.return_type, names);
        for (const Parameter& p : f.parameters)
            collect(p.type, names);
    };
    auto record = [&](const Record& r) {
        for (const Base& base : r.bases)
            if (base.name.find('<') == std::string::npos)
                names.insert(base.name);
        for (const Function& f : r.functions)
            function(f);
        for (const Property& p : r.properties)
            collect(p.type, names);
    };
    for (const Class& c : header.classes) {
        record(c);
        if (c.native)
            record(*c.native);
    }
    for (const Struct& s : header.structs)
        record(s);
    for (const Delegate& d : header.delegates)
        names.insert(d.name); // its macro is blanked
    return names;
}

std::string prelude(const Header& header, const Registry& registry, const std::set<std::string>& names,
    const std::set<std::string>& macros) {
    std::string out(fixed_text);
    std::set<std::string> defined(header.defined_names.begin(), header.defined_names.end());
    for (std::string_view name : unary_templates)
        if (!defined.contains(std::string(name)))
            out += "template <class T, class... R> class " + std::string(name) + " { public: " + std::string(name) +
                   "(); template <class... A> " + std::string(name) +
                   "(A&&...); T* operator->() const; T& operator[](int) const; T* begin() const; T* end() const; };\n";
    out +=
        "template <class K, class V, class... R> class TMap { public: TMap(); template <class... A> TMap(A&&...); };\n";
    out += "class UClass;\nclass FObjectInitializer;\n";
    // Types of this header may be used above their definition (an include would have declared them).
    for (const Class& c : header.classes) {
        out += "class " + c.name + ";\n";
        if (c.native)
            out += "class " + c.native->name + ";\n";
    }
    for (const Struct& s : header.structs)
        out += "struct " + s.name + ";\n";
    // Before the types: a macro of the same name would break them, and none has one.
    for (const std::string& macro : macros)
        out += "#define " + macro + "\n";
    static const std::set<std::string> known = [] {
        std::set<std::string> names{"TMap", "UClass", "FObjectInitializer", "void", "bool", "float", "double", "int",
            "char", "int8", "int16", "int32", "int64", "uint8", "uint16", "uint32", "uint64", "TCHAR", "ANSICHAR",
            "SIZE_T", "PTRINT", "UPTRINT", "size_t", "auto", "long", "short", "unsigned", "int8_t", "int16_t",
            "int32_t", "int64_t", "uint8_t", "uint16_t", "uint32_t", "uint64_t"};
        names.insert(unary_templates.begin(), unary_templates.end());
        return names;
    }();
    std::set<std::string> done;
    // Qualified names first: they declare their scope.
    for (bool qualified : {true, false})
        for (const std::string& name : names) {
            std::size_t colon = name.find("::");
            if ((colon != std::string::npos) != qualified)
                continue;
            std::string scope = qualified ? name.substr(0, colon) : name;
            bool word = std::all_of(
                name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_' || c == ':'; });
            if (!word || known.contains(name) || defined.contains(scope) || name.find(' ') != std::string::npos)
                continue;
            if (qualified && done.contains(scope)) {
                if (scope.starts_with("E") && !registry.find(scope))
                    out += declaration(name, registry);
                continue;
            }
            if (!done.insert(scope).second)
                continue;
            out += declaration(name, registry);
        }
    return out;
}

} // namespace spear::header_tool
