// SPDX-License-Identifier: MIT
/** FScopeLock, FScopeUnlock. */
#pragma once

#include "HAL/CriticalSection.h"

class FScopeLock {
public:
    [[nodiscard]] explicit FScopeLock(FCriticalSection* InSynchObject) : SynchObject(InSynchObject) {
        check(SynchObject);
        SynchObject->Lock();
    }
    ~FScopeLock() { Unlock(); }
    UE_NONCOPYABLE(FScopeLock)
    /** Lets go before the scope ends. */
    void Unlock() {
        if (SynchObject) {
            SynchObject->Unlock();
            SynchObject = nullptr;
        }
    }

private:
    FCriticalSection* SynchObject;
};

class FScopeUnlock {
public:
    [[nodiscard]] explicit FScopeUnlock(FCriticalSection* InSynchObject) : SynchObject(InSynchObject) {
        if (SynchObject) {
            SynchObject->Unlock();
        }
    }
    ~FScopeUnlock() {
        if (SynchObject) {
            SynchObject->Lock();
        }
    }
    UE_NONCOPYABLE(FScopeUnlock)

private:
    FCriticalSection* SynchObject;
};
