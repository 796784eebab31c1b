// SPDX-License-Identifier: MIT
// Files and folders: modules, their headers, reading and writing.
#pragma once

#include "emit.h"
#include "model.h"

#include <nlohmann/json.hpp>

#include <memory>
#include <string>
#include <vector>

namespace spear::header_tool {

// Throws UserError naming the file and the system's reason.
std::string read_file(const std::string& path);
nlohmann::json read_json(const std::string& path);
// Creates missing folders; the file is complete or absent (written beside, then renamed).
void write_file(const std::string& path, const std::string& text);

// NAME=DIR, or DIR: the modules whose *.Build.cs lies in DIR or below it. Sorted by name.
std::vector<ModuleInfo> find_modules(const std::vector<std::string>& arguments);

// All *.h of the modules, sorted by module and path; Intermediate/, ThirdParty/, Binaries/ and hidden folders are left
// out.
std::vector<std::unique_ptr<Header>> find_headers(const std::vector<ModuleInfo>& modules);

// A Makefile fragment: the output depends on these headers and imports.
void write_depfile(const std::string& path, const std::string& output,
    const std::vector<std::unique_ptr<Header>>& headers, const std::vector<std::string>& imports);

} // namespace spear::header_tool
