// SPDX-License-Identifier: MIT
#pragma once

// The one value encoding: how operations, arguments and results look as bytes, on every transport, both ways. The header serves
// client and server, so it uses neither exceptions nor RTTI, and no library but the standard one.
//
// A value is a type number (u32) followed by its payload. All numbers are little-endian and unaligned; nothing is padded.
// Small type numbers are built in. Composite types are *announced* once per session by the side that writes them, and get
// a number then: the client counts up from first_client_type, the server from first_server_type, so that either side can
// read values of both. Announcements travel ahead of the first message that uses them.
//
//   null            nothing                         list      u32 n, n values
//   boolean         u8 0 or 1                       dict      u32 n, n x (string, value)
//   i8 ... f64      the number                      map       u32 n, n x (value, value)
//   string          u32 bytes, UTF-8                future    u64 number of an earlier operation of the session
//   handle          u64 handle: an object without its class, from the client
//   bytes           u32 bytes, raw                  object    u64 handle (0 is null), u32 announced class (0 if null)
//   announced struct:  its fields in order, each without type number (unless the field's type is `any`)
//   announced array/set: u32 n, n payloads     announced map: u32 n, n x (payload, payload)     announced enum: i64
//   any             a value (type number and payload): only as a field or element type

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "spear/error_code.hpp"
#include "spear/limits.hpp"

namespace spear {

static_assert(std::endian::native == std::endian::little, "the wire is little-endian and written by plain copies");

using TypeId = std::uint32_t;

namespace types {
inline constexpr TypeId null = 0, boolean = 1, i8 = 2, i16 = 3, i32 = 4, i64 = 5, u8 = 6, u16 = 7, u32 = 8, u64 = 9, f32 = 10, f64 = 11, string = 12,
                        bytes = 13, object = 14, any = 15, future = 16, list = 17, dict = 18, map = 19, handle = 20;
inline constexpr TypeId last_builtin = 20;
inline constexpr TypeId first_client_type = 64;
inline constexpr TypeId first_server_type = 0x8000'0000u;
} // namespace types

/// Bytes of a number's payload; 0 for types of variable size and for null.
constexpr std::size_t fixed_size(TypeId type) {
    switch (type) {
    case types::boolean: case types::i8: case types::u8: return 1;
    case types::i16: case types::u16: return 2;
    case types::i32: case types::u32: case types::f32: return 4;
    case types::i64: case types::u64: case types::f64: case types::future: case types::handle: return 8;
    case types::object: return 12;
    default: return 0;
    }
}

enum class TypeKind : std::uint8_t { structure = 1, array = 2, set = 3, map = 4, enumeration = 5, object_class = 6, call_shape = 7, path_shape = 8 };

struct FieldInfo {
    std::string name{};
    TypeId type = types::any;
    friend bool operator==(const FieldInfo&, const FieldInfo&) = default;
};

struct EnumEntry {
    std::string name{}; ///< short name without the enum's scope, e.g. "WorldStatic"
    std::int64_t value = 0;
    friend bool operator==(const EnumEntry&, const EnumEntry&) = default;
};

/// An announced type, call shape or property path.
struct TypeInfo {
    TypeKind kind = TypeKind::structure;
    /// structure, enumeration, object_class: the C++ name ("FVector", "AActor"); call_shape: the function's name; path_shape: the
    /// path, e.g. "RootComponent.RelativeLocation.X".
    std::string name{};
    std::string path{};               ///< structure, enumeration, object_class: the object path ("/Script/Engine.Actor"), may be empty;
                                      ///< call_shape: if the name stands for an alias (aliases.hpp), what was written: tried first
    TypeId element = types::null;     ///< array, set: element; map: value; object_class: the announced super class (0 at UObject)
    TypeId key = types::null;         ///< map: the keys; enumeration: u64 if the entries are bits that values combine, else null
    std::vector<FieldInfo> fields{};  ///< structure; call_shape: the arguments in the order sent, a positional one has an empty name
    std::vector<EnumEntry> entries{}; ///< enumeration
    std::uint32_t weight = 1;         ///< values inside one value of the type, counted by the table (not sent)
};

/// Bytes that grow at the end, like a std::vector, but without writing zeros that are overwritten at once.
class ByteBuffer {
public:
    ByteBuffer() = default;
    ByteBuffer(const ByteBuffer& other) { append(other.data_, other.size_); }
    ByteBuffer(ByteBuffer&& other) noexcept { swap(other); }
    ByteBuffer& operator=(ByteBuffer other) noexcept {
        swap(other);
        return *this;
    }
    ~ByteBuffer() { ::operator delete(data_); }

    std::byte* data() { return data_; }
    const std::byte* data() const { return data_; }
    std::size_t size() const { return size_; }
    std::size_t capacity() const { return capacity_; }
    bool empty() const { return size_ == 0; }
    std::byte* begin() { return data_; }
    std::byte* end() { return data_ + size_; }
    const std::byte* begin() const { return data_; }
    const std::byte* end() const { return data_ + size_; }
    std::byte& operator[](std::size_t at) { return data_[at]; }
    const std::byte& operator[](std::size_t at) const { return data_[at]; }

    void clear() { size_ = 0; }
    /// New bytes are of no particular value.
    void resize(std::size_t size) {
        if (size > capacity_) {
            enlarge(size - size_);
        }
        size_ = size;
    }
    /// Room for so many more bytes, which the caller fills.
    std::byte* extend(std::size_t size) {
        if (size > capacity_ - size_) {
            enlarge(size);
        }
        std::byte* const at = data_ + size_;
        size_ += size;
        return at;
    }
    void append(const void* data, std::size_t size) {
        if (size != 0) {
            std::memcpy(extend(size), data, size);
        }
    }
    void swap(ByteBuffer& other) noexcept {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
    }

private:
    void enlarge(std::size_t more) {
        std::size_t capacity = capacity_ < 32 ? 64 : 2 * capacity_;
        if (capacity < size_ + more) {
            capacity = size_ + more;
        }
        auto* const larger = static_cast<std::byte*>(::operator new(capacity));
        if (size_ != 0) {
            std::memcpy(larger, data_, size_);
        }
        ::operator delete(data_);
        data_ = larger;
        capacity_ = capacity;
    }

    std::byte* data_ = nullptr;
    std::size_t size_ = 0;
    std::size_t capacity_ = 0;
};

/// Appends to a byte buffer that it owns. Never fails.
class Encoder {
public:
    ByteBuffer buffer;

    template <typename T>
        requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    void put(T value) {
        std::memcpy(buffer.extend(sizeof(T)), &value, sizeof(T));
    }
    void put_raw(const void* data, std::size_t size) { buffer.append(data, size); }
    void put_text(std::string_view text) { ///< string payload
        put(static_cast<std::uint32_t>(text.size()));
        put_raw(text.data(), text.size());
    }
    /// Reserves a number to be written later with patch(); returns its offset.
    template <typename T>
    std::size_t reserve() {
        const std::size_t at = buffer.size();
        buffer.extend(sizeof(T));
        return at;
    }
    template <typename T>
    void patch(std::size_t at, T value) { std::memcpy(buffer.data() + at, &value, sizeof(T)); }
    std::span<const std::byte> bytes() const { return {buffer.data(), buffer.size()}; }
};

/// Reads bytes that nobody vouches for. After the first read past the end, or limit exceeded, `ok()` is false, every read gives
/// zero or empty, and the position no longer moves.
class Decoder {
public:
    Decoder() = default;
    explicit Decoder(std::span<const std::byte> bytes) : position_(bytes.data()), end_(bytes.data() + bytes.size()) {}

    template <typename T>
        requires std::is_arithmetic_v<T> || std::is_enum_v<T>
    T get() {
        T value{};
        if (const std::byte* at = take(sizeof(T))) {
            std::memcpy(&value, at, sizeof(T));
        }
        return value;
    }
    std::string_view get_text() {
        const auto size = get<std::uint32_t>();
        if (size > limits::max_string_bytes) {
            fail();
        }
        const std::byte* at = take(size);
        return at ? std::string_view(reinterpret_cast<const char*>(at), size) : std::string_view();
    }
    std::span<const std::byte> get_raw(std::size_t size) {
        const std::byte* at = take(size);
        return at ? std::span<const std::byte>(at, size) : std::span<const std::byte>();
    }
    /// The number of elements that follow; fails if they cannot possibly fit into what is left.
    std::uint32_t get_count(std::size_t smallest_element) {
        const auto count = get<std::uint32_t>();
        if (count > limits::max_elements || (smallest_element != 0 && count > remaining() / smallest_element)) {
            fail();
            return 0;
        }
        return count;
    }
    std::size_t remaining() const { return static_cast<std::size_t>(end_ - position_); }
    const std::byte* position() const { return position_; }
    bool ok() const { return ok_; }
    void fail() {
        ok_ = false;
        position_ = end_;
    }

private:
    const std::byte* take(std::size_t size) {
        if (size > remaining()) {
            fail();
            return nullptr;
        }
        const std::byte* at = position_;
        position_ += size;
        return at;
    }
    const std::byte* position_ = nullptr;
    const std::byte* end_ = nullptr;
    bool ok_ = true;
};

/// The types that one side has announced. Grows only, so TypeInfo pointers stay valid as long as the table. One thread at a time
/// may add; any number may read meanwhile without a lock (the client's I/O thread adds while others decode).
class TypeTable {
public:
    explicit TypeTable(TypeId first) : first_(first) {}
    TypeTable(const TypeTable&) = delete;
    TypeTable& operator=(const TypeTable&) = delete;
    ~TypeTable() {
        for (auto& chunk : chunks_) {
            delete[] chunk.load(std::memory_order_relaxed);
        }
    }
    TypeId first() const { return first_; }
    TypeId next() const { return first_ + size_.load(std::memory_order_acquire); }
    const TypeInfo* find(TypeId type) const {
        const std::uint32_t index = type - first_;
        return type >= first_ && index < size_.load(std::memory_order_acquire) ? at(index) : nullptr;
    }
    TypeId add(TypeInfo info) {
        const std::uint32_t index = size_.load(std::memory_order_relaxed);
        auto& chunk = chunks_[chunk_of(index)];
        if (!chunk.load(std::memory_order_relaxed)) {
            chunk.store(new TypeInfo[std::size_t{first_chunk} << chunk_of(index)], std::memory_order_release);
        }
        *at(index) = std::move(info);
        size_.store(index + 1, std::memory_order_release);
        return first_ + index;
    }
    /// Bytes that a payload of the type has at least. Element and field types have at least one, so that reading a value never
    /// takes more steps than it has bytes.
    std::size_t smallest_size(TypeId type) const {
        switch (type) {
        case types::null: return 0;
        case types::string: case types::bytes: case types::any: case types::list: case types::dict: case types::map: return 4;
        default: break;
        }
        if (const std::size_t size = fixed_size(type)) {
            return size;
        }
        const TypeInfo* info = find(type);
        return info && info->kind == TypeKind::structure ? info->fields.size()
             : info && info->kind <= TypeKind::enumeration ? 4 : 0;
    }
    std::uint32_t weight_of(TypeId type) const {
        const TypeInfo* info = find(type);
        return info ? info->weight : 1;
    }

private:
    // Chunk k holds first_chunk << k entries, so entry i is in the chunk of the top bit of i + first_chunk.
    static constexpr std::uint32_t first_chunk = 64;
    static constexpr std::size_t chunk_of(std::uint32_t index) { return static_cast<std::size_t>(std::bit_width(index + first_chunk)) - 7; }
    TypeInfo* at(std::uint32_t index) const {
        const std::size_t chunk = chunk_of(index);
        return chunks_[chunk].load(std::memory_order_acquire) + (index + first_chunk - (first_chunk << chunk));
    }

    TypeId first_;
    std::atomic<std::uint32_t> size_{0};
    std::array<std::atomic<TypeInfo*>, 26> chunks_{};
};

// Announcements ------------------------------------------------------------------------------------------------------------
// A stream of: u32 number (always the table's next), u8 kind, then text name, text path, u32 element, u32 key,
// u32 n fields x (text, u32 type), u32 n entries x (text, i64).

inline void encode_announcement(Encoder& out, TypeId number, const TypeInfo& info) {
    out.put(number);
    out.put(info.kind);
    out.put_text(info.name);
    out.put_text(info.path);
    out.put(info.element);
    out.put(info.key);
    out.put(static_cast<std::uint32_t>(info.fields.size()));
    for (const FieldInfo& field : info.fields) {
        out.put_text(field.name);
        out.put(field.type);
    }
    out.put(static_cast<std::uint32_t>(info.entries.size()));
    for (const EnumEntry& entry : info.entries) {
        out.put_text(entry.name);
        out.put(entry.value);
    }
}

/// Adds all announcements of a stream to the table. False if the bytes are malformed, number out of order, refer to types that
/// are not announced before, or exceed limits::max_announcements; the table then holds what was good.
inline bool decode_announcements(std::span<const std::byte> bytes, TypeTable& table) {
    Decoder in(bytes);
    const auto known = [&](TypeId type) { return type <= types::last_builtin || table.find(type) != nullptr; };
    while (in.ok() && in.remaining() != 0) {
        TypeInfo info;
        const auto number = in.get<TypeId>();
        info.kind = in.get<TypeKind>();
        info.name = std::string(in.get_text());
        info.path = std::string(in.get_text());
        info.element = in.get<TypeId>();
        info.key = in.get<TypeId>();
        for (std::uint32_t n = in.get_count(8); n != 0 && in.ok(); --n) {
            FieldInfo field;
            field.name = std::string(in.get_text());
            field.type = in.get<TypeId>();
            if (!known(field.type) || (info.kind == TypeKind::structure && table.smallest_size(field.type) == 0)) {
                return false;
            }
            info.weight += table.weight_of(field.type);
            if (info.weight > limits::max_type_weight) {
                return false;
            }
            info.fields.push_back(std::move(field));
        }
        for (std::uint32_t n = in.get_count(12); n != 0 && in.ok(); --n) {
            EnumEntry entry;
            entry.name = std::string(in.get_text());
            entry.value = in.get<std::int64_t>();
            info.entries.push_back(std::move(entry));
        }
        const bool kind_known = info.kind >= TypeKind::structure && info.kind <= TypeKind::path_shape;
        if (info.kind >= TypeKind::array && info.kind <= TypeKind::map && table.smallest_size(info.element) == 0) {
            return false;
        }
        if (!in.ok() || !kind_known || number != table.next() || !known(info.element) || !known(info.key) ||
            table.next() - table.first() >= limits::max_announcements) {
            return false;
        }
        table.add(std::move(info));
    }
    return in.ok();
}

/// The writer's side: gives each distinct TypeInfo one number and remembers the announcements not yet sent. Not thread-safe.
class TypeAnnouncer {
public:
    explicit TypeAnnouncer(TypeId first) : table_(first) {}
    const TypeTable& table() const { return table_; }

    TypeId number_of(const TypeInfo& info) {
        Encoder key;
        encode_announcement(key, 0, info);
        const std::string text(reinterpret_cast<const char*>(key.buffer.data()), key.buffer.size());
        const auto [at, is_new] = numbers_.try_emplace(text, table_.next());
        if (is_new) {
            table_.add(info);
            encode_announcement(pending_, at->second, info);
        }
        return at->second;
    }
    /// The announcements made since the last call: they go ahead of the next message.
    ByteBuffer take_pending() { return std::exchange(pending_.buffer, {}); }
    bool has_pending() const { return !pending_.buffer.empty(); }

private:
    TypeTable table_;
    std::map<std::string, TypeId, std::less<>> numbers_;
    Encoder pending_;
};

// Operations and answers ---------------------------------------------------------------------------------------------------

enum class OperationFlags : std::uint8_t {
    none = 0,
    wants_answer = 1, ///< synchronous or asynchronous; without it, only a failure is answered (fire-and-forget)
    keep_result = 2,  ///< the server keeps the result, for later operations that name this one as a future, until released
};

/// Record: u64 number, u16 entry point, u8 flags, u32 bytes, then the arguments as values.
struct OperationHeader {
    std::uint64_t number = 0; ///< counted up by the client, never 0; the name of its future
    std::uint16_t entry_point = 0; ///< index into the entry points agreed at connect
    OperationFlags flags = OperationFlags::none;
    std::uint32_t bytes = 0;
    static constexpr std::size_t size = 8 + 2 + 1 + 4;
};

inline std::size_t begin_operation(Encoder& out, std::uint64_t number, std::uint16_t entry_point, OperationFlags flags) {
    out.put(number);
    out.put(entry_point);
    out.put(flags);
    return out.reserve<std::uint32_t>();
}
inline void end_operation(Encoder& out, std::size_t at) {
    out.patch(at, static_cast<std::uint32_t>(out.buffer.size() - at - sizeof(std::uint32_t)));
}
/// The header of an operation that decode_operation_header has checked before.
inline OperationHeader load_operation_header(const std::byte* at) {
    OperationHeader header;
    std::memcpy(&header.number, at, 8);
    std::memcpy(&header.entry_point, at + 8, 2);
    std::memcpy(&header.flags, at + 10, 1);
    std::memcpy(&header.bytes, at + 11, 4);
    return header;
}
/// All of an operation.
inline void put_operation(Encoder& out, std::uint64_t number, std::uint16_t entry_point, OperationFlags flags, const std::byte* arguments, std::size_t size) {
    std::byte* const at = out.buffer.extend(OperationHeader::size + size);
    const auto bytes = static_cast<std::uint32_t>(size);
    std::memcpy(at, &number, 8);
    std::memcpy(at + 8, &entry_point, 2);
    std::memcpy(at + 10, &flags, 1);
    std::memcpy(at + 11, &bytes, 4);
    if (size != 0) {
        std::memcpy(at + 15, arguments, size);
    }
}
inline OperationHeader decode_operation_header(Decoder& in) {
    OperationHeader header;
    header.number = in.get<std::uint64_t>();
    header.entry_point = in.get<std::uint16_t>();
    header.flags = in.get<OperationFlags>();
    header.bytes = in.get<std::uint32_t>();
    if (header.bytes > in.remaining()) {
        in.fail();
    }
    return header;
}

/// A batch's releases are numbers of operations whose results the server forgets. One with this bit is the first of a range, and the
/// next entry says how many numbers it has.
inline constexpr std::uint64_t release_range = std::uint64_t{1} << 63;

/// pending: a latent function has begun; the error in its payload is what a client raises that cannot wait for it
/// (engine_service.wait_for_result).
enum class AnswerState : std::uint8_t { succeeded = 0, failed = 1, pending = 2 };

/// Record: u64 number, u8 state, u32 bytes, then a value (succeeded), or an error (u16 code, four texts).
inline constexpr std::size_t answer_header_size = 8 + 1 + 4;
inline void store_answer_header(std::byte* at, std::uint64_t number, AnswerState state, std::uint32_t bytes) {
    std::memcpy(at, &number, 8);
    std::memcpy(at + 8, &state, 1);
    std::memcpy(at + 9, &bytes, 4);
}
inline std::size_t begin_answer(Encoder& out, std::uint64_t number, AnswerState state) {
    out.put(number);
    out.put(state);
    return out.reserve<std::uint32_t>();
}
inline std::size_t begin_answer(Encoder& out, std::uint64_t number, bool failed) {
    return begin_answer(out, number, failed ? AnswerState::failed : AnswerState::succeeded);
}
inline void end_answer(Encoder& out, std::size_t at) { end_operation(out, at); }

inline void encode_error(Encoder& out, const ErrorInfo& error) {
    out.put(error.code);
    out.put_text(error.message);
    out.put_text(error.operation);
    out.put_text(error.argument);
    out.put_text(error.expected);
}
inline ErrorInfo decode_error(Decoder& in) {
    ErrorInfo error;
    error.code = in.get<ErrorCode>();
    error.message = std::string(in.get_text());
    error.operation = std::string(in.get_text());
    error.argument = std::string(in.get_text());
    error.expected = std::string(in.get_text());
    return error;
}

// Skipping ------------------------------------------------------------------------------------------------------------------

/// Both tables of a session: enough to read any value of it.
struct TypeTables {
    const TypeTable* client = nullptr;
    const TypeTable* server = nullptr;
    const TypeInfo* find(TypeId type) const {
        return type >= types::first_server_type ? (server ? server->find(type) : nullptr) : (client ? client->find(type) : nullptr);
    }
};

/// Moves past one payload of the type; the decoder fails on anything malformed, too deep, or of unknown type.
inline void skip_payload(Decoder& in, TypeId type, const TypeTables& tables, std::size_t depth = 0) {
    if (depth > limits::max_value_depth) {
        in.fail();
        return;
    }
    const auto skip_value = [&] { skip_payload(in, in.get<TypeId>(), tables, depth + 1); };
    switch (type) {
    case types::null: return;
    case types::string: (void)in.get_text(); return;
    case types::bytes: (void)in.get_raw(in.get<std::uint32_t>()); return;
    case types::any: skip_value(); return;
    case types::list:
        for (std::uint32_t n = in.get_count(4); n != 0 && in.ok(); --n) skip_value();
        return;
    case types::dict:
        for (std::uint32_t n = in.get_count(8); n != 0 && in.ok(); --n) {
            (void)in.get_text();
            skip_value();
        }
        return;
    case types::map:
        for (std::uint32_t n = in.get_count(8); n != 0 && in.ok(); --n) {
            skip_value();
            skip_value();
        }
        return;
    default: break;
    }
    if (const std::size_t size = fixed_size(type)) {
        (void)in.get_raw(size);
        return;
    }
    const TypeInfo* info = tables.find(type);
    if (!info) {
        in.fail();
        return;
    }
    switch (info->kind) {
    case TypeKind::structure:
        for (const FieldInfo& field : info->fields) skip_payload(in, field.type, tables, depth + 1);
        return;
    case TypeKind::array:
    case TypeKind::set:
        for (std::uint32_t n = in.get_count(1); n != 0 && in.ok(); --n)
            skip_payload(in, info->element, tables, depth + 1);
        return;
    case TypeKind::map:
        for (std::uint32_t n = in.get_count(1); n != 0 && in.ok(); --n) {
            skip_payload(in, info->key, tables, depth + 1);
            skip_payload(in, info->element, tables, depth + 1);
        }
        return;
    case TypeKind::enumeration: (void)in.get_raw(8); return;
    default: in.fail(); return;
    }
}

} // namespace spear
