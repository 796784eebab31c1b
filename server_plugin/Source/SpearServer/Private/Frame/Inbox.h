// SPDX-License-Identifier: MIT
#pragma once

// The meeting point of server thread and game thread: sessions, their queued batches, and who holds the engine. One
// mutex; nothing in here knows an object. What arrives is checked in shape and order here, its
// values later.

#include "CoreMinimal.h"

#include "Frame/Batch.h"
#include "Frame/Result.h"

#include "spear/limits.hpp"
#include "spear_wire.h"

#include <atomic>
#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace SpearServer {

/// What a new session brings along.
struct FSessionGreeting {
    uint64 Id = 0;
    std::string ClientName;
    std::vector<uint16> EntryPoints; ///< the client's number -> ours
};

/// What has changed since the game thread looked last.
struct FInboxNews {
    std::vector<FSessionGreeting> Joined;
    std::vector<uint64> Left;
};

/// Everything of one session that the game thread takes at once before it runs one of the session's batches.
struct FSessionNews {
    std::vector<std::byte> Types; ///< announcements, in order of arrival
    std::vector<uint64> Releases; ///< kept results to drop now: every batch that may use them has run
};

class FInbox {
public:
    /// Before the first session. At most limits::max_queued_bytes.
    void SetMaxQueuedBytes(std::size_t Bytes) { MaxQueuedBytes = Bytes; }

    // Server thread
    // ---------------------------------------------------------------------------------------------------------
    void Join(FSessionGreeting Greeting);
    void Leave(uint64 Session);

    /// What to do with a batch that was submitted.
    struct FVerdict {
        enum EKind {
            Queued,     ///< the game thread will answer
            AnswerHere, ///< only operations of the server thread: the caller runs and answers them
            Refused,    ///< answer with the error
            Drop        ///< answer with the error, then end the session
        } Kind = Queued;
        ErrorInfo Error;
    };
    FVerdict Submit(uint64 Session, uint64 Request, const spear_batch& Batch);
    /// The session's mapping of entry points; empty if there is no such session.
    std::vector<uint16> EntryPointsOf(uint64 Session) const;
    void FillStatus(uint64 Session, spear_status& Status) const;
    std::size_t NumSessions() const;

    // Game thread
    // -----------------------------------------------------------------------------------------------------------
    /// Rises when there is something for TakeNews or TakeSessionNews.
    uint64 GetNewsCount() const { return NewsCount.load(std::memory_order_acquire); }
    FInboxNews TakeNews();
    /// Into: emptied first; its memory is used.
    void TakeSessionNews(uint64 Session, FSessionNews& Into);
    /// All batches outside of blocks, in order of arrival within each session.
    std::vector<FBatch> TakeFreeBatches();
    bool HasFreeBatches() const { return NumFreeBatches.load(std::memory_order_acquire) != 0; }
    /// The session whose waiting transaction arrived first: of those that Fits(session) accepts.
    template <typename F>
    std::optional<uint64> NextSessionToBegin(F&& Fits) const {
        const std::lock_guard Lock(Mutex);
        std::optional<uint64> Best;
        uint64 BestArrival = 0;
        for (const auto& [Session, Entry] : Entries) {
            if (!Entry.Transactions.empty() && (!Best || Entry.Transactions.front().Arrival < BestArrival) &&
                Fits(Session)) {
                Best = Session;
                BestArrival = Entry.Transactions.front().Arrival;
            }
        }
        return Best;
    }
    /// The next batch of the session's first transaction.
    std::optional<FBatch> TakeBatch(uint64 Session, EBlock Block);
    bool IsBlockClosed(uint64 Session, EBlock Block) const; ///< true for sessions that are gone, too
    bool IsAlive(uint64 Session) const;
    /// The number of the session's first transaction; 0 if it has none.
    uint64 FirstTransaction(uint64 Session) const;
    /// Forgets the session's first transaction; its batches that have not run are returned. Returns whether it asked
    /// for single_step.
    bool FinishTransaction(uint64 Session, std::vector<FBatch>& NotRun);
    /// Notes that the batches of the session up to that one have run (for releases and the limit of queued bytes).
    /// Takes the batch's memory for another.
    void NoteRun(FBatch& Batch);
    /// Notes how many results the session keeps, for its statistics.
    void NoteKept(uint64 Session, std::size_t Count);
    std::string ClientNameOf(uint64 Session) const;

    /// Whom to wake when something arrives (spear_server_wake); null before and after.
    void SetBell(spear_server* Server) { Bell.store(Server, std::memory_order_release); }

    /// Who holds the game thread now, and why (for status reports); 0: nobody.
    void SetHolder(uint64 Session, const char* Reason);
    uint64 GetHolder() const;
    void NoteFrame(uint64 Frame);
    void NoteExit();
    uint64 GetFrame() const { return Frame.load(std::memory_order_relaxed); }

private:
    enum class EPhase : uint8 { Idle, Begin, Between, End };
    struct FEntry {
        FSessionGreeting Greeting;
        uint64 LastSequence = 0;
        uint64 LastTransaction = 0;
        uint64 AbortedTransaction = 0; ///< this one and all before it are over; what still comes for them is refused
        EPhase Phase = EPhase::Idle;   ///< of the transaction that arrived last
        TFifo<FTransaction> Transactions;
        TFifo<FBatch> FreeBatches;
        std::vector<std::byte> Types;
        std::vector<FRelease> Releases;
        std::vector<uint64> ReleaseNumbers; ///< of all Releases, one after the other
        std::vector<uint64> Outstanding;    ///< sequence numbers of batches that have not run, rising
        std::vector<FTransaction> SpareTransactions;
        std::vector<std::vector<std::byte>> SpareOperations;
        std::size_t QueuedBytes = 0;
        std::size_t KeptResults = 0;
    };

    void Wake() const;
    FVerdict SubmitToBlock(FEntry& Entry, FBatch Batch, const spear_batch& Message, std::size_t Operations,
        std::optional<ErrorInfo> TooMuch);
    static void TakeOperations(FEntry& Entry, FBatch& Batch, const spear_batch& Message);
    FEntry* Find(uint64 Session);
    const FEntry* Find(uint64 Session) const;

    std::size_t MaxQueuedBytes = spear::limits::max_queued_bytes;
    mutable std::mutex Mutex;
    std::atomic<uint64> NewsCount{0};           // rises under Mutex
    std::atomic<std::size_t> NumFreeBatches{0}; // changes under Mutex
    std::atomic<spear_server*> Bell{nullptr};
    uint64 LastTransactionArrival = 0;
    std::map<uint64, FEntry> Entries;
    FInboxNews News;

    uint64 Holder = 0;
    std::string HoldReason;
    std::atomic<uint64> Frame{0};
    std::chrono::steady_clock::time_point FrameBegan = std::chrono::steady_clock::now();
    bool bExiting = false;
};

} // namespace SpearServer
