// SPDX-License-Identifier: MIT
#include "Frame/KeptResults.h"

#include "spear/limits.hpp"

#include <algorithm>
#include <utility>

namespace SpearServer {

namespace {
constexpr std::size_t MostSpareOwn = 4096;
constexpr std::size_t LargestSpareOwn = 256;
constexpr std::size_t MostSpareBlocks = 4;
constexpr std::size_t LargestSpareBytes = 1u << 20;
/// A block with so few of its results left is copied to memory of their size.
constexpr std::size_t CompactBelow = 8;

ErrorInfo NoResult(uint64 Number) {
    return MakeError(ErrorCode::DependencyFailed,
        "the future of operation " + std::to_string(Number) +
            " has no result here: the operation has not run, its result was not kept, or the future was dropped");
}
ErrorInfo FailedResult(const ErrorInfo& Error) {
    return MakeError(
        ErrorCode::DependencyFailed, "the operation of the future failed: " + Error.operation + ": " + Error.message);
}
} // namespace

bool FKeptResults::CanKeep(uint64 Number, bool bInBlock) {
    if (Own.size() + NumInBlocks >= spear::limits::max_kept_results || (!Own.empty() && Own.contains(Number))) {
        return false;
    }
    if (bInBlock) {
        return Number > LastInBlocks;
    }
    FBlock* Block = FindBlock(Number);
    return !Block || !FindPlace(*Block, Number);
}

// Values of their own

FKeptResult& FKeptResults::Keep(uint64 Number) {
    if (SpareOwn.empty()) {
        FKeptResult& Kept = Own[Number];
        Kept.State = FKeptResult::Pending;
        return Kept;
    }
    FOwn::node_type Node = std::move(SpareOwn.back());
    SpareOwn.pop_back();
    Node.key() = Number;
    return Own.insert(std::move(Node)).position->second;
}

FKeptResult* FKeptResults::Find(uint64 Number) {
    const auto At = Own.find(Number);
    return At != Own.end() ? &At->second : nullptr;
}

// Those of blocks

void FKeptResults::BeginBatch(const spear::ByteBuffer& Answers) { CurrentBytes = &Answers; }

void FKeptResults::KeepAnswer(uint64 Number, std::size_t AnswerAt) {
    if (Current.Places.empty()) {
        Current.First = Number;
    }
    const uint64 Delta = Number - Current.First;
    if (Delta >= Released || AnswerAt >= Released) { // no client of ours counts like that
        Release(Number, 1);
        return;
    }
    Current.Places.push_back({static_cast<uint32>(Delta), static_cast<uint32>(AnswerAt)});
    Current.Last = LastInBlocks = Number;
    ++NumInBlocks;
}

void FKeptResults::EndBatch(spear::ByteBuffer& Answers) {
    CurrentBytes = nullptr;
    if (Current.Places.empty()) {
        return;
    }
    Current.Live = Current.Places.size();
    Current.Bytes.swap(Answers);
    Blocks.push_back(std::move(Current));
    Current = {};
    if (!SpareBlocks.empty()) {
        Current = std::move(SpareBlocks.back());
        SpareBlocks.pop_back();
    }
    Answers.swap(Current.Bytes); // memory of one that is gone
    Answers.clear();
}

FKeptResults::FPlace* FKeptResults::FindPlace(FBlock& Block, uint64 Number) {
    if (Number < Block.First || Number > Block.Last) {
        return nullptr;
    }
    const auto Delta = static_cast<uint32>(Number - Block.First);
    if (Delta < Block.Places.size() && Block.Places[Delta].Delta == Delta) { // no number is left out, usually
        return &Block.Places[Delta];
    }
    const auto At = std::lower_bound(Block.Places.begin(), Block.Places.end(), Delta,
        [](const FPlace& Place, uint32 Wanted) { return Place.Delta < Wanted; });
    return At != Block.Places.end() && At->Delta == Delta ? &*At : nullptr;
}

FKeptResults::FBlock* FKeptResults::FindBlock(uint64 Number) {
    const auto At = std::lower_bound(
        Blocks.begin(), Blocks.end(), Number, [](const FBlock& Block, uint64 Wanted) { return Block.Last < Wanted; });
    return At != Blocks.end() && At->First <= Number ? &*At : nullptr;
}

TSpearResult<std::span<const std::byte>> FKeptResults::ReadAnswer(
    const spear::ByteBuffer& Bytes, std::size_t At, uint64 Number) const {
    spear::Decoder In({Bytes.data() + At, Bytes.size() - At});
    (void)In.get<uint64>();
    const auto State = In.get<spear::AnswerState>();
    const std::span<const std::byte> Value = In.get_raw(In.get<uint32>());
    if (State == spear::AnswerState::succeeded) {
        return Value;
    }
    spear::Decoder Failure(Value);
    return State == spear::AnswerState::failed ? FailedResult(spear::decode_error(Failure)) : NoResult(Number);
}

TSpearResult<std::span<const std::byte>> FKeptResults::Resolve(uint64 Number) {
    if (CurrentBytes) {
        if (const FPlace* Place = FindPlace(Current, Number); Place && Place->AnswerAt != Released) {
            TSpearResult<std::span<const std::byte>> Value = ReadAnswer(*CurrentBytes, Place->AnswerAt, Number);
            if (!Value.IsOk()) {
                return Value;
            }
            // The operation that asks may write to the same bytes, and they may move.
            if (NumResolved == Resolved.size()) {
                Resolved.push_back(std::make_unique<spear::ByteBuffer>());
            }
            spear::ByteBuffer& Copy = *Resolved[NumResolved++];
            Copy.clear();
            Copy.append(Value.GetValue().data(), Value.GetValue().size());
            return std::span<const std::byte>(Copy.data(), Copy.size());
        }
    }
    if (FBlock* Block = FindBlock(Number)) {
        const FPlace* Place = FindPlace(*Block, Number);
        if (Place && Place->AnswerAt != Released) {
            return ReadAnswer(Block->Bytes, Place->AnswerAt, Number);
        }
    }
    const FKeptResult* Result = Find(Number);
    if (!Result) {
        return NoResult(Number);
    }
    switch (Result->State) {
    case FKeptResult::Pending:
        return MakeError(
            ErrorCode::NeedsFrames, "the future of operation " + std::to_string(Number) +
                                        " is of a latent function that has not completed yet; use it in a later frame");
    case FKeptResult::Failed:
        return FailedResult(Result->Error);
    default:
        return std::span<const std::byte>(Result->Value.data(), Result->Value.size());
    }
}

// Giving up

void FKeptResults::Recycle(FBlock& Block) {
    if (SpareBlocks.size() < MostSpareBlocks && Block.Bytes.capacity() <= LargestSpareBytes) {
        Block.Places.clear();
        Block.Bytes.clear();
        Block.First = Block.Last = 0;
        Block.Live = 0;
        SpareBlocks.push_back(std::move(Block));
    }
}

/// Copies what is left, so that a single future that a client keeps does not keep a whole block.
void FKeptResults::Compact(FBlock& Block) {
    FBlock Smaller;
    Smaller.First = Block.First;
    Smaller.Last = Block.Last;
    Smaller.Live = Block.Live;
    Smaller.Places.reserve(Block.Live);
    for (const FPlace& Place : Block.Places) {
        if (Place.AnswerAt == Released) {
            continue;
        }
        spear::Decoder In({Block.Bytes.data() + Place.AnswerAt, Block.Bytes.size() - Place.AnswerAt});
        (void)In.get_raw(sizeof(uint64) + sizeof(uint8));
        const std::size_t Bytes = sizeof(uint64) + sizeof(uint8) + sizeof(uint32) + In.get<uint32>();
        Smaller.Places.push_back({Place.Delta, static_cast<uint32>(Smaller.Bytes.size())});
        Smaller.Bytes.append(Block.Bytes.data() + Place.AnswerAt, Bytes);
    }
    std::swap(Block, Smaller);
    Recycle(Smaller);
}

void FKeptResults::ReleaseIn(FBlock& Block, uint64 First, uint64 Last) {
    const uint64 From = std::max(First, Block.First);
    const uint64 To = std::min(Last, Block.Last);
    if (From == Block.First && To == Block.Last) {
        NumInBlocks -= Block.Live;
        Block.Live = 0;
        return;
    }
    const auto Delta = static_cast<uint32>(From - Block.First);
    auto At = std::lower_bound(Block.Places.begin(), Block.Places.end(), Delta,
        [](const FPlace& Place, uint32 Wanted) { return Place.Delta < Wanted; });
    for (; At != Block.Places.end() && Block.First + At->Delta <= To; ++At) {
        if (std::exchange(At->AnswerAt, Released) != Released) {
            --Block.Live;
            --NumInBlocks;
        }
    }
}

void FKeptResults::Release(uint64 First, uint64 Count) {
    if (Count == 0) {
        return;
    }
    const uint64 Last = First + std::min(Count - 1, ~uint64{0} - First);
    const auto Begin = std::lower_bound(
        Blocks.begin(), Blocks.end(), First, [](const FBlock& Block, uint64 Wanted) { return Block.Last < Wanted; });
    auto End = Begin;
    bool bEmpty = false;
    for (; End != Blocks.end() && End->First <= Last; ++End) {
        ReleaseIn(*End, First, Last);
        if (End->Live == 0) {
            bEmpty = true;
        } else if (End->Live * CompactBelow < End->Places.size()) {
            Compact(*End);
        }
    }
    if (bEmpty) {
        const auto Kept = std::remove_if(Begin, End, [this](FBlock& Block) {
            if (Block.Live == 0) {
                Recycle(Block);
            }
            return Block.Live == 0;
        });
        Blocks.erase(Kept, End);
    }
    if (Own.empty()) {
        return;
    }
    const auto ReleaseOwn = [this](FOwn::iterator At) {
        FOwn::node_type Node = Own.extract(At);
        // A large or failed result gives its memory back.
        if (SpareOwn.size() < MostSpareOwn && Node.mapped().State != FKeptResult::Failed &&
            Node.mapped().Value.capacity() <= LargestSpareOwn) {
            Node.mapped().State = FKeptResult::Pending;
            Node.mapped().Value.clear();
            SpareOwn.push_back(std::move(Node));
        }
    };
    if (Last - First < Own.size()) {
        for (uint64 Number = First;; ++Number) {
            if (const auto At = Own.find(Number); At != Own.end()) {
                ReleaseOwn(At);
            }
            if (Number == Last) {
                break;
            }
        }
    } else {
        for (auto At = Own.begin(); At != Own.end();) {
            const auto This = At++;
            if (This->first >= First && This->first <= Last) {
                ReleaseOwn(This);
            }
        }
    }
}

} // namespace SpearServer
