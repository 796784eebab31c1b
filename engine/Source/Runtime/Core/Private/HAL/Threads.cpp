// SPDX-License-Identifier: MIT
// Threads and events.
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "HAL/Event.h"
#include "HAL/PlatformTLS.h"
#include "HAL/RunnableThread.h"
#include "Misc/ScopeLock.h"
#include "Containers/Array.h"

namespace {
class FStandardEvent final : public FEvent {
public:
    using FEvent::Wait;
    bool Create(bool bInManualReset) override {
        bManualReset = bInManualReset;
        return true;
    }
    bool IsManualReset() override { return bManualReset; }
    void Trigger() override {
        std::lock_guard<std::mutex> Lock(Mutex);
        bTriggered = true;
        if (bManualReset) {
            Condition.notify_all();
        } else {
            Condition.notify_one();
        }
    }
    void Reset() override {
        std::lock_guard<std::mutex> Lock(Mutex);
        bTriggered = false;
    }
    bool Wait(uint32 WaitTime, const bool) override {
        std::unique_lock<std::mutex> Lock(Mutex);
        const auto IsTriggered = [this] { return bTriggered; };
        if (WaitTime == MAX_uint32) {
            Condition.wait(Lock, IsTriggered);
        } else if (!Condition.wait_for(Lock, std::chrono::milliseconds(WaitTime), IsTriggered)) {
            return false;
        }
        if (!bManualReset) {
            bTriggered = false;
        }
        return true;
    }

private:
    std::mutex Mutex;
    std::condition_variable Condition;
    bool bTriggered = false;
    bool bManualReset = false;
};

struct FEventPool {
    FCriticalSection Lock;
    TArray<FEvent*> Free[2];
    static FEventPool& Get() {
        static FEventPool& Pool = *new FEventPool();
        return Pool;
    }
};

class FStandardRunnableThread final : public FRunnableThread {
public:
    FStandardRunnableThread(FRunnable* InRunnable, const TCHAR* InName) : Runnable(InRunnable), Name(InName) {}
    ~FStandardRunnableThread() override { Kill(true); }

    /** Waits until Init has run; false if it said no. */
    bool Start() {
        Thread = std::thread([this] {
            FPlatformProcess::SetThreadName(*Name);
            ThreadId = FPlatformTLS::GetCurrentThreadId();
            const bool bInitialised = Runnable->Init();
            {
                std::lock_guard<std::mutex> Lock(Mutex);
                bInitDone = true;
                bInitOk = bInitialised;
            }
            Condition.notify_all();
            if (bInitialised) {
                Runnable->Run();
                Runnable->Exit();
            }
        });
        std::unique_lock<std::mutex> Lock(Mutex);
        Condition.wait(Lock, [this] { return bInitDone; });
        return bInitOk;
    }
    bool Kill(bool bShouldWait) override {
        if (Thread.joinable()) {
            Runnable->Stop();
            if (bShouldWait) {
                WaitForCompletion();
            }
        }
        return true;
    }
    void WaitForCompletion() override {
        if (Thread.joinable()) {
            checkf(Thread.get_id() != std::this_thread::get_id(), TEXT("Thread '%s' cannot wait for itself"), *Name);
            Thread.join();
        }
    }
    uint32 GetThreadID() const override { return ThreadId; }
    const FString& GetThreadName() const override { return Name; }

private:
    FRunnable* Runnable;
    FString Name;
    std::thread Thread;
    std::mutex Mutex;
    std::condition_variable Condition;
    bool bInitDone = false;
    bool bInitOk = false;
    uint32 ThreadId = 0;
};
} // namespace

FRunnableThread* FRunnableThread::Create(
    FRunnable* InRunnable, const TCHAR* ThreadName, uint32, EThreadPriority, uint64) {
    check(InRunnable);
    FStandardRunnableThread* Thread =
        new FStandardRunnableThread(InRunnable, ThreadName ? ThreadName : TEXT("Unnamed"));
    if (!Thread->Start()) {
        delete Thread;
        return nullptr;
    }
    return Thread;
}

FEvent* FGenericPlatformProcess::GetSynchEventFromPool(bool bIsManualReset) {
    FEventPool& Pool = FEventPool::Get();
    {
        FScopeLock Lock(&Pool.Lock);
        if (Pool.Free[bIsManualReset].Num()) {
            return Pool.Free[bIsManualReset].Pop();
        }
    }
    FEvent* Event = new FStandardEvent();
    Event->Create(bIsManualReset);
    return Event;
}

void FGenericPlatformProcess::ReturnSynchEventToPool(FEvent* Event) {
    if (Event) {
        Event->Reset();
        FEventPool& Pool = FEventPool::Get();
        FScopeLock Lock(&Pool.Lock);
        Pool.Free[Event->IsManualReset()].Add(Event);
    }
}
