// SPDX-License-Identifier: MIT
// Value: its parts and conversions. Its encoding is in value_codec.cpp, equality and text in value_text.cpp.
#include "value_impl.hpp"

namespace spear {
namespace {

using detail::is_sequence;
using detail::Overloaded;

std::string_view builtin_name(TypeId type) {
    static constexpr std::string_view names[] = {"null", "bool", "int8", "int16", "int32", "int64", "uint8", "uint16",
        "uint32", "uint64", "float", "double", "string", "bytes", "object", "any", "future", "list", "dict", "map",
        "object"};
    return type <= types::last_builtin ? names[type] : "struct";
}

Value number_at(const NumericArray& array, std::size_t index) {
    const std::size_t size = fixed_size(array.element());
    Decoder in(array.bytes().subspan(index * size, size));
    return Value::decode(in, array.element(), ValueContext{});
}

} // namespace

// Parts

const Value* StructValue::find(std::string_view field) const noexcept {
    for (const auto& [name, value] : fields) {
        if (name == field)
            return &value;
    }
    return nullptr;
}

Value NumericArray::operator[](std::size_t index) const {
    if (index >= size()) {
        throw_error(
            ErrorCode::OutOfRange, fmt::format("Element {} was asked for, but the array has {}.", index, size()));
    }
    return number_at(*this, index);
}

std::string Value::type_name() const {
    return std::visit(
        Overloaded{
            [](std::nullptr_t) -> std::string { return "null"; },
            [](bool) -> std::string { return "bool"; },
            [](std::int64_t) -> std::string { return "int64"; },
            [](std::uint64_t) -> std::string { return "uint64"; },
            [](double) -> std::string { return "double"; },
            [](const std::string&) -> std::string { return "string"; },
            [](const Bytes&) -> std::string { return "bytes"; },
            [](const ObjectHandle& object) {
                return object.is_null() ? std::string("null") : std::string(object.class_name());
            },
            [](const StructValue& value) { return value.type_name; },
            [](const EnumValue& value) { return value.type_name; },
            [](const List&) -> std::string { return "list"; },
            [](const Dict&) -> std::string { return "dict"; },
            [](const Map&) -> std::string { return "map"; },
            [](const NumericArray& array) { return fmt::format("array<{}>", builtin_name(array.element())); },
        },
        storage_);
}

std::size_t Value::size() const noexcept {
    return std::visit(
        [](const auto& value) -> std::size_t {
            using T = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::is_same_v<T, StructValue>)
                return value.fields.size();
            else if constexpr (requires { value.size(); })
                return value.size();
            else
                return 0;
        },
        storage_);
}

const Value& Value::operator[](std::string_view name) const {
    std::string present;
    const auto note = [&](std::string_view key) { present.append(present.empty() ? "" : ", ").append(key); };
    if (const auto* structure = get_if<StructValue>()) {
        if (const Value* found = structure->find(name))
            return *found;
        for (const auto& [key, value] : structure->fields)
            note(key);
    } else if (const auto* dict = get_if<Dict>()) {
        for (const auto& [key, value] : *dict) {
            if (key == name)
                return value;
            note(key);
        }
    } else if (const auto* map = get_if<Map>()) {
        for (const auto& [key, value] : *map) {
            const auto* text = key.get_if<std::string>();
            if (text && *text == name)
                return value;
            note(to_string(key));
        }
    } else {
        throw_error(
            ErrorCode::WrongType, fmt::format("\"{}\" was asked of a value of type {}, which has no named parts: {}.",
                                      name, type_name(), to_string(*this)));
    }
    throw_error(ErrorCode::UnknownProperty,
        fmt::format("{} has no \"{}\"; it has: {}.", type_name(), name, present.empty() ? "nothing" : present));
}

Value Value::operator[](std::size_t index) const {
    if (!is_sequence(*this)) {
        throw_error(ErrorCode::WrongType,
            fmt::format("Element {} was asked of a value of type {}: {}.", index, type_name(), to_string(*this)));
    }
    if (const auto* array = get_if<NumericArray>()) {
        return (*array)[index];
    }
    const List& list = *get_if<List>();
    if (index >= list.size()) {
        throw_error(
            ErrorCode::OutOfRange, fmt::format("Element {} was asked for, but the list has {}.", index, list.size()));
    }
    return list[index];
}

Value Value::operator[](int index) const {
    if (index < 0) {
        throw_error(ErrorCode::OutOfRange, fmt::format("Element {} was asked for; indices start at 0.", index));
    }
    return (*this)[static_cast<std::size_t>(index)];
}

// Conversions

void Value::throw_conversion(CodecError error, std::string_view wanted) const {
    std::string text = to_string(*this);
    if (text.size() > 200)
        text = text.substr(0, 200) + "...";
    const bool range = error == CodecError::out_of_range;
    throw_error(range ? ErrorCode::OutOfRange : ErrorCode::WrongType,
        fmt::format("A value of type {} {} {}: {}.", type_name(),
            range ? "is outside the range of" : "cannot be read as", wanted, text),
        {}, {}, std::string(wanted));
}

Session* Value::find_session() const noexcept {
    return std::visit(
        [](const auto& value) -> Session* {
            using T = std::remove_cvref_t<decltype(value)>;
            const auto first = [](const auto& parts, auto&& part_of) -> Session* {
                for (const auto& part : parts) {
                    if (Session* found = part_of(part).find_session())
                        return found;
                }
                return nullptr;
            };
            const auto second = [](const auto& pair) -> const Value& { return pair.second; };
            if constexpr (std::is_same_v<T, ObjectHandle>)
                return value.session().get();
            else if constexpr (std::is_same_v<T, StructValue>)
                return first(value.fields, second);
            else if constexpr (std::is_same_v<T, List>)
                return first(value, [](const Value& part) -> const Value& { return part; });
            else if constexpr (std::is_same_v<T, Dict> || std::is_same_v<T, Map>)
                return first(value, second);
            else
                return nullptr;
        },
        storage_);
}

} // namespace spear
