// SPDX-License-Identifier: MIT
#pragma once

// Starting an engine process and looking after it. `spear::launch` (instance.hpp) does this and connects.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spear/error_code.hpp"
#include "spear/operation.hpp"

namespace spear {

/// What to start, and how. Everything has a sensible default.
struct LaunchOptions {
    /// Scene to load ("apartment"); empty: the engine's default.
    std::string scene{};
    /// Frames per second to run at; 0: as fast as possible. Unset: the engine's default.
    std::optional<double> fps{};
    /// Seconds of simulated time per frame, for exact stepping (G9). Unset: measured time.
    std::optional<double> fixed_dt{};
    /// Seed of the engine's random numbers. Unset: the engine's default.
    std::optional<std::uint64_t> seed{};
    /// Start with the game paused.
    bool paused = false;
    /// The engine. Empty: the environment variable SPEAR_ENGINE, else `spear-engine` next to this library, else on
    /// PATH.
    std::filesystem::path executable{};
    /// Further arguments, after our own options and before -SpearAddress=.
    std::vector<std::string> arguments{};
    /// Where the engine shall listen: "unix:/path", "tcp://127.0.0.1:port" (port 0: any). Empty: a new private Unix
    /// socket. An engine that cannot listen there ends, and launch() raises EngineExited with the reason.
    std::string address{};
    /// The token that clients must give. Empty: for addresses that other machines can reach a random one is made, else
    /// there is none.
    std::string token{};
    /// How long starting may take, in all.
    Milliseconds connect_timeout{60'000};
    /// Where standard output and error of the engine go. Empty: a file that is removed when the engine has ended well.
    std::filesystem::path log_file{};
    /// As in SessionOptions.
    std::string client_name{};
    Milliseconds lease{0};
    bool no_lease = false;
    Milliseconds deadline{limits::default_deadline_ms};
    bool channel = true;
    bool spin = true;
};

/// The `spear-engine` that launch() would start. Raises LaunchFailed, which lists where it looked.
std::filesystem::path find_engine_executable();

/// A child process that runs an engine. It ends with this object, and with this process however that ends.
class EngineProcess {
public:
    /// Starts it; does not wait for it to answer. Raises LaunchFailed.
    explicit EngineProcess(const LaunchOptions& options);
    /// Ends the engine: asks (SIGTERM), waits a few seconds, kills.
    ~EngineProcess();
    EngineProcess(const EngineProcess&) = delete;
    EngineProcess& operator=(const EngineProcess&) = delete;

    const std::filesystem::path& executable() const noexcept;
    /// With the port that the engine chose, once launch() has connected.
    const std::string& address() const noexcept;
    /// The token that clients must give; empty: none.
    const std::string& token() const noexcept;
    std::int64_t process_id() const noexcept;
    const std::filesystem::path& log_file() const noexcept;
    bool is_running() const noexcept;
    /// Waits until the process has ended; false if the timeout has passed.
    bool wait(Milliseconds timeout) const noexcept;
    /// Ends it as the destructor does.
    void terminate() noexcept;
    /// How it ended, with exit code or signal and the last lines of its log: an EngineExited. Empty while it runs.
    std::optional<ErrorInfo> describe_exit() const;

    /// Completes address() by the port that the engine chose, if it was to choose one; false while the engine does not
    /// say. launch() does this; not while other threads use this object.
    bool find_port();
    /// Whether a command line (EngineInfo::command_line) is that of this engine, and not of another one at the same
    /// address.
    bool has_command_line(std::string_view command_line) const;

private:
    struct Impl;
    std::shared_ptr<Impl> impl_;
};

} // namespace spear
