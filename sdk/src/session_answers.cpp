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
    bool any = false;
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
    auto node = in_flight.extract(request);
    if (node.empty()) {
        return; // lost meanwhile
    }
    OperationBatch& batch = node.mapped();
    if (answers.has_error) {
        finish_failed_batch(batch, {static_cast<ErrorCode>(answers.error_code),
                                       answers.error_message ? answers.error_message : "", {}, {}, {}});
    } else {
        const auto* bytes = reinterpret_cast<const std::byte*>(answers.answers.data);
        finish_batch(
            batch, std::make_shared<const std::vector<std::byte>>(bytes, bytes + answers.answers.size), answers.frame);
    }
    for (const auto& argument : batch.arguments) {
        drop_user(argument);
    }
    batch.clear();
    spare = std::move(node);
    if (followers != 0) {
        changed.notify_all();
    }
}

void Session::Impl::finish_batch(
    OperationBatch& batch, const std::shared_ptr<const std::vector<std::byte>>& message, std::uint64_t frame) {
    Decoder in(*message);
    // Answers come in the order of the operations, so the next is nearly always the one wanted.
    std::size_t next = 0;
    std::size_t missing = batch.states.size();
    const auto find = [&](std::uint64_t number) -> std::shared_ptr<OperationState> {
        if (next < batch.states.size() && batch.states[next]->number == number) {
            --missing;
            return batch.states[next++];
        }
        const auto at = std::ranges::lower_bound(batch.states, number, {}, &OperationState::number);
        return at != batch.states.end() && (*at)->number == number ? *at : nullptr;
    };
    while (in.ok() && in.remaining() != 0) {
        const auto number = in.get<std::uint64_t>();
        const auto answer = in.get<AnswerState>();
        Decoder payload(in.get_raw(in.get<std::uint32_t>()));
        if (!in.ok()) {
            break;
        }
        const std::shared_ptr<OperationState> state = find(number);
        if (answer == AnswerState::succeeded) {
            if (state) {
                RawResult result{message, {}, state->entry_point, state->shape, frame};
                result.view.type = payload.get<TypeId>();
                result.view.payload = {payload.position(), payload.remaining()};
                finish(batch, state, std::move(result), nullptr, false);
            }
            continue;
        }
        auto error = std::make_shared<const ErrorInfo>(decode_error(payload));
        if (state) {
            finish(batch, state, {}, std::move(error), answer == AnswerState::pending);
        } else if (answer == AnswerState::failed) {
            report_failure(batch, {batch.transaction, std::move(error), nullptr});
        }
    }
    if (missing == 0) {
        return;
    }
    for (const auto& state : batch.states) {
        if (state->stage.load(std::memory_order_relaxed) == OperationState::Stage::sent && !state->fire_and_forget) {
            auto error = std::make_shared<const ErrorInfo>(ErrorInfo{ErrorCode::InternalError,
                "The engine answered the batch of " + describe(*state) + ", but not this operation.", describe(*state),
                {}, {}});
            finish(batch, state, {}, std::move(error), false);
        }
    }
}

void Session::Impl::finish_failed_batch(OperationBatch& batch, ErrorInfo error) {
    const auto shared = std::make_shared<const ErrorInfo>(std::move(error));
    for (const auto& state : batch.states) {
        if (!state->fire_and_forget) {
            finish(batch, state, {}, shared, false);
        }
    }
    const bool has_waiting_states =
        std::ranges::any_of(batch.states, [](const auto& state) { return !state->fire_and_forget; });
    if (batch.block != SPEAR_BLOCK_NONE ? batch.fire_and_forget != 0 || !has_waiting_states
                                        : batch.fire_and_forget != 0) {
        report_failure(batch, {batch.transaction, shared, nullptr});
    }
}

void Session::Impl::finish(OperationBatch& batch, const std::shared_ptr<OperationState>& state, RawResult result,
    std::shared_ptr<const ErrorInfo> error, bool is_late) {
    using Stage = OperationState::Stage;
    if (error && error->code == ErrorCode::DependencyFailed) {
        const auto failed = std::ranges::find_if(
            state->arguments, [](const auto& argument) { return argument->is_done() && argument->error; });
        if (failed != state->arguments.end()) {
            state->original = (*failed)->original ? (*failed)->original : (*failed)->error;
        }
    }
    if (state->fire_and_forget) {
        if (error && !is_late) {
            report_failure(batch, {batch.transaction, std::move(error), state->original});
        }
        state->arguments.clear();
        return;
    }
    if (const auto target = std::exchange(state->deliver_to, nullptr)) { // an answer to wait_for_result
        target->is_asked_for = false;
        if (error && error->code == ErrorCode::NeedsFrames) {
            target->ask_again_after = Clock::now() + Milliseconds(5);
            return;
        }
        result.entry_point = target->entry_point;
        result.shape = target->shape;
        late.erase(target->number);
        finish(batch, target, std::move(result), std::move(error), false);
        return;
    }
    state->arguments.clear();
    state->error = std::move(error);
    state->result = std::move(result);
    if (is_late && state->kept) {
        state->stage.store(Stage::late, std::memory_order_release);
        if (state->users != 0) {
            late.emplace(state->number, state);
        }
    } else {
        state->stage.store(Stage::done, std::memory_order_release);
    }
    if (state->users == 0 && std::exchange(state->kept, false)) {
        releases.push_back(state->number);
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
    const auto fail = [this](const std::shared_ptr<OperationState>& state) {
        if (!state->is_done()) {
            state->error = lost;
            state->arguments.clear();
            state->deliver_to = nullptr;
            state->stage.store(OperationState::Stage::done, std::memory_order_release);
        }
    };
    for (const auto& [request, batch] : in_flight) {
        std::ranges::for_each(batch.states, fail);
    }
    in_flight.clear();
    for (const auto& [number, state] : late) {
        fail(state);
    }
    late.clear();
    std::ranges::for_each(block.states, fail);
    releases.clear();
    changed.notify_all();
    if (has_leader && client) {
        spear_client_wake(client);
    }
}

/// Under the mutex. Results are released once they are there and nobody needs them any more.
void Session::Impl::drop_user(const std::shared_ptr<OperationState>& state) {
    if (--state->users != 0 || lost) {
        return;
    }
    const auto stage = state->stage.load(std::memory_order_relaxed);
    if (stage == OperationState::Stage::late) {
        late.erase(state->number);
    }
    if ((stage == OperationState::Stage::done || stage == OperationState::Stage::late) &&
        std::exchange(state->kept, false)) {
        releases.push_back(state->number);
    }
}

} // namespace spear
