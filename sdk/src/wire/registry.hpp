// SPDX-License-Identifier: MIT
#pragma once

// Where running engines of this user are listed, for `spear engine list` and connect() without an address: a directory
// with one small JSON file for each, {"address": ..., "pid": ...}, written when a server starts and removed when it
// stops. A file whose process is gone counts as absent.

#include <string>

namespace spear::wire {

class RegistryEntry {
public:
    RegistryEntry() = default;
    /// Lists the engine; failure to write is no error (the directory may be read-only), the engine is just not listed.
    RegistryEntry(const std::string& directory, const std::string& address);
    ~RegistryEntry();
    RegistryEntry(const RegistryEntry&) = delete;
    RegistryEntry& operator=(const RegistryEntry&) = delete;

private:
    std::string file_;
};

/// $XDG_RUNTIME_DIR/spear, or /tmp/spear-<uid>; made with mode 0700 if it is absent. Empty if that cannot be had
/// safely.
std::string runtime_directory();

} // namespace spear::wire
