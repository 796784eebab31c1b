// SPDX-License-Identifier: MIT
#pragma once

// The Python classes that the package hands to this extension (spear/_setup.py). They live as long as the interpreter.

#include <nanobind/nanobind.h>

namespace spear::python {
namespace nb = nanobind;

struct Classes {
    PyObject* object = nullptr;        ///< spear.UnrealObject
    PyObject* struct_base = nullptr;   ///< spear.structs.Struct
    PyObject* struct_class = nullptr;  ///< spear.structs.struct_class(name, field_names)
    PyObject* enum_class = nullptr;    ///< spear._setup._enum_class(name, entries)
    PyObject* errors = nullptr;        ///< {name: class}
    PyObject* future_object = nullptr; ///< spear.unreal_object.future_object(future)
};

inline Classes classes;

/// Attribute names, interned once.
struct Names {
    PyObject* struct_name = PyUnicode_InternFromString("struct_name");
    PyObject* field_names = PyUnicode_InternFromString("field_names");
    PyObject* field_types = PyUnicode_InternFromString("field_types");
    PyObject* unreal_name = PyUnicode_InternFromString("unreal_name");
    PyObject* future = PyUnicode_InternFromString("_future");
    PyObject* value_to_member = PyUnicode_InternFromString("_value2member_map_");
};
inline const Names& names() {
    static const Names instance;
    return instance;
}

} // namespace spear::python
