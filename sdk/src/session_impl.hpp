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

struct OperationSlab;

/// One operation that somebody may ask about. Guarded by the session's mutex except where atomic. It lies in a slab, and
/// lives as long as anybody has a handle of it, its batch is under way, or the session itself uses it.
struct OperationState {
    /// Of one that is not done: see OperationSlab::is_sent.
    enum class Stage : std::uint8_t {
        pending,
        late, ///< a latent function: begun, its result takes further frames
        done,
    };
    /// What few operations have.
    struct Rare {
        std::shared_ptr<const ErrorInfo> error;    ///< constant once done; while late: what NeedsFrames says
        std::shared_ptr<const ErrorInfo> original; ///< DependencyFailed: the argument's error
        std::vector<OperationState*> arguments;    ///< until it is answered
        ByteBuffer own_bytes;                      ///< of a late result
        // Late results are asked for with wait_for_result; the asking operation delivers to this one.
        OperationState* deliver_to = nullptr;
        bool is_asked_for = false;
        std::chrono::steady_clock::time_point ask_again_after{};
    };

    OperationSlab* slab = nullptr;
    std::uint64_t number = 0;
    TypeId shape = types::null;
    std::uint16_t entry_point = 0;
    bool fire_and_forget = false; ///< nobody waits: a failure goes to the session's list
    bool kept = false;            ///< the server keeps the result until it is released
    std::atomic<Stage> stage{Stage::pending};
    std::atomic<int> users{0}; ///< handles of users
    int uses = 0;              ///< by the session: of operations in flight that have it as an argument, and the like
    TypeId result_type = types::null; // the result: set before stage is done, constant afterwards
    std::uint32_t result_size = 0;
    const std::byte* result = nullptr;
    std::uint64_t frame = 0;
    std::unique_ptr<Rare> rare;

    bool is_done() const noexcept { return stage.load(std::memory_order_acquire) == Stage::done; }
    Rare& rarely() {
        if (!rare) {
            rare = std::make_unique<Rare>();
        }
        return *rare;
    }
    const std::shared_ptr<const ErrorInfo>& error() const noexcept {
        static const std::shared_ptr<const ErrorInfo> none;
        return rare ? rare->error : none;
    }
};

/// The bytes of answers to a batch, which the results of its operations are views of.
struct AnswerBytes {
    ByteBuffer bytes;
    int slabs = 0; ///< that use it
};

/// The states of the operations of a batch, or of a part of it: one piece of memory, used again when nobody needs them.
/// Guarded by the session's mutex except where atomic.
struct OperationSlab {
    explicit OperationSlab(std::uint32_t size) : capacity(size), states(new OperationState[size]) {}

    const std::uint32_t capacity;
    std::uint32_t count = 0;
    const std::unique_ptr<OperationState[]> states;
    Session::Impl* impl = nullptr;
    std::uint64_t transaction = 0; ///< 0 outside of blocks
    bool has_gaps = false;         ///< between its numbers are some of other batches
    std::atomic<bool> is_sent{false};
    bool is_answered = false;
    int uses = 0; ///< of all its states
    AnswerBytes* answers = nullptr;
    /// Of the states that were given to users, how many, and how many nobody has a handle of any more. Equal: `session` is
    /// null. While a handle exists, `session` does not change.
    std::atomic<std::uint32_t> given{0}, dropped{0};
    std::shared_ptr<Session> session;
    std::uint32_t dropped_seen = 0; ///< when releases of single results were last looked for
    static constexpr std::size_t not_held = ~std::size_t{0};
    std::size_t held_at = not_held; ///< in Impl::held_slabs
};

} // namespace detail

using detail::AnswerBytes;
using detail::OperationSlab;
using detail::OperationState;
using Clock = std::chrono::steady_clock;

/// Operations recorded for one message, and afterwards what is known of them until they are answered.
struct OperationBatch {
    Encoder operations;
    std::vector<OperationSlab*> slabs;      ///< of their states, by number, rising
    std::vector<OperationState*> arguments; ///< futures in use by it (counted in `uses`)
    std::uint64_t last_number = 0;
    bool has_gaps = false; ///< other batches have numbers between its own
    std::size_t count = 0;
    std::size_t fire_and_forget = 0;
    std::uint64_t transaction = 0;
    std::uint8_t block = SPEAR_BLOCK_NONE;
    bool is_abandoned = false; ///< failures are logged

    template <typename F>
    void for_each_state(F&& f) const {
        for (const OperationSlab* slab : slabs) {
            for (std::uint32_t i = 0; i < slab->count; ++i) {
                f(slab->states[i]);
            }
        }
    }
    const OperationState* first_state() const noexcept { return slabs.empty() ? nullptr : &slabs.front()->states[0]; }

    /// As new, but with its memory.
    void clear() {
        constexpr std::size_t largest_kept = 1u << 20;
        if (operations.buffer.capacity() > largest_kept) {
            operations = {};
        }
        operations.buffer.clear();
        slabs.clear();
        arguments.clear();
        last_number = 0;
        has_gaps = false;
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
    Impl();

    enum class Phase { idle, begin_open, between, end_open };

    // Constant after connect.
    const std::uint64_t serial; // of this session among all of the process
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
    InFlight in_flight;                     // by request
    std::vector<InFlight::node_type> spare; // some that were answered, with their memory
    OperationBatch single;     // for an operation outside of blocks, while it is recorded
    std::unordered_map<std::uint64_t, OperationState*> late; // each counted in its `uses`

    // Memory of operations; it lives as long as the session.
    std::vector<std::unique_ptr<OperationSlab>> all_slabs;
    std::vector<OperationSlab*> free_small, free_large;
    std::vector<OperationSlab*> held_slabs; // answered, but users still have handles of some
    std::size_t next_held = 0;              // of them to look at
    std::vector<std::unique_ptr<AnswerBytes>> all_answer_bytes;
    std::vector<AnswerBytes*> free_answer_bytes;

    // A call through the channel's place for calls: one at a time.
    bool is_calling = false;        // made and not answered
    std::uint64_t call_number = 0;  // of the last one
    bool call_failed = false;       // the answer, once is_calling is false again
    std::uint64_t call_frame = 0;
    ByteBuffer call_answer;
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
    bool take_call(bool spin);
    void finish_batch(OperationBatch& batch, AnswerBytes* bytes, std::uint64_t frame);
    void finish_failed_batch(OperationBatch& batch, ErrorInfo error);
    void finish(OperationBatch& batch, OperationState& state, AnyView result, std::uint64_t frame,
        std::shared_ptr<const ErrorInfo> error, bool is_late);
    void report_failure(OperationBatch& batch, Failure failure);
    void lose(ErrorInfo error);

    // session_states.cpp. All want the mutex but the first two.
    static void add_user(OperationState& state) noexcept;
    static void drop_user(OperationState& state) noexcept;
    OperationState& new_state(OperationBatch& batch);
    void give(OperationState& state, Session& session);
    AnswerBytes& new_answer_bytes();
    void drop_answer_bytes(AnswerBytes& bytes);
    void add_use(OperationState& state) noexcept;
    void drop_use(OperationState& state);
    void set_answered(OperationSlab& slab);
    void reuse_if_unneeded(OperationSlab& slab);
    void release_results_of(OperationSlab& slab);
    void release_dropped_results();
    void forget_dropped_late();

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
    bool wait_until_done(Lock& lock, OperationState& state, Clock::time_point until);
    void ask_for_late(OperationState& state);
    RawResult wait_for_result(
        const OperationHandle& handle, std::optional<Milliseconds> wanted_deadline, BeforeSleep before_sleep);
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
    OperationState* record(Lock& lock, OperationBuilder& builder, CallMode mode);
    bool may_call_directly(const OperationBuilder& builder) const;
};

/// Waits until `done`, which is asked under the mutex. False at the deadline.
template <typename F>
bool Session::Impl::wait_until(Lock& lock, Clock::time_point until, F&& done) {
    take_answers();
    while (!done()) {
        if (Clock::now() >= until) {
            return false;
        }
        wait_for_change(lock, until);
    }
    return true;
}

} // namespace spear
