// SPDX-License-Identifier: MIT
#pragma once

// The Python classes that the package hands to this extension (spear/_setup.py). They live as long as the interpreter.

#include <cstdint>

#include <nanobind/nanobind.h>

namespace spear::python {
namespace nb = nanobind;

struct Classes {
    PyObject* object = nullptr;       ///< spear.UnrealObject
    PyObject* struct_base = nullptr;  ///< spear.structs.Struct
    PyObject* struct_class = nullptr; ///< spear.structs.announced(name, path, field_names) -> (class, attributes)
    PyObject* enum_class =
        nullptr; ///< spear.enums.announced(name, path, flags, entries) -> (class, {number: member}, ...)
    PyObject* enum_entries = nullptr; ///< spear.enums.wire_entries(class) -> (name, flags, entries) or None
    PyObject* result_class = nullptr; ///< spear.results.result_class(name, fields) -> class
    PyObject* null_result =
        nullptr; ///< spear.nulls.null_result(...): raises where a null object is none of the results
    PyObject* parameter_name = nullptr; ///< spear.naming.parameter_name(keyword) -> Unreal's name
    PyObject* errors = nullptr;         ///< {name: class}
    PyObject* future_object = nullptr;  ///< spear.FutureObject
    PyObject* member = nullptr;         ///< spear.Member
    PyObject* async_namespace = nullptr; ///< spear.unreal_object.AsyncNamespace
    PyObject* send_namespace = nullptr;  ///< spear.unreal_object.SendNamespace
    PyObject* renamed = nullptr;         ///< spear.naming.renamed: {attribute: what it is in Unreal, or where to look}
    PyObject* unreal_name_of = nullptr;  ///< spear.naming.unreal_name_of(target, attribute) for those
    PyObject* check_assignment = nullptr; ///< spear.unreal_object.check_assignment(name): raises for names of ObjectBase

    /// Counts the announcements of enums by engines: a class may have got more entries, so that it is announced anew.
    std::uint32_t enums_seen = 0;
};

inline Classes classes;

/// Attribute names, interned once.
struct Names {
    PyObject* struct_name = PyUnicode_InternFromString("struct_name");
    PyObject* field_names = PyUnicode_InternFromString("field_names");
    PyObject* attributes = PyUnicode_InternFromString("_attributes");
    PyObject* field_types = PyUnicode_InternFromString("field_types");
    PyObject* unreal_name = PyUnicode_InternFromString("unreal_name");
};
inline const Names& names() {
    static const Names instance;
    return instance;
}

} // namespace spear::python
