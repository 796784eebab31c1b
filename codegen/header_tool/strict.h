// SPDX-License-Identifier: MIT
// What UE's own header tool rejects and clang accepts. Errors with --strict, warnings otherwise.
#pragma once

#include "model.h"
#include "registry.h"
#include "report.h"

namespace spear::header_tool {

void check_rules(const Header& header, const Registry& registry, Report& report);

} // namespace spear::header_tool
