// SPDX-License-Identifier: MIT
#pragma once

// One file per service; each binds its entry points.

#include "CoreMinimal.h"

#include "Frame/Inbox.h"

#include <functional>

namespace SpearServer {

void BindEngineService();
void BindTraceService();
void BindUnrealService();
void BindUnrealQueries();

/// Whether the session holds the engine right now, by a block or by single_step; set by the server.
void SetHolderQuery(std::function<uint64()> InGetHolder);
uint64 GetHolderOfEngine();

} // namespace SpearServer
