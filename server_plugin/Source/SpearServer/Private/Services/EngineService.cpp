// SPDX-License-Identifier: MIT
#include "Services/Services.h"

#include "SpearText.h"

#include "Frame/EntryPointTable.h"
#include "Frame/Session.h"
#include "Services/EngineFacts.h"

#include "HAL/PlatformMisc.h"

#include "spear/entry_points/engine_service.hpp"

#include <atomic>

namespace SpearServer {

namespace {

std::function<uint64()>& GetHolderQuery() {
    static std::function<uint64()> Query;
    return Query;
}

std::atomic<bool> ExitAsked{false};

} // namespace

void ExitIfAsked() {
    if (ExitAsked.load(std::memory_order_relaxed) && ExitAsked.exchange(false)) {
        FPlatformMisc::RequestExit(false);
    }
}

void SetHolderQuery(std::function<uint64()> InGetHolder) { GetHolderQuery() = std::move(InGetHolder); }
uint64 GetHolderOfEngine() { return GetHolderQuery() ? GetHolderQuery()() : 0; }

void BindEngineService() {
    namespace service = spear::engine_service;

    Bind(service::ping,
        [](FOperation&, std::string_view Text) -> TSpearResult<std::string> { return std::string(Text); });

    Bind(service::get_engine_info, [](FOperation&) -> TSpearResult<spear::EngineInfo> { return GetEngineFacts(); });

    Bind(service::get_frame_number,
        [](FOperation&) -> TSpearResult<std::uint64_t> { return std::uint64_t{GetEngineFacts().frame}; });

    Bind(service::request_exit, [](FOperation&) -> FStatus {
        ExitAsked = true; // see ExitIfAsked
        return {};
    });

    Bind(service::wait_for_result, [](FOperation& Operation, std::uint64_t Number) -> FStatus {
        const FKeptResult* Kept = Operation.Session->Kept.Find(Number);
        if (!Kept) {
            if (const auto Value = Operation.Session->Kept.Resolve(Number); Value.IsOk()) {
                Operation.Out->put_raw(Value.GetValue().data(), Value.GetValue().size());
                return {};
            }
            return MakeError(ErrorCode::DependencyFailed,
                "operation " + std::to_string(Number) +
                    " has no result here: it has not run, its result was not kept, or its future was dropped",
                "operation");
        }
        switch (Kept->State) {
        case FKeptResult::Succeeded:
            Operation.Out->put_raw(Kept->Value.data(), Kept->Value.size());
            return {};
        case FKeptResult::Failed:
            return ErrorInfo(Kept->Error);
        default:
            break;
        }
        if (Operation.bInBlock || GetHolderOfEngine() == Operation.Session->GetId()) {
            return MakeError(ErrorCode::NeedsFrames,
                "the latent function needs frames to complete, but you hold the engine (an open block, or "
                "single_step); close the block, or end it without single_step");
        }
        Operation.Outcome = EOutcome::Park;
        return {};
    });
}

} // namespace SpearServer
