// SPDX-License-Identifier: MIT
/** FEvent: threads wait until it is triggered. */
#pragma once

#include "HAL/PlatformProcess.h"
#include "Misc/Timespan.h"

class FEvent {
public:
    virtual ~FEvent() = default;
    virtual bool Create(bool bIsManualReset = false) = 0;
    virtual bool IsManualReset() = 0;
    virtual void Trigger() = 0;
    virtual void Reset() = 0;
    /** False if the time (milliseconds) ran out. */
    virtual bool Wait(uint32 WaitTime, const bool bIgnoreThreadIdleStats = false) = 0;
    bool Wait() { return Wait(MAX_uint32); }
    bool Wait(const FTimespan& WaitTime, bool bIgnoreThreadIdleStats = false) {
        const double Milliseconds = WaitTime.GetTotalMilliseconds();
        return Wait(Milliseconds >= static_cast<double>(MAX_uint32)
                        ? MAX_uint32
                        : static_cast<uint32>(Milliseconds < 0 ? 0 : Milliseconds),
            bIgnoreThreadIdleStats);
    }
};

/** A pooled event for the length of a scope. */
class FEventRef {
public:
    explicit FEventRef(EEventMode Mode = EEventMode::AutoReset)
        : Event(FPlatformProcess::GetSynchEventFromPool(Mode == EEventMode::ManualReset)) {}
    ~FEventRef() { FPlatformProcess::ReturnSynchEventToPool(Event); }
    UE_NONCOPYABLE(FEventRef)
    FEvent* operator->() const { return Event; }
    FEvent* Get() { return Event; }

private:
    FEvent* Event;
};
