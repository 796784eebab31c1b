// SPDX-License-Identifier: MIT
#include "spear/instance.hpp"

#include <algorithm>
#include <chrono>
#include <thread>

#include <fmt/format.h>

namespace spear {

Instance::Instance(std::shared_ptr<Session> session, std::shared_ptr<EngineProcess> process)
    : session_(std::move(session)), process_(std::move(process)) {}

Instance& Instance::operator=(Instance&& other) noexcept {
    if (this != &other) {
        close();
        session_ = std::move(other.session_);
        process_ = std::move(other.process_);
    }
    return *this;
}

Instance::~Instance() { close(); }

void Instance::close() noexcept {
    if (session_) {
        session_->close();
    }
    if (process_) {
        process_->terminate();
        process_.reset();
    }
}

void Instance::step(std::uint64_t frames) {
    for (std::uint64_t i = 0; i < frames; ++i) {
        begin_frame().execute();
        end_frame({.single_step = true}).execute();
    }
    session_->flush();
}

Instance connect(std::string_view address, SessionOptions options) {
    options.address = address;
    return Instance(Session::connect(options));
}

namespace {

/// At an address that the user chose, another engine may have been first: then the one launched ends by itself.
void require_own_engine(Session& session, const EngineProcess& process) {
    const EngineInfo info = session.call(engine_service::get_engine_info);
    if (process.has_command_line(info.command_line)) {
        return;
    }
    session.close();
    process.wait(Milliseconds(10'000));
    if (auto exit = process.describe_exit()) {
        exit->message = "The engine ended while it was starting. " + exit->message;
        throw_error(std::move(*exit));
    }
    throw_error(ErrorCode::LaunchFailed,
        fmt::format("Another engine (process {}) serves at {}, not the one that was launched.", info.process_id,
            process.address()),
        "launch");
}

} // namespace

Instance launch(const LaunchOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    auto process = std::make_shared<EngineProcess>(options);
    SessionOptions session_options{.address = process->address(),
        .client_name = options.client_name,
        .lease = options.lease,
        .no_lease = options.no_lease,
        .deadline = options.deadline,
        .channel = options.channel,
        .spin = options.spin};
    session_options.token = process->token();
    Milliseconds pause(5);
    while (true) {
        if (auto exit = process->describe_exit()) {
            exit->message = "The engine ended while it was starting. " + exit->message;
            throw_error(std::move(*exit));
        }
        const auto spent = std::chrono::duration_cast<Milliseconds>(std::chrono::steady_clock::now() - start);
        session_options.connect_timeout = std::max(Milliseconds(1), options.connect_timeout - spent);
        try {
            if (!process->find_port()) {
                throw_error(ErrorCode::EngineNotRunning, "The engine does not listen yet.", "launch");
            }
            session_options.address = process->address();
            auto session = Session::connect(session_options);
            if (!options.address.empty()) {
                require_own_engine(*session, *process);
            }
            session->set_loss_explainer([weak = std::weak_ptr(process)]() -> std::optional<ErrorInfo> {
                const auto engine = weak.lock();
                if (!engine ||
                    !engine->wait(Milliseconds(2000))) { // the connection breaks a moment before the process has ended
                    return {};
                }
                return engine->describe_exit();
            });
            return Instance(std::move(session), std::move(process));
        } catch (const EngineNotRunning& error) {
            if (spent >= options.connect_timeout) {
                throw_error(ErrorCode::EngineBusy,
                    fmt::format(
                        "The engine {} (process {}) runs, but does not answer at {} after {} ms. Its log is {}.",
                        process->executable().string(), process->process_id(), process->address(), spent.count(),
                        process->log_file().string()),
                    "launch");
            }
        }
        process->wait(pause);
        pause = std::min(pause * 2, Milliseconds(50));
    }
}

} // namespace spear
