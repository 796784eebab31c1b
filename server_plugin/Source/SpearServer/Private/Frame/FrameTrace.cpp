// SPDX-License-Identifier: MIT
#include "Frame/FrameTrace.h"

#include "Frame/EntryPointTable.h"
#include "Frame/Session.h"

#include "Engine/World.h"
#include "Misc/App.h"

#include <algorithm>
#include <string>

namespace SpearServer {

namespace {

void Record(spear_trace_kind Kind, uint64 Began, uint64 Ended, uint64 A = 0) {
    const spear_trace_event Event{Began, Ended - Began, static_cast<uint16>(Kind), 0, 0, A, 0};
    spear_trace_record(&Event);
}

/// The function or property path of an operation whose second argument is a call shape or a path; else null.
const spear::TypeInfo* FindShape(const FSession& Session, std::span<const std::byte> Arguments) {
    spear::Decoder In(Arguments);
    const auto Target = In.get<spear::TypeId>();
    spear::skip_payload(In, Target, Session.Tables());
    const bool bNumber = In.get<spear::TypeId>() == spear::types::u32;
    const auto Shape = In.get<spear::TypeId>();
    const spear::TypeInfo* Info = In.ok() && bNumber ? Session.ClientTypes.find(Shape) : nullptr;
    return Info && (Info->kind == spear::TypeKind::call_shape || Info->kind == spear::TypeKind::path_shape) ? Info
                                                                                                            : nullptr;
}

} // namespace

void FOperationTrace::Start(
    const FSession* Session, uint64 Number, uint16 EntryPoint, std::span<const std::byte> Arguments) {
    Span.emplace(SPEAR_TRACE_OPERATION, Number);
    const spear::TypeInfo* Shape = Session ? FindShape(*Session, Arguments) : nullptr;
    const std::string_view Name = Shape ? std::string_view(Shape->name) : NameOf(EntryPoint);
    Span->set_text(Name.data(), Name.size());
}

void FFrameTrace::Start() {
    spear_trace_name_thread("game thread");
    TickStartHandle = FWorldDelegates::OnWorldTickStart.AddRaw(this, &FFrameTrace::OnWorldTickStart);
    TickEndHandle = FWorldDelegates::OnWorldTickEnd.AddRaw(this, &FFrameTrace::OnWorldTickEnd);
}

void FFrameTrace::Stop() {
    FWorldDelegates::OnWorldTickStart.Remove(TickStartHandle);
    FWorldDelegates::OnWorldTickEnd.Remove(TickEndHandle);
}

void FFrameTrace::BeginFrame() {
    FrameBegan = SPEAR_TRACE_LEVEL() != SPEAR_TRACE_OFF ? spear_trace_now() : 0;
    FrameNumber = GFrameCounter;
    BeginWorkEnded = TickBegan = 0;
}

void FFrameTrace::EndBeginWork() {
    if (FrameBegan != 0) {
        BeginWorkEnded = spear_trace_now();
    }
}

void FFrameTrace::EndFrame() {
    if (FrameBegan != 0) {
        const uint64 Now = spear_trace_now();
        RecordIdleTime(Now);
        Record(SPEAR_TRACE_FRAME, FrameBegan, Now, FrameNumber);
        FrameBegan = 0;
    }
}

void FFrameTrace::OnWorldTickStart(UWorld*, ELevelTick, float) {
    if (FrameBegan != 0) {
        TickBegan = spear_trace_now();
        RecordIdleTime(TickBegan);
    }
}

void FFrameTrace::OnWorldTickEnd(UWorld*, ELevelTick, float) {
    if (TickBegan != 0) {
        Record(SPEAR_TRACE_WORLD_TICK, TickBegan, spear_trace_now());
        TickBegan = 0;
    }
}

/// The engine sleeps in UEngine::UpdateTimeAndHandleMaxTickRate, which comes right after OnBeginFrame, and says for how
/// long.
void FFrameTrace::RecordIdleTime(uint64 Until) {
    if (BeginWorkEnded != 0 && FApp::GetIdleTime() > 0.0) {
        const uint64 Slept = static_cast<uint64>(FApp::GetIdleTime() * 1e9);
        Record(SPEAR_TRACE_IDLE, BeginWorkEnded, std::min(BeginWorkEnded + Slept, Until));
    }
    BeginWorkEnded = 0;
}

} // namespace SpearServer
