// SPDX-License-Identifier: MIT
#include "Frame/Batches.h"

#include "Frame/FrameTrace.h"
#include "Frame/Session.h"

#include "spear/limits.hpp"

namespace SpearServer {

namespace {

/// Room left for the envelope and the answers that follow, so that a reply never exceeds limits::max_message_bytes.
constexpr std::size_t LargestReply = spear::limits::max_message_bytes - (1u << 20);

bool HasFlag(spear::OperationFlags Flags, spear::OperationFlags Flag) {
    return (static_cast<uint8>(Flags) & static_cast<uint8>(Flag)) != 0;
}

void AnswerError(
    spear::Encoder& Answers, std::size_t Start, uint64 Number, spear::AnswerState State, const ErrorInfo& Error) {
    Answers.buffer.resize(Start);
    const std::size_t At = spear::begin_answer(Answers, Number, State);
    spear::encode_error(Answers, Error);
    spear::end_answer(Answers, At);
}

/// Messages quote what clients sent; they stay readable.
void CutTexts(ErrorInfo& Error) {
    constexpr std::size_t Longest = 4096;
    for (std::string* Text : {&Error.message, &Error.operation, &Error.argument, &Error.expected}) {
        if (Text->size() > Longest) {
            Text->resize(Longest);
            *Text += "...";
        }
    }
}

/// Runs one operation and appends its answer. Park leaves the answers as they were.
EOutcome RunOperation(FSession* Session, const spear::OperationHeader& Header, uint16 EntryPoint, bool bInBlock,
    std::span<const std::byte> Arguments, spear::Encoder& Answers) {
    FOperation Operation;
    Operation.Session = Session;
    Operation.Out = &Answers;
    Operation.Number = Header.number;
    Operation.bInBlock = bInBlock;
    Operation.bWantsAnswer = HasFlag(Header.flags, spear::OperationFlags::wants_answer);
    Operation.bKeepResult = HasFlag(Header.flags, spear::OperationFlags::keep_result) && Session;

    const std::size_t Start = Answers.buffer.size();
    const std::size_t At = spear::begin_answer(Answers, Header.number, spear::AnswerState::succeeded);
    const std::size_t ValueAt = Answers.buffer.size();

    bool bKeeps = Operation.bKeepResult;
    EOutcome Outcome = EOutcome::Failed;
    if (RunsOnOf(EntryPoint) == spear::RunsOn::game_thread && !bInBlock) {
        Operation.Error = MakeError(ErrorCode::NotInFrame,
            std::string(NameOf(EntryPoint)) + " runs within begin_frame and end_frame blocks only");
    } else if (bKeeps && !Session->Kept.CanKeep(Header.number, bInBlock)) {
        bKeeps = Operation.bKeepResult = false;
        Operation.Error = MakeError(ErrorCode::LimitExceeded,
            "the result cannot be kept: operation number " + std::to_string(Header.number) +
                " is taken, or limits::max_kept_results = " + std::to_string(spear::limits::max_kept_results) +
                " is reached; drop futures");
    } else {
        FOperationTrace Trace(Session, Header.number, EntryPoint, Arguments);
        spear::Decoder In(Arguments);
        Outcome = GetHandler(EntryPoint)(Operation, In);
    }
    if (Outcome == EOutcome::Done && Answers.buffer.size() > LargestReply) {
        const bool bAloneTooLarge = Answers.buffer.size() - Start > LargestReply;
        Outcome = EOutcome::Failed;
        Operation.Error = MakeError(ErrorCode::LimitExceeded,
            bAloneTooLarge ? "the result is larger than a message may be (limits::max_message_bytes); read it in parts"
                           : "the results of the block together are larger than a message may be "
                             "(limits::max_message_bytes); spread them over several blocks");
    }
    switch (Outcome) {
    case EOutcome::Done:
        spear::end_answer(Answers, At);
        if (bKeeps && bInBlock && Operation.bWantsAnswer) {
            Session->Kept.KeepAnswer(Header.number, Start);
        } else if (bKeeps) {
            FKeptResult& Kept = Session->Kept.Keep(Header.number);
            Kept.State = FKeptResult::Succeeded;
            Kept.Value.append(Answers.buffer.data() + ValueAt, Answers.buffer.size() - ValueAt);
        }
        if (!Operation.bWantsAnswer) {
            Answers.buffer.resize(Start);
        }
        break;
    case EOutcome::Failed:
        if (Operation.Error.operation.empty()) {
            Operation.Error.operation = std::string(NameOf(EntryPoint));
        }
        CutTexts(Operation.Error);
        AnswerError(Answers, Start, Header.number, spear::AnswerState::failed, Operation.Error);
        if (bKeeps) {
            FKeptResult& Kept = Session->Kept.Keep(Header.number);
            Kept.State = FKeptResult::Failed;
            Kept.Error = std::move(Operation.Error);
        }
        break;
    case EOutcome::Pending: {
        Answers.buffer.resize(Start);
        if (bKeeps) { // the latent function completes into it, in a later frame
            Session->Kept.Keep(Header.number);
        }
        if (Operation.bWantsAnswer) {
            ErrorInfo Error = MakeError(ErrorCode::NeedsFrames,
                "the latent function completes in a later frame: leave the block, then wait for its future");
            Error.operation = std::string(NameOf(EntryPoint));
            AnswerError(Answers, Start, Header.number, spear::AnswerState::pending, Error);
        }
        break;
    }
    case EOutcome::Park:
        Answers.buffer.resize(Start);
        break;
    }
    if (Session) {
        Session->Kept.ForgetResolved();
    }
    return Outcome;
}

/// Runs an operation of a block if it is a plain call (FPlainCalls), as nearly all are. False: RunOperation takes it.
bool RunPlainCall(FSession& Session, const spear::OperationHeader& Header, std::span<const std::byte> Arguments,
    spear::Encoder& Answers) {
    const bool bWantsAnswer = HasFlag(Header.flags, spear::OperationFlags::wants_answer);
    const bool bKeeps = HasFlag(Header.flags, spear::OperationFlags::keep_result);
    if ((bKeeps && (!bWantsAnswer || !Session.Kept.CanKeep(Header.number, true))) ||
        Answers.buffer.size() > LargestReply) {
        return false;
    }
    const FPlainCalls::FReady Ready = Session.PlainCalls.Find(Session, Arguments);
    if (!Ready.Object) {
        return false;
    }
    if (!bWantsAnswer) {
        FPlainCalls::Make(Ready, nullptr);
        return true;
    }
    const std::size_t Start = Answers.buffer.size();
    std::byte* const At = Answers.buffer.extend(spear::answer_header_size + Ready.ResultBytes());
    spear::store_answer_header(
        At, Header.number, spear::AnswerState::succeeded, static_cast<uint32>(Ready.ResultBytes()));
    FPlainCalls::Make(Ready, At + spear::answer_header_size); // writes no answers of its own
    if (bKeeps) {
        Session.Kept.KeepAnswer(Header.number, Start);
    }
    return true;
}

} // namespace

bool RunBatch(FSession& Session, FRunningBatch& Running) {
    const bool bInBlock = Running.Batch.Block != EBlock::None;
    const bool bPlainCalls = bInBlock && SPEAR_TRACE_LEVEL() != SPEAR_TRACE_OPERATIONS;
    const std::span<const std::byte> All(Running.Batch.Operations);
    if (bInBlock) {
        Session.Kept.BeginBatch(Running.Answers.buffer);
    }
    while (Running.Offset < All.size()) {
        // The headers were checked when the batch arrived (FInbox::Submit).
        const spear::OperationHeader Header = spear::load_operation_header(All.data() + Running.Offset);
        const std::span<const std::byte> Arguments =
            All.subspan(Running.Offset + spear::OperationHeader::size, Header.bytes);
        const uint16 EntryPoint = Session.EntryPointOf(Header.entry_point);
        if (!(bPlainCalls && EntryPoint == CallFunctionEntryPoint() && RunPlainCall(Session, Header, Arguments, Running.Answers)) &&
            RunOperation(&Session, Header, EntryPoint, bInBlock, Arguments, Running.Answers) == EOutcome::Park) {
            return false;
        }
        Running.Offset += spear::OperationHeader::size + Header.bytes;
    }
    return true;
}

bool RunCall(FSession& Session, uint64 Number, uint16 EntryPoint, std::span<const std::byte> Arguments,
    spear::Encoder& Answer) {
    Answer.buffer.clear();
    if (EntryPoint == CallFunctionEntryPoint() && SPEAR_TRACE_LEVEL() != SPEAR_TRACE_OPERATIONS) {
        if (const FPlainCalls::FReady Ready = Session.PlainCalls.Find(Session, Arguments); Ready.Object) {
            FPlainCalls::Make(Ready, Answer.buffer.extend(Ready.ResultBytes()));
            return true;
        }
    }
    spear::OperationHeader Header;
    Header.number = Number;
    Header.flags = spear::OperationFlags::wants_answer;
    // The record of an answer, of which the value is wanted.
    RunOperation(&Session, Header, EntryPoint, true, Arguments, Answer);
    spear::Decoder In(Answer.bytes());
    (void)In.get<uint64>();
    const bool bSucceeded = In.get<spear::AnswerState>() == spear::AnswerState::succeeded;
    const uint32 Bytes = In.get<uint32>();
    std::memmove(Answer.buffer.data(), In.position(), Bytes);
    Answer.buffer.resize(Bytes);
    return bSucceeded;
}

void RunOnServerThread(
    std::span<const std::byte> Operations, const std::vector<uint16>& EntryPoints, spear::Encoder& Answers) {
    spear::Decoder In(Operations);
    while (In.ok() && In.remaining() != 0) {
        const spear::OperationHeader Header = spear::decode_operation_header(In);
        const std::span<const std::byte> Arguments = In.get_raw(Header.bytes);
        RunOperation(nullptr, Header, EntryPoints[Header.entry_point], false, Arguments, Answers);
    }
}

} // namespace SpearServer
