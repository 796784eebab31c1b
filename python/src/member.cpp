// SPDX-License-Identifier: MIT
// Members: what actor.SetActorScale3D and actor.RootComponent.RelativeLocation are.

#include <array>

#include <nanobind/nanobind.h>

#include <structmember.h>

#include "classes.hpp"
#include "native_types.hpp"
#include "session.hpp"

namespace spear::python {
namespace {

nb::object owned(NativePath* path) { return nb::steal(reinterpret_cast<PyObject*>(path)); }

/// "Owner.Function": what the path without its last name is, and that name.
void split(NativePath& path) {
    if (path.last) {
        return;
    }
    const Py_ssize_t length = PyUnicode_GetLength(path.text);
    const Py_ssize_t dot = PyUnicode_FindChar(path.text, '.', 0, length, -1);
    if (dot <= 0) {
        PyErr_Format(PyExc_TypeError, "%R is an element of a variable, not a function", path.text);
        throw nb::python_error();
    }
    const nb::object owner = nb::steal(PyUnicode_Substring(path.text, 0, dot));
    const nb::object last = nb::steal(PyUnicode_Substring(path.text, dot + 1, length));
    if (!owner.is_valid() || !last.is_valid()) {
        throw nb::python_error();
    }
    path.owner = path_of_text(owner.ptr());
    path.last = path_of_text(last.ptr());
}

PyObject* member_call(PyObject* self, PyObject* const* args, std::size_t flagged, PyObject* keywords) {
    return guarded<PyObject*>(nullptr, [&] {
        const auto* const member = as<NativeMember>(self);
        const Arguments arguments{args, PyVectorcall_NARGS(flagged), keywords};
        PyObject* const session = session_of_target(member->target);
        if (member->path->is_plain) {
            return PySession::call_function(session, member->target, member->path, arguments, member->mode)
                .release()
                .ptr();
        }
        // A function of the object that the path leads to: the server passes it on, so this is still one round trip.
        split(*member->path);
        const nb::object owner =
            PySession::get_property(session, member->target, member->path->owner, async_mode | raw_mode);
        return PySession::call_function(session, owner, member->path->last, arguments, member->mode).release().ptr();
    });
}

void member_dealloc(PyObject* self) {
    auto* const member = as<NativeMember>(self);
    PyTypeObject* const type = Py_TYPE(self);
    Py_XDECREF(member->target);
    Py_XDECREF(reinterpret_cast<PyObject*>(member->path));
    type->tp_free(self);
    Py_DECREF(type);
}

PyObject* member_new(PyTypeObject*, PyObject* args, PyObject* kwargs) {
    PyObject *target = nullptr, *text = nullptr;
    int mode = 0;
    if ((kwargs && PyDict_Size(kwargs) != 0) || !PyArg_ParseTuple(args, "OUi", &target, &text, &mode)) {
        return nullptr;
    }
    return guarded<PyObject*>(nullptr, [&] {
        if (!session_of_target(target)) {
            PyErr_Format(PyExc_TypeError, "an object of the engine is needed, not a %s", Py_TYPE(target)->tp_name);
            throw nb::python_error();
        }
        const nb::object path = owned(path_of_text(text));
        return make_member(target, as<NativePath>(path.ptr()), mode);
    });
}

PyObject* member_getattro(PyObject* self, PyObject* name) {
    if (_PyType_Lookup(Py_TYPE(self), name)) {
        return PyObject_GenericGetAttr(self, name);
    }
    return guarded<PyObject*>(nullptr, [&] {
        const auto* const member = as<NativeMember>(self);
        const nb::object path = owned(attribute_path(member->path, self, nullptr, name));
        return make_member(member->target, as<NativePath>(path.ptr()), member->mode);
    });
}

int member_setattro(PyObject* self, PyObject* name, PyObject* value) {
    return guarded(-1, [&] {
        if (!value) {
            PyErr_Format(PyExc_AttributeError, "%R is a variable of the engine, which cannot be deleted", name);
            throw nb::python_error();
        }
        const auto* const member = as<NativeMember>(self);
        const nb::object path = owned(attribute_path(member->path, self, nullptr, name));
        PySession::set_property(
            session_of_target(member->target), member->target, as<NativePath>(path.ptr()), value, member->mode);
        return 0;
    });
}

/// The path itself, or, for a text, the one that begins there.
nb::object path_from(const NativeMember& member, PyObject* more) {
    if (!more || (PyUnicode_Check(more) && PyUnicode_GetLength(more) == 0)) {
        return nb::borrow(reinterpret_cast<PyObject*>(member.path));
    }
    const nb::object text = nb::steal(PyUnicode_FromFormat("%U.%S", member.path->text, more));
    if (!text.is_valid()) {
        throw nb::python_error();
    }
    return owned(path_of_text(text.ptr()));
}

PyObject* read(const NativeMember& member, NativePath* path, int mode) {
    return PySession::get_property(session_of_target(member.target), member.target, path, mode).release().ptr();
}

PyObject* member_get(PyObject* self, PyObject* const* args, Py_ssize_t count) {
    if (count > 1) {
        PyErr_Format(PyExc_TypeError, "get() takes at most a path, %zd arguments were given", count);
        return nullptr;
    }
    return guarded<PyObject*>(nullptr, [&] {
        const auto& member = *as<NativeMember>(self);
        const nb::object path = path_from(member, count == 1 ? args[0] : nullptr);
        const bool is_own = path.ptr() == reinterpret_cast<PyObject*>(member.path);
        return read(member, as<NativePath>(path.ptr()), is_own ? member.mode : member.mode | raw_mode);
    });
}

PyObject* member_get_or_none(PyObject* self, PyObject*) {
    return guarded<PyObject*>(nullptr, [&] {
        const auto& member = *as<NativeMember>(self);
        return read(member, member.path, member.mode | raw_mode);
    });
}

PyObject* member_set(PyObject* self, PyObject* const* args, Py_ssize_t count) {
    if (count != 1 && count != 2) {
        PyErr_Format(PyExc_TypeError, "set() takes a value, or a path and a value; %zd arguments were given", count);
        return nullptr;
    }
    return guarded<PyObject*>(nullptr, [&] {
        const auto& member = *as<NativeMember>(self);
        const nb::object path = path_from(member, count == 2 ? args[0] : nullptr);
        return PySession::set_property(session_of_target(member.target), member.target, as<NativePath>(path.ptr()),
            args[count - 1], member.mode)
            .release()
            .ptr();
    });
}

PyObject* member_async(PyObject* self, void*) {
    return guarded<PyObject*>(
        nullptr, [&] { return make_member(as<NativeMember>(self)->target, as<NativeMember>(self)->path, async_mode); });
}
PyObject* member_send(PyObject* self, void*) {
    return guarded<PyObject*>(
        nullptr, [&] { return make_member(as<NativeMember>(self)->target, as<NativeMember>(self)->path, send_mode); });
}
PyObject* member_path(PyObject* self, void*) { return Py_NewRef(as<NativeMember>(self)->path->text); }

} // namespace

PyObject* make_member(PyObject* target, NativePath* path, int mode) {
    auto* const type = reinterpret_cast<PyTypeObject*>(classes.member);
    PyObject* const made = type->tp_alloc(type, 0);
    if (!made) {
        throw nb::python_error();
    }
    auto* const member = as<NativeMember>(made);
    member->call = &member_call;
    member->target = Py_NewRef(target);
    member->path = as<NativePath>(Py_NewRef(reinterpret_cast<PyObject*>(path)));
    member->mode = mode;
    return made;
}

void make_member_type(nb::module_& module) {
    static PyMemberDef members[] = {
        {"__vectorcalloffset__", T_PYSSIZET, offsetof(NativeMember, call), READONLY, nullptr},
        {"_target", T_OBJECT, offsetof(NativeMember, target), READONLY, nullptr},
        {"_mode", T_INT, offsetof(NativeMember, mode), READONLY, nullptr},
        {nullptr, 0, 0, 0, nullptr},
    };
    static PyGetSetDef attributes[] = {
        {"_path", &member_path, nullptr, nullptr, nullptr},
        {"async_", &member_async, nullptr,
            "The same place, asynchronously: ``actor.RootComponent.async_.K2_GetComponentLocation()``.", nullptr},
        {"send_", &member_send, nullptr, "The same place, fire-and-forget.", nullptr},
        {nullptr, nullptr, nullptr, nullptr, nullptr},
    };
    static PyMethodDef methods[] = {
        {"get", reinterpret_cast<PyCFunction>(reinterpret_cast<void*>(&member_get)), METH_FASTCALL,
            "The variable's value; a Future under ``async_``. NullObject if it is an object, and null.\n\nWith a path: "
            "what is there, seen from the object that the variable holds (as ``object.get(path)``)."},
        {"get_or_none", &member_get_or_none, METH_NOARGS,
            "The variable's value, None for an object that is null; a Future under ``async_``."},
        {"set", reinterpret_cast<PyCFunction>(reinterpret_cast<void*>(&member_set)), METH_FASTCALL,
            "Writes the variable, through Unreal's own setter where it has one. With a path before the value: what is "
            "there (see get)."},
        {nullptr, nullptr, 0, nullptr},
    };
    PyType_Slot slots[] = {
        {Py_tp_doc, const_cast<char*>("A function or variable of an object, by name.")},
        {Py_tp_new, reinterpret_cast<void*>(&member_new)},
        {Py_tp_dealloc, reinterpret_cast<void*>(&member_dealloc)},
        {Py_tp_call, reinterpret_cast<void*>(&PyVectorcall_Call)},
        {Py_tp_getattro, reinterpret_cast<void*>(&member_getattro)},
        {Py_tp_setattro, reinterpret_cast<void*>(&member_setattro)},
        {Py_tp_members, members},
        {Py_tp_getset, attributes},
        {Py_tp_methods, methods},
        {0, nullptr},
    };
    PyType_Spec spec{"spear._native.MemberBase", sizeof(NativeMember), 0,
        Py_TPFLAGS_DEFAULT | Py_TPFLAGS_BASETYPE | Py_TPFLAGS_HAVE_VECTORCALL, slots};
    native.member = reinterpret_cast<PyTypeObject*>(PyType_FromSpec(&spec));
    if (!native.member) {
        throw nb::python_error();
    }
    module.attr("MemberBase") = nb::handle(reinterpret_cast<PyObject*>(native.member));
}

} // namespace spear::python
