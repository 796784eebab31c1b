// SPDX-License-Identifier: MIT
#include "server_channels.hpp"

#include <chrono>
#include <csignal>
#include <cstring>
#include <utility>
#include <vector>

#include <pthread.h>

#include "spear/limits.hpp"
#include "spear_trace.h"

namespace spear::wire {
namespace {

/// One reader does not stay with one client for ever.
constexpr std::size_t most_batches_at_once = 256;
/// A watcher that is woken for nothing so often in a row has a client that plays with it.
constexpr unsigned patience = 64;
constexpr std::uint32_t watcher_sleep_us = 200'000;
constexpr char zeros[8] = {};

std::size_t padding(std::size_t size) { return (8 - size % 8) % 8; }

} // namespace

// ServerChannel

ServerChannel::ServerChannel(std::uint64_t session, std::unique_ptr<ChannelRegion> region,
    std::size_t max_message_bytes, const ChannelEvents& events)
    : session_(session), region_(std::move(region)), header_(region_->header()), events_(events),
      reader_(region_->to_server(), &header_.to_server_tail, &header_.to_server_head, channel_ring_bytes,
          max_message_bytes + (1u << 20)),
      writer_(region_->to_client(), &header_.to_client_tail, &header_.to_client_head, channel_ring_bytes,
          &header_.server_cpu) {}

ServerChannel::~ServerChannel() { close(); }

bool ServerChannel::confirm(const void* nonce, std::size_t size, bool client_spins) {
    const bool right = size == channel_nonce_bytes && std::memcmp(nonce, region_->nonce(), channel_nonce_bytes) == 0;
    region_->unlink();
    if (right) {
        spinner_ = std::make_unique<Spinner>(client_spins);
        watcher_ = std::thread([this] { watch(); });
    }
    return right;
}

void ServerChannel::close() {
    {
        const std::lock_guard lock(read_mutex_);
        closed_ = true;
    }
    if (watcher_.joinable()) {
        __atomic_exchange_n(&header_.watcher_sleeps, 0u, __ATOMIC_SEQ_CST);
        futex_wake(&header_.watcher_sleeps);
        watcher_.join();
    }
}

std::size_t ServerChannel::pump() {
    const std::unique_lock lock(read_mutex_, std::try_to_lock);
    if (!lock) {
        return 0;
    }
    std::size_t count = 0;
    try {
        while (count < most_batches_at_once && !closed_ && !dropped_) {
            const ChannelReader::Result result = reader_.next();
            if (result == ChannelReader::Result::nothing) {
                break;
            }
            if (result == ChannelReader::Result::message) {
                deliver();
            } else {
                dropped_ = true;
            }
            ++count;
        }
        if (dropped_ && !closed_) {
            events_.drop(session_, "MalformedMessage: the bytes in the shared memory channel are not of this protocol");
        }
    } catch (const std::bad_alloc&) {
        dropped_ = true;
        events_.drop(session_, "the engine had no memory for a batch");
    }
    return count;
}

/// One message, checked: it has been copied out of the ring.
void ServerChannel::deliver() {
    ChannelBatch head{};
    std::memcpy(&head, reader_.data(), sizeof(head));
    const std::uint64_t releases = std::uint64_t{head.release_count} * sizeof(std::uint64_t);
    const std::uint64_t size = sizeof(head) + releases + head.operations_bytes + std::uint64_t{head.types_bytes};
    if (size > reader_.size() || reader_.size() - size >= 8) {
        dropped_ = true;
        return;
    }
    // The message is as aligned as what operator new gives.
    const auto* at = reinterpret_cast<const std::uint8_t*>(reader_.data()) + sizeof(head);
    spear_batch batch{};
    batch.transaction = head.transaction;
    batch.block = head.block;
    batch.closes = head.closes;
    batch.abort = head.abort;
    batch.single_step = head.single_step;
    batch.releases = reinterpret_cast<const std::uint64_t*>(at);
    batch.release_count = head.release_count;
    batch.operations = {at + releases, head.operations_bytes};
    batch.types = {at + releases + head.operations_bytes, head.types_bytes};
    received_.add(TrafficCounter::bytes_of(batch));
    events_.submit(session_, head.request, batch);
}

void ServerChannel::reply(std::uint64_t request, const spear_answers& answers) {
    const char* const text = answers.error_message ? answers.error_message : "";
    ChannelAnswers head{};
    head.request = request;
    head.frame = answers.frame;
    head.answers_bytes = static_cast<std::uint32_t>(answers.answers.size);
    head.types_bytes = static_cast<std::uint32_t>(answers.types.size);
    head.error_bytes = answers.has_error ? static_cast<std::uint32_t>(std::strlen(text)) : 0;
    head.error_code = answers.error_code;
    head.has_error = answers.has_error;
    const std::size_t size = sizeof(head) + answers.answers.size + answers.types.size + head.error_bytes;
    head.bytes = size + padding(size);
    bool too_much = false;
    {
        const std::lock_guard lock(write_mutex_);
        writer_.write({{&head, sizeof(head)}, {answers.answers.data, answers.answers.size},
            {answers.types.data, answers.types.size}, {text, head.error_bytes}, {zeros, padding(size)}});
        sent_.add(TrafficCounter::bytes_of(answers));
        if (writer_.waiting_bytes() != 0) {
            wants_room_ = true;
            store_ordered(&header_.server_wants_room, 1u);
            too_much = writer_.broken() || writer_.waiting_bytes() > 2 * limits::max_queued_bytes;
        }
    }
    wake_sleeper(&header_.client_sleeps);
    if (too_much) {
        events_.drop(session_, "LimitExceeded: the client does not read its answers");
    } else if (wants_room_) {
        wake_watcher(); // it looks for room again, should the client have made it before it could see the wish
    }
}

void ServerChannel::set_wake_for_blocks(bool wanted) noexcept {
    store_ordered(&header_.wake_for_blocks, wanted ? 1u : 0u);
}

void ServerChannel::claim() noexcept {
    game_thread_reads_ = true;
    store_ordered(&header_.game_thread_reads, 1u);
}

bool ServerChannel::take_call(spear_call& call) {
    const ChannelCall& in = header_.call;
    ++calls_;
    const std::size_t size = __atomic_load_n(&in.arguments_bytes, __ATOMIC_RELAXED);
    call.entry_point = __atomic_load_n(&in.entry_point, __ATOMIC_RELAXED);
    call.number = call_number_ = __atomic_load_n(&in.number, __ATOMIC_RELAXED);
    if (size > sizeof(call_) || (call.number & (call_request | call_failed)) != 0) {
        events_.drop(session_, "MalformedMessage: a call in the shared memory channel is not of this protocol");
        return false;
    }
    std::memcpy(call_, in.arguments, size);
    call.arguments = {call_, size};
    calls_received_.add(size);
    return true;
}

void ServerChannel::answer_call(const spear_call_answer& answer) {
    ChannelCallAnswer& out = header_.answer;
    CallState state = answer.failed ? CallState::failed : CallState::succeeded;
    if (answer.types.size != 0 || answer.value.size > sizeof(out.answer)) {
        state = CallState::in_ring;
        spear_answers answers{};
        answers.frame = answer.frame;
        answers.answers = answer.value;
        answers.types = answer.types;
        reply(call_request | (answer.failed ? call_failed : 0) | call_number_, answers);
    } else {
        if (answer.value.size != 0) {
            std::memcpy(out.answer, answer.value.data, answer.value.size);
        }
        out.answer_bytes = static_cast<std::uint16_t>(answer.value.size);
        calls_sent_.add(answer.value.size);
    }
    out.state = static_cast<std::uint16_t>(state);
    out.frame = answer.frame;
    note_cpu(&header_.server_cpu);
    store_ordered(&out.sequence, calls_);
    wake_sleeper(&header_.client_sleeps);
}

void ServerChannel::refuse_call() {
    if (has_call()) {
        ++calls_;
        events_.drop(session_, "MalformedMessage: a call outside of a block that holds the game thread");
    }
}

void ServerChannel::release() noexcept {
    refuse_call();
    game_thread_reads_ = false;
    store_ordered(&header_.game_thread_reads, 0u);
    // What arrived before the client could see that: the client woke nobody for it.
    if (has_news()) {
        pump();
        if (has_news()) {
            wake_watcher();
        }
    }
}

template <typename F>
void ServerChannel::wait(std::uint32_t timeout_us, F&& idle, std::atomic<bool>& sleeps) {
    if (spinner_->spin(&header_.client_cpu, [&] { return has_call() || has_news() || !idle(); })) {
        return;
    }
    sleeps = true;
    store_ordered(&header_.game_thread_sleeps, 1u);
    if (!has_call() && !has_news() && idle()) {
        futex_wait(&header_.game_thread_sleeps, 1, timeout_us);
    }
    store_ordered(&header_.game_thread_sleeps, 0u);
    sleeps = false;
}

bool ServerChannel::watcher_has_work() const noexcept { return closed_ || (!game_thread_reads_ && has_news()); }

void ServerChannel::watch() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    pthread_setname_np(pthread_self(), "SpearChannel");
    spear_trace_name_thread("channel watcher");
    unsigned fruitless = 0;
    while (!closed_) {
        std::size_t done = 0;
        if (!game_thread_reads_) {
            done = pump();
        }
        bool stuck = false;
        if (wants_room_) {
            const std::lock_guard lock(write_mutex_);
            const std::size_t before = writer_.waiting_bytes();
            store_ordered(&header_.server_wants_room, 1u);
            if (writer_.flush()) {
                wants_room_ = false;
                store_ordered(&header_.server_wants_room, 0u);
            }
            stuck = writer_.waiting_bytes() != 0;
            done += before - writer_.waiting_bytes();
        }
        if (done != 0) {
            fruitless = 0;
            wake_sleeper(&header_.client_sleeps);
            continue;
        }
        if (++fruitless > patience) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        store_ordered(&header_.watcher_sleeps, 1u);
        if (!watcher_has_work()) {
            futex_wait(&header_.watcher_sleeps, 1, stuck ? 1000 : watcher_sleep_us);
            fruitless = load_ordered(&header_.watcher_sleeps) != 0 ? 0 : fruitless; // slept its full time
        }
        store_ordered(&header_.watcher_sleeps, 0u);
    }
}

// ServerChannels

std::shared_ptr<ServerChannel> ServerChannels::offer(
    std::uint64_t session, std::size_t max_message_bytes, std::string& why) {
    auto region = ChannelRegion::create(why);
    return region ? std::make_shared<ServerChannel>(session, std::move(region), max_message_bytes, events_) : nullptr;
}

void ServerChannels::add(std::shared_ptr<ServerChannel> channel) {
    const std::lock_guard lock(mutex_);
    channel->set_wake_for_blocks(sessions_ > 1 || !is_polled_);
    channels_[channel->session()] = std::move(channel);
    ++changes_;
}

void ServerChannels::remove(std::uint64_t session) {
    std::shared_ptr<ServerChannel> removed;
    {
        const std::lock_guard lock(mutex_);
        const auto at = channels_.find(session);
        if (at == channels_.end()) {
            return;
        }
        removed = std::move(at->second);
        channels_.erase(at);
        ++changes_;
    }
    removed->close();
    removed->wake_game_thread();
}

void ServerChannels::set_session_count(std::size_t count) {
    const std::lock_guard lock(mutex_);
    sessions_ = count;
    for (const auto& [session, channel] : channels_) {
        channel->set_wake_for_blocks(count > 1 || !is_polled_);
    }
}

std::shared_ptr<ServerChannel> ServerChannels::find(std::uint64_t session) const {
    const std::lock_guard lock(mutex_);
    const auto at = channels_.find(session);
    return at != channels_.end() ? at->second : nullptr;
}

void ServerChannels::get_traffic(std::uint64_t session, spear_traffic& received, spear_traffic& sent) const {
    if (const std::shared_ptr<ServerChannel> channel = find(session)) {
        received = channel->received();
        sent = channel->sent();
    }
}

bool ServerChannels::reply(std::uint64_t session, std::uint64_t request, const spear_answers& answers) {
    if (std::this_thread::get_id() == game_thread_.load(std::memory_order_relaxed) && claimed_ &&
        session == claimed_session_) {
        claimed_->reply(request, answers);
        return true;
    }
    const std::shared_ptr<ServerChannel> channel = find(session);
    if (channel) {
        channel->reply(request, answers);
    }
    return channel != nullptr;
}

void ServerChannels::poll() {
    std::vector<std::shared_ptr<ServerChannel>>& with_news = polled_;
    {
        const std::lock_guard lock(mutex_);
        const bool is_first = !std::exchange(is_polled_, true);
        for (const auto& [session, channel] : channels_) {
            if (is_first) {
                channel->set_wake_for_blocks(sessions_ > 1);
            }
            if (channel->has_news()) {
                with_news.push_back(channel);
            }
        }
    }
    for (const auto& channel : with_news) {
        channel->pump();
    }
    with_news.clear();
}

/// From now on the game thread reads the session's channel.
void ServerChannels::claim(std::uint64_t session) {
    game_thread_.store(std::this_thread::get_id(), std::memory_order_relaxed);
    const std::uint32_t changes = changes_.load(std::memory_order_acquire);
    if (session != claimed_session_ || changes != seen_changes_) {
        release();
        seen_changes_ = changes;
        claimed_session_ = session;
        claimed_ = find(session);
        if (claimed_) {
            claimed_->claim();
            const std::lock_guard lock(sleep_mutex_);
            sleeps_at_ = claimed_;
        }
    }
}

void ServerChannels::wait(std::uint64_t session, std::uint32_t timeout_ms) {
    claim(session);
    const auto idle = [this] { return wakes_.load() == seen_wakes_; };
    if (claimed_) {
        if (claimed_->pump() == 0 && idle()) {
            claimed_->wait(timeout_ms * 1000, idle, waits_);
            claimed_->pump();
        }
        claimed_->refuse_call();
    } else {
        waits_ = true;
        store_ordered(&sleeps_, 1u);
        if (idle()) {
            futex_wait(&sleeps_, 1, timeout_ms * 1000);
        }
        store_ordered(&sleeps_, 0u);
        waits_ = false;
    }
    // The caller looks at everything now; a wake() counted here had its reason in place before.
    seen_wakes_ = wakes_.load();
}

bool ServerChannels::wait_call(std::uint64_t session, std::uint32_t timeout_ms, spear_call& call) {
    claim(session);
    if (!claimed_) {
        wait(session, timeout_ms);
        return false;
    }
    const auto idle = [this] { return wakes_.load() == seen_wakes_; };
    if (!claimed_->has_call() && !claimed_->has_news() && idle()) {
        claimed_->wait(timeout_ms * 1000, idle, waits_);
    }
    // A call came before what the ring has; wakes are looked at when there is none.
    if (claimed_->has_call()) {
        return claimed_->take_call(call);
    }
    claimed_->pump();
    seen_wakes_ = wakes_.load();
    return false;
}

void ServerChannels::answer_call(std::uint64_t session, const spear_call_answer& answer) {
    if (claimed_ && session == claimed_session_) {
        claimed_->answer_call(answer);
    }
}

void ServerChannels::release() {
    if (claimed_) {
        {
            const std::lock_guard lock(sleep_mutex_);
            sleeps_at_.reset();
        }
        claimed_->release();
        claimed_.reset();
    }
    claimed_session_ = 0;
}

void ServerChannels::wake() {
    ++wakes_;
    if (!waits_) { // it looks at wakes_ before it sleeps
        return;
    }
    wake_sleeper(&sleeps_);
    const std::lock_guard lock(sleep_mutex_);
    if (sleeps_at_) {
        sleeps_at_->wake_game_thread();
    }
}

} // namespace spear::wire
