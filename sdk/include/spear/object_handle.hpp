// SPDX-License-Identifier: MIT
#pragma once

// A reference to an object of the engine together with the session that it belongs to. What users hold is Object
// (object.hpp), which adds calls and properties to this.

#include <cstdint>
#include <memory>
#include <string_view>

#include "spear/codec.hpp"

namespace spear {

class Session;

/// Copyable; copies refer to the same object. A handle keeps the session's memory, not the engine's object, alive.
class ObjectHandle {
public:
    ObjectHandle() = default;
    ObjectHandle(std::shared_ptr<Session> session, ObjectRef ref) : session_(std::move(session)), ref_(ref) {}

    bool is_null() const noexcept { return ref_.handle == 0; }
    explicit operator bool() const noexcept { return !is_null(); }
    /// What travels: slot and generation, and the announced class.
    ObjectRef ref() const noexcept { return ref_; }
    const std::shared_ptr<Session>& session() const noexcept { return session_; }

    /// The C++ name of the object's class when the handle was received, e.g. "AStaticMeshActor"; empty for null. No
    /// round trip.
    std::string_view class_name() const;
    /// The path of that class, e.g. "/Script/Engine.StaticMeshActor"; empty for null. No round trip.
    std::string_view class_path() const;
    /// Whether that class is, or derives from, the class of that C++ name ("AActor"). No round trip; false for null.
    bool derives_from(std::string_view class_name) const;

    /// The same object of the same session. (The identity of an object across sessions is its path.)
    friend bool operator==(const ObjectHandle& a, const ObjectHandle& b) noexcept {
        return a.ref_.handle == b.ref_.handle && (a.is_null() || a.session_ == b.session_);
    }

private:
    std::shared_ptr<Session> session_;
    ObjectRef ref_;
};

namespace detail {
/// DecodeContext::user is, on the client, the Session whose values are read (or null).
std::shared_ptr<Session> session_of_context(void* user);
} // namespace detail

template <>
struct Codec<ObjectHandle> {
    static constexpr std::string_view name = Codec<ObjectRef>::name;
    static void encode(Encoder& out, const ObjectHandle& value) { Codec<ObjectRef>::encode(out, value.ref()); }
    static CodecError decode(Decoder& in, TypeId type, const DecodeContext& context, ObjectHandle& value) {
        ObjectRef ref;
        const CodecError error = Codec<ObjectRef>::decode(in, type, context, ref);
        value = ref.handle != 0 ? ObjectHandle(detail::session_of_context(context.user), ref) : ObjectHandle();
        return error;
    }
};

} // namespace spear
