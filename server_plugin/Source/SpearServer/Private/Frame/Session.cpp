// SPDX-License-Identifier: MIT
#include "Frame/Session.h"

#include "spear/limits.hpp"

namespace SpearServer {

TSpearResult<std::span<const std::byte>> FSession::ResolveFuture(uint64 Number) const {
    const auto At = Kept.find(Number);
    if (At == Kept.end()) {
        return MakeError(ErrorCode::DependencyFailed,
            "the future of operation " + std::to_string(Number) +
                " has no result here: the operation has not run, its result was not kept, or the future was dropped");
    }
    const FKeptResult& Result = At->second;
    switch (Result.State) {
    case FKeptResult::Pending:
        return MakeError(
            ErrorCode::NeedsFrames, "the future of operation " + std::to_string(Number) +
                                        " is of a latent function that has not completed yet; use it in a later frame");
    case FKeptResult::Failed:
        return MakeError(ErrorCode::DependencyFailed,
            "the operation of the future failed: " + Result.Error.operation + ": " + Result.Error.message);
    default:
        return std::span<const std::byte>(Result.Value);
    }
}

bool FSession::Keep(uint64 Number, FKeptResult Result) {
    if (Kept.size() >= spear::limits::max_kept_results) {
        return false;
    }
    return Kept.try_emplace(Number, std::move(Result)).second;
}

FKeptResult* FSession::FindKept(uint64 Number) {
    const auto At = Kept.find(Number);
    return At != Kept.end() ? &At->second : nullptr;
}

void FSession::Sweep() {
    Handles.Sweep();
    TypeNumbers.Sweep();
    Conversions.clear();
    CallPlans.Sweep();
    PropertyPaths.Sweep();
}

} // namespace SpearServer
