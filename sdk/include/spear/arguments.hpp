// SPDX-License-Identifier: MIT
#pragma once

// Which C++ values fit which parameter, and how they are written into an operation.

#include <concepts>
#include <ranges>
#include <string_view>
#include <type_traits>
#include <utility>

#include "spear/entry_points/types.hpp"
#include "spear/future.hpp"
#include "spear/object_handle.hpp"
#include "spear/value.hpp"

namespace spear {

/// A named argument of a reflected call: arg("NewScale3D", value).
template <typename T>
struct NamedArgument {
    std::string_view name;
    T value; // a reference for lvalues: lives until the end of the full expression
};
template <typename T>
NamedArgument<T> arg(std::string_view name, T&& value) {
    return {name, std::forward<T>(value)};
}

/// A class as an argument: its name or path, a Class, or a future of one. Nothing at all: no restriction.
class ClassReference {
public:
    ClassReference() = default;
    ClassReference(const char* name) : argument_{{}, name} {}
    ClassReference(std::string_view name) : argument_{{}, std::string(name)} {}
    ClassReference(std::string name) : argument_{{}, std::move(name)} {}
    ClassReference(const ObjectHandle& object) : argument_{object.ref(), {}} {}
    template <std::derived_from<ObjectHandle> T>
    ClassReference(const Future<T>& future) : future_(future.operation()) {}

    void put(OperationBuilder& operation) const {
        if (future_.valid())
            operation.put_future(future_);
        else
            Codec<ClassArgument>::encode(operation.out(), argument_);
    }

private:
    ClassArgument argument_;
    OperationHandle future_;
};

/// An object as an argument: an Object, null, or a future of one.
class ObjectReference {
public:
    ObjectReference(std::nullptr_t = nullptr) {}
    ObjectReference(const ObjectHandle& object) : ref_(object.ref()) {}
    template <std::derived_from<ObjectHandle> T>
    ObjectReference(const Future<T>& future) : future_(future.operation()) {}

    void put(OperationBuilder& operation) const {
        if (future_.valid())
            operation.put_future(future_);
        else
            Codec<ObjectRef>::encode(operation.out(), ref_);
    }

private:
    ObjectRef ref_;
    OperationHandle future_;
};

namespace detail {

template <typename T>
inline constexpr bool is_named_argument = false;
template <typename T>
inline constexpr bool is_named_argument<NamedArgument<T>> = true;

template <typename A>
std::string_view argument_name(const A& argument) {
    if constexpr (is_named_argument<A>)
        return argument.name;
    else
        return {};
}
template <typename A>
const auto& argument_value(const A& argument) {
    if constexpr (is_named_argument<A>)
        return argument.value;
    else
        return argument;
}

/// Whether values of A hold futures, at any depth of containers.
template <typename A>
constexpr bool holds_future() {
    if constexpr (is_future<A>)
        return true;
    else if constexpr (requires { typename A::mapped_type; })
        return holds_future<typename A::mapped_type>();
    else if constexpr (requires { typename A::value_type; } && std::ranges::sized_range<const A&> && !StringLike<A>)
        return holds_future<typename A::value_type>();
    else
        return false;
}

/// An argument of a reflected function or a value for a property: anything that encode_typed takes, a future of
/// anything, or a container of futures: a list is an array or a set, a map with names a struct or a map.
template <typename A>
void put_reflected(OperationBuilder& operation, const A& argument) {
    if constexpr (is_future<A>) {
        operation.put_future(argument.operation());
    } else if constexpr (!holds_future<A>()) {
        encode_typed(operation.out(), argument, operation.types());
    } else if constexpr (requires { typename A::mapped_type; }) {
        constexpr bool has_names = StringLike<typename A::key_type>;
        operation.out().put(has_names ? types::dict : types::map);
        operation.out().put(static_cast<std::uint32_t>(argument.size()));
        for (const auto& [key, value] : argument) {
            if constexpr (has_names)
                operation.out().put_text(key);
            else
                put_reflected(operation, key);
            put_reflected(operation, value);
        }
    } else {
        operation.out().put(types::list);
        operation.out().put(static_cast<std::uint32_t>(argument.size()));
        for (const auto& element : argument)
            put_reflected(operation, element);
    }
}

/// Whether an A may stand for an entry point's parameter of type P.
template <typename P, typename A>
constexpr bool fits_parameter() {
    if constexpr (is_future<A>) {
        using T = typename A::value_type;
        if constexpr (std::is_void_v<T>)
            return false;
        else
            return std::is_same_v<T, Value> || fits_parameter<P, T>();
    } else if constexpr (std::is_same_v<P, AnyView>) {
        return true;
    } else if constexpr (std::is_same_v<P, ObjectRef>) {
        return std::derived_from<A, ObjectHandle> || std::is_same_v<A, ObjectRef> ||
               std::is_same_v<A, ObjectReference> || std::is_null_pointer_v<A>;
    } else if constexpr (std::is_same_v<P, ClassArgument>) {
        return std::derived_from<A, ObjectHandle> || std::is_same_v<A, ClassArgument> ||
               std::is_same_v<A, ClassReference> || StringLike<A>;
    } else if constexpr (std::is_same_v<P, std::string_view>) {
        return StringLike<A>;
    } else if constexpr (std::is_same_v<P, bool>) {
        return std::is_same_v<A, bool>;
    } else {
        return std::convertible_to<const A&, P>;
    }
}

/// One argument of an entry point.
template <typename P, typename A>
void put_parameter(OperationBuilder& operation, const A& argument) {
    static_assert(fits_parameter<P, A>(), "an argument of the wrong type for this entry point");
    Encoder& out = operation.out();
    if constexpr (is_future<A>) {
        operation.put_future(argument.operation());
    } else if constexpr (std::is_same_v<A, ClassReference> || std::is_same_v<A, ObjectReference>) {
        argument.put(operation);
    } else if constexpr (std::is_same_v<P, AnyView>) {
        if constexpr (std::is_same_v<A, AnyView>)
            Codec<AnyView>::encode(out, argument);
        else
            encode_typed(out, argument, operation.types());
    } else if constexpr (std::derived_from<A, ObjectHandle>) {
        Codec<ObjectRef>::encode(out, argument.ref());
    } else if constexpr (std::is_null_pointer_v<A>) {
        out.put(types::null);
    } else if constexpr (std::is_same_v<P, ClassArgument> && StringLike<A>) {
        Codec<std::string>::encode(out, std::string_view(argument));
    } else if constexpr (std::is_same_v<P, std::string_view>) {
        Codec<std::string>::encode(out, std::string_view(argument));
    } else {
        Codec<P>::encode(out, static_cast<P>(argument));
    }
}

/// All arguments of an entry point: as many as it has parameters, each of a fitting type.
template <typename E, typename... A>
void put_parameters(OperationBuilder& operation, const A&... arguments) {
    using Parameters = typename E::Arguments;
    constexpr std::size_t count = std::tuple_size_v<Parameters>;
    static_assert(sizeof...(A) == count, "the wrong number of arguments for this entry point");
    [&]<std::size_t... I>(std::index_sequence<I...>) {
        (put_parameter<std::tuple_element_t<I, Parameters>>(operation, arguments), ...);
    }(std::make_index_sequence<count>{});
}

} // namespace detail
} // namespace spear
