// SPDX-License-Identifier: MIT
#pragma once

// trace_service: records what the engine's threads do, for `spear trace` (trace.hpp). Answered by the server thread, also while the game
// thread is busy or held.

#include <cstdint>
#include <string>
#include <vector>

#include "spear/entry_point.hpp"

namespace spear {

/// A part of an ended recording: some events of one thread.
struct TracePart {
    std::uint64_t process_id = 0;
    std::uint64_t thread_id = 0;
    std::string thread;
    std::uint64_t dropped = 0;           ///< events of this thread that found no room
    std::vector<std::uint64_t> events;   ///< five numbers each: begin and duration in nanoseconds, kind | detail << 16 | text << 32, a, b
    std::vector<std::string> texts;      ///< in the first part: all texts that events name, from number 1
    std::uint64_t parts = 0;             ///< how many there are
};
template <>
struct Members<TracePart> {
    static constexpr std::string_view name = "TracePart";
    static constexpr auto list = std::tuple{Member{"process_id", &TracePart::process_id}, Member{"thread_id", &TracePart::thread_id},
        Member{"thread", &TracePart::thread}, Member{"dropped", &TracePart::dropped}, Member{"events", &TracePart::events},
        Member{"texts", &TracePart::texts}, Member{"parts", &TracePart::parts}};
};

namespace trace_service {

inline constexpr EntryPoint<"trace_service.start", std::uint64_t(bool, std::uint64_t), Names<"operations", "events_per_thread">, RunsOn::server_thread,
    "Begins to record what the engine's threads do; with `operations` also each single operation. A recording that runs is given up for it. Returns "
    "its number. What finds no room is dropped and counted."> start;

inline constexpr EntryPoint<"trace_service.stop", TracePart(std::uint64_t, std::uint64_t), Names<"recording", "part">, RunsOn::server_thread,
    "Ends a recording and gives one part of it, counted from 0; ask until all parts are there. Raises UnknownObject if the recording was given up "
    "for another one."> stop;

inline constexpr EntryPoint<"trace_service.get_clock", std::uint64_t(), Names<>, RunsOn::server_thread,
    "Nanoseconds of the clock that recordings are made with (CLOCK_MONOTONIC of the engine's machine)."> get_clock;

using List = EntryPointList<std::remove_cv_t<decltype(start)>, std::remove_cv_t<decltype(stop)>, std::remove_cv_t<decltype(get_clock)>>;

} // namespace trace_service
} // namespace spear
