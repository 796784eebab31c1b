// SPDX-License-Identifier: MIT
#pragma once

// How C++ values become arguments of reflected calls: with announced types where the C++ type says enough, so that an
// FVector travels as 24 bytes and an array of numbers as one block, and with Codec<T>'s self-describing form everywhere
// else.

#include <array>
#include <atomic>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "spear/codec.hpp"
#include "spear/object_handle.hpp"

namespace spear {

/// Gives types their numbers: a Session, which announces them to its server, or LocalTypes for bytes that stay in this
/// process.
class TypeSource {
public:
    /// The number of a type, announced if it is new. Thread-safe in a Session.
    virtual TypeId number_of(const TypeInfo& info) = 0;

    /// The number of the type that make() describes; make() is called at most once per source and C++ type (`slot`).
    template <typename F>
    TypeId cached_number(std::size_t slot, F&& make) {
        if (slot >= cache_.size()) {
            return number_of(make());
        }
        TypeId type = cache_[slot].load(std::memory_order_acquire);
        if (type == types::null) {
            type = number_of(make());
            cache_[slot].store(type, std::memory_order_release);
        }
        return type;
    }

protected:
    TypeSource() = default;
    ~TypeSource() = default;

private:
    std::array<std::atomic<TypeId>, 512> cache_{};
};

/// Types of bytes that are written and read within this process.
class LocalTypes final : public TypeSource {
public:
    TypeId number_of(const TypeInfo& info) override { return announcer_.number_of(info); }
    const TypeTable& table() const { return announcer_.table(); }
    TypeAnnouncer& announcer() { return announcer_; }

private:
    TypeAnnouncer announcer_{types::first_client_type};
};

namespace detail {

inline std::atomic<std::size_t> next_type_slot{0};
template <typename T>
inline const std::size_t type_slot = next_type_slot++;

template <typename T>
inline constexpr bool is_vector = false;
template <typename T>
inline constexpr bool is_vector<std::vector<T>> = true;

template <typename T>
concept StringLike = std::convertible_to<const T&, std::string_view>;

} // namespace detail

/// The number of the type that all values of T have on the wire, or types::any if it depends on the value.
template <typename T>
TypeId wire_type(TypeSource& source) {
    if constexpr (std::is_arithmetic_v<T>) {
        return detail::number_type<T>();
    } else if constexpr (GeneratedEnum<T>) {
        return types::any; // the entry's name, or a number
    } else if constexpr (std::is_enum_v<T>) {
        return types::i64;
    } else if constexpr (detail::StringLike<T>) {
        return types::string;
    } else if constexpr (std::derived_from<T, ObjectHandle>) {
        return types::object;
    } else if constexpr (detail::is_vector<T>) {
        return source.cached_number(detail::type_slot<T>, [&] {
            TypeInfo info{.kind = TypeKind::array, .element = wire_type<typename T::value_type>(source)};
            return info;
        });
    } else if constexpr (HasMembers<T>) {
        return source.cached_number(detail::type_slot<T>, [&] {
            TypeInfo info{.kind = TypeKind::structure, .name = std::string(Members<T>::name)};
            std::apply(
                [&](const auto&... member) {
                    (info.fields.push_back({std::string(member.name),
                         wire_type<std::remove_cvref_t<decltype(std::declval<T>().*(member.pointer))>>(source)}),
                        ...);
                },
                Members<T>::list);
            return info;
        });
    } else {
        return types::any;
    }
}

template <typename T>
void encode_typed(Encoder& out, const T& value, TypeSource& source);

/// The payload of a value of type wire_type<T>.
template <typename T>
void encode_payload(Encoder& out, const T& value, TypeSource& source) {
    if constexpr (std::is_same_v<T, bool>) {
        out.put(static_cast<std::uint8_t>(value));
    } else if constexpr (std::is_arithmetic_v<T>) {
        out.put(value);
    } else if constexpr (std::is_enum_v<T> && !GeneratedEnum<T>) {
        out.put(static_cast<std::int64_t>(value));
    } else if constexpr (detail::StringLike<T>) {
        out.put_text(std::string_view(value));
    } else if constexpr (std::derived_from<T, ObjectHandle>) {
        out.put(value.ref().handle);
        out.put(value.ref().class_type);
    } else if constexpr (detail::is_vector<T>) {
        using Element = typename T::value_type;
        out.put(static_cast<std::uint32_t>(value.size()));
        if constexpr (std::is_arithmetic_v<Element> && !std::is_same_v<Element, bool>) {
            out.put_raw(value.data(), value.size() * sizeof(Element));
        } else {
            for (const Element& element : value)
                encode_payload(out, element, source);
        }
    } else if constexpr (HasMembers<T>) {
        std::apply([&](const auto&... member) { (encode_payload(out, value.*(member.pointer), source), ...); },
            Members<T>::list);
    } else {
        encode_typed(out, value, source); // `any`: a value with its own type number
    }
}

/// Type number and payload. Types with an `encode(out, source)` member (Value) write themselves; the rest goes through
/// Codec<T>.
template <typename T>
void encode_typed(Encoder& out, const T& value, TypeSource& source) {
    if constexpr (std::is_null_pointer_v<T>) {
        out.put(types::null);
    } else if constexpr (requires { value.encode(out, source); }) {
        value.encode(out, source);
    } else if constexpr (detail::StringLike<T>) {
        Codec<std::string>::encode(out, value);
    } else if constexpr (requires {
                             typename T::value_type;
                             value.has_value();
                         }) { // std::optional
        if (value.has_value())
            encode_typed(out, *value, source);
        else
            out.put(types::null);
    } else if constexpr (requires { typename T::mapped_type; }) { // std::map and the like
        if constexpr (detail::StringLike<typename T::key_type>) {
            out.put(types::dict);
            out.put(static_cast<std::uint32_t>(value.size()));
            for (const auto& [key, element] : value) {
                out.put_text(std::string_view(key));
                encode_typed(out, element, source);
            }
        } else {
            out.put(types::map);
            out.put(static_cast<std::uint32_t>(value.size()));
            for (const auto& [key, element] : value) {
                encode_typed(out, key, source);
                encode_typed(out, element, source);
            }
        }
    } else if (const TypeId type = wire_type<T>(source); type != types::any) {
        out.put(type);
        encode_payload(out, value, source);
    } else {
        Codec<T>::encode(out, value);
    }
}

} // namespace spear
