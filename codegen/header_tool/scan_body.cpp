// SPDX-License-Identifier: MIT
#include "scan_body.h"

#include "specifiers.h"

#include <algorithm>

namespace spear::header_tool {

std::size_t BodyScanner::skip_template(std::size_t at) const {
    ++at;
    if (!tokens_[at].is("<"))
        return at;
    int depth = 0;
    for (; at + 1 < tokens_.size(); ++at) {
        if (tokens_[at].is("("))
            at = matching(tokens_, at);
        else if (tokens_[at].is("<"))
            ++depth;
        else if (tokens_[at].is(">") && --depth == 0)
            return at + 1;
    }
    return at;
}

void BodyScanner::orphans_inside(std::size_t from, std::size_t to) const {
    for (std::size_t i = from; i < to; ++i)
        if (tokens_[i].identifier() && is_reflection_macro(tokens_[i].text) && tokens_[i + 1].is("("))
            members_.fail("nested-type", i, std::string(tokens_[i].text),
                "stands inside a body that is not reflected; it is skipped");
}

std::size_t BodyScanner::delegate(std::size_t at, const std::string& owner, const std::string& space) {
    Delegate d;
    if (tokens_[at].is("UDELEGATE")) {
        members_.begin_declared(d, at);
        std::size_t close = parse_specifiers(source_, tokens_, at + 1, d.specifiers);
        header_.blanks.push_back({tokens_[at].begin, tokens_[close].end});
        at = close + 1;
        if (!is_delegate_macro(tokens_[at].text)) {
            members_.fail(
                "unparsed-declaration", at, "UDELEGATE", "is not followed by a dynamic delegate; it is skipped");
            return at;
        }
    }
    d.owner = owner;
    if (!space.empty())
        members_.fail(
            "namespaced-type", at, std::string(tokens_[at].text), "a dynamic delegate stands in namespace " + space);
    if (members_.delegate(at, d))
        header_.delegates.push_back(std::move(d));
    return at;
}

// Members of a class, interface or struct body; tokens[open] is '{'.
void BodyScanner::body(Record& r, std::size_t open, std::size_t close, const std::string& owner, bool is_struct) {
    r.has_body = true;
    r.body = {tokens_[open].begin, tokens_[close].end};
    Access access = is_struct ? Access::public_ : Access::private_;
    std::size_t at = open + 1;
    while (at < close) {
        const Token& t = tokens_[at];
        const Token& next = tokens_[at + 1];
        bool call = next.is("(");
        if ((t.is("public") || t.is("protected") || t.is("private")) && next.is(":")) {
            access = t.is("public") ? Access::public_ : t.is("protected") ? Access::protected_ : Access::private_;
            at += 2;
        } else if (call && t.identifier() && is_body_macro(t.text)) {
            bool legacy = !t.is("GENERATED_BODY");
            if (legacy && !is_struct)
                access = Access::public_; // GENERATED_UCLASS_BODY() and its kind end in public:
            r.generated_body = GeneratedBody{std::string(t.text), to_string(access), members_.line(at)};
            std::size_t end = matching(tokens_, at + 1);
            header_.blanks.push_back({t.begin, tokens_[end].end});
            at = end + 1;
            if (tokens_[at].is(";"))
                ++at;
        } else if (call && t.is("UFUNCTION")) {
            Function f;
            f.access = access;
            std::size_t macro = at;
            if (members_.function(at, f)) {
                decorate(f, &f.deprecated, macro);
                r.declares.insert(f.name);
                r.functions.push_back(std::move(f));
            }
        } else if (call && t.is("UPROPERTY")) {
            std::size_t macro = at;
            for (Property& p : members_.properties(at)) {
                p.access = access;
                decorate(p, nullptr, macro);
                r.properties.push_back(std::move(p));
            }
        } else if (call && (t.is("UDELEGATE") || is_delegate_macro(t.text))) {
            at = delegate(at, owner, "");
        } else if (call && (t.is("UENUM") || t.is("USTRUCT") || t.is("UCLASS") || t.is("UINTERFACE"))) {
            members_.fail("nested-type", at, std::string(t.text),
                "a reflected type cannot be declared inside " + r.name + "; it is skipped");
            at = matching(tokens_, at + 1) + 1;
        } else if (t.is(";") || t.is("}")) {
            ++at;
        } else {
            at = member(r, at, close, access);
        }
    }
}

void BodyScanner::decorate(Declared& declared, std::string* deprecated, std::size_t at) const {
    if (decoration_end_ != at || decoration_end_ == 0)
        return;
    if (declared.comment.empty())
        declared.comment = members_.comment_before(decoration_begin_);
    if (deprecated && deprecated->empty())
        *deprecated = decoration_deprecated_;
}

// An unreflected member: noted if it declares a function, else passed by.
std::size_t BodyScanner::member(Record& r, std::size_t at, std::size_t close, Access access) {
    std::size_t begin = at;
    if (tokens_[at].is("template"))
        at = skip_template(at);
    if ((tokens_[at].is("class") || tokens_[at].is("struct") || tokens_[at].is("union")) || tokens_[at].is("enum")) {
        std::size_t i = at;
        while (i < close && !tokens_[i].is("{") && !tokens_[i].is(";") && !tokens_[i].is("("))
            ++i;
        if (tokens_[i].is("{")) {
            std::size_t end = matching(tokens_, i);
            orphans_inside(i, end);
            return members_.skip_statement(end + 1);
        }
    }
    for (std::size_t i = at; i < close; ++i) {
        const Token& t = tokens_[i];
        if (i > begin && tokens_[i + 1].is("(") && (is_reflection_macro(t.text) || is_body_macro(t.text)))
            return macro_end(begin, i); // a macro without semicolon stood before it
        if (t.is(";") || t.is("=") || t.is("{") || (t.is(":") && i > begin))
            break;
        if (t.is(":"))
            continue;
        if (t.is("(")) {
            i = matching(tokens_, i);
            continue;
        }
        if (!t.identifier() || !tokens_[i + 1].is("("))
            continue;
        std::size_t end = matching(tokens_, i + 1);
        if (t.is("DECLARE_FUNCTION")) {
            r.declares.insert(members_.slice(i + 2, end));
            return members_.skip_statement(i);
        }
        const Token& after = tokens_[std::min(end + 1, end_index(tokens_))];
        if (is_macro_like(t.text) && !after.is(";") && !after.is("const") && !after.is("override") && !after.is("{")) {
            // MACRO(...) in front of a declaration, or alone on its line
            header_.blanks.push_back({t.begin, tokens_[end].end});
            decoration_begin_ = i;
            decoration_end_ = end + 1;
            decoration_deprecated_ =
                t.text.find("DEPRECATED") != std::string_view::npos ? members_.slice(i + 2, end) : std::string();
            return end + 1;
        }
        if (t.is("alignas") || t.is("decltype") || t.is("__declspec") || t.is("noexcept") || t.is("__attribute__")) {
            i = end;
            continue;
        }
        function_like(r, begin, i, end, access);
        break;
    }
    return members_.skip_statement(at);
}

// Capital words between `begin` and the reflection macro at `macro` are macros without semicolon.
std::size_t BodyScanner::macro_end(std::size_t begin, std::size_t macro) {
    for (std::size_t i = begin; i < macro; ++i)
        if (tokens_[i].identifier() && is_macro_like(tokens_[i].text)) {
            bool call = tokens_[i + 1].is("(");
            std::size_t end = call ? matching(tokens_, i + 1) : i;
            header_.blanks.push_back({tokens_[i].begin, tokens_[end].end});
            report_.note("macro-blanked", header_.path, members_.line(i), std::string(tokens_[i].text),
                "macro without semicolon taken as empty");
            i = end;
        }
    return macro;
}

void BodyScanner::function_like(Record& r, std::size_t begin, std::size_t name, std::size_t params_end, Access access) {
    const Token& t = tokens_[name];
    bool destructor = name > begin && tokens_[name - 1].is("~");
    if (destructor) {
        r.destructor = true;
        return;
    }
    if (t.text != r.name) {
        r.declares.insert(std::string(t.text));
        return;
    }
    Constructor c;
    c.access = to_string(access);
    c.line = members_.line(name);
    std::size_t first = name + 2;
    bool initializer = false, helper = false,
         optional = params_end == first || (params_end == first + 1 && tokens_[first].is("void"));
    int commas = 0;
    bool all_default = true, this_default = false;
    for (std::size_t i = first; i < params_end; ++i) {
        initializer |= tokens_[i].is("FObjectInitializer");
        helper |= tokens_[i].is("FVTableHelper");
        this_default |= tokens_[i].is("=");
        if (tokens_[i].is("(") || tokens_[i].is("{"))
            i = matching(tokens_, i);
        if (tokens_[i].is(",")) {
            ++commas;
            all_default &= this_default;
            this_default = false;
        }
    }
    all_default &= this_default;
    if (helper)
        c.kind = "vtable_helper";
    else if (initializer && commas == 0)
        c.kind = "object_initializer";
    else
        c.kind = optional || all_default ? "default" : "other";
    for (std::size_t i = params_end + 1;
        i + 1 < tokens_.size() && !tokens_[i].is(";") && !tokens_[i].is("{") && !tokens_[i].is(":"); ++i) {
        c.deleted |= tokens_[i].is("delete");
        c.defaulted |= tokens_[i].is("default");
    }
    r.constructors.push_back(c);
}

} // namespace spear::header_tool
