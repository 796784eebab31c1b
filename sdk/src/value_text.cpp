// SPDX-License-Identifier: MIT
// Value: equality, and one line of text for people.
#include <iterator>
#include <ostream>

#include "value_impl.hpp"

namespace spear {
namespace {

using detail::is_sequence;
using detail::Overloaded;

/// A number with its kind, for comparisons across kinds.
struct Number {
    enum class Kind { signed_integer, unsigned_integer, floating } kind;
    std::int64_t integer = 0;
    std::uint64_t natural = 0;
    double real = 0;
};

std::optional<Number> as_number(const Value& value) {
    if (const auto* integer = value.get_if<std::int64_t>())
        return Number{Number::Kind::signed_integer, *integer, 0, 0};
    if (const auto* natural = value.get_if<std::uint64_t>())
        return Number{Number::Kind::unsigned_integer, 0, *natural, 0};
    if (const auto* real = value.get_if<double>())
        return Number{Number::Kind::floating, 0, 0, *real};
    return {};
}

bool same_number(const Number& a, const Number& b) {
    using enum Number::Kind;
    const auto real = [](const Number& n) {
        return n.kind == floating         ? n.real
               : n.kind == signed_integer ? static_cast<double>(n.integer)
                                          : static_cast<double>(n.natural);
    };
    if (a.kind == floating || b.kind == floating)
        return real(a) == real(b);
    if (a.kind == b.kind)
        return a.integer == b.integer && a.natural == b.natural;
    return a.kind == signed_integer ? std::cmp_equal(a.integer, b.natural) : std::cmp_equal(a.natural, b.integer);
}

} // namespace

bool operator==(const Value& a, const Value& b) {
    if (const auto x = as_number(a)) {
        const auto y = as_number(b);
        return y && same_number(*x, *y);
    }
    if (is_sequence(a) || is_sequence(b)) {
        if (!is_sequence(a) || !is_sequence(b) || a.size() != b.size())
            return false;
        for (std::size_t i = 0; i < a.size(); ++i) {
            if (!(a[i] == b[i]))
                return false;
        }
        return true;
    }
    if (const auto *x = a.get_if<StructValue>(), *y = b.get_if<StructValue>(); x && y) {
        return x->type_name == y->type_name && x->fields == y->fields;
    }
    const auto is_null = [](const Value& value) {
        const auto* object = value.get_if<ObjectHandle>();
        return value.is_null() || (object && object->is_null());
    };
    if (is_null(a) || is_null(b))
        return is_null(a) && is_null(b);
    return std::visit(
        [](const auto& x, const auto& y) -> bool {
            using X = std::remove_cvref_t<decltype(x)>;
            if constexpr (!std::is_same_v<X, std::remove_cvref_t<decltype(y)>> || std::is_same_v<X, StructValue> ||
                          std::is_same_v<X, NumericArray>)
                return false;
            else
                return x == y;
        },
        a.storage_, b.storage_);
}

namespace {

void print(std::string& out, const Value& value);

void print_quoted(std::string& out, std::string_view text) {
    out += '"';
    for (const char c : text) {
        switch (c) {
        case '"':
            out += "\\\"";
            break;
        case '\\':
            out += "\\\\";
            break;
        case '\n':
            out += "\\n";
            break;
        case '\t':
            out += "\\t";
            break;
        default:
            out += c;
        }
    }
    out += '"';
}

template <typename Items, typename F>
void print_items(std::string& out, char open, char close, const Items& items, F&& print_item) {
    out += open;
    bool first = true;
    for (const auto& item : items) {
        if (!first)
            out += ", ";
        first = false;
        print_item(item);
    }
    out += close;
}

void print(std::string& out, const Value& value) {
    std::visit(
        Overloaded{
            [&](std::nullptr_t) { out += "null"; },
            [&](bool flag) { out += flag ? "true" : "false"; },
            [&](std::int64_t number) { fmt::format_to(std::back_inserter(out), "{}", number); },
            [&](std::uint64_t number) { fmt::format_to(std::back_inserter(out), "{}", number); },
            [&](double number) { fmt::format_to(std::back_inserter(out), "{}", number); },
            [&](const std::string& text) { print_quoted(out, text); },
            [&](const Value::Bytes& bytes) { fmt::format_to(std::back_inserter(out), "<{} bytes>", bytes.size()); },
            [&](const ObjectHandle& object) {
                if (object.is_null())
                    out += "null";
                else
                    fmt::format_to(std::back_inserter(out), "{}#{}", object.class_name(),
                        static_cast<std::uint32_t>(object.ref().handle));
            },
            [&](const StructValue& structure) {
                out += structure.type_name;
                print_items(out, '(', ')', structure.fields, [&](const auto& field) {
                    out.append(field.first).append("=");
                    print(out, field.second);
                });
            },
            [&](const EnumValue& entry) {
                out.append(entry.type_name).append("::");
                if (entry.entry_name.empty())
                    fmt::format_to(std::back_inserter(out), "{}", entry.value);
                else
                    out += entry.entry_name;
            },
            [&](const Value::List& list) {
                print_items(out, '[', ']', list, [&](const Value& part) { print(out, part); });
            },
            [&](const Value::Dict& dict) {
                print_items(out, '{', '}', dict, [&](const auto& entry) {
                    print_quoted(out, entry.first);
                    out += ": ";
                    print(out, entry.second);
                });
            },
            [&](const Value::Map& map) {
                print_items(out, '{', '}', map, [&](const auto& entry) {
                    print(out, entry.first);
                    out += ": ";
                    print(out, entry.second);
                });
            },
            [&](const NumericArray& array) {
                out += '[';
                for (std::size_t i = 0; i < array.size(); ++i) {
                    if (i == 16 && array.size() > 20) {
                        fmt::format_to(std::back_inserter(out), ", ... {} in all", array.size());
                        break;
                    }
                    if (i != 0)
                        out += ", ";
                    print(out, array[i]);
                }
                out += ']';
            },
        },
        value.storage());
}

} // namespace

std::string to_string(const Value& value) {
    std::string out;
    print(out, value);
    return out;
}

std::ostream& operator<<(std::ostream& out, const Value& value) { return out << to_string(value); }

} // namespace spear
