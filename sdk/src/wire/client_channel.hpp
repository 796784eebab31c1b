// SPDX-License-Identifier: MIT
#pragma once

// The client's half of a shared memory channel.

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "channel.hpp"
#include "spear_wire.h"

namespace spear::wire {

class ClientChannel {
public:
    ClientChannel(std::unique_ptr<ChannelRegion> region, std::size_t max_message_bytes, bool spins);

    /// Any thread. Returns whether some of it found no room: then call flush() until that returns true.
    bool submit(std::uint64_t request, const spear_batch& batch);
    bool flush();

    // One thread at a time, as in spear_wire.h.
    bool call(const spear_call& call);
    int take_call(bool spin, spear_call_answer& answer);
    int take(std::uint64_t& request, spear_answers& answers);
    void wait(std::uint32_t wakes, std::uint32_t timeout_us);

    /// Whether answers wait at the server for room in the ring.
    bool more_is_coming() const noexcept { return load_ordered(&header_.server_wants_room) != 0; }

    std::uint32_t wakes() const noexcept { return wakes_.load(); }
    void wake() noexcept;

    spear_traffic sent() const noexcept { return sent_.read() + calls_sent_.read(); }
    spear_traffic received() const noexcept { return received_.read() + calls_received_.read(); }

private:
    void wake_server(bool block);
    bool is_call_answered() const noexcept {
        return is_calling_.load(std::memory_order_relaxed) &&
               load_acquire(&header_.answer.sequence) == calls_.load(std::memory_order_relaxed);
    }

    const std::unique_ptr<ChannelRegion> region_;
    ChannelHeader& header_;
    std::mutex write_mutex_;
    TrafficCounter sent_; // counted under write_mutex_
    TrafficCounter calls_sent_, calls_received_; // counted by who calls
    TrafficCounter received_; // counted by who takes
    ChannelWriter writer_;
    std::atomic<bool> wants_room_{false};
    ChannelReader reader_;
    std::string error_text_; ///< of the answers taken last
    std::atomic<std::uint32_t> calls_{0};     ///< sequence of the last call
    std::atomic<bool> is_calling_{false};     ///< its answer was not taken yet
    std::uint8_t answer_[sizeof(ChannelCallAnswer::answer)]; ///< the answer to a call that was taken last
    std::atomic<std::uint32_t> wakes_{0};
    Spinner spinner_;
};

} // namespace spear::wire
