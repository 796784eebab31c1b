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

/// Ends the engine if an operation has asked for it. Any thread, after the operation's answer was sent: it would be
/// lost if the engine ended first.
void ExitIfAsked();

/// Whether the session holds the engine right now, by a block or by single_step; set by the server.
void SetHolderQuery(std::function<uint64()> InGetHolder);
uint64 GetHolderOfEngine();

} // namespace SpearServer
