// SPDX-License-Identifier: MIT
#include "flags.h"

#include <algorithm>
#include <array>

namespace spear::header_tool {

namespace {

constexpr std::array<std::string_view, 20> plain_class_flags{"Abstract", "Const", "Transient", "Optional",
    "DefaultToInstanced", "Hidden", "HideDropDown", "Deprecated", "EditInlineNew", "CollapseCategories",
    "PerObjectConfig", "PerPlatformConfig", "DefaultConfig", "GlobalUserConfig", "ProjectUserConfig",
    "ConfigDoNotCheckDefaults", "NeedsDeferredDependencyLoading", "CustomConstructor", "NoExport", "MinimalAPI"};

constexpr std::array<std::string_view, 14> plain_property_flags{"Transient", "DuplicateTransient",
    "TextExportTransient", "NonPIEDuplicateTransient", "NoClear", "EditFixedSize", "NonTransactional",
    "BlueprintAssignable", "BlueprintCallable", "BlueprintAuthorityOnly", "AssetRegistrySearchable", "SimpleDisplay",
    "AdvancedDisplay", "SaveGame"};

// Core structs that UE declares HasDefaults; used only when no schema declares them.
constexpr std::array<std::string_view, 24> core_defaults{"FVector", "FVector4", "FVector2D", "FTwoVectors", "FPlane",
    "FRotator", "FQuat", "FTransform", "FLinearColor", "FColor", "FIntPoint", "FIntVector", "FBox", "FBox2D",
    "FBoxSphereBounds", "FMatrix", "FGuid", "FDateTime", "FTimespan", "FVector3f", "FVector2f", "FRotator3f", "FQuat4f",
    "FTransform3f"};

bool falsy(const std::string& value) { return equals_no_case(value, "false") || value == "0"; }

} // namespace

const Flags& inherited_class_flags() {
    static const Flags flags{"Transient", "DefaultConfig", "Config", "PerObjectConfig", "ConfigDoNotCheckDefaults",
        "NotPlaceable", "Const", "HasInstancedReference", "Deprecated", "DefaultToInstanced", "GlobalUserConfig",
        "ProjectUserConfig", "PerPlatformConfig", "Optional", "EditInlineNew", "CollapseCategories", "Hidden"};
    return flags;
}

Flags own_class_flags(const Class& c, Flags& removed) {
    Flags flags;
    for (std::string_view flag : plain_class_flags)
        if (c.specifiers.has(flag))
            flags.emplace(flag);
    auto drop = [&](std::string_view specifier, std::string_view flag) {
        if (c.specifiers.has(specifier)) {
            flags.erase(std::string(flag));
            removed.emplace(flag);
        }
    };
    if (c.specifiers.has("NotPlaceable") || flags.contains("Deprecated") || c.name.find("DEPRECATED_") == 1)
        flags.insert("NotPlaceable");
    if (c.name.find("DEPRECATED_") == 1)
        flags.insert("Deprecated");
    if (c.specifiers.has("NeedsDeferredDependencyLoading"))
        flags.insert("NeedsDeferredDependencyLoading");
    drop("NonTransient", "Transient");
    drop("NotEditInlineNew", "EditInlineNew");
    drop("DontCollapseCategories", "CollapseCategories");
    drop("Placeable", "NotPlaceable");
    drop("NonOptional", "Optional");
    if (c.interface) {
        flags.insert("Interface");
        flags.insert("Abstract");
    }
    if (!c.api.empty())
        flags.insert("RequiredAPI");
    return flags;
}

Flags own_struct_flags(const Struct& s) {
    Flags flags;
    for (std::string_view flag : {"Atomic", "Immutable", "NoExport"})
        if (s.specifiers.has(flag))
            flags.emplace(flag);
    if (flags.contains("Immutable"))
        flags.insert("Atomic");
    if (!s.api.empty())
        flags.insert("RequiredAPI");
    return flags;
}

bool is_rpc(const Function& f) {
    return f.specifiers.has("Server") || f.specifiers.has("Client") || f.specifiers.has("NetMulticast") ||
           f.specifiers.has("ServiceRequest") || f.specifiers.has("ServiceResponse");
}

bool struct_has_defaults(const Registry& registry, const std::string& name) {
    if (const TypeInfo* info = registry.find(name))
        return info->has_defaults;
    return std::find(core_defaults.begin(), core_defaults.end(), name) != core_defaults.end();
}

namespace {

void add_type_flags(Flags& flags, const TypeNode& node, bool member) {
    if (node.instanced) {
        flags.insert("InstancedReference");
        if (member)
            flags.insert("ExportObject");
    }
    if (node.contains_instanced) {
        flags.insert("ContainsInstancedReference");
        if (member && node.is_container()) {
            auto holds_object = [](const TypeNode& n, auto& self) -> bool {
                if (n.instanced)
                    return true;
                return std::any_of(
                    n.children.begin(), n.children.end(), [&](const TypeNode& child) { return self(child, self); });
            };
            if (holds_object(node, holds_object))
                flags.insert("ExportObject");
        }
    }
    if (node.wrapper)
        flags.insert("UObjectWrapper");
    if (node.object_ptr)
        flags.insert("TObjectPtr");
    if (node.auto_weak)
        flags.insert("AutoWeak");
}

} // namespace

Flags parameter_flags(
    const TypeSyntax& type, const TypeNode& node, const Specifiers& specifiers, bool is_return, bool rpc) {
    Flags flags{"Parm", "NativeAccessSpecifierPublic"};
    bool reference = type.reference == Reference::lvalue;
    bool string = node.kind == "string" || node.kind == "utf8_string" || node.kind == "ansi_string";
    if (is_return) {
        flags.insert("OutParm");
        flags.insert("ReturnParm");
        if (type.is_const && reference && !string)
            flags.insert("ReferenceParm");
        if (type.is_const && !(string && reference))
            flags.insert("ConstParm");
    } else if (reference && type.is_const) {
        if (!string) { // const FString& counts as passed by value
            flags.insert("ConstParm");
            flags.insert("ReferenceParm");
            if (!rpc)
                flags.insert("OutParm");
        }
    } else if (reference) {
        flags.insert("OutParm");
        if (specifiers.has("ref"))
            flags.insert("ReferenceParm");
    } else if (type.is_const) {
        flags.insert("ConstParm");
    }
    if (!is_return && specifiers.has("const"))
        flags.insert("ConstParm");
    if (specifiers.has("Required"))
        flags.insert("RequiredParm");
    if (specifiers.has("NotReplicated"))
        flags.insert("RepSkip");
    add_type_flags(flags, node, false);
    return flags;
}

namespace {

void add_signature_flags(Flags& flags, const Registry& registry,
    const std::vector<std::pair<Flags, TypeNode>>& parameters, const std::pair<Flags, TypeNode>* returns) {
    for (const auto& [parameter, node] : parameters) {
        if (parameter.contains("OutParm"))
            flags.insert("HasOutParms");
        if (node.kind == "struct" && struct_has_defaults(registry, node.name))
            flags.insert("HasDefaults");
    }
    if (returns && returns->second.kind == "struct" && struct_has_defaults(registry, returns->second.name))
        flags.insert("HasDefaults");
}

} // namespace

Flags function_flags(const Function& f, const FunctionContext& context,
    const std::vector<std::pair<Flags, TypeNode>>& parameters, const std::pair<Flags, TypeNode>* returns) {
    const Specifiers& s = f.specifiers;
    Flags flags;
    if (context.in_interface)
        flags.insert("Public");
    else
        flags.insert(f.access == Access::public_ ? "Public" : f.access == Access::protected_ ? "Protected" : "Private");
    bool implementable = s.has("BlueprintImplementableEvent"), native_event = s.has("BlueprintNativeEvent");
    if (!implementable)
        flags.insert("Native");
    if (implementable || native_event) {
        flags.insert("Event");
        flags.insert("BlueprintEvent");
    }
    if (is_rpc(f)) {
        flags.insert("Event");
        flags.insert("Net");
        if (s.has("Server"))
            flags.insert("NetServer");
        if (s.has("Client"))
            flags.insert("NetClient");
        if (s.has("NetMulticast"))
            flags.insert("NetMulticast");
        if (s.has("ServiceRequest"))
            flags.insert({"NetReliable", "NetRequest"});
        if (s.has("ServiceResponse"))
            flags.insert({"NetReliable", "NetResponse"});
        if (s.has("Reliable"))
            flags.insert("NetReliable");
    }
    if (s.has("WithValidation"))
        flags.insert("NetValidate");
    bool is_virtual = f.is_virtual || f.is_override;
    if ((!is_virtual && !implementable && !native_event && !context.in_interface) || f.is_final || s.has("SealedEvent"))
        flags.insert("Final");
    if (f.is_static)
        flags.insert("Static");
    if (f.is_const || context.const_class)
        flags.insert("Const");
    for (std::string_view flag : {"Exec", "BlueprintAuthorityOnly", "BlueprintCosmetic"})
        if (s.has(flag))
            flags.emplace(flag);
    const Specifier* pure = s.find("BlueprintPure");
    bool impure = pure && pure->value && falsy(*pure->value);
    bool is_pure = (pure && !impure) || s.has("BlueprintGetter");
    if (s.has("BlueprintCallable") || is_pure || s.has("BlueprintSetter"))
        flags.insert("BlueprintCallable");
    add_signature_flags(flags, context.registry, parameters, returns);
    bool outputs = returns != nullptr || flags.contains("HasOutParms");
    if (is_pure || (flags.contains("BlueprintCallable") && flags.contains("Const") && outputs && !impure))
        flags.insert("BlueprintPure");
    if (f.conditions.editor_only)
        flags.insert("EditorOnly");
    return flags;
}

Flags delegate_flags(const Delegate& d, const Registry& registry,
    const std::vector<std::pair<Flags, TypeNode>>& parameters, const std::pair<Flags, TypeNode>* returns) {
    Flags flags{"Public", "Delegate"};
    if (d.kind != "single")
        flags.insert("MulticastDelegate");
    add_signature_flags(flags, registry, parameters, returns);
    if (d.conditions.editor_only)
        flags.insert("EditorOnly");
    return flags;
}

Flags property_flags(const Property& p, const TypeNode& node) {
    const Specifiers& s = p.specifiers;
    Flags flags;
    auto edit = [&](std::string_view specifier, std::initializer_list<const char*> names) {
        if (s.has(specifier))
            flags.insert(names.begin(), names.end());
    };
    edit("EditAnywhere", {"Edit"});
    edit("EditInstanceOnly", {"Edit", "DisableEditOnTemplate"});
    edit("EditDefaultsOnly", {"Edit", "DisableEditOnInstance"});
    edit("VisibleAnywhere", {"Edit", "EditConst"});
    edit("VisibleInstanceOnly", {"Edit", "EditConst", "DisableEditOnTemplate"});
    edit("VisibleDefaultsOnly", {"Edit", "EditConst", "DisableEditOnInstance"});
    edit("BlueprintReadWrite", {"BlueprintVisible"});
    edit("BlueprintReadOnly", {"BlueprintVisible", "BlueprintReadOnly"});
    edit("BlueprintSetter", {"BlueprintVisible"});
    edit("BlueprintGetter", {"BlueprintVisible"});
    if (s.has("BlueprintGetter") && !s.has("BlueprintSetter") && !s.has("BlueprintReadWrite"))
        flags.insert("BlueprintReadOnly");
    edit("Interp", {"Edit", "BlueprintVisible", "Interp"});
    edit("Config", {"Config"});
    edit("GlobalConfig", {"Config", "GlobalConfig"});
    edit("Replicated", {"Net"});
    edit("ReplicatedUsing", {"Net", "RepNotify"});
    edit("NotReplicated", {"RepSkip"});
    edit("Export", {"ExportObject"});
    edit("SkipSerialization", {"SkipSerialization"});
    for (std::string_view flag : plain_property_flags)
        if (s.has(flag))
            flags.emplace(flag);
    if (s.has("Instanced"))
        flags.insert({"ExportObject", node.is_container() ? "ContainsInstancedReference" : "InstancedReference",
            "PersistentInstance"});
    auto expose = s.meta.find("ExposeOnSpawn");
    if (expose != s.meta.end() && !falsy(expose->second))
        flags.insert("ExposeOnSpawn");
    switch (p.access) {
    case Access::public_:
        flags.insert("NativeAccessSpecifierPublic");
        break;
    case Access::protected_:
        flags.insert({"NativeAccessSpecifierProtected", "Protected"});
        break;
    case Access::private_:
        flags.insert("NativeAccessSpecifierPrivate");
        break;
    }
    if (p.conditions.editor_only)
        flags.insert("EditorOnly");
    if (p.cpp_name.ends_with("_DEPRECATED"))
        flags.insert("Deprecated");
    if (p.type.is_const)
        flags.insert("ConstParm");
    add_type_flags(flags, node, true);
    return flags;
}

namespace {

// Metadata that UHT takes as a specifier of any declaration.
bool metadata_keyword(std::string_view key) {
    static constexpr std::array<std::string_view, 14> names{"DisplayName", "FriendlyName", "BlueprintInternalUseOnly",
        "BlueprintType", "NotBlueprintType", "Blueprintable", "NotBlueprintable", "CallInEditor", "Category",
        "Experimental", "EarlyAccessPreview", "DocumentationPolicy", "ToolTip", "Keywords"};
    return std::any_of(names.begin(), names.end(), [&](std::string_view name) { return equals_no_case(name, key); });
}

template <std::size_t N>
bool listed(const std::array<std::string_view, N>& names, std::string_view key) {
    return std::any_of(names.begin(), names.end(), [&](std::string_view name) { return equals_no_case(name, key); });
}

} // namespace

bool known_property_specifier(std::string_view key) {
    static constexpr std::array<std::string_view, 37> more{"EditAnywhere", "EditInstanceOnly", "EditDefaultsOnly",
        "VisibleAnywhere", "VisibleInstanceOnly", "VisibleDefaultsOnly", "BlueprintReadWrite", "BlueprintReadOnly",
        "BlueprintSetter", "BlueprintGetter", "Interp", "Config", "GlobalConfig", "Localized", "Replicated",
        "ReplicatedUsing", "NotReplicated", "Export", "SkipSerialization", "Instanced", "Getter", "Setter",
        "FieldNotify", "Category", "DisplayName", "Native", "RepRetry", "EditInline", "DuplicateTransient", "ToolTip",
        "EditorOnly", "Input", "Const", "ShowInTreeTitle", "AllowEditInlineCustomization", "Units", "NonNullable"};
    return listed(plain_property_flags, key) || listed(more, key) || metadata_keyword(key);
}

bool known_function_specifier(std::string_view key) {
    static constexpr std::array<std::string_view, 31> names{"BlueprintAuthorityOnly", "BlueprintCallable",
        "BlueprintCosmetic", "BlueprintGetter", "BlueprintImplementableEvent", "BlueprintInternalUseOnly",
        "BlueprintNativeEvent", "BlueprintPure", "BlueprintSetter", "CallInEditor", "Client", "CustomThunk", "Exec",
        "NetMulticast", "Reliable", "SealedEvent", "Server", "ServiceRequest", "ServiceResponse", "Unreliable",
        "WithValidation", "FieldNotify", "Category", "DisplayName", "Final", "CustomEvent", "Variadic", "ToolTip",
        "Keywords", "Blueprintable", "DefaultToSelf"};
    return listed(names, key) || metadata_keyword(key);
}

bool known_class_specifier(std::string_view key) {
    static constexpr std::array<std::string_view, 49> names{"NonTransient", "NotEditInlineNew",
        "DontCollapseCategories", "NotPlaceable", "Placeable", "NonOptional", "Within", "Config", "HideCategories",
        "ShowCategories", "HideFunctions", "ShowFunctions", "AutoExpandCategories", "AutoCollapseCategories",
        "DontAutoCollapseCategories", "ClassGroup", "PrioritizeCategories", "SparseClassDataType",
        "SparseClassDataTypes", "Blueprintable", "NotBlueprintable", "BlueprintType", "NotBlueprintType",
        "ComponentWrapperClass", "ConversionRoot", "Experimental", "EarlyAccessPreview", "AdvancedClassDisplay",
        "DependsOn", "Intrinsic", "CustomThunkTemplates", "CustomFieldNotify", "EditorConfig", "MatchedSerializers",
        "SortedCategories", "DisplayName", "Category", "Kismet", "DontUseGenericSpawnObject", "Native", "Parsed",
        "Internal", "CannotImplementInterfaceInBlueprint", "ConversionRootClass", "PerObjectConfigEx", "ToolTip",
        "Interface", "Meta", "NotConfig"};
    return listed(plain_class_flags, key) || listed(names, key) || metadata_keyword(key);
}

bool known_struct_specifier(std::string_view key) {
    static constexpr std::array<std::string_view, 14> names{"Atomic", "Immutable", "NoExport", "BlueprintType",
        "NotBlueprintType", "HasDefaults", "HasNoOpConstructor", "IsAlwaysAccessible", "IsCoreType", "DisplayName",
        "Category", "ToolTip", "BlueprintInternalUseOnly", "BlueprintInternalUseOnlyHierarchical"};
    return listed(names, key) || metadata_keyword(key);
}

bool known_enum_specifier(std::string_view key) {
    static constexpr std::array<std::string_view, 7> names{
        "BlueprintType", "NotBlueprintType", "Blueprintable", "Flags", "DisplayName", "Category", "ToolTip"};
    return listed(names, key) || metadata_keyword(key);
}

} // namespace spear::header_tool
