// SPDX-License-Identifier: MIT
#pragma once

// What the SDK tells when nobody can catch it: failures of a block that was left by an exception, a lost engine at
// shutdown.

#include <functional>
#include <string_view>

namespace spear {

enum class LogLevel { info, warning, error };

/// Receives every message. May run on the session's I/O thread, so it must not block nor call the SDK.
using LogHandler = std::function<void(LogLevel level, std::string_view message)>;

/// Replaces the handler (any thread); an empty one restores the default, which writes "spear: warning: ..." to standard
/// error.
void set_log_handler(LogHandler handler);

/// Never throws, whatever the handler does.
void log_message(LogLevel level, std::string_view message) noexcept;

} // namespace spear
