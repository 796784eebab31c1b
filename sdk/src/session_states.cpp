// SPDX-License-Identifier: MIT
// The memory of operations and what it means that nobody needs one any more: the server forgets its result.
#include <algorithm>

#include "session_impl.hpp"

namespace spear {
namespace {

constexpr std::uint32_t small_slab = 8, large_slab = 1024;
constexpr std::size_t most_free_bytes = 64;
constexpr std::size_t largest_free_bytes = 1u << 20;
/// Of the slabs that users hold on to, how many are looked at for single results to release, with each message.
constexpr std::size_t looks_at_once = 4;

} // namespace

// Users: handles

void Session::Impl::add_user(OperationState& state) noexcept { state.users.fetch_add(1, std::memory_order_relaxed); }

void Session::Impl::drop_user(OperationState& state) noexcept {
    // Who has the only handle needs no exchange: nobody else can copy it.
    if (state.users.load(std::memory_order_acquire) != 1) {
        if (state.users.fetch_sub(1, std::memory_order_acq_rel) != 1) {
            return;
        }
    } else {
        state.users.store(0, std::memory_order_release);
    }
    OperationSlab& slab = *state.slab;
    std::uint32_t dropped = slab.dropped.load(std::memory_order_relaxed);
    for (;;) {
        if (dropped + 1 != slab.given.load(std::memory_order_acquire)) {
            if (slab.dropped.compare_exchange_weak(dropped, dropped + 1, std::memory_order_acq_rel)) {
                return;
            }
            continue;
        }
        // Perhaps the last of all. Until it is counted, the slab's session stands; afterwards our copy keeps it, and the
        // session keeps the slab, though other operations may have it by then.
        const std::shared_ptr<Session> session = slab.session;
        if (slab.dropped.compare_exchange_weak(dropped, dropped + 1, std::memory_order_acq_rel)) {
            std::shared_ptr<Session> unneeded; // goes without the mutex
            Impl& impl = *session->impl_;
            const std::lock_guard lock(impl.mutex);
            if (slab.given.load(std::memory_order_relaxed) == slab.dropped.load(std::memory_order_acquire)) {
                unneeded = std::move(slab.session);
                impl.reuse_if_unneeded(slab);
            }
            return;
        }
    }
}

/// The state's first handle is about to be made.
void Session::Impl::give(OperationState& state, Session& session) {
    OperationSlab& slab = *state.slab;
    if (!slab.session) {
        slab.session = session.shared_from_this();
    }
    state.users.store(1, std::memory_order_relaxed);
    slab.given.store(slab.given.load(std::memory_order_relaxed) + 1, std::memory_order_release);
}

// Uses by the session

void Session::Impl::add_use(OperationState& state) noexcept {
    ++state.uses;
    ++state.slab->uses;
}

void Session::Impl::drop_use(OperationState& state) {
    OperationSlab& slab = *state.slab;
    --state.uses;
    --slab.uses;
    slab.dropped_seen = ~0u; // what was dropped before may be released now
    reuse_if_unneeded(slab);
}

// Slabs

OperationState& Session::Impl::new_state(OperationBatch& batch) {
    OperationSlab* slab = batch.slabs.empty() ? nullptr : batch.slabs.back();
    if (!slab || slab->count == slab->capacity) {
        const bool is_small = slab == nullptr;
        std::vector<OperationSlab*>& free = is_small ? free_small : free_large;
        if (free.empty()) {
            all_slabs.push_back(std::make_unique<OperationSlab>(is_small ? small_slab : large_slab));
            slab = all_slabs.back().get();
            slab->impl = this;
            for (std::uint32_t i = 0; i < slab->capacity; ++i) {
                slab->states[i].slab = slab;
            }
        } else {
            slab = free.back();
            free.pop_back();
        }
        slab->transaction = batch.transaction;
        batch.slabs.push_back(slab);
    }
    return slab->states[slab->count++];
}

AnswerBytes& Session::Impl::new_answer_bytes() {
    if (free_answer_bytes.empty()) {
        all_answer_bytes.push_back(std::make_unique<AnswerBytes>());
        return *all_answer_bytes.back();
    }
    AnswerBytes& bytes = *free_answer_bytes.back();
    free_answer_bytes.pop_back();
    return bytes;
}

void Session::Impl::drop_answer_bytes(AnswerBytes& bytes) {
    if (bytes.slabs != 0) {
        return;
    }
    if (free_answer_bytes.size() < most_free_bytes && bytes.bytes.capacity() <= largest_free_bytes) {
        bytes.bytes.clear();
        free_answer_bytes.push_back(&bytes);
    } else {
        std::erase_if(all_answer_bytes, [&](const auto& one) { return one.get() == &bytes; });
    }
}

/// The slab's operations are answered: from now on it waits for its users only.
void Session::Impl::set_answered(OperationSlab& slab) {
    slab.is_answered = true;
    if (slab.uses != 0 || slab.given.load(std::memory_order_relaxed) != slab.dropped.load(std::memory_order_acquire)) {
        slab.held_at = held_slabs.size();
        held_slabs.push_back(&slab);
    } else {
        reuse_if_unneeded(slab);
    }
}

void Session::Impl::reuse_if_unneeded(OperationSlab& slab) {
    if (!slab.is_answered || slab.uses != 0 || slab.session ||
        slab.given.load(std::memory_order_relaxed) != slab.dropped.load(std::memory_order_acquire)) {
        return;
    }
    release_results_of(slab);
    if (slab.held_at != OperationSlab::not_held) {
        held_slabs[slab.held_at] = held_slabs.back();
        held_slabs[slab.held_at]->held_at = slab.held_at;
        held_slabs.pop_back();
        slab.held_at = OperationSlab::not_held;
    }
    if (AnswerBytes* const bytes = std::exchange(slab.answers, nullptr)) {
        --bytes->slabs;
        drop_answer_bytes(*bytes);
    }
    for (std::uint32_t i = 0; i < slab.count; ++i) {
        slab.states[i].stage.store(OperationState::Stage::pending, std::memory_order_relaxed);
        if (slab.states[i].rare) {
            slab.states[i].rare.reset();
        }
    }
    slab.count = 0;
    slab.is_answered = false;
    slab.is_sent.store(false, std::memory_order_relaxed);
    slab.given.store(0, std::memory_order_relaxed);
    slab.dropped.store(0, std::memory_order_relaxed);
    slab.dropped_seen = 0;
    (slab.capacity == small_slab ? free_small : free_large).push_back(&slab);
}

// Releases

/// The results that nobody needs and the server still keeps, in ranges.
void Session::Impl::release_results_of(OperationSlab& slab) {
    if (lost) {
        return;
    }
    // A range may pass over numbers of the batch that have no result to keep, but over none of other batches.
    std::uint64_t first = 0, last = 0;
    const auto put = [&] {
        if (last > first) {
            releases.push_back(release_range | first);
            releases.push_back(last - first + 1);
        } else if (first != 0) {
            releases.push_back(first);
        }
    };
    for (std::uint32_t i = 0; i < slab.count; ++i) {
        OperationState& state = slab.states[i];
        if (!state.kept) {
            continue; // released before, or never kept
        }
        if (state.uses != 0 || state.users.load(std::memory_order_acquire) != 0 ||
            state.stage.load(std::memory_order_relaxed) == OperationState::Stage::pending) {
            put();
            first = last = 0;
            continue;
        }
        state.kept = false;
        if (first != 0 && (!slab.has_gaps || state.number == last + 1)) {
            last = state.number;
        } else {
            put();
            first = last = state.number;
        }
    }
    put();
}

/// Of operations whose neighbours are still in use.
void Session::Impl::release_dropped_results() {
    if (!late.empty()) {
        forget_dropped_late();
    }
    for (std::size_t looks = 0; looks < looks_at_once && looks < held_slabs.size(); ++looks) {
        OperationSlab& slab = *held_slabs[next_held++ % held_slabs.size()];
        const std::uint32_t dropped = slab.dropped.load(std::memory_order_acquire);
        if (dropped != slab.dropped_seen) {
            slab.dropped_seen = dropped;
            release_results_of(slab);
        }
    }
}

/// Late results that nobody waits for any more.
void Session::Impl::forget_dropped_late() {
    for (auto at = late.begin(); at != late.end();) {
        OperationState& state = *at->second;
        if (state.users.load(std::memory_order_acquire) != 0 || state.uses > 1) {
            ++at;
            continue;
        }
        at = late.erase(at);
        drop_use(state);
    }
}

} // namespace spear
