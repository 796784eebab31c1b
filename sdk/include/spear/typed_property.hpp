// SPDX-License-Identifier: MIT
#pragma once

// TypedProperty<T>: a property path whose type is known at compile time, as generated proxies give it.
//
//     double x = actor.RootComponent().RelativeLocation().X().get();       // one round trip
//     actor.RootComponent().RelativeLocation().set({1, 2, 3});
//     spear::Future<double> later = actor.async().RootComponent().RelativeLocation().X().get();
//     actor.Tags()[0].set("door");    int weight = thing.Weights()["door"].get();
//
// It leads through objects, structs and containers, is resolved by the engine when it is read or written, and costs
// nothing until then. Paths to objects have the functions of their class too: the object is looked up and called in one
// round trip.

#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "spear/proxy_arguments.hpp"

namespace spear {

template <typename T, CallMode mode = CallMode::sync>
class TypedProperty;

namespace detail {

/// What calls and properties of a proxy start from: an object, a future of one, or the path to one.
template <typename Target, CallMode mode>
class CallTarget {
public:
    static constexpr CallMode spear_call_mode = mode;
    explicit CallTarget(Target target) : target_(std::move(target)) {}
    const Target& spear_target() const noexcept { return target_; }

private:
    Target target_;
};

template <typename T>
constexpr CallMode call_mode_of() {
    if constexpr (std::derived_from<T, ObjectHandle>)
        return CallMode::sync;
    else
        return T::spear_call_mode;
}

template <typename T>
const auto& target_of(const T& self) {
    if constexpr (std::derived_from<T, ObjectHandle>)
        return static_cast<const ObjectHandle&>(self);
    else
        return self.spear_target();
}

inline Property property_of(const ObjectHandle& object, std::string_view name) {
    return Property(object, std::string(name));
}
inline Property property_of(const OperationHandle& future, std::string_view name) {
    return Property(future, std::string(name));
}
inline Property property_of(const Property& path, std::string_view name) { return path[name]; }

/// The text of a map's key within a path.
template <typename K>
std::string key_text(const K& key) {
    if constexpr (StringLike<K>)
        return std::string(std::string_view(key));
    else if constexpr (is_soft<K>)
        return key.path;
    else if constexpr (GeneratedEnum<K>)
        return enum_name(key).empty() ? std::to_string(static_cast<std::int64_t>(key)) : std::string(enum_name(key));
    else if constexpr (std::is_same_v<K, bool>)
        return key ? "True" : "False";
    else
        return std::to_string(key);
}

/// Base with the elements of a container.
template <typename T, typename Base>
class ElementPaths : public Base {
public:
    using Base::Base;
    /// An element; raises OutOfRange when it is used and there is none.
    auto operator[](int index) const {
        return TypedProperty<typename T::value_type, Base::spear_call_mode>(this->spear_target()[index]);
    }
};
template <typename K, typename V, typename Base>
class ElementPaths<std::map<K, V>, Base> : public Base {
public:
    using Base::Base;
    /// The value of a key; writing adds the key.
    auto operator[](const K& key) const {
        return TypedProperty<V, Base::spear_call_mode>(this->spear_target().key(key_text(key)));
    }
};
template <typename K, typename V, typename Base>
class ElementPaths<KeyValues<K, V>, Base> : public Base {
public:
    using Base::Base;
};

template <typename T, typename Base>
struct PathLayersOf {
    using type = Base;
};
template <ProxyClass T, typename Base>
struct PathLayersOf<T, Base> {
    using type = typename ProxyTraits<T>::template Layers<Base>;
};
template <GeneratedStruct T, typename Base>
struct PathLayersOf<T, Base> {
    using type = typename StructTraits<T>::template Path<Base>;
};
template <typename T, typename Base>
    requires(is_sequence<T> || is_associative<T>)
struct PathLayersOf<T, Base> {
    using type = ElementPaths<T, Base>;
};

} // namespace detail

/// `mode`: what get() and set() do: wait, or give futures, or send and forget.
template <typename T, CallMode mode>
class TypedProperty : public detail::PathLayersOf<T, detail::CallTarget<Property, mode>>::type {
    static_assert(detail::Complete<T>,
        "the property's type is only declared here: include its header, <spear/unreal/MODULE/TYPE.hpp>");
    using Layers = typename detail::PathLayersOf<T, detail::CallTarget<Property, mode>>::type;

public:
    using value_type = T;
    using Layers::Layers;

    /// Reads it. Raises NullObject (on the way), OutOfRange (index), StaleObject, ...
    CallResult<mode, T> get() const
        requires(mode != CallMode::send)
    {
        return property().template read<mode, T>();
    }
    Future<T> async_get() const { return property().template read<CallMode::async, T>(); }
    /// Writes it, through the native setter where there is one. Of structs only the members given. Raises ReadOnly, ...
    template <Argument<T> A = T>
    CallResult<mode, void> set(const A& value) const {
        return write<mode>(value);
    }
    template <Argument<T> A = T>
    Future<void> async_set(const A& value) const {
        return write<CallMode::async>(value);
    }
    template <Argument<T> A = T>
    void send_set(const A& value) const {
        write<CallMode::send>(value);
    }

    /// The same path with get() and set() that give futures, or that send and forget.
    TypedProperty<T, CallMode::async> async() const { return TypedProperty<T, CallMode::async>(property()); }
    TypedProperty<T, CallMode::send> send() const { return TypedProperty<T, CallMode::send>(property()); }
    /// The path without its type.
    const Property& property() const noexcept { return this->spear_target(); }
    const std::string& path() const noexcept { return property().path(); }

private:
    template <CallMode how, typename A>
    CallResult<how, void> write(const A& value) const {
        const std::shared_ptr<Session>& session = property().require_session();
        OperationBuilder operation(*session, unreal_service::set_property);
        property().put_owner(operation);
        detail::put_argument<T>(operation, value);
        return detail::perform<how, void>(operation, session);
    }
};

/// The type of a property of a proxy whose layers end in Base.
template <typename Base, typename T>
using PropertyOf = TypedProperty<T, detail::call_mode_of<Base>()>;

/// A property of a proxy, or a member of a struct path.
template <typename T, typename Self>
auto typed_property(const Self& self, std::string_view name) {
    return TypedProperty<T, detail::call_mode_of<Self>()>(detail::property_of(detail::target_of(self), name));
}

} // namespace spear

#include "spear/unreal_paths.hpp" // IWYU pragma: keep (paths to the structs of unreal_types.hpp)
