// SPDX-License-Identifier: MIT
#include "scan.h"
#include "scan_body.h"
#include "specifiers.h"

#include <algorithm>

namespace spear::header_tool {

namespace {

class Scanner {
public:
    Scanner(Header& header, const ConditionMap& conditions, Report& report)
        : header_(header), body_(header, conditions, report), members_(body_.members()), tokens_(header.lexed.tokens),
          source_(*header.source) {}

    void run() {
        scope(0, end_index(tokens_), "");
        std::vector<std::pair<std::size_t, std::string>> names; // in the order of the text
        auto collect = [&](const auto& declarations) {
            for (const auto& d : declarations)
                names.emplace_back(d.macro_offset, d.name);
        };
        collect(header_.classes);
        collect(header_.structs);
        collect(header_.enums);
        collect(header_.delegates);
        std::sort(names.begin(), names.end());
        for (auto& [offset, name] : names)
            header_.type_names.push_back(std::move(name));
    }

private:
    // Declarations of a namespace or of the file. `space`: the namespace's name, "" outside.
    void scope(std::size_t at, std::size_t end, const std::string& space) {
        while (at < end) {
            const Token& t = tokens_[at];
            bool call = tokens_[at + 1].is("(");
            if (call && (t.is("UCLASS") || t.is("UINTERFACE")))
                at = annotated_class(at, space);
            else if (call && t.is("USTRUCT"))
                at = annotated_struct(at, space);
            else if (call && t.is("UENUM"))
                at = annotated_enum(at, space);
            else if (call && (t.is("UDELEGATE") || is_delegate_macro(t.text)))
                at = body_.delegate(at, "", space);
            else if (call && (t.is("UFUNCTION") || t.is("UPROPERTY")))
                at = orphan(at);
            else if (t.is("namespace"))
                at = namespace_scope(at, end, space);
            else if (t.is("extern") && tokens_[at + 1].kind == TokenKind::string && tokens_[at + 2].is("{"))
                at += 3; // its '}' is skipped as a stray one
            else if (t.is("}") || t.is(";"))
                ++at;
            else if (t.is("template"))
                at = body_.skip_template(at);
            else if ((t.is("class") || t.is("struct")) && !tokens_[at - (at > 0)].is("enum"))
                at = plain_record(at, space);
            else if (t.is("enum"))
                at = plain_enum(at);
            else if (t.identifier() && is_macro_like(t.text) && call && t.text.size() > 2)
                at = macro_call(at);
            else if (t.identifier() && is_macro_like(t.text) && !tokens_[at + 1].is("::") &&
                     tokens_[at + 1].identifier())
                at = bare_macro(at);
            else
                at = plain_statement(at, end);
        }
    }

    std::size_t orphan(std::size_t at) {
        members_.fail(
            "orphan-macro", at, std::string(tokens_[at].text), "stands outside a class or struct body; it is skipped");
        return matching(tokens_, at + 1) + 1;
    }

    std::size_t namespace_scope(std::size_t at, std::size_t end, const std::string& space) {
        std::string name = space;
        std::size_t i = at + 1;
        for (; i < end && !tokens_[i].is("{") && !tokens_[i].is(";") && !tokens_[i].is("="); ++i)
            if (tokens_[i].identifier() && !is_api_macro(tokens_[i].text))
                name += (name.empty() ? "" : "::") + std::string(tokens_[i].text);
        if (!tokens_[i].is("{"))
            return members_.skip_statement(i);
        std::size_t close = matching(tokens_, i);
        scope(i + 1, close, name.empty() ? "(unnamed)" : name);
        return close + 1;
    }

    // A macro call at file scope: MACRO(...) or MACRO(...); blank when no semicolon follows.
    std::size_t macro_call(std::size_t at) {
        std::size_t close = matching(tokens_, at + 1);
        if (tokens_[close + 1].is(";"))
            return close + 2;
        if (tokens_[close + 1].is("{"))
            return members_.skip_statement(at);
        header_.blanks.push_back({tokens_[at].begin, tokens_[close].end});
        return close + 1;
    }

    std::size_t bare_macro(std::size_t at) {
        header_.blanks.push_back({tokens_[at].begin, tokens_[at].end});
        return at + 1;
    }

    std::size_t plain_statement(std::size_t at, std::size_t end) {
        // Stops early at a reflection macro, so that an odd construct never swallows a declaration.
        std::size_t i = at;
        while (i < end) {
            const Token& t = tokens_[i];
            if (i > at && tokens_[i + 1].is("(") && is_reflection_macro(t.text))
                return i;
            if (t.is(";"))
                return i + 1;
            if (t.is("(") || t.is("[")) {
                i = matching(tokens_, i) + 1;
            } else if (t.is("{")) {
                std::size_t close = matching(tokens_, i);
                body_.orphans_inside(i, close);
                i = close + 1;
                if (!tokens_[std::min(i, end_index(tokens_))].is(","))
                    return std::min(i, end);
            } else {
                ++i;
            }
        }
        return end;
    }

    // Reads "class X_API UFoo final : bases {"; `at` is at class/struct. Returns the index of '{', or of what else
    // ended it.
    std::size_t record_head(std::size_t at, Record& record) {
        at = members_.skip_decorations(at + 1, nullptr, &record.api);
        while (tokens_[at].identifier() && (tokens_[at + 1].identifier() && !tokens_[at + 1].is("final"))) {
            // MACRO Name
            if (is_api_macro(tokens_[at].text))
                record.api = tokens_[at].text;
            header_.blanks.push_back({tokens_[at].begin, tokens_[at].end});
            at = members_.skip_decorations(at + 1, nullptr, &record.api);
        }
        if (!tokens_[at].identifier())
            return at;
        record.name = tokens_[at].text;
        record.name_offset = tokens_[at].begin;
        record.line = members_.line(at);
        ++at;
        if (tokens_[at].is("<")) {
            record.name.clear(); // an explicit specialisation
            at = body_.skip_template(at - 1);
        }
        if (tokens_[at].is("final")) {
            record.is_final = true;
            ++at;
        }
        if (!tokens_[at].is(":"))
            return at;
        ++at;
        std::string access = record.name.starts_with("F") ? "public" : "private";
        while (!tokens_[at].is("{") && !tokens_[at].is(";") && tokens_[at].kind != TokenKind::end) {
            Base base;
            base.access = access;
            std::size_t begin = at;
            while (tokens_[at].is("public") || tokens_[at].is("protected") || tokens_[at].is("private") ||
                   tokens_[at].is("virtual")) {
                if (!tokens_[at].is("virtual"))
                    base.access = tokens_[at].text;
                ++at;
            }
            if (tokens_[at].identifier() && is_api_macro(tokens_[at].text))
                ++at;
            auto type = parse_type(tokens_, at, end_index(tokens_));
            if (!type) {
                ++at;
                continue;
            }
            base.name = type->bare();
            base.text = normalise_spaces(members_.slice(begin, at));
            record.bases.push_back(base);
            while (!tokens_[at].is(",") && !tokens_[at].is("{") && !tokens_[at].is(";") &&
                   tokens_[at].kind != TokenKind::end)
                ++at;
            if (tokens_[at].is(","))
                ++at;
        }
        return at;
    }

    void begin_record(Record& record, std::size_t& at, const std::string& space) {
        std::string macro(tokens_[at].text);
        members_.begin_declared(record, at);
        std::size_t close = parse_specifiers(source_, tokens_, at + 1, record.specifiers);
        header_.blanks.push_back({tokens_[at].begin, tokens_[close].end});
        at = members_.skip_decorations(close + 1);
        if (tokens_[at].is(";")) // UCLASS(); happens
            ++at;
        record.in_namespace = !space.empty();
        if (!space.empty())
            members_.fail("namespaced-type", at, macro,
                "a reflected type stands in namespace " + space + ", which UHT does not know");
    }

    std::size_t annotated_class(std::size_t at, const std::string& space) {
        std::size_t macro = at;
        Class c;
        c.interface = tokens_[at].is("UINTERFACE");
        begin_record(c, at, space);
        if (!tokens_[at].is("class")) {
            members_.fail("unparsed-declaration", macro, std::string(tokens_[macro].text),
                "is not followed by a class; it is skipped");
            return at;
        }
        at = record_head(at, c);
        if (!tokens_[at].is("{") || c.name.empty()) {
            members_.fail(
                "missing-body", macro, c.name.empty() ? "UCLASS" : c.name, "no class body follows; it is skipped");
            return at;
        }
        std::size_t close = matching(tokens_, at);
        if (c.name.size() < 2) {
            members_.fail("prefix", macro, c.name, "is too short for a class name with its prefix; it is skipped");
            return close + 1;
        }
        body_.body(c, at, close, c.name, false);
        header_.defined_names.push_back(c.name);
        header_.classes.push_back(std::move(c));
        return close + 1;
    }

    std::size_t annotated_struct(std::size_t at, const std::string& space) {
        std::size_t macro = at;
        Struct s;
        begin_record(s, at, space);
        if (!tokens_[at].is("struct") && !tokens_[at].is("class")) {
            members_.fail("unparsed-declaration", macro, "USTRUCT", "is not followed by a struct; it is skipped");
            return at;
        }
        at = record_head(at, s);
        if (!tokens_[at].is("{") || s.name.empty()) {
            members_.fail(
                "missing-body", macro, s.name.empty() ? "USTRUCT" : s.name, "no struct body follows; it is skipped");
            return at;
        }
        std::size_t close = matching(tokens_, at);
        if (s.name.size() < 2) {
            members_.fail("prefix", macro, s.name, "is too short for a struct name with its prefix; it is skipped");
            return close + 1;
        }
        body_.body(s, at, close, "", true);
        header_.defined_names.push_back(s.name);
        header_.structs.push_back(std::move(s));
        return close + 1;
    }

    // A class or struct without a reflection macro: an I class of an interface, or something to pass by.
    std::size_t plain_record(std::size_t at, const std::string& space) {
        Record r;
        std::size_t i = record_head(at, r);
        if (!tokens_[i].is("{")) {
            if (tokens_[i].is(";"))
                return i + 1;
            return std::max(plain_statement(i, end_index(tokens_)), at + 1);
        }
        std::size_t close = matching(tokens_, i);
        if (!r.name.empty())
            header_.defined_names.push_back(r.name);
        bool candidate = r.name.size() > 1 && r.name[0] == 'I';
        bool has_body_macro = false;
        for (std::size_t k = i; candidate && k < close; ++k)
            has_body_macro = has_body_macro || (tokens_[k].identifier() && is_body_macro(tokens_[k].text));
        if (has_body_macro) {
            members_.begin_declared(r, at);
            r.in_namespace = !space.empty();
            body_.body(r, i, close, "", false);
            header_.native_interfaces.push_back(std::move(r));
        } else {
            body_.orphans_inside(i, close);
        }
        return close + 1;
    }

    std::size_t plain_enum(std::size_t at) {
        std::size_t i = at + 1;
        if (tokens_[i].is("class") || tokens_[i].is("struct"))
            ++i;
        if (tokens_[i].identifier())
            header_.defined_names.emplace_back(tokens_[i].text);
        while (!tokens_[i].is("{") && !tokens_[i].is(";") && tokens_[i].kind != TokenKind::end)
            ++i;
        return tokens_[i].is("{") ? members_.skip_statement(i) : i + 1;
    }

    std::size_t annotated_enum(std::size_t at, const std::string& space) {
        std::size_t macro = at;
        Enum e;
        members_.begin_declared(e, at);
        std::size_t close = parse_specifiers(source_, tokens_, at + 1, e.specifiers);
        header_.blanks.push_back({tokens_[at].begin, tokens_[close].end});
        at = members_.skip_decorations(close + 1);
        e.in_namespace = !space.empty();
        if (!space.empty())
            members_.fail("namespaced-type", macro, "UENUM", "a reflected enum stands in namespace " + space);
        std::size_t outer_close = 0;
        e.form = "regular";
        if (tokens_[at].is("namespace") && tokens_[at + 1].identifier()) {
            e.form = "namespaced";
            e.name = tokens_[at + 1].text;
            std::size_t open = at + 2;
            outer_close = matching(tokens_, open);
            header_.defined_names.push_back(e.name);
            at = open + 1;
            while (at < outer_close && !tokens_[at].is("enum"))
                ++at;
        }
        if (!tokens_[at].is("enum")) {
            members_.fail("unparsed-declaration", macro, "UENUM", "is not followed by an enum; it is skipped");
            return at;
        }
        ++at;
        if (tokens_[at].is("class") || tokens_[at].is("struct")) {
            if (e.form == "regular")
                e.form = "class";
            ++at;
        }
        at = members_.skip_decorations(at);
        std::string inner = tokens_[at].identifier() ? std::string(tokens_[at].text) : std::string();
        if (!inner.empty()) {
            e.name_offset = tokens_[at].begin;
            e.line = members_.line(at);
            ++at;
        } else {
            e.line = members_.line(macro);
        }
        if (e.form == "namespaced") {
            e.cpp_type = e.name + "::" + (inner.empty() ? "Type" : inner);
        } else {
            e.name = inner;
            e.cpp_type = inner;
        }
        if (tokens_[at].is(":")) {
            std::size_t begin = ++at;
            while (!tokens_[at].is("{") && !tokens_[at].is(";") && tokens_[at].kind != TokenKind::end)
                ++at;
            e.underlying = canonical_builtin(normalise_spaces(members_.slice(begin, at)));
        }
        if (!tokens_[at].is("{") || e.name.empty()) {
            members_.fail(
                "missing-body", macro, e.name.empty() ? "UENUM" : e.name, "no enumerators follow; it is skipped");
            return at;
        }
        std::size_t enum_close = matching(tokens_, at);
        entries(e, at + 1, enum_close);
        header_.defined_names.push_back(e.name);
        header_.enums.push_back(std::move(e));
        return outer_close != 0
                   ? outer_close + 1
                   : members_.skip_statement(enum_close + 1 < tokens_.size() ? enum_close + 1 : enum_close);
    }

    void entries(Enum& e, std::size_t at, std::size_t close) {
        while (at < close) {
            if (!tokens_[at].identifier()) {
                ++at;
                continue;
            }
            EnumEntry entry;
            entry.comment = members_.comment_before(at);
            if (is_macro_like(tokens_[at].text) && tokens_[at + 1].is("(")) { // a macro before the name
                std::size_t end = matching(tokens_, at + 1);
                header_.blanks.push_back({tokens_[at].begin, tokens_[end].end});
                at = end + 1;
                if (at >= close || !tokens_[at].identifier())
                    continue;
            }
            entry.name = tokens_[at].text;
            entry.name_offset = tokens_[at].begin;
            entry.line = members_.line(at);
            ++at;
            std::size_t value_begin = 0, value_end = 0;
            while (at < close && !tokens_[at].is(",")) {
                bool call = tokens_[at + 1].is("(");
                if (tokens_[at].is("UMETA") && call) {
                    if (value_begin != 0 && value_end == 0)
                        value_end = at;
                    std::size_t end = parse_specifiers(source_, tokens_, at + 1, entry.specifiers);
                    header_.blanks.push_back({tokens_[at].begin, tokens_[end].end});
                    at = end + 1;
                } else if (value_begin == 0 && tokens_[at].identifier() && is_macro_like(tokens_[at].text) && call) {
                    std::size_t end = matching(tokens_, at + 1); // UE_DEPRECATED(...)
                    header_.blanks.push_back({tokens_[at].begin, tokens_[end].end});
                    at = end + 1;
                } else if (tokens_[at].is("=")) {
                    value_begin = ++at;
                } else if (tokens_[at].is("(") || tokens_[at].is("{")) {
                    at = matching(tokens_, at) + 1;
                } else {
                    ++at;
                }
            }
            if (value_begin != 0) {
                if (value_end == 0)
                    value_end = at;
                entry.value_text = members_.slice(value_begin, value_end);
                entry.value_range = {tokens_[value_begin].begin, tokens_[value_end].begin};
            }
            e.entries.push_back(std::move(entry));
            ++at;
        }
    }

    Header& header_;
    BodyScanner body_;
    MemberParser& members_;
    const std::vector<Token>& tokens_;
    const SourceText& source_;
};

} // namespace

void scan(Header& header, const ConditionMap& conditions, Report& report) { Scanner(header, conditions, report).run(); }

} // namespace spear::header_tool
