// SPDX-License-Identifier: MIT
// What one header declares, as plain data: filled by the declaration parser from text, checked against the AST, then
// resolved and written.
#pragma once

#include "text.h"
#include "type_syntax.h"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace spear::header_tool {

// One item of a macro's arguments: `EditAnywhere`, `Category = "X"`, `hidecategories=(A, B)`.
struct Specifier {
    std::string key;
    std::optional<std::string> value; // quotes removed, escapes resolved
    std::vector<std::string> list;    // the values of a parenthesised list
};

struct Specifiers {
    std::string raw; // text between the outer parentheses, comments removed, white space normalised
    std::vector<Specifier> items;
    std::map<std::string, std::string> meta; // from meta=(...), keys in Epic's spelling

    const Specifier* find(std::string_view key) const; // without case
    bool has(std::string_view key) const { return find(key) != nullptr; }
};

enum class Access { public_, protected_, private_ };
std::string to_string(Access access);

// The preprocessor conditions a declaration stands under.
struct Conditions {
    bool editor_only = false;
    bool in_function_of_cpp = false;    // under #if !CPP
    std::vector<std::string> arbitrary; // conditions that UHT does not know, "#if" text
};

struct Declared {
    std::size_t macro_offset = 0; // of the UPROPERTY/UFUNCTION/UCLASS... token
    std::size_t name_offset = 0;
    unsigned line = 0;   // of the name
    std::string comment; // raw, "" if none
    Specifiers specifiers;
    Conditions conditions;
};

struct Property : Declared {
    std::string cpp_name;
    TypeSyntax type;
    std::string type_text;
    std::string array_text;
    ByteRange array_range;         // of array_text
    std::optional<int> array_size; // computed
    std::optional<std::string> bits;
    std::optional<std::string> default_text;
    Access access = Access::public_;
    bool is_mutable = false;
};

struct Parameter {
    std::string name;
    std::size_t name_offset = 0;
    TypeSyntax type;
    std::string type_text;
    std::string array_text;
    std::optional<std::string> default_text;
    Specifiers specifiers; // UPARAM
};

struct Function : Declared {
    std::string name;
    TypeSyntax return_type; // name "void" for none
    std::string return_text;
    Specifiers return_specifiers; // UPARAM before the return type
    std::vector<Parameter> parameters;
    Access access = Access::public_;
    bool is_virtual = false, is_static = false, is_const = false, is_override = false, is_final = false,
         is_inline = false, is_pure = false;
    std::string api;
    std::string deprecated;
};

struct Delegate : Function {
    std::string owner; // class in whose body it stands
    std::string kind;  // single, multicast, sparse
    std::string macro;
    std::size_t macro_token = 0; // offset of DECLARE_DYNAMIC_...; macro_offset is that of a UDELEGATE before it
    std::string sparse_owner, sparse_property;
    int declared_parameters = -1; // count the macro's name promises
};

struct Base {
    std::string name, access, text;
};

struct GeneratedBody {
    std::string macro;
    std::string access; // in force where the macro stands; UHT's macro ends with it
    unsigned line = 0;
};

struct Constructor {
    std::string kind, access;
    unsigned line = 0;
    bool deleted = false, defaulted = false;
};

// A class, struct or interface body.
struct Record : Declared {
    std::string name;
    std::string api;
    std::vector<Base> bases;
    bool is_final = false;
    bool in_namespace = false;
    bool has_body = false;
    std::optional<GeneratedBody> generated_body;
    std::vector<Constructor> constructors;
    bool destructor = false;
    std::set<std::string> declares;
    std::vector<Function> functions;
    std::vector<Property> properties;
    ByteRange body;
};

struct Class : Record {
    bool interface = false;         // declared by UINTERFACE
    std::shared_ptr<Record> native; // the I class of an interface
};

struct Struct : Record {};

struct EnumEntry {
    std::string name; // short
    std::size_t name_offset = 0;
    unsigned line = 0;
    std::string comment;
    std::string value_text;
    ByteRange value_range;
    std::optional<long long> value;
    Specifiers specifiers; // UMETA
};

struct Enum : Declared {
    std::string name;
    std::string form;     // regular, namespaced, class
    std::string cpp_type; // "EFoo", "EFoo::Type"
    std::string underlying;
    bool in_namespace = false;
    std::vector<EnumEntry> entries;
};

struct Header {
    std::string module;
    std::string path;     // as opened
    std::string relative; // to the module's directory
    std::string include;
    std::string generated;
    std::unique_ptr<SourceText> source;
    std::vector<ByteRange> skipped; // inactive preprocessor branches
    LexResult lexed;                // of the active text
    bool reflected = false;
    std::vector<Class> classes;
    std::vector<Record> native_interfaces; // I classes, joined to classes later
    std::vector<Struct> structs;
    std::vector<Enum> enums;
    std::vector<Delegate> delegates;
    std::vector<std::string> type_names;    // of reflected types, in order
    std::vector<std::string> defined_names; // every class/struct/enum the header defines
    std::set<std::size_t> seen_macros;      // offsets of reflection macros that became a declaration or a report entry
    std::vector<ByteRange> blanks;          // what the AST must not see: reflection macros, API tokens
};

} // namespace spear::header_tool
