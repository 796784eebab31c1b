// SPDX-License-Identifier: MIT
// Names of functions and paths of variables, each kept once.

#include <string>

#include "classes.hpp"
#include "native_types.hpp"

namespace spear::python {
namespace {

// The caches, guarded by Python's lock. They hold what programs write; programs that make up names without end fill
// them, and then they start anew.
constexpr Py_ssize_t most_paths = 1 << 14;
constexpr Py_ssize_t most_children = 1 << 10;
PyObject* by_text = nullptr;      // {text: NativePath}
PyObject* by_attribute = nullptr; // {attribute of an object: NativePath}, without those that spear.naming renames

NativePath* checked_path(PyObject* made) {
    if (!made) {
        throw nb::python_error();
    }
    return as<NativePath>(made);
}

void path_dealloc(PyObject* self) {
    auto* const path = as<NativePath>(self);
    PyTypeObject* const type = Py_TYPE(self);
    Py_XDECREF(path->text);
    Py_XDECREF(path->children);
    Py_XDECREF(reinterpret_cast<PyObject*>(path->owner));
    Py_XDECREF(reinterpret_cast<PyObject*>(path->last));
    for (const NativePath::Shape& shape : path->shapes) {
        Py_XDECREF(shape.keywords);
    }
    type->tp_free(self);
    Py_DECREF(type);
}

void keep(PyObject*& dictionary, Py_ssize_t most, PyObject* key, PyObject* path) {
    if (!dictionary) {
        dictionary = PyDict_New();
        if (!dictionary) {
            throw nb::python_error();
        }
    }
    if (PyDict_Size(dictionary) >= most) {
        PyDict_Clear(dictionary);
    }
    if (PyDict_SetItem(dictionary, key, path) != 0) {
        throw nb::python_error();
    }
}

/// The first time that an attribute is asked for.
NativePath* find_attribute(NativePath* parent, PyObject* self, PyObject* target, PyObject* name) {
    nb::object text = nb::borrow(name);
    const int is_renamed = PyDict_Contains(classes.renamed, name);
    if (is_renamed < 0) {
        throw nb::python_error();
    }
    if (is_renamed) {
        text = nb::handle(classes.unreal_name_of)(target ? nb::handle(target) : nb::none(), nb::handle(name));
    } else if (PyUnicode_GetLength(name) >= 2 && PyUnicode_READ_CHAR(name, 0) == '_' &&
               PyUnicode_READ_CHAR(name, 1) == '_') {
        PyErr_Format(PyExc_AttributeError, "'%s' object has no attribute %R", Py_TYPE(self)->tp_name, name);
        throw nb::python_error();
    }
    if (parent) {
        text = nb::steal(PyUnicode_FromFormat("%U.%S", parent->text, text.ptr()));
        if (!text.is_valid()) {
            throw nb::python_error();
        }
    }
    NativePath* const path = path_of_text(text.ptr());
    if (!is_renamed) { // what renamed ones stand for depends on the class
        const nb::object owned = nb::borrow(reinterpret_cast<PyObject*>(path));
        if (parent)
            keep(parent->children, most_children, name, owned.ptr());
        else
            keep(by_attribute, most_paths, name, owned.ptr());
    }
    return path;
}

} // namespace

NativePath* attribute_path(NativePath* parent, PyObject* self, PyObject* target, PyObject* name) {
    if (PyObject* const known = parent ? parent->children : by_attribute) {
        if (PyObject* const path = PyDict_GetItemWithError(known, name)) {
            return as<NativePath>(Py_NewRef(path));
        }
        if (PyErr_Occurred()) {
            throw nb::python_error();
        }
    }
    return find_attribute(parent, self, target, name);
}

NativePath* path_of_text(PyObject* text) {
    if (!PyUnicode_Check(text)) {
        throw_error(ErrorCode::WrongType,
            std::string("The name of a function, or the path of a variable, is a str, not a ") +
                Py_TYPE(text)->tp_name + ".");
    }
    if (by_text) {
        if (PyObject* const path = PyDict_GetItemWithError(by_text, text)) {
            return as<NativePath>(Py_NewRef(path));
        }
        if (PyErr_Occurred()) {
            throw nb::python_error();
        }
    }
    NativePath* const path = checked_path(native.path->tp_alloc(native.path, 0)); // zeros but for the head
    const nb::object owned = nb::steal(reinterpret_cast<PyObject*>(path));
    path->text = Py_NewRef(text);
    path->is_plain = true;
    const Py_ssize_t length = PyUnicode_GetLength(text);
    for (Py_ssize_t i = 0; i < length; ++i) {
        const Py_UCS4 character = PyUnicode_READ_CHAR(text, i);
        path->is_plain &= character != '.' && character != '[';
    }
    if (by_text && PyDict_Size(by_text) >= most_paths && by_attribute) {
        PyDict_Clear(by_attribute);
    }
    keep(by_text, most_paths, text, owned.ptr());
    return checked_path(Py_NewRef(owned.ptr()));
}

void forget_names() {
    // Children are names of members too: paths that hold such start anew as well.
    for (PyObject* const cache : {by_attribute, by_text}) {
        if (cache) {
            PyDict_Clear(cache);
        }
    }
}

void make_path_type() {
    PyType_Slot slots[] = {{Py_tp_dealloc, reinterpret_cast<void*>(&path_dealloc)}, {0, nullptr}};
    PyType_Spec spec{"spear._native._Path", sizeof(NativePath), 0,
        Py_TPFLAGS_DEFAULT | Py_TPFLAGS_DISALLOW_INSTANTIATION, slots};
    native.path = reinterpret_cast<PyTypeObject*>(PyType_FromSpec(&spec));
    if (!native.path) {
        throw nb::python_error();
    }
}

} // namespace spear::python
