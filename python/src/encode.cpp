// SPDX-License-Identifier: MIT
// Python values as arguments: straight into the operation's bytes.

#include <array>
#include <cstring>

#include "classes.hpp"
#include "session.hpp"

namespace spear::python {
namespace {

void encode_text(Encoder& out, PyObject* text) {
    Py_ssize_t size = 0;
    const char* utf8 = PyUnicode_AsUTF8AndSize(text, &size);
    if (!utf8) {
        throw nb::python_error();
    }
    out.put_text({utf8, static_cast<std::size_t>(size)});
}

void encode_integer(Encoder& out, PyObject* value) {
    int overflow = 0;
    const long long number = PyLong_AsLongLongAndOverflow(value, &overflow);
    if (overflow == 0) {
        out.put(types::i64);
        out.put(static_cast<std::int64_t>(number));
        return;
    }
    if (overflow > 0) {
        const unsigned long long big = PyLong_AsUnsignedLongLong(value);
        if (!PyErr_Occurred()) {
            out.put(types::u64);
            out.put(static_cast<std::uint64_t>(big));
            return;
        }
        PyErr_Clear();
    }
    throw_error(ErrorCode::OutOfRange,
        "An integer of more than 64 bits cannot be sent: " + std::string(nb::str(value).c_str()) + ".");
}

/// The payload of a number as a field's type; false if the Python value is none, or does not fit.
bool encode_number_payload(Encoder& out, TypeId type, PyObject* value) {
    if (type == types::f64 || type == types::f32) {
        double number = 0;
        if (PyFloat_CheckExact(value)) {
            number = PyFloat_AS_DOUBLE(value);
        } else if (PyFloat_Check(value) || (PyLong_Check(value) && !PyBool_Check(value))) {
            number = PyFloat_AsDouble(value);
            if (number == -1.0 && PyErr_Occurred()) {
                PyErr_Clear();
                return false;
            }
        } else {
            return false;
        }
        if (type == types::f64)
            out.put(number);
        else
            out.put(static_cast<float>(number));
        return true;
    }
    if (!PyLong_Check(value) || PyBool_Check(value)) {
        return false;
    }
    int overflow = 0;
    const long long number = PyLong_AsLongLongAndOverflow(value, &overflow);
    const auto put = [&]<typename T>(T) {
        if (overflow != 0 || !std::in_range<T>(number))
            return false;
        out.put(static_cast<T>(number));
        return true;
    };
    switch (type) {
    case types::i8:
        return put(std::int8_t{});
    case types::i16:
        return put(std::int16_t{});
    case types::i32:
        return put(std::int32_t{});
    case types::i64:
        return put(std::int64_t{});
    case types::u8:
        return put(std::uint8_t{});
    case types::u16:
        return put(std::uint16_t{});
    case types::u32:
        return put(std::uint32_t{});
    default:
        return false;
    }
}

/// The value of a struct's field of that index; nothing if it is not set. Not through __getattr__, which only words the
/// error.
nb::object field_of(PyObject* value, const StructWriter& writer, std::size_t index) {
    if (!writer.offsets.empty()) {
        PyObject* const in_slot =
            *reinterpret_cast<PyObject**>(reinterpret_cast<char*>(value) + writer.offsets[index]);
        return nb::borrow(in_slot);
    }
    PyObject* field = PyObject_GenericGetAttr(value, writer.fields[index]);
    if (!field) {
        if (!PyErr_ExceptionMatches(PyExc_AttributeError)) {
            throw nb::python_error();
        }
        PyErr_Clear();
    }
    return nb::steal(field);
}

/// The fields that are set, by name: the engine gives the others Unreal's own defaults.
void encode_set_fields(
    OperationBuilder& operation, PySession& session, const StructWriter& writer, PyObject* value, std::size_t depth) {
    Encoder& out = operation.out();
    out.put(types::dict);
    const std::size_t count_at = out.reserve<std::uint32_t>();
    std::uint32_t count = 0;
    if (writer.fields.empty()) { // a struct of which nothing is known: it has what it was given
        const nb::object fields = nb::steal(PyObject_GenericGetDict(value, nullptr));
        if (!fields.is_valid()) {
            throw nb::python_error();
        }
        PyObject *name = nullptr, *field = nullptr;
        Py_ssize_t position = 0;
        while (PyDict_Next(fields.ptr(), &position, &name, &field)) {
            encode_text(out, name);
            encode_python(operation, session, field, depth + 1);
            ++count;
        }
    }
    for (std::size_t i = 0; i < writer.fields.size(); ++i) {
        if (const nb::object field = field_of(value, writer, i); field.is_valid()) {
            out.put_text(writer.names[i]);
            encode_python(operation, session, field, depth + 1);
            ++count;
        }
    }
    out.patch(count_at, count);
}

/// A struct value: as plain numbers if its class says so and all fields are numbers now, else each field with its own
/// type.
void encode_struct(OperationBuilder& operation, PySession& session, PyObject* value, std::size_t depth) {
    const StructWriter& writer = session.writer_for(Py_TYPE(value));
    Encoder& out = operation.out();
    const std::size_t start = out.buffer.size();
    if (writer.numbers != types::null) {
        out.put(writer.numbers);
        bool all = true;
        for (std::size_t i = 0; i < writer.fields.size() && all; ++i) {
            const nb::object field = field_of(value, writer, i);
            all = field.is_valid() && encode_number_payload(out, writer.field_types[i], field.ptr());
        }
        if (all) {
            return;
        }
        out.buffer.resize(start);
    }
    if (writer.fields.empty()) {
        return encode_set_fields(operation, session, writer, value, depth);
    }
    out.put(writer.anything);
    for (std::size_t i = 0; i < writer.fields.size(); ++i) {
        const nb::object field = field_of(value, writer, i);
        if (!field.is_valid()) {
            out.buffer.resize(start);
            return encode_set_fields(operation, session, writer, value, depth);
        }
        encode_python(operation, session, field, depth + 1);
    }
}

/// The wire type of a buffer's elements; null if they are no numbers.
TypeId buffer_element(const Py_buffer& buffer) {
    const char* format = buffer.format ? buffer.format : "B";
    while (*format == '@' || *format == '=' || *format == '<') {
        ++format;
    }
    const bool is_signed = std::strchr("bhilqn", *format) != nullptr;
    const bool is_unsigned = std::strchr("BHILQN", *format) != nullptr;
    if (*format == 0 || format[1] != 0)
        return types::null;
    if (*format == '?')
        return types::boolean;
    if (*format == 'f')
        return types::f32;
    if (*format == 'd')
        return types::f64;
    if (!is_signed && !is_unsigned)
        return types::null;
    switch (buffer.itemsize) {
    case 1:
        return is_signed ? types::i8 : types::u8;
    case 2:
        return is_signed ? types::i16 : types::u16;
    case 4:
        return is_signed ? types::i32 : types::u32;
    case 8:
        return is_signed ? types::i64 : types::u64;
    default:
        return types::null;
    }
}

void encode_buffer_payload(Encoder& out, const Py_buffer& buffer, int dimension, const char*& at) {
    const Py_ssize_t count = buffer.shape[dimension];
    out.put(static_cast<std::uint32_t>(count));
    if (dimension + 1 == buffer.ndim) {
        out.put_raw(at, static_cast<std::size_t>(count * buffer.itemsize));
        at += count * buffer.itemsize;
        return;
    }
    for (Py_ssize_t i = 0; i < count; ++i) {
        encode_buffer_payload(out, buffer, dimension + 1, at);
    }
}

/// Opens a value's buffer, contiguous; false if it has none.
bool open_buffer(PyObject* value, Py_buffer& buffer) {
    if (PyObject_GetBuffer(value, &buffer, PyBUF_C_CONTIGUOUS | PyBUF_FORMAT) == 0) {
        return true;
    }
    PyErr_Clear();
    // Not contiguous: NumPy copies it for us.
    const nb::object copy = nb::module_::import_("numpy").attr("ascontiguousarray")(nb::handle(value));
    if (copy.ptr() == value || PyObject_GetBuffer(copy.ptr(), &buffer, PyBUF_C_CONTIGUOUS | PyBUF_FORMAT) != 0) {
        PyErr_Clear();
        return false;
    }
    return true;
}

/// The type of an array of so many dimensions.
TypeId array_type(TypeSource& source, TypeId element, int dimensions) {
    TypeId type = element;
    for (int dimension = 0; dimension < dimensions; ++dimension) {
        TypeInfo info;
        info.kind = TypeKind::array;
        info.element = type;
        type = source.number_of(info);
    }
    return type;
}

/// NumPy arrays and the like; false if the value is no array of numbers.
bool encode_buffer(OperationBuilder& operation, PyObject* value) {
    Py_buffer buffer;
    if (!open_buffer(value, buffer)) {
        return false;
    }
    struct Release {
        Py_buffer& buffer;
        ~Release() { PyBuffer_Release(&buffer); }
    } release{buffer};
    const TypeId element = buffer_element(buffer);
    if (element == types::null || buffer.ndim < 1) {
        return false;
    }
    const TypeId type = array_type(operation.types(), element, buffer.ndim);
    Encoder& out = operation.out();
    out.put(type);
    const char* at = static_cast<const char*>(buffer.buf);
    encode_buffer_payload(out, buffer, 0, at);
    return true;
}

[[noreturn]] void refuse(PyObject* value) {
    throw_error(ErrorCode::WrongType,
        std::string("A Python value of type ") + Py_TYPE(value)->tp_name +
            " cannot be sent. What can: None, bool, int, float, str, bytes, lists, dicts, sets, NumPy arrays, structs "
            "(FVector, ...), "
            "enums, objects of the engine, futures. (Of a variable of an object, send its value: .get().)");
}

} // namespace

std::unique_ptr<NumberRows> NumberRows::of(PyObject* value, PySession& session) {
    std::unique_ptr<NumberRows> rows(new NumberRows);
    if (!open_buffer(value, rows->buffer_)) {
        return nullptr;
    }
    const Py_buffer& buffer = rows->buffer_;
    const TypeId element = buffer_element(buffer);
    if (element == types::null || buffer.ndim < 1) {
        return nullptr;
    }
    rows->type_ = array_type(*session.session(), element, buffer.ndim - 1);
    rows->row_bytes_ = buffer.shape[0] ? static_cast<std::size_t>(buffer.len / buffer.shape[0]) : 0;
    return rows;
}

void NumberRows::encode(OperationBuilder& operation, std::size_t row) const {
    Encoder& out = operation.out();
    out.put(type_);
    const char* at = static_cast<const char*>(buffer_.buf) + row * row_bytes_;
    if (buffer_.ndim == 1)
        out.put_raw(at, row_bytes_);
    else
        encode_buffer_payload(out, buffer_, 1, at);
}

void encode_python(OperationBuilder& operation, PySession& session, nb::handle handle, std::size_t depth) {
    if (depth > limits::max_value_depth) {
        throw_error(ErrorCode::LimitExceeded, "A value is nested deeper than " +
                                                  std::to_string(limits::max_value_depth) +
                                                  " levels; does it contain itself?");
    }
    PyObject* value = handle.ptr();
    Encoder& out = operation.out();
    if (is_object(value)) {
        const NativeObject& object = *as<NativeObject>(value);
        if (&session_of(object.session) != &session) {
            throw_error(ErrorCode::WrongType,
                "An object of one session was given to another; find it there by its path (get_path_name()).");
        }
        Codec<ObjectRef>::encode(out, object.ref);
    } else if (value == Py_None) {
        out.put(types::null);
    } else if (PyFloat_Check(value)) {
        out.put(types::f64);
        out.put(PyFloat_AS_DOUBLE(value));
    } else if (PyBool_Check(value)) {
        out.put(types::boolean);
        out.put(static_cast<std::uint8_t>(value == Py_True));
    } else if (PyLong_CheckExact(value)) {
        encode_integer(out, value);
    } else if (PyLong_Check(value)) {
        const TypeId type = session.enum_type(Py_TYPE(value));
        if (type == types::null) {
            encode_integer(out, value);
        } else { // an enum of Unreal: the announcement names the entries, so that other numbers of the engine do no
                 // harm
            out.put(type);
            out.put(static_cast<std::int64_t>(PyLong_AsLongLong(value)));
            if (PyErr_Occurred()) {
                throw nb::python_error();
            }
        }
    } else if (PyUnicode_Check(value)) {
        out.put(types::string);
        encode_text(out, value);
    } else if (is_future(value)) {
        operation.put_future(as<NativeFuture>(value)->operation);
    } else if (is_future_object(value)) {
        operation.put_future(as<NativeFuture>(as<NativeFutureObject>(value)->future)->operation);
    } else if (PyObject_TypeCheck(value, reinterpret_cast<PyTypeObject*>(classes.struct_base))) {
        encode_struct(operation, session, value, depth);
    } else if (PyDict_Check(value)) {
        const auto count = static_cast<std::uint32_t>(PyDict_Size(value));
        PyObject *key = nullptr, *element = nullptr;
        Py_ssize_t position = 0;
        bool all_text = true;
        while (PyDict_Next(value, &position, &key, &element)) {
            all_text &= PyUnicode_Check(key) != 0;
        }
        out.put(all_text ? types::dict : types::map);
        out.put(count);
        position = 0;
        while (PyDict_Next(value, &position, &key, &element)) {
            if (all_text)
                encode_text(out, key);
            else
                encode_python(operation, session, key, depth + 1);
            encode_python(operation, session, element, depth + 1);
        }
    } else if (PyList_Check(value) || PyTuple_Check(value)) {
        const nb::object sequence = nb::steal(PySequence_Fast(value, "a sequence"));
        const Py_ssize_t count = PySequence_Fast_GET_SIZE(sequence.ptr());
        out.put(types::list);
        out.put(static_cast<std::uint32_t>(count));
        for (Py_ssize_t i = 0; i < count; ++i) {
            encode_python(operation, session, PySequence_Fast_GET_ITEM(sequence.ptr(), i), depth + 1);
        }
    } else if (PyAnySet_Check(value)) {
        out.put(types::list);
        out.put(static_cast<std::uint32_t>(PySet_Size(value)));
        for (const nb::handle element : handle) {
            encode_python(operation, session, element, depth + 1);
        }
    } else if (PyBytes_Check(value)) {
        out.put(types::bytes);
        out.put_text({PyBytes_AS_STRING(value), static_cast<std::size_t>(PyBytes_GET_SIZE(value))});
    } else if (PyObject_CheckBuffer(value) && encode_buffer(operation, value)) {
        return;
    } else if (PyIndex_Check(value)) {
        const nb::object number =
            nb::steal(PyNumber_Index(value)); // NumPy integers; a Member raises its own advice here
        if (!number.is_valid()) {
            throw nb::python_error();
        }
        encode_integer(out, number.ptr());
    } else if (PyType_Check(value) && PyObject_HasAttr(value, names().unreal_name)) {
        const nb::object name = nb::getattr(handle, nb::handle(names().unreal_name));
        if (!PyUnicode_Check(name.ptr())) {
            refuse(value);
        }
        out.put(types::string);
        encode_text(out, name.ptr());
    } else if (const PyNumberMethods* number = Py_TYPE(value)->tp_as_number;
        number && number->nb_float) { // NumPy's float32
        const nb::object as_float = nb::steal(PyNumber_Float(value));
        if (!as_float.is_valid()) {
            throw nb::python_error();
        }
        out.put(types::f64);
        out.put(PyFloat_AS_DOUBLE(as_float.ptr()));
    } else {
        refuse(value);
    }
}

} // namespace spear::python
