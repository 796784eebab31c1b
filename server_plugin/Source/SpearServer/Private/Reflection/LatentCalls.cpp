// SPDX-License-Identifier: MIT
#include "Reflection/LatentCalls.h"

#include "Frame/Session.h"
#include "Reflection/SpearLatentReceiver.h"
#include "Reflection/Worlds.h"

#include "Engine/LatentActionManager.h"
#include "Engine/World.h"

void USpearLatentReceiver::OnLatentCompleted(int32 Linkage) { SpearServer::FLatentCalls::Get().NoteCompleted(Linkage); }

namespace SpearServer {

FLatentCalls& FLatentCalls::Get() {
    static FLatentCalls Calls;
    return Calls;
}

void FLatentCalls::Start(std::function<FSession*(uint64)> InFindSession) {
    FindSession = std::move(InFindSession);
    Receiver = TStrongObjectPtr<USpearLatentReceiver>(NewObject<USpearLatentReceiver>());
    WorldCleanupHandle = FWorldDelegates::OnWorldCleanup.AddRaw(this, &FLatentCalls::OnWorldCleanup);
}

void FLatentCalls::Stop() {
    FWorldDelegates::OnWorldCleanup.Remove(WorldCleanupHandle);
    Calls.clear();
    Receiver.Reset();
    FindSession = nullptr;
}

int32 FLatentCalls::Begin(
    uint64 Session, uint64 Operation, std::shared_ptr<FCallPlan> Plan, std::shared_ptr<FParameters> Parameters) {
    LastCall = LastCall == MAX_int32 ? 1 : LastCall + 1;
    Calls[LastCall] = {Session, Operation, std::move(Plan), std::move(Parameters), false, false};
    return LastCall;
}

void FLatentCalls::FillInfo(int32 Call, void* LatentInfo) const {
    FLatentActionInfo& Info = *static_cast<FLatentActionInfo*>(LatentInfo);
    Info.Linkage = Call;
    Info.UUID = Call;
    Info.ExecutionFunction = FName(TEXT("OnLatentCompleted"));
    Info.CallbackTarget = Receiver.Get();
}

bool FLatentCalls::Completed(int32 Call) {
    const auto At = Calls.find(Call);
    if (At == Calls.end() || At->second.bCompleted) {
        Calls.erase(Call);
        return true;
    }
    At->second.bReturned = true;
    return false;
}

void FLatentCalls::NoteCompleted(int32 Call) {
    const auto At = Calls.find(Call);
    if (At == Calls.end()) {
        return;
    }
    if (!At->second.bReturned) {
        At->second.bCompleted = true;
        return;
    }
    const FCall Done = std::move(At->second);
    Calls.erase(At);
    Finish(Done);
}

void FLatentCalls::Finish(const FCall& Call) {
    FSession* Session = FindSession ? FindSession(Call.Session) : nullptr;
    FKeptResult* Kept = Session ? Session->Kept.Find(Call.Operation) : nullptr;
    if (!Kept) {
        return; // nobody waits any more
    }
    spear::Encoder Out;
    FStatus Written = WriteResults(*Session, *Call.Plan, Call.Parameters->Get(), Out);
    if (Written.IsOk()) {
        Kept->State = FKeptResult::Succeeded;
        Kept->Value = std::move(Out.buffer);
    } else {
        Kept->State = FKeptResult::Failed;
        Kept->Error = std::move(Written.GetError());
        Kept->Error.operation = Call.Plan->OperationName;
    }
}

void FLatentCalls::OnWorldCleanup(UWorld* World, bool, bool) {
    // The world's latent actions go with it; those of other worlds are few, and stay.
    if (World != GetPrimaryWorld() && GetPrimaryWorld()) {
        return;
    }
    for (const auto& [Number, Call] : Calls) {
        FSession* Session = FindSession ? FindSession(Call.Session) : nullptr;
        if (FKeptResult* Kept = Session ? Session->Kept.Find(Call.Operation) : nullptr) {
            Kept->State = FKeptResult::Failed;
            Kept->Error = MakeError(ErrorCode::StaleObject, "the world ended before the latent function completed");
            Kept->Error.operation = Call.Plan->OperationName;
        }
    }
    Calls.clear();
}

} // namespace SpearServer
