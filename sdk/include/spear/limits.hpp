// SPDX-License-Identifier: MIT
#pragma once

// Every limit of SPEAR, in one table. Client and server compile the same table; the server enforces it, because a client is never
// trusted. Each limit has a test that exceeds it: tests/end_to_end/server_limits.cpp, those of leases in tests/sdk/session_test.cpp.

#include <cstddef>
#include <cstdint>

namespace spear::limits {

/// Bytes of one message on the wire (one batch of operations, or its answers). Stops a client from making the engine allocate
/// without bound. Bulk data belongs in shared memory. Sane values: 1 MiB to 1 GiB.
inline constexpr std::size_t max_message_bytes = 256u << 20;

/// Operations in one block. A block is executed within one frame, so this bounds the length of a frame.
inline constexpr std::size_t max_operations_per_block = 1'000'000;

/// Nesting of values (lists in dictionaries in structs ...). Bounds the recursion of every decoder.
inline constexpr std::size_t max_value_depth = 64;

/// Bytes of one string (a name, a path, a text).
inline constexpr std::size_t max_string_bytes = 16u << 20;

/// Elements of one array, set or map.
inline constexpr std::size_t max_elements = 64u << 20;

/// Types, call shapes and property paths that one session may announce.
inline constexpr std::size_t max_announcements = 1u << 20;

/// Bytes of memory that the values of one operation may take in the engine. A list of empty dictionaries is short on the wire and
/// long as an array of large structs.
inline constexpr std::size_t max_decoded_bytes = std::size_t{1} << 30;

/// Values inside one value of an announced structure. Without it a few small announcements, each with two fields of the one
/// before, would describe a value of no bytes and 2^64 parts.
inline constexpr std::uint32_t max_type_weight = 1u << 14;

/// Results kept in the server for futures that the client still holds.
inline constexpr std::size_t max_kept_results = 1u << 20;

/// Segments of one property path, "A.B[3].C" has four.
inline constexpr std::size_t max_path_segments = 64;

/// Transactions that one session may have queued in the server; the SDK itself never has more than two.
inline constexpr std::size_t max_queued_transactions = 8;

/// Bytes of batches that one session may have queued in the server, waiting for their frame.
inline constexpr std::size_t max_queued_bytes = 2 * max_message_bytes;

/// Sessions of one engine at a time.
inline constexpr std::size_t max_sessions = 64;

/// The lease of a session in milliseconds: a client that sends nothing for so long is taken for dead, its transaction is aborted
/// and the game thread goes on. The SDK renews it from its own thread every third of it, so slow user code never expires it.
inline constexpr std::uint32_t default_lease_ms = 5'000;
inline constexpr std::uint32_t min_lease_ms = 100;
inline constexpr std::uint32_t max_lease_ms = 3'600'000;

/// How long a client waits for an answer before it asks the server why, and raises, in milliseconds.
inline constexpr std::uint32_t default_deadline_ms = 30'000;

/// The longest sleep of the game thread while it waits for a client; then it feeds the engine's heartbeat and looks whether the
/// engine exits.
inline constexpr std::uint32_t game_thread_wake_ms = 10;

/// Events of one thread in a trace (40 bytes each, taken as they are used). What finds no room is dropped and counted.
inline constexpr std::uint64_t max_trace_events = 1u << 22;

} // namespace spear::limits
