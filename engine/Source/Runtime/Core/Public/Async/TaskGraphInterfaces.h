// SPDX-License-Identifier: MIT
/** ENamedThreads, and the queue of work for the game thread. */
#pragma once

#include "Templates/Function.h"
#include "Templates/RefCounting.h"

namespace ENamedThreads {
enum Type : int32 {
    UnusedAnchor = -1,
    GameThread = 0,
    ActualRenderingThread = 1,
    AnyThread = 0xff,
    AnyNormalThreadNormalTask = AnyThread,
    AnyBackgroundThreadNormalTask = AnyThread,
    AnyHiPriThreadHiPriTask = AnyThread,
};
} // namespace ENamedThreads

class FTaskGraphInterface {
public:
    static CORE_API FTaskGraphInterface& Get();
    /** Runs the game thread's queued work; the engine loop calls this once a frame. Returns how much there was. */
    CORE_API int32 ProcessThreadUntilIdle(ENamedThreads::Type CurrentThread);
    CORE_API void QueueTask(ENamedThreads::Type Thread, TUniqueFunction<void()> Function);
    CORE_API int32 GetNumWorkerThreads() const;
    /** Ends the worker threads after what they are doing; later work for them is refused with a check. */
    CORE_API void Shutdown();

private:
    FTaskGraphInterface() = default;
};

/** Completion event of a task: what tick functions have in their signature. */
class FGraphEvent : public FRefCountBase {};

/** Counted reference to a completion event. */
using FGraphEventRef = TRefCountPtr<FGraphEvent>;
