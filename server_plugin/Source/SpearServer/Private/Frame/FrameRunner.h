// SPDX-License-Identifier: MIT
#pragma once

// The game thread's side of the frames: begin_frame blocks run at FCoreDelegates::OnBeginFrame, their end_frame blocks
// at the OnEndFrame of the same frame, and in between the engine does what it always does. (Paper, section 4, "Work
// Queues".)
//
// A frame carries at most one transaction of each session: begin works in order of arrival, then end works in the same
// order. The game thread waits for a client in three places only, all in Hold(): for the rest of a begin block whose
// first operations have come, for the end block of a transaction whose begin block has run, and, after single_step, for
// the next begin block. A client that is gone, or an engine that exits, ends each of them.

#include "CoreMinimal.h"

#include "Frame/Batches.h"
#include "Frame/FrameTrace.h"
#include "Frame/Inbox.h"
#include "Frame/Session.h"

#include "spear_wire.h"

#include <map>
#include <memory>
#include <vector>

namespace SpearServer {

class FFrameRunner {
public:
    FFrameRunner(FInbox& InInbox) : Inbox(InInbox) {}

    /// Binds to the engine's delegates. Game thread.
    void Start(spear_server* InServer);
    /// Unbinds and forgets all sessions. Game thread; no wait may be under way.
    void Stop();

    FSession* FindSession(uint64 Session);

private:
    void OnBeginFrame();
    void OnEndFrame();
    void OnPostGarbageCollect() {
        bSweepNeeded = true;
        ++GarbageEpoch;
    }

    /// New and closed sessions; announcements and releases of all.
    void KeepHouse();
    void ApplyNews(FSession& Session);
    /// Operations outside of blocks.
    void RunFreeBatches();
    /// Runs the batches of a block of the session's first transaction until it is closed. False if the wait was cut
    /// off.
    bool RunBlock(uint64 SessionId, EBlock Block);
    void RunAndReply(FBatch Batch);
    void EndTransaction(uint64 SessionId);
    /// Waits for something to arrive; runs what may run meanwhile. False if the engine exits.
    /// bInBlock: within a block of the session of which nothing is queued, so it may make calls.
    bool Hold(uint64 SessionId, const char* Reason, bool bInBlock);
    void TakeCalls(uint64 SessionId);
    void RunAndAnswer(uint64 SessionId, const spear_call& Call);
    void Reply(const FBatch& Batch, const spear::Encoder& Answers);
    void ReplyError(const FBatch& Batch, const ErrorInfo& Error);
    void SweepIfNeeded();
    void SetHolder(uint64 SessionId, const char* Reason);

    FInbox& Inbox;
    spear_server* Server = nullptr;
    std::map<uint64, std::unique_ptr<FSession>> Sessions;
    std::vector<FRunningBatch> Parked;
    std::vector<uint64> InFrame; ///< sessions whose transaction this frame carries, in order of arrival
    std::vector<uint64> Holders; ///< sessions that hold the engine by single_step, until their next begin block
    FRunningBatch InBlock;      ///< the one that runs, with its memory for the next
    FSessionNews SessionNews; ///< taken last, with its memory
    spear::Encoder CallAnswer;
    std::size_t CallsInBlock = 0;
    uint64 SeenNews = 0;
    uint64 Holder = 0;                ///< as the inbox was told last
    const char* HoldReason = nullptr; ///< a literal
    bool bSweepNeeded = false;
    bool bRunning =
        false; ///< an operation is running: the delegates must not re-enter (a function may tick the engine)

    FDelegateHandle BeginFrameHandle;
    FDelegateHandle EndFrameHandle;
    FDelegateHandle GarbageHandle;
    FFrameTrace Trace;
};

} // namespace SpearServer
