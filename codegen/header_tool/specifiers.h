// SPDX-License-Identifier: MIT
// The arguments of reflection macros: UPROPERTY(EditAnywhere, Category = "X", meta = (ClampMin = 0)).
#pragma once

#include "model.h"

namespace spear::header_tool {

// Parses the tokens between an opening parenthesis at tokens[open] and its match; returns the index of the closing one
// (or of the end token when it is missing).
std::size_t parse_specifiers(
    const SourceText& source, const std::vector<Token>& tokens, std::size_t open, Specifiers& out);

// Index of the token that closes the bracket at tokens[open] ('(', '[' or '{'), or of the last token.
std::size_t matching(const std::vector<Token>& tokens, std::size_t open);

// The value of a C++ string literal token, prefix and quotes removed, escapes resolved.
std::string unquote(std::string_view literal);

// Epic's spelling of a well-known metadata key, others unchanged.
std::string canonical_meta_key(std::string_view key);

} // namespace spear::header_tool
