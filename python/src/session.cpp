// SPDX-License-Identifier: MIT
#include "session.hpp"

#include <cstring>

#include <nanobind/nanobind.h>

#include <structmember.h>

#include "classes.hpp"

namespace spear::python {
namespace {

struct EntryPointRow {
    std::string_view name;
    std::vector<std::string_view> parameters;
    bool has_result;
};

const std::vector<EntryPointRow>& entry_points() {
    static const std::vector<EntryPointRow> rows = [] {
        std::vector<EntryPointRow> made;
        AllEntryPoints::for_each([&](auto entry) {
            using E = decltype(entry);
            made.push_back(
                {E::name, {E::parameters.begin(), E::parameters.end()}, !std::is_void_v<typename E::Result>});
        });
        return made;
    }();
    return rows;
}

std::uint16_t find_entry_point(std::string_view name) {
    static const std::unordered_map<std::string_view, std::uint16_t> numbers = [] {
        std::unordered_map<std::string_view, std::uint16_t> made;
        for (const EntryPointRow& row : entry_points()) {
            made.emplace(row.name, static_cast<std::uint16_t>(made.size()));
        }
        return made;
    }();
    const auto at = numbers.find(name);
    if (at == numbers.end()) {
        throw_error(
            ErrorCode::UnknownEntryPoint, "There is no entry point '" + std::string(name) + "'.", std::string(name));
    }
    return at->second;
}

std::string_view text_of(nb::handle text, const char* what) {
    Py_ssize_t size = 0;
    const char* utf8 = PyUnicode_Check(text.ptr()) ? PyUnicode_AsUTF8AndSize(text.ptr(), &size) : nullptr;
    if (!utf8) {
        PyErr_Clear();
        throw_error(ErrorCode::WrongType, std::string(what) + " is a str, not a " + Py_TYPE(text.ptr())->tp_name + ".");
    }
    return {utf8, static_cast<std::size_t>(size)};
}

/// What is asked about an operation on a target: of an object to come, its future.
Asked asked_about(nb::handle target, const NativePath& name, int mode, bool is_function) {
    if (mode & raw_mode) {
        return {};
    }
    return {is_future_object(target.ptr()) ? as<NativeFutureObject>(target.ptr())->future : target.ptr(), name.text,
        is_function};
}

/// Whether two tuples of keywords are the same: those of one place in a program are one tuple, and its names interned.
bool same_keywords(PyObject* left, PyObject* right) {
    if (left == right) {
        return true;
    }
    if (!left || !right || PyTuple_GET_SIZE(left) != PyTuple_GET_SIZE(right)) {
        return false;
    }
    for (Py_ssize_t i = 0; i < PyTuple_GET_SIZE(left); ++i) {
        if (PyTuple_GET_ITEM(left, i) != PyTuple_GET_ITEM(right, i)) {
            return false;
        }
    }
    return true;
}

/// The number that a session gave to what `positional` and `keywords` say of a path, asked from `announce` once.
template <typename F>
ShapeId kept_shape(
    NativePath& path, std::uint64_t session, Py_ssize_t positional, PyObject* keywords, const F& announce) {
    for (const NativePath::Shape& shape : path.shapes) {
        if (shape.session == session && shape.positional == positional && same_keywords(shape.keywords, keywords)) {
            return {shape.number};
        }
    }
    const ShapeId number = announce();
    NativePath::Shape& shape = path.shapes[path.next_shape++ % NativePath::shapes_kept];
    PyObject* const before = shape.keywords;
    shape = {session, positional, Py_XNewRef(keywords), number.number};
    Py_XDECREF(before);
    return number;
}

TypeId number_type_named(std::string_view name) {
    static constexpr std::pair<std::string_view, TypeId> rows[] = {{"f64", types::f64}, {"f32", types::f32},
        {"i8", types::i8}, {"i16", types::i16}, {"i32", types::i32}, {"i64", types::i64}, {"u8", types::u8},
        {"u16", types::u16}, {"u32", types::u32}};
    for (const auto& [row, type] : rows) {
        if (row == name)
            return type;
    }
    throw_error(ErrorCode::WrongType,
        "field_types has '" + std::string(name) + "'; it knows f64, f32, i8 ... i64, u8 ... u32.");
}

} // namespace

PySession::~PySession() {
    for (auto& [type, reader] : readers_) {
        Py_XDECREF(reader.made);
        Py_XDECREF(reader.value_to_member);
        Py_XDECREF(reader.combination);
        for (PyObject* name : reader.fields) {
            Py_DECREF(name);
        }
    }
    const nb::gil_scoped_release unlock; // closing may wait for the engine
    try {
        instance_.close();
    } catch (const detail::ErrorBase&) { // a destructor does not throw; close() by name does
    }
}

// Operations
// -------------------------------------------------------------------------------------------------------------------

nb::object PySession::perform(
    nb::handle self, OperationBuilder& operation, int mode, bool has_result, const Asked& asked) {
    mode &= ~raw_mode;
    if (mode == sync_mode) {
        const RawResult result = waited_for([&](BeforeSleep notice) { return operation.call_here({}, notice); });
        return has_result ? decode_result(result, self, asked) : nb::none();
    }
    if (mode == async_mode) {
        return nb::steal(
            make_future(self.ptr(), operation.async(), has_result, asked.target, asked.name, asked.is_function));
    }
    operation.send();
    return nb::none();
}

nb::object PySession::call(nb::handle self, std::string_view entry_point, nb::tuple args, nb::handle kwargs, int mode) {
    PySession& session = session_of(self);
    const std::uint16_t number = find_entry_point(entry_point);
    const EntryPointRow& row = entry_points()[number];
    const std::size_t count = row.parameters.size();
    if (args.size() > count) {
        throw_error(ErrorCode::UnknownArgument,
            std::string(entry_point) + " takes " + std::to_string(count) + " arguments, " +
                std::to_string(args.size()) + " were given.",
            std::string(entry_point));
    }
    OperationBuilder operation(*session.session_, number);
    Py_ssize_t used = 0;
    for (std::size_t i = 0; i < count; ++i) {
        PyObject* given = i < args.size() ? PyTuple_GET_ITEM(args.ptr(), static_cast<Py_ssize_t>(i)) : nullptr;
        if (PyDict_Size(kwargs.ptr()) != 0) {
            const nb::str name(row.parameters[i].data(), row.parameters[i].size());
            if (PyObject* named = PyDict_GetItemWithError(kwargs.ptr(), name.ptr())) {
                if (given) {
                    throw_error(ErrorCode::UnknownArgument,
                        "Argument '" + std::string(row.parameters[i]) + "' was given twice.", std::string(entry_point),
                        std::string(row.parameters[i]));
                }
                given = named;
                ++used;
            }
        }
        if (!given) {
            throw_error(ErrorCode::MissingArgument,
                "Argument '" + std::string(row.parameters[i]) + "' of " + std::string(entry_point) + " was not given.",
                std::string(entry_point), std::string(row.parameters[i]));
        }
        encode_python(operation, session, given);
    }
    if (used != PyDict_Size(kwargs.ptr())) {
        throw_error(ErrorCode::UnknownArgument,
            std::string(entry_point) + " has no such argument as one of " + nb::str(kwargs).c_str() + ".",
            std::string(entry_point));
    }
    return perform(self, operation, mode, row.has_result, {});
}

ShapeId PySession::announced_function_shape(NativePath& function, const Arguments& arguments) {
    std::vector<std::string_view> argument_names(static_cast<std::size_t>(arguments.positional));
    std::vector<nb::object> renamed; // keeps the texts
    for (Py_ssize_t i = 0; arguments.keywords && i < PyTuple_GET_SIZE(arguments.keywords); ++i) {
        PyObject* const name = PyTuple_GET_ITEM(arguments.keywords, i);
        std::string_view keyword = text_of(name, "A keyword");
        if (keyword.ends_with('_')) { // may stand for a word of Python: `class_` for `class`
            renamed.push_back(nb::handle(classes.parameter_name)(nb::handle(name)));
            keyword = text_of(renamed.back(), "A keyword");
        }
        argument_names.push_back(keyword);
    }
    return session_->call_shape(text_of(function.text, "A function's name"), argument_names);
}

ShapeId PySession::function_shape(NativePath& function, const Arguments& arguments) {
    return kept_shape(function, serial, arguments.positional, arguments.keywords,
        [&] { return announced_function_shape(function, arguments); });
}

ShapeId PySession::path_shape(NativePath& path) {
    return kept_shape(
        path, serial, -1, nullptr, [&] { return session_->path_shape(text_of(path.text, "A variable's path")); });
}

nb::object PySession::call_function(
    nb::handle self, nb::handle target, NativePath* function, const Arguments& arguments, int mode) {
    PySession& session = session_of(self);
    OperationBuilder operation(*session.session_, unreal_service::call_function);
    encode_python(operation, session, target);
    operation.put_shape(session.function_shape(*function, arguments));
    const Py_ssize_t count = arguments.count();
    for (Py_ssize_t i = 0; i < count; ++i) {
        encode_python(operation, session, arguments.values[i]);
    }
    return perform(self, operation, mode, true, asked_about(target, *function, mode, true));
}

nb::object PySession::get_property(nb::handle self, nb::handle target, NativePath* path, int mode) {
    PySession& session = session_of(self);
    OperationBuilder operation(*session.session_, unreal_service::get_property);
    encode_python(operation, session, target);
    operation.put_shape(session.path_shape(*path));
    return perform(self, operation, mode, true, asked_about(target, *path, mode, false));
}

nb::object PySession::set_property(nb::handle self, nb::handle target, NativePath* path, nb::handle value, int mode) {
    PySession& session = session_of(self);
    OperationBuilder operation(*session.session_, unreal_service::set_property);
    encode_python(operation, session, target);
    operation.put_shape(session.path_shape(*path));
    encode_python(operation, session, value);
    return perform(self, operation, mode, false, {});
}

// Blocks
// -----------------------------------------------------------------------------------------------------------------------

void PySession::begin_block() {
    const nb::gil_scoped_release unlock;
    session_->open_block(BlockKind::begin);
}
void PySession::end_block() {
    const nb::gil_scoped_release unlock;
    session_->open_block(BlockKind::end);
}
void PySession::close_block(bool single_step) {
    const nb::gil_scoped_release unlock;
    const auto kind = session_->open_block_of_this_thread();
    session_->close_block(kind.value_or(BlockKind::begin), single_step);
}
void PySession::abort_block() {
    const nb::gil_scoped_release unlock;
    session_->abandon_transaction();
}
void PySession::flush() {
    const nb::gil_scoped_release unlock;
    session_->flush();
}
void PySession::close() {
    const nb::gil_scoped_release unlock;
    instance_.close();
}

// Caches
// -----------------------------------------------------------------------------------------------------------------------

std::vector<Py_ssize_t> slot_offsets(PyTypeObject* type, const std::vector<PyObject*>& names) {
    std::vector<Py_ssize_t> offsets;
    for (PyObject* const name : names) {
        const nb::object found = nb::steal(PyObject_GetAttr(reinterpret_cast<PyObject*>(type), name));
        if (!found.is_valid() || !Py_IS_TYPE(found.ptr(), &PyMemberDescr_Type)) {
            PyErr_Clear();
            return {};
        }
        const PyMemberDef& member = *as<PyMemberDescrObject>(found.ptr())->d_member;
        if (member.type != T_OBJECT_EX || member.flags != 0) {
            return {};
        }
        offsets.push_back(member.offset);
    }
    return offsets;
}

const StructWriter& PySession::find_writer(PyTypeObject* type) {
    if (const auto at = writers_.find(type); at != writers_.end()) {
        last_written_ = type;
        last_writer_ = &at->second;
        return at->second;
    }
    const nb::handle python_class(reinterpret_cast<PyObject*>(type));
    Py_INCREF(type); // the cache names it: it must not be another class later
    StructWriter writer;
    TypeInfo info;
    info.kind = TypeKind::structure;
    info.name = nb::cast<std::string>(nb::getattr(python_class, nb::handle(names().struct_name)));
    const auto field_names = nb::cast<nb::tuple>(nb::getattr(python_class, nb::handle(names().field_names)));
    const auto attributes = nb::cast<nb::tuple>(nb::getattr(python_class, nb::handle(names().attributes)));
    const auto field_types = nb::cast<nb::tuple>(nb::getattr(python_class, nb::handle(names().field_types)));
    for (const nb::handle attribute : attributes) {
        PyObject* name = Py_NewRef(attribute.ptr());
        PyUnicode_InternInPlace(&name);
        writer.fields.push_back(name);
    }
    for (const nb::handle field : field_names) {
        writer.names.push_back(nb::cast<std::string>(field));
        info.fields.push_back({writer.names.back(), types::any});
    }
    if (writer.fields.empty()) {
        return writers_.emplace(type, std::move(writer))
            .first->second; // nothing is known of it: values go as dictionaries
    }
    writer.offsets = slot_offsets(type, writer.fields);
    writer.anything = session_->number_of(info);
    if (field_types.size() == writer.fields.size()) {
        for (std::size_t i = 0; i < writer.fields.size(); ++i) {
            writer.field_types.push_back(number_type_named(nb::cast<std::string>(field_types[i])));
            info.fields[i].type = writer.field_types.back();
        }
        writer.numbers = session_->number_of(info);
    }
    return writers_.emplace(type, std::move(writer)).first->second;
}

const StructReader& PySession::find_struct_reader(TypeId type, const TypeInfo& info) {
    if (const auto at = readers_.find(type); at != readers_.end()) {
        last_read_ = type;
        last_reader_ = &at->second;
        return at->second;
    }
    StructReader reader;
    const nb::str name(info.name.c_str(), info.name.size());
    nb::list fields;
    for (const FieldInfo& field : info.fields) {
        fields.append(nb::str(field.name.c_str(), field.name.size()));
    }
    reader.is_result = info.path.empty() && info.name.ends_with("_Result");
    if (reader.is_result) {
        reader.made = nb::handle(classes.result_class)(name, fields).release().ptr();
        return readers_.emplace(type, std::move(reader)).first->second;
    }
    const auto made = nb::cast<nb::tuple>(
        nb::handle(classes.struct_class)(name, nb::str(info.path.c_str(), info.path.size()), fields));
    const nb::object python_class = made[0];
    for (const nb::handle attribute : nb::cast<nb::tuple>(made[1])) {
        PyObject* interned = Py_NewRef(attribute.ptr());
        PyUnicode_InternInPlace(&interned);
        reader.fields.push_back(interned);
    }
    if (reader.fields.size() != info.fields.size()) {
        throw_error(
            ErrorCode::InternalError, "spear.structs gave a class with other fields than " + info.name + " has.");
    }
    auto* const type_object = reinterpret_cast<PyTypeObject*>(python_class.ptr());
    writers_.erase(type_object); // the class may have got more fields
    last_written_ = nullptr;
    reader.offsets = slot_offsets(type_object, reader.fields);
    reader.made = nb::object(python_class).release().ptr();
    return readers_.emplace(type, std::move(reader)).first->second;
}

const StructReader& PySession::enum_reader(TypeId type, const TypeInfo& info) {
    if (const auto at = readers_.find(type); at != readers_.end()) {
        return at->second;
    }
    StructReader reader;
    nb::list entries;
    for (const EnumEntry& entry : info.entries) {
        entries.append(nb::make_tuple(nb::str(entry.name.c_str(), entry.name.size()), entry.value));
    }
    const auto made = nb::cast<nb::tuple>(nb::handle(classes.enum_class)(nb::str(info.name.c_str(), info.name.size()),
        nb::str(info.path.c_str(), info.path.size()), nb::bool_(info.key == types::u64), entries));
    ++classes.enums_seen;
    reader.made = nb::object(made[0]).release().ptr();
    reader.value_to_member = nb::object(made[1]).release().ptr();
    if (!made[2].is_none()) {
        reader.combination = nb::object(made[2]).release().ptr();
    }
    return readers_.emplace(type, std::move(reader)).first->second;
}

TypeId PySession::enum_type(PyTypeObject* type) {
    const auto at = enum_writers_.find(type);
    if (at != enum_writers_.end() && (at->second.type == types::null || at->second.enums_seen == classes.enums_seen)) {
        return at->second.type;
    }
    EnumWriter writer;
    const nb::object found = nb::handle(classes.enum_entries)(nb::handle(reinterpret_cast<PyObject*>(type)));
    if (!found.is_none()) {
        TypeInfo info;
        info.kind = TypeKind::enumeration;
        info.name = nb::cast<std::string>(found[0]);
        info.key = nb::cast<bool>(found[1]) ? types::u64 : types::null;
        for (const nb::handle entry : nb::cast<nb::list>(found[2])) {
            info.entries.push_back({nb::cast<std::string>(entry[0]), nb::cast<std::int64_t>(entry[1])});
        }
        writer.type = session_->number_of(info);
    }
    writer.enums_seen = classes.enums_seen;
    if (at == enum_writers_.end()) {
        Py_INCREF(type); // the cache names it: it must not be another class later
    }
    return (enum_writers_[type] = writer).type;
}

nb::object PySession::class_names(TypeId class_type) {
    nb::list chain;
    const TypeTables tables = session_->types();
    // Classes are announced after their super classes, so the chain cannot loop.
    for (const TypeInfo* info = tables.find(class_type); info && info->kind == TypeKind::object_class;
        info = tables.find(info->element)) {
        chain.append(nb::str(info->name.c_str(), info->name.size()));
        if (info->element == types::null) {
            break;
        }
    }
    return nb::tuple(chain);
}

} // namespace spear::python
