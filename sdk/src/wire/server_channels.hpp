// SPDX-License-Identifier: MIT
#pragma once

// The server's half of the shared memory channels: who reads which ring when, and who wakes whom.
//
// Each channel has exactly one reader at a time (its mutex): the game thread while it waits for the session in an open
// transaction, so that operations need no hop through another thread; otherwise the channel's own watcher thread, which
// sleeps until the client wakes it. The header's game_thread_reads tells the client whom to wake. Batches of blocks
// wake nobody between frames: the game thread looks at all rings at the beginning and at the end of each frame.

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "channel.hpp"
#include "spear_wire.h"

namespace spear::wire {

/// What a channel tells its server.
struct ChannelEvents {
    /// A batch; the pointers are valid during the call. Any thread, one at a time for each session.
    std::function<void(std::uint64_t session, std::uint64_t request, const spear_batch& batch)> submit;
    /// The session must end: its client broke the rules. Any thread.
    std::function<void(std::uint64_t session, const char* reason)> drop;
};

class ServerChannel {
public:
    ServerChannel(std::uint64_t session, std::unique_ptr<ChannelRegion> region, std::size_t max_message_bytes,
        const ChannelEvents& events);
    ~ServerChannel();
    ServerChannel(const ServerChannel&) = delete;
    ServerChannel& operator=(const ServerChannel&) = delete;

    std::uint64_t session() const noexcept { return session_; }
    const std::string& name() const noexcept { return region_->name(); }

    /// The client has given back this nonce: if it is right, both see the same memory, and the channel opens.
    bool confirm(const void* nonce, std::size_t size, bool client_spins);
    /// Nothing is read or submitted any more once this has returned. Not from within events.
    void close();

    /// Hands what has arrived to events.submit. Returns the number of batches; none if another thread is at it.
    std::size_t pump();
    bool has_news() const noexcept { return reader_.has_news(); }
    /// Any thread.
    void reply(std::uint64_t request, const spear_answers& answers);
    void set_wake_for_blocks(bool wanted) noexcept;
    spear_traffic received() const noexcept { return received_.read() + calls_received_.read(); }
    spear_traffic sent() const noexcept { return sent_.read() + calls_sent_.read(); }

    // Game thread.
    void claim() noexcept;
    void release() noexcept;
    /// Waits for the client or wake_game_thread(), as long as `idle` is true; says in `sleeps` when it does not spin.
    template <typename F>
    void wait(std::uint32_t timeout_us, F&& idle, std::atomic<bool>& sleeps);
    bool has_call() const noexcept { return load_acquire(&header_.call.sequence) == calls_ + 1; }
    /// Takes the call that has arrived; false, and the session ends, if it is none.
    bool take_call(spear_call& call);
    void answer_call(const spear_call_answer& answer);
    /// Ends the session if it has made a call that nobody may take now.
    void refuse_call();
    /// Any thread.
    void wake_game_thread() noexcept { wake_sleeper(&header_.game_thread_sleeps); }

private:
    void watch();
    bool watcher_has_work() const noexcept;
    void wake_watcher() noexcept { wake_sleeper(&header_.watcher_sleeps); }
    void deliver();

    const std::uint64_t session_;
    const std::unique_ptr<ChannelRegion> region_;
    ChannelHeader& header_;
    const ChannelEvents& events_;
    std::atomic<bool> closed_{false};
    std::atomic<bool> game_thread_reads_{false}; ///< header_'s is for the client only

    std::mutex read_mutex_; ///< the reader of the moment
    ChannelReader reader_;
    bool dropped_ = false;    ///< under read_mutex_
    TrafficCounter received_; ///< counted under read_mutex_

    std::mutex write_mutex_;
    ChannelWriter writer_;
    TrafficCounter sent_; ///< counted under write_mutex_
    std::atomic<bool> wants_room_{false};

    std::unique_ptr<Spinner> spinner_; ///< game thread
    TrafficCounter calls_received_, calls_sent_; ///< game thread counts
    std::uint32_t calls_ = 0;                    ///< game thread: taken
    std::uint64_t call_number_ = 0;    ///< game thread: of the one taken last
    alignas(16) std::uint8_t call_[sizeof(ChannelCall::arguments)]; ///< game thread: likewise
    std::thread watcher_;
};

/// All channels of a server.
class ServerChannels {
public:
    explicit ServerChannels(ChannelEvents events) : events_(std::move(events)) {}

    /// Server thread. A channel whose client has not yet confirmed it; null with `why` if there cannot be one.
    std::shared_ptr<ServerChannel> offer(std::uint64_t session, std::size_t max_message_bytes, std::string& why);
    void add(std::shared_ptr<ServerChannel> channel);
    void remove(std::uint64_t session);
    /// With those of RPC: with several sessions the order of arrival matters.
    void set_session_count(std::size_t count);

    /// Any thread. False if the session has no channel.
    bool reply(std::uint64_t session, std::uint64_t request, const spear_answers& answers);
    bool has(std::uint64_t session) const { return find(session) != nullptr; }
    /// Any thread. Nothing if the session has no channel.
    void get_traffic(std::uint64_t session, spear_traffic& received, spear_traffic& sent) const;

    // Game thread.
    void poll();
    void wait(std::uint64_t session, std::uint32_t timeout_ms);
    bool wait_call(std::uint64_t session, std::uint32_t timeout_ms, spear_call& call);
    void answer_call(std::uint64_t session, const spear_call_answer& answer);
    void release();
    /// Any thread: ends a wait().
    void wake();

private:
    std::shared_ptr<ServerChannel> find(std::uint64_t session) const;
    void claim(std::uint64_t session);

    const ChannelEvents events_;
    mutable std::mutex mutex_;
    std::map<std::uint64_t, std::shared_ptr<ServerChannel>> channels_; // under mutex_
    std::size_t sessions_ = 0;                                         // under mutex_
    bool is_polled_ = false;                                           // under mutex_: there is a game thread
    std::atomic<std::uint32_t> changes_{0};                            // of channels_

    std::atomic<std::uint32_t> wakes_{0};
    std::atomic<bool> waits_{false};             // the game thread is about to sleep, or sleeps
    std::atomic<std::thread::id> game_thread_{}; // relaxed: each thread looks only for itself
    std::vector<std::shared_ptr<ServerChannel>> polled_; // game thread, in poll(): with its memory
    std::uint32_t seen_wakes_ = 0;               // game thread
    std::uint32_t seen_changes_ = 0;             // game thread
    std::shared_ptr<ServerChannel> claimed_;     // game thread
    std::uint64_t claimed_session_ = 0;          // game thread: also of a session without channel
    std::mutex sleep_mutex_;
    std::shared_ptr<ServerChannel> sleeps_at_; // under sleep_mutex_: claimed_
    std::uint32_t sleeps_ = 0;                 // sleeping word for sessions without a channel
};

} // namespace spear::wire
