// SPDX-License-Identifier: MIT
#pragma once

// What Python sees of a session: PySession, NativeObject, NativeFuture. All members are guarded by Python's lock (the
// module declares no free threading), except that waits release it.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include "spear/spear.hpp"

namespace spear::python {
namespace nb = nanobind;

/// How an operation is performed. With `raw_mode` added, a null object is always None: nobody is asked whether that may
/// be.
enum Mode : int { sync_mode = 0, async_mode = 1, send_mode = 2, raw_mode = 4 };

/// How values of a Python struct class are written.
struct StructWriter {
    TypeId numbers = types::null;    ///< announced type whose fields are numbers; null if the class names none
    TypeId anything = types::null;   ///< announced type with fields of any type
    std::vector<PyObject*> fields;   ///< interned names of the attributes, kept alive by the class
    std::vector<std::string> names;  ///< the engine's names of the fields
    std::vector<TypeId> field_types; ///< of `numbers`
};

/// How values of a Python enum class are written.
struct EnumWriter {
    TypeId type = types::null;    ///< announced with names and numbers; null if the class is no enum of Unreal
    std::uint32_t enums_seen = 0; ///< as of which it holds
};

/// How values of an announced struct or enum are read.
struct StructReader {
    PyObject* made = nullptr;            ///< the class (owned)
    std::vector<PyObject*> fields;       ///< interned names of the attributes (owned)
    bool is_result = false;              ///< the outputs of a function: a named tuple
    PyObject* value_to_member = nullptr; ///< enums: {number: member} (owned)
    PyObject* combination = nullptr;     ///< enums of bits: what makes a member of any number (owned), or null
};

/// What an operation was about, for results that are null.
struct Asked {
    nb::object target; ///< the object, or the future of it; nothing for entry points, and in raw mode
    nb::object name;   ///< the function, or the path of the variable
    bool is_function = false;
};

class __attribute__((visibility("hidden"))) PySession {
public:
    explicit PySession(Instance instance) : instance_(std::move(instance)), session_(instance_.session()) {}
    ~PySession();
    PySession(const PySession&) = delete;
    PySession& operator=(const PySession&) = delete;

    const std::shared_ptr<Session>& session() const { return session_; }
    Instance& instance() { return instance_; }

    // Operations
    // --------------------------------------------------------------------------------------------------------- `self`
    // is the Python object of this session: objects and futures refer to it.

    static nb::object call(nb::handle self, std::string_view entry_point, nb::tuple args, nb::handle kwargs, int mode);
    static nb::object call_function(
        nb::handle self, nb::handle target, nb::handle function, nb::tuple args, nb::handle kwargs, int mode);
    static nb::object get_property(nb::handle self, nb::handle target, nb::handle path, int mode);
    static nb::object set_property(nb::handle self, nb::handle target, nb::handle path, nb::handle value, int mode);

    // Blocks
    // -------------------------------------------------------------------------------------------------------------

    void begin_block();
    void end_block();
    void close_block(bool single_step);
    void abort_block();
    void flush();
    void close();

    // Caches
    // -------------------------------------------------------------------------------------------------------------

    const StructWriter& writer_for(PyTypeObject* type);
    const StructReader& struct_reader(TypeId type, const TypeInfo& info);
    const StructReader& enum_reader(TypeId type, const TypeInfo& info);
    /// The announced type of an enum class's values; null for classes that are no enums of Unreal.
    TypeId enum_type(PyTypeObject* type);
    nb::object class_names(TypeId class_type);

    /// Of all sessions of this process: unlike the server's number, it never means another one.
    const std::uint64_t serial = next_serial++;

    /// How many null objects were read so far.
    std::uint64_t nulls_read = 0;

private:
    static nb::object perform(
        nb::handle self, OperationBuilder& operation, int mode, bool has_result, const Asked& asked);
    ShapeId function_shape(nb::handle function, std::size_t positional, nb::handle kwargs);
    ShapeId path_shape(nb::handle path);

    static inline std::uint64_t next_serial = 1;

    Instance instance_;
    std::shared_ptr<Session> session_;
    std::unordered_map<std::string, ShapeId> function_shapes_;
    std::unordered_map<std::string, ShapeId> path_shapes_;
    std::unordered_map<PyTypeObject*, StructWriter> writers_;
    std::unordered_map<PyTypeObject*, EnumWriter> enum_writers_;
    std::unordered_map<TypeId, StructReader> readers_;
};

/// Base of spear.UnrealObject.
struct __attribute__((visibility("hidden"))) NativeObject {
    nb::object session; // a PySession
    ObjectRef ref;
};

struct __attribute__((visibility("hidden"))) NativeFuture {
    nb::object session; // a PySession
    OperationHandle operation;
    bool has_result = true;
    Asked asked;
};

inline PySession& session_of(nb::handle self) { return *nb::inst_ptr<PySession>(self); }

// encode.cpp: appends a Python value as an argument. Raises TypeError, OverflowError for what has no place on the wire.
void encode_python(OperationBuilder& operation, PySession& session, nb::handle value, std::size_t depth = 0);

// decode.cpp: reads one value.
nb::object decode_python(Decoder& in, TypeId type, nb::handle session);
/// Reads an operation's result. Raises NullObject if it is a null object that cannot be meant (spear.nulls).
nb::object decode_result(const RawResult& result, nb::handle session, const Asked& asked);

// errors.cpp
void set_python_error(const detail::ErrorBase& error);

} // namespace spear::python
