// SPDX-License-Identifier: MIT
// C++ types as written, parsed from tokens. This is the source of truth for types: with includes missing, an AST would
// quietly turn unknown names into int.
#pragma once

#include "text.h"

#include <optional>
#include <string>
#include <vector>

namespace spear::header_tool {

enum class Reference { none, lvalue, rvalue };

struct TypeSyntax {
    std::string
        name; // "TArray", "EFoo::Type", "unsigned int"; for text that is no name (an expression) the text itself
    std::vector<TypeSyntax> args; // template arguments
    bool is_const = false;        // the innermost type is const
    bool is_raw = false;          // not understood as a type, `name` is text
    int pointers = 0;
    bool pointer_const = false; // T* const
    Reference reference = Reference::none;

    // One spelling for one type: "const TMap<FName, AActor*>&".
    std::string text() const;
    // Without outer const, pointers and reference.
    std::string bare() const;
};

// Parses a type starting at tokens[at]; moves `at` behind it. nullopt when there is no type there.
std::optional<TypeSyntax> parse_type(const std::vector<Token>& tokens, std::size_t& at, std::size_t end);
// Parses text that is a type and nothing else.
std::optional<TypeSyntax> parse_type(std::string_view text);

// The canonical spelling of builtin integer types: "unsigned int" -> "uint32"; others unchanged.
std::string canonical_builtin(const std::string& name);

} // namespace spear::header_tool
