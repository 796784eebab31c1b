// SPDX-License-Identifier: MIT
#include "Frame/Session.h"

#include "spear/limits.hpp"

namespace SpearServer {

namespace {
constexpr std::size_t MostSpare = 4096;
constexpr std::size_t LargestSpare = 256;
} // namespace

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
        return std::span<const std::byte>(Result.Value.data(), Result.Value.size());
    }
}

FKeptResult* FSession::Keep(uint64 Number) {
    if (Kept.size() >= spear::limits::max_kept_results) {
        return nullptr;
    }
    if (Spare.empty()) {
        const auto [At, bIsNew] = Kept.try_emplace(Number);
        At->second.State = bIsNew ? FKeptResult::Pending : At->second.State;
        return bIsNew ? &At->second : nullptr;
    }
    FKept::node_type Node = std::move(Spare.back());
    Spare.pop_back();
    Node.key() = Number;
    auto Inserted = Kept.insert(std::move(Node));
    if (!Inserted.inserted) {
        Spare.push_back(std::move(Inserted.node));
        return nullptr;
    }
    return &Inserted.position->second;
}

void FSession::ReleaseKept(uint64 Number) {
    FKept::node_type Node = Kept.extract(Number);
    // A large or failed result gives its memory back.
    if (Node && Spare.size() < MostSpare && Node.mapped().State != FKeptResult::Failed &&
        Node.mapped().Value.capacity() <= LargestSpare) {
        Node.mapped().State = FKeptResult::Pending;
        Node.mapped().Value.clear();
        Spare.push_back(std::move(Node));
    }
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
