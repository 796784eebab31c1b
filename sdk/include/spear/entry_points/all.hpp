// SPDX-License-Identifier: MIT
#pragma once

// Every entry point, in the order of their numbers on the wire. A new service is a header beside this one and a line here.

#include "spear/entry_points/engine_service.hpp"
#include "spear/entry_points/trace_service.hpp"
#include "spear/entry_points/unreal_service.hpp"

namespace spear {

using AllEntryPoints = JoinLists<engine_service::List, unreal_service::List, trace_service::List>::type;

} // namespace spear
