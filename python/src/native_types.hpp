// SPDX-License-Identifier: MIT
#pragma once

// The Python types that every call passes through, as plain types of CPython: objects, what an attribute of an object
// is (a member: callable, or got and set), the namespaces async_ and send_, futures, objects to come. The classes of
// spear/unreal_object.py derive from them and add what is called rarely. No value here refers to itself, so none takes
// part in garbage collection. Everything is guarded by Python's lock.

#include <cstdint>

#include <nanobind/nanobind.h>

#include "spear/spear.hpp"

namespace spear::python {
namespace nb = nanobind;

/// How an operation is performed. With `raw_mode` added, a null object is always None: nobody is asked whether that may
/// be.
enum Mode : int { sync_mode = 0, async_mode = 1, send_mode = 2, raw_mode = 4 };

/// An object of the engine (base of spear.ObjectBase).
struct NativeObject {
    PyObject_HEAD;
    PyObject* session; ///< a Session (owned)
    ObjectRef ref;
};

/// The result of an asynchronous operation, and what it was about (for results that are null).
struct NativeFuture {
    PyObject_HEAD;
    PyObject* session; ///< a Session (owned)
    OperationHandle operation;
    PyObject* target; ///< the object or the future that was asked (owned), or null: nothing is asked about nulls
    PyObject* name;   ///< the function, or the path of the variable (owned), or null
    bool has_result;
    bool is_function;
};

/// The object that a future will be, as a target (base of spear.FutureObject).
struct NativeFutureObject {
    PyObject_HEAD;
    PyObject* future; ///< a Future (owned)
};

/// object.async_ or object.send_.
struct NativeNamespace {
    PyObject_HEAD;
    PyObject* target; ///< an Object or a FutureObject (owned)
    int mode;
};

/// A path from an object, "RootComponent.RelativeLocation", or the name of a function: shared by all members that have
/// it, with the numbers that sessions gave it.
struct NativePath {
    PyObject_HEAD;
    PyObject* text;     ///< str (owned)
    PyObject* children; ///< {attribute: NativePath}, made with the first (owned), or null
    NativePath* owner;  ///< of a path that leads somewhere: the path without its last name (owned); found when called
    NativePath* last;   ///< and that name (owned)
    bool is_plain;      ///< one name, no "." and no "["

    /// One question that a session has numbered.
    struct Shape {
        std::uint64_t session; ///< its serial; 0: nothing here
        Py_ssize_t positional; ///< arguments without name; -1: this is a variable's path
        PyObject* keywords;    ///< tuple of str (owned), or null
        TypeId number;
    };
    static constexpr std::size_t shapes_kept = 4;
    Shape shapes[shapes_kept];
    std::uint8_t next_shape; ///< the one that is replaced next
};

/// What an attribute of an object is (base of spear.Member).
struct NativeMember {
    PyObject_HEAD;
    vectorcallfunc call;
    PyObject* target; ///< an Object or a FutureObject (owned)
    NativePath* path; ///< (owned)
    int mode;
};

/// The types, ready after make_native_types().
struct NativeTypes {
    PyTypeObject* object = nullptr;
    PyTypeObject* future = nullptr;
    PyTypeObject* future_object = nullptr;
    PyTypeObject* name_space = nullptr;
    PyTypeObject* member = nullptr;
    PyTypeObject* path = nullptr;
};
inline NativeTypes native;

/// Makes the types and adds them to the module.
void make_native_types(nb::module_& module);
/// Of the above; each file makes its own.
void make_object_types(nb::module_& module);
void make_member_type(nb::module_& module);
void make_future_type(nb::module_& module);
void make_path_type();

inline bool is_object(PyObject* value) { return PyObject_TypeCheck(value, native.object); }
inline bool is_future(PyObject* value) { return Py_IS_TYPE(value, native.future); }
inline bool is_future_object(PyObject* value) { return PyObject_TypeCheck(value, native.future_object); }
template <typename T>
T* as(PyObject* value) {
    return reinterpret_cast<T*>(value);
}

/// New references; they throw nb::python_error.
PyObject* make_object(PyObject* session, ObjectRef ref);
/// `target` may be null.
PyObject* make_future(PyObject* session, OperationHandle operation, bool has_result, PyObject* target, PyObject* name,
    bool is_function);
PyObject* make_member(PyObject* target, NativePath* path, int mode);
PyObject* make_namespace(PyTypeObject* type, PyObject* target, int mode);
/// The value of a future (its RawResult decoded), waited for at most so many seconds.
PyObject* future_result(NativeFuture* future, std::optional<double> timeout);

/// The session of an Object, Future or FutureObject; null for other values.
PyObject* session_of_target(PyObject* target);

// Paths (paths.cpp)

/// The path of an attribute, for what has one: `parent` is where it starts, or null. A new reference. Null with an
/// AttributeError for names of Python (__name__). `target` is for names that depend on the class, may be null.
NativePath* attribute_path(NativePath* parent, PyObject* self, PyObject* target, PyObject* name);
/// The path of a text. A new reference; raises WrongType if it is no str.
NativePath* path_of_text(PyObject* text);
/// Forgets what attributes are called in Unreal: spear.naming has changed its mind.
void forget_names();

/// Calls f; what it throws becomes the Python error, and then the result is `failed`.
template <typename R, typename F>
R guarded(R failed, F&& f) noexcept;

void set_python_error(const detail::ErrorBase& error);
/// The Python error for the exception that is being handled.
void translate_current_exception() noexcept;

template <typename R, typename F>
R guarded(R failed, F&& f) noexcept {
    try {
        return f();
    } catch (...) {
        translate_current_exception();
        return failed;
    }
}

} // namespace spear::python
