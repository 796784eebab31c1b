// SPDX-License-Identifier: MIT
/** @file Timers of the game. Mirrors UE's TimerManager.h. */
#pragma once

#include "Containers/Map.h"
#include "CoreMinimal.h"
#include "Engine/EngineTypes.h"
#include "Templates/Function.h"
#include "UObject/ScriptDelegates.h"

class UGameInstance;

/** Simple delegate that a timer calls. */
DECLARE_DELEGATE(FTimerDelegate);

/** What a timer calls: nothing, a native delegate, a reflected function, or a function object. */
struct FTimerUnifiedDelegate {
    /** Holds the delegate to call. */
    FTimerDelegate FuncDelegate;
    /** Holds the dynamic delegate to call. */
    FTimerDynamicDelegate FuncDynDelegate;
    /** Holds the TFunction callback to call. */
    TFunction<void(void)> FuncCallback;

    FTimerUnifiedDelegate() = default;
    FTimerUnifiedDelegate(const FTimerDelegate& D) : FuncDelegate(D) {}
    FTimerUnifiedDelegate(const FTimerDynamicDelegate& D) : FuncDynDelegate(D) {}
    FTimerUnifiedDelegate(TFunction<void(void)>&& Callback) : FuncCallback(MoveTemp(Callback)) {}

    /** Calls what is bound. */
    ENGINE_API void Execute();
    /** Whether anything callable is bound. */
    ENGINE_API bool IsBound() const;
    /** Whether it is bound to that object. */
    ENGINE_API bool IsBoundToObject(const void* Object) const;
    /** Unbinds. */
    ENGINE_API void Unbind();
};

/** State of a timer. */
enum class ETimerStatus : uint8 {
    /** Set, and starts to count at the end of this tick. */
    Pending,
    Active,
    Paused,
    /** Its delegate is being called. */
    Executing,
    ActivePendingRemoval,
};

/** How a timer runs. */
struct FTimerManagerTimerParameters {
    /** Whether to call again after the rate. */
    bool bLoop = false;
    /** If true, a looping timer fires at most once per frame, however late the frame is. */
    bool bMaxOncePerFrame = false;
    /** Seconds until the first call, or negative to use the rate. */
    float FirstDelay = -1.f;
};

/**
 * Class to globally manage timers. It counts world time: timers stop while the game is paused.
 *
 * Timers that are due in one tick are called in order of their time, then in the order they were set.
 *
 * https://dev.epicgames.com/documentation/en-us/unreal-engine/API/Runtime/Engine/FTimerManager
 */
class ENGINE_API FTimerManager : public FNoncopyable {
public:
    explicit FTimerManager(UGameInstance* GameInstance = nullptr);
    virtual ~FTimerManager();

    /** Advances all timers and calls those that are due. @param DeltaTime seconds. */
    void Tick(float DeltaTime);

    /**
     * Sets a timer to call the given native function at a set interval. If a timer is already set for this handle, it
     * will replace the current timer.
     * @param InOutHandle if the passed-in handle refers to an existing timer, it will be cleared before the new timer
     * is added. A new handle to the new timer is returned in either case.
     * @param InObj object to call the timer function on.
     * @param InTimerMethod method to call when timer fires.
     * @param InRate the amount of time (in seconds) between set and firing. If <= 0.f, clears existing timers.
     * @param InbLoop true to keep firing at Rate intervals, false to fire only once.
     * @param InFirstDelay the time (in seconds) for the first iteration of a looping timer. If < 0.f InRate will be
     * used.
     */
    template <class UserClass>
    void SetTimer(FTimerHandle& InOutHandle, UserClass* InObj, void (UserClass::*InTimerMethod)(), float InRate,
        bool InbLoop = false, float InFirstDelay = -1.f) {
        InternalSetTimer(InOutHandle, FTimerUnifiedDelegate(FTimerDelegate::CreateUObject(InObj, InTimerMethod)),
            InRate, ToParameters(InbLoop, InFirstDelay));
    }
    template <class UserClass>
    void SetTimer(FTimerHandle& InOutHandle, UserClass* InObj, void (UserClass::*InTimerMethod)() const, float InRate,
        bool InbLoop = false, float InFirstDelay = -1.f) {
        InternalSetTimer(InOutHandle, FTimerUnifiedDelegate(FTimerDelegate::CreateUObject(InObj, InTimerMethod)),
            InRate, ToParameters(InbLoop, InFirstDelay));
    }
    /** Version that takes any generic delegate. */
    void SetTimer(FTimerHandle& InOutHandle, FTimerDelegate const& InDelegate, float InRate, bool InbLoop,
        float InFirstDelay = -1.f) {
        InternalSetTimer(InOutHandle, FTimerUnifiedDelegate(InDelegate), InRate, ToParameters(InbLoop, InFirstDelay));
    }
    /** Version that takes a dynamic delegate (e.g. for reflected functions). */
    void SetTimer(FTimerHandle& InOutHandle, FTimerDynamicDelegate const& InDynDelegate, float InRate, bool InbLoop,
        float InFirstDelay = -1.f) {
        InternalSetTimer(
            InOutHandle, FTimerUnifiedDelegate(InDynDelegate), InRate, ToParameters(InbLoop, InFirstDelay));
    }
    /** Version that doesn't take a delegate, only counts. */
    void SetTimer(FTimerHandle& InOutHandle, float InRate, bool InbLoop, float InFirstDelay = -1.f) {
        InternalSetTimer(InOutHandle, FTimerUnifiedDelegate(), InRate, ToParameters(InbLoop, InFirstDelay));
    }
    /** Version that takes a TFunction. */
    void SetTimer(FTimerHandle& InOutHandle, TFunction<void(void)>&& Callback, float InRate, bool InbLoop,
        float InFirstDelay = -1.f) {
        InternalSetTimer(
            InOutHandle, FTimerUnifiedDelegate(MoveTemp(Callback)), InRate, ToParameters(InbLoop, InFirstDelay));
    }
    /** Version with all parameters. */
    void SetTimer(FTimerHandle& InOutHandle, FTimerDynamicDelegate const& InDynDelegate, float InRate,
        const FTimerManagerTimerParameters& InTimerParameters) {
        InternalSetTimer(InOutHandle, FTimerUnifiedDelegate(InDynDelegate), InRate, InTimerParameters);
    }
    void SetTimer(FTimerHandle& InOutHandle, FTimerDelegate const& InDelegate, float InRate,
        const FTimerManagerTimerParameters& InTimerParameters) {
        InternalSetTimer(InOutHandle, FTimerUnifiedDelegate(InDelegate), InRate, InTimerParameters);
    }

    /** Sets a timer to call the given native function on the next tick. */
    template <class UserClass>
    FTimerHandle SetTimerForNextTick(UserClass* InObj, void (UserClass::*InTimerMethod)()) {
        return InternalSetTimerForNextTick(FTimerUnifiedDelegate(FTimerDelegate::CreateUObject(InObj, InTimerMethod)));
    }
    FTimerHandle SetTimerForNextTick(FTimerDelegate const& InDelegate) {
        return InternalSetTimerForNextTick(FTimerUnifiedDelegate(InDelegate));
    }
    FTimerHandle SetTimerForNextTick(FTimerDynamicDelegate const& InDynDelegate) {
        return InternalSetTimerForNextTick(FTimerUnifiedDelegate(InDynDelegate));
    }
    FTimerHandle SetTimerForNextTick(TFunction<void(void)>&& Callback) {
        return InternalSetTimerForNextTick(FTimerUnifiedDelegate(MoveTemp(Callback)));
    }

    /** Clears a previously set timer, identical to calling SetTimer() with a <= 0.f rate. Invalidates the timer handle
     * as it should no longer be used. */
    void ClearTimer(FTimerHandle& InHandle);
    /** Clears all timers that are bound to functions on the given object. */
    void ClearAllTimersForObject(void const* Object);

    /** Pauses a previously set timer. */
    void PauseTimer(FTimerHandle InHandle);
    /** Unpauses a previously set timer. */
    void UnPauseTimer(FTimerHandle InHandle);

    /** Gets the current rate (time between activations) for the specified timer, in seconds, or -1.f if timer does not
     * exist. */
    float GetTimerRate(FTimerHandle InHandle) const;
    /** Returns true if the specified timer exists and is not paused. */
    bool IsTimerActive(FTimerHandle InHandle) const;
    /** Returns true if the specified timer exists and is paused. */
    bool IsTimerPaused(FTimerHandle InHandle) const;
    /** Returns true if the specified timer exists and is pending. */
    bool IsTimerPending(FTimerHandle InHandle) const;
    /** Returns true if the specified timer exists. */
    bool TimerExists(FTimerHandle InHandle) const;
    /** Gets the current elapsed time of the specified timer in seconds, or -1.f if timer does not exist. */
    float GetTimerElapsed(FTimerHandle InHandle) const;
    /** Gets the time remaining before the specified timer is called, in seconds, or -1.f if timer does not exist. */
    float GetTimerRemaining(FTimerHandle InHandle) const;

    /** Timer manager has been ticked this frame? */
    bool HasBeenTickedThisFrame() const;

    /** Finds the handle of a timer that calls that reflected function on that object; an invalid handle if there is
     * none. */
    FTimerHandle K2_FindDynamicTimerHandle(FTimerDynamicDelegate InDynamicDelegate) const;

    /** Writes all timers to the log. */
    void ListTimers() const;

private:
    struct FTimerData {
        FTimerUnifiedDelegate TimerDelegate;
        ETimerStatus Status = ETimerStatus::Active;
        bool bLoop = false;
        bool bMaxOncePerFrame = false;
        float Rate = 0.f;
        /** Time on this manager's clock when this fires; for paused timers: seconds that remain; for pending ones:
         * seconds from activation. */
        double ExpireTime = 0.0;
    };

    static FTimerManagerTimerParameters ToParameters(bool bLoop, float FirstDelay) {
        FTimerManagerTimerParameters Parameters;
        Parameters.bLoop = bLoop;
        Parameters.FirstDelay = FirstDelay;
        return Parameters;
    }

    void InternalSetTimer(FTimerHandle& InOutHandle, FTimerUnifiedDelegate&& InDelegate, float InRate,
        const FTimerManagerTimerParameters& Parameters);
    FTimerHandle InternalSetTimerForNextTick(FTimerUnifiedDelegate&& InDelegate);
    FTimerData* FindTimer(FTimerHandle Handle);
    const FTimerData* FindTimer(FTimerHandle Handle) const;
    FTimerHandle AddTimer(FTimerData&& Data);

    /** Timers by serial number. Few exist at a time, so the next to fire is found by a pass over them: no heap to keep
     * in step. */
    TMap<uint64, FTimerData> Timers;
    /** Serial numbers of Timers in ascending order. */
    TArray<uint64> TimerOrder;
    uint64 LastHandle;
    double InternalTime;
    /** Frame in which Tick ran last. */
    uint64 LastTickedFrame;
};
