// SPDX-License-Identifier: MIT
#pragma once

// Codec<T>: how a C++ type of an entry point's signature is written as, and read from, a value. The same code serves both sides;
// no exceptions, no RTTI. Reading is lenient about the number types (an i64 fits an int32 parameter if its value does) and strict
// about everything else.
//
// A codec has
//     static constexpr std::string_view name;                          // text of the type in signatures, e.g. "list<string>"
//     static void encode(Encoder& out, const T& value);                // type number and payload
//     static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, T& value);   // payload of the given type

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "spear/encode.hpp"

namespace spear {

/// Why a value did not fit.
enum class CodecError : std::uint8_t { none, wrong_type, out_of_range, malformed, unresolved_future };

/// What a reader needs besides the bytes.
struct DecodeContext {
    TypeTables tables;
    /// Gives the value (type number and payload) of an earlier operation's result. Null where futures are not allowed.
    bool (*resolve_future)(void* user, std::uint64_t number, std::span<const std::byte>& value) = nullptr;
    void* user = nullptr;
};

template <typename T>
struct Codec; // specialised below for each type that may stand in a signature

/// Reads type number and payload; a future is replaced by its result first.
template <typename T>
CodecError decode_value(Decoder& in, const DecodeContext& context, T& value) {
    const auto type = in.get<TypeId>();
    if (type == types::future) {
        std::span<const std::byte> bytes;
        if (!context.resolve_future || !context.resolve_future(context.user, in.get<std::uint64_t>(), bytes)) {
            return CodecError::unresolved_future;
        }
        Decoder resolved(bytes);
        const auto resolved_type = resolved.get<TypeId>();
        return resolved.ok() ? Codec<T>::decode(resolved, resolved_type, context, value) : CodecError::malformed;
    }
    if (!in.ok()) {
        return CodecError::malformed;
    }
    const CodecError error = Codec<T>::decode(in, type, context, value);
    return error == CodecError::none && !in.ok() ? CodecError::malformed : error;
}

/// Reads an element or field of an announced type: `any` means a value with its own type number.
template <typename T>
CodecError decode_element(Decoder& in, TypeId type, const DecodeContext& context, T& value) {
    return type == types::any ? decode_value(in, context, value) : Codec<T>::decode(in, type, context, value);
}

template <typename T>
void encode_value(Encoder& out, const T& value) { Codec<T>::encode(out, value); }

// Numbers ------------------------------------------------------------------------------------------------------------------

namespace detail {

template <typename T>
constexpr TypeId number_type() {
    if constexpr (std::is_same_v<T, bool>) return types::boolean;
    else if constexpr (std::is_same_v<T, float>) return types::f32;
    else if constexpr (std::is_same_v<T, double>) return types::f64;
    else if constexpr (std::is_signed_v<T>) return sizeof(T) == 1 ? types::i8 : sizeof(T) == 2 ? types::i16 : sizeof(T) == 4 ? types::i32 : types::i64;
    else return sizeof(T) == 1 ? types::u8 : sizeof(T) == 2 ? types::u16 : sizeof(T) == 4 ? types::u32 : types::u64;
}

template <typename T>
constexpr std::string_view number_name() {
    constexpr std::string_view names[] = {"", "bool", "int8", "int16", "int32", "int64", "uint8", "uint16", "uint32", "uint64", "float", "double"};
    return names[number_type<T>()];
}

/// Converts a number that was sent as S into a T, exactly or not at all (floating-point targets round).
template <typename T, typename S>
CodecError convert_number(S sent, T& value) {
    if constexpr (std::is_same_v<T, bool>) {
        if constexpr (!std::is_same_v<S, bool>) return CodecError::wrong_type;
        else value = sent;
    } else if constexpr (std::is_same_v<S, bool>) {
        return CodecError::wrong_type;
    } else if constexpr (std::is_floating_point_v<T>) {
        value = static_cast<T>(sent);
    } else if constexpr (std::is_floating_point_v<S>) {
        return CodecError::wrong_type;
    } else {
        if (!std::in_range<T>(sent)) return CodecError::out_of_range;
        value = static_cast<T>(sent);
    }
    return CodecError::none;
}

} // namespace detail

/// Reads a number of any wire type into T; also used for reflected numeric properties.
template <typename T>
CodecError decode_number(Decoder& in, TypeId type, T& value) {
    switch (type) {
    case types::boolean: return detail::convert_number(in.get<std::uint8_t>() != 0, value);
    case types::i8: return detail::convert_number(in.get<std::int8_t>(), value);
    case types::i16: return detail::convert_number(in.get<std::int16_t>(), value);
    case types::i32: return detail::convert_number(in.get<std::int32_t>(), value);
    case types::i64: return detail::convert_number(in.get<std::int64_t>(), value);
    case types::u8: return detail::convert_number(in.get<std::uint8_t>(), value);
    case types::u16: return detail::convert_number(in.get<std::uint16_t>(), value);
    case types::u32: return detail::convert_number(in.get<std::uint32_t>(), value);
    case types::u64: return detail::convert_number(in.get<std::uint64_t>(), value);
    case types::f32: return detail::convert_number(in.get<float>(), value);
    case types::f64: return detail::convert_number(in.get<double>(), value);
    default: return CodecError::wrong_type;
    }
}

template <typename T>
    requires std::is_arithmetic_v<T>
struct Codec<T> {
    static constexpr std::string_view name = detail::number_name<T>();
    static void encode(Encoder& out, T value) {
        out.put(detail::number_type<T>());
        if constexpr (std::is_same_v<T, bool>) out.put(static_cast<std::uint8_t>(value));
        else out.put(value);
    }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext&, T& value) { return decode_number(in, type, value); }
};

/// The entries of a generated enum (proxy_types.hpp): such travel by the names of their entries.
template <typename E>
struct EnumEntries;

/// A generated enum.
template <typename E>
concept GeneratedEnum = std::is_enum_v<E> && requires { EnumEntries<E>::list; };

/// An enum is sent as its number and read from a number or an announced enumeration.
template <typename T>
    requires(std::is_enum_v<T> && !GeneratedEnum<T>)
struct Codec<T> {
    static constexpr std::string_view name = "enum";
    static void encode(Encoder& out, T value) { Codec<std::int64_t>::encode(out, static_cast<std::int64_t>(value)); }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, T& value) {
        std::underlying_type_t<T> number{};
        const TypeInfo* info = context.tables.find(type);
        const bool enumeration = info && info->kind == TypeKind::enumeration;
        const CodecError error = decode_number(in, enumeration ? types::i64 : type, number);
        value = static_cast<T>(number);
        return error;
    }
};

// Text ---------------------------------------------------------------------------------------------------------------------

template <>
struct Codec<std::string> {
    static constexpr std::string_view name = "string";
    static void encode(Encoder& out, std::string_view value) {
        out.put(types::string);
        out.put_text(value);
    }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext&, std::string& value) {
        if (type != types::string) return CodecError::wrong_type;
        value = std::string(in.get_text());
        return CodecError::none;
    }
};

template <>
struct Codec<std::string_view> {
    static constexpr std::string_view name = Codec<std::string>::name;
    static void encode(Encoder& out, std::string_view value) { Codec<std::string>::encode(out, value); }
    /// The view points into the message.
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext&, std::string_view& value) {
        if (type != types::string) return CodecError::wrong_type;
        value = in.get_text();
        return CodecError::none;
    }
};

// Objects ------------------------------------------------------------------------------------------------------------------

/// A reference to an object of the engine as it travels: the session's handle, 0 for null, and its class at the moment of sending.
/// The handle is a slot (low 32 bits) with a generation (high 32 bits).
struct ObjectRef {
    std::uint64_t handle = 0;
    TypeId class_type = types::null;
    friend bool operator==(const ObjectRef& a, const ObjectRef& b) { return a.handle == b.handle; }
};

template <>
struct Codec<ObjectRef> {
    static constexpr std::string_view name = "object";
    static void encode(Encoder& out, const ObjectRef& value) {
        out.put(types::object);
        out.put(value.handle);
        out.put(value.class_type);
    }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext&, ObjectRef& value) {
        value = {};
        if (type == types::null) return CodecError::none;
        if (type != types::object && type != types::handle) return CodecError::wrong_type;
        value.handle = in.get<std::uint64_t>();
        value.class_type = type == types::object ? in.get<TypeId>() : types::null;
        return CodecError::none;
    }
};

/// An object where only the engine reads it: without its class.
inline void encode_handle(Encoder& out, const ObjectRef& value) {
    out.put(types::handle);
    out.put(value.handle);
}

// Anything -----------------------------------------------------------------------------------------------------------------

/// One value as bytes, type number and payload: what reflected values are in a signature. Reading gives a view into the message
/// (or into a future's kept result), so it must be used before the message goes.
struct AnyView {
    TypeId type = types::null;
    std::span<const std::byte> payload;
};

template <>
struct Codec<AnyView> {
    static constexpr std::string_view name = "any";
    static void encode(Encoder& out, const AnyView& value) {
        out.put(value.type);
        out.put_raw(value.payload.data(), value.payload.size());
    }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, AnyView& value) {
        const std::byte* start = in.position();
        skip_payload(in, type, context.tables);
        if (!in.ok()) return CodecError::malformed;
        value = {type, {start, in.position()}};
        return CodecError::none;
    }
};

/// A number announced as a call shape or a property path (encode.hpp); u32 on the wire.
struct ShapeId {
    TypeId number = 0;
};

template <>
struct Codec<ShapeId> {
    static constexpr std::string_view name = "shape";
    static void encode(Encoder& out, ShapeId value) { Codec<std::uint32_t>::encode(out, value.number); }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext&, ShapeId& value) { return decode_number(in, type, value.number); }
};

/// All values up to the end of the operation, undecoded: the arguments of a reflected call. Only as the last parameter.
struct ArgumentsView {
    std::span<const std::byte> values;
};

template <>
struct Codec<ArgumentsView> {
    static constexpr std::string_view name = "arguments";
    static void encode(Encoder& out, const ArgumentsView& value) { out.put_raw(value.values.data(), value.values.size()); }
};

// Containers ---------------------------------------------------------------------------------------------------------------

template <typename T>
struct Codec<std::optional<T>> {
    static constexpr std::string_view name = Codec<T>::name; // null fits every optional
    static void encode(Encoder& out, const std::optional<T>& value) {
        if (value) Codec<T>::encode(out, *value);
        else out.put(types::null);
    }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, std::optional<T>& value) {
        value.reset();
        if (type == types::null) return CodecError::none;
        return Codec<T>::decode(in, type, context, value.emplace());
    }
};

namespace detail {
/// "list<" + name + ">" at compile time.
template <std::size_t N>
struct NameBuffer {
    char text[N] = {};
    std::size_t size = 0;
    constexpr void add(std::string_view part) {
        for (char c : part) text[size++] = c;
    }
    constexpr std::string_view view() const { return {text, size}; }
};
template <typename T, bool is_dict>
struct ContainerName {
    static constexpr auto buffer = [] {
        NameBuffer<256> name;
        name.add(is_dict ? "dict<" : "list<");
        name.add(Codec<T>::name);
        name.add(">");
        return name;
    }();
};
} // namespace detail

template <typename T>
struct Codec<std::vector<T>> {
    static constexpr std::string_view name = detail::ContainerName<T, false>::buffer.view();
    static void encode(Encoder& out, const std::vector<T>& value) {
        out.put(types::list);
        out.put(static_cast<std::uint32_t>(value.size()));
        for (const T& element : value) Codec<T>::encode(out, element);
    }
    /// Takes a list, an announced array or set, and null for none.
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, std::vector<T>& value) {
        value.clear();
        if (type == types::null) return CodecError::none;
        TypeId element_type = types::any;
        if (type != types::list) {
            const TypeInfo* info = context.tables.find(type);
            if (!info || (info->kind != TypeKind::array && info->kind != TypeKind::set)) return CodecError::wrong_type;
            element_type = info->element;
        }
        const std::size_t smallest = element_type == types::any ? sizeof(TypeId) : fixed_size(element_type);
        for (std::uint32_t n = in.get_count(smallest); n != 0 && in.ok(); --n) {
            T element{};
            if (const CodecError error = decode_element(in, element_type, context, element); error != CodecError::none) return error;
            value.push_back(std::move(element));
        }
        return CodecError::none;
    }
};

template <typename T>
struct Codec<std::map<std::string, T>> {
    static constexpr std::string_view name = detail::ContainerName<T, true>::buffer.view();
    static void encode(Encoder& out, const std::map<std::string, T>& value) {
        out.put(types::dict);
        out.put(static_cast<std::uint32_t>(value.size()));
        for (const auto& [key, element] : value) {
            out.put_text(key);
            Codec<T>::encode(out, element);
        }
    }
    /// Takes a dict, and a map or announced map whose keys are strings.
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, std::map<std::string, T>& value) {
        value.clear();
        if (type == types::dict) {
            for (std::uint32_t n = in.get_count(8); n != 0 && in.ok(); --n) {
                std::string key(in.get_text());
                if (const CodecError error = decode_value(in, context, value[std::move(key)]); error != CodecError::none) return error;
            }
            return CodecError::none;
        }
        TypeId key_type = types::any, element_type = types::any;
        if (type != types::map) {
            const TypeInfo* info = context.tables.find(type);
            if (!info || info->kind != TypeKind::map) return CodecError::wrong_type;
            key_type = info->key;
            element_type = info->element;
        }
        for (std::uint32_t n = in.get_count(1); n != 0 && in.ok(); --n) {
            std::string key;
            if (const CodecError error = decode_element(in, key_type, context, key); error != CodecError::none) return error;
            if (const CodecError error = decode_element(in, element_type, context, value[std::move(key)]); error != CodecError::none) return error;
        }
        return CodecError::none;
    }
};

// Structures of signatures ---------------------------------------------------------------------------------------------------

/// A plain struct becomes a dict by naming its members once:
///     template <> struct spear::Members<Vector> { static constexpr auto list = std::tuple{Member{"X", &Vector::X}, ...};
///                                                 static constexpr std::string_view name = "Vector"; };
/// Reading takes the members in any order; one that is absent from a dict keeps its default.
template <typename C, typename T>
struct Member {
    std::string_view name;
    T C::*pointer;
};
template <typename C, typename T>
Member(std::string_view, T C::*) -> Member<C, T>;
template <typename C, typename T>
Member(const char*, T C::*) -> Member<C, T>;

template <typename T>
struct Members;

template <typename T>
concept HasMembers = requires { Members<T>::list; };

template <HasMembers T>
struct Codec<T> {
    static constexpr std::string_view name = Members<T>::name;
    static void encode(Encoder& out, const T& value) {
        out.put(types::dict);
        out.put(static_cast<std::uint32_t>(std::tuple_size_v<decltype(Members<T>::list)>));
        std::apply([&](const auto&... member) { (encode_member(out, value, member), ...); }, Members<T>::list);
    }
    /// Takes a dict, a list of the members in order, or an announced struct: that has all members, and more only if it has the same
    /// name (so that a part of a large Unreal struct can be read, but an FVector is no FVector2D).
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, T& value) {
        CodecError error = CodecError::none;
        if (type == types::dict) {
            for (std::uint32_t n = in.get_count(8); n != 0 && in.ok() && error == CodecError::none; --n) {
                const std::string_view key = in.get_text();
                error = set_member(key, value, [&](auto& member) { return decode_value(in, context, member); });
            }
            return error;
        }
        if (type == types::list) {
            std::uint32_t left = in.get_count(4);
            if (left > std::tuple_size_v<decltype(Members<T>::list)>) return CodecError::wrong_type;
            std::apply([&](const auto&... member) {
                ((left != 0 && error == CodecError::none ? (void)(error = decode_value(in, context, value.*(member.pointer)), --left) : (void)0), ...);
            }, Members<T>::list);
            return error;
        }
        const TypeInfo* info = context.tables.find(type);
        if (!info || info->kind != TypeKind::structure) return CodecError::wrong_type;
        std::size_t found = 0;
        for (const FieldInfo& field : info->fields) {
            bool known = false;
            error = set_member(field.name, value, [&](auto& member) {
                known = true;
                return decode_element(in, field.type, context, member);
            });
            if (known && error != CodecError::none) return error;
            if (!known && info->name != name) return CodecError::wrong_type;
            if (!known) skip_payload(in, field.type, context.tables);
            found += known;
        }
        return found == std::tuple_size_v<decltype(Members<T>::list)> ? CodecError::none : CodecError::wrong_type;
    }

private:
    template <typename M>
    static void encode_member(Encoder& out, const T& value, const M& member) {
        out.put_text(member.name);
        encode_value(out, value.*(member.pointer));
    }
    template <typename F>
    static CodecError set_member(std::string_view key, T& value, F&& set) {
        CodecError error = CodecError::wrong_type; // unknown member
        std::apply([&](const auto&... member) { ((member.name == key ? (void)(error = set(value.*(member.pointer))) : (void)0), ...); }, Members<T>::list);
        return error;
    }
};

} // namespace spear
