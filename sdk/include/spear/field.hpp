// SPDX-License-Identifier: MIT
#pragma once

// Field<T>: a member of a generated struct. It is either not given, and then does not travel, so that the engine's own
// initial value counts (in a call) or the present one stays (in a property); or it holds a T, or a future of one.
//
//     spear::unreal::FHitResult hit{.Time = 0.5f, .Location = {1, 2, 3}, .BoneName = actor.async().GetBone()};
//     double x = hit.Location->X;    float time = hit.Time;    if (hit.bBlockingHit) ...
//
// Structs that the engine sends have all their members. Reading one that is not given raises ArgumentError.

#include <concepts>
#include <initializer_list>
#include <memory>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "spear/error.hpp"
#include "spear/future.hpp"
#include "spear/object.hpp"

namespace spear {

template <typename T>
class Field;
template <typename T>
class ObjectField;

namespace detail {

template <typename T>
inline constexpr bool is_field = false;
template <typename T>
inline constexpr bool is_field<Field<T>> = true;
template <typename T>
inline constexpr bool is_field<ObjectField<T>> = true;

template <typename P, typename A>
constexpr bool fits_argument();
template <typename T, typename A>
constexpr bool fits_object();

/// What is converted to a T when it is assigned; everything that an argument may be, except what only travels.
template <typename T, typename A>
constexpr bool fits_field() {
    if constexpr (is_future<A> || is_field<A>)
        return false;
    else
        return fits_argument<T, A>() && std::constructible_from<T, const A&>;
}

/// Integers only if they fit: raises OutOfRange.
template <typename T, typename A>
T member_cast(const A& value) {
    if constexpr (std::is_integral_v<T> && std::is_integral_v<A> && !std::is_same_v<T, bool>) {
        if (!std::in_range<T>(value))
            throw_error(ErrorCode::OutOfRange, fmt::format("{} is outside the range of a member of a struct.", value));
    }
    return static_cast<T>(value);
}

[[noreturn]] inline void throw_not_given() {
    throw_error(ErrorCode::ArgumentError, "This member of a struct has no value here: it was not given, or is a "
                                          "future. The engine's own value for it is known to the "
                                          "engine only.");
}

} // namespace detail

template <typename T>
class Field {
public:
    using value_type = T;

    Field() {} // not defaulted: T may hold a struct that contains this member, which is not complete yet
    Field(T value) : value_(std::move(value)), given_(true) {}
    template <typename A>
        requires(!std::is_same_v<A, T> && detail::fits_field<T, A>())
    Field(const A& value) : value_(detail::member_cast<T>(value)), given_(true) {}
    template <typename U>
        requires(detail::fits_argument<T, Future<U>>())
    Field(const Future<U>& future)
        : future_(std::make_shared<const OperationHandle>(future.operation())), given_(true) {}
    /// `.Location = {1, 2, 3}`
    template <typename... A>
        requires(sizeof...(A) > 1 && std::is_aggregate_v<T> && requires(A&&... a) { T(std::forward<A>(a)...); })
    Field(A&&... members) : value_(std::forward<A>(members)...), given_(true) {}
    /// `.Tags = {"one", "two"}`
    template <typename E>
        requires(!std::is_aggregate_v<T> && std::constructible_from<T, std::initializer_list<E>> &&
                    !std::convertible_to<const T&, std::string_view>)
    Field(std::initializer_list<E> elements) : value_(elements), given_(true) {}

    /// Whether it travels.
    bool is_given() const noexcept { return given_; }
    /// Whether it holds a value that can be read.
    bool has_value() const noexcept { return given_ && !future_; }
    const T& get() const {
        if (!has_value())
            detail::throw_not_given();
        return value_;
    }
    T value_or(T otherwise) const { return has_value() ? get() : std::move(otherwise); }
    operator const T&() const { return get(); }
    const T& operator*() const { return get(); }
    const T* operator->() const { return &get(); }
    /// To change what is given; raises, like reading, if it is not.
    T& operator*() { return const_cast<T&>(std::as_const(*this).get()); }
    T* operator->() { return &**this; }
    /// To change it, also when it is not given yet.
    T& edit() {
        if (!has_value())
            *this = Field(T{});
        return value_;
    }
    void reset() { *this = Field(); }

    friend bool operator==(const Field& a, const Field& b) {
        return a.is_given() == b.is_given() &&
               (!a.is_given() || (a.has_value() && b.has_value() && a.get() == b.get()));
    }
    template <typename U>
        requires(!detail::is_field<U>)
    friend bool operator==(const Field& a, const U& b) {
        return a.get() == b;
    }

    /// For encoding: the future, if it is one; the value otherwise.
    const OperationHandle* future() const noexcept { return future_.get(); }
    const T& stored() const { return get(); }

private:
    T value_{};
    std::shared_ptr<const OperationHandle> future_;
    bool given_ = false;
};

/// A member that refers to an object; needs the definition of T only where it is used.
template <typename T>
class ObjectField {
public:
    using value_type = T;

    ObjectField() = default;
    template <typename A>
        requires(std::derived_from<A, ObjectHandle> && detail::fits_object<T, A>())
    ObjectField(const A& object) : object_(object), given_(true) {}
    ObjectField(std::nullptr_t) : given_(true) {}
    template <typename U>
        requires(detail::fits_object<T, U>())
    ObjectField(const Future<U>& future)
        : future_(std::make_shared<const OperationHandle>(future.operation())), given_(true) {}

    bool is_given() const noexcept { return given_; }
    bool has_value() const noexcept { return given_ && !future_; }
    /// Whatever object it is; not checked.
    static ObjectField of(const ObjectHandle& object) {
        ObjectField field(nullptr);
        field.object_ = object;
        return field;
    }
    /// The object; may be null.
    T get() const { return T(stored()); }
    operator T() const { return get(); }
    T operator*() const { return get(); }
    /// Calls and properties of the object.
    std::unique_ptr<T> operator->() const { return std::make_unique<T>(get()); }
    bool is_null() const { return stored().is_null(); }
    void reset() noexcept { *this = ObjectField(); }
    friend bool operator==(const ObjectField& a, const ObjectField& b) {
        return a.given_ == b.given_ && !a.future_ && !b.future_ && a.object_ == b.object_;
    }
    friend bool operator==(const ObjectField& a, const ObjectHandle& b) { return a.stored() == b; }

    const OperationHandle* future() const noexcept { return future_.get(); }
    const ObjectHandle& stored() const {
        if (!has_value())
            detail::throw_not_given();
        return object_;
    }

private:
    ObjectHandle object_;
    std::shared_ptr<const OperationHandle> future_;
    bool given_ = false;
};

/// A member that must be given.
template <typename T>
class RequiredField : public Field<T> {
public:
    using Field<T>::Field;
    RequiredField() = delete;
};
template <typename T>
class RequiredObjectField : public ObjectField<T> {
public:
    using ObjectField<T>::ObjectField;
    RequiredObjectField() = delete;
};

namespace detail {
template <typename T>
inline constexpr bool is_field<RequiredField<T>> = true;
template <typename T>
inline constexpr bool is_field<RequiredObjectField<T>> = true;
} // namespace detail

template <typename T>
struct Codec<Field<T>> {
    static constexpr std::string_view name = "member";
    /// Only of what holds a value: futures need an operation (proxy_arguments.hpp).
    static void encode(Encoder& out, const Field<T>& value) { encode_value(out, value.get()); }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, Field<T>& value) {
        return Codec<T>::decode(in, type, context, value.edit());
    }
};

template <typename T>
struct Codec<ObjectField<T>> {
    static constexpr std::string_view name = "object";
    static void encode(Encoder& out, const ObjectField<T>& value) { encode_value(out, value.stored()); }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, ObjectField<T>& value) {
        Object object;
        const CodecError error = Codec<Object>::decode(in, type, context, object);
        if (error == CodecError::none)
            value = ObjectField<T>::of(object);
        return error;
    }
};

} // namespace spear

template <typename T>
struct fmt::formatter<spear::Field<T>> : fmt::formatter<T> {
    auto format(const spear::Field<T>& field, fmt::format_context& context) const {
        return fmt::formatter<T>::format(field.get(), context);
    }
};
