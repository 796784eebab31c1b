// SPDX-License-Identifier: MIT
#pragma once

// The trace that SPEAR_TRACE in the environment asks for: what sessions tell it. Any thread; nothing without
// SPEAR_TRACE.

#include <memory>

namespace spear {

class Session;

namespace detail {

/// A session stands.
void trace_session_connected(const std::shared_ptr<Session>& session) noexcept;
/// A session is about to close; it still answers.
void trace_session_closes(Session& session) noexcept;
void trace_program_ends() noexcept;

} // namespace detail
} // namespace spear
