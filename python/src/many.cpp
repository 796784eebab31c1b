// SPDX-License-Identifier: MIT
// One function called for many objects: one loop here instead of one in Python.

#include <string>
#include <vector>

#include "classes.hpp"
#include "session.hpp"

namespace spear::python {
namespace {

/// What is given for one parameter, or for the objects: a value for each call, or one for all.
class Column {
public:
    Column(nb::handle given, PySession& session, const std::string& what) : given_(nb::borrow(given)), what_(what) {
        if (PyList_Check(given.ptr()) || PyTuple_Check(given.ptr())) {
            take_sequence();
        } else if (PyObject_CheckBuffer(given.ptr()) && !PyBytes_Check(given.ptr()) &&
                   !PyByteArray_Check(given.ptr())) {
            rows_ = NumberRows::of(given.ptr(), session);
            if (rows_) {
                count_ = rows_->count();
            } else if (PySequence_Check(given.ptr()) && PySequence_Size(given.ptr()) >= 0) { // an array of objects
                take_sequence();
            }
            PyErr_Clear();
        }
    }

    /// How many values there are; nothing if one is for all.
    std::optional<std::size_t> count() const { return count_; }
    const std::string& what() const { return what_; }

    PyObject* at(std::size_t row) const {
        return sequence_.is_valid() ? PySequence_Fast_GET_ITEM(sequence_.ptr(), static_cast<Py_ssize_t>(row))
                                    : given_.ptr();
    }

    /// Appends the value for a call as its next argument.
    void encode(OperationBuilder& operation, PySession& session, std::size_t row) const {
        if (rows_)
            rows_->encode(operation, row);
        else
            encode_python(operation, session, at(row));
    }

    bool is_numbers() const { return rows_ != nullptr; }

private:
    void take_sequence() {
        sequence_ = nb::steal(PySequence_Tuple(given_.ptr())); // a copy: encoding may run code that changes a list
        if (!sequence_.is_valid()) {
            throw nb::python_error();
        }
        count_ = static_cast<std::size_t>(PyTuple_GET_SIZE(sequence_.ptr()));
    }

    nb::object given_;
    std::string what_;
    nb::object sequence_; // a tuple
    std::unique_ptr<NumberRows> rows_;
    std::optional<std::size_t> count_;
};

std::size_t common_count(const Column& objects, const std::vector<Column>& columns) {
    std::optional<std::size_t> count = objects.count();
    const Column* first = &objects;
    for (const Column& column : columns) {
        if (column.count() && !count) {
            count = column.count();
            first = &column;
        } else if (column.count() && *column.count() != *count) {
            const std::string text = column.what() + " has " + std::to_string(*column.count()) + " values, but " +
                                     first->what() + " has " + std::to_string(*count) +
                                     ": a list or array has one for each call. (What is one value for all calls is a "
                                     "struct, a number, a text; a list for all is [value] * n.)";
            PyErr_SetString(PyExc_ValueError, text.c_str());
            throw nb::python_error();
        }
    }
    return count.value_or(1);
}

} // namespace

nb::object PySession::call_many(
    nb::handle self, nb::handle objects, nb::str function, nb::tuple args, nb::dict kwargs, int mode) {
    PySession& session = session_of(self);
    const nb::object path = nb::steal(reinterpret_cast<PyObject*>(path_of_text(function.ptr())));
    const nb::object all = PyList_Check(objects.ptr()) || PyTuple_Check(objects.ptr()) || session_of_target(objects.ptr())
                               ? nb::borrow(objects)
                               : nb::steal(PySequence_Tuple(objects.ptr()));
    if (!all.is_valid()) {
        throw nb::python_error();
    }
    const Column targets(all, session, "objects");
    const auto names = nb::steal<nb::tuple>(PyTuple_New(PyDict_Size(kwargs.ptr())));
    std::vector<Column> columns;
    for (const nb::handle value : args) {
        columns.emplace_back(value, session, "argument " + std::to_string(columns.size() + 1));
    }
    PyObject *name = nullptr, *value = nullptr;
    Py_ssize_t position = 0;
    for (Py_ssize_t i = 0; PyDict_Next(kwargs.ptr(), &position, &name, &value); ++i) {
        PyTuple_SET_ITEM(names.ptr(), i, Py_NewRef(name));
        columns.emplace_back(value, session, nb::cast<std::string>(nb::handle(name)));
    }
    const Arguments shape_of{nullptr, PyTuple_GET_SIZE(args.ptr()), kwargs.size() != 0 ? names.ptr() : nullptr};
    const std::size_t count = common_count(targets, columns);

    const int how = mode & ~raw_mode;
    std::vector<OperationHandle> handles;
    nb::object futures;
    if (how == async_mode) {
        futures = nb::steal(PyList_New(static_cast<Py_ssize_t>(count)));
        if (!futures.is_valid()) {
            throw nb::python_error();
        }
    } else if (how == sync_mode) {
        handles.reserve(count);
    }
    if (count == 0) {
        return how == async_mode ? futures : how == sync_mode ? nb::object(nb::list()) : nb::none();
    }
    const ShapeId shape = session.function_shape(*as<NativePath>(path.ptr()), shape_of);
    for (std::size_t row = 0; row < count; ++row) {
        OperationBuilder operation(*session.session_, unreal_service::call_function);
        encode_python(operation, session, targets.at(row));
        operation.put_shape(shape);
        for (const Column& column : columns) {
            column.encode(operation, session, row);
        }
        if (how == send_mode) {
            operation.send();
        } else if (how == sync_mode) {
            handles.push_back(operation.async());
        } else {
            PyList_SET_ITEM(futures.ptr(), static_cast<Py_ssize_t>(row),
                make_future(self.ptr(), operation.async(), true, mode & raw_mode ? nullptr : targets.at(row),
                    mode & raw_mode ? nullptr : as<NativePath>(path.ptr())->text, true));
        }
    }
    if (how != sync_mode) {
        return how == async_mode ? futures : nb::none();
    }
    auto results = nb::steal<nb::object>(PyList_New(static_cast<Py_ssize_t>(count)));
    if (!results.is_valid()) {
        throw nb::python_error();
    }
    for (std::size_t row = 0; row < count; ++row) {
        PyObject* const target = targets.at(row);
        const Asked asked{is_future_object(target) ? as<NativeFutureObject>(target)->future : target,
            as<NativePath>(path.ptr())->text, true};
        const RawResult result = result_of(handles[row], {});
        PyList_SET_ITEM(results.ptr(), static_cast<Py_ssize_t>(row),
            decode_result(result, self, mode & raw_mode ? Asked{} : asked).release().ptr());
    }
    return results;
}

} // namespace spear::python
