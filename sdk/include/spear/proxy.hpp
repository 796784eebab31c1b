// SPDX-License-Identifier: MIT
#pragma once

// What generated proxies (spear/unreal/<Module>/<Type>.hpp) are made of. A proxy class holds what an Object holds, and
// nothing else: its functions and properties are written in layers, one template for each Unreal class, that stand on
// whatever a call can start from. So the same layers serve
//
//     actor.SetActorScale3D({4, 4, 4});                     // an object: synchronous
//     actor.async().K2_GetActorLocation()                   // Future<FVector>
//     actor.send().SetActorScale3D({1, 1, 1});              // fire and forget
//     game.async().spawn_actor<unreal::AActor>().async().K2_GetActorLocation()     // a future of an object
//     actor.RootComponent().K2_GetComponentLocation()       // the path to an object
//     game.get_class<unreal::UGameplayStatics>().GetGameMode()                     // a class: static functions
//
// Arguments are values or futures, checked at compile time; those with a default may be left out.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "spear/game.hpp"
#include "spear/proxy_arguments.hpp"
#include "spear/proxy_types.hpp"
#include "spear/typed_property.hpp"
#include "spear/unreal_types.hpp"

namespace spear {
namespace detail {

inline const std::shared_ptr<Session>& require_session(const Property& path, std::string_view) {
    return path.require_session();
}

inline void put_target(OperationBuilder& operation, const ObjectHandle& object) {
    Codec<ObjectRef>::encode(operation.out(), object.ref());
}
inline void put_target(OperationBuilder& operation, const OperationHandle& future) { operation.put_future(future); }
/// The object at the path is read first, in the same message.
inline void put_target(OperationBuilder& operation, const Property& path) {
    operation.put_future(path.async_get<Object>().operation());
}

/// One argument of a typed call: P is the parameter's type.
template <typename P, typename A>
struct Input {
    std::string_view name;
    const A& value;

    bool is_given() const noexcept {
        if constexpr (std::is_same_v<A, Omitted>)
            return false;
        else if constexpr (!std::is_same_v<A, P>)
            return true; // only the parameter's own type stands for nothing, by omitted<P>
        else
            return static_cast<const void*>(&value) != static_cast<const void*>(&omitted<A>);
    }
    void put(OperationBuilder& operation) const {
        if constexpr (!std::is_same_v<A, Omitted>) {
            if (is_given())
                put_argument<std::conditional_t<std::is_void_v<P>, Object, P>>(operation, value);
        }
    }
};
} // namespace detail

/// An argument of call_proxy.
template <typename P, typename A>
detail::Input<P, A> input(std::string_view name, const A& value) {
    return {name, value};
}
/// The same for a parameter that is an object: T need not be defined.
template <typename A>
detail::Input<void, A> object_input(std::string_view name, const A& value) {
    return {name, value};
}

/// What a function of a proxy whose layers end in Base gives.
template <typename Base, typename R>
using ResultOf = CallResult<detail::call_mode_of<Base>(), R>;

/// Calls a reflected function for a proxy. Arguments left out do not travel.
template <typename R, typename Self, typename... I>
CallResult<detail::call_mode_of<Self>(), R> call_proxy(
    const Self& self, std::string_view function, const I&... inputs) {
    static_assert(detail::Complete<R>,
        "the result's type is only declared here: include its header, <spear/unreal/MODULE/TYPE.hpp>");
    const auto& target = detail::target_of(self);
    const std::shared_ptr<Session>& session = detail::require_session(target, function);
    OperationBuilder operation(*session, unreal_service::call_function);
    detail::put_target(operation, target);
    std::array<std::string_view, sizeof...(I)> names;
    std::size_t given = 0;
    ((inputs.is_given() ? void(names[given++] = inputs.name) : void()), ...);
    operation.put_shape(session->call_shape(function, std::span(names).first(given)));
    (inputs.put(operation), ...);
    return detail::perform<detail::call_mode_of<Self>(), R>(operation, session);
}

/// The same with a struct of named arguments.
template <typename R, typename Self, typename Arguments>
CallResult<detail::call_mode_of<Self>(), R> call_proxy_named(
    const Self& self, std::string_view function, const Arguments& arguments) {
    static_assert(detail::Complete<R>,
        "the result's type is only declared here: include its header, <spear/unreal/MODULE/TYPE.hpp>");
    const auto& target = detail::target_of(self);
    const std::shared_ptr<Session>& session = detail::require_session(target, function);
    OperationBuilder operation(*session, unreal_service::call_function);
    detail::put_target(operation, target);
    std::vector<std::string_view> names;
    StructTraits<Arguments>::visit(
        [&](std::string_view name, const auto& argument) {
            if (argument.is_given())
                names.push_back(name);
        },
        arguments);
    operation.put_shape(session->call_shape(function, names));
    StructTraits<Arguments>::visit(
        [&](std::string_view, const auto& argument) {
            if (argument.is_given())
                detail::put_pieces(operation, argument);
        },
        arguments);
    return detail::perform<detail::call_mode_of<Self>(), R>(operation, session);
}

/// T, in a template that is not to need its definition before it is used.
template <typename T, typename>
struct Deferred {
    using type = T;
};

/// The layers of a proxy class on another base.
template <ProxyClass T, typename Base>
using LayersOf = typename ProxyTraits<T>::template Layers<Base>;

/// The last part of every proxy class: async() and send().
template <typename Self, typename Base>
class Proxy : public Base {
public:
    using Base::async;
    using Base::Base;
    using Base::send;
    /// The same functions giving futures, and properties whose get() and set() give futures.
    auto async() const { return with_mode<CallMode::async>(); }
    /// The same functions without a result: failures are raised when the block ends.
    auto send() const { return with_mode<CallMode::send>(); }

private:
    template <CallMode mode>
    auto with_mode() const {
        return LayersOf<Self, detail::CallTarget<ObjectHandle, mode>>(static_cast<const ObjectHandle&>(*this));
    }
};

/// What Game::get_class<T>() gives: the class T as a value, with its static functions.
template <typename T>
class ClassOf : public Proxy<ClassOf<T>, typename ProxyTraits<T>::template Statics<SubclassOf<T>>> {
public:
    using Proxy<ClassOf<T>, typename ProxyTraits<T>::template Statics<SubclassOf<T>>>::Proxy;
    using StaticsOf = T;
};
template <typename T>
struct ProxyTraits<ClassOf<T>> {
    template <typename Base>
    using Layers = typename ProxyTraits<T>::template Statics<Base>;
};

namespace detail {

/// A future of an object as the start of calls.
template <typename T>
class FutureTarget : public ObjectOperations<Future<T>> {
public:
    static constexpr CallMode spear_call_mode = CallMode::sync;
    const OperationHandle& spear_target() const { return static_cast<const Future<T>&>(*this).operation(); }

private:
    friend class ObjectOperations<Future<T>>;
    const OperationHandle& property_owner() const { return spear_target(); }
    void put_self(OperationBuilder& operation) const { operation.put_future(spear_target()); }
    const std::shared_ptr<Session>& session_for(std::string_view what) const {
        return require_session(spear_target(), what);
    }
};

/// Futures of proxies are used like the proxies, with no round trip for the object.
template <ProxyClass T>
struct FutureMixin<T> : LayersOf<T, FutureTarget<T>> {
    using ObjectOperations<Future<T>>::async;
    using ObjectOperations<Future<T>>::send;
    auto async() const { return with_mode<CallMode::async>(); }
    auto send() const { return with_mode<CallMode::send>(); }

private:
    template <CallMode mode>
    auto with_mode() const {
        return LayersOf<T, CallTarget<OperationHandle, mode>>(this->spear_target());
    }
};

} // namespace detail

/// A generated struct: a dict of the members given; read from a dict or an announced struct of that name. Members that
/// the engine does not have stay not given, those that it has in addition are skipped.
template <GeneratedStruct T>
struct Codec<T> {
    static constexpr std::string_view name = StructTraits<T>::name;
    static void encode(Encoder& out, const T& value) {
        const auto given = [](const auto& member) {
            if constexpr (detail::is_field<std::remove_cvref_t<decltype(member)>>)
                return member.is_given();
            else
                return true;
        };
        std::uint32_t count = 0;
        StructTraits<T>::visit([&](std::string_view, const auto& member) { count += given(member) ? 1 : 0; }, value);
        out.put(types::dict);
        out.put(count);
        StructTraits<T>::visit(
            [&](std::string_view field, const auto& member) {
                if (given(member)) {
                    out.put_text(field);
                    encode_value(out, member);
                }
            },
            value);
    }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, T& value) {
        value = T{};
        if (type == types::dict) {
            for (std::uint32_t n = in.get_count(8); n != 0 && in.ok(); --n) {
                const std::string_view field = in.get_text();
                if (const CodecError error = decode_member(in, field, types::any, context, value);
                    error != CodecError::none)
                    return error;
            }
            return CodecError::none;
        }
        const TypeInfo* info = context.tables.find(type);
        if (!info || info->kind != TypeKind::structure || info->name != name)
            return CodecError::wrong_type;
        // Nearly always all members come in the order in which they stand here.
        CodecError error = CodecError::none;
        std::size_t at = 0;
        bool in_order = true;
        StructTraits<T>::visit(
            [&](std::string_view field, auto& member) {
                if (!in_order || error != CodecError::none)
                    return;
                if (at == info->fields.size() || info->fields[at].name != field)
                    in_order = false;
                else
                    error = decode_element(in, info->fields[at++].type, context, member);
            },
            value);
        for (; at < info->fields.size() && error == CodecError::none && in.ok(); ++at)
            error = decode_member(in, info->fields[at].name, info->fields[at].type, context, value);
        return error;
    }

private:
    static CodecError decode_member(
        Decoder& in, std::string_view field, TypeId type, const DecodeContext& context, T& value) {
        CodecError error = CodecError::none;
        bool known = false;
        StructTraits<T>::visit(
            [&](std::string_view member_name, auto& member) {
                if (!known && member_name == field) {
                    known = true;
                    error = decode_element(in, type, context, member);
                }
            },
            value);
        if (!known) {
            if (type == types::any)
                type = in.get<TypeId>();
            skip_payload(in, type, context.tables);
        }
        return error;
    }
};

} // namespace spear
