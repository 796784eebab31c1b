// SPDX-License-Identifier: MIT
#pragma once

// What a Session consists of. One mutex guards everything that is not constant; it is never held while waiting, while
// user code runs, or while the wire is closed. The I/O thread takes it to deliver answers.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <unordered_map>
#include <vector>

#include "spear/encode.hpp"
#include "spear/session.hpp"
#include "spear_wire.h"

namespace spear {

namespace detail {

/// One operation that somebody may ask about. Guarded by the session's mutex except where atomic.
struct OperationState {
    enum class Stage : std::uint8_t {
        recorded, ///< in a block that was not sent yet
        sent,
        late, ///< a latent function: begun, its result takes further frames
        done,
    };

    std::uint64_t number = 0;
    std::uint16_t entry_point = 0;
    TypeId shape = types::null;
    bool fire_and_forget = false; ///< nobody waits: a failure goes to the session's list
    bool kept = false;            ///< the server keeps the result until it is released
    int users = 0;                ///< handles of users, and operations in flight that have it as an argument
    std::atomic<Stage> stage{Stage::recorded};
    std::uint64_t transaction = 0;             ///< 0 outside of blocks
    RawResult result;                          // set before stage is done, constant afterwards
    std::shared_ptr<const ErrorInfo> error;    // likewise; while late: what NeedsFrames says
    std::shared_ptr<const ErrorInfo> original; // DependencyFailed: the argument's error
    std::vector<std::shared_ptr<OperationState>> arguments;

    // Late results are asked for with wait_for_result; the asking operation delivers to this one.
    std::shared_ptr<OperationState> deliver_to;
    bool is_asked_for = false;
    std::chrono::steady_clock::time_point ask_again_after{};

    bool is_done() const noexcept { return stage.load(std::memory_order_acquire) == Stage::done; }
};

/// Makes one in memory that this thread has freed before, where there is some: operations come and go by the thousand.
std::shared_ptr<OperationState> make_operation_state();

} // namespace detail

using detail::OperationState;
using Clock = std::chrono::steady_clock;

/// Operations recorded for one message, and afterwards what is known of them until they are answered.
struct OperationBatch {
    Encoder operations;
    std::vector<std::shared_ptr<OperationState>> states;    ///< by number, rising
    std::vector<std::shared_ptr<OperationState>> arguments; ///< futures in use by it (counted in `users`)
    std::size_t count = 0;
    std::size_t fire_and_forget = 0;
    std::uint64_t transaction = 0;
    std::uint8_t block = SPEAR_BLOCK_NONE;
    bool is_abandoned = false; ///< failures are logged

    /// As new, but with its memory.
    void clear() {
        constexpr std::size_t largest_kept = 1u << 20;
        if (operations.buffer.capacity() > largest_kept) {
            operations = {};
        }
        operations.buffer.clear();
        states.clear();
        arguments.clear();
        count = fire_and_forget = 0;
        transaction = 0;
        block = SPEAR_BLOCK_NONE;
        is_abandoned = false;
    }
};

/// A failure that nobody was told yet.
struct Failure {
    std::uint64_t transaction = 0;
    std::shared_ptr<const ErrorInfo> error;
    std::shared_ptr<const ErrorInfo> original;
};

/// What AllEntryPoints says, by number.
struct EntryPointRow {
    std::string_view name;
    RunsOn runs_on;
    std::string signature;
};
const std::vector<EntryPointRow>& entry_point_rows();

struct Session::Impl {
    using Lock = std::unique_lock<std::mutex>;

    enum class Phase { idle, begin_open, between, end_open };

    // Constant after connect.
    std::string address;
    std::uint64_t session_id = 0;
    bool has_channel = false;
    std::atomic<Milliseconds::rep> deadline_ms{limits::default_deadline_ms};

    mutable std::mutex mutex;
    std::condition_variable changed; // an answer arrived, a batch was sent, or the session ended
    spear_client* client = nullptr;
    std::shared_ptr<const ErrorInfo> lost; // why nothing goes any more
    bool is_closed = false;
    int calls_outside = 0; // of spear_client_status, without the mutex
    LossExplainer loss_explainer;

    // With a channel, answers are taken under the mutex; one of the waiting threads, the leader, waits for them at the
    // channel (without the mutex), the others at `changed`.
    bool has_leader = false;
    int followers = 0;
    std::vector<std::string> log; // failures to be logged, without the mutex

    TypeAnnouncer announcer{types::first_client_type};
    TypeTable server_types{types::first_server_type}; // I/O thread adds under the mutex; read without it
    std::unordered_map<std::string, TypeId> shapes;

    std::uint64_t next_operation = 1;
    std::uint64_t next_request = 1;
    std::uint64_t next_transaction = 1;
    using InFlight = std::map<std::uint64_t, OperationBatch>;
    InFlight in_flight;        // by request
    InFlight::node_type spare; // the last one answered, with its memory
    OperationBatch single;     // for an operation outside of blocks, while it is recorded
    std::unordered_map<std::uint64_t, std::shared_ptr<OperationState>> late;
    std::vector<std::uint64_t> releases;
    std::vector<Failure> failures;

    Phase phase = Phase::idle;
    std::thread::id owner{}; // of the transaction, or of the single step that holds the engine
    std::uint64_t transaction = 0;
    OperationBatch block;           // recorded in the open block
    bool holds_game_thread = false; // the open block has sent a batch that does not close it
    bool holds_single_step = false;
    std::uint64_t last_request[3] = {0, 0, 0}; // of each kind of block
    std::uint64_t block_opened_ns = 0;         // for traces: 0 if none was recorded at that moment

    Milliseconds deadline() const noexcept { return Milliseconds(deadline_ms.load(std::memory_order_relaxed)); }
    bool is_block_open() const noexcept { return phase == Phase::begin_open || phase == Phase::end_open; }
    BlockKind open_kind() const noexcept { return phase == Phase::begin_open ? BlockKind::begin : BlockKind::end; }
    bool is_owner() const noexcept { return owner == std::this_thread::get_id(); }
    /// Whether frames can only go on if this thread does something.
    bool is_held_by_this_thread() const noexcept {
        // From the begin block's end on, the frame waits for the end block.
        return is_owner() &&
               (holds_game_thread || phase == Phase::between || phase == Phase::end_open || holds_single_step);
    }

    // session_answers.cpp. The first three are the I/O thread's; the others want the mutex.
    static void on_answers(void* user, std::uint64_t request, const spear_answers* answers);
    static void on_lost(void* user, const spear_wire_error* error);
    static void on_attend(void* user);
    void take_answers();
    void write_log(Lock& lock);
    void receive(std::uint64_t request, const spear_answers& answers);
    void finish_batch(
        OperationBatch& batch, const std::shared_ptr<const std::vector<std::byte>>& message, std::uint64_t frame);
    void finish_failed_batch(OperationBatch& batch, ErrorInfo error);
    void finish(OperationBatch& batch, const std::shared_ptr<OperationState>& state, RawResult result,
        std::shared_ptr<const ErrorInfo> error, bool is_late);
    void report_failure(OperationBatch& batch, Failure failure);
    void lose(ErrorInfo error);
    void drop_user(const std::shared_ptr<OperationState>& state);

    // session_blocks.cpp: sending and waiting
    std::uint64_t submit(OperationBatch& batch, bool closes, bool abort = false, bool single_step = false);
    void send_recorded();
    void require_open(Lock& lock, std::string_view what) const;
    [[noreturn]] void throw_lost(Lock& lock, std::string_view what) const;
    [[noreturn]] void throw_deadline(Lock& lock, Milliseconds waited, std::string_view what);
    /// Waits for something to change, at most until then. May return for no reason.
    void wait_for_change(Lock& lock, Clock::time_point until);
    template <typename F>
    bool wait_until(Lock& lock, Clock::time_point until, F&& done);
    void wait_for_request(Lock& lock, std::uint64_t request, std::string_view what);
    void wait_for_kind(Lock& lock, BlockKind kind);
    bool wait_until_done(Lock& lock, const std::shared_ptr<OperationState>& state, Clock::time_point until);
    void ask_for_late(const std::shared_ptr<OperationState>& state);
    RawResult wait_for_result(
        const std::shared_ptr<OperationState>& state, std::optional<Milliseconds> wanted_deadline);
    void require_order(BlockKind kind) const;
    void open(BlockKind kind);
    void close(BlockKind kind, bool single_step);
    void trace_block(BlockKind kind);
    void abandon() noexcept;
    void flush();
    [[noreturn]] void throw_failures(std::vector<Failure> raised, bool transaction_was_closed) const;

    // session.cpp
    std::string describe(std::uint16_t entry_point, TypeId shape) const;
    std::string describe(const OperationState& state) const { return describe(state.entry_point, state.shape); }
    Status status(Lock& lock, Milliseconds timeout);
    Statistics statistics(Lock& lock, Milliseconds timeout);
    spear_status ask_status(Lock& lock, Milliseconds timeout, const char* what);
    template <typename F>
    ShapeId shape(Session& session, const std::string& key, F&& make);

    // operation.cpp
    std::shared_ptr<OperationState> record(Lock& lock, OperationBuilder& builder, CallMode mode);
};

} // namespace spear
