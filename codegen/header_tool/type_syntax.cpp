// SPDX-License-Identifier: MIT
#include "type_syntax.h"

#include <algorithm>
#include <array>

namespace spear::header_tool {

namespace {

constexpr std::array<std::string_view, 9> builtin_words{
    "unsigned", "signed", "int", "long", "short", "char", "double", "float", "bool"};
constexpr std::array<std::string_view, 4> elaborating{"class", "struct", "enum", "typename"};

bool is_builtin_word(std::string_view word) {
    return std::find(builtin_words.begin(), builtin_words.end(), word) != builtin_words.end();
}

// Skips one balanced piece up to a ',' or '>' at depth 0 (a template argument that is no type).
std::string raw_argument(const std::vector<Token>& tokens, std::size_t& at, std::size_t end) {
    std::string out;
    int depth = 0, angle = 0;
    while (at < end) {
        const Token& t = tokens[at];
        if (depth == 0 && angle == 0 && (t.is(",") || t.is(">")))
            break;
        if (t.is("(") || t.is("[") || t.is("{"))
            ++depth;
        else if (t.is(")") || t.is("]") || t.is("}"))
            --depth;
        else if (t.is("<"))
            ++angle;
        else if (t.is(">"))
            --angle;
        if (depth < 0)
            break;
        if (!out.empty() && t.identifier() && tokens[at - 1].identifier())
            out += ' ';
        out += t.text;
        ++at;
    }
    return out;
}

bool parse_arguments(
    const std::vector<Token>& tokens, std::size_t& at, std::size_t end, std::vector<TypeSyntax>& args) {
    ++at; // '<'
    while (at < end && !tokens[at].is(">")) {
        std::size_t start = at;
        std::optional<TypeSyntax> arg = parse_type(tokens, at, end);
        if (!arg || at >= end || !(tokens[at].is(",") || tokens[at].is(">"))) {
            at = start;
            TypeSyntax raw;
            raw.is_raw = true;
            raw.name = raw_argument(tokens, at, end);
            if (raw.name.empty())
                return false;
            arg = raw;
        }
        args.push_back(*arg);
        if (at < end && tokens[at].is(","))
            ++at;
    }
    if (at >= end)
        return false;
    ++at; // '>'
    return true;
}

} // namespace

std::optional<TypeSyntax> parse_type(const std::vector<Token>& tokens, std::size_t& at, std::size_t end) {
    std::size_t i = at;
    TypeSyntax type;
    auto qualifiers = [&] {
        while (i < end && tokens[i].identifier()) {
            if (tokens[i].is("const"))
                type.is_const = true;
            else if (!tokens[i].is("volatile") &&
                     std::find(elaborating.begin(), elaborating.end(), tokens[i].text) == elaborating.end())
                break;
            ++i;
        }
    };
    qualifiers();
    if (i < end && tokens[i].is("::"))
        ++i;
    if (i >= end || !tokens[i].identifier())
        return std::nullopt;
    if (is_builtin_word(tokens[i].text)) {
        while (i < end && tokens[i].identifier() && (is_builtin_word(tokens[i].text) || tokens[i].is("const"))) {
            if (tokens[i].is("const")) {
                type.is_const = true;
            } else {
                if (!type.name.empty())
                    type.name += ' ';
                type.name += tokens[i].text;
            }
            ++i;
        }
    } else {
        while (i < end && tokens[i].identifier()) {
            type.name += tokens[i++].text;
            if (i < end && tokens[i].is("<")) {
                if (!parse_arguments(tokens, i, end, type.args))
                    return std::nullopt;
                if (i < end && tokens[i].is("::") && i + 1 < end && tokens[i + 1].identifier()) {
                    // TFoo<X>::Type: kept as text, no reflected type looks like this
                    TypeSyntax prefix = type;
                    type = TypeSyntax{};
                    type.is_const = prefix.is_const;
                    prefix.is_const = false;
                    type.name = prefix.text() + "::";
                    ++i;
                    continue;
                }
                break;
            }
            if (i + 1 < end && tokens[i].is("::") && tokens[i + 1].identifier()) {
                type.name += "::";
                ++i;
                continue;
            }
            break;
        }
    }
    qualifiers();
    while (i < end) {
        if (tokens[i].is("*")) {
            ++type.pointers;
        } else if (tokens[i].is("&")) {
            type.reference = Reference::lvalue;
        } else if (tokens[i].is("&&")) {
            type.reference = Reference::rvalue;
        } else if (tokens[i].is("const") && type.pointers > 0) {
            type.pointer_const = true;
        } else if (!tokens[i].is("volatile") && !tokens[i].is("RESTRICT")) {
            break;
        }
        ++i;
    }
    at = i;
    return type;
}

std::optional<TypeSyntax> parse_type(std::string_view text) {
    SourceText source{std::string(text)};
    LexResult lexed = lex(source, {});
    std::size_t at = 0;
    std::optional<TypeSyntax> type = parse_type(lexed.tokens, at, end_index(lexed.tokens));
    if (!type || at != end_index(lexed.tokens))
        return std::nullopt;
    return type;
}

std::string TypeSyntax::bare() const {
    std::string out = name;
    if (!args.empty()) {
        out += '<';
        for (std::size_t i = 0; i < args.size(); ++i) {
            if (i > 0)
                out += ", ";
            out += args[i].text();
        }
        out += '>';
    }
    return out;
}

std::string TypeSyntax::text() const {
    std::string out = is_const ? "const " : "";
    out += bare();
    out.append(static_cast<std::size_t>(pointers), '*');
    if (pointer_const)
        out += " const";
    if (reference == Reference::lvalue)
        out += '&';
    else if (reference == Reference::rvalue)
        out += "&&";
    return out;
}

std::string canonical_builtin(const std::string& name) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 10> names{
        {{"int", "int32"}, {"unsigned int", "uint32"}, {"unsigned", "uint32"}, {"signed int", "int32"},
            {"signed", "int32"}, {"int32_t", "int32"}, {"uint32_t", "uint32"}, {"uint8_t", "uint8"},
            {"int64_t", "int64"}, {"uint64_t", "uint64"}}};
    for (const auto& [from, to] : names)
        if (name == from)
            return std::string(to);
    return name;
}

} // namespace spear::header_tool
