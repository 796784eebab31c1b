// SPDX-License-Identifier: MIT
/** FThreadHeartBeat: threads tell that they are alive; whoever asks learns when a thread last did. */
#pragma once

#include "Containers/Map.h"
#include "HAL/CriticalSection.h"

class FThreadHeartBeat {
public:
    static CORE_API FThreadHeartBeat& Get();
    static FThreadHeartBeat* GetNoInit() { return &Get(); }

    /** Called by a thread, from time to time. */
    CORE_API void HeartBeat(bool bReadConfig = false);
    /** Suspends and resumes the watch of the calling thread; calls nest. */
    CORE_API void SuspendHeartBeat(bool bAllThreads = false);
    CORE_API void ResumeHeartBeat(bool bAllThreads = false);
    CORE_API bool IsBeating();
    CORE_API void KillHeartBeat();
    /** FPlatformTime::Seconds() of the thread's last beat, or 0 if it never beat. */
    CORE_API double GetLastHeartBeatTime(uint32 ThreadId);
    /** Beats of the thread so far. */
    CORE_API uint64 GetNumHeartBeats(uint32 ThreadId);
    /** A thread that has not beaten for that long and is not suspended, or INVALID. */
    CORE_API uint32 CheckHeartBeat(double& OutHangDuration, double HangDuration);
    static constexpr uint32 InvalidThreadId = ~0u;

private:
    struct FHeartBeatInfo {
        double LastHeartBeatTime = 0;
        uint64 NumHeartBeats = 0;
        int32 SuspendedCount = 0;
    };
    FCriticalSection HeartBeatCritical;
    TMap<uint32, FHeartBeatInfo> ThreadHeartBeat;
    int32 GlobalSuspendCount = 0;
};

/** Suspends the watch for the length of a scope. */
struct FSlowHeartBeatScope {
    FSlowHeartBeatScope() { FThreadHeartBeat::Get().SuspendHeartBeat(); }
    ~FSlowHeartBeatScope() { FThreadHeartBeat::Get().ResumeHeartBeat(); }
    UE_NONCOPYABLE(FSlowHeartBeatScope)
};
