// SPDX-License-Identifier: MIT
// Making struct values: FVector(1, 2, 3), FVector(X=1). What is unusual is left to spear/struct_base.py.

#include <unordered_map>
#include <vector>

#include "classes.hpp"
#include "native_types.hpp"
#include "session.hpp"

namespace spear::python {
namespace {

/// How values of a class are filled. All references are owned.
struct Layout {
    std::vector<PyObject*> names; ///< attributes, interned
    std::vector<PyObject*> defaults;
    std::vector<Py_ssize_t> offsets; ///< empty: not all attributes have slots, so Python's way is the only one
};

/// The tuple of that name in a class; nothing valid if there is none.
nb::object tuple_of(PyTypeObject* type, const char* name) {
    nb::object found = nb::steal(PyObject_GetAttrString(reinterpret_cast<PyObject*>(type), name));
    if (!found.is_valid() || !PyTuple_Check(found.ptr())) {
        PyErr_Clear();
        return nb::object();
    }
    return found;
}

const Layout& layout_of(PyTypeObject* type) {
    static std::unordered_map<PyTypeObject*, Layout> layouts;
    static PyTypeObject* last = nullptr;
    static const Layout* last_layout = nullptr;
    if (type == last) {
        return *last_layout;
    }
    auto at = layouts.find(type);
    if (at == layouts.end()) {
        Layout layout;
        const nb::object attributes = tuple_of(type, "_attributes");
        const nb::object defaults = tuple_of(type, "field_defaults");
        if (attributes.is_valid() && defaults.is_valid() && PyTuple_GET_SIZE(attributes.ptr()) != 0 &&
            PyTuple_GET_SIZE(defaults.ptr()) == PyTuple_GET_SIZE(attributes.ptr())) {
            for (Py_ssize_t i = 0; i < PyTuple_GET_SIZE(attributes.ptr()); ++i) {
                PyObject* name = Py_NewRef(PyTuple_GET_ITEM(attributes.ptr(), i));
                PyUnicode_InternInPlace(&name);
                layout.names.push_back(name);
                layout.defaults.push_back(Py_NewRef(PyTuple_GET_ITEM(defaults.ptr(), i)));
            }
            layout.offsets = slot_offsets(type, layout.names);
        }
        Py_INCREF(type); // the cache names it: it must not be another class later
        at = layouts.emplace(type, std::move(layout)).first;
    }
    last = type;
    last_layout = &at->second;
    return at->second;
}

int initialise_in_python(PyObject* self, PyObject* args, PyObject* kwargs) {
    static PyObject* const name = PyUnicode_InternFromString("_initialise");
    const nb::object method = nb::steal(PyObject_GetAttr(self, name));
    const nb::object done = nb::steal(method.is_valid() ? PyObject_Call(method.ptr(), args, kwargs) : nullptr);
    return done.is_valid() ? 0 : -1;
}

int struct_init(PyObject* self, PyObject* args, PyObject* kwargs) {
    return guarded(-1, [&] {
        const Layout& layout = layout_of(Py_TYPE(self));
        const auto count = static_cast<std::size_t>(PyTuple_GET_SIZE(args));
        const std::size_t size = layout.names.size();
        constexpr std::size_t most = 16;
        if (layout.offsets.empty() || count > size || size > most) {
            return initialise_in_python(self, args, kwargs);
        }
        nb::object values[most];
        Py_ssize_t named = 0;
        for (std::size_t i = 0; i < size; ++i) {
            if (i < count) {
                values[i] = nb::borrow(PyTuple_GET_ITEM(args, static_cast<Py_ssize_t>(i)));
                continue;
            }
            if (PyObject* const given = kwargs ? PyDict_GetItemWithError(kwargs, layout.names[i]) : nullptr) {
                values[i] = nb::borrow(given);
                ++named;
                continue;
            }
            PyObject* const standard = layout.defaults[i];
            values[i] = PyCallable_Check(standard) ? nb::steal(PyObject_CallNoArgs(standard)) : nb::borrow(standard);
            if (!values[i].is_valid()) {
                throw nb::python_error();
            }
        }
        if (kwargs && PyDict_Size(kwargs) != named) { // a name given twice, Unreal's spelling, or no field
            return initialise_in_python(self, args, kwargs);
        }
        for (std::size_t i = 0; i < size; ++i) {
            auto& slot = *reinterpret_cast<PyObject**>(reinterpret_cast<char*>(self) + layout.offsets[i]);
            PyObject* const before = slot;
            slot = values[i].release().ptr();
            Py_XDECREF(before);
        }
        return 0;
    });
}

} // namespace

void make_struct_type(nb::module_& module) {
    PyType_Slot slots[] = {
        {Py_tp_doc, const_cast<char*>("Base of struct values: fills their fields.")},
        {Py_tp_init, reinterpret_cast<void*>(&struct_init)},
        {0, nullptr},
    };
    PyType_Spec spec{"spear._native.StructBase", sizeof(PyObject), 0, Py_TPFLAGS_DEFAULT | Py_TPFLAGS_BASETYPE, slots};
    PyObject* const type = PyType_FromSpec(&spec);
    if (!type) {
        throw nb::python_error();
    }
    module.attr("StructBase") = nb::steal(type);
}

} // namespace spear::python
