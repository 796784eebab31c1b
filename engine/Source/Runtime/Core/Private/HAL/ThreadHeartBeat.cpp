// SPDX-License-Identifier: MIT
#include "HAL/ThreadHeartBeat.h"

#include "CoreMinimal.h"
#include "HAL/PlatformTLS.h"
#include "HAL/PlatformTime.h"
#include "Misc/ScopeLock.h"

FThreadHeartBeat& FThreadHeartBeat::Get() {
    static FThreadHeartBeat Instance;
    return Instance;
}

void FThreadHeartBeat::HeartBeat(bool) {
    const FScopeLock Lock(&HeartBeatCritical);
    FHeartBeatInfo& Info = ThreadHeartBeat.FindOrAdd(FPlatformTLS::GetCurrentThreadId());
    Info.LastHeartBeatTime = FPlatformTime::Seconds();
    ++Info.NumHeartBeats;
}

void FThreadHeartBeat::SuspendHeartBeat(bool bAllThreads) {
    const FScopeLock Lock(&HeartBeatCritical);
    ++(bAllThreads ? GlobalSuspendCount : ThreadHeartBeat.FindOrAdd(FPlatformTLS::GetCurrentThreadId()).SuspendedCount);
}

void FThreadHeartBeat::ResumeHeartBeat(bool bAllThreads) {
    const FScopeLock Lock(&HeartBeatCritical);
    FHeartBeatInfo& Info = ThreadHeartBeat.FindOrAdd(FPlatformTLS::GetCurrentThreadId());
    int32& Count = bAllThreads ? GlobalSuspendCount : Info.SuspendedCount;
    Count = FMath::Max(0, Count - 1);
    Info.LastHeartBeatTime = FPlatformTime::Seconds(); // the time suspended does not count
}

bool FThreadHeartBeat::IsBeating() {
    const FScopeLock Lock(&HeartBeatCritical);
    const FHeartBeatInfo* const Info = ThreadHeartBeat.Find(FPlatformTLS::GetCurrentThreadId());
    return Info && Info->NumHeartBeats > 0 && Info->SuspendedCount == 0 && GlobalSuspendCount == 0;
}

void FThreadHeartBeat::KillHeartBeat() {
    const FScopeLock Lock(&HeartBeatCritical);
    ThreadHeartBeat.Remove(FPlatformTLS::GetCurrentThreadId());
}

double FThreadHeartBeat::GetLastHeartBeatTime(uint32 ThreadId) {
    const FScopeLock Lock(&HeartBeatCritical);
    const FHeartBeatInfo* const Info = ThreadHeartBeat.Find(ThreadId);
    return Info ? Info->LastHeartBeatTime : 0.0;
}

uint64 FThreadHeartBeat::GetNumHeartBeats(uint32 ThreadId) {
    const FScopeLock Lock(&HeartBeatCritical);
    const FHeartBeatInfo* const Info = ThreadHeartBeat.Find(ThreadId);
    return Info ? Info->NumHeartBeats : 0;
}

uint32 FThreadHeartBeat::CheckHeartBeat(double& OutHangDuration, double HangDuration) {
    const FScopeLock Lock(&HeartBeatCritical);
    const double Now = FPlatformTime::Seconds();
    OutHangDuration = 0.0;
    if (GlobalSuspendCount > 0) {
        return InvalidThreadId;
    }
    for (const TPair<uint32, FHeartBeatInfo>& Pair : ThreadHeartBeat) {
        const double Silence = Now - Pair.Value.LastHeartBeatTime;
        if (Pair.Value.NumHeartBeats > 0 && Pair.Value.SuspendedCount == 0 && Silence > HangDuration) {
            OutHangDuration = Silence;
            return Pair.Key;
        }
    }
    return InvalidThreadId;
}
