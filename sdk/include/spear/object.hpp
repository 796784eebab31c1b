// SPDX-License-Identifier: MIT
#pragma once

// Object: an object of the engine, its functions and properties by name.
//
//     spear::Object actor = game.find_actor_by_name("Table_3");
//     auto location = actor.call<spear::unreal::FVector>("K2_GetActorLocation");
//     actor.call("SetActorScale3D", spear::arg("NewScale3D", spear::unreal::FVector{4, 4, 4}));
//     double x = actor["RootComponent"]["RelativeLocation"]["X"].get<double>();
//     actor.property("CustomTimeDilation").set(0.5);
//
// Names are Unreal's and match without case. The spellings of aliases.hpp work too. All of this needs an open block
// (frame.hpp).

#include <array>
#include <concepts>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "spear/arguments.hpp"
#include "spear/session.hpp"

namespace spear {

class Object;
class Class;

template <typename T>
struct ProxyTraits; // proxy_types.hpp

/// A property path of an object: `object["RootComponent"]["RelativeLocation"]["X"]`. It leads through objects, structs,
/// arrays and maps, is resolved by the engine when it is read or written, and costs nothing until then.
class Property {
public:
    Property(OperationHandle owner, std::string path) : owner_future_(std::move(owner)), path_(std::move(path)) {}
    Property(ObjectHandle owner, std::string path) : owner_(std::move(owner)), path_(std::move(path)) {}

    /// A member: appends ".name". The name may itself be a path.
    Property operator[](std::string_view member) const { return extended(path_.empty() ? "" : ".", member, ""); }
    Property operator[](const char* member) const { return (*this)[std::string_view(member)]; }
    /// An element of an array: appends "[index]".
    Property operator[](int index) const { return extended("[", std::to_string(index), "]"); }
    /// An entry of a map: appends "[\"key\"]". Keys that are no strings are written as the engine prints them.
    Property key(std::string_view key) const;
    const std::string& path() const noexcept { return path_; }

    /// The session of its object. Raises NullObject, Disconnected.
    const std::shared_ptr<Session>& require_session() const;

    /// Reads it. Raises UnknownProperty, NullObject (on the way), OutOfRange (index), StaleObject, WrongType (it is no
    /// T).
    template <typename T = Value>
    T get() const {
        return read<CallMode::sync, T>();
    }
    template <typename T = Value>
    Future<T> async_get() const {
        return read<CallMode::async, T>();
    }
    /// Writes it, through the native setter where there is one. The value may be a future. Raises ReadOnly, WrongType,
    /// ... as well.
    template <typename T>
    void set(const T& value) const {
        write<CallMode::sync>(value);
    }
    template <typename T>
    Future<void> async_set(const T& value) const {
        return write<CallMode::async>(value);
    }
    template <typename T>
    void send_set(const T& value) const {
        write<CallMode::send>(value);
    }

    template <CallMode mode, typename T>
    CallResult<mode, T> read() const {
        const std::shared_ptr<Session>& session = require_session();
        OperationBuilder operation(*session, unreal_service::get_property);
        put_owner(operation);
        return detail::perform<mode, T>(operation, session);
    }
    template <CallMode mode, typename T>
    CallResult<mode, void> write(const T& value) const {
        const std::shared_ptr<Session>& session = require_session();
        OperationBuilder operation(*session, unreal_service::set_property);
        put_owner(operation);
        detail::put_reflected(operation, value);
        return detail::perform<mode, void>(operation, session);
    }

    /// Writes object and path as the first two arguments of an operation on it.
    void put_owner(OperationBuilder& operation) const;

private:
    Property extended(std::string_view before, std::string_view text, std::string_view after) const;

    OperationHandle owner_future_; // one of the two
    ObjectHandle owner_;
    std::string path_;
};

namespace detail {

/// Raises NullObject or Disconnected.
const std::shared_ptr<Session>& require_session(const ObjectHandle& object, std::string_view what);
const std::shared_ptr<Session>& require_session(const OperationHandle& operation, std::string_view what);

} // namespace detail

/// What can be done with an object, for Object and for Future<Object> alike. `Self` has put_self(OperationBuilder&),
/// session_for(what) and property_owner().
template <typename Self>
class ObjectOperations {
public:
    /// Calls a reflected function. Arguments are positional or named (`arg`), values or futures; those left out take
    /// the engine's defaults. R: the return value's type; for functions with out-parameters also a struct with members
    /// ReturnValue and the parameters' names; Value takes all of it, void drops it. On a class, calls a static function.
    /// Raises UnknownFunction, UnknownArgument, MissingArgument, WrongType, OutOfRange, StaleObject, NotCallable, and
    /// NotInFrame etc.
    template <typename R = Value, typename... A>
    R call(std::string_view function, const A&... arguments) const {
        return invoke<CallMode::sync, R>(function, arguments...);
    }
    template <typename R = Value, typename... A>
    Future<R> async(std::string_view function, const A&... arguments) const {
        return invoke<CallMode::async, R>(function, arguments...);
    }
    template <typename... A>
    void send(std::string_view function, const A&... arguments) const {
        invoke<CallMode::send, void>(function, arguments...);
    }
    template <CallMode mode, typename R, typename... A>
    CallResult<mode, R> invoke(std::string_view function, const A&... arguments) const {
        const std::shared_ptr<Session>& session = self().session_for(function);
        OperationBuilder operation(*session, unreal_service::call_function);
        self().put_self(operation);
        const std::array<std::string_view, sizeof...(A)> names{detail::argument_name(arguments)...};
        operation.put_shape(session->call_shape(function, names));
        (detail::put_reflected(operation, detail::argument_value(arguments)), ...);
        return detail::perform<mode, R>(operation, session);
    }

    /// A property by name or path.
    Property property(std::string_view path) const { return Property(self().property_owner(), std::string(path)); }
    Property operator[](std::string_view name) const { return property(name); }
    Property operator[](const char* name) const { return property(name); }

private:
    const Self& self() const { return static_cast<const Self&>(*this); }
};

/// An object of the engine, or null. Copyable; holds the session, not the object: when the engine destroys the object,
/// uses raise StaleObject.
class Object : public ObjectHandle, public ObjectOperations<Object> {
public:
    using ObjectOperations<Object>::operator[];
    Object() = default;
    Object(std::nullptr_t) {}
    explicit Object(const ObjectHandle& handle) : ObjectHandle(handle) {}
    explicit Object(ObjectHandle&& handle) noexcept : ObjectHandle(std::move(handle)) {}
    Object(std::shared_ptr<Session> session, ObjectRef ref) : ObjectHandle(std::move(session), ref) {}

    // Entry points about objects (they run at the next chance, in or out of a block).

    /// The object's path, its identity. Raises StaleObject.
    std::string path_name() const;
    /// Whether it still lives. False for null; never raises StaleObject.
    bool is_valid() const;
    Class get_class() const;
    /// Whether it is of the class (by name, or a Class), or of one derived from it, by the engine's own answer.
    bool is_a(std::string_view class_name) const;

    /// The object as a generated proxy (or any class derived from Object) if its class is, or derives from,
    /// T::unreal_name; else raises WrongType. No round trip, except for interfaces: whether it implements one is asked.
    template <std::derived_from<Object> T>
    T cast() const {
        bool fits = is_null();
        if constexpr (requires { ProxyTraits<T>::is_interface; })
            fits = fits || is_a(T::unreal_name);
        else
            fits = fits || derives_from(T::unreal_name);
        if (!fits)
            throw_bad_cast(T::unreal_name);
        return T(static_cast<const ObjectHandle&>(*this));
    }

private:
    friend class ObjectOperations<Object>;
    void put_self(OperationBuilder& operation) const { encode_handle(operation.out(), ref()); }
    const std::shared_ptr<Session>& session_for(std::string_view what) const {
        return detail::require_session(*this, what);
    }
    const ObjectHandle& property_owner() const { return *this; }
    [[noreturn]] void throw_bad_cast(std::string_view wanted) const;
};

/// A class of the engine. Calls on it are static functions, and functions of its default object.
class Class : public Object {
public:
    static constexpr std::string_view unreal_name = "UClass";
    Class() = default;
    explicit Class(const ObjectHandle& handle) : Object(handle) {}
    explicit Class(ObjectHandle&& handle) noexcept : Object(std::move(handle)) {}

    /// The class default object.
    Object default_object() const;
    /// Null for UObject.
    Class super_class() const;
    /// Sorted by name.
    std::vector<Class> derived_classes(bool recursive = true) const;
};

/// Object and every class derived from it, such as generated proxies.
template <std::derived_from<Object> T>
struct Codec<T> {
    static constexpr std::string_view name = Codec<ObjectRef>::name;
    static void encode(Encoder& out, const T& value) { Codec<ObjectHandle>::encode(out, value); }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, T& value) {
        ObjectHandle handle;
        const CodecError error = Codec<ObjectHandle>::decode(in, type, context, handle);
        value = T(std::move(handle));
        return error;
    }
};

namespace detail {

/// Futures of objects are used like the objects, with no round trip.
template <std::derived_from<ObjectHandle> T>
struct FutureMixin<T> : ObjectOperations<Future<T>> {
private:
    friend class ObjectOperations<Future<T>>;
    const OperationHandle& property_owner() const { return static_cast<const Future<T>&>(*this).operation(); }
    void put_self(OperationBuilder& operation) const { operation.put_future(property_owner()); }
    const std::shared_ptr<Session>& session_for(std::string_view what) const {
        return require_session(property_owner(), what);
    }
};

} // namespace detail
} // namespace spear
