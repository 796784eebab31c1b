// SPDX-License-Identifier: MIT
#include "constants.h"

#include "specifiers.h"
#include "type_syntax.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>

namespace spear::header_tool {

namespace {

constexpr std::size_t longest_expression = 400;
constexpr int deepest_expression = 100;

struct Integer {
    std::string_view name;
    unsigned bits;
    bool is_signed;
};

constexpr std::array<Integer, 16> integers{{{"int8", 8, true}, {"int16", 16, true}, {"int32", 32, true},
    {"int64", 64, true}, {"uint8", 8, false}, {"uint16", 16, false}, {"uint32", 32, false}, {"uint64", 64, false},
    {"int", 32, true}, {"unsigned", 32, false}, {"char", 8, true}, {"short", 16, true}, {"long", 64, true},
    {"SIZE_T", 64, false}, {"size_t", 64, false}, {"bool", 1, false}}};

const Integer* integer(std::string_view name) {
    if (name.ends_with("_t") && name != "size_t")
        name.remove_suffix(2);
    auto it = std::find_if(integers.begin(), integers.end(), [&](const Integer& i) { return i.name == name; });
    return it == integers.end() ? nullptr : &*it;
}

long long cast_to(const Integer& type, long long value) {
    if (type.bits == 1)
        return value != 0;
    if (type.bits == 64)
        return value;
    unsigned long long mask = (1ull << type.bits) - 1, cut = static_cast<unsigned long long>(value) & mask;
    if (type.is_signed && (cut >> (type.bits - 1)) != 0)
        cut |= ~mask;
    return static_cast<long long>(cut);
}

std::optional<long long> literal(const Token& token) {
    std::string digits;
    for (char c : token.text)
        if (c != '\'' || token.kind == TokenKind::character)
            digits += c;
    if (token.kind == TokenKind::character) {
        std::size_t open = digits.find('\'');
        bool plain = digits.size() == open + 3 && digits[open + 1] != '\\';
        return plain ? std::optional<long long>(digits[open + 1]) : std::nullopt;
    }
    while (!digits.empty() && std::string_view("uUlL").find(digits.back()) != std::string_view::npos)
        digits.pop_back();
    int base = 0;
    const char* begin = digits.c_str();
    if (digits.starts_with("0b") || digits.starts_with("0B")) {
        base = 2;
        begin += 2;
    }
    char* stop = nullptr;
    unsigned long long value = std::strtoull(begin, &stop, base);
    if (stop == begin || *stop != '\0')
        return std::nullopt;
    return static_cast<long long>(value);
}

class Evaluator {
public:
    Evaluator(const std::vector<Token>& tokens, const NameValue& names) : tokens_(tokens), names_(names) {}

    std::optional<long long> run() {
        auto value = conditional();
        return good_ && at_ == end_index(tokens_) ? std::optional(value) : std::nullopt;
    }

private:
    const Token& token(std::size_t ahead = 0) const { return tokens_[std::min(at_ + ahead, end_index(tokens_))]; }

    long long fail() {
        good_ = false;
        return 0;
    }

    // Two characters that stand together: "<<", "==".
    bool pair(std::string_view spelling) const {
        if (token().text == spelling && token().kind == TokenKind::punctuation)
            return true;
        return token().is(spelling.substr(0, 1)) && token(1).is(spelling.substr(1)) && token().end == token(1).begin;
    }

    bool take(std::string_view spelling) {
        if (spelling.size() == 2) {
            if (!pair(spelling))
                return false;
            at_ += token().text.size() == 2 ? 1 : 2;
            return true;
        }
        if (!token().is(spelling))
            return false;
        for (std::string_view longer : {"<<", ">>", "<=", ">=", "==", "!=", "||"})
            if (longer.starts_with(spelling) && pair(longer))
                return false;
        ++at_;
        return true;
    }

    long long conditional() {
        long long condition = binary(0);
        if (!good_ || !take("?"))
            return condition;
        long long yes = conditional();
        if (!take(":"))
            return fail();
        long long no = conditional();
        return condition != 0 ? yes : no;
    }

    static constexpr std::array<std::array<std::string_view, 4>, 10> levels{{{"||"}, {"&&"}, {"|"}, {"^"}, {"&"},
        {"==", "!="}, {"<=", ">=", "<", ">"}, {"<<", ">>"}, {"+", "-"}, {"*", "/", "%"}}};

    long long binary(std::size_t level) {
        if (level == levels.size())
            return unary();
        long long left = binary(level + 1);
        for (bool found = true; good_ && found;) {
            found = false;
            for (std::string_view op : levels[level]) {
                if (op.empty() || !take(op))
                    continue;
                left = apply(op, left, binary(level + 1));
                found = true;
                break;
            }
        }
        return left;
    }

    long long apply(std::string_view op, long long a, long long b) {
        auto u = [](long long v) { return static_cast<unsigned long long>(v); };
        if (op == "||")
            return a != 0 || b != 0;
        if (op == "&&")
            return a != 0 && b != 0;
        if (op == "==")
            return a == b;
        if (op == "!=")
            return a != b;
        if (op == "<=")
            return a <= b;
        if (op == ">=")
            return a >= b;
        if ((op == "<<" || op == ">>") && (b < 0 || b > 63))
            return fail();
        if (op == "<<")
            return static_cast<long long>(u(a) << b);
        if (op == ">>")
            return a >> b;
        switch (op[0]) {
        case '|':
            return a | b;
        case '^':
            return a ^ b;
        case '&':
            return a & b;
        case '<':
            return a < b;
        case '>':
            return a > b;
        case '+':
            return static_cast<long long>(u(a) + u(b));
        case '-':
            return static_cast<long long>(u(a) - u(b));
        case '*':
            return static_cast<long long>(u(a) * u(b));
        default:
            if (b == 0 || b == -1) // -1: the one division that can overflow
                return b == 0 ? fail() : static_cast<long long>(op[0] == '/' ? 0 - u(a) : 0);
            return op[0] == '/' ? a / b : a % b;
        }
    }

    long long unary() {
        if (++depth_ > deepest_expression)
            return fail();
        long long out = 0;
        if (take("-"))
            out = static_cast<long long>(0 - static_cast<unsigned long long>(unary()));
        else if (take("+"))
            out = unary();
        else if (take("~"))
            out = ~unary();
        else if (take("!"))
            out = unary() == 0;
        else
            out = primary();
        --depth_;
        return out;
    }

    // "uint8", "unsigned int", "EFoo": names that a cast may hold; empty if none starts here.
    std::string type_name() {
        std::size_t i = at_;
        std::optional<TypeSyntax> type = parse_type(tokens_, i, end_index(tokens_));
        if (!type || type->pointers > 0 || !type->args.empty())
            return {};
        at_ = i;
        return canonical_builtin(type->name);
    }

    long long converted(const std::string& type, long long value) const {
        const Integer* builtin = integer(type);
        return builtin ? cast_to(*builtin, value) : value;
    }

    long long primary() {
        if (token().kind == TokenKind::number || token().kind == TokenKind::character) {
            auto value = literal(token());
            ++at_;
            return value ? *value : fail();
        }
        if (token().is("(")) {
            std::size_t open = at_++;
            std::size_t close = matching(tokens_, open);
            // "(uint8)EFoo::Bar": a type in parentheses, an operand behind it.
            const Token& after = tokens_[std::min(close + 1, end_index(tokens_))];
            bool operand = after.identifier() || after.kind == TokenKind::number || after.is("(") || after.is("~");
            if (operand && token().identifier()) {
                std::string type = type_name();
                if (!type.empty() && at_ == close) {
                    ++at_;
                    return converted(type, unary());
                }
                at_ = open + 1;
            }
            long long value = conditional();
            return take(")") ? value : fail();
        }
        if (!token().identifier())
            return fail();
        if (token().is("true") || token().is("false"))
            return tokens_[at_++].is("true");
        if (token().is("static_cast") && token(1).is("<")) {
            at_ += 2;
            std::string type = type_name();
            if (type.empty() || !take(">") || !take("("))
                return fail();
            long long value = conditional();
            return take(")") ? converted(type, value) : fail();
        }
        std::string name(tokens_[at_++].text);
        while (token().is("::") && token(1).identifier()) {
            name += "::" + std::string(token(1).text);
            at_ += 2;
        }
        if (token().is("(") || token().is("{")) { // uint8(5), int32{5}; a call computes something
            const Integer* builtin = integer(name);
            if (!builtin)
                return fail();
            bool brace = token().is("{");
            ++at_;
            long long value = conditional();
            return take(brace ? "}" : ")") ? cast_to(*builtin, value) : fail();
        }
        auto value = names_(name);
        return value ? *value : fail();
    }

    const std::vector<Token>& tokens_;
    const NameValue& names_;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool good_ = true;
};

bool could_be_constant(const std::string& text) {
    if (text.empty() || text.size() > longest_expression || text.find('"') != std::string::npos)
        return false;
    return std::isalnum(static_cast<unsigned char>(text[0])) ||
           std::string_view("_(-+~!'").find(text[0]) != std::string_view::npos;
}

// The entries of the enum whose '{' is tokens[open], each with a text that needs only the one before it.
void add_entries(const std::vector<Token>& t, std::size_t open, const std::string& scope, const std::string& alias,
    std::vector<ConstantFacts>& out) {
    std::size_t close = matching(t, open);
    std::string written; // the last entry with a value of its own
    int behind = 0;
    for (std::size_t i = open + 1; i < close; ++i) {
        if (!t[i].identifier())
            return;
        std::string name(t[i].text), text;
        std::size_t end = i + 1;
        while (end < close && !t[end].is(","))
            end = t[end].is("(") || t[end].is("{") ? matching(t, end) + 1 : end + 1;
        if (t[i + 1].is("="))
            for (std::size_t k = i + 2; k < std::min(end, close); ++k)
                text += (t[k].begin > t[k - 1].end ? " " : "") + std::string(t[k].text);
        else
            text = (written.empty() ? "" : written + " + ") + std::to_string(behind);
        text = std::string(trim(text));
        std::string full = scope.empty() ? name : scope + "::" + name;
        if (!could_be_constant(text))
            return;
        out.push_back({full, text});
        if (!alias.empty())
            out.push_back({alias + "::" + name, full});
        if (t[i + 1].is("=")) {
            written = full;
            behind = 0;
        }
        ++behind;
        i = end;
    }
}

} // namespace

std::optional<long long> evaluate(const std::string& expression, const NameValue& names) {
    if (expression.empty() || expression.size() > longest_expression)
        return std::nullopt;
    SourceText source(expression);
    LexResult lexed = lex(source, {});
    return Evaluator(lexed.tokens, names).run();
}

std::vector<std::string> names_in(const std::string& expression) {
    if (expression.empty() || std::isdigit(static_cast<unsigned char>(expression[0])))
        if (expression.find_first_not_of("0123456789") == std::string::npos)
            return {};
    SourceText source(expression);
    LexResult lexed = lex(source, {});
    std::vector<std::string> out;
    for (std::size_t i = 0; i < end_index(lexed.tokens); ++i) {
        if (!lexed.tokens[i].identifier())
            continue;
        std::string name(lexed.tokens[i].text);
        while (lexed.tokens[i + 1].is("::") && lexed.tokens[i + 2].identifier()) {
            name += "::" + std::string(lexed.tokens[i + 2].text);
            i += 2;
        }
        if (!integer(name) && name != "static_cast" && name != "true" && name != "false")
            out.push_back(std::move(name));
    }
    return out;
}

std::vector<ConstantFacts> find_constants(const LexResult& lexed) {
    std::vector<ConstantFacts> out;
    for (const Directive& d : lexed.directives) {
        if (d.name != "define")
            continue;
        std::size_t end = 0;
        while (end < d.rest.size() && (std::isalnum(static_cast<unsigned char>(d.rest[end])) || d.rest[end] == '_'))
            ++end;
        if (end == 0 || end >= d.rest.size() || !std::isspace(static_cast<unsigned char>(d.rest[end])))
            continue; // empty, or with parameters
        std::string text(trim(std::string_view(d.rest).substr(end)));
        if (could_be_constant(text))
            out.push_back({d.rest.substr(0, end), text});
    }
    const std::vector<Token>& t = lexed.tokens;
    std::size_t last = end_index(t);
    std::vector<std::pair<std::size_t, std::string>> scopes; // index of the closing brace, name
    for (std::size_t i = 0; i < last; ++i) {
        while (!scopes.empty() && i >= scopes.back().first)
            scopes.pop_back();
        std::string scope = scopes.empty() ? std::string() : scopes.back().second;
        auto add = [&](const std::string& name, std::size_t begin, std::size_t end) {
            if (begin >= end || t[end - 1].end - t[begin].begin > longest_expression)
                return;
            std::string text(t[begin].text);
            for (std::size_t k = begin + 1; k < end; ++k)
                text += (t[k].begin > t[k - 1].end ? " " : "") + std::string(t[k].text);
            if (could_be_constant(text))
                out.push_back({scope.empty() ? name : scope + "::" + name, text});
        };
        if ((t[i].is("class") || t[i].is("struct") || t[i].is("namespace")) && scopes.size() < 64) {
            std::string name;
            std::size_t k = i + 1;
            for (; k < last && !t[k].is("{") && !t[k].is(";") && !t[k].is("(") && !t[k].is(":") && !t[k].is("<") &&
                   !t[k].is(">") && !t[k].is("=");
                ++k)
                if (t[k].identifier() && !t[k].is("final") && !(i > 0 && t[i - 1].is("enum")))
                    name = t[k].text;
            while (k < last && t[k].is(":") && !t[k].is("{") && !t[k].is(";"))
                for (++k; k < last && !t[k].is("{") && !t[k].is(";"); ++k) {}
            if (t[k].is("{") && !(i > 0 && t[i - 1].is("enum"))) {
                scopes.emplace_back(matching(t, k), name);
                i = k;
            }
        } else if (t[i].is("enum") && !(i > 0 && t[i - 1].is(")"))) { // one that is not reflected
            bool scoped = t[i + 1].is("class") || t[i + 1].is("struct");
            std::size_t k = i + 1 + (scoped ? 1 : 0);
            std::string name = t[k].identifier() ? std::string(t[k].text) : std::string();
            while (k < last && !t[k].is("{") && !t[k].is(";") && !t[k].is(")") && !t[k].is(","))
                ++k;
            if (!t[k].is("{") || (scoped && name.empty()))
                continue;
            add_entries(t, k, scoped ? name : scope, scoped ? "" : name, out);
            i = matching(t, k);
        } else if (t[i].is("constexpr") || (t[i].is("const") && (i == 0 || !t[i - 1].is("constexpr")))) {
            std::size_t k = i + 1;
            while (t[k].is("static") || t[k].is("inline") || t[k].is("const") || t[k].is("constexpr"))
                ++k;
            if (!integer(t[k].text) || k >= last)
                continue;
            while (t[k].identifier() && t[k + 1].identifier())
                ++k;
            bool brace = t[k + 1].is("{");
            if (!t[k].identifier() || !(t[k + 1].is("=") || brace))
                continue;
            std::size_t end = k + 2;
            if (brace)
                end = matching(t, k + 1);
            else
                while (end < last && !t[end].is(";") && !t[end].is(",") && !t[end].is(")"))
                    end = t[end].is("(") ? matching(t, end) + 1 : end + 1;
            if (t[end].is(";") || brace)
                add(std::string(t[k].text), k + 2, std::min(end, last));
            i = k + 1;
        }
    }
    return out;
}

} // namespace spear::header_tool
