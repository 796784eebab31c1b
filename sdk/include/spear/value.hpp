// SPDX-License-Identifier: MIT
#pragma once

// Value: any value of the engine, with its type known at run time. Calls and properties give one unless a C++ type is
// asked for:
//
//     spear::Value location = actor.call("K2_GetActorLocation");       // FVector(X=1, Y=2, Z=3)
//     double x = location["X"].as<double>();
//     auto vector = location.as<spear::unreal::FVector>();
//     actor.call("K2_SetActorLocation", spear::Value(spear::Value::Dict{{"X", 1.0}, {"Y", 2.0}, {"Z", 3.0}}), ...);

#include <cstdint>
#include <initializer_list>
#include <iosfwd>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "spear/codec.hpp"
#include "spear/error.hpp"
#include "spear/object_handle.hpp"
#include "spear/wire_type.hpp"

namespace spear {

class Value;

/// A struct: its C++ name ("FVector", or "<Function>_Result" for functions with out-parameters) and its fields in
/// order.
struct StructValue {
    std::string type_name{};
    std::vector<std::pair<std::string, Value>> fields;

    const Value* find(std::string_view field) const noexcept; ///< null if there is no such field
};

/// An enum value. The entry's name is empty if the number is no entry.
struct EnumValue {
    std::string type_name{};  ///< "ECollisionChannel"
    std::string entry_name{}; ///< "WorldStatic", without scope
    std::int64_t value = 0;
    friend bool operator==(const EnumValue&, const EnumValue&) = default;
};

/// An array of numbers, kept as one block of memory.
class NumericArray {
public:
    NumericArray() = default;
    /// `element` is a number type of encode.hpp (types::i8 ... types::f64); the bytes are a whole number of elements.
    NumericArray(TypeId element, std::span<const std::byte> bytes)
        : element_(element), bytes_(bytes.begin(), bytes.end()) {}

    TypeId element() const noexcept { return element_; }
    std::size_t size() const noexcept { return bytes_.size() / fixed_size(element_); }
    std::span<const std::byte> bytes() const noexcept { return bytes_; }
    /// The elements, if T is exactly their type; else raises WrongType.
    template <typename T>
    std::span<const T> view() const;
    Value operator[](std::size_t index) const;

private:
    TypeId element_ = types::f64;
    std::vector<std::byte> bytes_; // operator new aligns for every number
};

/// What is needed to turn bytes into Values: the session's types, and the session itself for objects (may be null).
struct ValueContext {
    TypeTables tables;
    Session* session = nullptr;
};

namespace detail {
template <typename T, typename Variant>
inline constexpr bool is_alternative = false;
template <typename T, typename... A>
inline constexpr bool is_alternative<T, std::variant<A...>> = (std::is_same_v<T, A> || ...);
} // namespace detail

class Value {
public:
    using Bytes = std::vector<std::byte>;
    using List = std::vector<Value>;
    using Dict = std::vector<std::pair<std::string, Value>>; ///< in the order received
    using Map = std::vector<std::pair<Value, Value>>;        ///< Unreal's TMap with any key type
    using Storage = std::variant<std::nullptr_t, bool, std::int64_t, std::uint64_t, double, std::string, Bytes,
        ObjectHandle, StructValue, EnumValue, List, Dict, Map, NumericArray>;

    Value() : storage_(nullptr) {}
    Value(std::nullptr_t) : storage_(nullptr) {}
    Value(bool value) : storage_(value) {}
    template <std::signed_integral T>
    Value(T value) : storage_(static_cast<std::int64_t>(value)) {}
    template <std::unsigned_integral T>
        requires(!std::is_same_v<T, bool>)
    Value(T value) : storage_(static_cast<std::uint64_t>(value)) {}
    template <std::floating_point T>
    Value(T value) : storage_(static_cast<double>(value)) {}
    Value(const char* value) : storage_(std::string(value)) {}
    Value(std::string_view value) : storage_(std::string(value)) {}
    Value(std::string value) : storage_(std::move(value)) {}
    Value(Bytes value) : storage_(std::move(value)) {}
    Value(ObjectHandle value) : storage_(std::move(value)) {}
    Value(StructValue value) : storage_(std::move(value)) {}
    Value(EnumValue value) : storage_(std::move(value)) {}
    Value(List value) : storage_(std::move(value)) {}
    Value(Dict value) : storage_(std::move(value)) {}
    Value(Map value) : storage_(std::move(value)) {}
    Value(NumericArray value) : storage_(std::move(value)) {}

    /// From any C++ type that can be an argument: structs with Members<T>, enums, vectors, maps, optionals.
    template <typename T>
    static Value from(const T& value);

    // What it is

    const Storage& storage() const noexcept { return storage_; }
    template <typename T>
    const T* get_if() const noexcept {
        return std::get_if<T>(&storage_);
    } ///< T is one of Storage's types
    bool is_null() const noexcept { return std::holds_alternative<std::nullptr_t>(storage_); }
    /// "null", "bool", "int64", "uint64", "double", "string", "bytes", "list", "dict", "map", the struct's or enum's
    /// C++ name, the object's class, or the element type for numeric arrays: "array<float>".
    std::string type_name() const;

    // Parts

    /// Elements of a list or array, entries of a dict or map, fields of a struct, bytes of a string; 0 for the rest.
    std::size_t size() const noexcept;
    /// The field of a struct, or the entry of a dict or of a map with string keys. Raises UnknownProperty (listing what
    /// there is) or WrongType.
    const Value& operator[](std::string_view name) const;
    const Value& operator[](const char* name) const { return (*this)[std::string_view(name)]; }
    /// The element of a list or numeric array. Raises OutOfRange or WrongType.
    Value operator[](std::size_t index) const;
    Value operator[](int index) const;

    // Conversions

    /// The value as a T: numbers that fit, strings (of an enum value: its entry's name), enums (from enum values or
    /// numbers), Object, std::optional (null is nullopt), std::vector, std::map, and structs with Members<T> (from
    /// structs, dicts and lists). Raises WrongType or OutOfRange.
    template <typename T>
    T as() const;

    // Encoding

    /// Reads type number and payload. Raises MalformedMessage.
    static Value decode(Decoder& in, const ValueContext& context);
    /// Reads the payload of a type. Raises MalformedMessage.
    static Value decode(Decoder& in, TypeId type, const ValueContext& context) { return decode(in, type, context, 0); }
    static Value decode(const AnyView& view, const ValueContext& context) {
        Decoder in(view.payload);
        return decode(in, view.type, context);
    }
    /// Writes type number and payload; structs and numeric arrays are announced through the source.
    void encode(Encoder& out, TypeSource& source) const;

    /// Numbers are equal if they are the same number, whatever their kinds (arrays too, with lists); structs if names
    /// and fields are.
    friend bool operator==(const Value& a, const Value& b);

private:
    static Value decode(Decoder& in, TypeId type, const ValueContext& context, std::size_t depth);
    TypeId typed_number(TypeSource& source) const;
    void encode_typed_payload(Encoder& out, TypeSource& source) const;
    [[noreturn]] void throw_conversion(CodecError error, std::string_view wanted) const;
    Session* find_session() const noexcept;

    Storage storage_;
};

/// One line for people, in the spirit of the engine's own text: FVector(X=1, Y=2, Z=3), [1, 2], {"a": 1}, AActor#5,
/// "text".
std::string to_string(const Value& value);
std::ostream& operator<<(std::ostream& out, const Value& value);

template <>
struct Codec<Value> {
    static constexpr std::string_view name = Codec<AnyView>::name;
    /// Self-contained: structs become dicts. (Arguments go through Value::encode with a session, which announces them.)
    static void encode(Encoder& out, const Value& value);
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, Value& value);
};

// Templates

template <typename T>
std::span<const T> NumericArray::view() const {
    if (element_ != detail::number_type<T>()) {
        throw_error(ErrorCode::WrongType,
            fmt::format("An array of type number {} was asked for as {}.", element_, detail::number_name<T>()), {}, {},
            std::string(detail::number_name<T>()));
    }
    return {reinterpret_cast<const T*>(bytes_.data()), size()};
}

template <typename T>
Value Value::from(const T& value) {
    if constexpr (std::is_constructible_v<Value, const T&> && !std::is_enum_v<T>) {
        return Value(value);
    } else {
        LocalTypes types;
        Encoder out;
        encode_typed(out, value, types);
        Decoder in(out.bytes());
        return decode(in, ValueContext{{&types.table(), nullptr}, nullptr});
    }
}

template <typename T>
T Value::as() const {
    if constexpr (std::is_same_v<T, Value>) {
        return *this;
    } else {
        if constexpr (detail::is_alternative<T, Storage>) {
            if (const T* same = std::get_if<T>(&storage_)) {
                return *same;
            }
        }
        if constexpr (std::is_same_v<T, std::string>) {
            if (const EnumValue* entry = std::get_if<EnumValue>(&storage_); entry && !entry->entry_name.empty()) {
                return entry->entry_name;
            }
        }
        LocalTypes types;
        Encoder out;
        encode(out, types);
        Decoder in(out.bytes());
        T value{};
        const CodecError error =
            decode_value(in, DecodeContext{{&types.table(), nullptr}, nullptr, find_session()}, value);
        if (error != CodecError::none) {
            throw_conversion(error, Codec<T>::name);
        }
        return value;
    }
}

} // namespace spear

template <>
struct fmt::formatter<spear::Value> : fmt::formatter<std::string_view> {
    template <typename Context>
    auto format(const spear::Value& value, Context& context) const {
        return fmt::formatter<std::string_view>::format(spear::to_string(value), context);
    }
};
