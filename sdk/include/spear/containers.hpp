// SPDX-License-Identifier: MIT
#pragma once

// Unreal's containers as the standard library's: how those travel that codec.hpp does not know already.
//
//     TArray<T>    std::vector<T>                         TOptional<T>   std::optional<T>
//     TSet<T>      std::set<T>; std::vector<T> where T has no order (objects, structs)
//     TMap<K, V>   std::map<K, V>; KeyValues<K, V> where K has no order
//     T x[N]       std::array<T, N>

#include <array>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "spear/codec.hpp"

namespace spear {

/// A map whose keys have no order in C++ (objects, structs): its entries as the engine lists them.
template <typename K, typename V>
struct KeyValues : std::vector<std::pair<K, V>> {
    using std::vector<std::pair<K, V>>::vector;
};

namespace detail {

/// Reads the entries of a map of any form; `add` takes key and value.
template <typename K, typename V, typename F>
CodecError decode_map(Decoder& in, TypeId type, const DecodeContext& context, F&& add) {
    if (type == types::null)
        return CodecError::none;
    TypeId key_type = types::any, value_type = types::any;
    if (type != types::map) {
        const TypeInfo* info = context.tables.find(type);
        if (!info || info->kind != TypeKind::map)
            return CodecError::wrong_type;
        key_type = info->key;
        value_type = info->element;
    }
    for (std::uint32_t n = in.get_count(1); n != 0 && in.ok(); --n) {
        K key{};
        V value{};
        if (const CodecError error = decode_element(in, key_type, context, key); error != CodecError::none)
            return error;
        if (const CodecError error = decode_element(in, value_type, context, value); error != CodecError::none)
            return error;
        add(std::move(key), std::move(value));
    }
    return CodecError::none;
}

template <typename M>
void encode_map(Encoder& out, const M& entries) {
    out.put(types::map);
    out.put(static_cast<std::uint32_t>(entries.size()));
    for (const auto& [key, value] : entries) {
        encode_value(out, key);
        encode_value(out, value);
    }
}

} // namespace detail

template <typename K, typename V>
    requires(!std::is_same_v<K, std::string>)
struct Codec<std::map<K, V>> {
    static constexpr std::string_view name = "map";
    static void encode(Encoder& out, const std::map<K, V>& value) { detail::encode_map(out, value); }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, std::map<K, V>& value) {
        value.clear();
        return detail::decode_map<K, V>(in, type, context,
            [&](K&& key, V&& element) { value.insert_or_assign(std::move(key), std::move(element)); });
    }
};

template <typename K, typename V>
struct Codec<KeyValues<K, V>> {
    static constexpr std::string_view name = "map";
    static void encode(Encoder& out, const KeyValues<K, V>& value) { detail::encode_map(out, value); }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, KeyValues<K, V>& value) {
        value.clear();
        return detail::decode_map<K, V>(
            in, type, context, [&](K&& key, V&& element) { value.emplace_back(std::move(key), std::move(element)); });
    }
};

template <typename T>
struct Codec<std::set<T>> {
    static constexpr std::string_view name = "set";
    static void encode(Encoder& out, const std::set<T>& value) {
        out.put(types::list);
        out.put(static_cast<std::uint32_t>(value.size()));
        for (const T& element : value)
            encode_value(out, element);
    }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, std::set<T>& value) {
        std::vector<T> elements;
        const CodecError error = Codec<std::vector<T>>::decode(in, type, context, elements);
        value = std::set<T>(elements.begin(), elements.end());
        return error;
    }
};

template <typename T, std::size_t N>
struct Codec<std::array<T, N>> {
    static constexpr std::string_view name = "array";
    static void encode(Encoder& out, const std::array<T, N>& value) {
        out.put(types::list);
        out.put(static_cast<std::uint32_t>(N));
        for (const T& element : value)
            encode_value(out, element);
    }
    /// Exactly N elements.
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, std::array<T, N>& value) {
        std::vector<T> elements;
        const CodecError error = Codec<std::vector<T>>::decode(in, type, context, elements);
        if (error != CodecError::none)
            return error;
        if (elements.size() != N)
            return CodecError::wrong_type;
        for (std::size_t i = 0; i < N; ++i)
            value[i] = std::move(elements[i]);
        return CodecError::none;
    }
};

} // namespace spear
