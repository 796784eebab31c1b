// SPDX-License-Identifier: MIT
// One dump: from options to schema.json, report and depfile.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace spear::header_tool {

// Something the user has to put right: wrong path, unreadable file. The text names what was asked, what was found and
// what to do.
struct UserError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct DumpOptions {
    std::vector<std::string> modules; // NAME=DIR or DIR
    std::vector<std::string> imports;
    std::vector<std::string> defines; // NAME=VALUE or NAME
    std::string output, report, depfile;
    unsigned jobs = 0; // 0: one per core
    bool strict = false;
    bool quiet = false;
};

// Returns the exit code: 0, or 1 when --strict found errors (nothing is written then but the report). Throws UserError.
int run_dump(const DumpOptions& options);

} // namespace spear::header_tool
