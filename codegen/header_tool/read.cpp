// SPDX-License-Identifier: MIT
#include "read.h"

#include "ast.h"
#include "files.h"
#include "scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace spear::header_tool {

namespace {

// Macro calls in inactive branches are not declared; say so unless the branch is one that a build leaves out on
// purpose.
void note_inactive(const Header& header, const LexResult& whole, Report& report) {
    for (std::size_t i = 0; i < end_index(whole.tokens); ++i) {
        const Token& t = whole.tokens[i];
        if (!t.identifier() || !is_reflection_macro(t.text) || !whole.tokens[i + 1].is("("))
            continue;
        for (const ByteRange& range : header.skipped)
            if (range.contains(t.begin))
                report.note("inactive-region", header.path, header.source->line(t.begin), std::string(t.text),
                    "stands in an inactive #if branch; not declared");
    }
}

// Last line of defence against silent skips.
void report_unseen(const Header& header, Report& report) {
    const std::vector<Token>& tokens = header.lexed.tokens;
    for (std::size_t i = 0; i < end_index(tokens); ++i)
        if (tokens[i].identifier() && is_reflection_macro(tokens[i].text) && tokens[i + 1].is("(") &&
            !header.seen_macros.contains(tokens[i].begin))
            report.rule("unparsed-declaration", header.path, header.source->line(tokens[i].begin),
                std::string(tokens[i].text),
                "was passed over: the text around it could not be understood; the declaration is skipped");
}

void find_generated_include(Header& header) {
    for (const Directive& d : header.lexed.directives) {
        if (d.name != "include")
            continue;
        std::size_t open = d.rest.find_first_of("\"<"), close = d.rest.find_first_of("\">", open + 1);
        if (open == std::string::npos || close == std::string::npos)
            continue;
        std::string file = d.rest.substr(open + 1, close - open - 1);
        if (file.ends_with(".generated.h"))
            header.generated = file.substr(file.rfind('/') + 1);
    }
}

// Gives each UINTERFACE its I class.
void join_interfaces(Header& header, Report& report) {
    for (Class& c : header.classes) {
        if (!c.interface)
            continue;
        std::string native = "I" + c.name.substr(1);
        auto it = std::find_if(header.native_interfaces.begin(), header.native_interfaces.end(),
            [&](const Record& r) { return r.name == native; });
        if (it == header.native_interfaces.end())
            continue;
        c.native = std::make_shared<Record>(std::move(*it));
        header.native_interfaces.erase(it);
    }
    for (const Record& r : header.native_interfaces)
        report.rule("orphan-macro", header.path, r.line, r.name,
            "has GENERATED_BODY() but no UINTERFACE in this header; its functions are skipped");
    header.native_interfaces.clear();
}

// No header a person wrote nests this deep, and parsers (ours, clang's) recurse.
constexpr int deepest_nesting = 200;

// The offset at which brackets, template arguments or a row of one sign get too deep, if they do.
std::optional<std::size_t> too_deep(const LexResult& lexed) {
    int brackets = 0, angles = 0, row = 0;
    for (std::size_t i = 0; i < end_index(lexed.tokens); ++i) {
        const Token& t = lexed.tokens[i];
        if (t.kind != TokenKind::punctuation) {
            row = 0;
            continue;
        }
        row = i > 0 && lexed.tokens[i - 1].text == t.text ? row + 1 : 0;
        if (t.is("(") || t.is("[") || t.is("{"))
            ++brackets;
        else if (t.is(")") || t.is("]") || t.is("}"))
            brackets = std::max(0, brackets - 1);
        else if (t.is("<"))
            ++angles;
        else if (t.is(">"))
            angles = std::max(0, angles - 1);
        if (t.is(";") || t.is("{") || t.is("}"))
            angles = 0;
        bool closing = t.is(")") || t.is("]") || t.is("}") || t.is(">") || t.is(";") || t.is(",");
        if (brackets > deepest_nesting || angles > deepest_nesting || (row > deepest_nesting && !closing))
            return t.begin;
    }
    return std::nullopt;
}

} // namespace

bool mentions_reflection(std::string_view bytes) {
    for (std::string_view word : {".generated.h", "UCLASS", "USTRUCT", "UENUM", "UINTERFACE", "DECLARE_DYNAMIC_",
             "UPROPERTY", "UFUNCTION", "UDELEGATE"})
        if (bytes.find(word) != std::string_view::npos)
            return true;
    // UTF-16 text has a byte order mark.
    return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
}

void read_header(Header& header, std::string bytes, const Defines& defines, Report& report) {
    if (!SourceText::looks_like_text(bytes)) {
        report.rule("not-text", header.path, 1, header.relative, "is a binary file; it is skipped");
        return;
    }
    auto source = std::make_unique<SourceText>(SourceText::to_utf8(std::move(bytes)));
    LexResult whole = lex(*source, {});
    if (std::optional<std::size_t> place = too_deep(whole)) {
        report.rule("too-deep", header.path, source->line(*place), header.relative,
            fmt::format("nests more than {} levels here; the header is skipped", deepest_nesting));
        return;
    }
    header.source = std::move(source); // the tokens point into its text
    ConditionMap conditions(whole.directives);
    header.skipped = inactive_branches(*header.source, whole.directives, conditions, defines);
    if (!header.skipped.empty())
        note_inactive(header, whole, report);
    header.lexed = lex(*header.source, header.skipped);
    find_generated_include(header);
    bool macro_definitions = false; // the headers that define the macros themselves
    for (const Directive& d : header.lexed.directives)
        macro_definitions |= d.name == "define" && (d.rest.starts_with("UCLASS(") || d.rest.starts_with("UPROPERTY("));
    if (macro_definitions)
        return;
    scan(header, conditions, report);
    report_unseen(header, report);
    join_interfaces(header, report);
    header.reflected = !header.generated.empty() || !header.type_names.empty();
}

} // namespace spear::header_tool
