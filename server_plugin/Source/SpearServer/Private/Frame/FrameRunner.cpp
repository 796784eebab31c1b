// SPDX-License-Identifier: MIT
#include "Frame/FrameRunner.h"

#include "SpearLog.h"
#include "SpearText.h"

#include "Reflection/ClassLookup.h"
#include "Services/EngineFacts.h"
#include "Services/Services.h"

#include "HAL/ThreadHeartBeat.h"
#include "Misc/CoreDelegates.h"
#include "UObject/UObjectGlobals.h"

#include "spear/limits.hpp"

#include <algorithm>

namespace SpearServer {

namespace {
constexpr const char* NoReason = "";
} // namespace

void FFrameRunner::Start(spear_server* InServer) {
    Server = InServer;
    BeginFrameHandle = FCoreDelegates::OnBeginFrame.AddRaw(this, &FFrameRunner::OnBeginFrame);
    EndFrameHandle = FCoreDelegates::OnEndFrame.AddRaw(this, &FFrameRunner::OnEndFrame);
    Trace.Start();
    GarbageHandle = FCoreUObjectDelegates::GetPostGarbageCollect().AddRaw(this, &FFrameRunner::OnPostGarbageCollect);
}

void FFrameRunner::Stop() {
    FCoreDelegates::OnBeginFrame.Remove(BeginFrameHandle);
    FCoreDelegates::OnEndFrame.Remove(EndFrameHandle);
    Trace.Stop();
    FCoreUObjectDelegates::GetPostGarbageCollect().Remove(GarbageHandle);
    Parked.clear();
    Sessions.clear();
    Server = nullptr;
}

FSession* FFrameRunner::FindSession(uint64 Session) {
    const auto At = Sessions.find(Session);
    return At != Sessions.end() ? At->second.get() : nullptr;
}

// Frames
// --------------------------------------------------------------------------------------------------------------------

void FFrameRunner::OnBeginFrame() {
    if (bRunning) {
        return;
    }
    Trace.BeginFrame();
    Inbox.NoteFrame(GFrameCounter);
    spear_server_poll(Server);
    UpdateEngineFacts();
    InFrame.clear();
    RunFreeBatches();
    for (;;) {
        // While somebody holds the engine by single_step, nobody else's transaction begins.
        std::erase_if(Holders, [this](uint64 Session) { return !Inbox.IsAlive(Session); });
        const std::optional<uint64> Next = Inbox.NextSessionToBegin([this](uint64 Session) {
            return Holders.empty() ? std::find(InFrame.begin(), InFrame.end(), Session) == InFrame.end()
                                   : std::find(Holders.begin(), Holders.end(), Session) != Holders.end();
        });
        if (Next) {
            std::erase(Holders, *Next);
            if (RunBlock(*Next, EBlock::Begin)) {
                InFrame.push_back(*Next);
            } else {
                EndTransaction(*Next);
            }
        } else if (Holders.empty()) {
            break;
        } else if (!Hold(Holders.front(),
                       "single_step: the engine waits at the beginning of a frame for the client's next "
                       "begin_frame block",
                       false)) {
            Holders.clear();
        }
    }
    spear_server_release(Server);
    SetHolder(0, NoReason);
    Trace.EndBeginWork();
}

void FFrameRunner::OnEndFrame() {
    if (bRunning) {
        return;
    }
    spear_server_poll(Server);
    for (const uint64 Session : InFrame) {
        RunBlock(Session, EBlock::End);
        EndTransaction(Session);
    }
    InFrame.clear();
    spear_server_release(Server);
    SetHolder(0, NoReason);
    Trace.EndFrame();
}

bool FFrameRunner::RunBlock(uint64 SessionId, EBlock Block) {
    CallsInBlock = 0;
    spear::TraceSpan Span(Block == EBlock::Begin ? SPEAR_TRACE_BEGIN_WORK : SPEAR_TRACE_END_WORK);
    if (Span.is_on()) {
        Span.set_arguments(SessionId, Inbox.FirstTransaction(SessionId));
    }
    for (;;) {
        if (std::optional<FBatch> Batch = Inbox.TakeBatch(SessionId, Block)) {
            RunAndReply(std::move(*Batch));
            continue;
        }
        if (Inbox.IsBlockClosed(SessionId, Block)) {
            return Inbox.IsAlive(SessionId);
        }
        const bool bGoesOn = Hold(SessionId,
            Block == EBlock::Begin
                ? "an open begin_frame block: the engine waits at the beginning of a frame for the block to close"
                : "a transaction between begin_frame and the end of end_frame: the engine waits at the end of the "
                  "frame",
            true);
        if (!bGoesOn) {
            return false;
        }
    }
}

void FFrameRunner::EndTransaction(uint64 SessionId) {
    std::vector<FBatch> NotRun;
    const bool bSingleStep = Inbox.FinishTransaction(SessionId, NotRun);
    for (FBatch& Batch : NotRun) {
        Inbox.NoteRun(Batch);
        ReplyError(
            Batch, MakeError(ErrorCode::TransactionAborted, "the transaction was aborted: the engine is ending"));
    }
    if (bSingleStep && Inbox.IsAlive(SessionId)) {
        Holders.push_back(SessionId);
    }
}

bool FFrameRunner::Hold(uint64 SessionId, const char* Reason, bool bInBlock) {
    if (IsEngineExitRequested()) {
        return false;
    }
    SetHolder(SessionId, Reason);
    if (bInBlock) {
        TakeCalls(SessionId);
    } else {
        const spear::TraceSpan Span(SPEAR_TRACE_WAIT_FOR_CLIENT, SessionId);
        spear_server_wait(Server, SessionId, spear::limits::game_thread_wake_ms);
    }
    FThreadHeartBeat::Get().HeartBeat();
    RunFreeBatches();
    return true;
}

/// Runs the session's calls, one after the other, until there is something else to do.
void FFrameRunner::TakeCalls(uint64 SessionId) {
    constexpr int32 MostAtOnce = 1000; // then the heartbeat is due
    for (int32 Count = 0; Count < MostAtOnce; ++Count) {
        spear_call Call{};
        bool bHasCall = false;
        {
            const spear::TraceSpan Span(SPEAR_TRACE_WAIT_FOR_CLIENT, SessionId);
            bHasCall = spear_server_wait_call(Server, SessionId, spear::limits::game_thread_wake_ms, &Call) != 0;
        }
        if (!bHasCall) {
            return;
        }
        RunAndAnswer(SessionId, Call);
        if (Inbox.HasFreeBatches() || !Parked.empty() || IsEngineExitRequested()) {
            return;
        }
    }
}

void FFrameRunner::RunAndAnswer(uint64 SessionId, const spear_call& Call) {
    KeepHouse();
    FSession* Session = FindSession(SessionId);
    if (!Session) {
        return;
    }
    if (!Session->IsEntryPoint(Call.entry_point)) {
        spear_server_drop(Server, SessionId,
            "MalformedMessage: a call names an entry point that was not agreed at connect");
        return;
    }
    bool bSucceeded = false;
    if (++CallsInBlock > spear::limits::max_operations_per_block) {
        CallAnswer.buffer.clear();
        spear::encode_error(CallAnswer, MakeError(ErrorCode::LimitExceeded,
                                            "a block of more than limits::max_operations_per_block = " +
                                                std::to_string(spear::limits::max_operations_per_block) +
                                                " operations"));
    } else {
        bRunning = true;
        bSucceeded = RunCall(*Session, Call.number, Session->EntryPointOf(Call.entry_point),
            {reinterpret_cast<const std::byte*>(Call.arguments.data), Call.arguments.size}, CallAnswer);
        bRunning = false;
    }
    spear_call_answer Answer{};
    Answer.frame = GFrameCounter;
    Answer.failed = !bSucceeded;
    Answer.value = {reinterpret_cast<const uint8*>(CallAnswer.buffer.data()), CallAnswer.buffer.size()};
    if (Session->TypeNumbers.HasPending()) {
        const spear::ByteBuffer Types = Session->TypeNumbers.TakePending();
        Answer.types = {reinterpret_cast<const uint8*>(Types.data()), Types.size()};
        spear_server_answer_call(Server, SessionId, &Answer);
    } else {
        spear_server_answer_call(Server, SessionId, &Answer);
    }
    SweepIfNeeded();
}

// Batches
// -------------------------------------------------------------------------------------------------------------------

void FFrameRunner::KeepHouse() {
    SweepIfNeeded();
    const uint64 Count = Inbox.GetNewsCount();
    if (Count == SeenNews) {
        return;
    }
    SeenNews = Count;
    FInboxNews News = Inbox.TakeNews();
    for (FSessionGreeting& Greeting : News.Joined) {
        const uint64 Id = Greeting.Id;
        Sessions[Id] = std::make_unique<FSession>(std::move(Greeting));
    }
    for (const uint64 Id : News.Left) {
        Sessions.erase(Id);
        Parked.erase(std::remove_if(Parked.begin(), Parked.end(),
                         [Id](const FRunningBatch& One) { return One.Batch.Session == Id; }),
            Parked.end());
    }
    for (const auto& [Id, Session] : Sessions) {
        ApplyNews(*Session);
    }
}

void FFrameRunner::ApplyNews(FSession& Session) {
    Inbox.TakeSessionNews(Session.GetId(), SessionNews);
    const FSessionNews& News = SessionNews;
    if (!News.Types.empty() && !spear::decode_announcements(News.Types, Session.ClientTypes)) {
        UE_LOG(LogSpear, Warning, TEXT("Ending the session of '%s': it announced malformed types"),
            *FromUtf8(Session.GetClientName()));
        spear_server_drop(
            Server, Session.GetId(), "MalformedMessage: the announced types are malformed, out of order, or too many");
    }
    for (std::size_t Index = 0; Index < News.Releases.size(); ++Index) {
        const uint64 First = News.Releases[Index];
        if ((First & spear::release_range) != 0 && Index + 1 < News.Releases.size()) {
            Session.Kept.Release(First & ~spear::release_range, News.Releases[++Index]);
        } else {
            Session.Kept.Release(First, 1);
        }
    }
    if (!News.Releases.empty()) {
        Inbox.NoteKept(Session.GetId(), Session.Kept.Num());
    }
}

void FFrameRunner::RunFreeBatches() {
    if (!Inbox.HasFreeBatches() && Parked.empty()) {
        KeepHouse();
        return;
    }
    // What has arrived is taken before announcements are applied, so that those of each batch are there when it runs.
    std::vector<FBatch> Arrived = Inbox.TakeFreeBatches();
    KeepHouse();
    std::vector<FRunningBatch> ToRun = std::move(Parked);
    Parked.clear();
    for (FBatch& Batch : Arrived) {
        ToRun.push_back({std::move(Batch), 0, {}});
    }
    for (FRunningBatch& Running : ToRun) {
        FSession* Session = FindSession(Running.Batch.Session);
        if (!Session) {
            continue;
        }
        bRunning = true;
        const bool bDone = RunBatch(*Session, Running);
        bRunning = false;
        SweepIfNeeded();
        if (bDone) {
            Inbox.NoteKept(Session->GetId(), Session->Kept.Num());
            Inbox.NoteRun(Running.Batch);
            Reply(Running.Batch, Running.Answers);
        } else {
            Parked.push_back(std::move(Running));
        }
    }
}

void FFrameRunner::SetHolder(uint64 SessionId, const char* Reason) {
    if (SessionId != Holder || Reason != HoldReason) {
        Holder = SessionId;
        HoldReason = Reason;
        Inbox.SetHolder(SessionId, Reason);
    }
}

void FFrameRunner::RunAndReply(FBatch Batch) {
    KeepHouse();
    FSession* Session = FindSession(Batch.Session);
    if (!Session) {
        return;
    }
    InBlock.Batch = std::move(Batch);
    InBlock.Offset = 0;
    InBlock.Answers.buffer.clear();
    bRunning = true;
    RunBatch(*Session, InBlock); // operations of a block are never parked
    bRunning = false;
    Inbox.NoteKept(InBlock.Batch.Session, Session->Kept.Num());
    Inbox.NoteRun(InBlock.Batch);
    Reply(InBlock.Batch, InBlock.Answers);
    Session->Kept.EndBatch(InBlock.Answers.buffer);
    SweepIfNeeded();
}

void FFrameRunner::Reply(const FBatch& Batch, const spear::Encoder& Answers) {
    spear::ByteBuffer Types;
    if (FSession* Session = FindSession(Batch.Session); Session && Session->TypeNumbers.HasPending()) {
        Types = Session->TypeNumbers.TakePending();
    }
    spear_answers Message{};
    Message.types = {reinterpret_cast<const uint8*>(Types.data()), Types.size()};
    Message.answers = {reinterpret_cast<const uint8*>(Answers.buffer.data()), Answers.buffer.size()};
    Message.frame = GFrameCounter;
    spear_server_reply(Server, Batch.Session, Batch.Request, &Message);
    ExitIfAsked();
}

void FFrameRunner::ReplyError(const FBatch& Batch, const ErrorInfo& Error) {
    spear_answers Message{};
    Message.frame = GFrameCounter;
    Message.has_error = 1;
    Message.error_code = static_cast<uint16>(Error.code);
    Message.error_message = Error.message.c_str();
    spear_server_reply(Server, Batch.Session, Batch.Request, &Message);
}

void FFrameRunner::SweepIfNeeded() {
    if (!bSweepNeeded || bRunning) {
        return;
    }
    bSweepNeeded = false;
    SweepTypePlans();
    ForgetClassNames();
    for (const auto& [Id, Session] : Sessions) {
        Session->Sweep();
    }
}

} // namespace SpearServer
