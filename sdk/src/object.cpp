// SPDX-License-Identifier: MIT
#include "spear/object.hpp"

#include <fmt/format.h>

namespace spear {

// ObjectHandle

namespace {

const TypeInfo* class_info(const std::shared_ptr<Session>& session, TypeId type) {
    return session ? session->types().find(type) : nullptr;
}

} // namespace

std::string_view ObjectHandle::class_name() const {
    const TypeInfo* info = class_info(session_, ref_.class_type);
    return info ? std::string_view(info->name) : std::string_view();
}

std::string_view ObjectHandle::class_path() const {
    const TypeInfo* info = class_info(session_, ref_.class_type);
    return info ? std::string_view(info->path) : std::string_view();
}

bool ObjectHandle::derives_from(std::string_view wanted) const {
    std::size_t steps = 0;
    for (const TypeInfo* info = class_info(session_, ref_.class_type); info && steps < 1024;
        info = class_info(session_, info->element), ++steps) {
        if (info->name == wanted)
            return true;
    }
    return false;
}

// Property

Property Property::extended(std::string_view before, std::string_view text, std::string_view after) const {
    Property result = *this;
    result.path_.append(before).append(text).append(after);
    return result;
}

Property Property::key(std::string_view key) const {
    std::string quoted;
    for (const char c : key) {
        if (c == '"' || c == '\\')
            quoted += '\\';
        quoted += c;
    }
    return extended("[\"", quoted, "\"]");
}

const std::shared_ptr<Session>& Property::require_session() const {
    return owner_future_.valid() ? detail::require_session(owner_future_, path_)
                                 : detail::require_session(owner_, path_);
}

void Property::put_owner(OperationBuilder& operation) const {
    if (owner_future_.valid()) {
        operation.put_future(owner_future_);
    } else {
        encode_handle(operation.out(), owner_.ref());
    }
    operation.put_shape(operation.session().path_shape(path_));
}

// Object

namespace detail {

const std::shared_ptr<Session>& require_session(const ObjectHandle& object, std::string_view what) {
    if (object.is_null() || !object.session()) {
        throw_error(ErrorCode::NullObject, fmt::format("{} was asked of a null object.", what), std::string(what));
    }
    return object.session();
}

const std::shared_ptr<Session>& require_session(const OperationHandle& operation, std::string_view what) {
    if (!operation.valid()) {
        throw_error(ErrorCode::ArgumentError,
            fmt::format("{} was asked of a future that belongs to no operation.", what), std::string(what));
    }
    return operation.session();
}

} // namespace detail

std::string Object::path_name() const {
    return session_for("get_path_name")->call(unreal_service::get_path_name, *this);
}

bool Object::is_valid() const { return !is_null() && session_for("is_valid")->call(unreal_service::is_valid, *this); }

Class Object::get_class() const {
    return session_for("get_class")->perform_as<CallMode::sync, Class>(unreal_service::get_class, *this);
}

bool Object::is_a(std::string_view class_name) const {
    return session_for("is_a")->call(unreal_service::is_a, *this, class_name);
}

void Object::throw_bad_cast(std::string_view wanted) const {
    throw_error(ErrorCode::WrongType,
        fmt::format("The object is of class {}, which is not {} and does not derive from it.", class_name(), wanted),
        "cast", {}, std::string(wanted));
}

// Class

Object Class::default_object() const {
    return detail::require_session(*this, "default_object")->call(unreal_service::get_default_object, *this);
}

Class Class::super_class() const {
    return detail::require_session(*this, "super_class")
        ->perform_as<CallMode::sync, Class>(unreal_service::get_super_class, *this);
}

std::vector<Class> Class::derived_classes(bool recursive) const {
    return detail::require_session(*this, "derived_classes")
        ->perform_as<CallMode::sync, std::vector<Class>>(unreal_service::get_derived_classes, *this, recursive);
}

} // namespace spear
