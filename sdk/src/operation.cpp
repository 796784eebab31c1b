// SPDX-License-Identifier: MIT
#include "spear/operation.hpp"

#include <new>
#include <utility>

#include <fmt/format.h>

#include "session_impl.hpp"

namespace spear {
namespace {

/// Buffers of builders that are gone: an operation costs no allocation once a thread has warmed up.
thread_local std::vector<ByteBuffer> spare_buffers;
constexpr std::size_t largest_spare_buffer = 1u << 20;

[[noreturn]] void throw_invalid_future(std::string_view what) {
    throw_error(ErrorCode::ArgumentError,
        fmt::format(
            "{} was called on a future that belongs to no operation (default-constructed, or moved from).", what));
}

} // namespace

namespace detail {
namespace {

/// Memory of operation states that are gone, kept by the thread that freed them.
class SpareMemory {
public:
    ~SpareMemory() {
        is_gone = true;
        while (void* const block = take())
            ::operator delete(block);
    }
    void* take() {
        if (!first_)
            return nullptr;
        Block* const block = std::exchange(first_, first_->next);
        --count_;
        return block;
    }
    bool put(void* memory) {
        if (count_ == most)
            return false;
        first_ = new (memory) Block{first_};
        ++count_;
        return true;
    }
    static inline thread_local bool is_gone = false; // a future may outlive the thread's locals

private:
    struct Block {
        Block* next;
    };
    static constexpr std::size_t most = 8192;
    Block* first_ = nullptr;
    std::size_t count_ = 0;
};
thread_local SpareMemory spare_memory;

/// Serves one type only: that of std::allocate_shared's block for an OperationState.
template <typename T>
struct StateAllocator {
    using value_type = T;
    StateAllocator() = default;
    template <typename U>
    StateAllocator(const StateAllocator<U>&) {}
    T* allocate(std::size_t count) {
        void* const memory = count == 1 && !SpareMemory::is_gone ? spare_memory.take() : nullptr;
        return static_cast<T*>(memory ? memory : ::operator new(count * sizeof(T)));
    }
    void deallocate(T* memory, std::size_t count) noexcept {
        if (count != 1 || SpareMemory::is_gone || !spare_memory.put(memory))
            ::operator delete(memory);
    }
    friend bool operator==(const StateAllocator&, const StateAllocator&) { return true; }
};

} // namespace

std::shared_ptr<OperationState> make_operation_state() {
    return std::allocate_shared<OperationState>(StateAllocator<OperationState>());
}

} // namespace detail

// OperationHandle

OperationHandle::OperationHandle(
    std::shared_ptr<Session> session, std::shared_ptr<detail::OperationState> state) noexcept
    : session_(std::move(session)), state_(std::move(state)) {}

OperationHandle::OperationHandle(const OperationHandle& other) noexcept
    : session_(other.session_), state_(other.state_) {
    if (state_) {
        const std::lock_guard lock(session_->impl_->mutex);
        ++state_->users;
    }
}

OperationHandle::~OperationHandle() {
    if (state_) {
        const std::lock_guard lock(session_->impl_->mutex);
        session_->impl_->drop_user(state_);
    }
}

std::uint64_t OperationHandle::number() const noexcept { return state_ ? state_->number : 0; }

bool OperationHandle::is_ready() const noexcept {
    if (!state_)
        return false;
    if (state_->is_done())
        return true;
    const auto stage = state_->stage.load(std::memory_order_relaxed);
    if (stage == OperationState::Stage::late ||
        (stage == OperationState::Stage::sent && session_->impl_->has_channel)) {
        const std::lock_guard lock(session_->impl_->mutex);
        session_->impl_->take_answers();
        if (state_->stage.load(std::memory_order_relaxed) == OperationState::Stage::late &&
            !session_->impl_->is_held_by_this_thread()) {
            session_->impl_->ask_for_late(state_);
        }
    }
    return state_->is_done();
}

RawResult OperationHandle::get(std::optional<Milliseconds> deadline) const {
    if (!state_)
        throw_invalid_future("get()");
    return session_->impl_->wait_for_result(state_, deadline);
}

bool OperationHandle::wait(Milliseconds timeout) const {
    if (!state_)
        throw_invalid_future("wait()");
    if (state_->is_done())
        return true;
    Session::Impl::Lock lock(session_->impl_->mutex);
    return session_->impl_->wait_until_done(lock, state_, Clock::now() + timeout);
}

// OperationBuilder

OperationBuilder::OperationBuilder(Session& session, std::uint16_t entry_point)
    : session_(session), entry_point_(entry_point) {
    if (!spare_buffers.empty()) {
        encoder_.buffer = std::move(spare_buffers.back());
        spare_buffers.pop_back();
    }
}

OperationBuilder::~OperationBuilder() {
    if (encoder_.buffer.capacity() <= largest_spare_buffer && spare_buffers.size() < 8) {
        encoder_.buffer.clear();
        spare_buffers.push_back(std::move(encoder_.buffer));
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
    if (operation.session().get() != &session_) {
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
std::shared_ptr<OperationState> Session::Impl::record(Lock& lock, OperationBuilder& builder, CallMode mode) {
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
        if (!in_block && future.state_->stage.load(std::memory_order_relaxed) == OperationState::Stage::recorded) {
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
    const std::size_t at = begin_operation(batch.operations, number, builder.entry_point_, flags);
    batch.operations.put_raw(builder.encoder_.buffer.data(), builder.encoder_.buffer.size());
    end_operation(batch.operations, at);
    ++batch.count;
    batch.fire_and_forget += mode == CallMode::send;

    std::shared_ptr<OperationState> state;
    if (mode != CallMode::send || !builder.futures_.empty()) {
        state = detail::make_operation_state();
        state->number = number;
        state->entry_point = builder.entry_point_;
        state->shape = builder.shape_;
        state->fire_and_forget = mode == CallMode::send;
        state->kept = mode == CallMode::async;
        state->users = mode == CallMode::send ? 0 : 1;
        state->transaction = batch.transaction;
        for (const OperationHandle& future : builder.futures_) {
            state->arguments.push_back(future.state_);
            batch.arguments.push_back(future.state_);
            ++future.state_->users; // until this batch is answered
        }
        batch.states.push_back(state);
    }
    if (!in_block) {
        submit(single, false);
    }
    return state;
}

RawResult OperationBuilder::call(std::optional<Milliseconds> deadline) {
    std::shared_ptr<OperationState> state;
    {
        Session::Impl::Lock lock(session_.impl_->mutex);
        state = session_.impl_->record(lock, *this, CallMode::sync);
    }
    return session_.impl_->wait_for_result(state, deadline);
}

OperationHandle OperationBuilder::async() {
    auto session = session_.shared_from_this();
    Session::Impl::Lock lock(session_.impl_->mutex);
    auto state = session_.impl_->record(lock, *this, CallMode::async);
    return {std::move(session), std::move(state)};
}

void OperationBuilder::send() {
    Session::Impl::Lock lock(session_.impl_->mutex);
    session_.impl_->record(lock, *this, CallMode::send);
}

} // namespace spear
