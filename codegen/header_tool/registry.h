// SPDX-License-Identifier: MIT
// What every type name of the run means: types declared in the read headers, types of imported schemas, and, for names
// that are in neither, a reading of UE's prefixes (reported as assumed).
#pragma once

#include "model.h"
#include "report.h"

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace spear::header_tool {

enum class TypeKind { class_, struct_, enum_ };

struct TypeInfo {
    TypeKind kind = TypeKind::class_;
    std::string name, module;
    std::string super;                                     // "" for none
    std::set<std::string> flags;                           // effective (classes, structs)
    std::string within, config;                            // effective, classes
    std::string hide_categories, auto_collapse_categories; // effective, blank-separated
    bool interface = false;
    bool super_unresolved = false;
    bool has_defaults = false;                             // structs
    std::string form, cpp_type, underlying;                // enums
    std::set<std::string> entries;                         // short names, enums
    std::vector<std::pair<std::string, long long>> values; // of imported enums, in order
    // Declaration of this run, null for imports.
    const Class* class_decl = nullptr;
    const Struct* struct_decl = nullptr;
    const Enum* enum_decl = nullptr;
    const Header* header = nullptr;
};

struct DelegateInfo {
    std::string name, owner, kind;
};

// A resolved type as the schema holds it.
struct TypeNode {
    std::string kind; // "" when the type cannot be reflected; `problem` says why
    std::string cpp, name, underlying, owner;
    bool bitfield = false;
    std::vector<TypeNode> children; // inner; or key, value
    std::string problem;
    std::string assumed; // what was read from a prefix only
    // What UHT derives from the type:
    bool instanced = false;          // an object of a DefaultToInstanced class
    bool contains_instanced = false; // a container or struct with such an object
    bool wrapper = false, object_ptr = false, auto_weak = false;
    bool const_argument = false; // TArray<const X*>
    std::string base_struct;     // TInstancedStruct<F>

    bool is_container() const { return kind == "array" || kind == "set" || kind == "map" || kind == "optional"; }
};

// Classes that no header declares with a macro and no schema holds: UClass, UPackage, UInterface...
bool is_intrinsic_class(const std::string& name);

class Registry {
public:
    // Takes the types of a schema file written earlier. Throws std::runtime_error naming the file when it is no schema.
    void import_schema(const nlohmann::json& schema, const std::string& file);
    // Takes all declarations of the headers; they must outlive the registry. Reports duplicates.
    void add(const Header& header, Report& report);
    // Computes what types hand down to each other. Call once, after the last add().
    void finish(Report& report);

    const TypeInfo* find(const std::string& name) const;
    // The U name behind an I name, "" if unknown.
    std::string interface_class(const std::string& native) const;
    // `owner`: the class whose scope the name is used in, or "".
    const DelegateInfo* find_delegate(const std::string& name, const std::string& owner) const;
    bool is_child_of(const std::string& name, const std::string& ancestor) const;

    struct Use {
        std::string owner;           // class in whose scope the type is written
        bool event_property = false; // BlueprintAssignable: an unknown F name is a multicast delegate
        bool bitfield = false;
    };
    TypeNode resolve(const TypeSyntax& type, const Use& use) const;

    // True when UObject itself is known: then every type of the run has to be, and an assumed one is an error with
    // --strict.
    bool closed() const { return types_.contains("UObject"); }

    const std::map<std::string, TypeInfo>& types() const { return types_; }

private:
    TypeNode resolve_name(const std::string& name, const TypeSyntax& type, const Use& use) const;
    TypeNode resolve_object(const TypeSyntax& pointee, const std::string& kind, const std::string& spelling) const;
    TypeNode assume(const std::string& name, const TypeSyntax& type, const Use& use) const;
    void finish_class(TypeInfo& info, std::set<std::string>& open, Report& report);
    bool class_is_instanced(const std::string& name, std::string& assumed) const;
    bool compute_struct_instanced(const std::string& name, std::set<std::string>& open);
    bool property_is_instanced(const Property& p, const std::string& owner) const;

    std::map<std::string, TypeInfo> types_;
    std::map<std::string, std::string> interfaces_; // IFoo -> UFoo
    std::multimap<std::string, DelegateInfo> delegates_;
};

} // namespace spear::header_tool
