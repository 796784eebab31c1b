// SPDX-License-Identifier: MIT
// The game thread's queue of work, and one worker thread for the rest.
#include "Async/TaskGraphInterfaces.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "CoreMinimal.h"
#include "HAL/PlatformProcess.h"

namespace {

struct FQueues {
    std::mutex Mutex;
    std::condition_variable Changed;
    std::deque<TUniqueFunction<void()>> Game;   // under Mutex
    std::deque<TUniqueFunction<void()>> Worker; // under Mutex
    std::thread Thread;                         // under Mutex; started with the first task
    bool bStopping = false;                     // under Mutex

    void Work() {
        FPlatformProcess::SetThreadName(TEXT("UEWorker"));
        std::unique_lock Lock(Mutex);
        for (;;) {
            Changed.wait(Lock, [this] { return bStopping || !Worker.empty(); });
            if (bStopping) {
                return;
            }
            TUniqueFunction<void()> Task = MoveTemp(Worker.front());
            Worker.pop_front();
            Lock.unlock();
            Task();
            Lock.lock();
        }
    }
};
FQueues& Queues() {
    static FQueues* const Instance = new FQueues; // other threads may end after statics
    return *Instance;
}

} // namespace

FTaskGraphInterface& FTaskGraphInterface::Get() {
    static FTaskGraphInterface Instance;
    return Instance;
}

int32 FTaskGraphInterface::ProcessThreadUntilIdle(ENamedThreads::Type CurrentThread) {
    check(CurrentThread == ENamedThreads::GameThread && IsInGameThread());
    int32 Count = 0;
    std::unique_lock Lock(Queues().Mutex);
    while (!Queues().Game.empty()) {
        TUniqueFunction<void()> Task = MoveTemp(Queues().Game.front());
        Queues().Game.pop_front();
        Lock.unlock();
        Task();
        ++Count;
        Lock.lock();
    }
    return Count;
}

void FTaskGraphInterface::QueueTask(ENamedThreads::Type Thread, TUniqueFunction<void()> Function) {
    FQueues& All = Queues();
    const std::lock_guard Lock(All.Mutex);
    if (Thread == ENamedThreads::GameThread) {
        All.Game.push_back(MoveTemp(Function));
        return;
    }
    checkf(!All.bStopping, TEXT("AsyncTask after the worker threads were shut down"));
    if (!All.Thread.joinable()) {
        All.Thread = std::thread([&All] { All.Work(); });
    }
    All.Worker.push_back(MoveTemp(Function));
    All.Changed.notify_one();
}

int32 FTaskGraphInterface::GetNumWorkerThreads() const { return 1; }

void FTaskGraphInterface::Shutdown() {
    FQueues& All = Queues();
    std::thread Thread;
    {
        const std::lock_guard Lock(All.Mutex);
        All.bStopping = true;
        All.Changed.notify_all();
        Thread = MoveTemp(All.Thread);
    }
    if (Thread.joinable()) {
        Thread.join();
    }
}
