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

    // A latent function completes into the kept result, so its place is made before it begins.
    const bool bPlaced = Operation.bKeepResult;
    FKeptResult* Kept = nullptr;
    EOutcome Outcome = EOutcome::Failed;
    if (RunsOnOf(EntryPoint) == spear::RunsOn::game_thread && !bInBlock) {
        Operation.Error = MakeError(ErrorCode::NotInFrame,
            std::string(NameOf(EntryPoint)) + " runs within begin_frame and end_frame blocks only");
    } else if (bPlaced && !(Kept = Session->Keep(Header.number))) {
        Operation.bKeepResult = false;
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
        if (Kept) {
            Kept->State = FKeptResult::Succeeded;
            Kept->Value.append(Answers.buffer.data() + ValueAt, Answers.buffer.size() - ValueAt);
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
        if (Kept) {
            Kept->State = FKeptResult::Failed;
            Kept->Error = std::move(Operation.Error);
        }
        break;
    case EOutcome::Pending: {
        Answers.buffer.resize(Start);
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
        if (bPlaced) {
            Session->ReleaseKept(Header.number); // placed again at the next try
        }
        break;
    }
    return Outcome;
}

} // namespace

bool RunBatch(FSession& Session, FRunningBatch& Running) {
    const bool bInBlock = Running.Batch.Block != EBlock::None;
    const std::span<const std::byte> All(Running.Batch.Operations);
    while (Running.Offset < All.size()) {
        spear::Decoder In(All.subspan(Running.Offset));
        const std::size_t Before = In.remaining();
        const spear::OperationHeader Header = spear::decode_operation_header(In);
        const std::span<const std::byte> Arguments = In.get_raw(Header.bytes);
        if (RunOperation(&Session, Header, Session.EntryPointOf(Header.entry_point), bInBlock, Arguments,
                Running.Answers) == EOutcome::Park) {
            return false;
        }
        Running.Offset += Before - In.remaining();
    }
    return true;
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
