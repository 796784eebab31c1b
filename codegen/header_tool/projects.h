// SPDX-License-Identifier: MIT
// Which modules a run is about: from folders, projects, plugins and an engine.
#pragma once

#include "emit.h"
#include "report.h"

#include <functional>
#include <string>
#include <vector>

namespace spear::header_tool {

struct Places {
    std::vector<std::string> modules;  // NAME=DIR or DIR
    std::vector<std::string> projects; // X.uproject, or its folder
    std::vector<std::string> plugins;  // X.uplugin, or its folder
    std::string engine;                // folder that holds Engine/, or Engine/ itself; "" for none
    bool write_engine = false;         // write the engine's modules too, not only know them
};

struct FoundModules {
    std::vector<ModuleInfo> modules; // sorted by name, the written ones first
    std::vector<std::string> errors; // places that could not be used
};

// Modules by their *.Build.cs. A second module of a name is left out and reported; a wrong place is one of the errors.
// Throws UserError for arguments that contradict themselves.
FoundModules find_modules(const Places& places, Report& report);

// Calls `use` for each regular file below `root`, in no particular order. Each folder is visited once, also when links
// lead to it twice; folders for which `skip` says so (by name) are not entered. Unreadable ones are reported.
void walk(const std::string& root, Report& report, const std::function<bool(const std::string& folder)>& skip,
    const std::function<void(const std::string& path, const std::string& name)>& use);

// Intermediate/, ThirdParty/, Binaries/, hidden folders and the like.
bool ignored_folder(const std::string& name);

} // namespace spear::header_tool
