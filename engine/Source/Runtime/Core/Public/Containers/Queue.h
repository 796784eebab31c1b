// SPDX-License-Identifier: MIT
/** TQueue: an unbounded queue, lock-free for one consumer and one (Spsc) or many (Mpsc) producers. */
#pragma once

#include <atomic>

#include "Templates/UnrealTemplate.h"

enum class EQueueMode { Mpsc, Spsc, SingleThreaded };

template <typename T, EQueueMode Mode = EQueueMode::Spsc>
class TQueue {
public:
    using FElementType = T;

    TQueue() { Head = Tail = new TNode(); }
    UE_NONCOPYABLE(TQueue)
    ~TQueue() {
        while (Tail != nullptr) {
            TNode* Node = Tail;
            Tail = Tail->NextNode.load();
            delete Node;
        }
    }
    bool Enqueue(const T& Item) { return Link(new TNode(Item)); }
    bool Enqueue(T&& Item) { return Link(new TNode(MoveTempIfPossible(Item))); }
    /** Takes the oldest item; only the consumer calls this. */
    bool Dequeue(T& OutItem) {
        TNode* Popped = Tail->NextNode.load(std::memory_order_acquire);
        if (Popped == nullptr) {
            return false;
        }
        OutItem = MoveTemp(Popped->Item);
        TNode* Old = Tail;
        Tail = Popped;
        Tail->Item = T();
        delete Old;
        return true;
    }
    bool Pop() {
        T Ignored;
        return Dequeue(Ignored);
    }
    void Empty() {
        while (Pop()) {}
    }
    bool IsEmpty() const { return Tail->NextNode.load(std::memory_order_acquire) == nullptr; }
    bool Peek(T& OutItem) const {
        const T* Item = const_cast<TQueue*>(this)->Peek();
        if (!Item) {
            return false;
        }
        OutItem = *Item;
        return true;
    }
    T* Peek() {
        TNode* Next = Tail->NextNode.load(std::memory_order_acquire);
        return Next ? &Next->Item : nullptr;
    }

private:
    struct TNode {
        std::atomic<TNode*> NextNode{nullptr};
        T Item{};
        TNode() = default;
        explicit TNode(const T& InItem) : Item(InItem) {}
        explicit TNode(T&& InItem) : Item(MoveTempIfPossible(InItem)) {}
    };
    bool Link(TNode* NewNode) {
        TNode* OldHead;
        if constexpr (Mode == EQueueMode::Mpsc) {
            OldHead = Head.exchange(NewNode, std::memory_order_acq_rel);
        } else {
            OldHead = Head.load(std::memory_order_relaxed);
            Head.store(NewNode, std::memory_order_relaxed);
        }
        OldHead->NextNode.store(NewNode, std::memory_order_release);
        return true;
    }
    std::atomic<TNode*> Head;
    TNode* Tail;
};
