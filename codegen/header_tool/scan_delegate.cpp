// SPDX-License-Identifier: MIT
// MemberParser::delegate: the DECLARE_DYNAMIC_... macros.
#include "scan.h"
#include "specifiers.h"

#include <algorithm>
#include <array>

namespace spear::header_tool {

namespace {

constexpr std::array<std::string_view, 10> counts{"", "_OneParam", "_TwoParams", "_ThreeParams", "_FourParams",
    "_FiveParams", "_SixParams", "_SevenParams", "_EightParams", "_NineParams"};

} // namespace

bool MemberParser::delegate(std::size_t& at, Delegate& out) {
    std::size_t macro = at;
    std::string_view name = tokens_[at].text;
    out.macro = name;
    out.kind = name.find("SPARSE") != std::string_view::npos      ? "sparse"
               : name.find("MULTICAST") != std::string_view::npos ? "multicast"
                                                                  : "single";
    bool returns = name.find("_RetVal") != std::string_view::npos;
    for (std::size_t n = 1; n < counts.size(); ++n)
        if (name.ends_with(counts[n]))
            out.declared_parameters = static_cast<int>(n);
    out.declared_parameters = std::max(out.declared_parameters, 0);
    header_.seen_macros.insert(tokens_[macro].begin);
    out.macro_token = tokens_[macro].begin;
    if (out.comment.empty() && out.macro_offset == 0)
        begin_declared(out, macro);
    std::size_t open = at + 1, close = matching(tokens_, open);
    // The AST sees the macro (the prelude gives it a meaning), unless it cannot be read.
    std::size_t blank = header_.blanks.size();
    header_.blanks.push_back({tokens_[macro].begin, tokens_[close].end});
    // Arguments at depth 0; commas inside <> belong to the type.
    std::vector<std::pair<std::size_t, std::size_t>> args;
    int angle = 0;
    std::size_t begin = open + 1;
    for (std::size_t i = open + 1; i <= close; ++i) {
        if (i < close && (tokens_[i].is("(") || tokens_[i].is("{"))) {
            i = matching(tokens_, i);
            continue;
        }
        if (tokens_[i].is("<"))
            ++angle;
        else if (tokens_[i].is(">"))
            --angle;
        if (i == close || (tokens_[i].is(",") && angle <= 0)) {
            if (i > begin)
                args.emplace_back(begin, i);
            begin = i + 1;
        }
    }
    at = close + 1;
    if (tokens_[at].is(";"))
        ++at;
    std::size_t used = 0;
    out.return_type.name = "void";
    out.return_text = "void";
    if (returns && used < args.size()) {
        std::size_t position = args[used].first;
        auto type = parse_type(tokens_, position, args[used].second);
        if (type && position == args[used].second) {
            out.return_type = *type;
        } else {
            out.return_type.is_raw = true;
            out.return_type.name = slice(args[used].first, args[used].second);
        }
        out.return_text = normalise_spaces(slice(args[used].first, args[used].second));
        ++used;
    }
    if (used >= args.size() || !tokens_[args[used].first].identifier()) {
        fail("unparsed-declaration", macro, std::string(name), "the delegate has no name; it is skipped");
        return false;
    }
    if (tokens_[args[used].first].text.size() < 2) {
        fail("prefix", macro, std::string(tokens_[args[used].first].text),
            "is too short for a delegate name with its prefix; it is skipped");
        return false;
    }
    out.name = tokens_[args[used].first].text;
    out.name_offset = tokens_[args[used].first].begin;
    out.line = line(macro);
    ++used;
    if (out.kind == "sparse") {
        if (used + 1 >= args.size()) {
            fail("unparsed-declaration", macro, out.name,
                "a sparse delegate needs its owning class and property; it is skipped");
            return false;
        }
        out.sparse_owner = slice(args[used].first, args[used].second);
        out.sparse_property = slice(args[used + 1].first, args[used + 1].second);
        used += 2;
    }
    while (used < args.size()) {
        Parameter p;
        std::size_t position = args[used].first, end = args[used].second;
        while (tokens_[position].is("UPARAM") && tokens_[position + 1].is("(")) {
            std::size_t macro_end = parse_specifiers(source_, tokens_, position + 1, p.specifiers);
            header_.blanks.push_back({tokens_[position].begin, tokens_[macro_end].end});
            position = macro_end + 1;
        }
        std::size_t type_begin = position;
        auto type = parse_type(tokens_, position, end);
        if (type && position == end) {
            p.type = *type;
        } else {
            p.type.is_raw = true;
            p.type.name = slice(type_begin, end);
        }
        p.type_text = normalise_spaces(slice(type_begin, end));
        ++used;
        if (used < args.size()) {
            p.name = slice(args[used].first, args[used].second);
            p.name_offset = tokens_[args[used].first].begin;
            ++used;
        }
        out.parameters.push_back(std::move(p));
    }
    header_.blanks.erase(header_.blanks.begin() + static_cast<std::ptrdiff_t>(blank));
    return true;
}

} // namespace spear::header_tool
