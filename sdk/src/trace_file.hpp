// SPDX-License-Identifier: MIT
#pragma once

// What a recording consists of once it has been taken from the processes, and the file that is made of it.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "spear_trace.h"

namespace spear::detail {

struct RecordedThread {
    std::uint64_t id = 0;
    std::string name;
    std::uint64_t dropped = 0;
    std::vector<spear_trace_event> events; ///< times on the clock of the process that writes the file
};

struct RecordedProcess {
    std::uint64_t id = 0;
    std::string name;
    bool is_engine = false;
    std::vector<RecordedThread> threads;
    std::vector<std::string> texts; ///< from number 1
};

/// Writes them as Chrome trace events. Events of frames that were not recorded from beginning to end are left out.
/// Raises ConnectionError if the file cannot be written.
void write_trace_file(const std::filesystem::path& file, std::vector<RecordedProcess> processes);

} // namespace spear::detail
