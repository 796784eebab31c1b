// SPDX-License-Identifier: MIT
#pragma once

// Which C++ values fit which parameter of a typed call, checked at compile time, and how they are written.

#include <concepts>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "spear/arguments.hpp"
#include "spear/field.hpp"
#include "spear/proxy_types.hpp"

namespace spear {
namespace detail {

template <typename T>
inline constexpr bool is_optional = false;
template <typename T>
inline constexpr bool is_optional<std::optional<T>> = true;

template <typename T>
inline constexpr bool is_sequence = is_vector<T>;
template <typename T>
inline constexpr bool is_sequence<std::set<T>> = true;
template <typename T, std::size_t N>
inline constexpr bool is_sequence<std::array<T, N>> = true;

template <typename T>
inline constexpr bool is_associative = false;
template <typename K, typename V>
inline constexpr bool is_associative<std::map<K, V>> = true;
template <typename K, typename V>
inline constexpr bool is_associative<KeyValues<K, V>> = true;

/// Keys and values of a map type.
template <typename T>
struct EntryTypes;
template <typename K, typename V>
struct EntryTypes<std::map<K, V>> {
    using Key = K;
    using Value = V;
};
template <typename K, typename V>
struct EntryTypes<KeyValues<K, V>> {
    using Key = K;
    using Value = V;
};

template <typename T>
struct SubclassTarget;
template <typename T>
struct SubclassTarget<SubclassOf<T>> {
    using type = T;
};
template <typename T>
concept IsSubclassOf = requires { typename SubclassTarget<T>::type; };

template <typename T>
inline constexpr bool is_class_name = false;
template <typename T>
inline constexpr bool is_class_name<ClassName<T>> = true;

template <typename T>
inline constexpr bool is_soft = false;
template <typename T>
inline constexpr bool is_soft<SoftObject<T>> = true;
template <typename T>
inline constexpr bool is_soft<SoftClass<T>> = true;

/// Whether an A (a proxy class, Object, or null) may be given as a T. Does not need the definition of T.
template <typename T, typename A>
constexpr bool fits_object() {
    if constexpr (is_future<A>) {
        return fits_object<T, typename A::value_type>();
    } else if constexpr (std::is_null_pointer_v<A>) {
        return true;
    } else if constexpr (!std::derived_from<A, ObjectHandle>) {
        return false;
    } else if constexpr (std::is_same_v<T, unreal::UObject> || std::is_same_v<T, Object> || std::is_same_v<T, A>) {
        return true;
    } else {
        return std::derived_from<A, T> || std::is_base_of_v<Implements<T>, A>;
    }
}

/// Whether the class that an A means is a T or derives from it, as far as that is known here.
template <typename T, typename A>
constexpr bool fits_class() {
    if constexpr (IsSubclassOf<A>)
        return fits_object<T, typename SubclassTarget<A>::type>();
    else if constexpr (requires { typename A::StaticsOf; })
        return fits_object<T, typename A::StaticsOf>();
    else
        return std::is_same_v<A, Class>;
}
template <typename T, typename A>
constexpr bool fits_class_name(const ClassName<A>*) {
    return fits_object<T, A>();
}

/// Whether an A may be given where a P is wanted.
template <typename P, typename A>
constexpr bool fits_argument() {
    if constexpr (is_future<A>) {
        if constexpr (std::is_void_v<typename A::value_type>)
            return false;
        else
            return fits_argument<P, typename A::value_type>();
    } else if constexpr (std::is_same_v<A, P> || std::is_same_v<P, Value>) {
        return true;
    } else if constexpr (is_field<A>) {
        return fits_argument<P, typename A::value_type>();
    } else if constexpr (std::is_same_v<P, bool>) {
        return std::is_same_v<A, bool>;
    } else if constexpr (std::is_integral_v<P>) {
        return std::is_integral_v<A> && !std::is_same_v<A, bool>;
    } else if constexpr (std::is_floating_point_v<P>) {
        return std::is_arithmetic_v<A> && !std::is_same_v<A, bool>;
    } else if constexpr (std::is_enum_v<P>) {
        return false; // nothing but the enum itself
    } else if constexpr (std::is_same_v<P, std::string>) {
        return StringLike<A> && !std::is_null_pointer_v<A>;
    } else if constexpr (IsSubclassOf<P>) {
        using T = typename SubclassTarget<P>::type;
        if constexpr (is_class_name<A>)
            return fits_class_name<T>(static_cast<const A*>(nullptr));
        else
            return std::is_null_pointer_v<A> || StringLike<A> || fits_class<T, A>();
    } else if constexpr (is_soft<P>) {
        return StringLike<A> || fits_object<typename P::Target, A>();
    } else if constexpr (is_optional<P>) {
        if constexpr (is_optional<A>)
            return fits_argument<typename P::value_type, typename A::value_type>();
        else
            return std::is_same_v<A, std::nullopt_t> || fits_argument<typename P::value_type, A>();
    } else if constexpr (is_sequence<P>) {
        if constexpr (requires { typename A::value_type; } && std::ranges::sized_range<const A&> && !StringLike<A>)
            return fits_argument<typename P::value_type, typename A::value_type>();
        else
            return false;
    } else if constexpr (is_associative<P>) {
        if constexpr (requires { typename A::mapped_type; })
            return fits_argument<typename EntryTypes<P>::Key, typename A::key_type>() &&
                   fits_argument<typename EntryTypes<P>::Value, typename A::mapped_type>();
        else
            return false;
    } else if constexpr (std::is_same_v<P, Class>) {
        return is_class_name<A> || StringLike<A> || fits_object<Class, A>();
    } else if constexpr (std::derived_from<P, ObjectHandle>) {
        return fits_object<P, A>();
    } else {
        return std::is_same_v<P, Delegate> && std::is_null_pointer_v<A>;
    }
}

/// Whether values of T may hold members that are not given, or futures: such are written piece by piece.
template <typename T>
constexpr bool is_piecewise() {
    if constexpr (is_future<T> || is_field<T> || GeneratedStruct<T> || is_class_name<T>)
        return true;
    else if constexpr (is_associative<T>)
        return is_piecewise<typename EntryTypes<T>::Key>() || is_piecewise<typename EntryTypes<T>::Value>();
    else if constexpr (is_optional<T> || is_sequence<T>)
        return is_piecewise<typename T::value_type>();
    else
        return false;
}

template <typename T>
void put_pieces(OperationBuilder& operation, const T& value);

/// A generated struct as a dict of the members that are given.
template <typename T>
void put_struct(OperationBuilder& operation, const T& value) {
    std::uint32_t count = 0;
    const auto given = [](const auto& member) {
        if constexpr (is_field<std::remove_cvref_t<decltype(member)>>)
            return member.is_given();
        else
            return true;
    };
    StructTraits<T>::visit([&](std::string_view, const auto& member) { count += given(member) ? 1 : 0; }, value);
    operation.out().put(types::dict);
    operation.out().put(count);
    StructTraits<T>::visit(
        [&](std::string_view name, const auto& member) {
            if (given(member)) {
                operation.out().put_text(name);
                put_pieces(operation, member);
            }
        },
        value);
}

/// Any value: with announced types where that is possible, else piece by piece.
template <typename T>
void put_pieces(OperationBuilder& operation, const T& value) {
    Encoder& out = operation.out();
    if constexpr (is_future<T>) {
        operation.put_future(value.operation());
    } else if constexpr (!is_piecewise<T>()) {
        encode_typed(out, value, operation.types());
    } else if constexpr (is_class_name<T>) {
        Codec<std::string>::encode(out, T::name());
    } else if constexpr (is_field<T>) {
        if (const OperationHandle* future = value.future())
            operation.put_future(*future);
        else
            put_pieces(operation, value.stored());
    } else if constexpr (GeneratedStruct<T>) {
        put_struct(operation, value);
    } else if constexpr (is_optional<T>) {
        if (value)
            put_pieces(operation, *value);
        else
            out.put(types::null);
    } else if constexpr (is_associative<T>) {
        out.put(types::map);
        out.put(static_cast<std::uint32_t>(value.size()));
        for (const auto& [key, element] : value) {
            put_pieces(operation, key);
            put_pieces(operation, element);
        }
    } else {
        out.put(types::list);
        out.put(static_cast<std::uint32_t>(value.size()));
        for (const auto& element : value)
            put_pieces(operation, element);
    }
}

/// An argument for a P.
template <typename P, typename A>
void put_argument(OperationBuilder& operation, const A& argument) {
    if constexpr (std::is_floating_point_v<P> && std::is_arithmetic_v<A>)
        Codec<P>::encode(operation.out(), static_cast<P>(argument));
    else if constexpr (std::is_same_v<A, std::nullopt_t>)
        operation.out().put(types::null);
    else
        put_pieces(operation, argument);
}

} // namespace detail

/// A value, or a future of one, that may be given where a P is wanted.
template <typename A, typename P>
concept Argument = detail::fits_argument<P, A>();
/// The same for parameters that may be left out by `spear::omit`.
template <typename A, typename P>
concept OptionalArgument = std::is_same_v<A, Omitted> || Argument<A, P>;
/// A T, an object derived from it or implementing it, null, or a future of such. Needs no definition of T.
template <typename A, typename T>
concept ObjectArgument = detail::fits_object<T, A>();
template <typename A, typename T>
concept OptionalObjectArgument = std::is_same_v<A, Omitted> || ObjectArgument<A, T>;

/// What a parameter that the caller leaves out is bound to: told by its address.
template <typename A>
inline const A omitted{};

} // namespace spear
