// SPDX-License-Identifier: MIT
// What arrives: answers, failures, the loss of the connection. By RPC it comes on the wire's I/O thread; from the
// channel, the thread that waits for it takes it.
#include <algorithm>

#include "session_impl.hpp"
#include "spear/log.hpp"

namespace spear {

void Session::Impl::on_answers(void* user, std::uint64_t request, const spear_answers* answers) {
    auto& self = *static_cast<Impl*>(user);
    Lock lock(self.mutex);
    try {
        self.receive(request, *answers);
    } catch (const std::exception& exception) { // out of memory: nothing else is thrown here
        self.lose({ErrorCode::InternalError, exception.what(), {}, {}, {}});
    }
    self.write_log(lock);
}

void Session::Impl::on_lost(void* user, const spear_wire_error* error) {
    auto& self = *static_cast<Impl*>(user);
    Lock lock(self.mutex);
    self.take_answers(); // what came before the end still counts
    self.lose({static_cast<ErrorCode>(error->code), error->message, {}, {}, {}});
    self.write_log(lock);
}

void Session::Impl::on_attend(void* user) {
    auto& self = *static_cast<Impl*>(user);
    Lock lock(self.mutex);
    self.take_answers();
    self.write_log(lock);
}

/// Takes what has arrived in the channel. Under the mutex.
void Session::Impl::take_answers() {
    if (!has_channel || !client || lost) {
        return;
    }
    bool any = is_calling && take_call(false);
    try {
        std::uint64_t request = 0;
        spear_answers answers{};
        int taken = 0;
        while (!lost && (taken = spear_client_take(client, &request, &answers)) == 1) {
            any = true;
            receive(request, answers);
        }
        if (taken < 0) {
            lose({ErrorCode::MalformedMessage,
                "The bytes in the shared memory channel from the engine are not of this protocol.", {}, {}, {}});
        }
    } catch (const std::exception& exception) {
        lose({ErrorCode::InternalError, exception.what(), {}, {}, {}});
    }
    if (any && has_leader) { // it may wait for just this
        spear_client_wake(client);
    }
    if (any && followers != 0) {
        changed.notify_all();
    }
}

/// Takes the answer to the call, if it is there; perhaps after a short spin. Under the mutex.
bool Session::Impl::take_call(bool spin) {
    spear_call_answer answer{};
    switch (spear_client_take_call(client, spin, &answer)) {
    case 0:
        return false;
    case 1:
        call_answer.clear();
        call_answer.append(answer.value.data, answer.value.size);
        call_failed = answer.failed != 0;
        call_frame = answer.frame;
        is_calling = false;
        return true;
    case 2: // receive() gets it
        return false;
    default:
        lose({ErrorCode::MalformedMessage,
            "The answer to a call in the shared memory channel from the engine is not of this protocol.", {}, {}, {}});
        return false;
    }
}

/// Logs what came up, without the mutex.
void Session::Impl::write_log(Lock& lock) {
    if (log.empty()) {
        return;
    }
    const std::vector<std::string> texts = std::exchange(log, {});
    lock.unlock();
    for (const std::string& text : texts) {
        log_message(LogLevel::warning, text);
    }
    lock.lock();
}

void Session::Impl::receive(std::uint64_t request, const spear_answers& answers) {
    if (answers.types.size != 0) {
        if (!decode_announcements(
                {reinterpret_cast<const std::byte*>(answers.types.data), answers.types.size}, server_types)) {
            lose({ErrorCode::MalformedMessage, "The engine announced types in bytes that are not of this protocol.", {},
                {}, {}});
            return;
        }
    }
    if ((request & SPEAR_CALL_REQUEST) != 0) {
        if (is_calling && (request & ~(SPEAR_CALL_REQUEST | SPEAR_CALL_FAILED)) == call_number) {
            call_answer.clear();
            call_answer.append(answers.answers.data, answers.answers.size);
            call_failed = (request & SPEAR_CALL_FAILED) != 0;
            call_frame = answers.frame;
            is_calling = false;
        }
        return;
    }
    auto node = in_flight.extract(request);
    if (node.empty()) {
        return; // lost meanwhile
    }
    OperationBatch& batch = node.mapped();
    if (answers.has_error) {
        finish_failed_batch(batch, {static_cast<ErrorCode>(answers.error_code),
                                       answers.error_message ? answers.error_message : "", {}, {}, {}});
    } else {
        AnswerBytes& bytes = new_answer_bytes();
        bytes.bytes.append(answers.answers.data, answers.answers.size);
        for (OperationSlab* const slab : batch.slabs) {
            slab->answers = &bytes;
            ++bytes.slabs;
        }
        finish_batch(batch, &bytes, answers.frame);
        drop_answer_bytes(bytes); // if it has no slabs
    }
    for (OperationState* const argument : batch.arguments) {
        drop_use(*argument);
    }
    for (OperationSlab* const slab : batch.slabs) {
        set_answered(*slab);
    }
    batch.clear();
    constexpr std::size_t most_spare = 8;
    if (spare.size() < most_spare) {
        spare.push_back(std::move(node));
    }
    if (followers != 0) {
        changed.notify_all();
    }
}

void Session::Impl::finish_batch(OperationBatch& batch, AnswerBytes* bytes, std::uint64_t frame) {
    Decoder in({bytes->bytes.data(), bytes->bytes.size()});
    // Answers come in the order of the operations, so the next is nearly always the one wanted.
    std::size_t slab_index = 0;
    std::uint32_t state_index = 0;
    const auto find = [&](std::uint64_t number) -> OperationState* {
        for (std::size_t at = slab_index; at < batch.slabs.size(); ++at, state_index = 0) {
            OperationSlab& slab = *batch.slabs[at];
            slab_index = at;
            for (; state_index < slab.count && slab.states[state_index].number <= number; ++state_index) {
                if (slab.states[state_index].number == number) {
                    return &slab.states[state_index++];
                }
            }
            if (state_index < slab.count) {
                return nullptr; // of a fire-and-forget operation that has no state
            }
        }
        return nullptr;
    };
    while (in.ok() && in.remaining() != 0) {
        const auto number = in.get<std::uint64_t>();
        const auto answer = in.get<AnswerState>();
        Decoder payload(in.get_raw(in.get<std::uint32_t>()));
        if (!in.ok()) {
            break;
        }
        OperationState* const state = find(number);
        if (answer == AnswerState::succeeded) {
            if (state) {
                const auto type = payload.get<TypeId>();
                finish(batch, *state, {type, {payload.position(), payload.remaining()}}, frame, nullptr, false);
            }
            continue;
        }
        auto error = std::make_shared<const ErrorInfo>(decode_error(payload));
        if (state) {
            finish(batch, *state, {}, frame, std::move(error), answer == AnswerState::pending);
        } else if (answer == AnswerState::failed) {
            report_failure(batch, {batch.transaction, std::move(error), nullptr});
        }
    }
    batch.for_each_state([&](OperationState& state) {
        if (state.stage.load(std::memory_order_relaxed) == OperationState::Stage::pending &&
            !state.fire_and_forget) {
            auto error = std::make_shared<const ErrorInfo>(ErrorInfo{ErrorCode::InternalError,
                "The engine answered the batch of " + describe(state) + ", but not this operation.", describe(state),
                {}, {}});
            finish(batch, state, {}, frame, std::move(error), false);
        }
    });
}

void Session::Impl::finish_failed_batch(OperationBatch& batch, ErrorInfo error) {
    const auto shared = std::make_shared<const ErrorInfo>(std::move(error));
    bool has_waiting_states = false;
    batch.for_each_state([&](OperationState& state) {
        if (!state.fire_and_forget) {
            has_waiting_states = true;
            finish(batch, state, {}, 0, shared, false);
        }
    });
    if (batch.block != SPEAR_BLOCK_NONE ? batch.fire_and_forget != 0 || !has_waiting_states
                                        : batch.fire_and_forget != 0) {
        report_failure(batch, {batch.transaction, shared, nullptr});
    }
}

void Session::Impl::finish(OperationBatch& batch, OperationState& state, AnyView result, std::uint64_t frame,
    std::shared_ptr<const ErrorInfo> error, bool is_late) {
    using Stage = OperationState::Stage;
    if (state.rare) {
        OperationState::Rare& rare = *state.rare;
        if (error && error->code == ErrorCode::DependencyFailed) {
            const auto failed = std::ranges::find_if(rare.arguments,
                [](const OperationState* argument) { return argument->is_done() && argument->error(); });
            if (failed != rare.arguments.end()) {
                rare.original = (*failed)->rare->original ? (*failed)->rare->original : (*failed)->error();
            }
        }
        rare.arguments.clear();
        if (OperationState* const target = std::exchange(rare.deliver_to, nullptr)) { // an answer to wait_for_result
            OperationState::Rare& asked = target->rarely();
            asked.is_asked_for = false;
            state.stage.store(Stage::done, std::memory_order_release);
            if (error && error->code == ErrorCode::NeedsFrames) {
                asked.ask_again_after = Clock::now() + Milliseconds(5);
            } else {
                if (late.erase(target->number) != 0) {
                    drop_use(*target); // not the last one
                }
                asked.own_bytes.clear();
                asked.own_bytes.append(result.payload.data(), result.payload.size());
                result.payload = {asked.own_bytes.data(), asked.own_bytes.size()};
                finish(batch, *target, result, frame, std::move(error), false);
            }
            drop_use(*target);
            return;
        }
    }
    if (state.fire_and_forget) {
        if (error && !is_late) {
            report_failure(batch, {batch.transaction, std::move(error), state.rare ? state.rare->original : nullptr});
        }
        return;
    }
    if (error) {
        state.rarely().error = std::move(error);
    } else {
        if (state.rare) {
            state.rare->error = nullptr;
        }
        state.result_type = result.type;
        state.result = result.payload.data();
        state.result_size = static_cast<std::uint32_t>(result.payload.size());
        state.frame = frame;
    }
    if (is_late && state.kept) {
        if (state.users.load(std::memory_order_acquire) != 0) {
            add_use(state); // by `late`
            late.emplace(state.number, &state);
        }
        state.stage.store(Stage::late, std::memory_order_release);
    } else {
        state.stage.store(Stage::done, std::memory_order_release);
    }
}

void Session::Impl::report_failure(OperationBatch& batch, Failure failure) {
    if (batch.is_abandoned) {
        log.push_back("an operation of a block that was left without execute() failed: " +
                      std::string(error_name(failure.error->code)) + ": " + failure.error->message);
    } else {
        failures.push_back(std::move(failure));
    }
}

/// Under the mutex.
void Session::Impl::lose(ErrorInfo error) {
    if (lost) {
        return;
    }
    lost = std::make_shared<const ErrorInfo>(std::move(error));
    const auto fail = [this](OperationState& state) {
        if (!state.is_done()) {
            OperationState::Rare& rare = state.rarely();
            rare.error = lost;
            rare.arguments.clear();
            rare.deliver_to = nullptr;
            state.stage.store(OperationState::Stage::done, std::memory_order_release);
        }
    };
    // Operations keep their memory as long as somebody has a handle; the session's own uses end here for good.
    const auto fail_batch = [&](OperationBatch& batch) {
        batch.for_each_state(fail);
        for (OperationSlab* const slab : batch.slabs) {
            slab->is_answered = true;
        }
        batch.slabs.clear();
        batch.arguments.clear();
    };
    for (auto& [request, batch] : in_flight) {
        fail_batch(batch);
    }
    in_flight.clear();
    for (const auto& [number, state] : late) {
        fail(*state);
    }
    late.clear();
    fail_batch(block);
    releases.clear();
    changed.notify_all();
    if (has_leader && client) {
        spear_client_wake(client);
    }
}

} // namespace spear
