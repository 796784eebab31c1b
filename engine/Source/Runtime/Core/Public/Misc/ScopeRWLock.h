// SPDX-License-Identifier: MIT
/** FReadScopeLock, FWriteScopeLock. */
#pragma once

#include "HAL/CriticalSection.h"

class FReadScopeLock {
public:
    [[nodiscard]] explicit FReadScopeLock(FRWLock& InLock) : Lock(InLock) { Lock.ReadLock(); }
    ~FReadScopeLock() { Lock.ReadUnlock(); }
    UE_NONCOPYABLE(FReadScopeLock)

private:
    FRWLock& Lock;
};
class FWriteScopeLock {
public:
    [[nodiscard]] explicit FWriteScopeLock(FRWLock& InLock) : Lock(InLock) { Lock.WriteLock(); }
    ~FWriteScopeLock() { Lock.WriteUnlock(); }
    UE_NONCOPYABLE(FWriteScopeLock)

private:
    FRWLock& Lock;
};
