// SPDX-License-Identifier: MIT
// Futures, and what waits for an answer.

#include <algorithm>
#include <cmath>
#include <new>

#include "classes.hpp"
#include "native_types.hpp"
#include "session.hpp"

namespace spear::python {
namespace {

void future_dealloc(PyObject* self) {
    auto* const future = as<NativeFuture>(self);
    PyTypeObject* const type = Py_TYPE(self);
    future->operation.~OperationHandle();
    Py_XDECREF(future->session);
    Py_XDECREF(future->target);
    Py_XDECREF(future->name);
    type->tp_free(self);
    Py_DECREF(type);
}

PyObject* future_get(PyObject* self, PyObject* const* args, Py_ssize_t count, PyObject* keywords) {
    const Py_ssize_t named = keywords ? PyTuple_GET_SIZE(keywords) : 0;
    if (count + named > 1 ||
        (named == 1 && PyUnicode_CompareWithASCIIString(PyTuple_GET_ITEM(keywords, 0), "timeout") != 0)) {
        PyErr_SetString(PyExc_TypeError, "get() takes one argument, timeout: seconds, or None");
        return nullptr;
    }
    std::optional<double> timeout;
    if (count + named == 1 && args[0] != Py_None) {
        timeout = PyFloat_AsDouble(args[0]);
        if (*timeout == -1.0 && PyErr_Occurred()) {
            return nullptr;
        }
    }
    return guarded<PyObject*>(nullptr, [&] { return future_result(as<NativeFuture>(self), timeout); });
}

PyObject* future_is_ready(PyObject* self, PyObject*) {
    return PyBool_FromLong(as<NativeFuture>(self)->operation.is_ready());
}

PyObject* future_object(PyObject* self, void*) { return PyObject_CallOneArg(classes.future_object, self); }
PyObject* future_session(PyObject* self, void*) { return Py_NewRef(as<NativeFuture>(self)->session); }

PyObject* future_repr(PyObject* self) {
    const OperationHandle& operation = as<NativeFuture>(self)->operation;
    return PyUnicode_FromFormat("<spear.Future %llu%s>", static_cast<unsigned long long>(operation.number()),
        operation.is_ready() ? "" : " (pending)");
}

} // namespace

PyObject* make_future(PyObject* session, OperationHandle operation, bool has_result, PyObject* target, PyObject* name,
    bool is_function) {
    PyObject* const made = native.future->tp_alloc(native.future, 0);
    if (!made) {
        throw nb::python_error();
    }
    auto* const future = as<NativeFuture>(made);
    new (&future->operation) OperationHandle(std::move(operation));
    future->session = Py_NewRef(session);
    future->target = Py_XNewRef(target);
    future->name = Py_XNewRef(name);
    future->has_result = has_result;
    future->is_function = is_function;
    return made;
}

PyObject* future_result(NativeFuture* future, std::optional<double> timeout) {
    const nb::object kept = nb::borrow(reinterpret_cast<PyObject*>(future)); // while the lock is released
    std::optional<Milliseconds> deadline;
    if (timeout) { // what is longer than a hundred years is for ever
        deadline = Milliseconds(std::isnan(*timeout) ? 0 : static_cast<std::int64_t>(std::clamp(*timeout, 0.0, 3.2e9) * 1000));
    }
    const RawResult result = result_of(future->operation, deadline);
    if (!future->has_result) {
        return Py_NewRef(Py_None);
    }
    return decode_result(result, future->session, {future->target, future->name, future->is_function})
        .release()
        .ptr();
}

void make_future_type(nb::module_& module) {
    static PyGetSetDef attributes[] = {
        {"object", &future_object, nullptr,
            "The object that the future will be, as the target of further calls without waiting.", nullptr},
        {"_session", &future_session, nullptr, nullptr, nullptr},
        {nullptr, nullptr, nullptr, nullptr, nullptr},
    };
    static PyMethodDef methods[] = {
        {"get", reinterpret_cast<PyCFunction>(reinterpret_cast<void*>(&future_get)), METH_FASTCALL | METH_KEYWORDS,
            "get($self, /, timeout=None)\n--\n\nWaits while the operation is pending (at most ``timeout`` seconds), then "
            "returns its result or raises its error. Any thread."},
        {"is_ready", &future_is_ready, METH_NOARGS,
            "is_ready($self, /)\n--\n\nWhether get() would return (or raise) at once."},
        {"__class_getitem__", &Py_GenericAlias, METH_O | METH_CLASS, "Future[T], for annotations."},
        {nullptr, nullptr, 0, nullptr},
    };
    PyType_Slot slots[] = {
        {Py_tp_doc, const_cast<char*>("The result of an asynchronous operation. May be an argument of later "
                                      "operations, in any position.")},
        {Py_tp_dealloc, reinterpret_cast<void*>(&future_dealloc)},
        {Py_tp_repr, reinterpret_cast<void*>(&future_repr)},
        {Py_tp_getset, attributes},
        {Py_tp_methods, methods},
        {0, nullptr},
    };
    PyType_Spec spec{"spear._native.Future", sizeof(NativeFuture), 0,
        Py_TPFLAGS_DEFAULT | Py_TPFLAGS_DISALLOW_INSTANTIATION, slots};
    native.future = reinterpret_cast<PyTypeObject*>(PyType_FromSpec(&spec));
    if (!native.future) {
        throw nb::python_error();
    }
    module.attr("Future") = nb::handle(reinterpret_cast<PyObject*>(native.future));
}

void make_native_types(nb::module_& module) {
    make_path_type();
    make_future_type(module);
    make_object_types(module);
    make_member_type(module);
}

} // namespace spear::python
