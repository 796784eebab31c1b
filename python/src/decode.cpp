// SPDX-License-Identifier: MIT
// Results as Python values: straight from the message's bytes.

#include "classes.hpp"
#include "session.hpp"
#include "spear/aliases.hpp"

namespace spear::python {
namespace {

[[noreturn]] void malformed() {
    throw_error(ErrorCode::MalformedMessage, "The engine sent a value that cannot be read.");
}

nb::object checked(PyObject* object) {
    if (!object) {
        throw nb::python_error();
    }
    return nb::steal(object);
}

nb::object text(Decoder& in) {
    const std::string_view view = in.get_text();
    return checked(PyUnicode_DecodeUTF8(view.data(), static_cast<Py_ssize_t>(view.size()), "replace"));
}

nb::object decode_object(Decoder& in, nb::handle session) {
    ObjectRef ref;
    ref.handle = in.get<std::uint64_t>();
    ref.class_type = in.get<TypeId>();
    if (ref.handle == 0) {
        ++session_of(session).nulls_read;
        return nb::none();
    }
    return nb::steal(make_object(session.ptr(), ref));
}

nb::object decode_struct(Decoder& in, TypeId type, const TypeInfo& info, nb::handle session) {
    const StructReader& reader = session_of(session).struct_reader(type, info);
    auto* type_object = reinterpret_cast<PyTypeObject*>(reader.made);
    if (reader.is_result) {
        nb::object tuple = checked(type_object->tp_alloc(type_object, static_cast<Py_ssize_t>(info.fields.size())));
        for (std::size_t i = 0; i < info.fields.size(); ++i) {
            PyTuple_SET_ITEM(tuple.ptr(), static_cast<Py_ssize_t>(i),
                decode_python(in, info.fields[i].type, session).release().ptr());
        }
        return tuple;
    }
    nb::object made = checked(type_object->tp_alloc(type_object, 0));
    const bool has_slots = reader.offsets.size() == info.fields.size();
    for (std::size_t i = 0; i < info.fields.size(); ++i) {
        nb::object field = decode_python(in, info.fields[i].type, session);
        if (has_slots) {
            *reinterpret_cast<PyObject**>(reinterpret_cast<char*>(made.ptr()) + reader.offsets[i]) =
                field.release().ptr(); // new: nothing is there yet
        } else if (PyObject_GenericSetAttr(made.ptr(), reader.fields[i], field.ptr()) != 0) {
            throw nb::python_error();
        }
    }
    return made;
}

/// A list; or a set if all elements can be in one.
nb::object decode_elements(Decoder& in, const TypeInfo& info, nb::handle session) {
    const std::uint32_t count = in.get_count(1);
    nb::list list;
    for (std::uint32_t i = 0; i < count && in.ok(); ++i) {
        list.append(decode_python(in, info.element, session));
    }
    if (info.kind == TypeKind::set) {
        PyObject* set = PySet_New(list.ptr());
        if (set) {
            return nb::steal(set);
        }
        PyErr_Clear(); // structs are not hashable
    }
    return list;
}

/// A dict; or a list of pairs if a key cannot be in one (structs).
template <typename Key, typename Element>
nb::object decode_pairs(std::uint32_t count, Decoder& in, Key&& key, Element&& element) {
    nb::list pairs;
    for (std::uint32_t i = 0; i < count && in.ok(); ++i) {
        nb::object k = key();
        nb::object v = element();
        pairs.append(nb::make_tuple(std::move(k), std::move(v)));
    }
    nb::dict dict;
    for (const nb::handle pair : pairs) {
        if (PyDict_SetItem(dict.ptr(), PyTuple_GET_ITEM(pair.ptr(), 0), PyTuple_GET_ITEM(pair.ptr(), 1)) != 0) {
            PyErr_Clear();
            return pairs;
        }
    }
    return dict;
}

nb::object decode_enum(Decoder& in, TypeId type, const TypeInfo& info, nb::handle session) {
    const StructReader& reader = session_of(session).enum_reader(type, info);
    const nb::object number = checked(PyLong_FromLongLong(in.get<std::int64_t>()));
    if (PyObject* member = PyDict_GetItemWithError(reader.value_to_member, number.ptr())) {
        return nb::borrow(member);
    }
    if (reader.combination) {
        return nb::handle(reader.combination)(number);
    }
    return number; // a number between the entries stays a number
}

/// Asks whether nulls among the results can be meant: a null object, or some in a tuple of outputs or a container.
/// Those inside of structs are what they are.
void check_nulls(nb::handle value, nb::handle session, const Asked& asked) {
    bool in_question = value.is_none() || PyList_CheckExact(value.ptr()) || PyAnySet_Check(value.ptr());
    if (PyTuple_Check(value.ptr())) {
        for (const nb::handle item : nb::borrow<nb::tuple>(value)) {
            in_question |= item.is_none() || PyList_CheckExact(item.ptr()) || PyAnySet_Check(item.ptr());
        }
    }
    if (in_question) {
        nb::object name = nb::borrow(asked.name);
        if (asked.is_function) {
            Py_ssize_t size = 0;
            const char* written = PyUnicode_AsUTF8AndSize(name.ptr(), &size);
            const std::string_view reflected = resolve_function_alias({written, static_cast<std::size_t>(size)});
            name = nb::str(reflected.data(), reflected.size());
        }
        nb::handle(classes.null_result)(session, nb::handle(asked.target), name, asked.is_function, value);
    }
}

} // namespace

nb::object decode_python(Decoder& in, TypeId type, nb::handle session) {
    switch (type) {
    case types::null:
        return nb::none();
    case types::boolean:
        return nb::bool_(in.get<std::uint8_t>() != 0);
    case types::i8:
        return checked(PyLong_FromLong(in.get<std::int8_t>()));
    case types::i16:
        return checked(PyLong_FromLong(in.get<std::int16_t>()));
    case types::i32:
        return checked(PyLong_FromLong(in.get<std::int32_t>()));
    case types::i64:
        return checked(PyLong_FromLongLong(in.get<std::int64_t>()));
    case types::u8:
        return checked(PyLong_FromLong(in.get<std::uint8_t>()));
    case types::u16:
        return checked(PyLong_FromLong(in.get<std::uint16_t>()));
    case types::u32:
        return checked(PyLong_FromUnsignedLong(in.get<std::uint32_t>()));
    case types::u64:
        return checked(PyLong_FromUnsignedLongLong(in.get<std::uint64_t>()));
    case types::f32:
        return checked(PyFloat_FromDouble(static_cast<double>(in.get<float>())));
    case types::f64:
        return checked(PyFloat_FromDouble(in.get<double>()));
    case types::string:
        return text(in);
    case types::bytes: {
        const auto bytes = in.get_raw(in.get<std::uint32_t>());
        return checked(PyBytes_FromStringAndSize(
            reinterpret_cast<const char*>(bytes.data()), static_cast<Py_ssize_t>(bytes.size())));
    }
    case types::object:
        return decode_object(in, session);
    case types::any: {
        const auto inner = in.get<TypeId>();
        return in.ok() ? decode_python(in, inner, session) : nb::none();
    }
    case types::list: {
        nb::list list;
        for (std::uint32_t n = in.get_count(sizeof(TypeId)); n != 0 && in.ok(); --n) {
            list.append(decode_python(in, types::any, session));
        }
        return list;
    }
    case types::dict:
        return decode_pairs(
            in.get_count(8), in, [&] { return text(in); }, [&] { return decode_python(in, types::any, session); });
    case types::map:
        return decode_pairs(
            in.get_count(8), in, [&] { return decode_python(in, types::any, session); },
            [&] { return decode_python(in, types::any, session); });
    default:
        break;
    }
    const TypeInfo* info = session_of(session).session()->types().find(type);
    if (!info || Py_EnterRecursiveCall(" while reading a value of the engine") != 0) {
        info ? throw nb::python_error() : malformed();
    }
    struct Leave {
        ~Leave() { Py_LeaveRecursiveCall(); }
    } leave;
    switch (info->kind) {
    case TypeKind::structure:
        return decode_struct(in, type, *info, session);
    case TypeKind::array:
    case TypeKind::set:
        return decode_elements(in, *info, session);
    case TypeKind::map:
        return decode_pairs(
            in.get_count(1), in, [&] { return decode_python(in, info->key, session); },
            [&] { return decode_python(in, info->element, session); });
    case TypeKind::enumeration:
        return decode_enum(in, type, *info, session);
    default:
        malformed();
    }
}

nb::object decode_result(const RawResult& result, nb::handle session, const Asked& asked) {
    Decoder in(result.view.payload);
    const std::uint64_t nulls_before = session_of(session).nulls_read;
    nb::object value = decode_python(in, result.view.type, session);
    if (!in.ok()) {
        malformed();
    }
    if (session_of(session).nulls_read != nulls_before && asked.target) {
        check_nulls(value, session, asked);
    }
    return value;
}

} // namespace spear::python
