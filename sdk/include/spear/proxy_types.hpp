// SPDX-License-Identifier: MIT
#pragma once

// The types that generated proxies (proxy.hpp) are made of, besides the plain ones: references to classes and assets,
// delegates, members of structs, names of enum entries.

#include <algorithm>
#include <array>
#include <compare>
#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "spear/containers.hpp"
#include "spear/error.hpp"
#include "spear/future.hpp"
#include "spear/object.hpp"

namespace spear {

namespace unreal {
class UObject;
}

/// What a generated proxy class says about itself: specialised beside each.
///   Layers<Base>: Base with the functions and properties of the class and of all above it;
///   Statics<Base>: the same with static functions only.
template <typename T>
struct ProxyTraits;

/// What a generated struct says about itself: specialised beside each.
///   name: "FHitResult";   visit(f, values...): calls f(Unreal's name of the member, the member of each value) in
///   order; Path<Base>: Base with the members as property paths.
template <typename T>
struct StructTraits;

namespace detail {
/// Not merely declared.
template <typename T>
concept Complete = std::is_void_v<T> || requires { sizeof(T); };
} // namespace detail

/// A generated proxy class.
template <typename T>
concept ProxyClass = std::derived_from<T, ObjectHandle> && requires { sizeof(ProxyTraits<T>); };

/// A generated struct (or the result of a function with several outputs).
template <typename T>
concept GeneratedStruct = std::is_class_v<T> && requires { StructTraits<T>::name; };

/// Whether all members of two structs of one type are equal. A template, so that structs need not be complete where
/// their == is written.
template <typename T>
bool equal_members(const T& a, const T& b) {
    bool equal = true;
    StructTraits<T>::visit([&](std::string_view, const auto& x, const auto& y) { equal = equal && x == y; }, a, b);
    return equal;
}

/// Marks a proxy class that implements the interface of that proxy (IFoo).
template <typename Interface>
struct Implements {};

/// A parameter that is left out on purpose, so that the engine's own default counts:
/// `actor.Move({1, 2, 3}, spear::omit, true)`.
struct Omitted {};
inline constexpr Omitted omit{};

// Classes as values
// -----------------------------------------------------------------------------------------------------------

/// TSubclassOf<T>: a class that is, or derives from, T. Converts to the classes above.
template <typename T>
class SubclassOf : public Class {
public:
    SubclassOf() = default;
    SubclassOf(std::nullptr_t) {}
    explicit SubclassOf(const ObjectHandle& handle) : Class(handle) {}
    explicit SubclassOf(ObjectHandle&& handle) noexcept : Class(std::move(handle)) {}
    template <std::derived_from<T> U>
        requires(!std::is_same_v<T, U>)
    SubclassOf(const SubclassOf<U>& other) : Class(static_cast<const ObjectHandle&>(other)) {}
};

/// The class of a proxy as an argument, without asking for it first:
/// `actor.GetComponentByClass(spear::class_of<UCameraComponent>)`.
template <typename T>
struct ClassName {
    static constexpr std::string_view name() { return T::unreal_name; }
};
template <typename T>
inline constexpr ClassName<T> class_of{};

// References by path
// ----------------------------------------------------------------------------------------------------------

namespace detail {
/// A path that may lead to an object that is not loaded.
template <typename Self>
struct SoftReference {
    std::string path{};
    bool is_null() const noexcept { return path.empty(); }
    friend bool operator==(const Self& a, const Self& b) { return a.path == b.path; }
    friend auto operator<=>(const Self& a, const Self& b) { return a.path <=> b.path; }
};
} // namespace detail

/// TSoftObjectPtr<T>: the path of an asset or other object, "/Game/Folder/Asset.Asset"; empty for none.
/// Game::load_object<T> gives the object.
template <typename T>
struct SoftObject : detail::SoftReference<SoftObject<T>> {
    using Target = T;
    SoftObject() = default;
    template <typename S>
        requires std::convertible_to<const S&, std::string_view>
    SoftObject(const S& text) : detail::SoftReference<SoftObject<T>>{std::string(std::string_view(text))} {}
};

/// TSoftClassPtr<T>: the path of a class, "/Game/Folder/BP_Door.BP_Door_C".
template <typename T>
struct SoftClass : detail::SoftReference<SoftClass<T>> {
    using Target = T;
    SoftClass() = default;
    template <typename S>
        requires std::convertible_to<const S&, std::string_view>
    SoftClass(const S& text) : detail::SoftReference<SoftClass<T>>{std::string(std::string_view(text))} {}
};

namespace detail {
template <typename T>
struct SoftCodec {
    static constexpr std::string_view name = Codec<std::string>::name;
    static void encode(Encoder& out, const T& value) { Codec<std::string>::encode(out, value.path); }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, T& value) {
        const CodecError error = Codec<std::string>::decode(in, type, context, value.path);
        if (value.path == "None")
            value.path.clear();
        return error;
    }
};
} // namespace detail
template <typename T>
struct Codec<SoftObject<T>> : detail::SoftCodec<SoftObject<T>> {};
template <typename T>
struct Codec<SoftClass<T>> : detail::SoftCodec<SoftClass<T>> {};

// Delegates
// -------------------------------------------------------------------------------------------------------------------

/// One binding of a dynamic delegate: a reflected function of an object, with the delegate's parameters. A multicast
/// delegate is a std::vector of them.
struct Delegate {
    Object object{};
    std::string function_name{};
    bool is_bound() const noexcept { return !object.is_null(); }
    friend bool operator==(const Delegate&, const Delegate&) = default;
};
template <>
struct Members<Delegate> {
    static constexpr std::string_view name = "FScriptDelegate";
    static constexpr auto list =
        std::tuple{Member{"Object", &Delegate::object}, Member{"FunctionName", &Delegate::function_name}};
};

// Enums
// -----------------------------------------------------------------------------------------------------------------------

// EnumEntries<E> (declared in codec.hpp) is specialised beside each generated enum, with
//   name: Unreal's;  flags: whether values are sets of bits;  list: an array of pairs (Unreal's name, value).

/// Unreal's name of a value, "ECC_Pawn"; empty if no entry has it.
template <GeneratedEnum E>
constexpr std::string_view enum_name(E value) {
    for (const auto& [name, entry] : EnumEntries<E>::list)
        if (entry == value)
            return name;
    return {};
}

/// The value of that name, if there is such an entry.
template <GeneratedEnum E>
constexpr std::optional<E> enum_from_name(std::string_view name) {
    for (const auto& [entry_name, entry] : EnumEntries<E>::list)
        if (entry_name == name)
            return entry;
    return {};
}

/// A generated enum travels by the name of its entry, so that an engine that numbers them in another way still gets the
/// entry that was meant; sets of bits, and values without a name, as numbers.
template <GeneratedEnum E>
struct Codec<E> {
    static constexpr std::string_view name = EnumEntries<E>::name;
    static void encode(Encoder& out, E value) {
        const std::string_view entry = EnumEntries<E>::flags ? std::string_view() : enum_name(value);
        if (entry.empty())
            Codec<std::int64_t>::encode(out, static_cast<std::int64_t>(value));
        else
            Codec<std::string>::encode(out, entry);
    }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, E& value) {
        if (type == types::string) {
            const std::optional<E> named = enum_from_name<E>(in.get_text());
            value = named.value_or(E{});
            return named ? CodecError::none : CodecError::out_of_range;
        }
        const TypeInfo* info = context.tables.find(type);
        const bool announced = info && info->kind == TypeKind::enumeration;
        std::int64_t number = 0;
        if (const CodecError error = decode_number(in, announced ? types::i64 : type, number);
            error != CodecError::none)
            return error;
        if (announced && !EnumEntries<E>::flags) {
            for (const EnumEntry& entry : info->entries) {
                if (entry.value == number) {
                    if (const std::optional<E> named = enum_from_name<E>(entry.name)) {
                        value = *named;
                        return CodecError::none;
                    }
                    break;
                }
            }
        }
        if (!std::in_range<std::underlying_type_t<E>>(number))
            return CodecError::out_of_range;
        value = static_cast<E>(number);
        return CodecError::none;
    }
};

/// UENUM(Flags): such enums have the operators of bits.
template <typename E>
concept FlagsEnum = GeneratedEnum<E> && EnumEntries<E>::flags;

namespace unreal {
template <FlagsEnum E>
constexpr E operator|(E a, E b) {
    using Bits = std::underlying_type_t<E>;
    return static_cast<E>(static_cast<Bits>(a) | static_cast<Bits>(b));
}
template <FlagsEnum E>
constexpr E operator&(E a, E b) {
    using Bits = std::underlying_type_t<E>;
    return static_cast<E>(static_cast<Bits>(a) & static_cast<Bits>(b));
}
template <FlagsEnum E>
constexpr E operator^(E a, E b) {
    using Bits = std::underlying_type_t<E>;
    return static_cast<E>(static_cast<Bits>(a) ^ static_cast<Bits>(b));
}
template <FlagsEnum E>
constexpr E operator~(E a) {
    return static_cast<E>(~static_cast<std::underlying_type_t<E>>(a));
}
template <FlagsEnum E>
constexpr E& operator|=(E& a, E b) {
    return a = a | b;
}
template <FlagsEnum E>
constexpr E& operator&=(E& a, E b) {
    return a = a & b;
}
} // namespace unreal

} // namespace spear

template <spear::GeneratedEnum E>
struct fmt::formatter<E> : fmt::formatter<std::string_view> {
    auto format(E value, fmt::format_context& context) const {
        const std::string_view name = spear::enum_name(value);
        return fmt::formatter<std::string_view>::format(
            name.empty() ? std::string_view(std::to_string(static_cast<std::int64_t>(value))) : name, context);
    }
};
