// SPDX-License-Identifier: MIT
/** FThreadSafeCounter, FThreadSafeBool. New code uses std::atomic. */
#pragma once

#include <atomic>

#include "CoreTypes.h"

template <typename IntType>
class TThreadSafeCounter {
public:
    TThreadSafeCounter() : Counter(0) {}
    explicit TThreadSafeCounter(IntType Value) : Counter(Value) {}
    /** The new value. */
    IntType Increment() { return ++Counter; }
    IntType Decrement() { return --Counter; }
    /** The old value. */
    IntType Add(IntType Amount) { return Counter.fetch_add(Amount); }
    IntType Subtract(IntType Amount) { return Counter.fetch_sub(Amount); }
    IntType Set(IntType Value) { return Counter.exchange(Value); }
    IntType Reset() { return Counter.exchange(0); }
    IntType GetValue() const { return Counter.load(); }

private:
    std::atomic<IntType> Counter;
};
using FThreadSafeCounter = TThreadSafeCounter<int32>;
using FThreadSafeCounter64 = TThreadSafeCounter<int64>;

class FThreadSafeBool {
public:
    FThreadSafeBool(bool Value = false) : Flag(Value) {}
    operator bool() const { return Flag.load(); }
    bool operator=(bool Value) {
        Flag.store(Value);
        return Value;
    }
    /** Sets it; returns what it was. */
    bool AtomicSet(bool Value) { return Flag.exchange(Value); }

private:
    std::atomic<bool> Flag;
};
