// SPDX-License-Identifier: MIT
#pragma once

// Trace: records what this program's threads and the engine's do, into one file that chrome://tracing and
// ui.perfetto.dev open (Chrome's trace event format):
//
//     {
//         spear::Trace trace(instance, {.file = "out.json"});
//         run();
//     } // written here; trace.stop() does the same and raises errors
//
// Without a change to the program: SPEAR_TRACE=out.json in its environment records from its first connection on, and
// writes when the last session is closed ("%p" in the name is the process id; SPEAR_TRACE_OPERATIONS=1: each operation
// as well). `spear trace` does that, draws a picture, and prints a summary. (docs/programming_model.md, "See it".)
//
// Times are CLOCK_MONOTONIC, which processes of one machine share. For an engine on another machine the distance
// between the clocks is measured by round trips at the start, as exact as half of the shortest of them.

#include <cstdint>
#include <filesystem>
#include <memory>

#include "spear/instance.hpp"

namespace spear {

struct TraceOptions {
    /// Where the trace goes. Replaced if it is there.
    std::filesystem::path file{};
    /// Each single operation as well: more to see, and more to record.
    bool operations = false;
    /// Room for events of each thread; what finds none is dropped, and the file says how many. At most
    /// limits::max_trace_events.
    std::uint64_t events_per_thread = 1u << 18;
};

/// A recording of this process and of one engine, from construction to stop(). One at a time in each process, and in
/// each engine: another client that starts one there ends this one's half. Members may be called from any thread.
class Trace {
public:
    /// Starts. Raises ArgumentError (this process records already, or no file is given), LimitExceeded, and what calls
    /// raise.
    Trace(std::shared_ptr<Session> session, TraceOptions options);
    Trace(const Instance& instance, TraceOptions options) : Trace(instance.session(), std::move(options)) {}
    /// Stops. Never throws: errors are logged.
    ~Trace();
    Trace(const Trace&) = delete;
    Trace& operator=(const Trace&) = delete;

    /// Ends the recording and writes the file. Raises ConnectionError if the file cannot be written, UnknownObject if
    /// another client has started a recording in the engine meanwhile (the file then has this process alone), and what
    /// calls raise. Stopping twice is fine.
    void stop();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace spear
