// SPDX-License-Identifier: MIT
#include "specifiers.h"

#include <array>

namespace spear::header_tool {

const Specifier* Specifiers::find(std::string_view key) const {
    for (const Specifier& item : items)
        if (equals_no_case(item.key, key))
            return &item;
    return nullptr;
}

std::string to_string(Access access) {
    switch (access) {
    case Access::public_:
        return "public";
    case Access::protected_:
        return "protected";
    case Access::private_:
        break;
    }
    return "private";
}

std::size_t matching(const std::vector<Token>& tokens, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < end_index(tokens); ++i) {
        if (tokens[i].is("(") || tokens[i].is("[") || tokens[i].is("{"))
            ++depth;
        else if ((tokens[i].is(")") || tokens[i].is("]") || tokens[i].is("}")) && --depth == 0)
            return i;
    }
    return end_index(tokens);
}

std::string unquote(std::string_view literal) {
    std::size_t open = literal.find('"');
    if (open == std::string_view::npos)
        return std::string(literal);
    if (open > 0 && literal[open - 1] == 'R') {
        std::size_t begin = literal.find('(', open), end = literal.rfind(')');
        return begin == std::string_view::npos || end <= begin
                   ? std::string()
                   : std::string(literal.substr(begin + 1, end - begin - 1));
    }
    std::string out;
    for (std::size_t i = open + 1; i < literal.size() && literal[i] != '"'; ++i) {
        if (literal[i] != '\\' || i + 1 >= literal.size()) {
            out += literal[i];
            continue;
        }
        switch (literal[++i]) {
        case 'n':
            out += '\n';
            break;
        case 't':
            out += '\t';
            break;
        case 'r':
            out += '\r';
            break;
        case '0':
            out += ' ';
            break;
        case '\n':
            break;
        default:
            out += literal[i];
        }
    }
    return out;
}

std::string canonical_meta_key(std::string_view key) {
    static constexpr std::array<std::string_view, 40> known{"AllowPrivateAccess", "AdvancedDisplay", "ArrayParm",
        "AutoCreateRefTerm", "BlueprintInternalUseOnly", "BlueprintSpawnableComponent", "BlueprintThreadSafe",
        "BlueprintType", "BindWidget", "CallInEditor", "Category", "ClampMax", "ClampMin", "CustomStructureParam",
        "CustomThunk", "DefaultToSelf", "DeprecatedFunction", "DeprecationMessage", "DeterminesOutputType",
        "DisplayName", "EditCondition", "EditInline", "ExpandEnumAsExecs", "ExposeOnSpawn", "HidePin",
        "IsBlueprintBase", "Keywords", "Latent", "LatentInfo", "MakeEditWidget", "ScriptName", "ShortToolTip",
        "ShowOnlyInnerProperties", "ToolTip", "UIMax", "UIMin", "UnsafeDuringActorConstruction", "Units",
        "WorldContext", "BaseStruct"};
    for (std::string_view name : known)
        if (equals_no_case(name, key))
            return std::string(name);
    return std::string(key);
}

namespace {

// A value from tokens [begin, end): one or more adjacent string literals, or the text itself.
std::string value_text(const SourceText& source, const std::vector<Token>& tokens, std::size_t begin, std::size_t end) {
    if (begin >= end)
        return {};
    // TEXT("x") counts as "x".
    if (end - begin >= 4 && tokens[begin].is("TEXT") && tokens[begin + 1].is("(") && tokens[end - 1].is(")"))
        return value_text(source, tokens, begin + 2, end - 1);
    bool strings = true;
    for (std::size_t i = begin; i < end; ++i)
        strings = strings && tokens[i].kind == TokenKind::string;
    if (!strings)
        return strip_comments(source.slice(tokens[begin].begin, tokens[end - 1].end));
    std::string out;
    for (std::size_t i = begin; i < end; ++i)
        out += unquote(tokens[i].text);
    return out;
}

// End of the item that starts at `at`: the next ',' or the closing parenthesis.
std::size_t item_end(const std::vector<Token>& tokens, std::size_t at, std::size_t close) {
    while (at < close && !tokens[at].is(",")) {
        if (tokens[at].is("(") || tokens[at].is("{") || tokens[at].is("["))
            at = std::min(matching(tokens, at), close);
        if (at < close)
            ++at;
    }
    return at;
}

Specifier parse_item(const SourceText& source, const std::vector<Token>& tokens, std::size_t begin, std::size_t end) {
    std::size_t equals = begin;
    while (equals < end && !tokens[equals].is("="))
        ++equals;
    Specifier item;
    item.key = value_text(source, tokens, begin, equals);
    if (equals == end) {
        // ClassGroup(Foo) and the like do not exist; a list directly after the key is kept as its value.
        return item;
    }
    std::size_t value = equals + 1;
    if (value < end && tokens[value].is("(") && matching(tokens, value) == end - 1) {
        for (std::size_t i = value + 1; i < end - 1;) {
            std::size_t stop = item_end(tokens, i, end - 1);
            if (stop > i)
                item.list.push_back(value_text(source, tokens, i, stop));
            i = stop + 1;
        }
        std::string joined;
        for (const std::string& part : item.list)
            joined += (joined.empty() ? "" : " ") + part;
        item.value = joined;
    } else {
        item.value = value_text(source, tokens, value, end);
    }
    return item;
}

} // namespace

std::size_t parse_specifiers(
    const SourceText& source, const std::vector<Token>& tokens, std::size_t open, Specifiers& out) {
    std::size_t close = matching(tokens, open);
    out.raw = strip_comments(source.slice(tokens[open].end, tokens[close].begin));
    for (std::size_t i = open + 1; i < close;) {
        std::size_t stop = item_end(tokens, i, close);
        bool meta =
            i + 2 < stop && equals_no_case(tokens[i].text, "meta") && tokens[i + 1].is("=") && tokens[i + 2].is("(");
        if (meta) {
            std::size_t meta_close = std::min(matching(tokens, i + 2), close);
            for (std::size_t k = i + 3; k < meta_close;) {
                std::size_t end = item_end(tokens, k, meta_close);
                if (end > k) {
                    Specifier pair = parse_item(source, tokens, k, end);
                    out.meta[canonical_meta_key(pair.key)] = pair.value.value_or("");
                }
                k = end + 1;
            }
        } else if (stop > i) {
            out.items.push_back(parse_item(source, tokens, i, stop));
        }
        i = stop + 1;
    }
    return close;
}

} // namespace spear::header_tool
