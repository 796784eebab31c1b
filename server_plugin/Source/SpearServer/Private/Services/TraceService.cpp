// SPDX-License-Identifier: MIT
#include "Services/Services.h"

#include "Frame/EntryPointTable.h"

#include "HAL/PlatformProcess.h"

#include "spear/entry_points/trace_service.hpp"
#include "spear/limits.hpp"
#include "spear_trace.h"

#include <algorithm>
#include <mutex>

namespace SpearServer {

namespace {

/// Events of one part: what a message carries without trouble.
constexpr std::size_t EventsOfPart = 16384;

/// The recording that was started last. Entry points of the server thread run on other threads too (spear_wire.h,
/// submit).
struct FRecording {
    std::mutex Mutex;
    uint64 Number = 0;            // under Mutex
    spear_trace* Ended = nullptr; // under Mutex: once it was stopped

    void Forget() {
        spear_trace_free(Ended);
        Ended = nullptr;
        Number = 0;
    }
};

FRecording& GetRecording() {
    static FRecording Recording;
    return Recording;
}

std::size_t PartsOf(std::size_t Events) { return std::max<std::size_t>(1, (Events + EventsOfPart - 1) / EventsOfPart); }

spear::TracePart ReadPart(const spear_trace* Trace, uint64 Wanted) {
    spear::TracePart Part;
    Part.process_id = FPlatformProcess::GetCurrentProcessId();
    if (Wanted == 0) {
        for (std::size_t Text = 1; Text <= spear_trace_text_count(Trace); ++Text) {
            Part.texts.emplace_back(spear_trace_text_at(Trace, Text));
        }
    }
    for (std::size_t Thread = 0; Thread < spear_trace_thread_count(Trace); ++Thread) {
        const char* Name = nullptr;
        std::size_t Count = 0;
        uint64_t ThreadId = 0;
        uint64_t Dropped = 0;
        const spear_trace_event* Events = spear_trace_thread(Trace, Thread, &Name, &ThreadId, &Count, &Dropped);
        const std::size_t Parts = PartsOf(Count);
        if (Wanted >= Part.parts && Wanted < Part.parts + Parts) {
            Part.thread = Name;
            Part.thread_id = ThreadId;
            Part.dropped = Dropped;
            const std::size_t First = static_cast<std::size_t>(Wanted - Part.parts) * EventsOfPart;
            for (std::size_t Index = First; Index < std::min(Count, First + EventsOfPart); ++Index) {
                const spear_trace_event& Event = Events[Index];
                const uint64 What = Event.kind | uint64{Event.detail} << 16 | uint64{Event.text} << 32;
                Part.events.insert(Part.events.end(), {Event.begin_ns, Event.duration_ns, What, Event.a, Event.b});
            }
        }
        Part.parts += Parts;
    }
    return Part;
}

} // namespace

void BindTraceService() {
    namespace service = spear::trace_service;

    Bind(service::start,
        [](FOperation&, bool bOperations, std::uint64_t EventsPerThread) -> TSpearResult<std::uint64_t> {
            if (EventsPerThread == 0 || EventsPerThread > spear::limits::max_trace_events) {
                return MakeError(ErrorCode::LimitExceeded,
                    "a recording of " + std::to_string(EventsPerThread) +
                        " events per thread is not possible: 1 to limits::max_trace_events = " +
                        std::to_string(spear::limits::max_trace_events),
                    "events_per_thread");
            }
            FRecording& Recording = GetRecording();
            const std::lock_guard Lock(Recording.Mutex);
            Recording.Forget();
            Recording.Number = spear_trace_start(
                bOperations ? SPEAR_TRACE_OPERATIONS : SPEAR_TRACE_ON, static_cast<std::size_t>(EventsPerThread));
            if (Recording.Number == 0) {
                return MakeError(ErrorCode::LimitExceeded, "the engine has no memory for a recording");
            }
            return std::uint64_t{Recording.Number};
        });

    Bind(service::stop, [](FOperation&, std::uint64_t Number, std::uint64_t Part) -> TSpearResult<spear::TracePart> {
        FRecording& Recording = GetRecording();
        const std::lock_guard Lock(Recording.Mutex);
        if (Number == Recording.Number && Number != 0 && !Recording.Ended) {
            Recording.Ended = spear_trace_stop(Number);
        }
        if (Number != Recording.Number || !Recording.Ended) {
            return MakeError(ErrorCode::UnknownObject,
                "recording " + std::to_string(Number) +
                    " is gone: somebody else has started another one, and an engine has one at a time",
                "recording");
        }
        spear::TracePart Found = ReadPart(Recording.Ended, Part);
        if (Part + 1 >= Found.parts) { // the last one was asked for
            Recording.Forget();
        }
        return Found;
    });

    Bind(service::get_clock,
        [](FOperation&) -> TSpearResult<std::uint64_t> { return std::uint64_t{spear_trace_now()}; });
}

} // namespace SpearServer
