// SPDX-License-Identifier: MIT
#include "Frame/Inbox.h"

#include "Frame/EntryPointTable.h"

#include "spear/limits.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <span>

namespace SpearServer {

namespace {

/// What the headers of a batch's operations say.
struct FBatchShape {
    bool bWellFormed = true;
    bool bOnlyServerThread = true;
    std::size_t Operations = 0;
};

FBatchShape ReadShape(std::span<const std::byte> Bytes, const std::vector<uint16>& EntryPoints) {
    FBatchShape Shape;
    spear::Decoder In(Bytes);
    while (In.ok() && In.remaining() != 0) {
        const spear::OperationHeader Header = spear::decode_operation_header(In);
        (void)In.get_raw(Header.bytes);
        if (!In.ok() || Header.number == 0 || Header.entry_point >= EntryPoints.size()) {
            Shape.bWellFormed = false;
            return Shape;
        }
        Shape.bOnlyServerThread = Shape.bOnlyServerThread && RunsOnServerThread(EntryPoints[Header.entry_point]);
        ++Shape.Operations;
    }
    Shape.bWellFormed = In.ok();
    return Shape;
}

FInbox::FVerdict Refuse(ErrorCode Code, std::string Message) {
    return {FInbox::FVerdict::Refused, MakeError(Code, std::move(Message))};
}

void CopyText(char* To, std::size_t Size, const std::string& Text) { std::snprintf(To, Size, "%s", Text.c_str()); }

std::span<const std::byte> AsSpan(const spear_bytes& Bytes) {
    return {reinterpret_cast<const std::byte*>(Bytes.data), Bytes.size};
}

/// Without frames for so long, the engine counts as busy.
constexpr uint32 BusyAfterMs = 1000;

} // namespace

FInbox::FEntry* FInbox::Find(uint64 Session) {
    const auto At = Entries.find(Session);
    return At != Entries.end() ? &At->second : nullptr;
}

const FInbox::FEntry* FInbox::Find(uint64 Session) const {
    const auto At = Entries.find(Session);
    return At != Entries.end() ? &At->second : nullptr;
}

void FInbox::Join(FSessionGreeting Greeting) {
    const std::lock_guard Lock(Mutex);
    Entries[Greeting.Id].Greeting = Greeting;
    News.Joined.push_back(std::move(Greeting));
    ++NewsCount;
}

void FInbox::Leave(uint64 Session) {
    {
        const std::lock_guard Lock(Mutex);
        const auto At = Entries.find(Session);
        if (At == Entries.end()) {
            return;
        }
        NumFreeBatches -= At->second.FreeBatches.size();
        Entries.erase(At);
        News.Left.push_back(Session);
        ++NewsCount;
    }
    Wake();
}

FInbox::FVerdict FInbox::Submit(uint64 Session, uint64 Request, const spear_batch& Message) {
    FVerdict Verdict;
    {
        const std::lock_guard Lock(Mutex);
        FEntry* Entry = Find(Session);
        if (!Entry) {
            return Refuse(ErrorCode::Disconnected, "the session is closed");
        }
        const FBatchShape Shape = ReadShape(AsSpan(Message.operations), Entry->Greeting.EntryPoints);
        if (!Shape.bWellFormed || Message.block > static_cast<uint8>(EBlock::End)) {
            return {FVerdict::Drop, MakeError(ErrorCode::MalformedMessage,
                                        "the batch is malformed: its operations do not add up or name entry points "
                                        "that were not agreed at connect; the session is ended")};
        }
        // Types and releases count also when the batch itself is refused: the client has given the numbers and goes on.
        const std::span<const std::byte> Types = AsSpan(Message.types);
        const std::size_t Beside = Types.size() + Message.release_count * sizeof(uint64);
        if (Entry->QueuedBytes + Beside > 2 * MaxQueuedBytes) {
            return {FVerdict::Drop,
                MakeError(ErrorCode::LimitExceeded, "the session has far too many bytes queued; it is ended")};
        }
        if (Beside != 0) {
            Entry->Types.insert(Entry->Types.end(), Types.begin(), Types.end());
            Entry->QueuedBytes += Beside;
            ++NewsCount;
        }

        FBatch Batch;
        Batch.Session = Session;
        Batch.Request = Request;
        Batch.Sequence = Entry->LastSequence + 1;
        Batch.Block = static_cast<EBlock>(Message.block);
        Batch.bCloses = Message.closes != 0;
        std::optional<ErrorInfo> TooMuch;
        if (Entry->QueuedBytes + Message.operations.size > MaxQueuedBytes) {
            TooMuch = MakeError(ErrorCode::LimitExceeded,
                "the session has too many bytes queued (limits::max_queued_bytes = " + std::to_string(MaxQueuedBytes) +
                    "); wait for answers before submitting more");
        } else if (Shape.Operations > spear::limits::max_operations_per_block) {
            TooMuch =
                MakeError(ErrorCode::LimitExceeded, "a batch of " + std::to_string(Shape.Operations) +
                                                        " operations exceeds limits::max_operations_per_block = " +
                                                        std::to_string(spear::limits::max_operations_per_block));
        }
        if (Batch.Block != EBlock::None) {
            Verdict = SubmitToBlock(*Entry, std::move(Batch), Message, Shape.Operations, std::move(TooMuch));
        } else if (TooMuch) {
            Verdict = {FVerdict::Refused, std::move(*TooMuch)};
        } else if (Shape.bOnlyServerThread) {
            Verdict.Kind = FVerdict::AnswerHere;
        } else {
            TakeOperations(*Entry, Batch, Message);
            Entry->LastSequence = Batch.Sequence;
            Entry->Outstanding.push_back(Batch.Sequence);
            Entry->FreeBatches.push_back(std::move(Batch));
            ++NumFreeBatches;
        }
        if (Message.release_count != 0) {
            Entry->Releases.push_back({Entry->LastSequence, Message.release_count});
            Entry->ReleaseNumbers.insert(
                Entry->ReleaseNumbers.end(), Message.releases, Message.releases + Message.release_count);
        }
        if (Verdict.Kind != FVerdict::Queued) {
            return Verdict;
        }
    }
    Wake();
    return Verdict;
}

FInbox::FVerdict FInbox::SubmitToBlock(
    FEntry& Entry, FBatch Batch, const spear_batch& Message, std::size_t Operations, std::optional<ErrorInfo> TooMuch) {
    const uint64 Number = Message.transaction;
    if (Number != 0 && Number <= Entry.AbortedTransaction) {
        return Refuse(ErrorCode::TransactionAborted, "the transaction was aborted by the engine");
    }
    const bool bEnd = Batch.Block == EBlock::End;
    if (!bEnd && Entry.Phase == EPhase::Idle) {
        if (Number <= Entry.LastTransaction) {
            return Refuse(ErrorCode::FrameMisuse, "transaction " + std::to_string(Number) +
                                                      " is not newer than the last one, " +
                                                      std::to_string(Entry.LastTransaction));
        }
        if (Entry.Transactions.size() >= spear::limits::max_queued_transactions) {
            return Refuse(ErrorCode::FrameMisuse,
                "the session has too many transactions queued (limits::max_queued_transactions = " +
                    std::to_string(spear::limits::max_queued_transactions) + ")");
        }
        Entry.LastTransaction = Number;
        Entry.Phase = EPhase::Begin;
        if (Entry.SpareTransactions.empty()) {
            Entry.Transactions.push_back({});
        } else {
            Entry.Transactions.push_back(std::move(Entry.SpareTransactions.back()));
            Entry.SpareTransactions.pop_back();
        }
        FTransaction& New = Entry.Transactions.back();
        New.Number = Number;
        New.Arrival = ++LastTransactionArrival;
    } else {
        const bool bFits =
            Number == Entry.LastTransaction && !Entry.Transactions.empty() &&
            (bEnd ? Entry.Phase == EPhase::Between || Entry.Phase == EPhase::End : Entry.Phase == EPhase::Begin);
        if (!bFits) {
            return Refuse(ErrorCode::FrameMisuse,
                std::string(bEnd ? "an end_frame" : "a begin_frame") + " block of transaction " +
                    std::to_string(Number) + " does not fit here: the last transaction is " +
                    std::to_string(Entry.LastTransaction) +
                    (Entry.Phase == EPhase::Idle         ? ", complete"
                        : Entry.Phase == EPhase::Begin   ? ", in its begin_frame block"
                        : Entry.Phase == EPhase::Between ? ", between its blocks"
                                                         : ", in its end_frame block"));
        }
        if (bEnd) {
            Entry.Phase = EPhase::End;
        }
    }

    FTransaction& Transaction = Entry.Transactions.back();
    std::size_t& Count = bEnd ? Transaction.EndOperations : Transaction.BeginOperations;
    if (!TooMuch && Count + Operations > spear::limits::max_operations_per_block) {
        TooMuch = MakeError(ErrorCode::LimitExceeded, "a block of more than limits::max_operations_per_block = " +
                                                          std::to_string(spear::limits::max_operations_per_block) +
                                                          " operations");
    }
    if (!TooMuch) {
        Count += Operations;
        TakeOperations(Entry, Batch, Message);
    }
    const bool bAborts = Message.abort != 0;
    if (Batch.bCloses || bAborts) {
        Batch.bCloses = true;
        if (bEnd || bAborts) {
            Transaction.bBeginClosed = Transaction.bEndClosed = true;
            Transaction.bSingleStep = bEnd && !bAborts && Message.single_step != 0;
            Entry.Phase = EPhase::Idle;
        } else {
            Transaction.bBeginClosed = true;
            Entry.Phase = EPhase::Between;
        }
    }
    if (TooMuch) {
        // The operations are refused, but a block that closes is closed: the frame must go on.
        Wake();
        return {FVerdict::Refused, std::move(*TooMuch)};
    }
    Entry.LastSequence = Batch.Sequence;
    Entry.Outstanding.push_back(Batch.Sequence);
    Transaction.Batches(Batch.Block).push_back(std::move(Batch));
    return {};
}

std::vector<uint16> FInbox::EntryPointsOf(uint64 Session) const {
    const std::lock_guard Lock(Mutex);
    const FEntry* Entry = Find(Session);
    return Entry ? Entry->Greeting.EntryPoints : std::vector<uint16>();
}

std::size_t FInbox::NumSessions() const {
    const std::lock_guard Lock(Mutex);
    return Entries.size();
}

void FInbox::FillStatus(uint64 Session, spear_status& Status) const {
    const std::lock_guard Lock(Mutex);
    const auto Age = std::chrono::steady_clock::now() - FrameBegan;
    Status.frame = GetFrame();
    if (const FEntry* Entry = Find(Session)) {
        Status.kept_results = Entry->KeptResults;
    }
    Status.frames_age_ms = static_cast<uint32>(std::chrono::duration_cast<std::chrono::milliseconds>(Age).count());
    if (bExiting) {
        Status.state = SPEAR_STATE_EXITING;
        CopyText(Status.detail, sizeof(Status.detail), "the engine is ending");
    } else if (Holder != 0) {
        Status.state = Holder == Session ? SPEAR_STATE_HELD_BY_YOU : SPEAR_STATE_HELD_BY_OTHER;
        const FEntry* Entry = Find(Holder);
        CopyText(
            Status.holder, sizeof(Status.holder), Entry ? Entry->Greeting.ClientName : "a client that has just gone");
        CopyText(Status.detail, sizeof(Status.detail), HoldReason);
    } else if (Status.frames_age_ms > BusyAfterMs) {
        Status.state = SPEAR_STATE_BUSY;
        CopyText(Status.detail, sizeof(Status.detail),
            "no frame has begun for " + std::to_string(Status.frames_age_ms) + " ms: loading, or a modal dialog");
    } else {
        Status.state = SPEAR_STATE_RUNNING;
    }
}

FInboxNews FInbox::TakeNews() {
    const std::lock_guard Lock(Mutex);
    return std::exchange(News, {});
}

void FInbox::TakeSessionNews(uint64 Session, FSessionNews& Into) {
    Into.Types.clear();
    Into.Releases.clear();
    const std::lock_guard Lock(Mutex);
    FEntry* Entry = Find(Session);
    if (!Entry) {
        return;
    }
    Into.Types.swap(Entry->Types);
    const uint64 Oldest = Entry->Outstanding.empty() ? std::numeric_limits<uint64>::max() : Entry->Outstanding.front();
    std::size_t Ready = 0;
    std::size_t Numbers = 0;
    for (; Ready < Entry->Releases.size() && Entry->Releases[Ready].After < Oldest; ++Ready) {
        Numbers += Entry->Releases[Ready].Count;
    }
    if (Ready == Entry->Releases.size()) {
        Into.Releases.swap(Entry->ReleaseNumbers);
        Entry->Releases.clear();
    } else {
        const auto First = Entry->ReleaseNumbers.begin();
        const auto Last = First + static_cast<std::ptrdiff_t>(Numbers);
        Into.Releases.assign(First, Last);
        Entry->ReleaseNumbers.erase(First, Last);
        Entry->Releases.erase(
            Entry->Releases.begin(), Entry->Releases.begin() + static_cast<std::ptrdiff_t>(Ready));
    }
    const std::size_t Bytes = Into.Types.size() + Into.Releases.size() * sizeof(uint64);
    Entry->QueuedBytes -= std::min(Bytes, Entry->QueuedBytes);
}

std::vector<FBatch> FInbox::TakeFreeBatches() {
    const std::lock_guard Lock(Mutex);
    std::vector<FBatch> Taken;
    for (auto& [Session, Entry] : Entries) {
        for (FBatch& Batch : Entry.FreeBatches) {
            Taken.push_back(std::move(Batch));
        }
        Entry.FreeBatches.clear();
    }
    NumFreeBatches = 0;
    return Taken;
}

std::optional<FBatch> FInbox::TakeBatch(uint64 Session, EBlock Block) {
    const std::lock_guard Lock(Mutex);
    FEntry* Entry = Find(Session);
    if (!Entry || Entry->Transactions.empty() || Entry->Transactions.front().Batches(Block).empty()) {
        return std::nullopt;
    }
    TFifo<FBatch>& Batches = Entry->Transactions.front().Batches(Block);
    FBatch Batch = std::move(Batches.front());
    Batches.pop_front();
    return Batch;
}

bool FInbox::IsBlockClosed(uint64 Session, EBlock Block) const {
    const std::lock_guard Lock(Mutex);
    const FEntry* Entry = Find(Session);
    return !Entry || Entry->Transactions.empty() ||
           (Entry->Transactions.front().IsClosed(Block) &&
               const_cast<FTransaction&>(Entry->Transactions.front()).Batches(Block).empty());
}

bool FInbox::IsAlive(uint64 Session) const {
    const std::lock_guard Lock(Mutex);
    return Find(Session) != nullptr;
}

uint64 FInbox::FirstTransaction(uint64 Session) const {
    const std::lock_guard Lock(Mutex);
    const FEntry* Entry = Find(Session);
    return Entry && !Entry->Transactions.empty() ? Entry->Transactions.front().Number : 0;
}

bool FInbox::FinishTransaction(uint64 Session, std::vector<FBatch>& NotRun) {
    const std::lock_guard Lock(Mutex);
    FEntry* Entry = Find(Session);
    if (!Entry || Entry->Transactions.empty()) {
        return false;
    }
    FTransaction Transaction = std::move(Entry->Transactions.front());
    Entry->Transactions.pop_front();
    if (!Transaction.bEndClosed) {
        // Cut off before its end arrived: what still comes for it is refused.
        Entry->AbortedTransaction = Transaction.Number;
        Entry->Phase = EPhase::Idle;
    }
    for (EBlock Block : {EBlock::Begin, EBlock::End}) {
        for (FBatch& Batch : Transaction.Batches(Block)) {
            NotRun.push_back(std::move(Batch));
        }
    }
    const bool bSingleStep = Transaction.bSingleStep;
    Transaction.Reset();
    Entry->SpareTransactions.push_back(std::move(Transaction));
    return bSingleStep;
}

/// The operations of a message become those of a batch.
void FInbox::TakeOperations(FEntry& Entry, FBatch& Batch, const spear_batch& Message) {
    if (!Entry.SpareOperations.empty() && Message.operations.size != 0) {
        Batch.Operations = std::move(Entry.SpareOperations.back());
        Entry.SpareOperations.pop_back();
    }
    const std::span<const std::byte> Bytes = AsSpan(Message.operations);
    Batch.Operations.assign(Bytes.begin(), Bytes.end());
    Entry.QueuedBytes += Batch.Operations.size();
}

void FInbox::NoteRun(FBatch& Batch) {
    const std::lock_guard Lock(Mutex);
    if (FEntry* Entry = Find(Batch.Session)) {
        Entry->QueuedBytes -= std::min(Batch.Operations.size(), Entry->QueuedBytes);
        std::erase(Entry->Outstanding, Batch.Sequence);
        NewsCount += !Entry->Releases.empty(); // they may be ready now
        constexpr std::size_t MostSpare = 8;
        constexpr std::size_t LargestSpare = 1u << 20;
        const std::size_t Capacity = Batch.Operations.capacity();
        if (Entry->SpareOperations.size() < MostSpare && Capacity != 0 && Capacity <= LargestSpare) {
            Batch.Operations.clear();
            Entry->SpareOperations.push_back(std::move(Batch.Operations));
        }
    }
}

void FInbox::NoteKept(uint64 Session, std::size_t Count) {
    const std::lock_guard Lock(Mutex);
    if (FEntry* Entry = Find(Session)) {
        Entry->KeptResults = Count;
    }
}

std::string FInbox::ClientNameOf(uint64 Session) const {
    const std::lock_guard Lock(Mutex);
    const FEntry* Entry = Find(Session);
    return Entry ? Entry->Greeting.ClientName : std::string();
}

/// What arrived is in place.
void FInbox::Wake() const {
    if (spear_server* Server = Bell.load(std::memory_order_acquire)) {
        spear_server_wake(Server);
    }
}

void FInbox::SetHolder(uint64 Session, const char* Reason) {
    const std::lock_guard Lock(Mutex);
    Holder = Session;
    HoldReason = Reason;
}

uint64 FInbox::GetHolder() const {
    const std::lock_guard Lock(Mutex);
    return Holder;
}

void FInbox::NoteFrame(uint64 NewFrame) {
    Frame.store(NewFrame, std::memory_order_relaxed);
    const std::lock_guard Lock(Mutex);
    FrameBegan = std::chrono::steady_clock::now();
}

void FInbox::NoteExit() {
    const std::lock_guard Lock(Mutex);
    bExiting = true;
}

} // namespace SpearServer
