// SPDX-License-Identifier: MIT
#include "prelude.h"

#include <algorithm>
#include <array>
#include <limits>

namespace spear::header_tool {

namespace {

constexpr std::string_view fixed_text = R"(
using int8 = signed char; using int16 = short; using int32 = int; using int64 = long long;
using uint8 = unsigned char; using uint16 = unsigned short; using uint32 = unsigned int; using uint64 = unsigned long long;
using TCHAR = char16_t; using ANSICHAR = char; using SIZE_T = unsigned long; using PTRINT = long; using UPTRINT = unsigned long;
using int8_t = signed char; using int16_t = short; using int32_t = int; using int64_t = long long;
using uint8_t = unsigned char; using uint16_t = unsigned short; using uint32_t = unsigned int; using uint64_t = unsigned long long;
using size_t = unsigned long;
template <auto N, class... A> class TInlineAllocator {}; template <auto N> class TFixedAllocator {};
template <auto N, class... A> class TNonRelocatableInlineAllocator {};
#define TEXT(x) u##x
#define INDEX_NONE (-1)
#define MAX_int32 2147483647
#define MIN_int32 (-2147483647 - 1)
#define MAX_uint8 255
#define MAX_uint16 65535
#define MAX_uint32 4294967295u
#define MAX_int8 127
#define MAX_int16 32767
#define MIN_int8 (-128)
#define MIN_int16 (-32768)
#define MAX_int64 9223372036854775807ll
#define MIN_int64 (-9223372036854775807ll - 1)
#define MAX_uint64 18446744073709551615ull
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

std::string literal(long long value) {
    return value == std::numeric_limits<long long>::min() ? "(-9223372036854775807ll - 1)"
                                                          : std::to_string(value) + "ll";
}

// " : uint8 { A = 1, B }": a reflected enum with its values, so that `= EOther::A` and `X[EOther::Count]` can be
// computed.
std::string enum_body(const TypeInfo& info, const Registry& registry) {
    const std::string& type = info.written_underlying;
    std::string out = (type.empty() ? "" : " : " + type) + " { ";
    for (const auto& [name, value] : registry.entries_of(info)) {
        out += name;
        if (value)
            out += " = " + (type.empty() ? "" : "(" + type + ")") + "(" + literal(*value) + ")";
        out += ", ";
    }
    return out + "};\n";
}

// static constexpr members for the constants of a scope.
std::string constant_members(const PreludeConstants& constants, const std::string& scope) {
    std::string out;
    if (auto it = constants.find(scope); it != constants.end())
        for (const auto& [name, value] : it->second)
            out += "static constexpr long long " + name + " = " + literal(value) + "; ";
    return out;
}

std::string declaration(const std::string& name, const Registry& registry, const PreludeConstants& constants) {
    std::size_t colon = name.find("::");
    if (colon != std::string::npos) {
        std::string scope = name.substr(0, colon), rest = name.substr(colon + 2);
        if (rest.find("::") != std::string::npos)
            return {};
        const TypeInfo* info = registry.find(scope);
        if (info && info->kind == TypeKind::enum_ && info->form == "namespaced")
            return "namespace " + scope + " { enum " + rest + enum_body(*info, registry) + "}\n";
        if (scope.starts_with("E") || (info && info->kind == TypeKind::enum_))
            return "namespace " + scope + " { enum " + rest + " : int {}; }\n";
        return "class " + scope + " { public: struct " + rest + " {}; virtual ~" + scope + "(); " +
               constant_members(constants, scope) + "};\n";
    }
    const TypeInfo* info = registry.find(name);
    if (info && info->kind == TypeKind::enum_) {
        if (info->form == "class")
            return "enum class " + name + enum_body(*info, registry);
        if (info->form == "regular")
            return "enum " + name + enum_body(*info, registry);
        return "namespace " + name + " { enum " + info->cpp_type.substr(info->cpp_type.rfind(':') + 1) +
               enum_body(*info, registry) + "}\n";
    }
    if (info && info->kind == TypeKind::struct_)
        return "struct " + name + " { " + name + "(); template <class... A> explicit " + name + "(A&&...); " +
               constant_members(constants, name) + "};\n";
    if (info || (name.size() > 1 && upper(name[1]) && (name[0] == 'U' || name[0] == 'A' || name[0] == 'I')))
        return "class " + name + " { public: " + name + "(); virtual ~" + name + "(); " +
               constant_members(constants, name) + "};\n";
    if (name.size() > 1 && upper(name[1]) && name[0] == 'E')
        return "enum class " + name + " : unsigned char {};\n";
    if (name.size() > 1 && upper(name[1]) && name[0] == 'T')
        return "template <class... A> class " + name + " {};\n";
    return "struct " + name + " { " + name + "(); template <class... A> explicit " + name + "(A&&...); " +
           constant_members(constants, name) + "};\n";
}

// "#define DECLARE_DYNAMIC_DELEGATE_OneParam(Name, T1, P1) struct Name { ... };"
std::string delegate_macro(const Delegate& d) {
    bool returns = d.macro.find("_RetVal") != std::string::npos;
    std::string heads = returns ? "Result, Name" : "Name", parameters;
    if (d.kind == "sparse")
        heads += ", Owner, Member";
    for (int i = 1; i <= d.declared_parameters; ++i) {
        std::string n = std::to_string(i);
        heads += ", T" + n + ", P" + n;
        parameters += (i > 1 ? ", T" : "T") + n + " P" + n;
    }
    return "#define " + d.macro + "(" + heads +
           ") struct Name { Name(); template <class... A> explicit Name(A&&...); " + "static " +
           (returns ? "Result " : "void ") + std::string(delegate_function) + "(" + parameters + "); };\n";
}

} // namespace

bool prelude_knows(const std::string& name) {
    return fixed_text.find("#define " + name + " ") != std::string_view::npos;
}

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
        function(d);
    return names;
}

std::string prelude(const Header& header, const Registry& registry, const std::set<std::string>& names,
    const std::set<std::string>& macros, const PreludeConstants& constants) {
    std::string out(fixed_text);
    std::set<std::string> defined(header.defined_names.begin(), header.defined_names.end()), delegate_macros;
    for (const Delegate& d : header.delegates) {
        if (delegate_macros.insert(d.macro).second)
            out += delegate_macro(d);
        defined.insert(d.name);
    }
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
                    out += declaration(name, registry, constants);
                continue;
            }
            if (!done.insert(scope).second)
                continue;
            out += declaration(name, registry, constants);
        }
    for (const auto& [scope, members] : constants) {
        if (scope.empty())
            out += constant_members(constants, scope) + "\n";
        else if (!done.contains(scope) && !defined.contains(scope) && !known.contains(scope))
            out += declaration(scope, registry, constants);
    }
    return out;
}

} // namespace spear::header_tool
