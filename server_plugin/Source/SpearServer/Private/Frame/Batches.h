// SPDX-License-Identifier: MIT
#pragma once

// Running the operations of a batch, one after the other: a failed one is answered with its error, and the next one
// still runs.

#include "CoreMinimal.h"

#include "Frame/Batch.h"
#include "Frame/EntryPointTable.h"

#include "spear/encode.hpp"

#include <span>
#include <vector>

namespace SpearServer {

class FSession;

/// A batch on its way: it may be parked in the middle, until a latent function completes.
struct FRunningBatch {
    FBatch Batch;
    std::size_t Offset = 0; ///< of the next operation
    spear::Encoder Answers;
};

/// Runs the batch from where it is. False if it must be parked and run again in a later frame.
bool RunBatch(FSession& Session, FRunningBatch& Running);

/// Runs a synchronous operation of a block that came without a batch. Answer becomes its value, or, and that is false, its
/// error.
bool RunCall(FSession& Session, uint64 Number, uint16 EntryPoint, std::span<const std::byte> Arguments,
    spear::Encoder& Answer);

/// Runs a batch of operations of the server thread, there. EntryPoints: the session's numbering.
void RunOnServerThread(
    std::span<const std::byte> Operations, const std::vector<uint16>& EntryPoints, spear::Encoder& Answers);

} // namespace SpearServer
