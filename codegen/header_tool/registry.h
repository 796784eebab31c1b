// SPDX-License-Identifier: MIT
// What every type name of the run means: types declared in the read headers, types of imported schemas, and, for names
// that are in neither, a reading of UE's prefixes (reported as assumed).
#pragma once

#include "facts.h"
#include "hash.h"
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
    bool has_defaults = false;                                            // structs
    std::string form, cpp_type, underlying;                               // enums
    std::string written_underlying;                                       // as the header has it, "" if it has none
    std::vector<std::pair<std::string, std::optional<long long>>> values; // entries by short name, in order
    // Declared by a header of this run: its path, and its facts; null and "" for imports.
    const RecordFacts* record = nullptr;
    const EnumFacts* enumeration = nullptr;
    std::string path;
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

// Which facts of other headers were asked for while one header was worked on, by name ("type AActor"). As long as each
// of them is what it was, so is the result.
using Trace = std::set<std::string>;

class Registry {
public:
    // Takes the types of a schema file written earlier. Throws std::runtime_error naming the file when it is no schema.
    void import_schema(const nlohmann::json& schema, const std::string& file);
    // Takes all declarations of a header; they must outlive the registry. Reports duplicates.
    void add(const HeaderFacts& facts, const std::string& module, const std::string& path, Report& report);
    // Constants of a header without reflected types.
    void add_constants(const std::vector<ConstantFacts>& constants);
    // True when an enumerator or constant has this name (its last part).
    bool explains(const std::string& name) const;
    // Computes what types hand down to each other, and the values of enumerators. Call once, after the last add().
    void finish(Report& report);

    // From now on, this thread's questions are noted in `trace`; null stops it.
    static void set_trace(Trace* trace);
    // What the answer to a noted question is now.
    Hash fact(const std::string& question) const;

    const TypeInfo* find(const std::string& name) const;
    // The entries of an enum and their values, in order.
    const std::vector<std::pair<std::string, std::optional<long long>>>& entries_of(const TypeInfo& info) const;
    // The declaration that counts when a name is declared twice.
    bool is_kept(const std::string& name, const std::string& path, unsigned line) const;
    // True when a class has a UFUNCTION of this name (without case), its super classes not counted.
    bool class_has_function(const std::string& name, const std::string& function) const;
    // Names of the enums with such an entry, sorted.
    std::vector<std::string> enums_with_entry(const std::string& entry) const;
    // The value of an integer constant expression whose parts are enumerators and constants of any header. `scope`: the
    // class or enum in which it stands, or "".
    std::optional<long long> evaluate(const std::string& expression, const std::string& scope) const;
    // The value of one name of such an expression.
    std::optional<long long> constant(const std::string& name, const std::string& scope) const;
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
    bool closed() const { return find("UObject") != nullptr; }

private:
    struct Constant {
        std::string text;
        bool ambiguous = false; // defined differently in two headers
    };

    static void note(const char* kind, const std::string& name);
    const TypeInfo* peek(const std::string& name) const;
    std::optional<long long> name_value(const std::string& name, const std::string& scope, int depth) const;
    std::optional<long long> constant_value(const std::string& name, int depth) const;
    void compute_enum(TypeInfo& info);
    void finish_classes(Report& report);
    void finish_structs();

    TypeNode resolve_name(const std::string& name, const TypeSyntax& type, const Use& use) const;
    TypeNode resolve_object(const TypeSyntax& pointee, const std::string& kind, const std::string& spelling) const;
    TypeNode assume(const std::string& name, const TypeSyntax& type, const Use& use) const;
    void finish_class(TypeInfo& info, std::set<std::string>& open, Report& report);
    bool class_is_instanced(const std::string& name, std::string& assumed) const;
    bool compute_struct_instanced(const std::string& name, std::set<std::string>& open);
    bool type_is_instanced(const TypeSyntax& type, const std::string& owner) const;

    std::map<std::string, TypeInfo> types_;
    std::map<std::string, std::string> interfaces_; // IFoo -> UFoo
    std::multimap<std::string, DelegateInfo> delegates_;
    std::map<std::string, std::set<std::string>> entries_; // of all enums: entry -> names of enums
    std::map<std::string, Constant> constants_;
    std::set<std::string> constant_names_; // their last parts
    std::set<std::string> computed_enums_; // finished, or being computed
};

} // namespace spear::header_tool
