// SPDX-License-Identifier: MIT
#pragma once

// What travels from the server thread to the game thread: batches of operations, grouped into transactions. Bytes only,
// no objects.

#include "CoreMinimal.h"

#include "spear/encode.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace SpearServer {

enum class EBlock : uint8 { None = 0, Begin = 1, End = 2 };

/// One message of operations.
struct FBatch {
    uint64 Session = 0;
    uint64 Request = 0;  ///< what the reply names
    uint64 Sequence = 0; ///< order of arrival within the session
    EBlock Block = EBlock::None;
    bool bCloses = false;
    std::vector<std::byte> Operations;
};

/// First in, first out, with memory that it keeps.
template <typename T>
class TFifo {
public:
    bool empty() const { return Head == Items.size(); }
    std::size_t size() const { return Items.size() - Head; }
    T& front() { return Items[Head]; }
    const T& front() const { return Items[Head]; }
    T& back() { return Items.back(); }
    const T& back() const { return Items.back(); }
    T* begin() { return Items.data() + Head; }
    T* end() { return Items.data() + Items.size(); }
    void push_back(T Item) { Items.push_back(std::move(Item)); }
    void pop_front() {
        ++Head;
        if (Head == Items.size()) {
            clear();
        } else if (Head >= 64 && Head * 2 >= Items.size()) {
            Items.erase(Items.begin(), Items.begin() + static_cast<std::ptrdiff_t>(Head));
            Head = 0;
        }
    }
    void clear() {
        Items.clear();
        Head = 0;
    }

private:
    std::vector<T> Items;
    std::size_t Head = 0;
};

/// A begin_frame block and its end_frame block, as far as they have arrived.
struct FTransaction {
    uint64 Number = 0;
    uint64 Arrival = 0; ///< order among the transactions of all sessions
    TFifo<FBatch> Begin;
    TFifo<FBatch> End;
    std::size_t BeginOperations = 0;
    std::size_t EndOperations = 0;
    bool bBeginClosed = false;
    bool bEndClosed = false;
    bool bSingleStep = false;

    TFifo<FBatch>& Batches(EBlock Block) { return Block == EBlock::Begin ? Begin : End; }
    bool IsClosed(EBlock Block) const { return Block == EBlock::Begin ? bBeginClosed : bEndClosed; }
    /// As new, but with its memory.
    void Reset() {
        Begin.clear();
        End.clear();
        Number = Arrival = 0;
        BeginOperations = EndOperations = 0;
        bBeginClosed = bEndClosed = bSingleStep = false;
    }
};

/// Kept results that the client gave up: dropped once every batch up to After has run, because one of them may still
/// use them.
struct FRelease {
    uint64 After = 0;
    std::size_t Count = 0; ///< of the numbers of all
};

} // namespace SpearServer
