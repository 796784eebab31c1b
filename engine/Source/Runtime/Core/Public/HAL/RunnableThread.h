// SPDX-License-Identifier: MIT
/** FRunnableThread: a thread that runs an FRunnable. */
#pragma once

#include "Containers/UnrealString.h"
#include "HAL/Runnable.h"

enum EThreadPriority {
    TPri_Normal,
    TPri_AboveNormal,
    TPri_BelowNormal,
    TPri_Highest,
    TPri_Lowest,
    TPri_SlightlyBelowNormal,
    TPri_TimeCritical,
    TPri_Num,
};

class FRunnableThread {
public:
    /** Starts a thread; null if that fails or Init says no. Priority and affinity are hints that this engine does not
     * use. */
    static CORE_API FRunnableThread* Create(FRunnable* InRunnable, const TCHAR* ThreadName, uint32 InStackSize = 0,
        EThreadPriority InThreadPri = TPri_Normal, uint64 InThreadAffinityMask = ~0ull);
    virtual ~FRunnableThread() = default;
    /** Calls Stop and, if asked, waits for the end. */
    virtual bool Kill(bool bShouldWait = true) = 0;
    virtual void WaitForCompletion() = 0;
    virtual uint32 GetThreadID() const = 0;
    virtual const FString& GetThreadName() const = 0;
};
