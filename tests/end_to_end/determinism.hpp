// SPDX-License-Identifier: MIT
#pragma once

// The scene that proves G9, the same as in tests/soak/determinism.py: moving and attached actors in a paused world, which
// each step unpauses for one frame.

#include <cstdint>
#include <vector>

#include "spear/spear.hpp"

namespace end_to_end {

/// All transforms after each of so many steps, ten numbers for each actor (quaternion X Y Z W, translation, scale), in
/// the order in which the actors were made. The engine must have been started with `paused`, `fixed_dt` and `seed`.
std::vector<double> run_scene(spear::Instance& instance, std::uint64_t steps);

/// `end_to_end_tests --determinism STEPS FILE ENGINE_ADDRESS`: runs it in the engine at an address and writes the numbers
/// to a file. Returns the exit code.
int run_determinism(const char* steps, const char* file, const char* address);

} // namespace end_to_end
