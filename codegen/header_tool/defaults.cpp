// SPDX-License-Identifier: MIT
// Default arguments: from C++ text to what UHT stores as CPP_Default_<Param>.
#include "metadata.h"
#include "specifiers.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace spear::header_tool {

namespace {

using Tokens = std::vector<Token>;

struct Text {
    SourceText source;
    Tokens tokens; // without the end token
    explicit Text(const std::string& text) : source(text), tokens(lex(source, {}).tokens) {
        tokens.resize(end_index(tokens));
    }
};

std::optional<double> number(const Tokens& t, std::size_t begin, std::size_t end) {
    double sign = 1;
    while (begin < end && (t[begin].is("-") || t[begin].is("+"))) {
        if (t[begin].is("-"))
            sign = -sign;
        ++begin;
    }
    if (begin + 3 == end && t[begin].is("(") && t[begin + 2].is(")"))
        return number(t, begin + 1, end - 1);
    if (begin + 1 != end)
        return std::nullopt;
    static const std::array<std::pair<std::string_view, double>, 16> constants{
        {{"INDEX_NONE", -1.0}, {"MAX_int32", 2147483647.0}, {"MIN_int32", -2147483648.0}, {"MAX_uint8", 255.0},
            {"MAX_int8", 127.0}, {"MAX_uint16", 65535.0}, {"MAX_int16", 32767.0}, {"MAX_uint32", 4294967295.0},
            {"MAX_FLT", std::numeric_limits<float>::max()}, {"FLT_MAX", std::numeric_limits<float>::max()},
            {"BIG_NUMBER", 3.4e+38f}, {"UE_BIG_NUMBER", 3.4e+38f}, {"KINDA_SMALL_NUMBER", 1.e-4f},
            {"UE_KINDA_SMALL_NUMBER", 1.e-4f}, {"SMALL_NUMBER", 1.e-8f}, {"UE_SMALL_NUMBER", 1.e-8f}}};
    for (const auto& [name, value] : constants)
        if (t[begin].is(name))
            return sign * value;
    if (t[begin].kind != TokenKind::number)
        return std::nullopt;
    std::string digits;
    for (char c : t[begin].text)
        if (c != '\'')
            digits += c;
    bool hex = digits.starts_with("0x") || digits.starts_with("0X");
    while (!digits.empty() && (std::string_view("uUlL").find(digits.back()) != std::string_view::npos ||
                                  (!hex && std::string_view("fF").find(digits.back()) != std::string_view::npos)))
        digits.pop_back();
    if (digits.starts_with("0b") || digits.starts_with("0B"))
        return sign * static_cast<double>(std::strtoull(digits.c_str() + 2, nullptr, 2));
    if (digits.size() > 1 && digits[0] == '0' && digits.find_first_not_of("01234567") == std::string::npos)
        return sign * static_cast<double>(std::strtoull(digits.c_str(), nullptr, 8));
    char* stop = nullptr;
    double value = std::strtod(digits.c_str(), &stop);
    if (stop == digits.c_str() || *stop != '\0')
        return std::nullopt;
    return sign * value;
}

// The numbers of "Name(a, b, c)" or "{a, b}"; nullopt when an argument is none.
std::optional<std::vector<double>> arguments(const Tokens& t, std::size_t open) {
    std::size_t close = t.size() - 1;
    if (!(t[close].is(")") || t[close].is("}")))
        return std::nullopt;
    std::vector<double> out;
    std::size_t begin = open + 1;
    for (std::size_t i = open + 1; i <= close; ++i) {
        if (i < close && !t[i].is(","))
            continue;
        if (i > begin) {
            auto value = number(t, begin, i);
            if (!value)
                return std::nullopt;
            out.push_back(*value);
        }
        begin = i + 1;
    }
    return out;
}

// TEXT("a"), "a", FString(TEXT("a")), FName("a"); nullopt otherwise. An empty constructor gives "".
std::optional<std::string> string_value(const Tokens& t, std::size_t begin, std::size_t end, std::string_view type) {
    if (begin == end)
        return std::nullopt;
    bool literals = true;
    std::string out;
    for (std::size_t i = begin; i < end; ++i) {
        literals = literals && t[i].kind == TokenKind::string;
        if (literals)
            out += unquote(t[i].text);
    }
    if (literals)
        return out;
    bool call = end - begin >= 3 && t[begin + 1].is("(") && t[end - 1].is(")");
    bool braces = end - begin >= 3 && t[begin + 1].is("{") && t[end - 1].is("}");
    if (call && (t[begin].is("TEXT") || t[begin].is("UTF8TEXT") || t[begin].is("ANSITEXT")))
        return string_value(t, begin + 2, end - 1, type);
    if ((call || braces) && t[begin].is(type))
        return begin + 2 == end - 1 ? std::string() : string_value(t, begin + 2, end - 1, type);
    if (end - begin == 2 && t[begin].is("{") && t[begin + 1].is("}"))
        return std::string();
    return std::nullopt;
}

// {}, Type() or Type{}; any other call computes something.
bool empty_construction(const Tokens& t, std::string_view type) {
    if (t.size() == 2 && t[0].is("{"))
        return t[1].is("}");
    if (t.size() < 3 ||
        !((t[t.size() - 2].is("(") && t[t.size() - 1].is(")")) || (t[t.size() - 2].is("{") && t[t.size() - 1].is("}"))))
        return false;
    std::string head, expected;
    for (std::size_t i = 0; i + 2 < t.size(); ++i)
        head += t[i].text;
    for (char c : type)
        if (c != ' ')
            expected += c;
    return head == expected;
}

std::optional<std::string> vector_default(const Tokens& t, const std::string& type) {
    if (empty_construction(t, type))
        return "";
    if (t.size() == 3 && t[0].is(type) && t[1].is("::")) {
        static constexpr std::array<std::array<std::string_view, 3>, 12> constants{{{"FVector", "UpVector", "0,0,1"},
            {"FVector", "DownVector", "0,0,-1"}, {"FVector", "ForwardVector", "1,0,0"},
            {"FVector", "BackwardVector", "-1,0,0"}, {"FVector", "RightVector", "0,1,0"},
            {"FVector", "LeftVector", "0,-1,0"}, {"FVector", "OneVector", "1,1,1"}, {"FVector", "XAxisVector", "1,0,0"},
            {"FVector", "YAxisVector", "0,1,0"}, {"FVector", "ZAxisVector", "0,0,1"},
            {"FVector2D", "UnitVector", "1,1"}, {"FVector2D", "One", "1,1"}}};
        if (t[2].is("ZeroVector") || t[2].is("ZeroRotator") || t[2].is("Zero"))
            return "";
        for (const auto& c : constants)
            if (type == c[0] && t[2].is(c[1])) {
                Text parts("f(" + std::string(c[2]) + ")");
                auto values = arguments(parts.tokens, 1);
                if (type == "FVector2D")
                    return fmt::format("(X={:.3f},Y={:.3f})", (*values)[0], (*values)[1]);
                return fmt::format("{:.6f},{:.6f},{:.6f}", (*values)[0], (*values)[1], (*values)[2]);
            }
        return std::nullopt;
    }
    if (t.size() == 4 && t[0].is(type) && t[1].is("(") &&
        (t[2].is("ForceInit") || t[2].is("ForceInitToZero") || t[2].is("EForceInit::ForceInit")))
        return "";
    std::size_t open = t.size() > 1 && t[0].is(type) ? 1 : 0;
    if (open >= t.size() || !(t[open].is("(") || t[open].is("{")))
        return std::nullopt;
    auto values = arguments(t, open);
    if (!values)
        return std::nullopt;
    if (values->size() == 1)
        values->resize(type == "FVector2D" ? 2 : 3, values->front());
    if (type == "FVector2D")
        return values->size() == 2 ? std::optional(fmt::format("(X={:.3f},Y={:.3f})", (*values)[0], (*values)[1]))
                                   : std::nullopt;
    return values->size() == 3
               ? std::optional(fmt::format("{:.6f},{:.6f},{:.6f}", (*values)[0], (*values)[1], (*values)[2]))
               : std::nullopt;
}

struct Named {
    std::string_view name;
    double r, g, b, a;
};

std::optional<std::string> colour_default(const Tokens& t, const std::string& type) {
    static constexpr std::array<Named, 11> colours{
        {{"White", 1, 1, 1, 1}, {"Black", 0, 0, 0, 1}, {"Transparent", 0, 0, 0, 0}, {"Red", 1, 0, 0, 1},
            {"Green", 0, 1, 0, 1}, {"Blue", 0, 0, 1, 1}, {"Yellow", 1, 1, 0, 1}, {"Gray", 0.5, 0.5, 0.5, 1},
            {"Cyan", 0, 1, 1, 1}, {"Magenta", 1, 0, 1, 1}, {"Orange", 0.95294117, 0.6117647, 0.07058824, 1}}};
    bool linear = type == "FLinearColor";
    auto write = [&](double r, double g, double b, double a) {
        if (linear)
            return fmt::format("(R={:.6f},G={:.6f},B={:.6f},A={:.6f})", r, g, b, a);
        return fmt::format("(R={:.0f},G={:.0f},B={:.0f},A={:.0f})", r, g, b, a);
    };
    double one = linear ? 1.0 : 255.0;
    if (t.size() == 3 && t[0].is(type) && t[1].is("::")) {
        for (const Named& c : colours)
            if (t[2].is(c.name) && !(c.name == "Gray" && !linear))
                return write(std::round(c.r * one * 1e6) / 1e6, std::round(c.g * one * 1e6) / 1e6,
                    std::round(c.b * one * 1e6) / 1e6, c.a * one);
        return std::nullopt;
    }
    if (empty_construction(t, type))
        return "()";
    if (t.size() < 3 || !t[0].is(type))
        return std::nullopt;
    if (t.size() == 4 && t[2].text.starts_with("ForceInit"))
        return write(0, 0, 0, 0);
    auto values = arguments(t, 1);
    if (!values || values->size() < 3)
        return std::nullopt;
    if (values->size() == 3)
        values->push_back(one);
    return write((*values)[0], (*values)[1], (*values)[2], (*values)[3]);
}

} // namespace

std::optional<std::string> normalised_default(const std::string& text, const TypeNode& node) {
    Text parsed(text);
    const Tokens& t = parsed.tokens;
    if (t.empty())
        return std::nullopt;
    const std::string& kind = node.kind;
    if (kind == "bool") {
        if (t.size() == 1 && (t[0].is("true") || t[0].is("false")))
            return std::string(t[0].text);
        if (t.size() == 1 && (t[0].is("0") || t[0].is("1")))
            return t[0].is("1") ? "true" : "false";
        return empty_construction(t, node.cpp) ? std::optional<std::string>("false") : std::nullopt;
    }
    if (kind == "float" || kind == "double" || kind.starts_with("int") || kind.starts_with("uint")) {
        bool real = kind == "float" || kind == "double";
        bool cast = t.size() > 3 && t[1].is("(") && t[0].is(node.cpp);
        auto value = cast ? number(t, 2, t.size() - 1) : number(t, 0, t.size());
        if (!value && empty_construction(t, node.cpp))
            value = 0.0;
        if (!value)
            return std::nullopt;
        if (!real) // 64-bit values beyond 2^53 keep their digits
            return t.size() == 1 && t[0].text.find_first_not_of("0123456789") == std::string_view::npos &&
                           !t[0].text.starts_with("0")
                       ? std::string(t[0].text)
                       : fmt::format("{:.0f}", *value);
        return fmt::format("{:.6f}", *value);
    }
    if (kind == "string" || kind == "utf8_string" || kind == "ansi_string")
        return string_value(t, 0, t.size(), node.cpp);
    if (kind == "name") {
        if ((t.size() == 1 && t[0].is("NAME_None")) || empty_construction(t, node.cpp) ||
            (t.size() == 4 && t[0].is("FName") && t[2].is("NAME_None")))
            return "None";
        return string_value(t, 0, t.size(), "FName");
    }
    if (kind == "text") {
        if (empty_construction(t, node.cpp) || (t.size() >= 3 && t[0].is("FText") && t[2].is("GetEmpty")))
            return "";
        if (t[0].is("INVTEXT") || t[0].is("LOCTEXT") || t[0].is("NSLOCTEXT"))
            return text;
        return std::nullopt;
    }
    if (kind == "object" || kind == "class" || kind == "soft_object" || kind == "soft_class" || kind == "weak_object" ||
        kind == "lazy_object" || kind == "interface" || kind == "field_path") {
        if (t.size() == 1 && (t[0].is("nullptr") || t[0].is("NULL") || t[0].is("0")))
            return "None";
        if (empty_construction(t, node.cpp) || (t.size() > 3 && t[t.size() - 2].is("nullptr")))
            return "None";
        return std::nullopt;
    }
    if (kind == "enum" || kind == "byte_enum") {
        for (const Token& token : t)
            if (!token.identifier() && !token.is("::"))
                return std::nullopt;
        return t.back().identifier() ? std::optional(std::string(t.back().text)) : std::nullopt;
    }
    if (kind == "struct") {
        if (node.name == "FVector" || node.name == "FRotator" || node.name == "FVector2D")
            return vector_default(t, node.name);
        if (node.name == "FLinearColor" || node.name == "FColor")
            return colour_default(t, node.name);
        if (empty_construction(t, node.cpp) ||
            (t.size() == 3 && t[1].is("::") && (t[2].is("Identity") || t[2].is("EmptyContainer"))))
            return "()";
        return std::nullopt;
    }
    if (node.is_container())
        return empty_construction(t, node.cpp) ? std::optional<std::string>("()") : std::nullopt;
    if (kind.ends_with("delegate"))
        return empty_construction(t, node.cpp) ? std::optional<std::string>("") : std::nullopt;
    return std::nullopt;
}

} // namespace spear::header_tool
