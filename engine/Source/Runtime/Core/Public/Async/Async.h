// SPDX-License-Identifier: MIT
/** AsyncTask. */
#pragma once

#include "Async/TaskGraphInterfaces.h"

/** Runs a function on the game thread (at its next pump) or on a worker. */
inline void AsyncTask(ENamedThreads::Type Thread, TUniqueFunction<void()> Function) {
    FTaskGraphInterface::Get().QueueTask(Thread, MoveTemp(Function));
}
