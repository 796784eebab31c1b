// SPDX-License-Identifier: MIT
#pragma once

// What a trace shows of a frame that no single function spans: the frame itself, the world's tick, and the sleep that
// keeps the frame rate. By Unreal's public delegates and FApp alone. Game thread.

#include "CoreMinimal.h"

#include "Delegates/IDelegateInstance.h"
#include "Engine/EngineBaseTypes.h"

#include "spear_trace.h"

#include <cstddef>
#include <optional>
#include <span>

class UWorld;

namespace SpearServer {

class FSession;

/// Records one operation under its name ("SetActorScale3D"), if operations are recorded.
class FOperationTrace {
public:
    FOperationTrace(const FSession* Session, uint64 Number, uint16 EntryPoint, std::span<const std::byte> Arguments) {
        if (SPEAR_TRACE_LEVEL() == SPEAR_TRACE_OPERATIONS) {
            Start(Session, Number, EntryPoint, Arguments);
        }
    }

private:
    void Start(const FSession* Session, uint64 Number, uint16 EntryPoint, std::span<const std::byte> Arguments);

    std::optional<spear::TraceSpan> Span;
};

class FFrameTrace {
public:
    /// Binds to the delegates of worlds, and names the thread.
    void Start();
    void Stop();

    /// At the very beginning of OnBeginFrame.
    void BeginFrame();
    /// At the very end of OnBeginFrame: the engine sleeps next, if the frame rate is to be kept.
    void EndBeginWork();
    /// At the very end of OnEndFrame.
    void EndFrame();

private:
    void OnWorldTickStart(UWorld* World, ELevelTick TickType, float DeltaSeconds);
    void OnWorldTickEnd(UWorld* World, ELevelTick TickType, float DeltaSeconds);
    void RecordIdleTime(uint64 Until);

    uint64 FrameBegan = 0; ///< nanoseconds; 0: this frame is not recorded
    uint64 FrameNumber = 0;
    uint64 BeginWorkEnded = 0; ///< 0: the idle time of this frame is recorded
    uint64 TickBegan = 0;
    FDelegateHandle TickStartHandle;
    FDelegateHandle TickEndHandle;
};

} // namespace SpearServer
