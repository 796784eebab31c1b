// SPDX-License-Identifier: MIT
#pragma once

// What Python sees of a session: PySession. All members are guarded by Python's lock (the module declares no free
// threading), which waits release.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include "native_types.hpp"
#include "spear/spear.hpp"

namespace spear::python {

/// How values of a Python struct class are written.
struct StructWriter {
    TypeId numbers = types::null;    ///< announced type whose fields are numbers; null if the class names none
    TypeId anything = types::null;   ///< announced type with fields of any type
    std::vector<PyObject*> fields;   ///< interned names of the attributes, kept alive by the class
    std::vector<std::string> names;  ///< the engine's names of the fields
    std::vector<TypeId> field_types; ///< of `numbers`
    /// Where the attributes are in a value whose class has slots for all of them; else empty.
    std::vector<Py_ssize_t> offsets;
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
    std::vector<Py_ssize_t> offsets;     ///< as StructWriter::offsets
    bool is_result = false;              ///< the outputs of a function: a named tuple
    PyObject* value_to_member = nullptr; ///< enums: {number: member} (owned)
    PyObject* combination = nullptr;     ///< enums of bits: what makes a member of any number (owned), or null
};

/// What an operation was about, for results that are null. Borrowed references.
struct Asked {
    PyObject* target = nullptr; ///< the object, or the future of it; nothing for entry points, and in raw mode
    PyObject* name = nullptr;   ///< the function, or the path of the variable
    bool is_function = false;
};

/// The arguments of a call as CPython's vectorcall protocol has them: first those without, then those with a name.
struct Arguments {
    PyObject* const* values = nullptr;
    Py_ssize_t positional = 0;
    PyObject* keywords = nullptr; ///< tuple of str, or null

    Py_ssize_t count() const { return positional + (keywords ? PyTuple_GET_SIZE(keywords) : 0); }
};

/// Where a class keeps these attributes if it has a slot for each (`__slots__`), in the same order; else nothing.
std::vector<Py_ssize_t> slot_offsets(PyTypeObject* type, const std::vector<PyObject*>& names);

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
    /// `target` is an Object, a Future of one or a FutureObject.
    static nb::object call_function(
        nb::handle self, nb::handle target, NativePath* function, const Arguments& arguments, int mode);
    /// The function called once for each of many objects (many.cpp): `objects` and the arguments are sequences and
    /// arrays of one value for each call, or one value for all. Gives a list of results (after all have run; raises the
    /// first error), a list of futures, or nothing.
    static nb::object call_many(
        nb::handle self, nb::handle objects, nb::str function, nb::tuple args, nb::dict kwargs, int mode);
    static nb::object get_property(nb::handle self, nb::handle target, NativePath* path, int mode);
    static nb::object set_property(nb::handle self, nb::handle target, NativePath* path, nb::handle value, int mode);

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

    const StructWriter& writer_for(PyTypeObject* type) {
        return type == last_written_ ? *last_writer_ : find_writer(type);
    }
    const StructReader& struct_reader(TypeId type, const TypeInfo& info) {
        return type == last_read_ ? *last_reader_ : find_struct_reader(type, info);
    }
    const StructReader& enum_reader(TypeId type, const TypeInfo& info);
    /// The announced type of an enum class's values; null for classes that are no enums of Unreal.
    TypeId enum_type(PyTypeObject* type);
    nb::object class_names(TypeId class_type);

    /// Of all sessions of this process: unlike the server's number, it never means another one.
    const std::uint64_t serial = next_serial++;

    /// How many null objects were read so far.
    std::uint64_t nulls_read = 0;

private:
    const StructWriter& find_writer(PyTypeObject* type);
    const StructReader& find_struct_reader(TypeId type, const TypeInfo& info);
    static nb::object perform(
        nb::handle self, OperationBuilder& operation, int mode, bool has_result, const Asked& asked);
    ShapeId function_shape(NativePath& function, const Arguments& arguments);
    ShapeId announced_function_shape(NativePath& function, const Arguments& arguments);
    ShapeId path_shape(NativePath& path);

    static inline std::uint64_t next_serial = 1;

    Instance instance_;
    std::shared_ptr<Session> session_;
    std::unordered_map<std::string, ShapeId> function_shapes_;
    std::unordered_map<PyTypeObject*, StructWriter> writers_;
    PyTypeObject* last_written_ = nullptr; // its writer is last_writer_
    const StructWriter* last_writer_ = nullptr;
    TypeId last_read_ = types::null; // its reader is last_reader_
    const StructReader* last_reader_ = nullptr;
    std::unordered_map<PyTypeObject*, EnumWriter> enum_writers_;
    std::unordered_map<TypeId, StructReader> readers_;
};

inline PySession& session_of(nb::handle self) { return *nb::inst_ptr<PySession>(self); }

/// Python's lock, given up when an operation is about to sleep and not before: answers that come within the spin cost
/// no hand-over, and no thread of Python waits for a sleeping one. Taken again when this goes.
class LateUnlock {
public:
    LateUnlock() = default;
    LateUnlock(const LateUnlock&) = delete;
    LateUnlock& operator=(const LateUnlock&) = delete;
    ~LateUnlock() {
        if (saved_) {
            PyEval_RestoreThread(saved_);
        }
    }
    void unlock() {
        if (!saved_) {
            saved_ = PyEval_SaveThread();
        }
    }

private:
    PyThreadState* saved_ = nullptr;
};

/// What `wait` gives, which may wait for the engine; it gets what it must tell the SDK.
template <typename F>
RawResult waited_for(F&& wait) {
    LateUnlock lock;
    return wait(BeforeSleep{[](void* user) { static_cast<LateUnlock*>(user)->unlock(); }, &lock});
}

/// Waits for a result; one that is there costs no hand-over of Python's lock.
inline RawResult result_of(const OperationHandle& operation, std::optional<Milliseconds> deadline) {
    return waited_for([&](BeforeSleep notice) { return operation.get(deadline, notice); });
}

// encode.cpp: appends a Python value as an argument. Raises TypeError, OverflowError for what has no place on the wire.
void encode_python(OperationBuilder& operation, PySession& session, nb::handle value, std::size_t depth = 0);

/// The rows of an array of numbers (NumPy's and others), each of which is an argument: a number, or an array.
class NumberRows {
public:
    /// Nothing if the value is no array of numbers with at least one dimension.
    static std::unique_ptr<NumberRows> of(PyObject* value, PySession& session);
    ~NumberRows() { PyBuffer_Release(&buffer_); }
    NumberRows(const NumberRows&) = delete;
    NumberRows& operator=(const NumberRows&) = delete;

    std::size_t count() const { return static_cast<std::size_t>(buffer_.shape[0]); }
    void encode(OperationBuilder& operation, std::size_t row) const;

private:
    NumberRows() = default;
    Py_buffer buffer_{};
    TypeId type_ = types::null; ///< of a row
    std::size_t row_bytes_ = 0;
};

// decode.cpp: reads one value.
nb::object decode_python(Decoder& in, TypeId type, nb::handle session);
/// Reads an operation's result. Raises NullObject if it is a null object that cannot be meant (spear.nulls).
nb::object decode_result(const RawResult& result, nb::handle session, const Asked& asked);

} // namespace spear::python
