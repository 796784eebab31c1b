// SPDX-License-Identifier: MIT
// One dump: from options to schema.json, report and depfile.
#pragma once

#include "projects.h"

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace spear::header_tool {

// Something the user has to put right: wrong path, unreadable file. The text names what was asked, what was found and
// what to do.
struct UserError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct DumpOptions {
    Places places;
    std::vector<std::string> imports;
    std::vector<std::string> defines; // NAME=VALUE or NAME
    std::string output, report, depfile;
    std::optional<std::string> cache; // folder; not given: the user's cache folder
    bool no_cache = false;
    std::uint64_t cache_mebibytes = 1024;
    unsigned jobs = 0; // 0: one per core
    bool strict = false;
    bool quiet = false;
};

// Returns the exit code: 0; 1 when --strict found errors (nothing is written then but the report); 2 when a place could
// not be used (what the others hold is written). Throws UserError.
int run_dump(const DumpOptions& options);

} // namespace spear::header_tool
