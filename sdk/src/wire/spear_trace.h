/* SPDX-License-Identifier: MIT */
#ifndef SPEAR_TRACE_H
#define SPEAR_TRACE_H

/* Trace points: what client, server and game threads do, recorded for `spear trace`. One recorder for each process, in spear_wire,
 * so that the SDK, the wire and the plugin write into the same recording.
 *
 * A point that is not recorded costs one relaxed load and a branch. Recorded ones go into a buffer of their thread, without a lock;
 * a full buffer drops what comes later and counts it. Times are nanoseconds of CLOCK_MONOTONIC, which all processes of a machine
 * share. Everything may be called from any thread. */

#include "spear_wire.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What is recorded; spear::trace_kinds (trace.cpp of the SDK) has names and arguments. The numbers are part of the protocol. */
enum spear_trace_kind {
    SPEAR_TRACE_RECORD_BEGIN_BLOCK = 1, /* client: the user's code in a begin_frame block; transaction */
    SPEAR_TRACE_RECORD_END_BLOCK = 2,   /* the same for an end_frame block */
    SPEAR_TRACE_SEND = 3,               /* client: a batch is given to the wire; transaction, block */
    SPEAR_TRACE_WAIT_FOR_RESULT = 4,    /* client: waits for an answer; operation number */
    SPEAR_TRACE_WAIT_FOR_FRAME = 5,     /* client: waits for the previous block of the same kind (G4); transaction */
    SPEAR_TRACE_RECEIVE = 6,            /* server: a batch is taken from the wire and queued; session, transaction, block */
    SPEAR_TRACE_QUEUED = 7,             /* server, a moment: it is in the queue; session, transaction, block */
    SPEAR_TRACE_ANSWER = 8,             /* server: answers are given to the wire; session, request */
    SPEAR_TRACE_FRAME = 9,              /* game thread: from OnBeginFrame to the end of OnEndFrame; number */
    SPEAR_TRACE_BEGIN_WORK = 10,        /* game thread: a begin_frame block; session, transaction */
    SPEAR_TRACE_END_WORK = 11,          /* game thread: an end_frame block; session, transaction */
    SPEAR_TRACE_WAIT_FOR_CLIENT = 12,   /* game thread: held by a client; session, transaction */
    SPEAR_TRACE_WORLD_TICK = 13,        /* game thread: UWorld::Tick */
    SPEAR_TRACE_IDLE = 14,              /* game thread: sleeps to keep the frame rate */
    SPEAR_TRACE_OPERATION = 15,         /* game thread: one operation; number. Only at SPEAR_TRACE_OPERATIONS */
    SPEAR_TRACE_KINDS = 16
};

enum { SPEAR_TRACE_OFF = 0, SPEAR_TRACE_ON = 1, SPEAR_TRACE_OPERATIONS = 2 };

/* One of SPEAR_TRACE_OFF ...: what is recorded now. Read it with SPEAR_TRACE_LEVEL. */
extern SPEAR_WIRE_API uint32_t spear_trace_level;
#define SPEAR_TRACE_LEVEL() __atomic_load_n(&spear_trace_level, __ATOMIC_RELAXED)

typedef struct spear_trace_event {
    uint64_t begin_ns;
    uint64_t duration_ns;
    uint16_t kind;
    uint16_t detail; /* small third argument: the block */
    uint32_t text;   /* of spear_trace_text; 0: none */
    uint64_t a;
    uint64_t b;
} spear_trace_event;

/* CLOCK_MONOTONIC, in nanoseconds; never 0. */
SPEAR_WIRE_API uint64_t spear_trace_now(void);
/* Appends to the calling thread's buffer; nothing while no recording runs. */
SPEAR_WIRE_API void spear_trace_record(const spear_trace_event* event);
/* The number of a text in the running recording, the same for equal texts; 0 if none runs or it has too many. Takes a lock. */
SPEAR_WIRE_API uint32_t spear_trace_text(const char* text, size_t size);
/* What the calling thread is called in recordings, at most 31 bytes; its system name if this is never called. */
SPEAR_WIRE_API void spear_trace_name_thread(const char* name);

typedef struct spear_trace spear_trace; /* a recording that has ended */

/* Begins a recording with room for so many events of each thread; one that runs is given up. Returns its number, 0 without memory. */
SPEAR_WIRE_API uint64_t spear_trace_start(uint32_t level, size_t events_per_thread);
/* Whether that recording still runs. */
SPEAR_WIRE_API int spear_trace_runs(uint64_t recording);
/* Ends the recording and gives it to the caller; NULL if it was given up for another, or ended before. */
SPEAR_WIRE_API spear_trace* spear_trace_stop(uint64_t recording);
SPEAR_WIRE_API size_t spear_trace_thread_count(const spear_trace* trace);
/* Events of one thread in the order in which they ended; valid until spear_trace_free. */
SPEAR_WIRE_API const spear_trace_event* spear_trace_thread(
    const spear_trace* trace, size_t thread, const char** name, uint64_t* thread_id, size_t* count, uint64_t* dropped);
SPEAR_WIRE_API size_t spear_trace_text_count(const spear_trace* trace);
SPEAR_WIRE_API const char* spear_trace_text_at(const spear_trace* trace, size_t number); /* from 1 to the count */
SPEAR_WIRE_API void spear_trace_free(spear_trace* trace);

#ifdef __cplusplus
} /* extern "C" */

namespace spear {

/// Records the time from its construction to its end, if a recording runs at its construction.
class TraceSpan {
public:
    explicit TraceSpan( // NOLINT(cppcoreguidelines-pro-type-member-init): costs nothing when off
        spear_trace_kind kind, uint64_t a = 0, uint64_t b = 0, uint16_t detail = 0) noexcept {
        event_.begin_ns = 0;
        if (__builtin_expect(SPEAR_TRACE_LEVEL() != SPEAR_TRACE_OFF, 0)) {
            event_ = {spear_trace_now(), 0, static_cast<uint16_t>(kind), detail, 0, a, b};
        }
    }
    ~TraceSpan() { end(); }
    TraceSpan(const TraceSpan&) = delete;
    TraceSpan& operator=(const TraceSpan&) = delete;

    /// Whether it records: ask before arguments are computed that cost something.
    bool is_on() const noexcept { return event_.begin_ns != 0; }
    void set_arguments(uint64_t a, uint64_t b = 0) noexcept { event_.a = a, event_.b = b; }
    void set_text(const char* text, size_t size) noexcept { event_.text = spear_trace_text(text, size); }
    void end() noexcept {
        if (__builtin_expect(event_.begin_ns != 0, 0)) {
            event_.duration_ns = spear_trace_now() - event_.begin_ns;
            spear_trace_record(&event_);
            event_.begin_ns = 0;
        }
    }

private:
    spear_trace_event event_; // but for begin_ns only written, and only read, while it records
};

/// A moment.
inline void trace_moment(spear_trace_kind kind, uint64_t a = 0, uint64_t b = 0, uint16_t detail = 0) noexcept {
    if (__builtin_expect(SPEAR_TRACE_LEVEL() != SPEAR_TRACE_OFF, 0)) {
        const spear_trace_event event{spear_trace_now(), 0, static_cast<uint16_t>(kind), detail, 0, a, b};
        spear_trace_record(&event);
    }
}

} // namespace spear
#endif
#endif
