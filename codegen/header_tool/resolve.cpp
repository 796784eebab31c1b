// SPDX-License-Identifier: MIT
// Registry::resolve: from a written type to the schema's type node.
#include "registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace spear::header_tool {

namespace {

struct Simple {
    std::string_view written, kind, cpp;
};

constexpr std::array<Simple, 18> simple_types{{{"bool", "bool", "bool"}, {"int8", "int8", "int8"},
    {"int16", "int16", "int16"}, {"int32", "int32", "int32"}, {"int64", "int64", "int64"}, {"uint8", "uint8", "uint8"},
    {"uint16", "uint16", "uint16"}, {"uint32", "uint32", "uint32"}, {"uint64", "uint64", "uint64"},
    {"float", "float", "float"}, {"double", "double", "double"}, {"FString", "string", "FString"},
    {"FName", "name", "FName"}, {"FText", "text", "FText"}, {"FUtf8String", "utf8_string", "FUtf8String"},
    {"FAnsiString", "ansi_string", "FAnsiString"}, {"FReal", "double", "double"},
    {"FVector::FReal", "double", "double"}}};

// Engine enums that are regular or namespaced and so are reflected as bytes; used only when no schema of the engine is
// given.
constexpr std::array<std::string_view, 24> byte_enums{"ECollisionChannel", "EObjectTypeQuery", "ETraceTypeQuery",
    "EMovementMode", "ECollisionResponse", "EPhysicalSurface", "EAxis", "ETickingGroup", "EInputEvent",
    "ETextureRenderTargetFormat", "EBlendMode", "EMaterialDomain", "ELightUnits", "EDrawDebugTrace", "EEndPlayReason",
    "EComponentMobility", "ETeleportType", "ESpatialDetailLevel", "ENetRole", "EViewTargetBlendFunction",
    "EMouseCursor", "ECameraProjectionMode", "EMoveComponentAction", "ESuggestProjVelocityTraceOption"};

} // namespace

bool is_intrinsic_class(const std::string& name) {
    static constexpr std::array<std::string_view, 16> names{"UObject", "UInterface", "UField", "UStruct",
        "UScriptStruct", "UClass", "UEnum", "UFunction", "UDelegateFunction", "USparseDelegateFunction", "UPackage",
        "UMetaData", "UTextBuffer", "UDynamicClass", "UPackageMap", "UObjectReferencer"};
    return std::find(names.begin(), names.end(), name) != names.end();
}

namespace {

bool upper_at(const std::string& name, std::size_t i) {
    return name.size() > i && std::isupper(static_cast<unsigned char>(name[i]));
}

bool looks_like_delegate(const std::string& name) {
    return name.ends_with("Delegate") || name.ends_with("Signature") || name.ends_with("Event") ||
           name.ends_with("Callback");
}

TypeNode problem(std::string text) {
    TypeNode node;
    node.problem = std::move(text);
    return node;
}

std::string last_segment(const std::string& name) {
    std::size_t colon = name.rfind("::");
    return colon == std::string::npos ? name : name.substr(colon + 2);
}

} // namespace

TypeNode Registry::resolve_object(
    const TypeSyntax& pointee, const std::string& kind, const std::string& spelling) const {
    std::string name = last_segment(pointee.name);
    if (pointee.is_raw || !pointee.args.empty() || pointee.pointers > 0)
        return problem("'" + pointee.text() + "' is no class name");
    const TypeInfo* info = find(name);
    TypeNode node;
    if (info && info->kind != TypeKind::class_)
        return problem("'" + name + "' is no UObject class");
    if (!info && !is_intrinsic_class(name)) {
        if (!(upper_at(name, 0) && (name[0] == 'U' || name[0] == 'A') && upper_at(name, 1)))
            return problem("'" + name + "' is no known class (and has no U or A prefix)");
        node.assumed = name + " taken for a class by its prefix";
    }
    node.kind = kind;
    node.name = name;
    node.cpp = spelling.empty() ? name + "*" : spelling + "<" + name + ">";
    node.const_argument = pointee.is_const;
    return node;
}

TypeNode Registry::assume(const std::string& name, const TypeSyntax& type, const Use& use) const {
    TypeNode node;
    node.name = name;
    if (type.name.find("::") != std::string::npos) {
        std::string scope = type.name.substr(0, type.name.rfind("::"));
        if (scope.starts_with("E") && upper_at(scope, 1)) {
            node.kind = "byte_enum";
            node.name = scope;
            node.cpp = "TEnumAsByte<" + type.name + ">";
            node.assumed = scope + " taken for a namespaced enum";
            return node;
        }
        if (!(name.starts_with("F") && looks_like_delegate(name)) && !use.event_property)
            return problem("'" + type.name + "' is no type known to reflection");
    }
    bool prefix = upper_at(name, 1);
    if (use.event_property && name.starts_with("F")) {
        node.kind = "multicast_delegate";
        node.cpp = name;
        node.assumed = name + " taken for a multicast delegate (BlueprintAssignable)";
    } else if (prefix && name[0] == 'F' && looks_like_delegate(name)) {
        node.kind = "delegate";
        node.cpp = name;
        node.assumed = name + " taken for a delegate by its name";
    } else if (prefix && name[0] == 'F') {
        node.kind = "struct";
        node.cpp = name;
        node.assumed = name + " taken for a struct by its prefix";
    } else if (prefix && name[0] == 'E') {
        bool byte = std::find(byte_enums.begin(), byte_enums.end(), name) != byte_enums.end();
        node.kind = byte ? "byte_enum" : "enum";
        node.cpp = byte ? "TEnumAsByte<" + name + ">" : name;
        node.underlying = byte ? "" : "uint8";
        node.assumed = name + " taken for " + (byte ? "a byte enum" : "an enum class of uint8");
    } else if (prefix && (name[0] == 'U' || name[0] == 'A')) {
        return problem("objects of class '" + name + "' can only be held by pointer");
    } else {
        return problem("'" + type.bare() + "' is no type known to reflection");
    }
    return node;
}

TypeNode Registry::resolve_name(const std::string& name, const TypeSyntax& type, const Use& use) const {
    for (const Simple& simple : simple_types)
        if (name == simple.written) {
            TypeNode node;
            node.kind = simple.kind;
            node.cpp = simple.cpp;
            if (use.bitfield) {
                if (node.kind != "bool" && node.kind != "uint8" && node.kind != "uint16" && node.kind != "uint32" &&
                    node.kind != "uint64")
                    return problem("a bit-field of type " + name + " cannot be reflected");
                node.kind = "bool";
                node.cpp = "bool";
                node.bitfield = true;
            }
            return node;
        }
    if (name == "FScriptInterface") { // any interface
        TypeNode node;
        node.kind = "interface";
        node.name = "IInterface";
        node.cpp = "TScriptInterface<IInterface>";
        return node;
    }
    if (name.starts_with("FVerse") || name.starts_with("verse::") || name.starts_with("Verse::"))
        return problem("'" + type.bare() + "' is a type of Verse, which Unreal's own compiler binds");
    std::string last = last_segment(name);
    std::string scope = last.size() == name.size() ? "" : name.substr(0, name.size() - last.size() - 2);
    auto enum_node = [](const TypeInfo& info) {
        TypeNode node;
        node.name = info.name;
        if (info.form == "class") {
            node.kind = "enum";
            node.cpp = info.name;
            node.underlying = info.underlying;
        } else {
            node.kind = "byte_enum";
            node.cpp = "TEnumAsByte<" + info.cpp_type + ">";
        }
        return node;
    };
    if (!scope.empty())
        if (const TypeInfo* info = find(scope); info && info->kind == TypeKind::enum_)
            return enum_node(*info);
    std::string owner = scope.empty() ? use.owner : scope;
    bool known_type = find(last) != nullptr;
    if (!known_type || find_delegate(last, owner)) {
        if (const DelegateInfo* d = find_delegate(last, owner)) {
            TypeNode node;
            node.kind = d->kind == "single" ? "delegate" : d->kind + "_delegate";
            node.name = d->name;
            node.owner = d->owner;
            node.cpp = d->name;
            return node;
        }
    }
    if (const TypeInfo* info = find(last)) {
        switch (info->kind) {
        case TypeKind::struct_: {
            TypeNode node;
            node.kind = "struct";
            node.name = node.cpp = info->name;
            node.contains_instanced = info->flags.contains("HasInstancedReference");
            return node;
        }
        case TypeKind::enum_:
            return enum_node(*info);
        case TypeKind::class_:
            return problem("objects of class '" + last + "' can only be held by pointer");
        }
    }
    return assume(last, type, use);
}

TypeNode Registry::resolve(const TypeSyntax& type, const Use& use) const {
    if (type.is_raw)
        return problem("'" + type.name + "' could not be read as a type");
    std::string name = canonical_builtin(type.name);
    if (type.pointers > 1)
        return problem("pointers to pointers cannot be reflected");
    if (type.pointers == 1) {
        if (!type.args.empty())
            return problem("pointers to templates cannot be reflected");
        if (name == "UClass") {
            TypeNode node;
            node.kind = "class";
            node.name = "UObject";
            node.cpp = "TSubclassOf<UObject>";
            return node;
        }
        TypeSyntax pointee = type;
        pointee.pointers = 0;
        TypeNode node = resolve_object(pointee, "object", "");
        node.const_argument = false;
        if (node.kind == "object")
            node.instanced = class_is_instanced(node.name, node.assumed);
        return node;
    }
    if (type.args.empty())
        return resolve_name(name, type, use);

    auto arity = [&](std::size_t least, std::size_t most) {
        return type.args.size() >= least && type.args.size() <= most;
    };
    Use inner_use{use.owner, false, false};
    if (name == "TArray" || name == "TSet" || name == "TOptional" || name == "TMap") {
        bool map = name == "TMap";
        if (!arity(map ? 2 : 1, map ? 3 : 2))
            return problem(fmt::format("{} has {} template arguments", name, type.args.size()));
        TypeNode node;
        node.kind = lower(name.substr(1));
        for (std::size_t i = 0; i < (map ? 2u : 1u); ++i) {
            TypeNode inner = resolve(type.args[i], inner_use);
            if (inner.kind.empty())
                return inner;
            node.contains_instanced |= inner.instanced || inner.contains_instanced;
            node.wrapper |= inner.wrapper;
            node.object_ptr |= inner.object_ptr;
            node.const_argument |= inner.const_argument || (type.args[i].is_const && type.args[i].pointers > 0);
            if (!inner.assumed.empty())
                node.assumed = inner.assumed;
            node.children.push_back(std::move(inner));
        }
        node.cpp = map ? fmt::format("TMap<{}, {}>", node.children[0].cpp, node.children[1].cpp)
                       : fmt::format("{}<{}>", name, node.children[0].cpp);
        return node;
    }
    if (type.args.empty() || !arity(1, 2))
        return problem("'" + type.bare() + "' is no type known to reflection");
    const TypeSyntax& arg = type.args[0];
    TypeNode node;
    if (name == "TObjectPtr" || name == "TNonNullPtr") {
        if (arg.name == "UClass") {
            node.kind = "class";
            node.name = "UObject";
            node.cpp = "TSubclassOf<UObject>";
        } else {
            node = resolve_object(arg, "object", "");
            if (node.kind == "object")
                node.instanced = class_is_instanced(node.name, node.assumed);
        }
        node.wrapper = node.object_ptr = name == "TObjectPtr";
    } else if (name == "TSubclassOf" || name == "TNonNullSubclassOf") {
        node = resolve_object(arg, "class", "TSubclassOf");
        node.wrapper = true;
    } else if (name == "TSoftClassPtr") {
        node = resolve_object(arg, "soft_class", "TSoftClassPtr");
        node.wrapper = true;
    } else if (name == "TSoftObjectPtr") {
        node = resolve_object(arg, "soft_object", "TSoftObjectPtr");
        node.wrapper = true;
    } else if (name == "TWeakObjectPtr" || name == "TAutoWeakObjectPtr") {
        node = resolve_object(arg, "weak_object", "TWeakObjectPtr");
        node.wrapper = true;
        node.auto_weak = name == "TAutoWeakObjectPtr";
    } else if (name == "TLazyObjectPtr") {
        node = resolve_object(arg, "lazy_object", "TLazyObjectPtr");
        node.wrapper = true;
    } else if (name == "TScriptInterface") {
        std::string native = last_segment(arg.name);
        const TypeInfo* info = find(native);
        if (info && info->interface)
            native = "I" + native.substr(1);
        if (!native.starts_with("I") || !upper_at(native, 1))
            return problem("TScriptInterface needs an interface, not '" + native + "'");
        node.kind = "interface";
        node.name = native;
        node.cpp = "TScriptInterface<" + native + ">";
        node.wrapper = true;
        if (interface_class(native).empty())
            node.assumed = native + " taken for an interface by its prefix";
    } else if (name == "TEnumAsByte") {
        TypeNode inner = resolve_name(arg.name, arg, {});
        std::string enum_name = arg.name.substr(0, arg.name.find("::"));
        if (inner.kind.empty() && !find(enum_name) && arg.args.empty() && !arg.is_raw) {
            // Enums without an E prefix exist (TextureFilter).
            inner.kind = "byte_enum";
            inner.name = enum_name;
            inner.cpp = "TEnumAsByte<" + arg.name + ">";
            inner.assumed = enum_name + " taken for an enum inside TEnumAsByte";
        }
        if (inner.kind != "enum" && inner.kind != "byte_enum")
            return problem("TEnumAsByte needs an enum, not '" + arg.text() + "'");
        node.kind = "byte_enum";
        node.name = inner.name;
        node.assumed = inner.assumed;
        node.cpp = inner.kind == "byte_enum" ? inner.cpp : "TEnumAsByte<" + inner.cpp + ">";
    } else if (name == "TFieldPath") {
        node.kind = "field_path";
        node.name = arg.name;
        node.cpp = "TFieldPath<" + arg.name + ">";
    } else if (name == "TInstancedStruct") {
        node.kind = "struct";
        node.name = node.cpp = "FInstancedStruct";
        node.base_struct = arg.name;
    } else {
        return problem("'" + type.bare() + "' is no type known to reflection");
    }
    return node;
}

} // namespace spear::header_tool
