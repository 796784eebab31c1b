// SPDX-License-Identifier: MIT
#pragma once

// What the server thread says about the engine: kept up to date by the game thread, read from any thread.

#include "CoreMinimal.h"

#include "spear/entry_points/types.hpp"

namespace SpearServer {

/// Looks again at what changes: the frame counter and the primary world. Game thread.
void UpdateEngineFacts();
spear::EngineInfo GetEngineFacts();

} // namespace SpearServer
