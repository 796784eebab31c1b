// SPDX-License-Identifier: MIT
/** FPlatformAtomics. New code uses std::atomic. */
#pragma once

#include "CoreTypes.h"

struct FPlatformAtomics {
    static int32 InterlockedIncrement(volatile int32* Value) { return __atomic_add_fetch(Value, 1, __ATOMIC_SEQ_CST); }
    static int64 InterlockedIncrement(volatile int64* Value) { return __atomic_add_fetch(Value, 1, __ATOMIC_SEQ_CST); }
    static int32 InterlockedDecrement(volatile int32* Value) { return __atomic_sub_fetch(Value, 1, __ATOMIC_SEQ_CST); }
    static int64 InterlockedDecrement(volatile int64* Value) { return __atomic_sub_fetch(Value, 1, __ATOMIC_SEQ_CST); }
    static int32 InterlockedAdd(volatile int32* Value, int32 Amount) {
        return __atomic_fetch_add(Value, Amount, __ATOMIC_SEQ_CST);
    }
    static int64 InterlockedAdd(volatile int64* Value, int64 Amount) {
        return __atomic_fetch_add(Value, Amount, __ATOMIC_SEQ_CST);
    }
    static int32 InterlockedExchange(volatile int32* Value, int32 New) {
        return __atomic_exchange_n(Value, New, __ATOMIC_SEQ_CST);
    }
    static int32 InterlockedCompareExchange(volatile int32* Dest, int32 Exchange, int32 Comparand) {
        __atomic_compare_exchange_n(Dest, &Comparand, Exchange, false, __ATOMIC_SEQ_CST, __ATOMIC_SEQ_CST);
        return Comparand;
    }
};
