// SPDX-License-Identifier: MIT
#pragma once

// What both ends of the shared memory channel are made of: the region, a stream in a ring, sleeping words, and the
// measure of whether spinning pays. The layout is channel_layout.hpp's. Nothing here knows sessions or RPC.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "channel_layout.hpp"
#include "spear_wire.h"

namespace spear::wire {

/// Integers in shared memory, or like such.
template <typename T>
T load_acquire(const T* at) {
    return __atomic_load_n(at, __ATOMIC_ACQUIRE);
}
template <typename T>
T load_ordered(const T* at) { // sequentially consistent
    return __atomic_load_n(at, __ATOMIC_SEQ_CST);
}
template <typename T>
void store_release(T* at, T value) {
    __atomic_store_n(at, value, __ATOMIC_RELEASE);
}
template <typename T>
void store_ordered(T* at, T value) {
    __atomic_store_n(at, value, __ATOMIC_SEQ_CST);
}

/// Waits on a futex word while it has that value, at most as long as that. Returns early for no reason now and then.
void futex_wait(std::uint32_t* word, std::uint32_t value, std::uint32_t timeout_us);
void futex_wake(std::uint32_t* word);

/// Wakes who sleeps on the word, if anybody does. After a store_ordered of what the sleeper looks for.
inline void wake_sleeper(std::uint32_t* word) {
    if (load_ordered(word) != 0 && __atomic_exchange_n(word, 0u, __ATOMIC_SEQ_CST) != 0) {
        futex_wake(word);
    }
}

/// A region of shared memory, mapped.
class ChannelRegion {
public:
    /// The server's: a new region with a random name, a random nonce, mode 0600 and all its memory reserved. Null, and
    /// `why` filled, if there cannot be one.
    static std::unique_ptr<ChannelRegion> create(std::string& why);
    /// The client's: maps a region of that name and checks its header. Null, and `why` filled, if it cannot.
    static std::unique_ptr<ChannelRegion> open(const std::string& name, std::string& why);
    /// Unlinks the name, if create() made it and unlink() was not called.
    ~ChannelRegion();
    ChannelRegion(const ChannelRegion&) = delete;
    ChannelRegion& operator=(const ChannelRegion&) = delete;

    /// Nobody finds the region any more; both mappings stay.
    void unlink() noexcept;
    const std::string& name() const noexcept { return name_; }
    ChannelHeader& header() noexcept;
    std::byte* to_server() noexcept;
    std::byte* to_client() noexcept;
    /// Own copy of the nonce: the client could write to the region's.
    const std::uint8_t* nonce() const noexcept { return nonce_; }

    /// Removes the regions that killed servers of this user left between making one and hearing from the client, and
    /// tells their names.
    static void remove_leftovers(const std::function<void(const std::string& name)>& removed);

private:
    struct Mapping;
    ChannelRegion();
    std::string name_;
    bool linked_ = false;
    std::uint8_t nonce_[channel_nonce_bytes] = {};
    std::unique_ptr<Mapping> mapping_;
};

struct Bytes {
    const void* data;
    std::size_t size;
};

/// The writing end of a ring, with a queue for what does not fit. One thread at a time.
class ChannelWriter {
public:
    /// `cpu`: where to note the core it writes on; may be null.
    ChannelWriter(std::byte* ring, std::uint64_t* tail, const std::uint64_t* head, std::size_t ring_bytes,
        std::uint32_t* cpu = nullptr)
        : ring_(ring), tail_(tail), head_(head), ring_bytes_(ring_bytes), cpu_(cpu) {}

    /// Appends the parts, in this order, and publishes them. What does not fit waits for flush(). Throws
    /// std::bad_alloc, and then nothing was written.
    void write(std::initializer_list<Bytes> parts);
    /// Moves waiting bytes into the ring as far as there is room. True if none are left.
    bool flush();
    std::size_t waiting_bytes() const noexcept { return waiting_.size() - waiting_from_; }
    /// The reader's position was impossible: it tampers. Nothing is written any more.
    bool broken() const noexcept { return broken_; }

private:
    std::size_t room();
    void put(const std::byte* data, std::size_t size);
    void publish();

    std::byte* const ring_;
    std::uint64_t* const tail_;
    const std::uint64_t* const head_;
    const std::size_t ring_bytes_;
    std::uint32_t* const cpu_;
    std::uint64_t written_ = 0; ///< our tail; what is in memory is only for the reader
    std::uint64_t published_ = 0;
    std::uint64_t seen_head_ = 0;
    bool broken_ = false;
    std::vector<std::byte> waiting_;
    std::size_t waiting_from_ = 0;
};

/// The reading end. One thread at a time, except has_news().
class ChannelReader {
public:
    ChannelReader(const std::byte* ring, const std::uint64_t* tail, std::uint64_t* head, std::size_t ring_bytes,
        std::size_t max_message_bytes)
        : ring_(ring), tail_(tail), head_(head), ring_bytes_(ring_bytes), max_message_bytes_(max_message_bytes) {}

    enum class Result { nothing, message, malformed };
    /// The next whole message, copied out of the ring; valid until the next call. Its first 8 bytes are its size.
    Result next();
    const std::byte* data() const noexcept { return message_.get(); }
    std::size_t size() const noexcept { return message_size_; }
    /// Whether the writer has written anything not yet read. Any thread.
    bool has_news() const noexcept { return load_ordered(tail_) != read_.load(std::memory_order_relaxed); }

private:
    void take(std::size_t size);

    const std::byte* const ring_;
    const std::uint64_t* const tail_;
    std::uint64_t* const head_;
    const std::size_t ring_bytes_;
    const std::size_t max_message_bytes_;
    std::atomic<std::uint64_t> read_{0}; ///< our head; what is in memory is only for the writer
    bool broken_ = false;
    std::unique_ptr<std::byte[]> message_;
    std::size_t capacity_ = 0;
    std::size_t have_ = 0;         ///< bytes of a message that has not arrived as a whole
    std::size_t message_size_ = 0; ///< 0: not known yet
};

/// Whether to spin before sleeping, from how the last waits ended.
class Spinner {
public:
    /// Off on one core, or by SPEAR_SPIN=off.
    explicit Spinner(bool wanted) : enabled_(wanted && allowed()) {}
    static bool allowed();
    /// 1 + the core this thread runs on.
    static std::uint32_t this_cpu();

    /// Spins until `arrived`, if that has paid lately, and the other side did not run on this very core just now: then
    /// it cannot run while we spin. Returns whether it arrived.
    template <typename F>
    bool spin(const std::uint32_t* other_cpu, F&& arrived) {
        if (!enabled_ || (other_cpu && __atomic_load_n(other_cpu, __ATOMIC_RELAXED) == this_cpu()) || !worth_it()) {
            return false;
        }
        std::uint64_t ends = 0; // the clock is asked only when the answer takes longer than a usual one
        for (;;) {
            for (int i = 0; i < 64; ++i) {
                if (arrived()) {
                    misses_ = 0;
                    return true;
                }
                pause();
            }
            const std::uint64_t now = now_ns();
            ends = ends != 0 ? ends : now + spin_ns;
            if (now >= ends) {
                break;
            }
        }
        misses_ = misses_ < give_up_after ? misses_ + 1 : misses_;
        return false;
    }

    /// Spins for some microseconds without asking the clock, in the middle of something. A miss does not count.
    template <typename F>
    bool spin_briefly(const std::uint32_t* other_cpu, F&& arrived) {
        if (!enabled_ || misses_ >= give_up_after || __atomic_load_n(other_cpu, __ATOMIC_RELAXED) == this_cpu()) {
            return false;
        }
        for (int i = 0; i < 256; ++i) {
            if (arrived()) {
                misses_ = 0;
                return true;
            }
            pause();
        }
        return false;
    }

private:
    static constexpr std::uint64_t spin_ns = 50'000;
    static constexpr unsigned give_up_after = 4, try_again_every = 16;
    bool worth_it() { return misses_ < give_up_after || ++skipped_ % try_again_every == 0; }
    static std::uint64_t now_ns();
    static void pause() {
#if defined(__x86_64__) || defined(__i386__)
        __builtin_ia32_pause();
#elif defined(__aarch64__)
        asm volatile("yield");
#endif
    }

    const bool enabled_;
    unsigned misses_ = 0, skipped_ = 0;
};

/// Tells the other side which core this thread runs on, if that has changed.
inline void note_cpu(std::uint32_t* at) {
    if (const std::uint32_t cpu = Spinner::this_cpu(); cpu != __atomic_load_n(at, __ATOMIC_RELAXED)) {
        __atomic_store_n(at, cpu, __ATOMIC_RELAXED);
    }
}

/// Counts the messages of one way. One thread at a time counts, any thread reads.
class TrafficCounter {
public:
    void add(std::uint64_t bytes) noexcept {
        messages_.store(messages_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
        bytes_.store(bytes_.load(std::memory_order_relaxed) + bytes, std::memory_order_relaxed);
    }
    spear_traffic read() const noexcept {
        return {messages_.load(std::memory_order_relaxed), bytes_.load(std::memory_order_relaxed)};
    }
    static std::uint64_t bytes_of(const spear_batch& batch) noexcept {
        return batch.types.size + batch.operations.size + batch.release_count * sizeof(std::uint64_t);
    }
    static std::uint64_t bytes_of(const spear_answers& answers) noexcept {
        return answers.types.size + answers.answers.size;
    }

private:
    std::atomic<std::uint64_t> messages_{0}, bytes_{0};
};

inline spear_traffic operator+(const spear_traffic& a, const spear_traffic& b) {
    return {a.messages + b.messages, a.bytes + b.bytes};
}

/// False if the environment variable is "off", "0", "no" or "false".
bool setting_is_on(const char* variable);

} // namespace spear::wire
