// SPDX-License-Identifier: MIT
#include "spear/trace.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include <fmt/format.h>
#include <unistd.h>

#include "spear/log.hpp"
#include "trace_file.hpp"
#include "trace_process.hpp"

namespace spear {
namespace {

using detail::RecordedProcess;
using detail::RecordedThread;

/// Whether something in this process records: it can be one thing at a time.
std::atomic<bool> is_recording{false};

/// The recording of this process.
RecordedProcess take_own(std::uint64_t recording) {
    RecordedProcess process;
    process.id = static_cast<std::uint64_t>(::getpid());
    process.name = fmt::format("client: {} (process {})", program_invocation_short_name, ::getpid());
    const std::unique_ptr<spear_trace, decltype(&spear_trace_free)> ended(
        spear_trace_stop(recording), &spear_trace_free);
    if (!ended) {
        return process;
    }
    for (std::size_t i = 0; i < spear_trace_thread_count(ended.get()); ++i) {
        RecordedThread thread;
        const char* name = nullptr;
        std::size_t count = 0;
        const spear_trace_event* events =
            spear_trace_thread(ended.get(), i, &name, &thread.id, &count, &thread.dropped);
        thread.name = name;
        thread.events.assign(events, events + count);
        process.threads.push_back(std::move(thread));
    }
    for (std::size_t i = 1; i <= spear_trace_text_count(ended.get()); ++i) {
        process.texts.emplace_back(spear_trace_text_at(ended.get(), i));
    }
    return process;
}

/// The engine's half of a recording.
struct EngineRecording {
    std::uint64_t number = 0;
    std::int64_t clock_offset = 0; ///< the engine's clock minus ours

    /// Raises what calls raise.
    static EngineRecording start(Session& session, bool operations, std::uint64_t events_per_thread) {
        EngineRecording made;
        std::uint64_t shortest = ~std::uint64_t{0};
        for (int i = 0; i < 16; ++i) {
            const std::uint64_t before = spear_trace_now();
            const std::uint64_t there = session.call(trace_service::get_clock);
            const std::uint64_t trip = spear_trace_now() - before;
            if (trip < shortest) {
                shortest = trip;
                made.clock_offset = static_cast<std::int64_t>(there - (before + trip / 2));
            }
        }
        // On one machine there is one clock. What is no larger than the error of measuring is none.
        if (static_cast<std::uint64_t>(std::abs(made.clock_offset)) <= shortest) {
            made.clock_offset = 0;
        }
        made.number = session.call(trace_service::start, operations, events_per_thread);
        return made;
    }

    RecordedProcess take(Session& session) const {
        RecordedProcess process;
        const EngineInfo info = session.call(engine_service::get_engine_info);
        process.name = fmt::format("engine: {}{}{} (process {})", info.engine_name, info.scene.empty() ? "" : ", ",
            info.scene, info.process_id);
        process.is_engine = true;
        // Lets the frame end that is under way, unless somebody holds the engine: only whole frames are shown.
        for (int i = 0; i < 50 && session.call(engine_service::get_frame_number) == info.frame; ++i) {
            std::this_thread::sleep_for(Milliseconds(1));
        }
        for (std::uint64_t part = 0, parts = 1; part < parts; ++part) {
            TracePart got = session.call(trace_service::stop, number, part);
            parts = got.parts;
            process.id = got.process_id;
            if (part == 0) {
                process.texts = std::move(got.texts);
            }
            const auto same = [&](const RecordedThread& thread) { return thread.id == got.thread_id; };
            auto thread = std::ranges::find_if(process.threads, same);
            if (thread == process.threads.end()) {
                process.threads.push_back({got.thread_id, got.thread, got.dropped, {}});
                thread = process.threads.end() - 1;
            }
            for (std::size_t i = 0; i + 5 <= got.events.size(); i += 5) {
                const std::uint64_t* const word = got.events.data() + i;
                thread->events.push_back({word[0] - static_cast<std::uint64_t>(clock_offset), word[1],
                    static_cast<std::uint16_t>(word[2]), static_cast<std::uint16_t>(word[2] >> 16),
                    static_cast<std::uint32_t>(word[2] >> 32), word[3], word[4]});
            }
        }
        return process;
    }
};

std::uint64_t start_own(bool operations, std::uint64_t events_per_thread) {
    const std::uint64_t number = spear_trace_start(
        operations ? SPEAR_TRACE_OPERATIONS : SPEAR_TRACE_ON, static_cast<std::size_t>(events_per_thread));
    if (number == 0) {
        throw_error(ErrorCode::LimitExceeded, "There is no memory for a recording.", "trace");
    }
    return number;
}

} // namespace

// Trace

struct Trace::Impl {
    std::shared_ptr<Session> session;
    TraceOptions options;
    EngineRecording engine;
    std::uint64_t own = 0;
    std::mutex mutex;
    bool is_stopped = false; // under mutex
};

Trace::Trace(std::shared_ptr<Session> session, TraceOptions options) : impl_(std::make_unique<Impl>()) {
    if (options.file.empty()) {
        throw_error(ErrorCode::ArgumentError, "A trace needs a file: TraceOptions::file is empty.", "trace", "file");
    }
    if (is_recording.exchange(true)) {
        throw_error(ErrorCode::ArgumentError,
            "This process is being recorded already, by another spear::Trace or by SPEAR_TRACE in its environment.",
            "trace");
    }
    try {
        impl_->session = std::move(session);
        impl_->options = std::move(options);
        impl_->engine =
            EngineRecording::start(*impl_->session, impl_->options.operations, impl_->options.events_per_thread);
        impl_->own = start_own(impl_->options.operations, impl_->options.events_per_thread);
    } catch (...) {
        is_recording = false;
        throw;
    }
}

Trace::~Trace() {
    try {
        stop();
    } catch (const std::exception& exception) {
        log_message(LogLevel::error, std::string("a trace could not be written: ") + exception.what());
    }
}

void Trace::stop() {
    const std::lock_guard lock(impl_->mutex);
    if (std::exchange(impl_->is_stopped, true)) {
        return;
    }
    std::vector<RecordedProcess> processes;
    processes.push_back(take_own(impl_->own));
    is_recording = false;
    std::exception_ptr failure;
    try {
        processes.push_back(impl_->engine.take(*impl_->session));
    } catch (const Error&) {
        failure = std::current_exception();
    }
    detail::write_trace_file(impl_->options.file, std::move(processes));
    if (failure) {
        std::rethrow_exception(failure);
    }
}

// SPEAR_TRACE

namespace detail {
namespace {

/// The recording of this process that its environment asks for.
class ProcessTrace {
public:
    explicit ProcessTrace(std::string file) : file_(std::move(file)) {
        if (const std::size_t at = file_.find("%p"); at != std::string::npos) {
            file_.replace(at, 2, std::to_string(::getpid()));
        }
        const char* const operations = std::getenv("SPEAR_TRACE_OPERATIONS");
        operations_ = operations && *operations && std::string_view(operations) != "0";
    }

    void connected(const std::shared_ptr<Session>& session) {
        const std::lock_guard lock(mutex_);
        if (own_ == 0) {
            if (is_recording.exchange(true)) {
                return; // the program has a spear::Trace of its own
            }
            own_ = start_own(operations_, TraceOptions().events_per_thread);
        }
        Engine& engine = engines_[session->address()];
        if (engine.sessions.empty()) {
            engine.recording = EngineRecording::start(*session, operations_, TraceOptions().events_per_thread);
        }
        engine.sessions.emplace_back(session.get(), session);
    }

    /// `session` is about to close. The last one of an engine takes the engine's half with it.
    void closes(Session& session) {
        const std::lock_guard lock(mutex_);
        const auto engine = engines_.find(session.address());
        if (engine == engines_.end() ||
            std::erase_if(engine->second.sessions, [&](const auto& one) { return one.first == &session; }) == 0) {
            return;
        }
        if (engine->second.sessions.empty()) {
            take(engine->second, session.weak_from_this().lock());
            engines_.erase(engine);
        }
        if (engines_.empty()) {
            write();
        }
    }

    /// The program ends, with sessions that it did not close.
    void finish() {
        const std::lock_guard lock(mutex_);
        for (auto& [address, engine] : engines_) {
            for (const auto& [number, weak] : engine.sessions) {
                if (const auto session = weak.lock(); session && session->is_open()) {
                    take(engine, session);
                    break;
                }
            }
        }
        engines_.clear();
        if (own_ != 0) {
            write();
        }
    }

private:
    struct Engine {
        EngineRecording recording;
        std::vector<std::pair<const Session*, std::weak_ptr<Session>>> sessions;
    };

    void take(const Engine& engine, const std::shared_ptr<Session>& session) {
        try {
            if (session) {
                done_.push_back(engine.recording.take(*session));
            }
        } catch (const std::exception& exception) {
            log_message(LogLevel::warning,
                fmt::format("SPEAR_TRACE: nothing of the engine at {}: {}", session->address(), exception.what()));
        }
    }

    void write() {
        done_.insert(done_.begin(), take_own(std::exchange(own_, 0)));
        is_recording = false;
        write_trace_file(file_, done_);
    }

    std::mutex mutex_; // guards what follows; calls to the engine are made under it
    std::string file_;
    bool operations_ = false;
    std::uint64_t own_ = 0;                 // the recording of this process
    std::map<std::string, Engine> engines_; // by address
    std::vector<RecordedProcess> done_;     // of sessions that are closed
};

/// Null without SPEAR_TRACE. Never destroyed: sessions may close during the end of the program.
ProcessTrace* process_trace() {
    static ProcessTrace* const made = []() -> ProcessTrace* {
        const char* const file = std::getenv("SPEAR_TRACE");
        if (!file || !*file) {
            return nullptr;
        }
        std::atexit([] { trace_program_ends(); });
        return new ProcessTrace(file);
    }();
    return made;
}

template <typename F>
void guarded(F&& f) noexcept {
    try {
        if (ProcessTrace* const trace = process_trace()) {
            f(*trace);
        }
    } catch (const std::exception& exception) {
        log_message(LogLevel::warning, std::string("SPEAR_TRACE: ") + exception.what());
    }
}

} // namespace

void trace_session_connected(const std::shared_ptr<Session>& session) noexcept {
    guarded([&](ProcessTrace& trace) { trace.connected(session); });
}
void trace_session_closes(Session& session) noexcept {
    guarded([&](ProcessTrace& trace) { trace.closes(session); });
}
void trace_program_ends() noexcept {
    guarded([](ProcessTrace& trace) { trace.finish(); });
}

} // namespace detail
} // namespace spear
