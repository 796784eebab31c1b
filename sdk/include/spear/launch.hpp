// SPDX-License-Identifier: MIT
#pragma once

// Starting an engine process and looking after it. `spear::launch` (instance.hpp) does this and connects.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
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
    /// Where the engine shall listen. Empty: a new private Unix socket.
    std::string address{};
    /// How long starting may take, in all.
    Milliseconds connect_timeout{60'000};
    /// Where standard output and error of the engine go. Empty: a file that is removed when the engine has ended well.
    std::filesystem::path log_file{};
    /// As in SessionOptions.
    std::string client_name{};
    Milliseconds lease{0};
    bool no_lease = false;
    Milliseconds deadline{limits::default_deadline_ms};
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
    const std::string& address() const noexcept;
    std::int64_t process_id() const noexcept;
    const std::filesystem::path& log_file() const noexcept;
    bool is_running() const noexcept;
    /// Waits until the process has ended; false if the timeout has passed.
    bool wait(Milliseconds timeout) const noexcept;
    /// Ends it as the destructor does.
    void terminate() noexcept;
    /// How it ended, with exit code or signal and the last lines of its log: an EngineExited. Empty while it runs.
    std::optional<ErrorInfo> describe_exit() const;

private:
    struct Impl;
    std::shared_ptr<Impl> impl_;
};

} // namespace spear
