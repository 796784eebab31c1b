// SPDX-License-Identifier: MIT
#pragma once

// Instance: a connection to a running engine, or an engine started for this program. Where every program begins.
//
//     spear::Instance instance = spear::launch({.scene = "apartment"});
//     spear::Instance instance = spear::connect("unix:/run/user/1000/spear/editor.sock");

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "spear/frame.hpp"
#include "spear/game.hpp"
#include "spear/launch.hpp"
#include "spear/session.hpp"

namespace spear {

/// Movable. Its end closes the session (and the engine, if launch() started it); Objects and Futures that outlive it
/// raise Disconnected. Members may be called from any thread; blocks belong to the thread that opens them.
class Instance {
public:
    explicit Instance(std::shared_ptr<Session> session, std::shared_ptr<EngineProcess> process = nullptr);
    Instance(Instance&&) noexcept = default;
    Instance& operator=(Instance&& other) noexcept;
    ~Instance();

    // Frames (frame.hpp)

    /// Opens the first block of a transaction.
    Frame begin_frame() { return Frame(session_, BlockKind::begin); }
    /// Opens the second.
    Frame end_frame(EndFrameOptions options = {}) { return Frame(session_, BlockKind::end, options); }
    /// Lets the engine run that many frames and returns with the engine held at the beginning of the next one, as after
    /// end_frame({.single_step = true}). Raises FrameMisuse while a transaction is open.
    void step(std::uint64_t frames = 1);
    /// Waits until everything sent has run; raises fire-and-forget failures. Not within a block.
    void flush() { session_->flush(); }

    // What is at the other end

    Game game() const { return Game(session_); }
    EngineInfo engine_info() const { return session_->call(engine_service::get_engine_info); }
    std::uint64_t frame_number() const { return session_->call(engine_service::get_frame_number); }
    const std::shared_ptr<Session>& session() const noexcept { return session_; }
    /// Messages and bytes that have travelled so far, and results kept: see Session::Statistics.
    Session::Statistics statistics() { return session_->statistics(); }
    /// The process that launch() started; null for connect().
    EngineProcess* process() const noexcept { return process_.get(); }

    // Entry points (entry_points/*.hpp)

    template <typename E, typename... A>
    auto call(const E& entry_point, const A&... arguments) {
        return session_->call(entry_point, arguments...);
    }
    template <typename E, typename... A>
    auto async(const E& entry_point, const A&... arguments) {
        return session_->async(entry_point, arguments...);
    }
    template <typename E, typename... A>
    void send(const E& entry_point, const A&... arguments) {
        session_->send(entry_point, arguments...);
    }

    /// Ends the session, and an engine started by launch() with it. Never throws. Closing twice is fine.
    void close() noexcept;

private:
    std::shared_ptr<Session> session_;
    std::shared_ptr<EngineProcess> process_;
};

/// Connects to a running engine: "unix:/path", "tcp://host:port", or "" for the only engine of this user that runs.
/// Raises EngineNotRunning, VersionMismatch, Unauthorized, AmbiguousName ("" while several run).
Instance connect(std::string_view address = "", SessionOptions options = {});

/// Starts an engine and connects when it answers. Raises LaunchFailed, EngineExited (with exit code and the last lines
/// of its log), EngineBusy (it runs, but does not answer within connect_timeout), VersionMismatch.
Instance launch(const LaunchOptions& options = {});

} // namespace spear
