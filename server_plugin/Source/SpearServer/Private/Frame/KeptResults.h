// SPDX-License-Identifier: MIT
#pragma once

// Results that later operations may name as futures, until the client gives them up. Those of a block stay in the bytes
// that answered it, with one place for each, so that keeping a result costs no memory of its own and giving up all of a
// block is one step. Those of other batches, and of latent functions, have a value each.

#include "CoreMinimal.h"

#include "Frame/Result.h"

#include "spear/encode.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace SpearServer {

/// A result with a value of its own.
struct FKeptResult {
    enum EState : uint8 { Pending, Succeeded, Failed } State = Succeeded;
    spear::ByteBuffer Value; ///< type number and payload
    ErrorInfo Error;
};

class FKeptResults {
public:
    /// Whether a result can be kept under that number: it is not taken, and limits::max_kept_results is not reached. In
    /// blocks numbers rise.
    bool CanKeep(uint64 Number, bool bInBlock);

    /// A place for a value of its own, pending. Stays where it is until it is released. CanKeep must be true.
    FKeptResult& Keep(uint64 Number);
    FKeptResult* Find(uint64 Number);

    /// The answers of a block's batch begin to be written to Answers, which must stay until EndBatch.
    void BeginBatch(const spear::ByteBuffer& Answers);
    /// Keeps what the answer at that offset says, once it is complete. CanKeep must be true.
    void KeepAnswer(uint64 Number, std::size_t AnswerAt);
    /// The batch has run and is answered. Takes the bytes if anything of them is kept; what Answers has then is memory
    /// for the next batch.
    void EndBatch(spear::ByteBuffer& Answers);

    /// The value of an earlier operation. DependencyFailed, NeedsFrames, or UnknownObject if there is none. Valid until
    /// ForgetResolved().
    TSpearResult<std::span<const std::byte>> Resolve(uint64 Number);
    /// Values that Resolve gave are not needed any more.
    void ForgetResolved() { NumResolved = 0; }

    std::size_t Num() const { return Own.size() + NumInBlocks; }
    /// Gives up the results of `Count` numbers from First on; those that are not kept are passed over.
    void Release(uint64 First, uint64 Count);

private:
    struct FPlace {
        uint32 Delta = 0;    ///< number of the operation - FBlock::First
        uint32 AnswerAt = 0; ///< Released: given up
    };
    struct FBlock {
        uint64 First = 0, Last = 0;
        std::vector<FPlace> Places; ///< by Delta, rising
        std::size_t Live = 0;
        spear::ByteBuffer Bytes;
    };
    static constexpr uint32 Released = 0xffff'ffffu;

    static FPlace* FindPlace(FBlock& Block, uint64 Number);
    FBlock* FindBlock(uint64 Number);
    TSpearResult<std::span<const std::byte>> ReadAnswer(
        const spear::ByteBuffer& Bytes, std::size_t At, uint64 Number) const;
    void Recycle(FBlock& Block);
    void Compact(FBlock& Block);
    void ReleaseIn(FBlock& Block, uint64 First, uint64 Last);

    using FOwn = std::unordered_map<uint64, FKeptResult>;
    FOwn Own;
    std::vector<FOwn::node_type> SpareOwn; ///< released ones with their memory, for the next

    std::vector<FBlock> Blocks; ///< by First, rising; their numbers do not overlap
    FBlock Current;             ///< of the batch that is running
    const spear::ByteBuffer* CurrentBytes = nullptr;
    std::vector<FBlock> SpareBlocks; ///< with their memory
    uint64 LastInBlocks = 0;
    std::size_t NumInBlocks = 0;

    std::vector<std::unique_ptr<spear::ByteBuffer>> Resolved; ///< copies of values in bytes that still grow
    std::size_t NumResolved = 0;
};

} // namespace SpearServer
