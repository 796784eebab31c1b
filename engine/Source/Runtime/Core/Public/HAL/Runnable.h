// SPDX-License-Identifier: MIT
#pragma once

#include "CoreTypes.h"

/** What a thread runs. */
class FRunnable {
public:
    virtual ~FRunnable() = default;
    /** First on the new thread; false ends it. */
    virtual bool Init() { return true; }
    /** The thread's work; returns its exit code. */
    virtual uint32 Run() = 0;
    /** Asks it to end; called from another thread. */
    virtual void Stop() {}
    /** Last on the thread. */
    virtual void Exit() {}
};
