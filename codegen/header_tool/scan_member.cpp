// SPDX-License-Identifier: MIT
#include "scan.h"
#include "specifiers.h"

#include <algorithm>
#include <array>

namespace spear::header_tool {

namespace {

constexpr std::array<std::string_view, 14> modifiers{"virtual", "static", "inline", "explicit", "constexpr",
    "consteval", "friend", "extern", "mutable", "FORCEINLINE", "FORCENOINLINE", "FORCEINLINE_DEBUGGABLE",
    "UE_NODISCARD", "thread_local"};

bool is_modifier(std::string_view word) {
    return std::find(modifiers.begin(), modifiers.end(), word) != modifiers.end();
}

} // namespace

bool is_api_macro(std::string_view name) { return is_macro_like(name) && name.size() > 4 && name.ends_with("_API"); }

bool is_delegate_macro(std::string_view name) {
    return name.starts_with("DECLARE_DYNAMIC_") && name.find("DELEGATE") != std::string_view::npos;
}

bool is_reflection_macro(std::string_view text) {
    return text == "UCLASS" || text == "USTRUCT" || text == "UENUM" || text == "UINTERFACE" || text == "UFUNCTION" ||
           text == "UPROPERTY" || text == "UDELEGATE" || is_delegate_macro(text);
}

bool is_body_macro(std::string_view name) { return name.starts_with("GENERATED_") && name.ends_with("BODY"); }

std::string MemberParser::slice(std::size_t first, std::size_t last) const {
    if (first >= last)
        return {};
    return strip_comments(source_.slice(tokens_[first].begin, tokens_[last - 1].end));
}

void MemberParser::fail(const char* rule, std::size_t at, std::string subject, std::string message) const {
    at = std::min(at, end_index(tokens_));
    header_.seen_macros.insert(tokens_[at].begin);
    report_.rule(rule, header_.path, line(at), std::move(subject), std::move(message));
}

std::string MemberParser::comment_before(std::size_t at) const {
    std::size_t from = at > 0 ? tokens_[at - 1].end : 0;
    unsigned previous_line = at > 0 ? source_.line(from) : 0;
    std::size_t to = tokens_[at].begin;
    for (const Directive& d : header_.lexed.directives)
        if (d.end <= to && d.end > from) {
            from = d.end;
            previous_line = source_.line(d.end);
        }
    std::vector<Comment> group;
    const auto& comments = header_.lexed.comments;
    auto first = std::lower_bound(
        comments.begin(), comments.end(), from, [](const Comment& c, std::size_t offset) { return c.begin < offset; });
    for (auto c = first; c != comments.end() && c->end <= to; ++c) {
        if (source_.line(c->begin) == previous_line && source_.line(c->begin) != source_.line(to))
            continue; // belongs to what stands before it on the line
        if (source_.slice(c->begin, c->end).starts_with("//~"))
            continue; // Epic's mark for "not documentation"
        bool joins = !c->block && !group.empty() && !group.back().block &&
                     source_.line(c->begin) <= source_.line(group.back().end) + 1;
        if (!joins)
            group.clear();
        group.push_back(*c);
    }
    if (group.empty())
        return {};
    if (group.front().block)
        return std::string(source_.slice(group.front().begin, group.front().end));
    std::string text;
    for (const Comment& c : group)
        text += std::string(trim(source_.slice(c.begin, c.end))) + "\n";
    return text;
}

void MemberParser::begin_declared(Declared& declared, std::size_t macro) const {
    declared.macro_offset = tokens_[macro].begin;
    header_.seen_macros.insert(tokens_[macro].begin);
    declared.comment = comment_before(macro);
    declared.conditions = conditions_.at(tokens_[macro].begin);
}

std::size_t MemberParser::skip_statement(std::size_t at) const {
    std::size_t last = end_index(tokens_);
    std::size_t begin = at;
    while (at < last) {
        // A macro without semicolon (PURE_VIRTUAL(...)) must not swallow what follows it.
        const Token& t = tokens_[at];
        if (at > begin && t.identifier() && tokens_[at + 1].is("(") &&
            (is_reflection_macro(t.text) || is_body_macro(t.text)))
            return at;
        if (at > begin && (t.is("public") || t.is("protected") || t.is("private")) && tokens_[at + 1].is(":"))
            return at;
        if (tokens_[at].is(";"))
            return at + 1;
        if (tokens_[at].is("}"))
            return at; // the end of the enclosing body: a macro without semicolon came last
        if (tokens_[at].is("(") || tokens_[at].is("[")) {
            at = matching(tokens_, at) + 1;
        } else if (tokens_[at].is("{")) {
            at = matching(tokens_, at) + 1;
            if (at >= last)
                return last;
            if (tokens_[at].is(";"))
                return at + 1;
            if (!tokens_[at].is(",") && !tokens_[at].is("{") && !tokens_[at].is("(") && !tokens_[at].is(".") &&
                !tokens_[at].is("->"))
                return at;
        } else {
            ++at;
        }
    }
    return last;
}

std::size_t MemberParser::skip_decorations(std::size_t at, std::string* deprecated, std::string* api) const {
    for (;;) {
        const Token& t = tokens_[at];
        const Token& next = tokens_[std::min(at + 1, end_index(tokens_))];
        if (t.is("[") && next.is("[")) {
            at = matching(tokens_, at) + 1;
        } else if (t.is("alignas") || t.is("__declspec") || t.is("__attribute__")) {
            at = matching(tokens_, at + 1) + 1;
        } else if (t.identifier() && is_api_macro(t.text)) {
            if (api)
                *api = t.text;
            header_.blanks.push_back({t.begin, t.end});
            ++at;
        } else if (t.identifier() && is_macro_like(t.text) && next.is("(") && !t.is("UPARAM") && t.text.size() > 3) {
            // UE_DEPRECATED(5.1, "..."), PRAGMA-like macros: nothing a declaration could start with looks like this.
            std::size_t close = matching(tokens_, at + 1);
            if (deprecated && t.text.find("DEPRECATED") != std::string_view::npos)
                *deprecated = slice(at + 2, close);
            header_.blanks.push_back({t.begin, tokens_[close].end});
            at = close + 1;
        } else if (t.identifier() && is_macro_like(t.text) && t.text.size() > 3 && next.identifier() &&
                   !is_modifier(t.text) && !next.is("const") &&
                   tokens_[std::min(at + 2, end_index(tokens_))].identifier()) {
            header_.blanks.push_back({t.begin, t.end}); // PRAGMA_DISABLE_DEPRECATION_WARNINGS type name
            report_.note("macro-blanked", header_.path, line(at), std::string(t.text),
                "macro before a declaration taken as empty");
            ++at;
        } else {
            return at;
        }
    }
}

Parameter MemberParser::parameter(std::size_t begin, std::size_t end) {
    Parameter p;
    std::size_t at = begin;
    while (at < end && tokens_[at].is("UPARAM") && tokens_[at + 1].is("(")) {
        std::size_t close = parse_specifiers(source_, tokens_, at + 1, p.specifiers);
        header_.blanks.push_back({tokens_[at].begin, tokens_[close].end});
        at = close + 1;
    }
    std::size_t equals = at;
    int angle = 0;
    for (; equals < end; ++equals) {
        if (tokens_[equals].is("<"))
            ++angle;
        else if (tokens_[equals].is(">"))
            --angle;
        else if (tokens_[equals].is("(") || tokens_[equals].is("{"))
            equals = std::min(matching(tokens_, equals), end - 1);
        else if (angle <= 0 && tokens_[equals].is("="))
            break;
    }
    if (equals < end)
        p.default_text = slice(equals + 1, end);
    std::size_t type_begin = at;
    auto type = parse_type(tokens_, at, equals);
    if (type)
        p.type = *type;
    p.type_text = normalise_spaces(slice(type_begin, at));
    // "const UPARAM(...)": rare, and macro words between type and name
    while (at + 1 < equals && tokens_[at].identifier() && tokens_[at + 1].identifier())
        ++at;
    if (at < equals && tokens_[at].identifier()) {
        p.name = tokens_[at].text;
        p.name_offset = tokens_[at].begin;
        ++at;
        if (at < equals && tokens_[at].is("[")) {
            std::size_t close = matching(tokens_, at);
            p.array_text = slice(at + 1, close);
            at = close + 1;
        }
    }
    if (!type || at != equals) {
        p.type.is_raw = true;
        p.type.name = normalise_spaces(slice(type_begin, equals));
        p.type_text = p.type.name;
    }
    return p;
}

std::vector<Parameter> MemberParser::parameters(std::size_t open, std::size_t close) {
    std::vector<Parameter> out;
    std::size_t begin = open + 1;
    int angle = 0;
    bool in_default = false;
    for (std::size_t i = open + 1; i <= close && close > open + 1; ++i) {
        const Token& t = tokens_[i];
        if (i < close && (t.is("(") || t.is("{") || t.is("["))) {
            i = matching(tokens_, i);
            continue;
        }
        if (t.is("="))
            in_default = true;
        else if (t.is("<") && (!in_default || tokens_[i - 1].identifier()))
            ++angle;
        else if (t.is(">") && angle > 0)
            --angle;
        if (i == close || (t.is(",") && angle == 0)) {
            if (!(begin + 1 == i && tokens_[begin].is("void")))
                out.push_back(parameter(begin, i));
            begin = i + 1;
            in_default = false;
            angle = 0;
        }
    }
    return out;
}

std::size_t MemberParser::function_tail(std::size_t at, Function& out) {
    std::size_t last = end_index(tokens_);
    while (at < last) {
        const Token& t = tokens_[at];
        if (t.is(";"))
            return at + 1;
        if (t.is("}"))
            return at;
        if (t.is("{")) {
            out.is_inline = true;
            at = matching(tokens_, at) + 1;
            return at < last && tokens_[at].is(";") ? at + 1 : at;
        }
        if (t.is("const")) {
            out.is_const = true;
        } else if (t.is("override")) {
            out.is_override = true;
        } else if (t.is("final")) {
            out.is_final = true;
        } else if (t.is("=") && tokens_[at + 1].is("0")) {
            out.is_pure = true;
        } else if (t.is("PURE_VIRTUAL") && tokens_[at + 1].is("(")) {
            at = matching(tokens_, at + 1) + 1; // the prelude defines this macro with its semicolon
            return tokens_[at].is(";") ? at + 1 : at;
        } else if (t.is("(")) {
            at = matching(tokens_, at);
        } else if (t.identifier() && is_macro_like(t.text)) {
            bool call = tokens_[at + 1].is("(");
            std::size_t close = call ? matching(tokens_, at + 1) : at;
            header_.blanks.push_back({t.begin, tokens_[close].end});
            at = close;
        } else if (at > 0 && (tokens_[at].is("UFUNCTION") || tokens_[at].is("UPROPERTY"))) {
            return at;
        }
        ++at;
    }
    return at;
}

bool MemberParser::function(std::size_t& at, Function& out) {
    std::size_t macro = at;
    begin_declared(out, macro);
    std::size_t close = parse_specifiers(source_, tokens_, at + 1, out.specifiers);
    header_.blanks.push_back({tokens_[macro].begin, tokens_[close].end});
    at = close + 1;
    if (tokens_[at].is(";"))
        ++at; // UFUNCTION(...); with a stray semicolon
    for (;;) {
        std::size_t before = at;
        at = skip_decorations(at, &out.deprecated, &out.api);
        while (tokens_[at].identifier() && is_modifier(tokens_[at].text)) {
            out.is_virtual |= tokens_[at].is("virtual");
            out.is_static |= tokens_[at].is("static");
            out.is_inline |= tokens_[at].text.starts_with("FORCEINLINE") || tokens_[at].is("inline");
            if (is_macro_like(tokens_[at].text))
                header_.blanks.push_back({tokens_[at].begin, tokens_[at].end});
            ++at;
        }
        if (tokens_[at].is("UPARAM") && tokens_[at + 1].is("(")) {
            std::size_t end = parse_specifiers(source_, tokens_, at + 1, out.return_specifiers);
            header_.blanks.push_back({tokens_[at].begin, tokens_[end].end});
            at = end + 1;
        }
        if (tokens_[at].is("const") && tokens_[at + 1].is("UPARAM"))
            break;
        if (at == before)
            break;
    }
    if (tokens_[at].is("template")) {
        fail("template-type", at, "template", "a UFUNCTION cannot be a template; declaration skipped");
        at = skip_statement(at);
        return false;
    }
    std::size_t type_begin = at;
    auto type = parse_type(tokens_, at, end_index(tokens_));
    std::size_t type_end = at;
    if (type && tokens_[at].identifier()) {
        while (tokens_[at].identifier() && !tokens_[at + 1].is("(")) {
            if (!is_modifier(tokens_[at].text) && !is_macro_like(tokens_[at].text))
                break;
            out.is_virtual |= tokens_[at].is("virtual");
            out.is_static |= tokens_[at].is("static");
            if (is_api_macro(tokens_[at].text))
                out.api = tokens_[at].text;
            if (is_macro_like(tokens_[at].text))
                header_.blanks.push_back({tokens_[at].begin, tokens_[at].end});
            ++at;
        }
    }
    if (!type || !tokens_[at].identifier() || !tokens_[at + 1].is("(")) {
        fail("unparsed-declaration", macro, "UFUNCTION",
            "no function declaration could be read after UFUNCTION; it is skipped");
        at = std::max(close + 1, type_begin);
        return false;
    }
    out.return_type = *type;
    out.return_text = normalise_spaces(slice(type_begin, type_end));
    out.name = tokens_[at].text;
    out.name_offset = tokens_[at].begin;
    out.line = line(at);
    std::size_t open = at + 1, params_close = matching(tokens_, open);
    out.parameters = parameters(open, params_close);
    at = function_tail(params_close + 1, out);
    return true;
}

std::vector<Property> MemberParser::properties(std::size_t& at) {
    std::size_t macro = at;
    Property common;
    begin_declared(common, macro);
    std::size_t close = parse_specifiers(source_, tokens_, at + 1, common.specifiers);
    header_.blanks.push_back({tokens_[macro].begin, tokens_[close].end});
    at = close + 1;
    if (tokens_[at].is(";")) {
        ++at;
        report_.note("property-semicolon", header_.path, line(macro), "UPROPERTY",
            "UPROPERTY(...) is followed by a semicolon; taken for the declaration behind it");
    }
    for (;;) {
        std::size_t before = at;
        at = skip_decorations(at);
        while (tokens_[at].identifier() && is_modifier(tokens_[at].text)) {
            common.is_mutable |= tokens_[at].is("mutable");
            if (tokens_[at].is("static"))
                fail("static-property", at, "UPROPERTY", "a static member cannot be a UPROPERTY");
            ++at;
        }
        if (at == before)
            break;
    }
    std::size_t type_begin = at;
    auto type = parse_type(tokens_, at, end_index(tokens_));
    std::vector<Property> out;
    if (!type || !tokens_[at].identifier()) {
        fail("unparsed-declaration", macro, "UPROPERTY",
            "no variable declaration could be read after UPROPERTY; it is skipped");
        at = close + 1;
        return out;
    }
    common.type = *type;
    common.type_text = normalise_spaces(slice(type_begin, at));
    while (tokens_[at].identifier()) {
        Property p = common;
        while (tokens_[at].identifier() && tokens_[at + 1].identifier()) // a macro between type and name
            ++at;
        p.cpp_name = tokens_[at].text;
        p.name_offset = tokens_[at].begin;
        p.line = line(at);
        ++at;
        if (tokens_[at].is("[")) {
            std::size_t end = matching(tokens_, at);
            p.array_text = slice(at + 1, end);
            p.array_range = {tokens_[at].begin, tokens_[end].end};
            at = end + 1;
            if (tokens_[at].is("[")) {
                fail("unsupported-type", at, p.cpp_name, "arrays of arrays cannot be reflected; declaration skipped");
                at = skip_statement(at);
                return out;
            }
        }
        if (tokens_[at].is(":")) {
            std::size_t begin = ++at;
            while (!tokens_[at].is(";") && !tokens_[at].is(",") && !tokens_[at].is("=") && !tokens_[at].is("{") &&
                   tokens_[at].kind != TokenKind::end)
                ++at;
            p.bits = slice(begin, at);
        }
        if (tokens_[at].is("=") || tokens_[at].is("{")) {
            std::size_t begin = tokens_[at].is("=") ? at + 1 : at;
            while (!tokens_[at].is(";") && !tokens_[at].is("}") && tokens_[at].kind != TokenKind::end) {
                if (tokens_[at].is("(") || tokens_[at].is("{") || tokens_[at].is("["))
                    at = matching(tokens_, at);
                else if (tokens_[at].is(",") && tokens_[at + 1].identifier() &&
                         (tokens_[at + 2].is(",") || tokens_[at + 2].is(";") || tokens_[at + 2].is("=")))
                    break; // the next declarator; a comma inside template arguments is never followed so
                ++at;
            }
            p.default_text = slice(begin, at);
        } else if (tokens_[at].identifier() && is_macro_like(tokens_[at].text)) {
            while (!tokens_[at].is(";") && !tokens_[at].is("}") && tokens_[at].kind != TokenKind::end)
                ++at;
        }
        out.push_back(std::move(p));
        if (tokens_[at].is(",")) {
            ++at;
            while (tokens_[at].is("*") || tokens_[at].is("&")) {
                if (tokens_[at].is("*") && common.type.pointers == 0)
                    ++common.type.pointers;
                ++at;
            }
            continue;
        }
        break;
    }
    if (tokens_[at].is(";")) {
        ++at;
    } else {
        fail("unparsed-declaration", at, out.empty() ? "UPROPERTY" : out.back().cpp_name,
            "unexpected text '" + std::string(tokens_[at].text) +
                "' after the property's name; the property is skipped");
        out.clear();
        at = tokens_[at].is("(") ? skip_statement(at) : at;
    }
    return out;
}

} // namespace spear::header_tool
