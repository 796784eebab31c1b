// SPDX-License-Identifier: MIT
#include "TimerManager.h"

#include "Engine/World.h"
#include "Misc/CoreMisc.h"

DEFINE_LOG_CATEGORY_STATIC(LogTimerManager, Log, All);

void FTimerUnifiedDelegate::Execute() {
    if (FuncDelegate.IsBound()) {
        FuncDelegate.Execute();
    } else if (FuncDynDelegate.IsBound()) {
        FuncDynDelegate.ProcessDelegate<UObject>(nullptr);
    } else if (FuncCallback) {
        FuncCallback();
    }
}

bool FTimerUnifiedDelegate::IsBound() const {
    return FuncDelegate.IsBound() || FuncDynDelegate.IsBound() || static_cast<bool>(FuncCallback);
}

bool FTimerUnifiedDelegate::IsBoundToObject(const void* Object) const {
    return (FuncDelegate.IsBound() && FuncDelegate.IsBoundToObject(Object)) ||
           (FuncDynDelegate.IsBound() && FuncDynDelegate.GetUObject() == Object);
}

void FTimerUnifiedDelegate::Unbind() {
    FuncDelegate.Unbind();
    FuncDynDelegate.Unbind();
    FuncCallback = nullptr;
}

FTimerManager::FTimerManager(UGameInstance*) : LastHandle(0), InternalTime(0.0), LastTickedFrame(MAX_uint64) {}

FTimerManager::~FTimerManager() = default;

FTimerManager::FTimerData* FTimerManager::FindTimer(FTimerHandle Handle) {
    FTimerData* Timer = Handle.IsValid() ? Timers.Find(Handle.Handle) : nullptr;
    return Timer && Timer->Status != ETimerStatus::ActivePendingRemoval ? Timer : nullptr;
}

const FTimerManager::FTimerData* FTimerManager::FindTimer(FTimerHandle Handle) const {
    return const_cast<FTimerManager*>(this)->FindTimer(Handle);
}

FTimerHandle FTimerManager::AddTimer(FTimerData&& Data) {
    FTimerHandle Handle;
    Handle.Handle = ++LastHandle;
    Timers.Add(Handle.Handle, MoveTemp(Data));
    TimerOrder.Add(Handle.Handle);
    return Handle;
}

void FTimerManager::InternalSetTimer(FTimerHandle& InOutHandle, FTimerUnifiedDelegate&& InDelegate, float InRate,
    const FTimerManagerTimerParameters& Parameters) {
    ClearTimer(InOutHandle);
    if (InRate <= 0.f) {
        return;
    }
    FTimerData Data;
    Data.TimerDelegate = MoveTemp(InDelegate);
    Data.Rate = InRate;
    Data.bLoop = Parameters.bLoop;
    Data.bMaxOncePerFrame = Parameters.bMaxOncePerFrame;
    const float FirstDelay = Parameters.FirstDelay >= 0.f ? Parameters.FirstDelay : InRate;
    if (HasBeenTickedThisFrame()) {
        Data.Status = ETimerStatus::Active;
        Data.ExpireTime = InternalTime + FirstDelay;
    } else {
        // Set before this frame's tick: that tick's time passed before the timer was there, so it must not count.
        Data.Status = ETimerStatus::Pending;
        Data.ExpireTime = FirstDelay;
    }
    InOutHandle = AddTimer(MoveTemp(Data));
}

FTimerHandle FTimerManager::InternalSetTimerForNextTick(FTimerUnifiedDelegate&& InDelegate) {
    FTimerData Data;
    Data.TimerDelegate = MoveTemp(InDelegate);
    Data.Status = ETimerStatus::Active;
    Data.ExpireTime = InternalTime;
    return AddTimer(MoveTemp(Data));
}

void FTimerManager::ClearTimer(FTimerHandle& InHandle) {
    if (FTimerData* Timer = FindTimer(InHandle)) {
        if (Timer->Status == ETimerStatus::Executing) {
            // Its delegate is on the stack: Tick removes it.
            Timer->Status = ETimerStatus::ActivePendingRemoval;
        } else {
            Timers.Remove(InHandle.Handle);
            TimerOrder.Remove(InHandle.Handle);
        }
    }
    InHandle.Invalidate();
}

void FTimerManager::ClearAllTimersForObject(void const* Object) {
    if (!Object) {
        return;
    }
    const TArray<uint64> Serials = TimerOrder;
    for (const uint64 Serial : Serials) {
        const FTimerData* Timer = Timers.Find(Serial);
        if (Timer && Timer->TimerDelegate.IsBoundToObject(Object)) {
            FTimerHandle Handle;
            Handle.Handle = Serial;
            ClearTimer(Handle);
        }
    }
}

void FTimerManager::PauseTimer(FTimerHandle InHandle) {
    FTimerData* Timer = FindTimer(InHandle);
    if (!Timer || Timer->Status == ETimerStatus::Paused) {
        return;
    }
    if (Timer->Status != ETimerStatus::Pending) {
        Timer->ExpireTime -= InternalTime;
    }
    Timer->Status = ETimerStatus::Paused;
}

void FTimerManager::UnPauseTimer(FTimerHandle InHandle) {
    FTimerData* Timer = FindTimer(InHandle);
    if (!Timer || Timer->Status != ETimerStatus::Paused) {
        return;
    }
    if (HasBeenTickedThisFrame()) {
        Timer->Status = ETimerStatus::Active;
        Timer->ExpireTime += InternalTime;
    } else {
        Timer->Status = ETimerStatus::Pending;
    }
}

float FTimerManager::GetTimerRate(FTimerHandle InHandle) const {
    const FTimerData* Timer = FindTimer(InHandle);
    return Timer ? Timer->Rate : -1.f;
}

bool FTimerManager::IsTimerActive(FTimerHandle InHandle) const {
    const FTimerData* Timer = FindTimer(InHandle);
    return Timer && Timer->Status != ETimerStatus::Paused;
}

bool FTimerManager::IsTimerPaused(FTimerHandle InHandle) const {
    const FTimerData* Timer = FindTimer(InHandle);
    return Timer && Timer->Status == ETimerStatus::Paused;
}

bool FTimerManager::IsTimerPending(FTimerHandle InHandle) const {
    const FTimerData* Timer = FindTimer(InHandle);
    return Timer && Timer->Status == ETimerStatus::Pending;
}

bool FTimerManager::TimerExists(FTimerHandle InHandle) const { return FindTimer(InHandle) != nullptr; }

float FTimerManager::GetTimerRemaining(FTimerHandle InHandle) const {
    const FTimerData* Timer = FindTimer(InHandle);
    if (!Timer) {
        return -1.f;
    }
    switch (Timer->Status) {
    case ETimerStatus::Active:
        return static_cast<float>(Timer->ExpireTime - InternalTime);
    case ETimerStatus::Executing:
        return 0.f;
    default:
        return static_cast<float>(Timer->ExpireTime);
    }
}

float FTimerManager::GetTimerElapsed(FTimerHandle InHandle) const {
    const FTimerData* Timer = FindTimer(InHandle);
    return Timer ? Timer->Rate - GetTimerRemaining(InHandle) : -1.f;
}

bool FTimerManager::HasBeenTickedThisFrame() const { return LastTickedFrame == GFrameCounter; }

FTimerHandle FTimerManager::K2_FindDynamicTimerHandle(FTimerDynamicDelegate InDynamicDelegate) const {
    FTimerHandle Handle;
    for (const uint64 Serial : TimerOrder) {
        const FTimerData& Timer = Timers[Serial];
        if (Timer.Status != ETimerStatus::ActivePendingRemoval && Timer.TimerDelegate.FuncDynDelegate.IsBound() &&
            Timer.TimerDelegate.FuncDynDelegate == InDynamicDelegate) {
            Handle.Handle = Serial;
            break;
        }
    }
    return Handle;
}

void FTimerManager::Tick(float DeltaTime) {
    if (HasBeenTickedThisFrame()) {
        return;
    }
    InternalTime += DeltaTime;

    for (;;) {
        // The earliest that is due; of equals the one that was set first. Strictly past: so what a delegate sets for
        // the next tick waits for it.
        uint64 Serial = 0;
        FTimerData* Timer = nullptr;
        for (const uint64 Candidate : TimerOrder) {
            FTimerData& CandidateTimer = Timers[Candidate];
            if (CandidateTimer.Status == ETimerStatus::Active && CandidateTimer.ExpireTime < InternalTime &&
                (!Timer || CandidateTimer.ExpireTime < Timer->ExpireTime)) {
                Serial = Candidate;
                Timer = &CandidateTimer;
            }
        }
        if (!Timer) {
            break;
        }

        int32 CallCount = 1;
        if (Timer->bLoop && !Timer->bMaxOncePerFrame) {
            CallCount = 1 + static_cast<int32>((InternalTime - Timer->ExpireTime) / Timer->Rate);
        }
        Timer->Status = ETimerStatus::Executing;
        for (int32 Call = 0; Call < CallCount; ++Call) {
            // A copy: the delegate may set timers, which moves the map's memory, or clear its own.
            FTimerUnifiedDelegate Delegate = Timer->TimerDelegate;
            Delegate.Execute();
            Timer = Timers.Find(Serial);
            if (!Timer || Timer->Status != ETimerStatus::Executing) {
                break;
            }
        }
        if (!Timer) {
            continue;
        }
        if (Timer->Status == ETimerStatus::Executing && Timer->bLoop && Timer->TimerDelegate.IsBound()) {
            Timer->ExpireTime = Timer->bMaxOncePerFrame
                                    ? FMath::Max(Timer->ExpireTime + Timer->Rate, InternalTime + UE_SMALL_NUMBER)
                                    : Timer->ExpireTime + static_cast<double>(CallCount) * Timer->Rate;
            Timer->Status = ETimerStatus::Active;
        } else if (Timer->Status != ETimerStatus::Paused) {
            Timers.Remove(Serial);
            TimerOrder.Remove(Serial);
        }
    }

    LastTickedFrame = GFrameCounter;
    for (const uint64 Serial : TimerOrder) {
        FTimerData& Timer = Timers[Serial];
        if (Timer.Status == ETimerStatus::Pending) {
            Timer.Status = ETimerStatus::Active;
            Timer.ExpireTime += InternalTime;
        }
    }
}

void FTimerManager::ListTimers() const {
    UE_LOG(LogTimerManager, Log, TEXT("%d timers"), TimerOrder.Num());
    for (const uint64 Serial : TimerOrder) {
        const FTimerData& Timer = Timers[Serial];
        UE_LOG(LogTimerManager, Log, TEXT("  %llu: rate %f s%s, status %d"), static_cast<unsigned long long>(Serial),
            Timer.Rate, Timer.bLoop ? TEXT(", loops") : TEXT(""), static_cast<int32>(Timer.Status));
    }
}
