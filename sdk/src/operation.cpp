// SPDX-License-Identifier: MIT
#include "spear/operation.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "session_impl.hpp"
#include "spear_trace.h"

namespace spear {
namespace {

/// Buffers of builders that are gone: an operation costs no allocation once a thread has warmed up. In two parts, as what
/// has a destructor is slow to reach.
struct SpareBuffers {
    static constexpr std::size_t most = 8;
    std::array<ByteBuffer, most> buffers;
    std::size_t count = 0;
    SpareBuffers();
    ~SpareBuffers();
};
constinit thread_local SpareBuffers* spare_buffers = nullptr;
constinit thread_local bool spare_buffers_are_gone = false;
SpareBuffers::SpareBuffers() { spare_buffers = this; }
SpareBuffers::~SpareBuffers() {
    spare_buffers = nullptr;
    spare_buffers_are_gone = true; // a builder in the destructor of another of the thread's objects
}
void make_spare_buffers() {
    if (!spare_buffers_are_gone) {
        thread_local SpareBuffers buffers;
        static_cast<void>(buffers);
    }
}
constexpr std::size_t largest_spare_buffer = 1u << 20;

[[noreturn]] void throw_invalid_future(std::string_view what) {
    throw_error(ErrorCode::ArgumentError,
        fmt::format(
            "{} was called on a future that belongs to no operation (default-constructed, or moved from).", what));
}

} // namespace

// OperationHandle

void OperationHandle::add_user() const noexcept { Session::Impl::add_user(*state_); }
void OperationHandle::drop_user() const noexcept { Session::Impl::drop_user(*state_); }

std::uint64_t OperationHandle::number() const noexcept { return state_ ? state_->number : 0; }

const std::shared_ptr<Session>& OperationHandle::session() const noexcept {
    static const std::shared_ptr<Session> none;
    return state_ ? state_->slab->session : none;
}

bool OperationHandle::is_ready() const noexcept {
    if (!state_)
        return false;
    if (state_->is_done())
        return true;
    Session::Impl& impl = *state_->slab->impl;
    const bool is_late = state_->stage.load(std::memory_order_relaxed) == OperationState::Stage::late;
    if (is_late || (state_->slab->is_sent.load(std::memory_order_relaxed) && impl.has_channel)) {
        const std::lock_guard lock(impl.mutex);
        impl.take_answers();
        if (state_->stage.load(std::memory_order_relaxed) == OperationState::Stage::late &&
            !impl.is_held_by_this_thread()) {
            impl.ask_for_late(*state_);
        }
    }
    return state_->is_done();
}

RawResult OperationHandle::get(std::optional<Milliseconds> deadline, BeforeSleep before_sleep) const {
    if (!state_)
        throw_invalid_future("get()");
    return state_->slab->impl->wait_for_result(*this, deadline, before_sleep);
}

bool OperationHandle::wait(Milliseconds timeout) const {
    if (!state_)
        throw_invalid_future("wait()");
    if (state_->is_done())
        return true;
    Session::Impl& impl = *state_->slab->impl;
    Session::Impl::Lock lock(impl.mutex);
    return impl.wait_until_done(lock, *state_, Clock::now() + timeout);
}

// OperationBuilder

OperationBuilder::OperationBuilder(Session& session, std::uint16_t entry_point)
    : session_(session), entry_point_(entry_point) {
    if (spare_buffers && spare_buffers->count != 0) {
        encoder_.buffer.swap(spare_buffers->buffers[--spare_buffers->count]);
    }
}

OperationBuilder::~OperationBuilder() {
    if (!spare_buffers) {
        make_spare_buffers();
    }
    if (spare_buffers && spare_buffers->count < SpareBuffers::most &&
        encoder_.buffer.capacity() <= largest_spare_buffer) {
        encoder_.buffer.clear();
        spare_buffers->buffers[spare_buffers->count++].swap(encoder_.buffer);
    }
}

TypeSource& OperationBuilder::types() noexcept { return session_; }

void OperationBuilder::put_future(const OperationHandle& operation) {
    if (!operation.valid()) {
        const std::string name = session_.describe_operation(entry_point_, shape_);
        throw_error(ErrorCode::ArgumentError,
            fmt::format("An argument of {} is a future that belongs to no operation (default-constructed, or moved "
                        "from).",
                name),
            name);
    }
    if (operation.state_->slab->impl != session_.impl_.get()) {
        const std::string name = session_.describe_operation(entry_point_, shape_);
        throw_error(ErrorCode::WrongType,
            fmt::format("An argument of {} is a future of another session. Get its value and pass that.", name), name);
    }
    encoder_.put(types::future);
    encoder_.put(operation.number());
    futures_.push_back(operation);
}

void OperationBuilder::put_shape(ShapeId shape) {
    shape_ = shape.number;
    encode_value(encoder_, shape);
}

/// Numbers the operation and appends it: to the open block, or as a batch of its own that is sent at once.
OperationState* Session::Impl::record(Lock& lock, OperationBuilder& builder, CallMode mode) {
    const auto name = [&] { return describe(builder.entry_point_, builder.shape_); };
    if (lost) {
        throw_lost(lock, name());
    }
    const RunsOn runs_on = entry_point_rows()[builder.entry_point_].runs_on;
    const bool in_block = is_block_open() && is_owner() && runs_on != RunsOn::server_thread;
    if (!in_block && runs_on == RunsOn::game_thread) {
        if (is_block_open()) {
            throw_error(ErrorCode::WrongThread,
                fmt::format("{} was called outside of the thread that has the {} block open. A transaction belongs to "
                            "the thread that opened it.",
                    name(), block_name(open_kind())),
                name());
        }
        throw_error(ErrorCode::NotInFrame,
            fmt::format("{} needs an open block: it runs on the engine's game thread. Call it between begin_frame() "
                        "and execute(){}.",
                name(),
                phase == Phase::between ? ", or in the end_frame block that is due next"
                                        : ", or in an end_frame block"),
            name());
    }
    if (!in_block) {
        single.clear();
    }
    OperationBatch& batch = in_block ? block : single;
    constexpr std::size_t envelope = 64u << 10; // announcements and the message's own words
    if (batch.operations.buffer.size() + builder.encoder_.buffer.size() + OperationHeader::size + envelope >
        limits::max_message_bytes) {
        throw_error(ErrorCode::LimitExceeded,
            fmt::format("With {}, one message would exceed {} bytes (limits::max_message_bytes). Make a synchronous "
                        "call in between, or pass less.",
                name(), limits::max_message_bytes),
            name());
    }
    for (const OperationHandle& future : builder.futures_) {
        if (!in_block && !future.state_->is_done() && !future.state_->slab->is_sent.load(std::memory_order_relaxed)) {
            throw_error(ErrorCode::FrameMisuse,
                fmt::format("An argument of {} is the future of {}, which is recorded in an open block and not sent "
                            "yet: {} would overtake it. execute() the block first.",
                    name(), describe(*future.state_), name()),
                name());
        }
    }

    const std::uint64_t number = next_operation++;
    const OperationFlags flags =
        mode == CallMode::send   ? OperationFlags::none
        : mode == CallMode::sync ? OperationFlags::wants_answer
                                 : static_cast<OperationFlags>(static_cast<std::uint8_t>(OperationFlags::wants_answer) |
                                                               static_cast<std::uint8_t>(OperationFlags::keep_result));
    const ByteBuffer& arguments = builder.encoder_.buffer;
    put_operation(batch.operations, number, builder.entry_point_, flags, arguments.data(), arguments.size());
    batch.has_gaps = batch.has_gaps || (batch.count != 0 && number != batch.last_number + 1);
    batch.last_number = number;
    ++batch.count;
    batch.fire_and_forget += mode == CallMode::send;

    OperationState* state = nullptr;
    if (mode != CallMode::send || !builder.futures_.empty()) {
        state = &new_state(batch);
        state->number = number;
        state->entry_point = builder.entry_point_;
        state->shape = builder.shape_;
        state->fire_and_forget = mode == CallMode::send;
        state->kept = mode == CallMode::async;
        for (const OperationHandle& future : builder.futures_) {
            state->rarely().arguments.push_back(future.state_);
            batch.arguments.push_back(future.state_);
            add_use(*future.state_); // until this batch is answered
        }
        if (mode != CallMode::send) {
            give(*state, builder.session_);
        }
    }
    if (!in_block) {
        submit(single, false);
    }
    return state;
}

RawResult OperationBuilder::call(std::optional<Milliseconds> deadline) {
    RawResult result = call_here(deadline);
    if (!result.operation.valid()) {
        result.own.swap(encoder_.buffer);
    }
    return result;
}

RawResult OperationBuilder::call_here(std::optional<Milliseconds> deadline, BeforeSleep before_sleep) {
    RawResult result;
    if (call_directly(result, deadline, before_sleep)) {
        return result;
    }
    OperationState* state = nullptr;
    {
        Session::Impl::Lock lock(session_.impl_->mutex);
        state = session_.impl_->record(lock, *this, CallMode::sync);
    }
    return session_.impl_->wait_for_result(OperationHandle(state), deadline, before_sleep);
}

/// Whether the game thread waits for the next operation of this thread's block, with nothing before it, and nothing that
/// must go along with it.
bool Session::Impl::may_call_directly(const OperationBuilder& builder) const {
    return has_channel && holds_game_thread && is_block_open() && is_owner() && !lost && !is_calling &&
           block.count == 0 && in_flight.empty() && releases.empty() && !announcer.has_pending() &&
           builder.futures_.empty() &&
           entry_point_rows()[builder.entry_point_].runs_on == RunsOn::game_thread;
}

bool OperationBuilder::call_directly(
    RawResult& result, std::optional<Milliseconds> deadline, BeforeSleep before_sleep) {
    Session::Impl& impl = *session_.impl_;
    Session::Impl::Lock lock(impl.mutex);
    if (!impl.may_call_directly(*this)) {
        return false;
    }
    const std::uint64_t number = impl.next_operation;
    TraceSpan span(SPEAR_TRACE_WAIT_FOR_RESULT, impl.session_id, number);
    if (span.is_on() && SPEAR_TRACE_LEVEL() == SPEAR_TRACE_OPERATIONS) {
        const std::string name = impl.describe(entry_point_, shape_);
        span.set_text(name.data(), name.size());
    }
    const spear_call call{number, entry_point_,
        {reinterpret_cast<const std::uint8_t*>(encoder_.buffer.data()), encoder_.buffer.size()}};
    if (spear_client_call(impl.client, &call) != 0) {
        return false;
    }
    ++impl.next_operation;
    impl.is_calling = true;
    impl.call_number = number;
    const auto is_over = [&] { return impl.lost || !impl.is_calling; };
    if (!impl.take_call(!impl.has_leader)) {
        before_sleep();
        const Milliseconds limit = deadline.value_or(impl.deadline());
        if (!impl.wait_until(lock, Clock::now() + limit, is_over)) {
            impl.throw_deadline(lock, limit, impl.describe(entry_point_, shape_));
        }
    }
    if (impl.is_calling) {
        impl.throw_lost(lock, impl.describe(entry_point_, shape_));
    }
    encoder_.buffer.swap(impl.call_answer);
    Decoder in(encoder_.bytes());
    if (impl.call_failed) {
        lock.unlock();
        throw_error(decode_error(in));
    }
    result.view.type = in.get<TypeId>();
    result.view.payload = {in.position(), in.remaining()};
    result.entry_point = entry_point_;
    result.shape = shape_;
    result.frame = impl.call_frame;
    return true;
}

OperationHandle OperationBuilder::async() {
    Session::Impl::Lock lock(session_.impl_->mutex);
    return OperationHandle(session_.impl_->record(lock, *this, CallMode::async));
}

void OperationBuilder::send() {
    Session::Impl::Lock lock(session_.impl_->mutex);
    session_.impl_->record(lock, *this, CallMode::send);
}

} // namespace spear
