// SPDX-License-Identifier: MIT
// Objects, objects to come, and their namespaces async_ and send_. Attributes that Python does not know are members.

#include <functional>
#include <string>

#include <nanobind/nanobind.h>

#include <structmember.h>

#include "classes.hpp"
#include "native_types.hpp"
#include "session.hpp"

namespace spear::python {
namespace {

nb::object owned(NativePath* path) { return nb::steal(reinterpret_cast<PyObject*>(path)); }

/// An attribute: what the type has, else a member of `target`. `named_by` helps to find Unreal's name (attribute_path).
PyObject* attribute(PyObject* self, PyObject* target, PyObject* named_by, PyObject* name, int mode) {
    if (_PyType_Lookup(Py_TYPE(self), name)) {
        return PyObject_GenericGetAttr(self, name);
    }
    return guarded<PyObject*>(nullptr, [&] {
        const nb::object path = owned(attribute_path(nullptr, self, named_by, name));
        return make_member(target, as<NativePath>(path.ptr()), mode);
    });
}

/// Assignment to an attribute: writes the variable.
int assign(PyObject* self, PyObject* target, PyObject* named_by, PyObject* name, PyObject* value, int mode) {
    return guarded(-1, [&] {
        if (!value) {
            PyErr_Format(PyExc_AttributeError, "%R is a variable of the engine, which cannot be deleted", name);
            throw nb::python_error();
        }
        if (is_object(self)) {
            nb::handle(classes.check_assignment)(nb::handle(name));
        }
        const nb::object path = owned(attribute_path(nullptr, self, named_by, name));
        PySession::set_property(session_of_target(target), target, as<NativePath>(path.ptr()), value, mode);
        return 0;
    });
}

// Objects

void object_dealloc(PyObject* self) {
    auto* const object = as<NativeObject>(self);
    PyTypeObject* const type = Py_TYPE(self);
    Py_XDECREF(object->session);
    type->tp_free(self);
    Py_DECREF(type);
}

PyObject* object_getattro(PyObject* self, PyObject* name) { return attribute(self, self, self, name, sync_mode); }
int object_setattro(PyObject* self, PyObject* name, PyObject* value) {
    return assign(self, self, self, name, value, sync_mode);
}

PyObject* object_compare(PyObject* left, PyObject* right, int operation) {
    if ((operation != Py_EQ && operation != Py_NE) || !is_object(left) || !is_object(right)) {
        Py_RETURN_NOTIMPLEMENTED;
    }
    const bool same = as<NativeObject>(left)->ref.handle == as<NativeObject>(right)->ref.handle &&
                      as<NativeObject>(left)->session == as<NativeObject>(right)->session;
    return PyBool_FromLong(same == (operation == Py_EQ));
}

Py_hash_t object_hash(PyObject* self) {
    const auto hash = static_cast<Py_hash_t>(std::hash<std::uint64_t>()(as<NativeObject>(self)->ref.handle));
    return hash == -1 ? -2 : hash;
}

PyObject* object_handle(PyObject* self, void*) {
    return PyLong_FromUnsignedLongLong(as<NativeObject>(self)->ref.handle);
}

PyObject* object_class_name(PyObject* self, void*) {
    return guarded<PyObject*>(nullptr, [&] {
        const auto* const object = as<NativeObject>(self);
        const TypeInfo* info = session_of(object->session).session()->types().find(object->ref.class_type);
        const std::string_view name = info ? std::string_view(info->name) : "UObject";
        return PyUnicode_FromStringAndSize(name.data(), static_cast<Py_ssize_t>(name.size()));
    });
}

PyObject* object_class_names(PyObject* self, void*) {
    return guarded<PyObject*>(nullptr, [&] {
        const auto* const object = as<NativeObject>(self);
        return session_of(object->session).class_names(object->ref.class_type).release().ptr();
    });
}

PyObject* target_session(PyObject* self, void*) { return Py_NewRef(session_of_target(self)); }

PyObject* async_of(PyObject* self, void*) {
    return guarded<PyObject*>(nullptr,
        [&] { return make_namespace(reinterpret_cast<PyTypeObject*>(classes.async_namespace), self, async_mode); });
}
PyObject* send_of(PyObject* self, void*) {
    return guarded<PyObject*>(nullptr,
        [&] { return make_namespace(reinterpret_cast<PyTypeObject*>(classes.send_namespace), self, send_mode); });
}

// Objects to come

void future_object_dealloc(PyObject* self) {
    PyTypeObject* const type = Py_TYPE(self);
    Py_XDECREF(as<NativeFutureObject>(self)->future);
    type->tp_free(self);
    Py_DECREF(type);
}

PyObject* future_object_new(PyTypeObject* type, PyObject* args, PyObject* kwargs) {
    PyObject* future = nullptr;
    if ((kwargs && PyDict_Size(kwargs) != 0) || !PyArg_ParseTuple(args, "O!", native.future, &future)) {
        return nullptr;
    }
    PyObject* const made = type->tp_alloc(type, 0);
    if (made) {
        as<NativeFutureObject>(made)->future = Py_NewRef(future);
    }
    return made;
}

PyObject* future_object_getattro(PyObject* self, PyObject* name) {
    return attribute(self, self, nullptr, name, sync_mode);
}
int future_object_setattro(PyObject* self, PyObject* name, PyObject* value) {
    return assign(self, self, nullptr, name, value, sync_mode);
}

// Namespaces

void namespace_dealloc(PyObject* self) {
    PyTypeObject* const type = Py_TYPE(self);
    Py_XDECREF(as<NativeNamespace>(self)->target);
    type->tp_free(self);
    Py_DECREF(type);
}

PyObject* namespace_new(PyTypeObject* type, PyObject* args, PyObject* kwargs) {
    PyObject* target = nullptr;
    int mode = 0;
    if ((kwargs && PyDict_Size(kwargs) != 0) || !PyArg_ParseTuple(args, "Oi", &target, &mode)) {
        return nullptr;
    }
    return guarded<PyObject*>(nullptr, [&] { return make_namespace(type, target, mode); });
}

PyObject* namespace_getattro(PyObject* self, PyObject* name) {
    const auto* const space = as<NativeNamespace>(self);
    return attribute(self, space->target, space->target, name, space->mode);
}
int namespace_setattro(PyObject* self, PyObject* name, PyObject* value) {
    const auto* const space = as<NativeNamespace>(self);
    return assign(self, space->target, space->target, name, value, space->mode);
}

PyTypeObject* make_type(
    nb::module_& module, const char* full_name, const char* name, std::size_t size, PyType_Slot* slots, bool is_made) {
    unsigned flags = Py_TPFLAGS_DEFAULT | Py_TPFLAGS_BASETYPE;
    if (!is_made) {
        flags |= Py_TPFLAGS_DISALLOW_INSTANTIATION;
    }
    PyType_Spec spec{full_name, static_cast<int>(size), 0, flags, slots};
    PyObject* const type = PyType_FromSpec(&spec);
    if (!type) {
        throw nb::python_error();
    }
    module.attr(name) = nb::handle(type);
    return reinterpret_cast<PyTypeObject*>(type); // for ever
}

} // namespace

PyObject* make_object(PyObject* session, ObjectRef ref) {
    auto* const type = reinterpret_cast<PyTypeObject*>(classes.object);
    PyObject* const made = type->tp_alloc(type, 0);
    if (!made) {
        throw nb::python_error();
    }
    as<NativeObject>(made)->session = Py_NewRef(session);
    as<NativeObject>(made)->ref = ref;
    return made;
}

PyObject* make_namespace(PyTypeObject* type, PyObject* target, int mode) {
    if (!session_of_target(target)) {
        PyErr_Format(PyExc_TypeError, "an object of the engine is needed, not a %s", Py_TYPE(target)->tp_name);
        throw nb::python_error();
    }
    PyObject* const made = type->tp_alloc(type, 0);
    if (!made) {
        throw nb::python_error();
    }
    as<NativeNamespace>(made)->target = Py_NewRef(target);
    as<NativeNamespace>(made)->mode = mode;
    return made;
}

PyObject* session_of_target(PyObject* target) {
    if (is_object(target)) {
        return as<NativeObject>(target)->session;
    }
    if (is_future_object(target)) {
        target = as<NativeFutureObject>(target)->future;
    }
    return is_future(target) ? as<NativeFuture>(target)->session : nullptr;
}

void make_object_types(nb::module_& module) {
    static PyGetSetDef object_attributes[] = {
        {"async_", &async_of, nullptr,
            "The same functions and variables, asynchronously: each gives a Future at once, and runs in the same order.",
            nullptr},
        {"send_", &send_of, nullptr,
            "Fire-and-forget: nothing is returned; failures are reported when a block ends.", nullptr},
        {"_session", &target_session, nullptr, nullptr, nullptr},
        {"_handle", &object_handle, nullptr, nullptr, nullptr},
        {"_class_name", &object_class_name, nullptr, nullptr, nullptr},
        {"_class_names", &object_class_names, nullptr,
            "The class and those it derives from, most derived first.", nullptr},
        {nullptr, nullptr, nullptr, nullptr, nullptr},
    };
    PyType_Slot object_slots[] = {
        {Py_tp_doc, const_cast<char*>("An object of the engine: the session, a weak handle, the class as it was when "
                                      "the engine sent it.")},
        {Py_tp_dealloc, reinterpret_cast<void*>(&object_dealloc)},
        {Py_tp_getattro, reinterpret_cast<void*>(&object_getattro)},
        {Py_tp_setattro, reinterpret_cast<void*>(&object_setattro)},
        {Py_tp_richcompare, reinterpret_cast<void*>(&object_compare)},
        {Py_tp_hash, reinterpret_cast<void*>(&object_hash)},
        {Py_tp_getset, object_attributes},
        {0, nullptr},
    };
    native.object = make_type(module, "spear._native.Object", "Object", sizeof(NativeObject), object_slots, false);

    static PyGetSetDef future_object_attributes[] = {
        {"async_", &async_of, nullptr, "Asynchronous calls on the object to come.", nullptr},
        {"send_", &send_of, nullptr, "Fire-and-forget calls on the object to come.", nullptr},
        {"_session", &target_session, nullptr, nullptr, nullptr},
        {nullptr, nullptr, nullptr, nullptr, nullptr},
    };
    static PyMemberDef future_object_members[] = {
        {"_future", T_OBJECT, offsetof(NativeFutureObject, future), READONLY, nullptr},
        {nullptr, 0, 0, 0, nullptr},
    };
    PyType_Slot future_object_slots[] = {
        {Py_tp_doc, const_cast<char*>("The object that a future will be.")},
        {Py_tp_new, reinterpret_cast<void*>(&future_object_new)},
        {Py_tp_dealloc, reinterpret_cast<void*>(&future_object_dealloc)},
        {Py_tp_getattro, reinterpret_cast<void*>(&future_object_getattro)},
        {Py_tp_setattro, reinterpret_cast<void*>(&future_object_setattro)},
        {Py_tp_getset, future_object_attributes},
        {Py_tp_members, future_object_members},
        {0, nullptr},
    };
    native.future_object = make_type(module, "spear._native.FutureObjectBase", "FutureObjectBase",
        sizeof(NativeFutureObject), future_object_slots, true);

    static PyMemberDef namespace_members[] = {
        {"_target", T_OBJECT, offsetof(NativeNamespace, target), READONLY, nullptr},
        {"_mode", T_INT, offsetof(NativeNamespace, mode), READONLY, nullptr},
        {nullptr, 0, 0, 0, nullptr},
    };
    PyType_Slot namespace_slots[] = {
        {Py_tp_doc, const_cast<char*>("An object's functions and variables in another mode.")},
        {Py_tp_new, reinterpret_cast<void*>(&namespace_new)},
        {Py_tp_dealloc, reinterpret_cast<void*>(&namespace_dealloc)},
        {Py_tp_getattro, reinterpret_cast<void*>(&namespace_getattro)},
        {Py_tp_setattro, reinterpret_cast<void*>(&namespace_setattro)},
        {Py_tp_members, namespace_members},
        {0, nullptr},
    };
    native.name_space =
        make_type(module, "spear._native.Namespace", "Namespace", sizeof(NativeNamespace), namespace_slots, true);
}

} // namespace spear::python
