// SPDX-License-Identifier: MIT
// Blocks, sending and waiting: the client's half of the guarantees G1 to G8.
#include <algorithm>

#include <fmt/format.h>

#include "session_impl.hpp"
#include "spear/log.hpp"
#include "spear_trace.h"

namespace spear {
namespace {

std::string seconds(Milliseconds time) { return fmt::format("{:g} s", static_cast<double>(time.count()) / 1000); }

} // namespace

// Sending

/// Sends one batch and returns its request number. The mutex is held, so announcements go out in the order of their
/// numbers.
/// The batch is empty afterwards.
std::uint64_t Session::Impl::submit(OperationBatch& batch, bool closes, bool abort, bool single_step) {
    const TraceSpan span(SPEAR_TRACE_SEND, session_id, batch.transaction, batch.block);
    ByteBuffer types;
    if (announcer.has_pending()) {
        types = announcer.take_pending();
    }
    release_dropped_results();
    spear_batch wire{};
    wire.transaction = batch.transaction;
    wire.block = batch.block;
    wire.closes = closes;
    wire.abort = abort;
    wire.single_step = single_step;
    wire.types = {reinterpret_cast<const std::uint8_t*>(types.data()), types.size()};
    wire.operations = {
        reinterpret_cast<const std::uint8_t*>(batch.operations.buffer.data()), batch.operations.buffer.size()};
    wire.releases = releases.data();
    wire.release_count = releases.size();

    const std::uint64_t request = next_request++;
    const bool refused = spear_client_submit(client, request, &wire) != 0;
    releases.clear();
    for (OperationSlab* const slab : batch.slabs) {
        slab->has_gaps = batch.has_gaps;
        slab->is_sent.store(true, std::memory_order_release);
    }
    if (batch.block != SPEAR_BLOCK_NONE) {
        last_request[batch.block] = request;
    }
    if (!spare.empty()) {
        InFlight::node_type node = std::move(spare.back());
        spare.pop_back();
        node.key() = request;
        std::swap(node.mapped(), batch);
        in_flight.insert(in_flight.end(), std::move(node));
    } else {
        in_flight.emplace_hint(in_flight.end(), request, std::exchange(batch, {}));
    }
    if (refused) {
        lose(
            {ErrorCode::Disconnected, fmt::format("The connection to the engine at {} is lost.", address), {}, {}, {}});
    }
    changed.notify_all();
    return request;
}

/// Sends what the open block has recorded, and holds the game thread from now on.
void Session::Impl::send_recorded() {
    const std::uint8_t kind = block.block;
    holds_game_thread = true;
    submit(block, false);
    block.transaction = transaction;
    block.block = kind;
}

// Waiting

void Session::Impl::require_open(Lock& lock, std::string_view what) const {
    if (lost) {
        throw_lost(lock, what);
    }
}

void Session::Impl::throw_lost(Lock& lock, std::string_view what) const {
    ErrorInfo error = *lost;
    const LossExplainer explainer = is_closed ? nullptr : loss_explainer;
    lock.unlock();
    if (explainer && error.code == ErrorCode::Disconnected) {
        if (auto better = explainer()) {
            error = std::move(*better);
        }
    }
    if (!what.empty()) {
        error.message += fmt::format(" (Asked for: {}.)", what);
        error.operation = what;
    }
    throw_error(std::move(error));
}

/// A wait reached its deadline: asks the server why, and raises.
void Session::Impl::throw_deadline(Lock& lock, Milliseconds waited, std::string_view what) {
    require_open(lock, what);
    std::string text = fmt::format("{} was not done within {}: ", what, seconds(waited));
    ErrorCode code = ErrorCode::DeadlineExceeded;
    try {
        const Status now = status(lock, Milliseconds(2000));
        const std::string age = seconds(now.frames_age);
        switch (now.state) {
        case Status::State::held_by_other:
            code = ErrorCode::HeldByClient;
            text += fmt::format("another client holds the engine ({}). It goes on when that client closes its block or "
                                "leaves single_step.",
                now.holder.empty() ? "unknown" : now.holder);
            break;
        case Status::State::held_by_you:
            code = ErrorCode::NeedsFrames;
            text += "this session itself holds the engine, by an open transaction or by single_step. Close the "
                    "transaction, or open the next one.";
            break;
        case Status::State::busy:
            code = ErrorCode::EngineBusy;
            text += fmt::format("the engine has run no frame for {} (it loads, or a modal dialog is open).", age);
            break;
        case Status::State::exiting:
            code = ErrorCode::EngineExited;
            text += "the engine is exiting.";
            break;
        case Status::State::running:
            text += fmt::format("the engine runs (frame {}, begun {} ago), but did not answer. Raise the deadline if "
                                "the operation takes so long.",
                now.frame, age);
            break;
        }
        if (!now.detail.empty()) {
            text += " " + now.detail;
        }
    } catch (const WaitError& error) {
        text += fmt::format("the engine's server thread does not answer either ({}).", error.what());
    }
    throw_error(code, std::move(text), std::string(what));
}

/// Leaves the lock open.
spear_status Session::Impl::ask_status(Lock& lock, Milliseconds timeout, const char* what) {
    require_open(lock, what);
    ++calls_outside;
    lock.unlock();
    spear_status wire{};
    spear_wire_error error{};
    const int failed = spear_client_status(client, static_cast<std::uint32_t>(timeout.count()), &wire, &error);
    lock.lock();
    --calls_outside;
    changed.notify_all();
    if (failed != 0) {
        lock.unlock();
        throw_error(static_cast<ErrorCode>(error.code), error.message, what);
    }
    lock.unlock();
    return wire;
}

Session::Status Session::Impl::status(Lock& lock, Milliseconds timeout) {
    const spear_status wire = ask_status(lock, timeout, "status");
    return {
        static_cast<Status::State>(wire.state), wire.frame, Milliseconds(wire.frames_age_ms), wire.holder, wire.detail};
}

Session::Statistics Session::Impl::statistics(Lock& lock, Milliseconds timeout) {
    take_answers();
    require_open(lock, "statistics");
    spear_traffic sent{}, received{};
    spear_client_traffic(client, &sent, &received);
    const spear_status wire = ask_status(lock, timeout, "statistics");
    return {{sent.messages, sent.bytes}, {received.messages, received.bytes},
        {wire.received.messages, wire.received.bytes}, {wire.sent.messages, wire.sent.bytes}, wire.kept_results};
}

void Session::Impl::wait_for_change(Lock& lock, Clock::time_point until) {
    write_log(lock);
    if (!has_channel || !client || lost || has_leader) {
        ++followers;
        changed.wait_until(lock, until);
        --followers;
        return;
    }
    using namespace std::chrono;
    const auto left = duration_cast<microseconds>(until - Clock::now()).count();
    const auto timeout = static_cast<std::uint32_t>(std::clamp<std::int64_t>(left, 0, 1'000'000));
    const std::uint32_t wakes = spear_client_wakes(client);
    has_leader = true;
    ++calls_outside;
    lock.unlock();
    spear_client_wait(client, wakes, timeout);
    lock.lock();
    has_leader = false;
    --calls_outside;
    take_answers();
    if (followers != 0 || is_closed) {
        changed.notify_all(); // somebody else leads now, or close() goes on
    }
}

void Session::Impl::wait_for_request(Lock& lock, std::uint64_t request, std::string_view what) {
    const Milliseconds limit = deadline();
    if (!wait_until(lock, Clock::now() + limit, [&] { return lost || !in_flight.contains(request); })) {
        throw_deadline(lock, limit, what);
    }
    require_open(lock, what);
}

/// Asks for the result of a latent function, once at a time.
void Session::Impl::ask_for_late(OperationState& state) {
    OperationState::Rare& rare = state.rarely();
    if (lost || rare.is_asked_for || Clock::now() < rare.ask_again_after) {
        return;
    }
    rare.is_asked_for = true;
    OperationBatch batch;
    OperationState& asking = new_state(batch);
    asking.number = next_operation++;
    asking.entry_point = AllEntryPoints::index_of<decltype(engine_service::wait_for_result)>();
    asking.shape = types::null;
    asking.fire_and_forget = asking.kept = false;
    asking.rarely().deliver_to = &state;
    add_use(state); // until it is answered
    const std::size_t at =
        begin_operation(batch.operations, asking.number, asking.entry_point, OperationFlags::wants_answer);
    encode_value(batch.operations, state.number);
    end_operation(batch.operations, at);
    batch.count = 1;
    submit(batch, false);
}

/// False at the timeout. Raises NeedsFrames.
bool Session::Impl::wait_until_done(Lock& lock, OperationState& state, Clock::time_point until) {
    using Stage = OperationState::Stage;
    while (!state.is_done()) {
        const Stage stage = state.stage.load(std::memory_order_relaxed);
        if (stage == Stage::pending && !state.slab->is_sent.load(std::memory_order_relaxed) && !lost &&
            is_block_open() && is_owner() && state.slab->transaction == transaction) {
            send_recorded();
            continue;
        }
        Clock::time_point wake = until;
        if (stage == Stage::late) {
            if (is_held_by_this_thread()) {
                const ErrorInfo error = state.error() ? *state.error() : ErrorInfo{};
                const std::string name = describe(state);
                lock.unlock();
                throw_error(ErrorCode::NeedsFrames,
                    fmt::format("The result of {} takes further frames, but this thread holds the engine. Close the "
                                "transaction (without single_step) "
                                "and ask again. {}",
                        name, error.message),
                    name);
            }
            ask_for_late(state);
            if (!state.rarely().is_asked_for) {
                wake = std::min(until, state.rarely().ask_again_after);
            }
        }
        wait_for_change(lock, wake);
        if (!state.is_done() && Clock::now() >= until) {
            take_answers();
            return state.is_done();
        }
    }
    return true;
}

RawResult Session::Impl::wait_for_result(
    const OperationHandle& handle, std::optional<Milliseconds> wanted_deadline, BeforeSleep before_sleep) {
    OperationState& state = *handle.state_;
    if (!state.is_done()) {
        before_sleep();
        TraceSpan span(SPEAR_TRACE_WAIT_FOR_RESULT, session_id, state.number);
        if (span.is_on() && SPEAR_TRACE_LEVEL() == SPEAR_TRACE_OPERATIONS) {
            const std::string name = describe(state);
            span.set_text(name.data(), name.size());
        }
        Lock lock(mutex);
        const Milliseconds limit = wanted_deadline.value_or(deadline());
        if (!wait_until_done(lock, state, Clock::now() + limit)) {
            throw_deadline(lock, limit, describe(state));
        }
    }
    if (state.rare && state.rare->error) {
        {
            Lock lock(mutex);
            if (state.rare->error == lost) {
                before_sleep(); // the launcher may want to know how its engine has ended
                throw_lost(lock, describe(state));
            }
        }
        throw_error(*state.rare->error, state.rare->original);
    }
    RawResult result;
    result.operation = handle;
    result.view.type = state.result_type;
    result.view.payload = {state.result, state.result_size};
    result.entry_point = state.entry_point;
    result.shape = state.shape;
    result.frame = state.frame;
    return result;
}

// Blocks

void Session::Impl::require_order(BlockKind kind) const {
    const std::string operation(block_name(kind));
    if (phase != Phase::idle && !is_owner()) {
        throw_error(ErrorCode::WrongThread,
            fmt::format("{}() was called while another thread has a transaction of this session open. A transaction "
                        "belongs to the thread that opened it; "
                        "give each thread a session of its own, or take turns.",
                operation),
            operation);
    }
    if (is_block_open()) {
        throw_error(ErrorCode::FrameMisuse,
            fmt::format("{}() was called within an open {} block. Blocks do not nest: execute() the open one first.",
                operation, block_name(open_kind())),
            operation);
    }
    if (kind == BlockKind::begin && phase == Phase::between) {
        throw_error(ErrorCode::FrameMisuse,
            "begin_frame() was called, but the last begin_frame block has no end_frame block yet: each transaction is "
            "both. Call end_frame() first.",
            operation);
    }
    if (kind == BlockKind::end && phase == Phase::idle) {
        throw_error(ErrorCode::FrameMisuse,
            "end_frame() was called without a begin_frame block before it: each transaction is both, in this order.",
            operation);
    }
}

void Session::Impl::wait_for_kind(Lock& lock, BlockKind kind) {
    const std::uint64_t request = last_request[static_cast<std::size_t>(kind)];
    take_answers();
    if (request != 0 && in_flight.contains(request)) {
        const TraceSpan span(SPEAR_TRACE_WAIT_FOR_FRAME, session_id, kind == BlockKind::begin ? next_transaction : transaction);
        wait_for_request(lock, request,
            kind == BlockKind::begin ? "The previous begin_frame block" : "The previous end_frame block");
    }
}

void Session::Impl::open(BlockKind kind) {
    Lock lock(mutex);
    require_open(lock, block_name(kind));
    require_order(kind);
    wait_for_kind(lock, kind);
    require_order(kind); // another thread may have been faster meanwhile
    if (kind == BlockKind::begin) {
        if (!failures.empty()) {
            auto raised = std::exchange(failures, {});
            lock.unlock();
            throw_failures(std::move(raised), false);
        }
        transaction = next_transaction++;
        owner = std::this_thread::get_id();
        phase = Phase::begin_open;
    } else {
        phase = Phase::end_open;
    }
    holds_game_thread = false;
    block.clear();
    block.transaction = transaction;
    block.block = static_cast<std::uint8_t>(kind);
    block_opened_ns = SPEAR_TRACE_LEVEL() != SPEAR_TRACE_OFF ? spear_trace_now() : 0;
}

/// The user's code in the block that closes now, for traces.
void Session::Impl::trace_block(BlockKind kind) {
    if (const std::uint64_t opened = std::exchange(block_opened_ns, 0)) {
        const auto what = kind == BlockKind::begin ? SPEAR_TRACE_RECORD_BEGIN_BLOCK : SPEAR_TRACE_RECORD_END_BLOCK;
        const spear_trace_event event{opened, spear_trace_now() - opened, static_cast<std::uint16_t>(what),
            static_cast<std::uint16_t>(kind), 0, session_id, transaction};
        spear_trace_record(&event);
    }
}

void Session::Impl::close(BlockKind kind, bool single_step) {
    Lock lock(mutex);
    if (lost) {
        phase = Phase::idle;
        throw_lost(lock, block_name(kind));
    }
    if (!is_block_open() || open_kind() != kind) {
        throw_error(ErrorCode::FrameMisuse,
            fmt::format("execute() was called on a {} block that is not open.", block_name(kind)),
            std::string(block_name(kind)));
    }
    if (!is_owner()) {
        throw_error(ErrorCode::WrongThread,
            fmt::format("execute() was called on the {} block of another thread.", block_name(kind)),
            std::string(block_name(kind)));
    }
    trace_block(kind);
    take_answers();
    const bool waits = holds_game_thread && block.fire_and_forget != 0;
    const bool is_begin = kind == BlockKind::begin;
    phase = is_begin ? Phase::between : Phase::idle;
    holds_game_thread = false;
    if (!is_begin) {
        holds_single_step = single_step;
    }
    const std::uint64_t request = submit(block, true, false, single_step);
    try {
        if (waits) {
            const TraceSpan span(SPEAR_TRACE_WAIT_FOR_RESULT, session_id, request);
            wait_for_request(
                lock, request, is_begin ? "The end of the begin_frame block" : "The end of the end_frame block");
        }
    } catch (...) {
        if (lock.owns_lock())
            lock.unlock();
        abandon();
        throw;
    }
    std::vector<Failure> raised;
    const auto concerns_this = [&](const Failure& failure) { return !is_begin || failure.transaction == transaction; };
    std::ranges::copy_if(failures, std::back_inserter(raised), concerns_this);
    std::erase_if(failures, concerns_this);
    lock.unlock();
    if (!raised.empty()) {
        if (is_begin) {
            abandon(); // who catches the error is past the place where the end block would have been
        }
        throw_failures(std::move(raised), is_begin);
    }
}

void Session::Impl::abandon() noexcept {
    try {
        const Lock lock(mutex);
        const Phase left = std::exchange(phase, Phase::idle);
        holds_game_thread = false;
        OperationBatch batch = std::exchange(block, {});
        if (left == Phase::idle || lost) {
            return;
        }
        holds_single_step = false;
        if (left == Phase::between) { // the begin block was closed in good order: an empty end block is what is missing
            batch.transaction = transaction;
            batch.block = SPEAR_BLOCK_END;
        }
        batch.is_abandoned = true;
        submit(batch, true, true);
    } catch (const std::exception& exception) {
        log_message(LogLevel::error, std::string("a transaction could not be closed: ") + exception.what());
    }
}

void Session::Impl::flush() {
    Lock lock(mutex);
    require_open(lock, "flush");
    if (is_block_open() && is_owner()) {
        throw_error(ErrorCode::FrameMisuse,
            fmt::format("flush() was called within an open {} block. execute() it first.", block_name(open_kind())),
            "flush");
    }
    // Answers to wait_for_result may take any number of frames: they are no part of "everything sent so far has run".
    const auto is_part = [](const auto& entry) {
        const OperationBatch& batch = entry.second;
        const OperationState* const first = batch.first_state();
        return !first || !first->rare || !first->rare->deliver_to;
    };
    const std::uint64_t last = next_request;
    const Milliseconds limit = deadline();
    const TraceSpan span(SPEAR_TRACE_WAIT_FOR_RESULT, session_id, last - 1);
    const bool done = wait_until(lock, Clock::now() + limit,
        [&] { return lost || !std::any_of(in_flight.begin(), in_flight.lower_bound(last), is_part); });
    if (!done) {
        throw_deadline(lock, limit, "flush");
    }
    require_open(lock, "flush");
    if (!failures.empty()) {
        auto raised = std::exchange(failures, {});
        lock.unlock();
        throw_failures(std::move(raised), false);
    }
}

void Session::Impl::throw_failures(std::vector<Failure> raised, bool transaction_was_closed) const {
    ErrorInfo first = *raised.front().error;
    if (raised.size() > 1) {
        first.message += fmt::format(" (And {} more fire-and-forget operations failed, the next with {}: {})",
            raised.size() - 1, error_name(raised[1].error->code), raised[1].error->message);
    }
    if (transaction_was_closed) {
        first.message += " (The transaction was closed with an empty end block.)";
    }
    throw_error(std::move(first), raised.front().original);
}

} // namespace spear
