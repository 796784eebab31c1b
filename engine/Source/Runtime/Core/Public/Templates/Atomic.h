// SPDX-License-Identifier: MIT
/** TAtomic: the older spelling of std::atomic. */
#pragma once

#include <atomic>

#include "CoreTypes.h"

enum class EMemoryOrder { Relaxed, SequentiallyConsistent };

template <typename T>
class TAtomic {
public:
    TAtomic() : Value(T()) {}
    constexpr TAtomic(T Arg) : Value(Arg) {}
    UE_NONCOPYABLE(TAtomic)
    operator T() const { return Value.load(); }
    T operator=(T Arg) {
        Value.store(Arg);
        return Arg;
    }
    T Load(EMemoryOrder Order = EMemoryOrder::SequentiallyConsistent) const {
        return Value.load(Order == EMemoryOrder::Relaxed ? std::memory_order_relaxed : std::memory_order_seq_cst);
    }
    void Store(T Arg, EMemoryOrder Order = EMemoryOrder::SequentiallyConsistent) {
        Value.store(Arg, Order == EMemoryOrder::Relaxed ? std::memory_order_relaxed : std::memory_order_seq_cst);
    }
    T Exchange(T Arg) { return Value.exchange(Arg); }
    bool CompareExchange(T& Expected, T Arg) { return Value.compare_exchange_strong(Expected, Arg); }
    T operator++() { return ++Value; }
    T operator++(int) { return Value++; }
    T operator--() { return --Value; }
    T operator--(int) { return Value--; }
    T operator+=(T Arg) { return Value += Arg; }
    T operator-=(T Arg) { return Value -= Arg; }

private:
    std::atomic<T> Value;
};
