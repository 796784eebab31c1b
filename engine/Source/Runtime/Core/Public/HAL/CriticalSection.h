// SPDX-License-Identifier: MIT
/** FCriticalSection (recursive), FRWLock. */
#pragma once

#include <mutex>
#include <shared_mutex>

#include "CoreTypes.h"

class FCriticalSection {
public:
    FCriticalSection() = default;
    UE_NONCOPYABLE(FCriticalSection)
    void Lock() { Mutex.lock(); }
    bool TryLock() { return Mutex.try_lock(); }
    void Unlock() { Mutex.unlock(); }

private:
    std::recursive_mutex Mutex;
};

/** Many readers or one writer. Not recursive. */
class FRWLock {
public:
    FRWLock() = default;
    UE_NONCOPYABLE(FRWLock)
    void ReadLock() { Mutex.lock_shared(); }
    void ReadUnlock() { Mutex.unlock_shared(); }
    void WriteLock() { Mutex.lock(); }
    void WriteUnlock() { Mutex.unlock(); }
    bool TryReadLock() { return Mutex.try_lock_shared(); }
    bool TryWriteLock() { return Mutex.try_lock(); }

private:
    std::shared_mutex Mutex;
};
