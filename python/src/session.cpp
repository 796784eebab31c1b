// SPDX-License-Identifier: MIT
#include "session.hpp"

#include <cstring>

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

Asked asked_about(nb::handle target, nb::handle name, int mode, bool is_function) {
    return mode & raw_mode ? Asked{} : Asked{nb::borrow(target), nb::borrow(name), is_function};
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
        RawResult result;
        {
            const nb::gil_scoped_release unlock;
            result = operation.call();
        }
        return has_result ? decode_result(result, self, asked) : nb::none();
    }
    if (mode == async_mode) {
        return nb::cast(
            new NativeFuture{nb::borrow(self), operation.async(), has_result, asked}, nb::rv_policy::take_ownership);
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

ShapeId PySession::function_shape(nb::handle function, std::size_t positional, nb::handle kwargs) {
    std::string key(text_of(function, "A function's name"));
    const std::size_t name_size = key.size();
    key += '\0';
    key += static_cast<char>('0' + positional % 64);
    PyObject *name = nullptr, *value = nullptr;
    Py_ssize_t position = 0;
    while (PyDict_Next(kwargs.ptr(), &position, &name, &value)) {
        key += '\0';
        key += text_of(name, "A keyword");
    }
    if (const auto at = function_shapes_.find(key); at != function_shapes_.end() && positional < 64) {
        return at->second;
    }
    std::vector<std::string_view> argument_names(positional);
    position = 0;
    std::vector<nb::object> renamed; // keeps the texts
    while (PyDict_Next(kwargs.ptr(), &position, &name, &value)) {
        std::string_view keyword = text_of(name, "A keyword");
        if (keyword.ends_with('_')) { // may stand for a word of Python: `class_` for `class`
            renamed.push_back(nb::handle(classes.parameter_name)(nb::handle(name)));
            keyword = text_of(renamed.back(), "A keyword");
        }
        argument_names.push_back(keyword);
    }
    const ShapeId shape = session_->call_shape(std::string_view(key).substr(0, name_size), argument_names);
    if (positional < 64) {
        function_shapes_.emplace(std::move(key), shape);
    }
    return shape;
}

ShapeId PySession::path_shape(nb::handle path) {
    const std::string_view text = text_of(path, "A variable's path");
    if (const auto at = path_shapes_.find(std::string(text)); at != path_shapes_.end()) {
        return at->second;
    }
    return path_shapes_.emplace(std::string(text), session_->path_shape(text)).first->second;
}

nb::object PySession::call_function(
    nb::handle self, nb::handle target, nb::handle function, nb::tuple args, nb::handle kwargs, int mode) {
    PySession& session = session_of(self);
    OperationBuilder operation(*session.session_, unreal_service::call_function);
    encode_python(operation, session, target);
    operation.put_shape(session.function_shape(function, args.size(), kwargs));
    for (Py_ssize_t i = 0; i < PyTuple_GET_SIZE(args.ptr()); ++i) {
        encode_python(operation, session, PyTuple_GET_ITEM(args.ptr(), i));
    }
    PyObject *name = nullptr, *value = nullptr;
    Py_ssize_t position = 0;
    while (PyDict_Next(kwargs.ptr(), &position, &name, &value)) {
        encode_python(operation, session, value);
    }
    return perform(self, operation, mode, true, asked_about(target, function, mode, true));
}

nb::object PySession::get_property(nb::handle self, nb::handle target, nb::handle path, int mode) {
    PySession& session = session_of(self);
    OperationBuilder operation(*session.session_, unreal_service::get_property);
    encode_python(operation, session, target);
    operation.put_shape(session.path_shape(path));
    return perform(self, operation, mode, true, asked_about(target, path, mode, false));
}

nb::object PySession::set_property(nb::handle self, nb::handle target, nb::handle path, nb::handle value, int mode) {
    PySession& session = session_of(self);
    OperationBuilder operation(*session.session_, unreal_service::set_property);
    encode_python(operation, session, target);
    operation.put_shape(session.path_shape(path));
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

const StructWriter& PySession::writer_for(PyTypeObject* type) {
    if (const auto at = writers_.find(type); at != writers_.end()) {
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

const StructReader& PySession::struct_reader(TypeId type, const TypeInfo& info) {
    if (const auto at = readers_.find(type); at != readers_.end()) {
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
    writers_.erase(reinterpret_cast<PyTypeObject*>(python_class.ptr())); // the class may have got more fields
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
