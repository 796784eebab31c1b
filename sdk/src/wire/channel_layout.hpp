// SPDX-License-Identifier: MIT
#pragma once

// The shared memory channel, byte for byte (docs/protocol.md, "The channel"). One region per session; client and server
// may be built by different compilers, so everything here is an integer at a stated offset, little-endian.
//
//      0  ChannelHeader (4096 bytes)
//   4096  ring client -> server, ring_bytes
//      +  ring server -> client, ring_bytes
//
// A ring is a stream of bytes with one writer and one reader. `tail` counts the bytes ever written, `head` those ever
// read; a byte with number n lies at n modulo ring_bytes. In the stream are messages, each a multiple of 8 bytes. A
// message larger than what is free is written piece by piece.
//
// Sleeping words: who is about to sleep writes 1, looks once more for what it waits for, then waits on the word as a
// Linux futex (not private) while it is 1. Who has written to the ring and finds it not 0 writes 0 and wakes the
// sleepers. Both sides store and load here sequentially consistent, so one of them sees the other.
//
// Beside the rings each direction has a place for one call and one answer (ChannelCall, ChannelCallAnswer): a synchronous
// operation in a block whose game thread already waits for the client. Number and contents stand in one cache line if
// they are small, so a round trip costs two transfers of a line and nothing else. Client and server take turns: the
// client writes a call and then its number into `sequence`; the server, the answer and then the same number.
//
// Neither side believes the other: each keeps its own position to itself and checks the other's, and copies a message
// out of the ring (a call, out of its place) before it looks at it.

#include <cstddef>
#include <cstdint>

namespace spear::wire {

inline constexpr std::uint64_t channel_magic = 0x314e414843525053; // "SPRCHAN1"
inline constexpr std::uint32_t channel_layout_version = 2;
inline constexpr std::size_t channel_header_bytes = 4096;
inline constexpr std::size_t channel_nonce_bytes = 32;
/// Bytes of each ring: a power of two. Small enough for a second-level cache, large enough for a block of some thousand
/// operations at once.
inline constexpr std::size_t channel_ring_bytes = 256u << 10;
inline constexpr std::size_t channel_region_bytes = channel_header_bytes + 2 * channel_ring_bytes;

/// A call, client to server. The arguments' bytes follow the head at once.
struct ChannelCall {
    std::uint32_t sequence; ///< counts up from 1 with each call; written last
    std::uint16_t arguments_bytes;
    std::uint16_t entry_point; ///< index into the entry points agreed at connect
    std::uint64_t number;      ///< of the operation
    std::uint8_t arguments[1008];
};
static_assert(sizeof(ChannelCall) == 1024 && offsetof(ChannelCall, arguments_bytes) == 4);
static_assert(offsetof(ChannelCall, entry_point) == 6 && offsetof(ChannelCall, number) == 8);
static_assert(offsetof(ChannelCall, arguments) == 16);

/// Its answer, server to client.
struct ChannelCallAnswer {
    std::uint32_t sequence; ///< of the call; written last
    std::uint16_t answer_bytes;
    std::uint16_t state; ///< CallState
    std::uint64_t frame; ///< in which it ran
    std::uint8_t answer[1008];
};
static_assert(sizeof(ChannelCallAnswer) == 1024 && offsetof(ChannelCallAnswer, answer_bytes) == 4);
static_assert(offsetof(ChannelCallAnswer, state) == 6 && offsetof(ChannelCallAnswer, frame) == 8);
static_assert(offsetof(ChannelCallAnswer, answer) == 16);

/// How a call ended. Answers that are too large for their place, or that need announcements, go through the ring.
enum class CallState : std::uint16_t {
    succeeded = 1, ///< the answer is a value
    failed = 2,    ///< the answer is an error
    in_ring = 3,   ///< the ring has it, as answers to the request `call_request | number`, or `| call_failed` as well
};
inline constexpr std::uint64_t call_request = std::uint64_t{1} << 63;
inline constexpr std::uint64_t call_failed = std::uint64_t{1} << 62;

struct ChannelHeader {
    // Written by the server before the client hears of the region, constant afterwards.
    std::uint64_t magic;
    std::uint32_t layout_version;
    std::uint32_t ring_bytes;
    std::uint8_t nonce[channel_nonce_bytes];

    // Positions and words lie apart by two cache lines (processors fetch lines in pairs).
    alignas(128) std::uint64_t to_server_tail; ///< written by the client
    std::uint32_t
        client_cpu; ///< client: 1 + the core it wrote on last; beside the tail, which the other side reads anyway
    alignas(128) std::uint64_t to_server_head;    ///< written by the server
    alignas(128) std::uint64_t to_client_tail;    ///< written by the server
    std::uint32_t server_cpu;                     ///< server: likewise
    alignas(128) std::uint64_t to_client_head;    ///< written by the client
    alignas(128) std::uint32_t game_thread_reads; ///< server: 1 while the game thread reads, 0: the watcher thread
    std::uint32_t wake_for_blocks;                ///< server: 1 if the watcher is to be woken for batches of blocks too
    std::uint32_t server_wants_room; ///< server: 1 while answers wait for room; the client wakes the watcher
    alignas(128) std::uint32_t game_thread_sleeps; ///< sleeping word
    alignas(128) std::uint32_t watcher_sleeps;     ///< sleeping word
    alignas(128) std::uint32_t client_sleeps;      ///< sleeping word
    alignas(128) ChannelCall call;                 ///< written by the client
    alignas(128) ChannelCallAnswer answer;         ///< written by the server
    alignas(128) std::uint8_t reserved[channel_header_bytes - 3200];
};
static_assert(sizeof(ChannelHeader) == channel_header_bytes);
static_assert(offsetof(ChannelHeader, magic) == 0 && offsetof(ChannelHeader, layout_version) == 8);
static_assert(offsetof(ChannelHeader, ring_bytes) == 12 && offsetof(ChannelHeader, nonce) == 16);
static_assert(offsetof(ChannelHeader, to_server_tail) == 128 && offsetof(ChannelHeader, to_server_head) == 256);
static_assert(offsetof(ChannelHeader, to_client_tail) == 384 && offsetof(ChannelHeader, to_client_head) == 512);
static_assert(offsetof(ChannelHeader, client_cpu) == 136 && offsetof(ChannelHeader, server_cpu) == 392);
static_assert(offsetof(ChannelHeader, game_thread_reads) == 640 && offsetof(ChannelHeader, wake_for_blocks) == 644);
static_assert(offsetof(ChannelHeader, server_wants_room) == 648 && offsetof(ChannelHeader, game_thread_sleeps) == 768);
static_assert(offsetof(ChannelHeader, watcher_sleeps) == 896 && offsetof(ChannelHeader, client_sleeps) == 1024);
static_assert(offsetof(ChannelHeader, call) == 1152 && offsetof(ChannelHeader, answer) == 2176);
static_assert((channel_ring_bytes & (channel_ring_bytes - 1)) == 0);

/// A batch of operations, client to server. Then: releases (u64 each), operations, types, zeros to a multiple of 8.
struct ChannelBatch {
    std::uint64_t bytes; ///< of the whole message with this header
    std::uint64_t request;
    std::uint64_t transaction;
    std::uint8_t block;
    std::uint8_t closes;
    std::uint8_t abort;
    std::uint8_t single_step;
    std::uint32_t release_count;
    std::uint32_t operations_bytes;
    std::uint32_t types_bytes;
};
static_assert(sizeof(ChannelBatch) == 40 && offsetof(ChannelBatch, block) == 24);
static_assert(offsetof(ChannelBatch, release_count) == 28 && offsetof(ChannelBatch, operations_bytes) == 32);

/// The answers to a batch, server to client. Then: answers, types, text of the error, zeros to a multiple of 8.
struct ChannelAnswers {
    std::uint64_t bytes; ///< of the whole message with this header
    std::uint64_t request;
    std::uint64_t frame;
    std::uint32_t answers_bytes;
    std::uint32_t types_bytes;
    std::uint32_t error_bytes;
    std::uint16_t error_code;
    std::uint16_t has_error;
};
static_assert(sizeof(ChannelAnswers) == 40 && offsetof(ChannelAnswers, answers_bytes) == 24);
static_assert(offsetof(ChannelAnswers, error_bytes) == 32 && offsetof(ChannelAnswers, error_code) == 36);

} // namespace spear::wire
