// SPDX-License-Identifier: MIT
#pragma once

// What travels from the server thread to the game thread: batches of operations, grouped into transactions. Bytes only,
// no objects.

#include "CoreMinimal.h"

#include "spear/encode.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
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

/// A begin_frame block and its end_frame block, as far as they have arrived.
struct FTransaction {
    uint64 Number = 0;
    uint64 Arrival = 0; ///< order among the transactions of all sessions
    std::deque<FBatch> Begin;
    std::deque<FBatch> End;
    std::size_t BeginOperations = 0;
    std::size_t EndOperations = 0;
    bool bBeginClosed = false;
    bool bEndClosed = false;
    bool bSingleStep = false;

    std::deque<FBatch>& Batches(EBlock Block) { return Block == EBlock::Begin ? Begin : End; }
    bool IsClosed(EBlock Block) const { return Block == EBlock::Begin ? bBeginClosed : bEndClosed; }
};

/// Kept results that the client gave up: dropped once every batch up to After has run, because one of them may still
/// use them.
struct FRelease {
    uint64 After = 0;
    std::vector<uint64> Numbers;
};

} // namespace SpearServer
