// SPDX-License-Identifier: MIT
#include "Frame/Server.h"

#include "SpearLog.h"
#include "SpearText.h"

#include "Frame/Batches.h"
#include "Reflection/LatentCalls.h"
#include "Services/EngineFacts.h"
#include "Services/Services.h"

#include "spear/limits.hpp"
#include "spear/version.hpp"

#include <cstdio>
#include <thread>

namespace SpearServer {

namespace {

void CopyText(char* To, std::size_t Size, const std::string& Text) { std::snprintf(To, Size, "%s", Text.c_str()); }

void Send(spear_server* Wire, uint64 Session, uint64 Request, const spear::Encoder& Answers, uint64 Frame) {
    spear_answers Message{};
    Message.answers = {reinterpret_cast<const uint8*>(Answers.buffer.data()), Answers.buffer.size()};
    Message.frame = Frame;
    spear_server_reply(Wire, Session, Request, &Message);
}

} // namespace

FStatus FServer::Start(const FServerOptions& Options) {
    BindEngineService();
    BindTraceService();
    BindUnrealService();
    BindUnrealQueries();
    if (const std::string Unbound = UnboundEntryPoints(); !Unbound.empty()) {
        return MakeError(ErrorCode::InternalError, "entry points without implementation: " + Unbound);
    }
    UpdateEngineFacts();
    SetHolderQuery([this] { return Inbox.GetHolder(); });
    FLatentCalls::Get().Start([this](uint64 Session) { return Runner.FindSession(Session); });

    if (Options.MaxQueuedBytes) {
        Inbox.SetMaxQueuedBytes(Options.MaxQueuedBytes);
    }
    const std::string Version(spear::version);
    spear_server_options Wanted{};
    Wanted.address = Options.Address.c_str();
    Wanted.token = Options.Token.empty() ? nullptr : Options.Token.data();
    Wanted.token_size = Options.Token.size();
    Wanted.spear_version = Version.c_str();
    Wanted.default_lease_ms = Options.LeaseMs ? Options.LeaseMs : spear::limits::default_lease_ms;
    Wanted.max_message_bytes = spear::limits::max_message_bytes;
    Wanted.max_sessions = spear::limits::max_sessions;
    const spear_server_callbacks Callbacks{this, &OnConnect, &OnDisconnect, &OnSubmit, &OnStatus, &OnDescribe, &OnLog};
    spear_wire_error Error{};
    spear_server* Started = spear_server_start(&Wanted, &Callbacks, &Error);
    if (!Started) {
        FLatentCalls::Get().Stop();
        SetHolderQuery(nullptr);
        return MakeError(static_cast<ErrorCode>(Error.code), Error.message);
    }
    Wire.store(Started, std::memory_order_release);
    Inbox.SetBell(Started);
    Address = spear_server_address(Started);
    Runner.Start(Started);
    return {};
}

void FServer::Stop() {
    spear_server* Running = Wire.load(std::memory_order_acquire);
    if (!Running) {
        return;
    }
    Inbox.NoteExit();
    spear_server_stop(Running);
    Inbox.SetBell(nullptr);
    Wire.store(nullptr, std::memory_order_release);
    Runner.Stop();
    FLatentCalls::Get().Stop();
    SetHolderQuery(nullptr);
    Address.clear();
}

// Server thread
// -------------------------------------------------------------------------------------------------------------

int FServer::OnConnect(void* User, const spear_hello* Hello, spear_wire_error* Error) {
    FServer& Server = *static_cast<FServer*>(User);
    FSessionGreeting Greeting;
    Greeting.Id = Hello->session;
    Greeting.ClientName = Hello->client_name ? Hello->client_name : "";
    for (std::size_t Index = 0; Index < Hello->entry_point_count; ++Index) {
        const std::string Wanted = Hello->entry_points[Index];
        const int32 Ours = FindSignature(Wanted);
        if (Ours < 0) {
            const std::string Known = SignatureOf(Wanted.substr(0, Wanted.find('(')));
            Error->code = static_cast<uint16_t>(ErrorCode::VersionMismatch);
            CopyText(Error->message, sizeof(Error->message),
                "the client knows the entry point " + Wanted.substr(0, 512) + ", the server " +
                    (Known.empty() ? std::string("has none of that name") : "has " + Known) +
                    "; install the same version of SPEAR on both sides");
            return 0;
        }
        Greeting.EntryPoints.push_back(static_cast<uint16>(Ours));
    }
    UE_LOG(LogSpear, Log, TEXT("Client '%s' has connected (session %llu)"), *FromUtf8(Greeting.ClientName),
        static_cast<unsigned long long>(Greeting.Id));
    Server.Inbox.Join(std::move(Greeting));
    return 1;
}

void FServer::OnDisconnect(void* User, uint64_t Session, const char* Reason) {
    FServer& Server = *static_cast<FServer*>(User);
    UE_LOG(LogSpear, Log, TEXT("Client '%s' has gone (session %llu): %s"),
        *FromUtf8(Server.Inbox.ClientNameOf(Session)), static_cast<unsigned long long>(Session),
        *FromUtf8(Reason ? Reason : ""));
    Server.Inbox.Leave(Session);
}

void FServer::OnSubmit(void* User, uint64_t Session, uint64_t Request, const spear_batch* Batch) {
    FServer& Server = *static_cast<FServer*>(User);
    spear_server* Wire = Server.Wire.load(std::memory_order_acquire);
    while (!Wire) { // the very first client may be faster than the return of spear_server_start
        std::this_thread::yield();
        Wire = Server.Wire.load(std::memory_order_acquire);
    }
    const FInbox::FVerdict Verdict = Server.Inbox.Submit(Session, Request, *Batch);
    switch (Verdict.Kind) {
    case FInbox::FVerdict::Queued:
        return;
    case FInbox::FVerdict::AnswerHere: {
        spear::Encoder Answers;
        const std::span<const std::byte> Operations{
            reinterpret_cast<const std::byte*>(Batch->operations.data), Batch->operations.size};
        RunOnServerThread(Operations, Server.Inbox.EntryPointsOf(Session), Answers);
        Send(Wire, Session, Request, Answers, Server.Inbox.GetFrame());
        return;
    }
    case FInbox::FVerdict::Refused:
    case FInbox::FVerdict::Drop: {
        spear_answers Message{};
        Message.frame = Server.Inbox.GetFrame();
        Message.has_error = 1;
        Message.error_code = static_cast<uint16_t>(Verdict.Error.code);
        Message.error_message = Verdict.Error.message.c_str();
        spear_server_reply(Wire, Session, Request, &Message);
        if (Verdict.Kind == FInbox::FVerdict::Drop) {
            UE_LOG(LogSpear, Warning, TEXT("Ending session %llu: %s"), static_cast<unsigned long long>(Session),
                *FromUtf8(Verdict.Error.message));
            spear_server_drop(Wire, Session, ("MalformedMessage: " + Verdict.Error.message).c_str());
        }
        return;
    }
    }
}

void FServer::OnStatus(void* User, uint64_t Session, spear_status* Status) {
    static_cast<FServer*>(User)->Inbox.FillStatus(Session, *Status);
}

void FServer::OnDescribe(void* User, spear_description* Description) {
    const spear::EngineInfo Facts = GetEngineFacts();
    CopyText(Description->spear_version, sizeof(Description->spear_version), Facts.spear_version);
    CopyText(Description->engine, sizeof(Description->engine), Facts.engine_name + " " + Facts.engine_version);
    CopyText(Description->scene, sizeof(Description->scene), Facts.scene);
    CopyText(Description->project, sizeof(Description->project), Facts.project);
    Description->process_id = Facts.process_id;
    Description->frame = Facts.frame;
    Description->sessions = static_cast<uint32_t>(static_cast<FServer*>(User)->Inbox.NumSessions());
}

void FServer::OnLog(void*, const char* Text) { UE_LOG(LogSpear, Warning, TEXT("%s"), *FromUtf8(Text)); }

} // namespace SpearServer
