// SPDX-License-Identifier: MIT
// Source bytes and tokens of one header. Everything the tool says about a declaration comes from byte offsets in here,
// so that macros, missing includes and parse errors cannot change what was written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace spear::header_tool {

enum class TokenKind { identifier, number, string, character, punctuation, end };

struct Token {
    TokenKind kind = TokenKind::end;
    std::size_t begin = 0; // byte offsets into the text
    std::size_t end = 0;
    std::string_view text;

    bool is(std::string_view spelling) const {
        return text == spelling && kind != TokenKind::string && kind != TokenKind::character;
    }
    bool identifier() const { return kind == TokenKind::identifier; }
};

struct Comment {
    std::size_t begin = 0;
    std::size_t end = 0;
    bool block = false; // /* ... */, else //
};

// One preprocessor directive, from '#' to the end of its last (continued) line.
struct Directive {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::string name; // "if", "include", ...
    std::string rest; // text after the name, continuations joined, comments removed
};

struct ByteRange {
    std::size_t begin = 0;
    std::size_t end = 0;
    bool contains(std::size_t offset) const { return offset >= begin && offset < end; }
};

class SourceText {
public:
    explicit SourceText(std::string bytes);

    const std::string& bytes() const { return bytes_; }
    std::string_view slice(std::size_t begin, std::size_t end) const {
        return std::string_view(bytes_).substr(begin, end - begin);
    }
    // 1-based line of a byte offset.
    unsigned line(std::size_t offset) const;
    unsigned column(std::size_t offset) const;
    // False when the bytes are not text (a NUL byte outside a byte order mark, or UTF-16 that could not be decoded).
    static bool looks_like_text(std::string_view bytes);
    // UTF-16 files with a byte order mark become UTF-8, a UTF-8 mark is removed, CR LF becomes LF, and bytes that are
    // no UTF-8 are read as Latin-1.
    static std::string to_utf8(std::string bytes);

private:
    std::string bytes_;
    std::vector<std::size_t> line_starts_;
};

// The last tokens of a LexResult are this many of kind `end`, so that a parser may look a little ahead without asking.
inline constexpr std::size_t end_token_count = 16;
// Index of the first token of kind `end`.
inline std::size_t end_index(const std::vector<Token>& tokens) { return tokens.size() - end_token_count; }

struct LexResult {
    std::vector<Token> tokens; // ends with end_token_count tokens of kind end
    std::vector<Comment> comments;
    std::vector<Directive> directives;
};

// Splits the text, leaving out the bytes of `skipped` (ascending ranges, e.g. inactive preprocessor branches).
LexResult lex(const SourceText& source, const std::vector<ByteRange>& skipped);

// Text with comments taken out and every run of white space made one blank; no blank around <>,()::*& except where C++
// style wants one.
std::string normalise_spaces(std::string_view text);
// Comments out, white space runs to one blank, otherwise as written.
std::string strip_comments(std::string_view text);
std::string_view trim(std::string_view text);
bool starts_with_no_case(std::string_view text, std::string_view prefix);
bool equals_no_case(std::string_view a, std::string_view b);
std::string lower(std::string_view text);
// Letters A-Z, digits and underscores only, at least one letter: how macros are spelled.
bool is_macro_like(std::string_view name);

} // namespace spear::header_tool
