// SPDX-License-Identifier: MIT
// Files and folders: modules, their headers, reading and writing.
#pragma once

#include "emit.h"
#include "model.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace spear::header_tool {

// Throws UserError naming the file and the system's reason.
std::string read_file(const std::string& path);
nlohmann::json read_json(const std::string& path);
// Creates missing folders; the file is complete or absent (written beside, then renamed).
void write_file(const std::string& path, const std::string& text);
void write_file(const std::string& path, const std::function<void(std::ostream&)>& write);

// All *.h of the modules, in the order of the modules, by path; Intermediate/, ThirdParty/, Binaries/ and hidden
// folders are left out. Folders that cannot be read are in the report.
std::vector<std::unique_ptr<Header>> find_headers(const std::vector<ModuleInfo>& modules, Report& report);

// A Makefile fragment: the output depends on these headers and imports.
void write_depfile(const std::string& path, const std::string& output, const std::vector<std::string>& headers,
    const std::vector<std::string>& imports);

} // namespace spear::header_tool
