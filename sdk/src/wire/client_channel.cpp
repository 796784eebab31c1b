// SPDX-License-Identifier: MIT
#include "client_channel.hpp"

#include <algorithm>
#include <cstring>

namespace spear::wire {
namespace {
constexpr char zeros[8] = {};
std::size_t padding(std::size_t size) { return (8 - size % 8) % 8; }
} // namespace

ClientChannel::ClientChannel(std::unique_ptr<ChannelRegion> region, std::size_t max_message_bytes, bool spins)
    : region_(std::move(region)), header_(region_->header()),
      writer_(region_->to_server(), &header_.to_server_tail, &header_.to_server_head, channel_ring_bytes,
          &header_.client_cpu),
      reader_(region_->to_client(), &header_.to_client_tail, &header_.to_client_head, channel_ring_bytes,
          max_message_bytes + (1u << 20)),
      spinner_(spins) {}

bool ClientChannel::submit(std::uint64_t request, const spear_batch& batch) {
    ChannelBatch head{};
    head.request = request;
    head.transaction = batch.transaction;
    head.block = batch.block;
    head.closes = batch.closes;
    head.abort = batch.abort;
    head.single_step = batch.single_step;
    head.release_count = static_cast<std::uint32_t>(batch.release_count);
    head.operations_bytes = static_cast<std::uint32_t>(batch.operations.size);
    head.types_bytes = static_cast<std::uint32_t>(batch.types.size);
    const std::size_t releases = batch.release_count * sizeof(std::uint64_t);
    const std::size_t size = sizeof(head) + releases + batch.operations.size + batch.types.size;
    head.bytes = size + padding(size);
    bool waits = false;
    {
        const std::lock_guard lock(write_mutex_);
        writer_.write(
            {{&head, sizeof(head)}, {batch.releases, releases}, {batch.operations.data, batch.operations.size},
                {batch.types.data, batch.types.size}, {zeros, padding(size)}});
        sent_.add(TrafficCounter::bytes_of(batch));
        waits = writer_.waiting_bytes() != 0;
        wants_room_.store(waits, std::memory_order_relaxed);
    }
    wake_server(batch.block != SPEAR_BLOCK_NONE && !waits);
    return waits;
}

bool ClientChannel::flush() {
    if (!wants_room_.load(std::memory_order_relaxed)) {
        return true;
    }
    bool moved = false;
    bool done = false;
    {
        const std::lock_guard lock(write_mutex_);
        const std::size_t before = writer_.waiting_bytes();
        done = writer_.flush();
        moved = writer_.waiting_bytes() != before;
        wants_room_.store(!done, std::memory_order_relaxed);
    }
    if (moved) {
        wake_server(false);
    }
    return done;
}

/// `block`: it is for the next beginning or end of a frame, where the game thread looks by itself.
void ClientChannel::wake_server(bool block) {
    if (load_ordered(&header_.game_thread_reads) != 0) {
        wake_sleeper(&header_.game_thread_sleeps);
    } else if (!block || load_ordered(&header_.wake_for_blocks) != 0) {
        wake_sleeper(&header_.watcher_sleeps);
    }
}

bool ClientChannel::call(const spear_call& call) {
    ChannelCall& out = header_.call;
    if (call.arguments.size > sizeof(out.arguments) || load_acquire(&header_.game_thread_reads) == 0) {
        return false;
    }
    out.arguments_bytes = static_cast<std::uint16_t>(call.arguments.size);
    out.entry_point = call.entry_point;
    out.number = call.number;
    if (call.arguments.size != 0) {
        std::memcpy(out.arguments, call.arguments.data, call.arguments.size);
    }
    note_cpu(&header_.client_cpu);
    const std::uint32_t sequence = calls_.load(std::memory_order_relaxed) + 1;
    calls_.store(sequence, std::memory_order_relaxed);
    is_calling_.store(true, std::memory_order_relaxed);
    calls_sent_.add(call.arguments.size);
    store_ordered(&out.sequence, sequence);
    wake_sleeper(&header_.game_thread_sleeps);
    return true;
}

int ClientChannel::take_call(bool spin, spear_call_answer& answer) {
    if (!is_call_answered() &&
        !(spin && spinner_.spin_briefly(&header_.server_cpu, [this] { return is_call_answered(); }))) {
        return 0;
    }
    is_calling_.store(false, std::memory_order_relaxed);
    const ChannelCallAnswer& in = header_.answer;
    const auto state = static_cast<CallState>(in.state);
    const std::size_t size = in.answer_bytes;
    if (state == CallState::in_ring) {
        return 2;
    }
    if ((state != CallState::succeeded && state != CallState::failed) || size > sizeof(answer_)) {
        return -1;
    }
    std::memcpy(answer_, in.answer, size);
    answer.frame = in.frame;
    answer.failed = state == CallState::failed;
    answer.value = {answer_, size};
    calls_received_.add(size);
    answer.types = {};
    return 1;
}

int ClientChannel::take(std::uint64_t& request, spear_answers& answers) {
    const ChannelReader::Result result = reader_.next();
    if (load_ordered(&header_.server_wants_room) != 0) {
        wake_sleeper(&header_.watcher_sleeps);
    }
    if (result == ChannelReader::Result::nothing) {
        return 0;
    }
    if (result == ChannelReader::Result::malformed) {
        return -1;
    }
    ChannelAnswers head{};
    std::memcpy(&head, reader_.data(), sizeof(head));
    const std::uint64_t size =
        sizeof(head) + std::uint64_t{head.answers_bytes} + head.types_bytes + std::uint64_t{head.error_bytes};
    if (size > reader_.size() || reader_.size() - size >= 8) {
        return -1;
    }
    const auto* at = reinterpret_cast<const std::uint8_t*>(reader_.data()) + sizeof(head);
    request = head.request;
    answers = {};
    answers.answers = {at, head.answers_bytes};
    answers.types = {at + head.answers_bytes, head.types_bytes};
    answers.frame = head.frame;
    if (head.has_error) {
        const auto* text = reinterpret_cast<const char*>(at + head.answers_bytes + head.types_bytes);
        error_text_.assign(text, head.error_bytes);
        answers.has_error = 1;
        answers.error_code = head.error_code;
        answers.error_message = error_text_.c_str();
    }
    received_.add(TrafficCounter::bytes_of(answers));
    return 1;
}

void ClientChannel::wait(std::uint32_t wakes, std::uint32_t timeout_us) {
    const auto arrived = [&] { return reader_.has_news() || is_call_answered() || wakes_.load() != wakes; };
    // A large batch goes out while we wait for its answer.
    while (!flush()) {
        if (spinner_.spin(&header_.server_cpu, [&] { return arrived() || flush(); })) {
            if (arrived()) {
                return;
            }
        } else {
            timeout_us = std::min(timeout_us, 200u);
            break;
        }
    }
    if (spinner_.spin(&header_.server_cpu, arrived)) {
        return;
    }
    store_ordered(&header_.client_sleeps, 1u);
    if (!arrived()) {
        futex_wait(&header_.client_sleeps, 1, timeout_us);
    }
    store_ordered(&header_.client_sleeps, 0u);
}

void ClientChannel::wake() noexcept {
    ++wakes_;
    wake_sleeper(&header_.client_sleeps);
}

} // namespace spear::wire
